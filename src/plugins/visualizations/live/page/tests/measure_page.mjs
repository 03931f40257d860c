// Measures the page in a headless Chromium, with a run or a replay:
//   node tests/measure_page.mjs first ARGUMENTS OF ARGOS3...   time and processor time to the first picture
//   node tests/measure_page.mjs seek ARGUMENTS OF ARGOS3...    to show ticks at random, and memory
//   node tests/measure_page.mjs frames ARGUMENTS OF ARGOS3...  pictures a second while it plays, whole arena
// such as "node tests/measure_page.mjs seek --replay run.rec". The environment variables ARGOS3 and CHROMIUM name the programs;
// CHROMIUM_ARGUMENTS replaces those that make the processor draw, DISTANCE (m) places the camera over the arena's centre, and
// PICTURE=FILE keeps what is drawn.
import { readFileSync, readdirSync } from "node:fs";

import { chromium } from "playwright-core";

import { readProcess, startLive } from "./start_live.mjs";

const kSeeks = 200;
const kPlayed = 8000; // ms
const kIdle = 0.05; // s of processor time in a second
const kMaxWaits = 20; // s
const [what, ...arguments_] = process.argv.slice(2);
const { program, url } = await startLive(arguments_);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: process.env.CHROMIUM_ARGUMENTS?.split(" ") ?? [
    ...["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
    ...["--disable-gpu-rasterization", "--no-sandbox"], // the former as browsers do where the processor draws
  ],
});

function stat(pid) {
  try {
    return readProcess(pid);
  } catch {
    return { parent: 0, cpu: 0 };
  }
}

// the browser's processes: descendants of this one, but not the simulator
function browserProcesses() {
  const all = readdirSync("/proc").filter((name) => /^\d+$/.test(name)).map(Number);
  const parents = new Map(all.map((pid) => [pid, stat(pid).parent]));
  const isOurs = (pid) => {
    for (let at = pid; at > 1; at = parents.get(at) ?? 0) {
      if (at === program.pid) {
        return false;
      }
      if (at === process.pid) {
        return true;
      }
    }
    return false;
  };
  return all.filter((pid) => pid !== process.pid && isOurs(pid));
}

const commandOf = (pid) => {
  try {
    return readFileSync(`/proc/${pid}/cmdline`, "utf8");
  } catch {
    return "";
  }
};
const cpuOfBrowser = () => browserProcesses().reduce((sum, pid) => sum + stat(pid).cpu, 0);
const megabytes = (pid, name) => Number(new RegExp(`${name}:\\s+(\\d+)`).exec(readFileSync(`/proc/${pid}/status`, "utf8"))?.[1]) / 1024;
const quantile = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];

const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
await page.addInitScript(() => {
  // when the page has first drawn a state
  const watch = () => {
    if (document.getElementById("app")?.dataset.tick !== undefined) {
      requestAnimationFrame(() => setTimeout(() => (window.firstPicture = performance.now())));
    } else {
      setTimeout(watch, 5);
    }
  };
  watch();
});
// what a browser does after its start is none of the page's
for (let busy = Infinity, i = 0; busy > kIdle && i < kMaxWaits; ++i) {
  const start = cpuOfBrowser();
  await page.waitForTimeout(1000);
  busy = cpuOfBrowser() - start;
}
const before = new Map(browserProcesses().map((pid) => [pid, stat(pid).cpu]));
await page.goto(url);
await page.waitForFunction(() => window.firstPicture !== undefined, null, { timeout: 60_000 });
const first = await page.evaluate(() => window.firstPicture);
// the others are the browser's own: its window, for one, shows that a page is loaded
const spent = (type) =>
  browserProcesses()
    .filter((pid) => type === "" || commandOf(pid).includes(`--type=${type}`))
    .reduce((sum, pid) => sum + stat(pid).cpu - (before.get(pid) ?? 0), 0)
    .toFixed(2);
console.log(
  `first picture after ${first.toFixed(0)} ms; processor time of the browser ${spent("")} s, ` +
    `of it pages ${spent("renderer")} s, drawing ${spent("gpu-process")} s`,
);

if (what === "seek") {
  const memory = async (when) => {
    const session = await page.context().newCDPSession(page);
    await session.send("HeapProfiler.collectGarbage");
    const { usedSize, backingStorageSize = 0 } = await session.send("Runtime.getHeapUsage");
    const pids = browserProcesses().filter((pid) => commandOf(pid).includes("--type=renderer"));
    const resident = Math.max(...pids.map((pid) => megabytes(pid, "VmRSS")));
    console.log(
      `${when}: heap of the page ${(usedSize / 2 ** 20).toFixed(0)} MB, arrays ${(backingStorageSize / 2 ** 20).toFixed(0)} MB, ` +
        `its process ${resident.toFixed(0)} MB, argos3 ${megabytes(program.pid, "VmRSS").toFixed(0)} MB`,
    );
  };
  await memory("at the start");
  const cpu = cpuOfBrowser();
  const times = await page.evaluate(async (count) => {
    const slider = document.querySelector("input.time");
    const root = document.getElementById("app");
    const last = Number(slider.max);
    const result = [];
    let random = 1;
    for (let i = 0; i < count; ++i) {
      random = (random * 48271) % 2147483647;
      const tick = random % (last + 1);
      const start = performance.now();
      const isShown = new Promise((resolve) => {
        const observer = new MutationObserver(() => {
          if (root.dataset.tick === String(tick)) {
            observer.disconnect();
            resolve();
          }
        });
        observer.observe(root, { attributeFilter: ["data-tick"] });
      });
      slider.value = String(tick);
      slider.dispatchEvent(new Event("input"));
      await isShown;
      result.push(performance.now() - start);
    }
    return result;
  }, kSeeks);
  times.sort((a, b) => a - b);
  console.log(
    `${kSeeks} ticks at random, ms: median ${quantile(times, 0.5).toFixed(0)}, 95 % ${quantile(times, 0.95).toFixed(0)}, most ${times.at(-1).toFixed(0)}; ` +
      `processor time for each: browser ${((1000 * (cpuOfBrowser() - cpu)) / kSeeks).toFixed(0)} ms`,
  );
  await memory("at the end");
}
if (what === "frames") {
  if (process.env.DISTANCE !== undefined) {
    await page.evaluate((distance) => {
      window.argosView.camera.distance = distance;
    }, Number(process.env.DISTANCE));
  }
  await page.keyboard.press("Space");
  await page.waitForTimeout(kPlayed / 2); // the page may choose fewer pixels
  const cpu = cpuOfBrowser();
  const drawn = await page.evaluate(async (duration) => {
    const view = window.argosView;
    const { render } = view;
    const times = [];
    view.render = (now) => {
      const start = performance.now();
      const hasDrawn = render.call(view, now);
      if (hasDrawn) {
        times.push([start, performance.now() - start]);
      }
      return hasDrawn;
    };
    await new Promise((resolve) => setTimeout(resolve, duration));
    delete view.render;
    const canvas = document.querySelector("canvas");
    return { times, counts: view.counts, name: view.rendererName, size: [canvas.width, canvas.height] };
  }, kPlayed);
  const perPicture = (1000 * (cpuOfBrowser() - cpu)) / drawn.times.length;
  const gaps = drawn.times.slice(1).map(([at], i) => at - drawn.times[i][0]).sort((a, b) => a - b);
  const own = drawn.times.map(([, time]) => time).sort((a, b) => a - b);
  console.log(
    `${((1000 * drawn.times.length) / kPlayed).toFixed(1)} pictures a second, ms between two: median ${quantile(gaps, 0.5).toFixed(0)}, ` +
      `95 % ${quantile(gaps, 0.95).toFixed(0)}; processor time for each: browser ${perPicture.toFixed(0)} ms, of it the page's drawing ` +
      `${quantile(own, 0.5).toFixed(1)} ms; ${drawn.size.join(" x ")} pixels by ${drawn.name}; ${JSON.stringify(drawn.counts)}`,
  );
}
if (process.env.PICTURE !== undefined) {
  await page.screenshot({ path: process.env.PICTURE });
}
await browser.close();
program.kill("SIGKILL");
