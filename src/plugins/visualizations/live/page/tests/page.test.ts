import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import type { Browser } from "playwright-core";

import { MockServer } from "./mock_server";
import { Tab, embed, launch, missingBrowser, pageFile, shots } from "./browser";
import { changedExperiment, folder, record, run } from "./runs";

const skip = missingBrowser() ?? false;
const kTimeout = 40_000; // ms, of a test
const url = `file://${pageFile}`;
let browser: Browser;
let recording: string;

before(async () => {
  if (skip === false) {
    browser = await launch();
    recording = process.env.PAGE_RECORDING ?? record("diffusion_10", 8);
  }
});
after(async () => {
  await MockServer.closeAll();
  await browser?.close();
  rmSync(folder, { recursive: true });
});

test("page: a recording is opened, played, paused, stepped and scrubbed", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(browser, url);
  assert.ok(await tab.button("Play").isDisabled());
  assert.equal(await tab.button("Play").getAttribute("title"), "Open a recording first");
  await tab.openRecording(recording);
  assert.equal(await tab.tick(), 0);
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 4, "the recording to play");
  await tab.button("Pause").click();
  const paused = await tab.tick();
  await tab.page.waitForTimeout(300);
  assert.ok((await tab.tick()) <= paused + 1);
  const slider = tab.page.getByRole("slider", { name: "Time" });
  await slider.fill("40");
  await tab.waitForTick((tick) => tick === 40, "tick 40");
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === 41, "a step ahead");
  await tab.page.keyboard.press("ArrowLeft");
  await tab.waitForTick((tick) => tick === 40, "a step back");
  await tab.page.keyboard.press("End");
  await tab.waitForTick((tick) => tick === 80, "the end");
  assert.ok(await tab.button("One tick ahead").isDisabled());
  await tab.page.keyboard.press("Home");
  await tab.waitForTick((tick) => tick === 0, "the start");
  await tab.page.getByRole("combobox", { name: "Speed" }).selectOption("10");
  await tab.page.keyboard.press("Escape");
  await tab.page.locator("canvas.picture").press(" ");
  await tab.waitForTick((tick) => tick === 80, "the end, ten times as fast");
  assert.deepEqual(await tab.close(), []);
});

test("page: a click selects a robot, whose values and plot are shown", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(browser, url);
  await tab.openRecording(recording);
  const place = await tab.placeOf("fb3");
  await tab.page.mouse.click(place.x, place.y);
  const card = tab.page.getByRole("region", { name: "fb3" });
  await card.waitFor();
  assert.match(await card.innerText(), /heading\s+-?[\d.]+°/);
  await card.getByRole("button", { name: "Plot x" }).click();
  await card.locator("figure canvas").waitFor();
  const other = await tab.placeOf("fb5");
  await tab.page.keyboard.down("Shift");
  await tab.page.mouse.click(other.x, other.y);
  await tab.page.keyboard.up("Shift");
  await tab.page.getByRole("region", { name: "fb5" }).waitFor();
  assert.equal(await tab.page.locator(".card").count(), 2);
  await card.getByRole("button", { name: "Follow" }).click();
  assert.equal(await card.getByRole("button", { name: "Follow" }).getAttribute("aria-pressed"), "true");
  await tab.shoot("selected");
  await tab.page.keyboard.press("Escape");
  assert.equal(await tab.page.locator(".card").count(), 0);
  assert.deepEqual(await tab.close(), []);
});

test("page: an entity is found by its id, and the keyboard reaches it", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(browser, url);
  await tab.openRecording(recording);
  await tab.page.getByRole("searchbox", { name: "Find an entity" }).fill("fb7");
  assert.equal(await tab.page.locator(".entities button").count(), 1);
  await tab.page.keyboard.press("Tab");
  await tab.page.keyboard.press("Enter");
  await tab.page.getByRole("region", { name: "fb7" }).waitFor();
  assert.deepEqual(await tab.close(), []);
});

test("page: every button has a name and a title, at 1280 and 390 pixels", { skip, timeout: kTimeout }, async () => {
  for (const size of [{ width: 1280, height: 800 }, { width: 390, height: 844 }]) {
    for (const theme of ["light", "dark"] as const) {
      const tab = await Tab.open(browser, url, size, theme);
      await tab.openRecording(recording);
      await tab.page.locator(".entities button").first().click();
      const problems = await tab.page.evaluate(() => {
        const found: string[] = [];
        for (const element of document.querySelectorAll<HTMLElement>("button, select, input")) {
          const box = element.getBoundingClientRect();
          const isShown = box.width > 0 && box.height > 0;
          const name =
            element.getAttribute("aria-label") ?? element.textContent ?? element.closest("label")?.textContent ?? "";
          if (isShown && name.trim() === "" && element.closest("label") === null) {
            found.push(`without a name: ${element.outerHTML.slice(0, 80)}`);
          }
          const isInList = element.closest(".tab-panel, .menu") !== null;
          if (isShown && !isInList && (box.right > innerWidth + 1 || box.left < -1 || box.bottom > innerHeight + 1)) {
            found.push(`outside the window: ${name}`);
          }
        }
        if (document.documentElement.scrollWidth > innerWidth) {
          found.push("the page is wider than the window");
        }
        return found;
      });
      assert.deepEqual(problems, [], `${size.width} ${theme}`);
      await tab.shoot(`recording_${size.width}_${theme}`);
      assert.deepEqual(await tab.close(), []);
    }
  }
});

test("page: many robots are the same points whether WebGL draws them or the page", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(browser, url);
  await tab.openRecording(record("rooms", 1));
  for (const elevation of [Math.PI / 2, 0.9, 0.15]) {
    const { drawnAs, points, different } = await tab.page.evaluate((angle) => {
      const view = (window as any).argosView;
      const drawer = view.entityDrawer;
      view.camera.elevation = angle; // from above, and so low that walls hide robots
      const shoot = (pointsByWebGL: number): Uint8ClampedArray => {
        drawer.budget.pointsByWebGL = pointsByWebGL;
        drawer.setEntities(drawer.entities, view.frame.words.length);
        view.lastChoice = 0;
        const { width, height } = view.capture(false);
        return view.capture(false).getContext("2d").getImageData(0, 0, width, height).data;
      };
      const [byWebGL, byPage, none] = [shoot(Infinity), shoot(0), shoot(0)];
      drawer.points.visible = false;
      view.lastChoice = performance.now() + 1e6; // is not chosen again
      ++view.changes;
      const canvas = view.capture(false);
      none.set(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data);
      const differs = (a: Uint8ClampedArray, b: Uint8ClampedArray, i: number): boolean =>
        Math.abs(a[i]! - b[i]!) + Math.abs(a[i + 1]! - b[i + 1]!) + Math.abs(a[i + 2]! - b[i + 2]!) > 12;
      let [numPoints, numDifferent] = [0, 0];
      for (let i = 0; i < none.length; i += 4) {
        numPoints += differs(byWebGL, none, i) ? 1 : 0;
        numDifferent += differs(byWebGL, byPage, i) ? 1 : 0;
      }
      return { drawnAs: view.counts.points, points: numPoints, different: numDifferent };
    }, elevation);
    assert.equal(drawnAs, 1000);
    assert.ok(points > 1000, `${points} pixels of points at ${elevation} rad`);
    // rounding of a point's edge
    assert.ok(different < 0.05 * points, `${different} of ${points} pixels differ at ${elevation} rad`);
  }
  assert.deepEqual(await tab.close(), []);
});

test("page: texts are drawn where they are, and only when they change", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(browser, url);
  await tab.openRecording(recording);
  const place = (): Promise<{ width: number; height: number }> =>
    tab.page.evaluate(() => {
      const { width, height } = document.querySelector("canvas.labels")!.getBoundingClientRect();
      return { width, height };
    });
  const scaleBar = await place();
  assert.ok(scaleBar.width > 0 && scaleBar.width <= 128 && scaleBar.height <= 96, JSON.stringify(scaleBar));
  await tab.page.evaluate(() => {
    const view = (window as any).argosView;
    const { cover } = Object.getPrototypeOf(view.labels);
    const counts = { covers: 0, pictures: 0 };
    Object.assign(window, { counts });
    view.labels.cover = function (...all: unknown[]): void {
      ++counts.covers;
      cover.apply(this, all);
    };
    const { render } = Object.getPrototypeOf(view);
    view.render = (now: number): boolean => {
      const isDrawn = render.call(view, now);
      counts.pictures += isDrawn ? 1 : 0;
      return isDrawn;
    };
  });
  await tab.button("Play").click();
  const counts = (): Promise<{ covers: number; pictures: number }> =>
    tab.page.evaluate(() => (window as any).counts);
  await tab.page.waitForFunction(() => (window as any).counts.pictures > 5);
  assert.equal((await counts()).covers, 0);
  await tab.page.evaluate(() => {
    (window as any).argosView.camera.azimuth += 0.3;
  });
  await tab.page.waitForFunction(() => (window as any).counts.covers > 0);
  await tab.button("Pause").click();
  assert.equal((await counts()).covers, 1);
  // ids of robots all over the picture, on it and in a saved one
  await tab.page.evaluate(() => {
    const view = (window as any).argosView;
    view.options.ids = true;
    view.optionsChanged();
  });
  await tab.page.waitForFunction(() => document.querySelector("canvas.labels")!.clientWidth > 300);
  const texts = await tab.page.evaluate(() => {
    const view = (window as any).argosView;
    const pixels = (canvas: HTMLCanvasElement): Uint8ClampedArray =>
      canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height).data;
    const saved = view.capture(true);
    const [with_, without] = [pixels(saved), pixels(view.capture(false))];
    const { left, top, right, bottom } = view.labels.covered;
    let [inside, outside] = [0, 0];
    for (let i = 0; i < with_.length; i += 4) {
      const [x, y] = [(i / 4) % saved.width, Math.floor(i / 4 / saved.width)];
      const isInside = x >= left && x < right && y >= top && y < bottom;
      const differs = Math.abs(with_[i]! - without[i]!) > 8;
      inside += differs && isInside ? 1 : 0;
      outside += differs && !isInside ? 1 : 0;
    }
    return { inside, outside, sameSize: with_.length === without.length };
  });
  assert.ok(texts.sameSize);
  assert.ok(texts.inside > 500, `${texts.inside} pixels of texts`);
  assert.equal(texts.outside, 0);
  assert.deepEqual(await tab.close(), []);
});

test("page: a recording inside the page opens from disk", { skip, timeout: kTimeout }, async () => {
  const path = join(folder, "embedded.html");
  writeFileSync(path, embed(recording));
  const tab = await Tab.open(browser, `file://${path}`);
  await tab.waitForTick((tick) => tick === 0, "the embedded recording");
  assert.equal(await tab.page.locator("h1").innerText(), "diffusion_10.argos");
  await tab.page.keyboard.press("End");
  await tab.waitForTick((tick) => tick === 80, "its end");
  assert.deepEqual(await tab.close(), []);
});

test("page: what is no recording is refused with the reason", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(browser, url);
  const path = join(folder, "other.rec");
  writeFileSync(path, "this is a text, and not a recording of anything");
  await tab.page.setInputFiles("input[type=file]", path);
  const alert = tab.page.getByRole("alert");
  await alert.waitFor();
  assert.match(await alert.innerText(), /Cannot open “other.rec”: it is no recording/);
  assert.deepEqual(await tab.close(), []);
});

test("page: a browser without WebGL 2 is told, and nothing else fails", { skip, timeout: kTimeout }, async () => {
  const path = join(folder, "no_webgl.html");
  const script = "<script>HTMLCanvasElement.prototype.getContext = () => null;</script>";
  writeFileSync(path, embed(recording).replace("<body>", `<body>${script}`));
  const tab = await Tab.open(browser, `file://${path}`);
  const alert = tab.page.getByRole("alert");
  await alert.waitFor();
  await tab.page.waitForTimeout(300);
  assert.equal(await alert.count(), 1);
  assert.match(await alert.innerText(), /needs WebGL 2/);
  assert.equal(await tab.page.locator(".tab-panel:visible").count(), 1);
  assert.deepEqual(await tab.close(), []);
});

// The measure: the mean difference of a colour channel, and the share of pixels whose colour differs
// by more than 48 of 255 in any channel. Lines and edges differ by their smoothing.
for (const size of [{ width: 1280, height: 800 }, { width: 390, height: 844 }]) {
  test(`page: the picture is that of the off-screen view, within 3.5 grey levels, at ${size.width} pixels`, { skip, timeout: kTimeout }, () => comparePictures(size));
}

async function comparePictures(size: { width: number; height: number }): Promise<void> {
  const tab = await Tab.open(browser, `${url}?detail=full`, size);
  await tab.openRecording(recording);
  await tab.page.keyboard.press("End");
  await tab.waitForTick((tick) => tick === 80, "the end");
  await tab.page.keyboard.press("b");
  const camera = await tab.page.evaluate(() => {
    const { argosView: view } = window as unknown as {
      argosView: { camera: { target: number[]; update(): { position: { x: number; y: number; z: number } } } };
    };
    const { x, y, z } = view.camera.update().position;
    const canvas = document.querySelector<HTMLCanvasElement>("canvas.picture")!;
    return { position: [x, y, z], target: view.camera.target, size: [canvas.width, canvas.height] };
  });
  await tab.page.waitForTimeout(1500);
  const pictures = join(folder, `pictures_${size.width}`);
  const changed = changedExperiment("diffusion_10", (xml) =>
    xml.replace(
      /<visualization>[^]*<\/visualization>/,
      `<visualization><offscreen directory="${pictures}" size="${camera.size.join("x")}" every="80">
        <camera><placements><placement index="0" position="${camera.position.join()}"
          look_at="${camera.target.join()}" lens_focal_length="${13.5 / Math.tan(Math.PI / 10)}" />
        </placements></camera></offscreen></visualization>`,
    ),
  );
  run("--quiet", "--replay", recording, "-c", changed, "--from", "80");
  const expected = readFileSync(join(pictures, "frame_0000000080.png")).toString("base64");
  const { mean, share } = await tab.page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const pixels = (source: CanvasImageSource): Uint8ClampedArray => {
      const canvas = document.createElement("canvas");
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext("2d")!;
      context.drawImage(source, 0, 0);
      return context.getImageData(0, 0, image.width, image.height).data;
    };
    const a = pixels(image);
    const { argosView: view } = window as unknown as {
      argosView: { capture(withLabels: boolean): HTMLCanvasElement };
    };
    const b = pixels(view.capture(false));
    let sum = 0;
    let different = 0;
    for (let i = 0; i < a.length; i += 4) {
      let most = 0;
      for (let channel = 0; channel < 3; ++channel) {
        const difference = Math.abs(a[i + channel]! - b[i + channel]!);
        sum += difference;
        most = Math.max(most, difference);
      }
      different += most > 48 ? 1 : 0;
    }
    return { mean: sum / (0.75 * a.length), share: different / (a.length / 4) };
  }, expected);
  if (shots !== undefined) {
    await tab.shoot(`compared_${size.width}`);
    writeFileSync(join(shots, `offscreen_${size.width}.png`), Buffer.from(expected, "base64"));
  }
  assert.ok(mean < 3.5 && share < 0.03, `mean ${mean.toFixed(2)}, share ${share.toFixed(4)}`);
  assert.deepEqual(await tab.close(), []);
}

test("page: a run is watched, played, stepped and reset", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(browser, server.url);
  await tab.waitForTick((tick) => tick === 0, "the first state");
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 10, "the run");
  await tab.button("Pause").click();
  await tab.button("Play").waitFor();
  const paused = server.tickNow;
  await tab.waitForTick((tick) => tick === paused, "the state at the pause");
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === paused + 1, "a step");
  await tab.button("One state back").click();
  await tab.waitForTick((tick) => tick < paused + 1, "what was received before");
  await tab.button("Present").first().or(tab.button("Back to the present")).first().click();
  await tab.waitForTick((tick) => tick === paused + 1, "the present");
  await tab.button("Reset").or(tab.page.getByRole("button", { name: /^Reset/ })).first().click();
  await tab.waitForTick((tick) => tick === 0, "the reset");
  const names = server.commands.map((command) => command.do);
  assert.deepEqual(names.filter((name) => name !== "parameters"), ["play", "pause", "step", "reset"]);
  await tab.page.locator(".entities button").first().click();
  const card = tab.page.getByRole("region", { name: "fb0" });
  await tab.button("One tick ahead").click();
  await card.getByText("Proximity", { exact: true }).waitFor();
  assert.match(await card.innerText(), /left\s+\d m\/s/);
  await tab.shoot("live");
  server.sendAll({ log: [{ level: "error", text: "<b>a robot</b> failed", tick: 1 }] });
  await tab.page.getByRole("tab", { name: "Log" }).click();
  assert.match(await tab.page.getByRole("log").innerText(), /<b>a robot<\/b> failed/);
  assert.deepEqual(await tab.close(), []);
  await server.close();
});

test("page: a drag that is refused says why", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(browser, server.url);
  await tab.waitForTick((tick) => tick === 0);
  const place = await tab.placeOf("fb3");
  await tab.page.mouse.click(place.x, place.y);
  await tab.page.getByRole("region", { name: "fb3" }).waitFor();
  await tab.page.mouse.move(place.x, place.y);
  await tab.page.mouse.down();
  await tab.page.mouse.move(place.x + 60, place.y - 30, { steps: 4 });
  await tab.page.mouse.up();
  await tab.page.getByRole("alert").first().waitFor();
  assert.match(await tab.page.getByRole("alert").first().innerText(), /would overlap with "wall_north"/);
  const move = server.commands.find((command) => command.do === "move")!;
  assert.equal(move.entity, "fb3");
  assert.equal((move.position as number[]).length, 3);
  assert.deepEqual(await tab.close(), []);
  await server.close();
});

test("page: a driven robot is let go when another one is selected, or keys drive no more", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(browser, server.url);
  await tab.waitForTick((tick) => tick === 0);
  await tab.page.locator('.entities button[data-id="fb3"]').click();
  await tab.button("Drive the selected robot by W, A, S and D").click();
  await tab.page.keyboard.down("w");
  await tab.page.locator('.entities button[data-id="fb5"]').click();
  await tab.page.keyboard.up("w");
  await tab.page.keyboard.press("a");
  await tab.button("Drive the selected robot by W, A, S and D").click();
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === 1);
  const drives = server.commands.filter((command) => command.do === "drive");
  assert.deepEqual(
    drives.map(({ entity, left, right }) => [entity, left, right]),
    [
      ["fb3", 10, 10],
      ["fb3", undefined, undefined],
      ["fb5", -4, 4],
      ["fb5", 0, 0],
      ["fb5", undefined, undefined],
    ],
  );
  assert.deepEqual(await tab.close(), []);
  await server.close();
});

const kPicture = "canvas.picture";

test("page: user functions get the keys of the picture first, and the page acts on those that they leave", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  server.usedKeys = new Set(["ArrowRight", "s", "S"]);
  const tab = await Tab.open(browser, server.url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  const told = (): string[] =>
    server.commands.filter(({ do: name }) => name === "user_key").map(({ key, down }) => `${down === false ? "-" : "+"}${key as string}`);
  const isChecked = (name: string): Promise<boolean> =>
    page.evaluate((option) => (window as unknown as { argosView: { options: Record<string, boolean> } }).argosView.options[option]!, name);
  const rays = await isChecked("rays");
  await page.locator(kPicture).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("s");
  await page.keyboard.press("i");
  await tab.waitFor("the ids", () => isChecked("ids"));
  assert.deepEqual(told(), ["+ArrowRight", "-ArrowRight", "+s", "-s", "+i", "-i"]);
  assert.equal(await tab.tick(), 0, "no step");
  assert.equal(await isChecked("rays"), rays);
  await page.keyboard.press("Space");
  await tab.waitForTick((tick) => tick > 3, "the run, which Space has started");
  await tab.button("Pause").click();
  await tab.button("Play").waitFor();

  // released where it was pressed, whatever its name and the focus are then
  server.commands = [];
  await page.locator(kPicture).focus();
  await page.keyboard.down("Shift");
  await page.keyboard.down("S");
  await page.keyboard.up("Shift");
  await page.getByRole("tab", { name: "Log" }).click();
  await page.keyboard.up("s");
  await tab.waitFor("the release", () => told().length === 4);
  assert.deepEqual(told(), ["+Shift", "+S", "-Shift", "-S"]);

  // with the keys that are down with them, but for what browsers do by Ctrl
  server.commands = [];
  await page.locator(kPicture).focus();
  const options = await page.evaluate(() => ({ ...(window as unknown as { argosView: { options: object } }).argosView.options }));
  await page.keyboard.press("Shift+ArrowUp");
  await page.keyboard.press("Control+Alt+h");
  await page.keyboard.press("Control+g");
  await page.keyboard.press("Control+c");
  const names = ["shift", "control", "alt", "meta"];
  const withModifiers = (): string[] =>
    server.commands
      .filter(({ do: name }) => name === "user_key")
      .map((command) => [command.down === false ? "-" : "+", command.key, ...names.filter((name) => command[name] === true)].join(" "));
  await tab.waitFor("all keys", () => withModifiers().length >= 16);
  assert.deepEqual(withModifiers(), [
    ...["+ Shift shift", "+ ArrowUp shift", "- ArrowUp shift", "- Shift"],
    ...["+ Control control", "+ Alt control alt", "+ h control alt", "- h control alt", "- Alt control", "- Control"],
    ...["+ Control control", "+ g control", "- g control", "- Control"],
    ...["+ Control control", "- Control"],
  ]);
  assert.deepEqual(
    await page.evaluate(() => ({ ...(window as unknown as { argosView: { options: object } }).argosView.options })),
    options,
    "the page takes Ctrl and a letter for the letter",
  );

  // elsewhere keys are the page's, and Tab leads there
  server.commands = [];
  await page.locator(kPicture).focus();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement!.tagName), "BUTTON");
  const before = await tab.tick();
  await page.keyboard.press("ArrowRight");
  await tab.waitForTick((tick) => tick === before + 1, "a step");
  assert.deepEqual(told().filter((key) => !key.endsWith("Tab")), []);
  assert.deepEqual(await tab.close(), []);
  await server.close();
});

test("page: without user functions nothing is told of keys, and they act at once", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(browser, server.url);
  await tab.waitForTick((tick) => tick === 0);
  const place = await tab.placeOf("fb3");
  await tab.page.mouse.click(place.x, place.y);
  await tab.page.getByRole("region", { name: "fb3" }).waitFor();
  await tab.page.locator(kPicture).press("ArrowRight");
  await tab.waitForTick((tick) => tick === 1, "a step");
  assert.deepEqual(server.commands.filter(({ do: name }) => /^user_/.test(name as string)), []);
  assert.deepEqual(await tab.close(), []);
  await server.close();
});

test("page: readings that a robot no longer has are not shown", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(browser, server.url);
  await tab.waitForTick((tick) => tick === 0);
  await tab.page.locator('.entities button[data-id="fb3"]').click();
  const card = tab.page.getByRole("region", { name: "fb3" });
  const sendMessages = (...ranges: number[]): void => {
    const messages = ranges.map((range) => ({ "message_range (cm)": range, "message_horizontal_bearing (rad)": 0.5 }));
    server.sendAll({ values: { entity: "fb3", tick: 0, tree: { messages, colliding: { colliding: 0 } } } });
  };
  sendMessages(12, 345);
  await card.getByText("345 cm, 28.6°").waitFor();
  assert.match(await card.innerText(), /colliding\s+no/);
  sendMessages(12);
  await card.getByText("345 cm, 28.6°").waitFor({ state: "hidden" });
  assert.ok(await card.getByText("12 cm, 28.6°").isVisible());
  sendMessages();
  await card.getByText("Messages").waitFor({ state: "hidden" });
  assert.deepEqual(await tab.close(), []);
  await server.close();
});

test("page: the whole arena stays in the picture when the window changes, unless the camera was moved", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(browser, url);
  await tab.openRecording(recording);
  const isWhole = (): Promise<boolean> =>
    tab.page.evaluate(() => {
      const { argosView: view } = window as unknown as {
        argosView: {
          arenaBox: { min: number[]; max: number[] };
          camera: { update(): void; project(point: number[]): { x: number; y: number } };
        };
      };
      view.camera.update();
      const { clientWidth, clientHeight } = document.querySelector("canvas")!;
      const [low, high] = [view.arenaBox.min, view.arenaBox.max];
      return [low[0]!, high[0]!].every((x) =>
        [low[1]!, high[1]!].every((y) => {
          const place = view.camera.project([x, y, 0]);
          return place.x >= 0 && place.x <= clientWidth && place.y >= 0 && place.y <= clientHeight;
        }),
      );
    });
  const becomes = async (expected: boolean): Promise<void> => {
    for (let i = 0; i < 100 && (await isWhole()) !== expected; ++i) {
      await tab.page.waitForTimeout(50);
    }
    assert.equal(await isWhole(), expected);
  };
  await becomes(true);
  await tab.page.setViewportSize({ width: 390, height: 844 });
  await becomes(true);
  await tab.page.locator("canvas").first().hover();
  await tab.page.mouse.wheel(0, -300);
  await tab.page.setViewportSize({ width: 1280, height: 800 });
  await tab.page.waitForTimeout(300);
  await tab.page.setViewportSize({ width: 390, height: 844 });
  await becomes(false);
  assert.deepEqual(await tab.close(), []);
});

test("page: the connection comes back after the server's restart", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(browser, server.url);
  await tab.waitForTick((tick) => tick === 0);
  const { port } = server;
  await server.close();
  await tab.page.getByText("Connection lost").first().waitFor();
  assert.equal(await tab.button("Play").getAttribute("title"), "There is no connection to the run");
  const second = await MockServer.start(recording, pageFile, port);
  await tab.page.getByText("Paused").first().waitFor();
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === 1, "a step of the new server");
  assert.deepEqual(await tab.close(), []);
  await second.close();
});

test("page: of two viewers one has control, and can hand it over", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const first = await Tab.open(browser, server.url);
  await first.waitForTick((tick) => tick === 0);
  const second = await Tab.open(browser, server.url);
  await second.waitForTick((tick) => tick === 0);
  await second.button("Another viewer has control. Ask for it").click();
  assert.equal(
    await second.button("Play").getAttribute("title"),
    "Another viewer has control: ask for it",
  );
  await first.button("You have control").click();
  await first.page.getByRole("button", { name: "Hand control to viewer 2" }).click();
  await second.page.waitForFunction(
    () => !document.querySelector<HTMLButtonElement>("button.primary.round")!.disabled,
  );
  await second.button("One tick ahead").click();
  await first.waitForTick((tick) => tick === 1, "the other viewer's step");
  assert.deepEqual(await first.close(), []);
  assert.deepEqual(await second.close(), []);
  await server.close();
});

test("page: a wrong token is refused, and not tried again", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(browser, `http://127.0.0.1:${server.port}/#00000000000000000000000000000000`);
  await tab.page.getByRole("alert").waitFor();
  assert.match(await tab.page.getByRole("alert").innerText(), /token/);
  await tab.close();
  await server.close();
});
