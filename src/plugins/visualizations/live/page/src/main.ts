// Starts the page. The first picture needs all of it, but its connection was made before, see first.ts.

import { prepareUnpacking } from "./decode/blocks";
import { App } from "./ui/app";

// A recording inside the page, as base64.
function embeddedRecording(): Uint8Array | null {
  const text = document.getElementById("recording")?.textContent?.trim() ?? "";
  if (text === "") {
    return null;
  }
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) {
    bytes[i] = binary.charCodeAt(i);
  }
  return bytes;
}

// the decompressor of states is compiled while the page is made
prepareUnpacking().catch(() => undefined); // whoever waits for it says why

function start(): void {
  const recording = embeddedRecording();
  const app = new App(document.getElementById("app")!);
  const first = window.argosConnection;
  if (recording !== null) {
    first?.socket.close();
    void app.openBytes(recording, document.title);
  } else if (first !== undefined) {
    app.openLive(first);
  }
}

start();
