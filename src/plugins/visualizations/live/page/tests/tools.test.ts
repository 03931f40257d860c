// Scripts, parameters, the past, and files that the page saves, with a run of argos3.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { Tab, missingLive, shots } from "./browser";
import {
  changedExperiment,
  folder,
  readTable,
  repository,
  run,
  startRun,
} from "./runs";

const kTimeout = 60_000; // ms, of a test
const skip = missingLive();

async function save(tab: Tab, item: string): Promise<string> {
  await tab.page.getByRole("button", { name: /^Save a picture, a film/ }).click();
  const [file] = await Promise.all([
    tab.page.waitForEvent("download"),
    tab.page.getByRole("button", { name: item }).click(),
  ]);
  const path = join(folder, file.suggestedFilename());
  await file.saveAs(path);
  return path;
}

async function select(tab: Tab, id: string): Promise<void> {
  await tab.page.locator(`.entities button[data-id="${id}"]`).click();
  await tab.page.getByRole("region", { name: id, exact: true }).waitFor();
}

function positions(tab: Tab): Promise<number[]> {
  return tab.page.evaluate(() => {
    const { argosView: view } = window as unknown as {
      argosView: { frame: { entities: { id: string }[]; poses: Float64Array } };
    };
    return [...view.frame.poses];
  });
}

function editable(): string {
  return changedExperiment("diffusion_10_lua", (xml) =>
    xml
      .replace("controllers/lua/", `${repository}/experiments/controllers/lua/`)
      .replace(/<visualization>[\s\S]*<\/visualization>/, "")
      .replace(
        "</argos-configuration>",
        '<visualization><live edit="true" speed="0" /></visualization></argos-configuration>',
      ),
  );
}

test("tools: a script is edited, with an error and without", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun(editable(), "--length", "60");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0, "the first state");
  await page.getByRole("tab", { name: "Script" }).click();
  await page.getByText("Select a robot first").first().waitFor();
  await page.getByRole("tab", { name: "Inspect" }).click();
  await select(tab, "fb0");
  await page.getByRole("tab", { name: "Script" }).click();
  const editor = page.locator(".cm-content");
  await editor.getByText("sum_up_proximity").first().waitFor();
  assert.equal(await page.locator(".script-title h3").innerText(), "diffusion.lua");
  assert.equal(await tab.button("Restart all robots of this script with it").isDisabled(), true);
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+A");
  await page.keyboard.insertText("function step()\n  robot.wheels.set_velocity(5, = 5)\nend\n");
  await tab.button("Restart all robots of this script with it").click();
  await page.locator(".script-message.error").waitFor();
  assert.match(await page.locator(".script-message").innerText(), /:2: .*near '='/);
  assert.equal(await page.locator(".cm-lint-marker-error").count(), 1);
  await tab.shoot("script-error");
  await editor.click();
  await page.keyboard.press("Control+A");
  await page.keyboard.insertText("function step()\n  robot.wheels.set_velocity(0, 0)\nend\n");
  await page.keyboard.press("Control+Enter");
  await page.getByText("Applied: 10 robots started again").waitFor();
  await tab.shoot("script");
  await page.keyboard.press("Escape");
  await page.locator("canvas").first().click({ position: { x: 5, y: 300 } });
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === 1);
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === 2);
  const start = await positions(tab);
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === 3);
  assert.deepEqual((await positions(tab)).slice(0, 14), start.slice(0, 14));
  assert.match(
    readFileSync(join(repository, "experiments/controllers/lua/diffusion.lua"), "utf8"),
    /sum_up_proximity/,
  );
  assert.deepEqual(await tab.close(), []);
});

test("tools: where scripts may not be edited, the page says why", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10_lua");
  const tab = await Tab.open(url);
  await tab.waitForTick((tick) => tick === 0);
  await select(tab, "fb0");
  await tab.page.getByRole("tab", { name: "Script" }).click();
  await tab.page.getByText("The author of this run does not allow it").first().waitFor();
  assert.equal(await tab.button("Restart all robots of this script with it").isDisabled(), true);
  assert.deepEqual(await tab.close(), []);
});

test("tools: the past of a run is shown, and the present again", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  const start = await positions(tab);
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 15);
  await tab.button("Pause").click();
  await tab.button("Play").waitFor();
  await page.waitForTimeout(300);
  const present = await tab.tick();
  const slider = page.getByRole("slider", { name: "Time" });
  await slider.fill("0");
  await tab.waitForTick((tick) => tick === 0, "the first state");
  assert.deepEqual(await positions(tab), start);
  const speed = page.getByRole("combobox", { name: "Speed" });
  assert.match((await speed.getAttribute("title")) ?? "", /past/);
  await tab.shoot("past");
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 5, "the past to play");
  await tab.button("Pause").click();
  await slider.fill("0");
  await tab.waitForTick((tick) => tick === 0, "the first state");
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick > 0 && tick < present, "the next state");
  await tab.button("Back to the present").click();
  await tab.waitForTick((tick) => tick === present, "the present");
  await tab.button("One tick ahead").click();
  await tab.waitForTick((tick) => tick === present + 1, "a step");
  assert.deepEqual(await tab.close(), []);
});

test("tools: what a viewer has received is saved, and replayed", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("foraging");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await page.getByRole("combobox", { name: "Speed" }).selectOption("10");
  await tab.button("Play").click();
  await tab.waitForTick((tick) => tick > 150);
  await tab.button("Pause").click();
  await tab.button("Play").waitFor();
  await page.waitForTimeout(400);
  const last = await tab.tick();
  const recording = await save(tab, "Save what this page has received, for argos3 --replay");
  run("-z", "--quiet", "--replay", recording, "--csv", join(folder, "saved"));
  const rows = readTable(join(folder, "saved/robots.csv"));
  assert.equal(Number(rows.at(-1)!.get("tick")), last);
  const poses = await positions(tab);
  const x = Number(rows.at(-12)!.get("x"));
  assert.ok(poses.some((value) => Math.abs(value - x) < 1e-9));

  const html = await save(tab, "Save this page with the recording in it, HTML: it opens without a server");
  const opened = await Tab.open(`file://${html}`);
  await opened.waitForTick((tick) => tick === 0, "the first state of the file");
  await opened.page.keyboard.press("End");
  await opened.waitForTick((tick) => tick === last, "the last state of the file");
  assert.deepEqual(await opened.close(), []);
  assert.deepEqual(await tab.close(), []);
});

interface Region {
  x: number;
  y: number;
  width: number;
  height: number;
}

// mean differences of the channels of two pictures in regions; a film is shown by its last picture
async function compare(first: string, second: string, regions: Region[]): Promise<number[]> {
  const tab = await Tab.open("about:blank");
  const differences = await tab.page.evaluate(
    async ([urls, places]) => {
      const load = async (url: string): Promise<CanvasImageSource & { w: number; h: number }> => {
        if (url.startsWith("data:image")) {
          const image = new Image();
          image.src = url;
          await image.decode();
          return Object.assign(image, { w: image.width, h: image.height });
        }
        const video = document.createElement("video");
        video.muted = true;
        video.src = url;
        await Promise.all([new Promise((resolve) => (video.onended = resolve)), video.play()]);
        return Object.assign(video, { w: video.videoWidth, h: video.videoHeight });
      };
      const images = await Promise.all(urls.map(load));
      return places.map(({ x, y, width, height }) => {
        const [a, b] = images.map((image) => {
          const canvas = document.createElement("canvas");
          [canvas.width, canvas.height] = [images[0]!.w, images[0]!.h];
          const context = canvas.getContext("2d")!;
          context.drawImage(image, 0, 0, canvas.width, canvas.height);
          return context.getImageData(x, y, width, height).data;
        });
        return a!.reduce((sum, value, i) => sum + Math.abs(value - b![i]!), 0) / (0.75 * a!.length);
      });
    },
    [[first, second], regions] as const,
  );
  assert.deepEqual(await tab.close(), []);
  return differences;
}

function dataUrl(path: string, type: string): string {
  return `data:${type};base64,${readFileSync(path).toString("base64")}`;
}

// The regions have a robot's id and the clock: without texts they differ by more than 8 levels. The film's encoder changes
// some levels of what is fine, but much less than a missing text.
test("tools: pictures and films have the texts and the clock that the page shows", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await page.keyboard.press("i");
  await page.getByRole("button", { name: /^Save a picture, a film/ }).click();
  await page.getByRole("button", { name: "Make a film of the picture from now on, WebM" }).click();
  await page.waitForTimeout(300);
  await page.getByRole("button", { name: "Go ahead by this number of ticks" }).click();
  await tab.waitForTick((tick) => tick === 10);
  await page.waitForTimeout(2500); // the encoder may be late
  const [download] = await Promise.all([page.waitForEvent("download"), tab.button("Save the film as a file").click()]);
  const film = join(shots ?? folder, "film.webm");
  await download.saveAs(film);
  const picture = dataUrl(await save(tab, "Save the picture, PNG"), "image/png");
  const place = await tab.placeOf("fb3");
  const stage = (await page.locator("canvas.picture").boundingBox())!;
  const regions = [
    { x: Math.round(place.x - stage.x) - 14, y: Math.round(place.y - stage.y) - 30, width: 28, height: 24 },
    { x: Math.floor(stage.width) - 70, y: Math.floor(stage.height) - 42, width: 66, height: 32 },
  ];
  const bare = await page.evaluate(() => {
    const { argosView: view } = window as unknown as {
      argosView: { capture(withLabels: boolean): HTMLCanvasElement };
    };
    return view.capture(false).toDataURL();
  });
  const shown = `data:image/png;base64,${(await page.screenshot({ clip: stage })).toString("base64")}`;
  const ofBare = await compare(picture, bare, regions);
  assert.ok(Math.min(...ofBare) > 8, `without texts: ${ofBare.join()}`);
  const ofPage = await compare(picture, shown, regions.slice(0, 1));
  assert.ok(ofPage[0]! < 2, `on the page: ${ofPage.join()}`);
  const ofFilm = await compare(picture, dataUrl(film, "video/webm"), regions);
  assert.ok(ofFilm.every((value, i) => value < 0.4 * ofBare[i]!), `in the film: ${ofFilm.join()}`);
  assert.deepEqual(await tab.close(), []);
});

test("tools: the experiment is saved with everything where it is", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await tab.button("Add a robot or a thing").click();
  await tab.button("Add a cylinder in the middle of the picture").click();
  await select(tab, "fb3");
  await page.getByRole("button", { name: "Remove it from the arena" }).click();
  await page.getByText("no longer in the arena").waitFor();
  await page.getByRole("spinbutton", { name: "Number of ticks" }).fill("30");
  await page.getByRole("button", { name: "Go ahead by this number of ticks" }).click();
  await tab.waitForTick((tick) => tick === 30);
  await page.waitForTimeout(300);
  const poses = await positions(tab);
  const file = await save(tab, "Save the experiment with everything where it is now");
  const text = readFileSync(file, "utf8");
  assert.match(text, /cylinder_added_1/);
  assert.doesNotMatch(text, /<distribute|id="fb3"/);
  run(file, "-z", "--quiet", "--length", "0.1", "--csv", join(folder, "world"));
  const rows = readTable(join(folder, "world/robots.csv")).filter((row) => row.get("tick") === "0");
  assert.equal(rows.length, 9);
  for (const row of rows) {
    const x = Number(row.get("x"));
    assert.ok(poses.some((value) => Math.abs(value - x) < 1e-6), `${row.get("robot")} is elsewhere`);
  }
  assert.deepEqual(await tab.close(), []);
});

test("tools: a robot is turned by dragging and by keys, and parameters are set", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("diffusion_10");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await page.keyboard.press("t");
  await page.waitForTimeout(300);
  await select(tab, "fb0");
  const card = page.getByRole("region", { name: "fb0", exact: true });
  const heading = card.getByLabel("Heading of fb0 in degrees");
  await page.locator("canvas").first().focus();
  const from = await tab.placeOf("fb0");
  await page.keyboard.down("Control");
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x, from.y - 60, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.up("Control");
  const shows = async (degrees: number): Promise<void> => {
    for (let i = 0; i < 100 && Math.abs(Number(await heading.inputValue()) - degrees) > 3; ++i) {
      await page.waitForTimeout(50);
    }
    assert.ok(Math.abs(Number(await heading.inputValue()) - degrees) <= 3, await heading.inputValue());
  };
  await shows(90);
  await page.keyboard.press("]");
  await shows(75);
  await heading.fill("-30");
  await heading.press("Enter");
  await shows(-30);
  const slider = card.getByRole("slider", { name: "velocity, cm/s" });
  await slider.fill("0");
  await slider.dispatchEvent("change");
  await card.getByText("0 cm/s", { exact: true }).first().waitFor();
  await select(tab, "fb5");
  await page.getByRole("region", { name: "fb5", exact: true }).getByText("0 cm/s", { exact: true }).first().waitFor();
  await tab.shoot("parameters");
  assert.deepEqual(await tab.close(), []);
});

test("tools: what a robot perceives is drawn, and its lines of the log are with it", { skip, timeout: kTimeout }, async () => {
  const { url } = await startRun("flocking");
  const tab = await Tab.open(url);
  const { page } = tab;
  await tab.waitForTick((tick) => tick === 0);
  await page.getByRole("button", { name: "Go ahead by this number of ticks" }).click();
  await tab.waitForTick((tick) => tick === 10);
  await select(tab, "fb0");
  const count = (): Promise<number> =>
    page.evaluate(
      () =>
        (window as unknown as { argosView: { deviceDots: { batch: { length: number } } } }).argosView.deviceDots.batch
          .length,
    );
  for (let i = 0; i < 100 && (await count()) === 0; ++i) {
    await page.waitForTimeout(50);
  }
  assert.ok((await count()) > 3, "blobs of the camera");
  await page.keyboard.press("f");
  await tab.shoot("devices");
  assert.deepEqual(await tab.close(), []);
});
