#include <argos3/campaign/report/page_parts.h>

namespace argos {

// In dark mode figures, whose background is transparent, are inverted in lightness and keep their
// hues. Heatmaps, whose colours stand for numbers, stay as they are.
const char* const kPageStyle = R"(
:root { color-scheme: light dark; --text: #222; --quiet: #666; --line: #ddd; --back: #fff;
  --panel: #f6f6f4; --accent: #332288; --bad: #a3322f; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e4e4e0; --quiet: #a0a09a; --line: #3a3a38; --back: #171716; --panel: #222220;
    --accent: #a9b6f0; --bad: #f08b84; }
  figure svg { filter: invert(0.92) hue-rotate(180deg); }
  figure.heatmap svg { filter: none; background: #fff; border-radius: 0.4rem; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 56rem; padding: 1.5rem 1rem 4rem; background: var(--back);
  color: var(--text); font: 1rem/1.5 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 0.3rem; overflow-wrap: anywhere; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 0.6rem; padding-top: 0.6rem;
  border-top: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.5rem 0 0.4rem; overflow-wrap: anywhere; }
p { margin: 0.4rem 0; overflow-wrap: anywhere; }
.quiet, figcaption, footer { color: var(--quiet); font-size: 0.88rem; }
.notice { border-left: 3px solid var(--bad); padding-left: 0.7rem; }
.numbers { display: flex; flex-wrap: wrap; gap: 0.6rem; margin: 1rem 0; padding: 0; list-style: none; }
.numbers li { flex: 1 1 7rem; padding: 0.5rem 0.8rem; border-radius: 0.4rem;
  background: var(--panel); color: var(--quiet); font-size: 0.82rem; }
.numbers b { display: block; color: var(--text); font-size: 1.25rem; font-weight: 600; }
.wide { margin-bottom: 1rem; overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.88rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.25rem 0.7rem 0.25rem 0; text-align: right; white-space: nowrap;
  border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--quiet); font-weight: 600; white-space: normal; vertical-align: bottom; }
th.text, td.text { text-align: left; }
td.text { white-space: normal; overflow-wrap: break-word; min-width: 3rem; max-width: 30rem; }
td.note { text-align: left; color: var(--bad); white-space: normal; }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure svg { display: block; width: 100%; height: auto; }
pre { margin: 0.3rem 0; padding: 0.5rem 0.7rem; border-radius: 0.3rem;
  white-space: pre-wrap; overflow-wrap: anywhere;
  background: var(--panel); font: 0.8rem/1.4 ui-monospace, "DejaVu Sans Mono", monospace; }
.status { color: var(--bad); font-weight: 600; }
ul { margin: 0.3rem 0; padding-left: 1.3rem; }
details { margin: 0.3rem 0 1rem; }
summary { cursor: pointer; color: var(--accent); }
@media print {
  :root { --text: #000; --quiet: #444; --line: #bbb; --back: #fff; --panel: #fff; --bad: #800; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  figure svg { filter: none; max-width: 14cm; }
  h2, h3 { break-after: avoid; }
  tr { break-inside: avoid; }
}
)";

}  // namespace argos
