// The selected robots: their values, as a tree, and plots of those that were chosen.

import type { Frame } from "../decode/frames";
import { type EntityType, TypeKind, colorOfWord } from "../decode/types";
import type { Session, Tree, TreeList } from "../session";
import { yawOf } from "../view/math";
import type { View } from "../view/view";
import { button, h, setEnabled, setText } from "./dom";
import { formatNumber } from "./format";
import { ParameterSliders } from "./parameters";
import { Plot, Series } from "./plots";

const kMaxListed = 300;
const kListDelay = 100; // ms
const kMinBars = 6; // numbers of a group that has bars
const kMaxOpen = 8; // longer ones are closed at first

interface Value {
  value: number | string | boolean;
  unit: string;
}

/** Values of one pinned entity. */
class Card {
  readonly element: HTMLElement;
  private readonly rows = new Map<string, { row: HTMLElement; output: HTMLElement }>();
  private readonly groups = new Map<string, HTMLElement>();
  private readonly leds = h("div", { class: "leds", "aria-label": "LEDs" });
  private readonly body = h("div", { class: "tree" });
  private readonly plotArea = h("div", { class: "plots" });
  private readonly plots = new Map<string, Plot>();
  private readonly gone = h("p", { class: "empty" }, "It is no longer in the arena.");
  private readonly follow: HTMLButtonElement;
  private readonly eyes: HTMLButtonElement;
  private readonly remove: HTMLButtonElement;
  private readonly heading: HTMLInputElement;
  private readonly headingRow: HTMLElement;
  private readonly logLines = h("pre", { class: "own-log" });
  private readonly logArea: HTMLElement;
  private readonly parameters: ParameterSliders;
  private readonly presentOnly = h("p", { class: "empty", hidden: true }, "Readings of its devices are known of the present only.");
  private tree: Tree | null = null;

  constructor(
    readonly id: string,
    type: EntityType | undefined,
    private readonly inspector: Inspector,
  ) {
    const { host } = inspector;
    this.follow = button({
      icon: "follow",
      text: "Follow",
      key: "F",
      pressed: false,
      onClick: () => host.follow(this.id, "orbit"),
    });
    this.eyes = button({
      icon: "eye",
      text: "Its view",
      title: "Look ahead from the robot",
      key: "E",
      pressed: false,
      onClick: () => host.follow(this.id, "eyes"),
    });
    this.remove = button({
      icon: "trash",
      text: "Remove",
      title: "Remove it from the arena",
      className: "danger run-only",
      onClick: () => host.session()?.remove(this.id),
    });
    this.heading = h("input", {
      type: "number",
      step: 15,
      "aria-label": `Heading of ${id} in degrees`,
      title: "Heading, degrees",
      onchange: () => host.turn(this.id, (Number(this.heading.value) * Math.PI) / 180),
    });
    this.heading.dataset.title = "Heading, degrees";
    this.headingRow = h("label", { class: "row heading" }, h("span", {}, "Heading (°)"), this.heading);
    this.logArea = h(
      "details",
      { class: "tree log-of", hidden: true, open: true },
      h("summary", {}, h("span", { class: "title" }, "Log")),
      this.logLines,
      button({ text: "All its lines", title: `Show the lines of ${id} in the log`, className: "quiet", onClick: () => host.showLogOf(this.id) }),
    );
    this.parameters = new ParameterSliders(host.session, id, host.notify);
    void this.parameters.load();
    this.element = h(
      "section",
      { class: "card", "aria-label": id },
      h(
        "header",
        {},
        h("h3", {}, id),
        h("span", { class: "tag" }, type?.tag ?? ""),
        button({
          icon: "close",
          title: "Unselect",
          className: "quiet",
          onClick: () => inspector.unpin(this.id),
        }),
      ),
      h("div", { class: "row actions" }, this.follow, this.eyes, this.remove),
      this.headingRow,
      this.gone,
      this.leds,
      this.parameters.element,
      this.logArea,
      this.plotArea,
      this.presentOnly,
      this.body,
    );
  }

  setTree(tree: Tree): void {
    this.tree = tree;
  }

  update(frame: Frame, view: View, time: number): void {
    const { host } = this.inspector;
    const number = view.find(this.id);
    this.gone.hidden = number >= 0;
    this.follow.setAttribute("aria-pressed", String(host.isFollowed(this.id, "orbit")));
    this.eyes.setAttribute("aria-pressed", String(host.isFollowed(this.id, "eyes")));
    setEnabled(this.remove, host.session()?.abilities.move ?? null);
    this.remove.hidden = host.session()?.kind !== "live";
    this.headingRow.hidden = this.remove.hidden || number < 0;
    setEnabled(this.heading, host.session()?.abilities.move ?? null);
    this.presentOnly.hidden = !this.inspector.isPast;
    this.showLog();
    if (number < 0) {
      return;
    }
    const values = this.collect(frame, number);
    const heading = values.get("Pose/heading")?.value;
    if (typeof heading === "number" && document.activeElement !== this.heading) {
      this.heading.value = heading.toFixed(1);
    }
    for (const [path, { value, unit }] of values) {
      this.show(path, value, unit, time);
    }
    this.hideMissing(values);
    this.showBars(values);
    for (const plot of this.plots.values()) {
      plot.update(time);
    }
  }

  // Hides the rows without a value, such as those of messages of the last tick.
  private hideMissing(values: Map<string, Value>): void {
    const groups = new Set<string>();
    for (const path of values.keys()) {
      for (let at = path.indexOf("/"); at >= 0; at = path.indexOf("/", at + 1)) {
        groups.add(path.slice(0, at));
      }
    }
    this.rows.forEach(({ row }, path) => (row.hidden = !values.has(path)));
    this.groups.forEach((details, path) => (details.hidden = !groups.has(path)));
  }

  /** What may be done has changed. */
  updateAbilities(): void {
    this.parameters.setReason(this.inspector.host.session()?.abilities.tune ?? null);
  }

  private showLog(): void {
    const lines = this.inspector.host.logLinesOf(this.id);
    this.logArea.hidden = lines.length === 0;
    setText(this.logLines, lines.join("\n"));
  }

  restyle(): void {
    this.plots.forEach((plot) => plot.restyle());
  }

  updatePlots(): void {
    this.plots.forEach((plot) => plot.update(this.inspector.time));
  }

  destroy(): void {
    this.plots.forEach((plot) => plot.destroy());
  }

  private collect(frame: Frame, number: number): Map<string, Value> {
    const entity = frame.entities[number]!;
    const values = recordedValues(frame, number);
    const flags = frame.words[entity.firstWord] ?? 0;
    if (entity.type.isRobot) {
      const speed = this.inspector.speedOf(this.id);
      if (speed !== null) {
        values.set("Pose/speed", { value: speed, unit: "m/s" });
      }
      values.set("State/controller", {
        value: (flags & 2) !== 0 ? "stopped by an error" : "running",
        unit: "",
      });
      if ((flags & 1) !== 0) {
        values.set("State/quarantine", { value: true, unit: "" });
      }
    }
    this.showLEDs(frame, entity.firstWord, entity.type.numLEDs);
    if (this.tree !== null && !this.inspector.isPast) {
      flatten(this.tree, "", values);
    }
    return values;
  }

  private showLEDs(frame: Frame, firstWord: number, count: number): void {
    this.leds.hidden = count === 0;
    while (this.leds.childElementCount < Math.min(count, 64)) {
      this.leds.append(h("i", {}));
    }
    for (let led = 0; led < Math.min(count, 64); ++led) {
      const [r, g, b] = colorOfWord(frame.words[firstWord + 1 + led]!);
      const dot = this.leds.children[led] as HTMLElement;
      const color = r + g + b === 0 ? "" : `rgb(${r},${g},${b})`;
      if (dot.dataset.color !== color) {
        dot.dataset.color = color;
        dot.style.background = color;
        dot.title = `LED ${led + 1}: ${color === "" ? "off" : color}`;
      }
    }
  }

  private show(path: string, value: Value["value"], unit: string, time: number): void {
    let shown = this.rows.get(path);
    if (shown === undefined) {
      shown = this.makeRow(path, typeof value === "number", unit);
    }
    const text =
      typeof value === "number"
        ? formatNumber(value)
        : typeof value === "boolean"
          ? value
            ? "yes"
            : "no"
          : value;
    setText(shown.output, unit === "" || unit === "°" ? `${text}${unit}` : `${text} ${unit}`);
    const number = typeof value === "boolean" ? Number(value) : value;
    if (typeof number === "number") {
      this.inspector.series(this.id, path).add(time, number);
    }
  }

  private makeRow(path: string, isNumber: boolean, unit: string): { row: HTMLElement; output: HTMLElement } {
    const parts = path.split("/");
    const name = parts.pop()!;
    const group = this.group(parts);
    const output = h("output", {});
    const row = h("div", { class: "value" }, h("span", { class: "name" }, name), output);
    if (isNumber) {
      const toggle = button({
        icon: "plot",
        title: `Plot ${name}`,
        className: "quiet",
        pressed: false,
        onClick: () => this.togglePlot(path, unit, toggle),
      });
      row.append(toggle);
    }
    group.append(row);
    const shown = { row, output };
    this.rows.set(path, shown);
    return shown;
  }

  // many numbers of a group, such as those of a ring of sensors, as bars beside its name
  private showBars(values: Map<string, Value>): void {
    const numbers = new Map<string, number[]>();
    for (const [path, { value }] of values) {
      const group = path.slice(0, path.lastIndexOf("/"));
      if (typeof value === "number" && group !== "Pose") {
        numbers.set(group, [...(numbers.get(group) ?? []), value]);
      }
    }
    for (const [group, details] of this.groups) {
      const list = numbers.get(group) ?? [];
      const bars = details.querySelector(".bars") as HTMLElement;
      if (list.length < kMinBars || list.length > 64) {
        bars.replaceChildren();
        continue;
      }
      if (bars.childElementCount !== list.length) {
        bars.replaceChildren(...list.map(() => h("i", {})));
        (details as HTMLDetailsElement).open = list.length <= kMaxOpen;
      }
      const most = Math.max(...list.map(Math.abs), 1e-12);
      list.forEach((value, i) => {
        const share = Math.round((100 * Math.abs(value)) / most);
        (bars.children[i] as HTMLElement).style.height = `${Math.max(share, 8)}%`;
      });
    }
  }

  // nested details elements
  private group(parts: string[]): HTMLElement {
    const path = parts.join("/");
    const found = this.groups.get(path);
    if (found !== undefined) {
      return found;
    }
    const parent = parts.length > 1 ? this.group(parts.slice(0, -1)) : this.body;
    const name = (parts[parts.length - 1] ?? "").replace(":", ": ");
    const title = name.charAt(0).toUpperCase() + name.slice(1);
    const bars = h("span", { class: "bars", "aria-hidden": "true" });
    const details = h(
      "details",
      { open: parts.length === 1 && path !== "orientation" },
      h("summary", {}, h("span", { class: "title" }, title), bars),
    );
    parent.append(details);
    this.groups.set(path, details);
    return details;
  }

  private togglePlot(path: string, unit: string, toggle: HTMLButtonElement): void {
    const shown = this.plots.get(path);
    toggle.setAttribute("aria-pressed", String(shown === undefined));
    if (shown !== undefined) {
      shown.destroy();
      shown.element.remove();
      this.plots.delete(path);
      return;
    }
    const close = button({
      icon: "close",
      title: "Close the plot",
      className: "quiet",
      onClick: () => this.togglePlot(path, unit, toggle),
    });
    const plot = new Plot(
      path.split("/").pop()!,
      unit,
      this.inspector.series(this.id, path),
      this.inspector.host.seekTime(),
      this.plots.size,
      close,
    );
    this.plots.set(path, plot);
    this.plotArea.append(plot.element);
    plot.update(this.inspector.time);
  }
}

/** What a state has of an entity, by path. */
function recordedValues(frame: Frame, number: number): Map<string, Value> {
  const values = new Map<string, Value>();
  const entity = frame.entities[number]!;
  if (entity.type.kind !== TypeKind.Floor && entity.type.kind !== TypeKind.Other) {
    const at = 7 * entity.firstPose;
    const { poses } = frame;
    values.set("Pose/x", { value: poses[at]!, unit: "m" });
    values.set("Pose/y", { value: poses[at + 1]!, unit: "m" });
    values.set("Pose/z", { value: poses[at + 2]!, unit: "m" });
    const yaw = yawOf([poses[at + 3]!, poses[at + 4]!, poses[at + 5]!, poses[at + 6]!]);
    values.set("Pose/heading", { value: (yaw * 180) / Math.PI, unit: "°" });
  }
  for (const column of frame.columns) {
    const value = column.values[number]!;
    if (!Number.isNaN(value)) {
      const text = column.texts?.[value];
      values.set(`${column.field}/${column.name}`, { value: text ?? value, unit: column.unit });
    }
  }
  return values;
}

const kNatural = new Intl.Collator("en", { numeric: true });
// shown already, from the states; or the same for all robots
const kKnownGroups = new Set(["type", "pose", "leds", "quarantined", "stopped", "lua:_VERSION"]);
const kLua = "lua:";

function numberWithUnit(value: number, unit: string): string {
  return unit === "rad" ? `${formatNumber((value * 180) / Math.PI, 3)}°` : `${formatNumber(value, 3)} ${unit}`.trim();
}

// an item of a list, such as a message, in a line: distances, angles, then texts
function describe(item: Tree): string {
  const order = ([name, value]: [string, unknown]): number => (typeof value !== "number" ? 2 : unitOf(name) === "rad" ? 1 : 0);
  return Object.entries(item)
    .filter(([name, value]) => value !== null && !(name.includes("vertical") && value === 0))
    .sort((a, b) => order(a) - order(b))
    .map(([name, value]) => (typeof value === "number" ? numberWithUnit(value, unitOf(name)) : String(value)))
    .join(", ");
}

function unitOf(name: string): string {
  return / \(([^()]*)\)$/.exec(name)?.[1] ?? "";
}

// a field with one value of its name, and variables of Lua, need no group each
function isFlat(name: string, value: Tree | number | string | boolean | null | TreeList): value is Tree {
  if (typeof value !== "object" || value === null || Array.isArray(value)) {
    return false;
  }
  const names = Object.keys(value);
  return names.length === 1 && (names[0] === name || name.startsWith(kLua));
}

// where sides are not joined, it says the same as the pose
function isSamePlace(tree: Tree): boolean {
  const [pose, unwrapped] = [tree.pose as Tree | undefined, tree.unwrapped as Tree | undefined];
  return pose?.["x (m)"] === unwrapped?.["unwrapped_x (m)"] && pose?.["y (m)"] === unwrapped?.["unwrapped_y (m)"];
}

// the values of a tree by path; names have their unit behind them: "x (m)"
function flatten(tree: Tree, prefix: string, values: Map<string, Value>): void {
  const names = Object.keys(tree).sort((a, b) => kNatural.compare(a, b));
  for (const name of names) {
    const value = tree[name]!;
    if (value === null || (prefix === "" && kKnownGroups.has(name))) {
      continue;
    }
    if (prefix === "" && name === "unwrapped" && isSamePlace(tree)) {
      continue;
    }
    if (prefix === "" && isFlat(name, value)) {
      const only = Object.values(value)[0] as number | string | null;
      if (only !== null) {
        const path = name.startsWith(kLua) ? `Lua variables/${name.slice(kLua.length)}` : `State/${name}`;
        values.set(path, { value: name === "colliding" ? only !== 0 : only, unit: "" });
      }
      continue;
    }
    const [, full = name, unit = ""] = /^(.*?)(?: \(([^()]*)\))?$/.exec(name) ?? [];
    // "readings:proximity" has "proximity_1", of which "1" says the same
    const label = `${prefix.split(/[:/]/).pop() ?? ""}_`;
    const plain = prefix !== "" && full.startsWith(label) ? full.slice(label.length) : full;
    const path = prefix === "" ? `State/${plain}` : `${prefix}/${plain}`;
    if (Array.isArray(value) && value.every((item) => typeof item !== "object")) {
      if (value.length > 0) {
        values.set(path, { value: value.join(", "), unit });
      }
    } else if (Array.isArray(value)) {
      value.forEach((item, i) => values.set(`${name}/${i + 1}`, { value: describe(item as Tree), unit: "" }));
    } else if (typeof value === "object") {
      flatten(value as Tree, prefix === "" ? name : `${prefix}/${name}`, values); // names in lists are numbers
    } else {
      values.set(path, { value, unit });
    }
  }
}

/** What the inspector needs of the page. */
export interface InspectorHost {
  view(): View;
  session(): Session | null;
  follow(id: string, mode: "orbit" | "eyes"): void;
  isFollowed(id: string, mode: "orbit" | "eyes"): boolean;
  seekTime(): ((time: number) => void) | null;
  selectionChanged(ids: string[]): void;
  /** The last lines of the log that name an entity. */
  logLinesOf(id: string): string[];
  showLogOf(id: string): void;
  /** To a heading, rad. */
  turn(id: string, yaw: number): void;
  notify(text: string, kind: "info" | "error"): void;
}

export class Inspector {
  readonly element: HTMLElement;
  /** Ids of pinned entities; the last one was selected last. */
  pinned: string[] = [];
  private readonly cards = new Map<string, Card>();
  private readonly cardArea = h("div", { class: "cards" });
  private readonly search = h("input", {
    type: "search",
    placeholder: "Find by id or type",
    "aria-label": "Find an entity",
    oninput: () => this.find(),
  });
  private readonly findRow = h("div", { class: "row find" }, this.search);
  private readonly list = h("ul", { class: "entities", "aria-label": "Entities" });
  private readonly hint = h("p", { class: "empty" });
  /** Of the state that is shown, s. */
  time = 0;
  /** That state is one before the present. */
  isPast = false;
  private parameters: ParameterSliders | null = null;
  private readonly parameterArea = h("div", { class: "parameter-area" });
  private frame: Frame | null = null;
  private listVersion = -1;
  private listTimer = 0;
  private readonly allSeries = new Map<string, Series>();
  private readonly speeds = new Map<string, number>();
  private readonly last = new Map<string, { time: number; x: number; y: number; z: number }>();

  constructor(readonly host: InspectorHost) {
    this.element = h(
      "div",
      { class: "inspector" },
      this.parameterArea,
      this.findRow,
      this.hint,
      this.cardArea,
      this.list,
    );
    this.updateHint();
  }

  /** A new session. */
  clear(): void {
    this.parameters = null;
    this.parameterArea.replaceChildren();
    this.cards.forEach((card) => card.destroy());
    this.cards.clear();
    this.cardArea.replaceChildren();
    this.pinned = [];
    this.allSeries.clear();
    this.speeds.clear();
    this.last.clear();
    this.frame = null;
    this.listVersion = -1;
    this.list.replaceChildren();
    this.updateHint();
  }

  /** Selects one entity, or with others (shift). */
  select(id: string | null, keepOthers = false): void {
    const kept = keepOthers ? this.pinned.filter((other) => other !== id) : [];
    const wanted = id === null ? kept : [...kept, id];
    for (const [other, card] of this.cards) {
      if (!wanted.includes(other)) {
        card.destroy();
        card.element.remove();
        this.cards.delete(other);
      }
    }
    this.pinned = wanted;
    if (id !== null && !this.cards.has(id)) {
      const entity = this.frame?.entities.find((candidate) => candidate.id === id);
      const card = new Card(id, entity?.type, this);
      this.cards.set(id, card);
      this.cardArea.prepend(card.element);
    }
    this.updateHint();
    this.host.selectionChanged(this.pinned);
    this.markList();
  }

  unpin(id: string): void {
    const others = this.pinned.filter((other) => other !== id);
    const card = this.cards.get(id);
    card?.destroy();
    card?.element.remove();
    this.cards.delete(id);
    this.pinned = others;
    this.updateHint();
    this.host.selectionChanged(others);
    this.markList();
  }

  setTree(id: string, tree: Tree): void {
    const card = this.cards.get(id);
    card?.setTree(tree);
    if (this.frame !== null) {
      card?.update(this.frame, this.host.view(), this.time);
    }
  }

  series(id: string, path: string): Series {
    const key = `${id}\n${path}`;
    let series = this.allSeries.get(key);
    if (series === undefined) {
      series = new Series();
      this.allSeries.set(key, series);
    }
    return series;
  }

  speedOf(id: string): number | null {
    return this.speeds.get(id) ?? null;
  }

  /** What may be done has changed: perhaps there is a new connection. */
  updateAbilities(): void {
    if (this.parameters === null && this.host.session()?.connection === "connected") {
      this.parameters = new ParameterSliders(this.host.session, null, this.host.notify);
      this.parameterArea.replaceChildren(this.parameters.element);
      void this.parameters.load();
    }
    this.parameters?.setReason(this.host.session()?.abilities.tune ?? null);
    this.cards.forEach((card) => card.updateAbilities());
  }

  update(frame: Frame, time: number, isPast = false): void {
    this.frame = frame;
    this.time = time;
    this.isPast = isPast;
    const view = this.host.view();
    for (const id of this.pinned) {
      const number = view.find(id);
      const entity = frame.entities[number];
      if (entity !== undefined && entity.type.isRobot) {
        const at = 7 * entity.firstPose;
        const [x, y, z] = [frame.poses[at]!, frame.poses[at + 1]!, frame.poses[at + 2]!];
        const before = this.last.get(id);
        if (before !== undefined && time > before.time && time - before.time < 5) {
          const way = Math.hypot(x - before.x, y - before.y, z - before.z);
          this.speeds.set(id, way / (time - before.time));
        }
        this.last.set(id, { time, x, y, z });
      }
      this.cards.get(id)?.update(frame, view, time);
    }
    if (frame.entitiesVersion !== this.listVersion) {
      this.listVersion = frame.entitiesVersion;
      this.fillListLater();
    }
  }

  // it costs as much as a picture, which comes first
  private fillListLater(): void {
    if (this.listTimer === 0) {
      this.listTimer = window.setTimeout(() => {
        this.listTimer = 0;
        this.fillList();
      }, kListDelay);
    }
  }

  /** Adds the values of a state that is not shown to what can be plotted. */
  collect(frame: Frame, time: number): void {
    for (const id of this.pinned) {
      const number = frame.entities.findIndex((entity) => entity.id === id);
      if (number < 0) {
        continue;
      }
      for (const [path, { value }] of recordedValues(frame, number)) {
        if (typeof value === "number") {
          this.series(id, path).add(time, value);
        }
      }
    }
  }

  /** Draws plots again to which values were added. */
  updatePlots(): void {
    this.cards.forEach((card) => card.updatePlots());
  }

  /** The run was reset: later values are gone. */
  cutAfter(time: number): void {
    this.allSeries.forEach((series) => series.cutAfter(time));
    this.last.clear();
  }

  restyle(): void {
    this.cards.forEach((card) => card.restyle());
  }

  private updateHint(): void {
    this.hint.hidden = this.pinned.length > 0;
    this.hint.textContent =
      "Click a robot to see its values. Hold Shift to compare several side by side.";
  }

  // what is found is shown below the field, above the cards
  private find(): void {
    if (this.search.value === "") {
      this.element.append(this.list);
    } else {
      this.findRow.after(this.list);
    }
    this.fillList();
  }

  private fillList(): void {
    const wanted = this.search.value.toLowerCase();
    const entities = (this.frame?.entities ?? []).filter(
      (entity) =>
        entity.type.kind !== TypeKind.Floor &&
        (wanted === "" || `${entity.id} ${entity.type.tag}`.toLowerCase().includes(wanted)),
    );
    entities.sort((a, b) => Number(b.type.isRobot) - Number(a.type.isRobot));
    const items = entities.slice(0, kMaxListed).map((entity) => {
      const item = h(
        "button",
        {
          type: "button",
          onclick: (event: MouseEvent) => this.select(entity.id, event.shiftKey),
        },
        h("span", {}, entity.id),
        h("span", { class: "tag" }, entity.type.tag),
      );
      item.dataset.id = entity.id;
      return h("li", {}, item);
    });
    if (entities.length > kMaxListed) {
      const more = (entities.length - kMaxListed).toLocaleString("en");
      items.push(h("li", { class: "empty" }, `and ${more} more: find them by id`));
    }
    this.list.replaceChildren(...items);
    this.markList();
  }

  private markList(): void {
    for (const item of this.list.querySelectorAll("button")) {
      item.setAttribute("aria-pressed", String(this.pinned.includes(item.dataset.id ?? "")));
    }
  }
}
