// Files that the page makes of what it has in memory.

import { h } from "./dom";

/** Lets the browser write a file into its folder of downloads. */
export function download(parts: BlobPart[], type: string, name: string): void {
  const link = h("a", {
    href: URL.createObjectURL(new Blob(parts, { type })),
    download: name.replace(/[^\w.-]+/g, "_"),
  });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

function toBase64(bytes: Uint8Array): string {
  const kPart = 0x8000;
  let binary = "";
  for (let place = 0; place < bytes.length; place += kPart) {
    binary += String.fromCharCode(...bytes.subarray(place, place + kPart));
  }
  return btoa(binary);
}

/** This page with a recording in it, as HTML. */
export function makePage(recording: Uint8Array, title: string): string {
  const page = document.documentElement.cloneNode(true) as HTMLElement;
  for (const name of [...page.getAttributeNames()].filter((name) => name !== "lang")) {
    page.removeAttribute(name);
  }
  page.querySelector("#recording")?.remove();
  const root = page.querySelector("#app")!;
  root.replaceChildren();
  for (const name of root.getAttributeNames().filter((name) => name !== "id")) {
    root.removeAttribute(name);
  }
  // what scripts have added
  const head = page.querySelector("head")!;
  [...head.querySelectorAll("style")]
    .filter((style) => !(style.textContent ?? "").includes("--surface"))
    .forEach((style) => style.remove());
  page.querySelector("title")!.textContent = title;
  const script = document.createElement("script");
  script.type = "application/octet-stream;base64";
  script.id = "recording";
  script.textContent = toBase64(recording);
  page.querySelector("body")!.append(script);
  const licences = [...document.childNodes].find((node) => node.nodeType === Node.COMMENT_NODE);
  return `<!doctype html>\n<!--${licences?.textContent ?? ""}-->\n${page.outerHTML}\n`;
}

const kFramePeriod = 1000 / 31; // ms
const kRepeatPeriod = 250; // ms

/** A film of what is drawn on a canvas, by the browser's encoder. Its size is that of the beginning. */
export class Film {
  private recorder: MediaRecorder | null = null;
  private readonly canvas = document.createElement("canvas");
  private lastAdded = 0;

  get isRunning(): boolean {
    return this.recorder !== null;
  }

  /** Returns why it is impossible, or null. */
  start(size: [number, number], name: () => string, notify: (text: string) => void): string | null {
    // VP8 does not say how bright its colours are: other players take them for brighter ones
    const type = ["video/webm;codecs=vp9", "video/webm"].find((candidate) => {
      return typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported(candidate);
    });
    if (type === undefined) {
      return "This browser cannot make films";
    }
    [this.canvas.width, this.canvas.height] = size;
    this.canvas.getContext("2d");
    const recorder = new MediaRecorder(this.canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 8e6 });
    const parts: Blob[] = [];
    recorder.ondataavailable = (event) => parts.push(event.data);
    recorder.onstop = () => {
      download(parts, "video/webm", `${name()}.webm`);
      notify("The film is saved");
    };
    recorder.start(1000);
    this.recorder = recorder;
    this.lastAdded = -Infinity;
    return null;
  }

  /** A picture was drawn: draw() copies it to the film. */
  add(now: number, draw: (canvas: HTMLCanvasElement) => void): void {
    if (this.isRunning && now - this.lastAdded >= kFramePeriod) {
      this.lastAdded = now;
      draw(this.canvas);
    }
  }

  /** Nothing was drawn: from time to time the last picture is filmed again, so that the film lasts as long. */
  hold(now: number): void {
    if (this.isRunning && now - this.lastAdded >= kRepeatPeriod) {
      this.lastAdded = now;
      this.canvas.getContext("2d")!.drawImage(this.canvas, 0, 0);
    }
  }

  stop(): void {
    this.recorder?.stop();
    this.recorder = null;
  }
}
