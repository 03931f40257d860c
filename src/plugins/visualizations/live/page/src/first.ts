// Runs before the rest of the page is read: connects to the run, and then starts the page.

import { type FirstConnection, connect } from "./live/connect";
import { part } from "./parts";

// the secret of a run; null: the page shows none
function tokenOfRun(): string | null {
  const token = location.hash.slice(1);
  return location.protocol.startsWith("http") && /^[0-9a-f]{8,}$/i.test(token) ? token : null;
}

declare global {
  interface Window {
    argosConnection?: FirstConnection;
  }
}

const token = tokenOfRun();
if (token !== null) {
  const url = `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/live`;
  window.argosConnection = connect(url, token);
}
// while a page loads, browsers draw that it does, which takes time from it; and a recording may follow the scripts
addEventListener("load", () => setTimeout(() => part("page")));
