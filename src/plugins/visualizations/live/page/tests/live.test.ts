import assert from "node:assert/strict";
import { request } from "node:http";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";

import { Tab, missingLive } from "./browser";
import { startRun } from "./runs";
import { SlowLink } from "./slow_link";
import { Watcher, mostBehind } from "./watcher";

const kTimeout = 40_000; // ms, of a test
const skip = missingLive();

async function numEntities(tab: Tab): Promise<number> {
  return tab.page.evaluate(
    () =>
      (window as unknown as { argosView: { frame: { entities: unknown[] } } }).argosView.frame.entities
        .length,
  );
}

async function waitForEntities(tab: Tab, expected: number): Promise<void> {
  for (let i = 0; i < 100 && (await numEntities(tab)) !== expected; ++i) {
    await tab.page.waitForTimeout(50);
  }
  assert.equal(await numEntities(tab), expected);
}

test("live: a run is played, its robot looked into, and it is ended", { skip, timeout: kTimeout }, async () => {
  const { url, ended } = await startRun("diffusion_10");
  const tab = await Tab.open(url);
  await tab.waitForTick((tick) => tick === 0, "the first state");
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 5, "the run");
  await tab.page.locator(".entities button").first().click();
  await tab.page.getByText("Readings: footbot_proximity").waitFor();
  await tab.button("Pause").click();
  await tab.button("Play").waitFor();
  await tab.page.waitForTimeout(300);
  const paused = await tab.tick();
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === paused + 1, "a step");
  await tab.button("Reset the run, with the same seed").click();
  await tab.waitForTick((tick) => tick === 0, "the reset");
  tab.page.on("dialog", (dialog) => void dialog.accept());
  await tab.button("End the run").click();
  assert.equal(await ended, 0);
  await tab.page.getByText("Ended", { exact: true }).waitFor();
  assert.equal(await tab.button("Play").getAttribute("title"), "The run has ended");
  assert.deepEqual(await tab.close(), []);
});

test("live: browsers get the page compressed, others as it is", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  const get = (headers: Record<string, string>): Promise<{ encoding: string | undefined; body: Buffer }> =>
    new Promise((resolve, reject) => {
      request(url, { headers }, (response) => {
        const chunks: Buffer[] = [];
        response.on("data", (chunk: Buffer) => chunks.push(chunk));
        response.on("end", () => resolve({ encoding: response.headers["content-encoding"], body: Buffer.concat(chunks) }));
      })
        .on("error", reject)
        .end();
    });
  const plain = await get({});
  assert.equal(plain.encoding, undefined);
  assert.match(plain.body.toString("utf8"), /^<!doctype html>/);
  for (const accepted of ["gzip", "br, gzip, deflate", "GZIP"]) {
    const packed = await get({ "accept-encoding": accepted });
    assert.equal(packed.encoding, "gzip", accepted);
    assert.ok(packed.body.length < 400_000);
    assert.ok(gunzipSync(packed.body).equals(plain.body));
  }
  assert.equal((await get({ "accept-encoding": "gzip;q=0, br, x-gzip" })).encoding, undefined);
});

test("live: a robot is dragged, refused in a wall, added and removed", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  const tab = await Tab.open(url);
  await tab.waitForTick((tick) => tick === 0, "the first state");
  await tab.page.keyboard.press("t");
  await tab.page.waitForTimeout(300);
  const drag = async (id: string, to: { x: number; y: number }): Promise<void> => {
    const from = await tab.placeOf(id);
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(to.x, to.y, { steps: 3 });
    await tab.page.mouse.up();
  };
  const start = await tab.placeOf("fb0");
  await tab.page.mouse.click(start.x, start.y);
  const card = tab.page.getByRole("region", { name: "fb0" });
  await card.waitFor();
  await drag("fb0", await tab.placeOf("wall_north"));
  await tab.page.getByRole("alert").first().waitFor();
  assert.match(await tab.page.getByRole("alert").first().innerText(), /"fb0" would overlap "wall_north"/);
  const before = await numEntities(tab);
  await card.getByRole("button", { name: "Remove it from the arena" }).click();
  await waitForEntities(tab, before - 1);
  await card.getByText("no longer in the arena").waitFor();
  await tab.button("Add a robot or a thing").click();
  await tab.button("Add a cylinder in the middle of the picture").click();
  await waitForEntities(tab, before);
  await tab.page.getByRole("region", { name: "cylinder_added_1" }).waitFor();
  await tab.button("Add a robot or a thing").click();
  await tab.button("Add a cylinder in the middle of the picture").click(); // the middle is occupied now
  await waitForEntities(tab, before + 1);
  await tab.page.getByRole("region", { name: "cylinder_added_2" }).waitFor();
  await tab.button("What the picture shows").click();
  await tab.page.keyboard.press("Escape");
  assert.equal(await tab.page.locator(".menu:not([hidden])").count(), 0);
  await tab.page.getByRole("region", { name: "cylinder_added_2" }).waitFor();
  assert.deepEqual(await tab.close(), []);
});

const linkSeconds = Number(process.env.LINK_SECONDS ?? 5);

interface Arrival {
  at: number;
  tick: number;
}

// when the page shows which tick, in the clock of this program
async function watchPage(tab: Tab): Promise<() => Promise<Arrival[]>> {
  await tab.page.evaluate(() => {
    const shown: Arrival[] = [];
    const root = document.getElementById("app")!;
    Object.assign(window, { shown });
    new MutationObserver(() =>
      shown.push({ at: performance.timeOrigin + performance.now(), tick: Number(root.dataset.tick) }),
    ).observe(root, { attributeFilter: ["data-tick"] });
  });
  return async () => {
    const shown = await tab.page.evaluate(() => (window as unknown as { shown: Arrival[] }).shown);
    return shown.map(({ at, tick }) => ({ at: at - performance.timeOrigin, tick }));
  };
}

// 1,000 robots in real time: their states need 3 % of the link, so that what a viewer is behind is the way there and
// back. With LINK_SECONDS it is also measured with the page, which is slow where other programs run.
test("live: over 10 Mbit/s and 100 ms a viewer gets each tenth of a second, half a second old at most", { skip, timeout: kTimeout + 1500 * linkSeconds }, async () => {
  const { url } = await startRun("rooms", "--set", "//distribute/entity/@quantity=1000", "--length", String(linkSeconds + 60));
  const { port } = new URL(url);
  const link = await SlowLink.open(Number(port), 1.25e6, 50);
  const near = await Watcher.open(url);
  await near.waitForTick(0);
  const far = await Watcher.open(url, link.port);
  await far.waitForTick(0);
  const isMeasured = process.env.LINK_SECONDS !== undefined;
  const tab = isMeasured ? await Tab.open(url.replace(port, String(link.port))) : null;
  await tab?.waitForTick((tick) => tick === 0, "the first state");
  const shownOfPage = tab === null ? null : await watchPage(tab);
  near.command("play");
  await far.waitForTick(10 * linkSeconds + 10);
  const report = (shown: Arrival[]): { behind: number; count: number; text: string } => {
    const behind = mostBehind(near.arrivals, shown, 10);
    const later = shown.filter(({ tick }) => tick > 10);
    const gaps = later.slice(1).map(({ at }, i) => at - later[i]!.at);
    const text = `${behind} ticks behind, ${later.length} states, gaps of at most ${Math.max(...gaps).toFixed(0)} ms`;
    return { behind, count: later.length, text };
  };
  const { behind, count, text } = report(far.arrivals);
  if (shownOfPage !== null) {
    console.log(`viewer: ${text}; page: ${report(await shownOfPage()).text}`);
  }
  assert.ok(behind <= 5, text);
  assert.ok(count >= 9 * linkSeconds, text);
  near.close();
  far.close();
  link.close();
  assert.deepEqual((await tab?.close()) ?? [], []);
});
