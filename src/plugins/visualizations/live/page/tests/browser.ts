// A headless Chromium with the page.

import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before } from "node:test";

import { type Browser, type Page, chromium } from "playwright-core";

import { endPrograms, run } from "./runs";

export const pageFile = process.env.PAGE ?? join(process.cwd(), "dist/index.html");

export const shots = process.env.PAGE_SHOTS;

const kPaths = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** Null, or why there is no browser. */
export function missingBrowser(): string | null {
  const path = process.env.CHROMIUM ?? kPaths.find((candidate) => existsSync(candidate));
  if (path === undefined && process.env.REQUIRE_BROWSER !== undefined) {
    throw new Error("no Chromium is installed; scripts/packages.txt names its package");
  }
  return path === undefined ? "no Chromium is installed" : null;
}

/** False, or why there can be no test with a run in a browser. */
export function missingLive(): string | false {
  return missingBrowser() ?? (run("--help").includes("--live") ? false : "this argos3 has no --live");
}

/** Opens a browser before the tests of a file, and ends it and all runs after them. */
export function useBrowser(skip: string | false, take: (browser: Browser) => void): void {
  let browser: Browser | undefined;
  before(async () => {
    if (skip === false) {
      take((browser = await launch()));
    }
  });
  after(async () => {
    endPrograms();
    await browser?.close();
  });
}

export async function launch(): Promise<Browser> {
  const executablePath = process.env.CHROMIUM ?? kPaths.find((candidate) => existsSync(candidate))!;
  return chromium.launch({
    executablePath,
    args: [
      "--use-gl=angle",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
      "--ignore-gpu-blocklist",
      "--disable-gpu-rasterization", // as browsers do where the processor draws
      "--no-sandbox",
    ],
  });
}

/** An opened page, whose errors fail the test at its end. */
export class Tab {
  readonly errors: string[] = [];

  private constructor(readonly page: Page) {
    page.on("pageerror", (error) => this.errors.push(error.message));
    page.on("console", (message) => {
      // a lost connection is written by the browser itself
      if (message.type() === "error" && !/WebSocket connection/.test(message.text())) {
        this.errors.push(message.text());
      }
    });
    page.on("request", (request) => {
      const isOwn = /^(file|data|blob):|^(http|ws):\/\/127\.0\.0\.1/.test(request.url());
      if (!isOwn) {
        this.errors.push(`loads ${request.url()} from outside`);
      }
    });
  }

  static async open(
    browser: Browser,
    url: string,
    size = { width: 1280, height: 800 },
    colorScheme: "light" | "dark" = "light",
  ): Promise<Tab> {
    const page = await browser.newPage({ viewport: size, colorScheme });
    page.setDefaultTimeout(12_000);
    const tab = new Tab(page);
    await page.goto(url);
    return tab;
  }

  async openRecording(path: string): Promise<void> {
    await this.page.setInputFiles("input[type=file]", path);
    await this.waitForTick((tick) => tick >= 0);
  }

  async tick(): Promise<number> {
    return Number(await this.page.evaluate(() => document.getElementById("app")!.dataset.tick ?? "-1"));
  }

  async waitForTick(accept: (tick: number) => boolean, what = "a tick"): Promise<number> {
    for (let i = 0; i < 300; ++i) {
      const tick = await this.tick();
      if (accept(tick)) {
        return tick;
      }
      await this.page.waitForTimeout(50);
    }
    throw new Error(`waited in vain for ${what}; the page shows tick ${await this.tick()}`);
  }

  /** Fails if something does not hold within ten seconds. */
  async waitFor(what: string, isTrue: () => Promise<boolean> | boolean): Promise<void> {
    for (let i = 0; i < 200; ++i) {
      if (await isTrue()) {
        return;
      }
      await this.page.waitForTimeout(50);
    }
    throw new Error(`waited in vain for ${what}`);
  }

  /** Keeps a picture of the page in the folder PAGE_SHOTS, if there is one. */
  async shoot(name: string): Promise<void> {
    if (shots !== undefined) {
      mkdirSync(shots, { recursive: true });
      await this.page.waitForTimeout(400);
      await this.page.screenshot({ path: join(shots, `${name}.png`) });
    }
  }

  button(name: string): ReturnType<Page["getByRole"]> {
    return this.page.getByRole("button", { name, exact: true }).first();
  }

  /** Where an entity is in the window. */
  async placeOf(id: string): Promise<{ x: number; y: number }> {
    return this.page.evaluate(async (wanted) => {
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const { argosView: view } = window as unknown as {
        argosView: {
          find(id: string): number;
          poseOf(number: number): { position: [number, number, number] };
          camera: { project(point: number[]): { x: number; y: number } };
        };
      };
      const place = view.camera.project(view.poseOf(view.find(wanted)).position);
      const box = document.querySelector("canvas")!.getBoundingClientRect();
      return { x: place.x + box.x, y: place.y + box.y };
    }, id);
  }

  async close(): Promise<string[]> {
    await this.page.close();
    return this.errors;
  }
}

/** A copy of the page with a recording in it. */
export function embed(recording: string): string {
  const base64 = readFileSync(recording).toString("base64");
  const script = `<script type="application/octet-stream;base64" id="recording">${base64}</script>`;
  return `${readFileSync(pageFile, "utf8")}${script}\n`;
}
