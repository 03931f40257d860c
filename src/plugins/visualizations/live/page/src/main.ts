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

function start(): void {
  const app = new App(document.getElementById("app")!);
  const recording = embeddedRecording();
  const token = location.hash.slice(1);
  if (recording !== null) {
    void app.openBytes(recording, document.title);
  } else if (location.protocol.startsWith("http") && /^[0-9a-f]{8,}$/i.test(token)) {
    app.openLive(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/live`, token);
  }
}

// a recording may follow the script
if (document.readyState === "loading") {
  document.addEventListener("DOMContentLoaded", start);
} else {
  start();
}
