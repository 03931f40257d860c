// Runs, replays and files of argos3 as researchers use them: keys, perceptions, several viewers, lost connections, markup, and
// the page without a mouse.

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";

import type { CDPSession } from "playwright-core";

import { Tab, missingLive } from "./browser";
import { changedExperiment, experiment, folder, record, run, startLive, startRun } from "./runs";
import { SlowLink } from "./slow_link";

const kTimeout = 60_000; // ms, of a test
const skip = missingLive();

interface View {
  find(id: string): number;
  frame: {
    tick: number;
    poses: Float64Array;
    entities: { id: string; firstPose: number; type: { isRobot: boolean } }[];
  };
  options: Record<string, boolean>;
  setDevices(lines: unknown[], dots: { pose: number; position: number[]; color: number[] }[]): void;
}

/** Where an entity is in the state that is shown: x, y (m). */
function placeInArena(tab: Tab, id: string): Promise<[number, number]> {
  return tab.page.evaluate((wanted) => {
    const { argosView: view } = window as unknown as { argosView: View };
    const at = 7 * view.frame.entities[view.find(wanted)]!.firstPose;
    return [view.frame.poses[at]!, view.frame.poses[at + 1]!] as [number, number];
  }, id);
}

test("viewers: keys drive a robot through user functions, and the page acts on the others", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("manual_control");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  const options = await page.evaluate(() => ({ ...(window as unknown as { argosView: View }).argosView.options }));
  const robot = await tab.placeOf("fb0");
  await page.mouse.click(robot.x, robot.y);
  await page.getByRole("region", { name: "fb0" }).waitFor();
  await page.keyboard.press("Space");
  await tab.waitForTick((tick) => tick > 2, "the run, which Space has started");
  const start = await placeInArena(tab, "fb0");
  await page.keyboard.down("ArrowUp");
  await tab.waitFor("the robot", async () => (await placeInArena(tab, "fb0"))[0] > start[0] + 0.2);
  await tab.shoot("manual_control");
  await page.keyboard.up("ArrowUp");
  // to drive left, to look at what the robot perceives, to show axes, to play the past: keys of both
  await page.keyboard.down("a");
  await page.waitForTimeout(600);
  await page.keyboard.up("a");
  const tick = await tab.tick();
  await tab.waitForTick((now) => now > tick + 3, "that it stands");
  const end = await placeInArena(tab, "fb0");
  await tab.waitForTick((now) => now > tick + 8, "time to pass");
  assert.deepEqual(await placeInArena(tab, "fb0"), end);
  const [x, y] = await placeInArena(tab, "fb1");
  assert.ok(Math.hypot(x + 1, y + 0.6) < 1e-5, "the robot that is not selected has moved"); // states keep 1e-6 m
  assert.deepEqual(
    await page.evaluate(() => ({ ...(window as unknown as { argosView: View }).argosView.options })),
    options,
    "keys of the experiment have switched options of the page",
  );
  await page.keyboard.press("Space");
  await page.getByText("Paused", { exact: true }).first().waitFor();
  await page.keyboard.press("i");
  await tab.waitFor("the ids", () => page.evaluate(() => (window as unknown as { argosView: View }).argosView.options.ids!));
  assert.deepEqual(await tab.close(), []);
});

// Red blobs of the camera are lamps in the middle of other foot-bots. A state later, these have driven 4 cm, and a tenth of a
// second later 10 cm.
test("viewers: at ten times real time, what a robot perceives is drawn where the robots are", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("flocking", "--length", "600");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await page.locator('.entities button[data-id="fb0"]').click();
  await page.getByRole("region", { name: "fb0", exact: true }).waitFor();
  await page.getByRole("combobox", { name: "Speed" }).selectOption("10");
  await page.evaluate(() => {
    const { argosView: view } = window as unknown as { argosView: View };
    const seen = { states: new Set<number>(), drawn: new Set<number>(), most: 0 };
    Object.assign(window, { seen });
    const set = view.setDevices.bind(view);
    view.setDevices = (lines, dots): void => {
      const { tick, poses, entities } = view.frame;
      seen.states.add(tick);
      for (const { pose, position } of dots.filter(({ color }) => color[0] === 255 && color[1] === 0)) {
        seen.drawn.add(tick);
        const [x, y, w, qz] = [poses[7 * pose]!, poses[7 * pose + 1]!, poses[7 * pose + 3]!, poses[7 * pose + 6]!];
        const [cos, sin] = [w * w - qz * qz, 2 * w * qz];
        const place = [x + cos * position[0]! - sin * position[1]!, y + sin * position[0]! + cos * position[1]!];
        const distances = entities
          .filter(({ id, type }) => type.isRobot && id !== "fb0")
          .map(({ firstPose: at }) => Math.hypot(poses[7 * at]! - place[0]!, poses[7 * at + 1]! - place[1]!));
        seen.most = Math.max(seen.most, Math.min(...distances));
      }
      set(lines, dots);
    };
  });
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 400, "four seconds of the run");
  await tab.button("Pause").click();
  const seen = await page.evaluate(() => {
    const { seen: all } = window as unknown as { seen: { states: Set<number>; drawn: Set<number>; most: number } };
    return { states: all.states.size, drawn: all.drawn.size, most: all.most };
  });
  const text = `${seen.drawn} of ${seen.states} states, at most ${(100 * seen.most).toFixed(1)} cm away`;
  assert.ok(seen.states > 30 && seen.drawn >= 0.9 * seen.states, text);
  assert.ok(seen.most < 0.02, text);
  assert.deepEqual(await tab.close(), []);
});

test("viewers: of two viewers one has control, which goes on with the other", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  const first = await Tab.open(url);
  await first.waitForTick((tick) => tick === 0);
  const second = await Tab.open(url);
  await second.waitForTick((tick) => tick === 0);
  assert.equal(await second.button("Play").getAttribute("title"), "Another viewer has control: ask for it");
  await second.button("Another viewer has control. Ask for it").click();
  await first.page.getByText("Viewer 2 asks for control").waitFor();
  await first.button("You have control").click();
  await first.page.getByRole("button", { name: "Hand control to viewer 2, who asks" }).click();
  await second.page.getByText("You have control of the run").waitFor();
  await second.button("One tick ahead").click();
  await first.waitForTick((tick) => tick === 1, "the other viewer's step");
  assert.ok(await first.button("One tick ahead").isDisabled());
  assert.deepEqual(await second.close(), []);
  // the one that is left gets it again
  await first.waitFor("control", () => first.button("One tick ahead").isEnabled());
  await first.button("One tick ahead").click();
  await first.waitForTick((tick) => tick === 2, "its own step");
  assert.deepEqual(await first.close(), []);
});

test("viewers: what was selected without control is driven by keys once there is control", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("manual_control");
  const first = await Tab.open(url);
  await first.waitForTick((tick) => tick === 0);
  const second = await Tab.open(url);
  await second.waitForTick((tick) => tick === 0);
  for (const [tab, robot] of [[first, "fb0"], [second, "fb1"]] as const) {
    await tab.page.locator(`.entities button[data-id="${robot}"]`).click();
    await tab.page.getByRole("region", { name: robot, exact: true }).waitFor();
  }
  await first.button("Play").click();
  await first.waitForTick((tick) => tick > 1, "the run");
  await first.button("You have control").click();
  await first.page.getByRole("button", { name: "Hand control to viewer 2" }).click();
  await second.page.getByText("You have control of the run").waitFor();
  await second.page.locator("canvas.picture").focus();
  const start = await placeInArena(second, "fb1");
  await second.page.keyboard.down("ArrowUp");
  await second.waitFor("the robot", async () => (await placeInArena(second, "fb1"))[0] > start[0] + 0.1);
  await second.page.keyboard.up("ArrowUp");
  const other = await placeInArena(second, "fb0");
  assert.ok(Math.hypot(other[0] + 1, other[1]) < 1e-5, "the first viewer's robot has moved");
  assert.deepEqual(await first.close(), []);
  assert.deepEqual(await second.close(), []);
});

test("viewers: a page comes back to its run when the connection does, and to none that was started again", { skip, timeout: kTimeout }, async () => {
  const first = await startRun("diffusion_10", "--length", "1000");
  const { port } = new URL(first.url);
  const fast = 1e9; // bytes/s
  const link = await SlowLink.open(Number(port), fast, 0);
  const ownPort = link.port;
  const tab = await Tab.open(first.url.replace(port, String(ownPort)));
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await page.locator('.entities button[data-id="fb0"]').click();
  await page.getByText("Readings: footbot_proximity").waitFor();
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 5, "the run");
  link.close();
  await page.getByText("Connection lost").first().waitFor();
  const lost = await tab.tick();
  assert.equal(await tab.button("Reset the run, with the same seed").getAttribute("title"), "There is no connection to the run");
  const again = await SlowLink.open(Number(port), fast, 0, ownPort);
  await tab.waitForTick((tick) => tick > lost + 10, "what the run does meanwhile");
  // it has control and its robot again
  await tab.button("Pause").click();
  await tab.button("Play").waitFor();
  await page.getByRole("region", { name: "fb0", exact: true }).waitFor();
  // the past from before the cut is still there
  await page.getByRole("slider", { name: "Time" }).fill("0");
  await tab.waitForTick((tick) => tick === 0, "the first state");
  await tab.button("Back to the present").click();

  // another run has another token
  first.kill();
  await first.ended;
  const second = await startLive(experiment("diffusion_10"), `--live=${port}`);
  await page.getByText("The token is wrong: open the URL that the run has printed").first().waitFor();
  assert.equal(await tab.button("Play").getAttribute("title"), "There is no connection to the run");
  await page.goto(second.url);
  await tab.waitForTick((tick) => tick === 0, "the new run");
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === 1, "a step of the new run");
  again.close();
  assert.deepEqual(await tab.close(), []);
});

test("viewers: a replay is scrubbed, and its robots are selected without complaints", { skip, timeout: kTimeout }, async () => {
  const recording = record("diffusion_10", 20);
  const { url } = await startLive("--replay", recording, "--live");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  const slider = page.getByRole("slider", { name: "Time" });
  for (const tick of [150, 7, 200, 0, 93]) {
    await slider.fill(String(tick));
    await tab.waitForTick((shown) => shown === tick, `tick ${tick}`);
  }
  await page.locator('.entities button[data-id="fb0"]').click();
  await page.getByRole("region", { name: "fb0", exact: true }).waitFor();
  await page.locator("canvas.picture").press("ArrowRight");
  await tab.waitForTick((tick) => tick === 94, "a step");
  await page.locator("canvas.picture").press("ArrowLeft");
  await tab.waitForTick((tick) => tick === 93, "a step back");
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 97, "the replay to play");
  assert.equal(await tab.button("Add a robot or a thing").getAttribute("title"), "This is a replay, which cannot be changed");
  assert.deepEqual(await page.getByRole("alert").allInnerTexts(), []);
  assert.deepEqual(await tab.close(), []);
});

test("viewers: argos3 writes a page with a recording, which opens from disk", { skip, timeout: kTimeout }, async () => {
  const html = join(folder, "sent.html");
  run("--replay", record("foraging", 10, "--set", "/loop_functions/foraging/@output=/dev/null"), "--html", html);
  const tab = await Tab.open(`file://${html}`);
  await tab.waitForTick((tick) => tick === 0, "the first state of the file");
  await tab.page.keyboard.press("End");
  await tab.waitForTick((tick) => tick === 100, "the last state of the file");
  await tab.page.getByRole("slider", { name: "Time" }).fill("50");
  await tab.waitForTick((tick) => tick === 50, "a state between");
  await tab.shoot("sent");
  assert.deepEqual(await tab.close(), []);
});

const kMarkup = `<img src=x onerror="document.title='owned'"><b>r</b>&amp;`;

test("viewers: markup in ids and errors is shown as text", { skip, timeout: kTimeout }, async () => {
  const escaped = kMarkup.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
  const file = changedExperiment("manual_control", (xml) => xml.replace('id="fb0"', `id="${escaped}"`));
  const { url } = await startRun(file);
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await page.locator(".entities button", { hasText: "onerror" }).click();
  const card = page.getByRole("region").filter({ has: page.getByRole("heading", { name: kMarkup, exact: true }) });
  await card.waitFor();
  await page.keyboard.press("t");
  await page.keyboard.press("i");
  const heading = card.getByRole("spinbutton");
  await heading.fill("90");
  await heading.press("Enter");
  await tab.waitFor("the robot to be turned", async () => Math.abs(Number(await heading.inputValue()) - 90) < 1);
  const drag = async (to: { x: number; y: number }): Promise<void> => {
    const from = await tab.placeOf(kMarkup);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y);
    await page.mouse.up();
  };
  await drag(await tab.placeOf("box")); // refused
  await page.getByRole("alert").first().waitFor();
  assert.ok((await page.getByRole("alert").first().innerText()).includes(`"${kMarkup}" would overlap "box"`));
  await tab.shoot("markup");
  assert.equal(await page.locator("img, b").count(), 0);
  assert.equal(await page.title(), "manual_control.changed.argos – ARGoS");
  assert.deepEqual(await tab.close(), []);
});

/** Buttons and fields that can be used now, by what a person would call them. */
function usable(tab: Tab): Promise<string[]> {
  return tab.page.evaluate(() => {
    const found: string[] = [];
    for (const element of document.querySelectorAll<HTMLElement>("button, select, input, summary, [tabindex='0']")) {
      const isOff = (element as HTMLButtonElement).disabled || element.tabIndex < 0;
      if (!isOff && element.checkVisibility({ visibilityProperty: true }) && element.getClientRects().length > 0) {
        element.dataset.reached ??= "no";
        found.push(element.getAttribute("aria-label") ?? element.textContent ?? element.id);
      }
    }
    return found;
  });
}

/** Goes through the page by Tab; returns what it has not reached. */
async function notReached(tab: Tab): Promise<string[]> {
  const expected = await usable(tab);
  let isDone = false;
  for (let i = 0; i < 2 * expected.length + 10 && !isDone; ++i) {
    await tab.page.keyboard.press("Tab");
    isDone = await tab.page.evaluate(() => {
      const element = document.activeElement as HTMLElement;
      element.dataset.reached = "yes";
      return document.querySelector("[data-reached='no']") === null;
    });
  }
  return tab.page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("[data-reached='no']")].map((element) => element.outerHTML.slice(0, 100)),
  );
}

interface Node {
  ignored: boolean;
  role?: { value: string };
  name?: { value: string };
}

/** What a screen reader has of each thing that can be used: its role, with those that have no name. */
async function withoutName(session: CDPSession): Promise<string[]> {
  const { nodes } = (await session.send("Accessibility.getFullAXTree")) as { nodes: Node[] };
  // a "MenuListPopup" is a part of a combobox, which has the name
  const roles = /^(button|checkbox|slider|spinbutton|combobox|searchbox|textbox|tab|region|log|dialog|image|menu(?!ListPopup))/i;
  return nodes
    .filter(({ ignored, role, name }) => !ignored && roles.test(role?.value ?? "") && (name?.value ?? "").trim() === "")
    .map(({ role }) => role!.value);
}

test("viewers: keyboard and screen reader reach every button, at 1280 and 390 pixels", { skip, timeout: 2 * kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  for (const size of [{ width: 1280, height: 800 }, { width: 390, height: 844 }]) {
    const tab = await Tab.open(url, size);
    const { page } = tab;
    const session = await page.context().newCDPSession(page);
    await tab.waitForTick((tick) => tick === 0);
    await page.locator('.entities button[data-id="fb0"]').focus();
    await page.keyboard.press("Enter");
    await page.getByText("Readings: footbot_proximity").waitFor();
    assert.deepEqual(await notReached(tab), [], `${size.width}`);
    assert.deepEqual(await withoutName(session), [], `${size.width}`);
    // each panel by the arrow keys, and each menu
    await page.getByRole("tab", { name: "Inspect" }).focus();
    for (const panel of ["Metrics", "Script", "Log", "About"]) {
      await page.keyboard.press("ArrowRight");
      assert.equal(await page.getByRole("tab", { name: panel }).getAttribute("aria-selected"), "true");
      assert.deepEqual(await withoutName(session), [], panel);
    }
    for (const name of ["What the picture shows", "Add a robot or a thing", "Save a picture, a film, the recording, a page, the experiment"]) {
      const opener = tab.button(name);
      await opener.focus();
      await page.keyboard.press("Enter");
      assert.equal(await opener.getAttribute("aria-expanded"), "true");
      assert.deepEqual(await withoutName(session), [], name);
      await page.keyboard.press("Tab");
      assert.ok(
        await page.evaluate(() => document.activeElement!.closest(".menu") !== null),
        `Tab does not lead into the menu "${name}"`,
      );
      await page.keyboard.press("Escape");
      assert.equal(await opener.getAttribute("aria-expanded"), "false");
    }
    assert.deepEqual(await tab.close(), []);
  }
});

// Of text and its background, as WCAG 2.2 asks for: 4.5, and 3 for large text; controls that are off need none.
test("viewers: texts differ from their background by 4.5, light and dark", { skip, timeout: 2 * kTimeout }, async () => {
  const { url } = await startRun("manual_control");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick >= 0);
  await page.locator('.entities button[data-id="fb0"]').click();
  await page.getByRole("region", { name: "fb0", exact: true }).waitFor();
  for (const theme of ["light", "dark"] as const) {
    await tab.setTheme(theme);
    for (const panel of ["Inspect", "Metrics", "Script", "Log", "About"]) {
      await page.getByRole("tab", { name: panel }).click();
      assert.deepEqual(await faintTexts(tab), [], `${theme}, ${panel}`);
    }
    await tab.button("Keys and mouse").click();
    assert.deepEqual(await faintTexts(tab), [], `${theme}, keys`);
    await tab.shoot(`keys_${theme}`);
    await page.keyboard.press("Escape");
    await tab.button("What the picture shows").click();
    assert.deepEqual(await faintTexts(tab), [], `${theme}, menu`);
    await tab.shoot(`menu_${theme}`);
    await page.keyboard.press("Escape");
  }
  assert.deepEqual(await tab.close(), []);
});

function faintTexts(tab: Tab): Promise<string[]> {
  return tab.page.evaluate(() => {
    type Rgba = [number, number, number, number];
    const parse = (text: string): Rgba => {
      const [r = 0, g = 0, b = 0, a = 1] = (text.match(/[\d.]+/g) ?? []).map(Number);
      return [r, g, b, a];
    };
    const over = ([r, g, b, a]: Rgba, [R, G, B]: Rgba): Rgba => [a * r + (1 - a) * R, a * g + (1 - a) * G, a * b + (1 - a) * B, 1];
    const backgroundOf = (element: Element | null): Rgba => {
      if (element === null) {
        return [255, 255, 255, 1];
      }
      const own = parse(getComputedStyle(element).backgroundColor);
      return own[3] === 1 ? own : over(own, backgroundOf(element.parentElement));
    };
    const luminance = (color: Rgba): number => {
      const [r, g, b] = color.map((value) => {
        const share = value / 255;
        return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
      }) as Rgba;
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const found = new Set<string>();
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode() !== null) {
      const element = walker.currentNode.parentElement!;
      const text = walker.currentNode.textContent!.trim();
      const isOff = element.closest(":disabled, .cm-editor, script, style, noscript, option") !== null;
      if (text === "" || isOff || !element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) {
        continue;
      }
      const style = getComputedStyle(element);
      const background = backgroundOf(element);
      const [a, b] = [luminance(over(parse(style.color), background)), luminance(background)];
      const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      const isLarge = Number.parseFloat(style.fontSize) >= 24 || (Number(style.fontWeight) >= 700 && Number.parseFloat(style.fontSize) >= 18.7);
      if (contrast < (isLarge ? 3 : 4.5)) {
        found.add(`${contrast.toFixed(2)}: ${element.tagName} ${element.className} "${text.slice(0, 30)}"`);
      }
    }
    return [...found];
  });
}
