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

/** A film of a canvas, by the browser's encoder. */
export class Film {
  private recorder: MediaRecorder | null = null;

  get isRunning(): boolean {
    return this.recorder !== null;
  }

  /** Returns why it is impossible, or null. */
  start(canvas: HTMLCanvasElement, name: () => string, notify: (text: string) => void): string | null {
    const type = ["video/webm;codecs=vp9", "video/webm"].find((candidate) => {
      return typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported(candidate);
    });
    if (type === undefined) {
      return "This browser cannot make films";
    }
    const recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 8e6 });
    const parts: Blob[] = [];
    recorder.ondataavailable = (event) => parts.push(event.data);
    recorder.onstop = () => {
      this.recorder = null;
      download(parts, "video/webm", `${name()}.webm`);
      notify("The film is saved");
    };
    recorder.start(1000);
    this.recorder = recorder;
    return null;
  }

  stop(): void {
    this.recorder?.stop();
  }
}
