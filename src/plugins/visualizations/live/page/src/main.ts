import { prepareUnpacking } from "./decode/blocks";
import { kProtocol } from "./live/client";
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

// the secret of a run; null: the page shows none
function tokenOfRun(): string | null {
  const token = location.hash.slice(1);
  return location.protocol.startsWith("http") && /^[0-9a-f]{8,}$/i.test(token) ? token : null;
}

function start(): void {
  const recording = embeddedRecording();
  const token = recording === null ? tokenOfRun() : null;
  // the connection is made while the page is
  const url = `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/live`;
  const socket = token !== null ? new WebSocket(url, kProtocol) : null;
  const app = new App(document.getElementById("app")!);
  if (recording !== null) {
    void app.openBytes(recording, document.title);
  } else if (socket !== null) {
    app.openLive(url, token!, socket);
  }
}

// a recording may follow the script
if (document.readyState === "loading" && tokenOfRun() === null) {
  document.addEventListener("DOMContentLoaded", start);
} else {
  start();
}
