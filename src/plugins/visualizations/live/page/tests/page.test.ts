import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { Tab, embed, missingBrowser, pageFile, shots } from "./browser";
import { changedExperiment, folder, record, run, sampleRecording } from "./runs";

const skip = missingBrowser() ?? false;
const kTimeout = 40_000; // ms, of a test
const url = `file://${pageFile}`;
const recording = skip === false ? sampleRecording() : "";

test("page: a recording is opened, played, paused, stepped and scrubbed", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(url);
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
  const tab = await Tab.open(url);
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
  const tab = await Tab.open(url);
  await tab.openRecording(recording);
  await tab.page.getByRole("searchbox", { name: "Find an entity" }).fill("fb7");
  assert.equal(await tab.page.locator(".entities button").count(), 1);
  await tab.page.keyboard.press("Tab");
  await tab.page.keyboard.press("Enter");
  await tab.page.getByRole("region", { name: "fb7" }).waitFor();
  assert.deepEqual(await tab.close(), []);
});

test("page: every button has a name and a title, at 1280 and 390 pixels", { skip, timeout: kTimeout }, async () => {
  for (const [size, themes] of [
    [{ width: 1280, height: 800 }, ["light", "dark"]],
    [{ width: 390, height: 844 }, ["dark", "light"]],
  ] as const) {
    const tab = await Tab.open(url, size, themes[0]);
    await tab.openRecording(recording);
    await tab.page.locator(".entities button").first().click();
    for (const theme of themes) {
      await tab.setTheme(theme);
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
    }
    assert.deepEqual(await tab.close(), []);
  }
});

test("page: many robots are the same points whether WebGL draws them or the page", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(url);
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
  const tab = await Tab.open(url);
  await tab.openRecording(recording);
  const place = (): Promise<{ width: number; height: number }> =>
    tab.page.evaluate(() => {
      const { width, height } = document.querySelector("canvas.labels")!.getBoundingClientRect();
      return { width, height };
    });
  await tab.page.waitForFunction(() => document.querySelector("canvas.labels")!.clientWidth < 200); // 300 before it is drawn
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
  const tab = await Tab.open(`file://${path}`);
  await tab.waitForTick((tick) => tick === 0, "the embedded recording");
  assert.equal(await tab.page.locator("h1").innerText(), "diffusion_10.argos");
  await tab.page.keyboard.press("End");
  await tab.waitForTick((tick) => tick === 80, "its end");
  assert.deepEqual(await tab.close(), []);
});

test("page: what is no recording is refused with the reason", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(url);
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
  const tab = await Tab.open(`file://${path}`);
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
  const tab = await Tab.open(`${url}?detail=full`, size);
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

test("page: the whole arena stays in the picture when the window changes, unless the camera was moved", { skip, timeout: kTimeout }, async () => {
  const tab = await Tab.open(url);
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
  await tab.page.waitForFunction(() => document.querySelector("canvas")!.clientWidth > 600);
  await tab.page.setViewportSize({ width: 390, height: 844 });
  await becomes(false);
  assert.deepEqual(await tab.close(), []);
});
