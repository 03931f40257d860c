// The log of a run, with levels and a filter.

import type { LogLine } from "../session";
import { h } from "./dom";

const kMaxLines = 5000;
const kLevels = ["error", "warning", "info", "debug"] as const;

export class LogPanel {
  readonly element: HTMLElement;
  private readonly list = h("ol", { class: "log-lines", role: "log", "aria-label": "Log", "aria-live": "off", tabindex: 0 });
  private readonly filter = h("input", {
    type: "search",
    placeholder: "Filter, such as a robot's id",
    "aria-label": "Filter of the log",
    oninput: () => this.apply(),
  });
  private readonly level = h(
    "select",
    { "aria-label": "Least important lines shown", onchange: () => this.apply() },
    h("option", { value: "3" }, "All lines"),
    h("option", { value: "1" }, "Warnings and errors"),
    h("option", { value: "0" }, "Errors"),
  );
  private readonly empty = h("p", { class: "empty" });
  private tickLength = 0.1;

  constructor() {
    this.element = h(
      "div",
      { class: "log" },
      h("div", { class: "row" }, this.filter, this.level),
      this.empty,
      this.list,
    );
    this.clear();
  }

  /** The last lines that contain an id, as a word of its own; the latest one is the last. */
  linesOf(id: string, count = 5): string[] {
    const word = new RegExp(`(^|[^\\w.-])${id.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}($|[^\\w-])`);
    const lines: string[] = [];
    for (let item = this.list.lastElementChild; item !== null && lines.length < count; item = item.previousElementSibling) {
      const text = item.querySelector(".text")?.textContent ?? "";
      if (word.test(text)) {
        lines.unshift(`${item.querySelector(".at")?.textContent ?? ""}  ${text}`);
      }
    }
    return lines;
  }

  /** Shows only lines that contain a text. */
  setFilter(text: string): void {
    this.filter.value = text;
    this.apply();
  }

  clear(tickLength = 0.1): void {
    this.list.replaceChildren();
    this.tickLength = tickLength;
    this.empty.hidden = false;
  }

  /** What is said while there are no lines. */
  setNote(note: string): void {
    this.empty.textContent = note;
  }

  add(lines: LogLine[]): void {
    this.empty.hidden = true;
    const isAtEnd = this.list.scrollTop + this.list.clientHeight > this.list.scrollHeight - 30;
    for (const line of lines) {
      const time = line.tick === null ? "" : (line.tick * this.tickLength).toFixed(1);
      const item = h(
        "li",
        { class: `level-${line.level}` },
        h("span", { class: "at" }, time),
        h("span", { class: "text" }, line.text.slice(0, 4000)),
      );
      item.dataset.level = String(kLevels.indexOf(line.level));
      item.hidden = !this.isShown(item);
      this.list.append(item);
    }
    while (this.list.childElementCount > kMaxLines) {
      this.list.firstElementChild!.remove();
    }
    if (isAtEnd) {
      this.list.scrollTop = this.list.scrollHeight;
    }
  }

  private isShown(item: HTMLElement): boolean {
    const wanted = this.filter.value.toLowerCase();
    return (
      Number(item.dataset.level) <= Number(this.level.value) &&
      (wanted === "" || (item.textContent ?? "").toLowerCase().includes(wanted))
    );
  }

  private apply(): void {
    for (const item of this.list.children) {
      (item as HTMLElement).hidden = !this.isShown(item as HTMLElement);
    }
  }
}
