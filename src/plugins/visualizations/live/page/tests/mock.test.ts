// The page with a server that plays a recording as if it were a run.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Tab, missingBrowser, pageFile } from "./browser";
import { MockServer } from "./mock_server";
import { sampleRecording } from "./runs";

const skip = missingBrowser() ?? false;
const kTimeout = 40_000; // ms, of a test
const recording = skip === false ? sampleRecording() : "";

/** A page that shows the first state of a mocked run. */
async function openRun(): Promise<{ server: MockServer; tab: Tab }> {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(server.url);
  await tab.waitForTick((tick) => tick === 0, "the first state");
  return { server, tab };
}

/** Selects a robot in the picture. @returns where it is. */
async function select(tab: Tab, id: string): Promise<{ x: number; y: number }> {
  const place = await tab.placeOf(id);
  await tab.page.mouse.click(place.x, place.y);
  await tab.page.getByRole("region", { name: id }).waitFor();
  return place;
}

test("page: a run is watched, played, stepped and reset", { skip, timeout: kTimeout }, async () => {
  const { server, tab } = await openRun();
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
  const { server, tab } = await openRun();
  const place = await select(tab, "fb3");
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
  const { server, tab } = await openRun();
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
  const tab = await Tab.open(server.url);
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
  const { server, tab } = await openRun();
  await select(tab, "fb3");
  await tab.page.locator(kPicture).press("ArrowRight");
  await tab.waitForTick((tick) => tick === 1, "a step");
  assert.deepEqual(server.commands.filter(({ do: name }) => /^user_/.test(name as string)), []);
  assert.deepEqual(await tab.close(), []);
  await server.close();
});

test("page: readings that a robot no longer has are not shown", { skip, timeout: kTimeout }, async () => {
  const { server, tab } = await openRun();
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

test("page: the connection comes back after the server's restart", { skip, timeout: kTimeout }, async () => {
  const { server, tab } = await openRun();
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

test("page: a wrong token is refused, and not tried again", { skip, timeout: kTimeout }, async () => {
  const server = await MockServer.start(recording, pageFile);
  const tab = await Tab.open(`http://127.0.0.1:${server.port}/#00000000000000000000000000000000`);
  await tab.page.getByRole("alert").waitFor();
  assert.match(await tab.page.getByRole("alert").innerText(), /token/);
  await tab.close();
  await server.close();
});
