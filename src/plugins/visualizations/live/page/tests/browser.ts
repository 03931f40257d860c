// A headless Chromium with the page.

import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach } from "node:test";

import { type Browser, type Page, chromium } from "playwright-core";

import { run } from "./runs";

export const pageFile = process.env.PAGE ?? join(process.cwd(), "dist/index.html");

export const shots = process.env.PAGE_SHOTS;

// where only what is shown counts: fewer pixels, and fewer pictures a second, for the processor draws them
const kSize = { width: 800, height: 560 };
const kPicturePeriod = 60; // ms, added to that of the browser
const kEvents = ["pageerror", "console", "request", "dialog"] as const; // that tests listen to
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

let browser: Browser | null = null;

async function launch(): Promise<Browser> {
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

// in a window of its own: those behind others in a window may not be drawn
async function makePage(opened: Browser): Promise<Page> {
  const page = await opened.newPage({ viewport: kSize });
  await page.addInitScript((period) => {
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) => Number(setTimeout(() => request(draw), period));
  }, kPicturePeriod);
  page.setDefaultTimeout(12_000);
  return page;
}

type Theme = "light" | "dark";

// where pages of files and of servers, which have processes of their own, wait for the next test
const idle = { file: [] as Page[], http: [] as Page[] };

/**
 * A page of the browser that has loaded the page of the live view, whose errors fail the test at its end. The browser needs
 * longer to make a page than to load it again, so the next test may get it: after close() without errors, in which case
 * nothing of the former test is left but the process. What a test that has failed did not close is never used again.
 */
export class Tab {
  readonly errors: string[] = [];
  private static readonly all = new Set<Tab>();

  private constructor(
    readonly page: Page,
    private readonly kind: keyof typeof idle,
  ) {
    Tab.all.add(this);
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

  static async open(url: string, size = kSize, colorScheme: Theme = "light"): Promise<Tab> {
    browser ??= await launch();
    const kind = url.startsWith("http") ? "http" : "file";
    const page = idle[kind].pop() ?? (await makePage(browser));
    await page.setViewportSize(size);
    await page.emulateMedia({ colorScheme });
    const tab = new Tab(page, kind);
    await page.goto(url);
    return tab;
  }

  /** Ends the pages of tests that have failed. */
  static async closeAll(): Promise<void> {
    await Promise.all([...Tab.all].map(({ page }) => page.close()));
    Tab.all.clear();
  }

  /** As a change of the system's setting does. */
  async setTheme(colorScheme: Theme): Promise<void> {
    await this.page.emulateMedia({ colorScheme });
    await this.page.waitForFunction((theme) => document.documentElement.dataset.theme === theme, colorScheme);
    await this.page.evaluate(() => Promise.allSettled(document.getAnimations().map(({ finished }) => finished))); // colours fade
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

  /** Returns the errors of the page. It ends its connection, as a page that is closed does. */
  async close(): Promise<string[]> {
    const { page } = this;
    Tab.all.delete(this);
    if (this.errors.length > 0) {
      await page.close();
      return this.errors;
    }
    if (page.url() !== "about:blank") {
      await page.evaluate(() => localStorage.clear());
    }
    await page.mouse.move(0, 0);
    await page.goto("about:blank");
    kEvents.forEach((event) => page.removeAllListeners(event));
    idle[this.kind].push(page);
    return this.errors;
  }
}

afterEach(() => Tab.closeAll());
after(() => browser?.close());

/** A copy of the page with a recording in it. */
export function embed(recording: string): string {
  const base64 = readFileSync(recording).toString("base64");
  const script = `<script type="application/octet-stream;base64" id="recording">${base64}</script>`;
  return `${readFileSync(pageFile, "utf8")}${script}\n`;
}
