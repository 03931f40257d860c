#!/usr/bin/python3
"""Opens the pages of the site in a browser and looks at their layout:

    check_widths.py SITE [PAGE]...     by default all pages but those of the API; needs chromium

- at 1280 and at 390 pixels no page is wider than the window;
- at 1280 pixels no block of code is clipped;
- at 390 pixels no line ends inside a word. Blocks of code and tables may scroll there.
"""
import functools
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

TIMEOUT = 300  # s
# opens each page in a frame, and sends what is wrong
HARNESS = """<!DOCTYPE html><body><script>
const pages = %s;
function brokenWord(node, frame) {
  const range = frame.contentDocument.createRange();
  for (const match of node.data.matchAll(/(?<![A-Za-z0-9-])--[A-Za-z0-9]+|[A-Za-z0-9]+/g)) {
    range.setStart(node, match.index);
    range.setEnd(node, match.index + match[0].length);
    const tops = new Set([...range.getClientRects()].filter(r => r.width > 0).map(r => Math.round(r.top / 4)));
    if (tops.size > 1) return match[0];
  }
}
// when the page has been loaded, the theme lets tables scroll and moves the menu out of sight
async function settled(page, width) {
  for (let i = 0; i < 60; ++i) {
    const tables = [...page.querySelectorAll('.md-content table:not([class])')];
    if (tables.every(table => table.closest('.md-typeset__scrollwrap')) && page.documentElement.scrollWidth <= width) return;
    await new Promise(done => setTimeout(done, 50));
  }
}
function problems(frame, width) {
  const page = frame.contentDocument, found = [];
  const content = page.querySelector('.md-content');
  if (!content) return ['has no content'];
  if (page.documentElement.scrollWidth > width) found.push('is ' + page.documentElement.scrollWidth + ' pixels wide');
  for (const code of width == 1280 ? content.querySelectorAll('pre > code') : [])
    if (code.scrollWidth > code.clientWidth + 1) found.push('clips "' + code.textContent.trim().slice(0, 60) + '..."');
  const texts = page.createTreeWalker(content, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const word = texts.currentNode.parentElement.closest('pre, script, style') ? null : brokenWord(texts.currentNode, frame);
    if (word) found.push('breaks the word "' + word + '"');
  }
  return found;
}
async function main() {
  const all = [];
  for (const width of [1280, 390]) {
    const frame = document.createElement('iframe');
    frame.width = width; frame.height = 900;
    document.body.append(frame);
    for (const name of pages) {
      await new Promise(done => { frame.onload = done; frame.src = name; });
      await settled(frame.contentDocument, width);
      for (const text of problems(frame, width)) all.push(name + ' at ' + width + ' pixels: ' + text);
    }
    frame.remove();
  }
  fetch('/found', {method: 'POST', body: JSON.stringify(all)});
}
main().catch(error => fetch('/found', {method: 'POST', body: JSON.stringify([String(error)])}));
</script></body>"""


class Handler(http.server.SimpleHTTPRequestHandler):
    harness, found, is_done = "", [], threading.Event()

    def do_GET(self):
        if self.path != "/check_widths":
            super().do_GET()
            return
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(Handler.harness.encode())

    def do_POST(self):
        Handler.found = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.end_headers()
        Handler.is_done.set()

    def log_message(self, *arguments):
        pass


class Server(http.server.ThreadingHTTPServer):
    def handle_error(self, request, client_address):
        """The browser may end while it is answered."""


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if not browser:
        sys.exit("there is no chromium: apt-get install chromium")
    pages = sys.argv[2:] or sorted(str(page.relative_to(site)) for page in site.rglob("*.html")
                                   if page.relative_to(site).parts[0] != "api" and page.name != "404.html")
    Handler.harness = HARNESS % json.dumps(pages)
    server = Server(("127.0.0.1", 0), functools.partial(Handler, directory=site))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:  # processes of the browser end later
        with subprocess.Popen([browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}",
                               f"http://127.0.0.1:{server.server_port}/check_widths"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            is_done = Handler.is_done.wait(TIMEOUT)
            process.terminate()
            process.wait()
    if not is_done:
        sys.exit(f"the browser has not opened the pages in {TIMEOUT} s")
    print("\n".join(Handler.found) or f"the layout of {len(pages)} pages is right at 1280 and 390 pixels")
    return 1 if Handler.found else 0


if __name__ == "__main__":
    sys.exit(main())
