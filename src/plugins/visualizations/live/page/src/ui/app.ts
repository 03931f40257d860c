// The page: its parts, and what connects them.

import type { RecordingInfo } from "../decode/blocks";
import type { Frame } from "../decode/frames";
import { Recording, sourceOfBlob, type ByteSource, sourceOfBytes } from "../decode/recording";
import { arenaAround, readArena } from "../experiment";
import { LiveClient } from "../live/client";
import type { FirstConnection } from "../live/connect";
import { RecordingPlayer } from "../player";
import { Scan } from "../scan";
import type { LogLine, Perception, Session, SessionListener, Tree } from "../session";
import { type CameraMode } from "../view/camera";
import { addDevices } from "../view/devices";
import { kDarkLook, kLightLook } from "../view/looks";
import type { Dot, Line } from "../view/marks";
import { yawOf } from "../view/math";
import { openSurface } from "../view/surface";
import { View, type ViewOptions, kDefaultOptions } from "../view/view";
import { makeWorld } from "../world";
import { DriveKeys } from "./drive";
import { button, h, icon, menu, setEnabled, setText } from "./dom";
import { formatNumber, formatTime, plural } from "./format";
import { Inspector } from "./inspector";
import { LogPanel } from "./log";
import { Plot, Series } from "./plots";
import { PointerControl } from "./pointer";
import { Film, download, makePage } from "./save";
import { ScriptPanel } from "./script";
import { Transport } from "./transport";
import { UserKeys, isCommand, modifiersOf } from "./user_keys";

type Theme = "auto" | "light" | "dark";
type TabName = "inspect" | "metrics" | "script" | "log" | "info";

const kUiPeriod = 120; // ms
const kSlowPeriod = 60; // ms from picture to picture
const kMaxSlowPictures = 15; // pictures
const kAddStep = 0.05; // share of the distance of the camera
const kMaxPerceptions = 64; // limit for each entity; fewer states are on their way
const kKeysOfBrowsers = /^(Tab|F\d+)$/; // their default action is kept

const kOptionNames: [keyof ViewOptions, string, string][] = [
  ["ids", "Ids", "I"],
  ["trails", "Trails", "R"],
  ["headings", "Headings", "H"],
  ["rays", "Rays of sensors", "S"],
  ["devices", "What the selected robots perceive", "D"],
  ["drawing", "What user code draws", "U"],
  ["axes", "Axes", "A"],
  ["scaleBar", "Scale bar", "B"],
  ["grid", "Grid", "G"],
  ["clock", "Time in saved pictures and films", "C"],
];

const kKeys: [string, string][] = [
  ["Space", "Play or pause"],
  ["→ / ←", "One state ahead or back"],
  ["Home / End", "To the start or the end"],
  ["+ / −", "Faster or slower"],
  ["T", "From above"],
  ["O", "From the side, whole arena"],
  ["F / E", "Follow the selected robot / look ahead from it"],
  ["I R H S D U A B G C", "Ids, trails, headings, rays, devices, drawings, axes, scale bar, grid, saved time"],
  ["[ / ]", "Turn the selected robot or thing by 15°"],
  ["Esc", "Unselect"],
  ["Click the picture", "From then on, keys go to user functions of the experiment first, if there are any, until Tab or a click elsewhere"],
  ["Drag", "Turn the camera; with Shift or the right button: move it"],
  ["Drag what is selected", "Move it; with Ctrl or Alt: turn it"],
  ["Wheel", "Zoom"],
];

/** A place, then places around it on two rings. */
function placesAround([x, y, z]: readonly [number, number, number], step: number): [number, number, number][] {
  const places: [number, number, number][] = [[x, y, z]];
  for (const ring of [1, 2]) {
    for (let i = 0; i < 8 * ring; ++i) {
      const angle = (Math.PI * i) / (4 * ring);
      places.push([x + ring * step * Math.cos(angle), y + ring * step * Math.sin(angle), z]);
    }
  }
  return places;
}

function stored(name: string): string | null {
  try {
    return localStorage.getItem(`argos3-${name}`);
  } catch {
    return null; // the browser keeps nothing for files
  }
}

function store(name: string, value: string): void {
  try {
    localStorage.setItem(`argos3-${name}`, value);
  } catch {
    // the browser keeps nothing for files
  }
}

export class App implements SessionListener {
  private session: Session | null = null;
  private view!: View; // undefined where the browser cannot draw: then nothing is opened
  private frame: Frame | null = null;
  private theme: Theme = (stored("theme") as Theme | null) ?? "auto";
  private tab: TabName = "inspect";
  private readonly transport = new Transport();
  private readonly log = new LogPanel();
  private readonly script: ScriptPanel;
  private readonly film = new Film();
  private readonly inspector: Inspector;
  private readonly metricPlots = new Map<string, Plot>();
  private readonly metricArea = h("div", { class: "plots" });
  private readonly metricHint = h("p", { class: "empty" });
  private readonly infoList = h("dl", { class: "info" });
  private canvas = h("canvas", {
    class: "picture",
    tabindex: 0,
    role: "img",
    "aria-label": "The arena. Entities can also be chosen in the list of the panel “Inspect”.",
  });
  private readonly labelCanvas = h("canvas", { class: "labels", "aria-hidden": "true" });
  private readonly title = h("h1", {}, "ARGoS");
  private readonly stateChip = h("span", { class: "chip", role: "status" });
  private readonly factor = h("span", { class: "factor", title: "Simulated seconds in a second" });
  private readonly people = h("div", { class: "people" });
  private readonly banner = h("div", { class: "banner", role: "status", hidden: true });
  private readonly note = h("p", { class: "note", hidden: true });
  private readonly welcome = h("div", { class: "welcome" });
  private readonly toasts = h("div", { class: "toasts", "aria-live": "polite" });
  private readonly tabs = new Map<TabName, { tab: HTMLButtonElement; panel: HTMLElement }>();
  private readonly optionBoxes = new Map<keyof ViewOptions, HTMLInputElement>();
  private readonly modeButtons = new Map<string, HTMLButtonElement>();
  private readonly fileInput = h("input", {
    type: "file",
    accept: ".rec",
    class: "hidden-file",
    "aria-label": "Recording",
    tabindex: -1,
    onchange: () => {
      const file = this.fileInput.files?.[0];
      if (file !== undefined) {
        void this.openFile(file);
      }
      this.fileInput.value = "";
    },
  });
  private readonly themeButton = button({
    icon: "theme",
    title: "Light or dark",
    className: "quiet",
    onClick: () => this.nextTheme(),
  });
  private readonly help = this.makeHelp();
  private readonly drive: DriveKeys;
  private readonly userKeys = new UserKeys({
    tell: (key, isDown, modifiers) => this.session?.key(key, isDown, modifiers) ?? null,
    act: (key) => this.runKey(key, this.canvas),
  });
  private readonly addMenu = h("div", {});
  private readonly liveTools = h("div", { class: "tools live-tools", hidden: true });
  private addType: string | null = null;
  private frames = 0;
  private framesSince = 0;
  private lastTime = 0;

  constructor(private readonly root: HTMLElement) {
    this.drive = new DriveKeys({ drive: (id, speeds) => this.session?.drive(id, speeds) });
    this.script = new ScriptPanel({
      session: () => this.session,
      selectedId: () => this.selectedId(),
      notify: (text, kind) => this.notify(text, kind),
    });
    this.inspector = new Inspector({
      view: () => this.view,
      session: () => this.session,
      follow: (id, mode) => this.follow(id, mode),
      isFollowed: (id, mode) => this.isFollowed(id, mode),
      seekTime: () => this.seekTime(),
      selectionChanged: (ids) => this.selectionChanged(ids),
      logLinesOf: (id) => this.log.linesOf(id),
      showLogOf: (id) => {
        this.log.setFilter(id);
        this.showTab("log");
      },
      turn: (id, yaw) => this.turnTo(id, yaw),
      notify: (text, kind) => this.notify(text, kind),
    });
    this.root.append(this.makeLayout(), this.fileInput, this.help);
    try {
      const surface = openSurface(this.canvas); // of its size, now that it has a place
      this.canvas = surface.canvas;
      this.view = new View(surface, this.labelCanvas);
      Object.assign(window, { argosView: this.view }); // for tests and the console
    } catch (error) {
      this.showTab("inspect");
      this.welcome.replaceChildren(h("p", { class: "error", role: "alert" }, (error as Error).message));
      return;
    }
    this.applyTheme();
    new PointerControl(this.canvas, this.view, {
      picked: (entity, withShift) => this.picked(entity, withShift),
      canDrag: (entity) => this.canDrag(entity),
      dragged: (entity, place, isDone) => this.dragged(entity, place, isDone),
      turned: (entity, yaw, isDone) => this.turned(entity, yaw, isDone),
      moved: () => {
        if (this.view.followed >= 0 && this.view.camera.mode !== "eyes") {
          this.stopFollowing();
        }
      },
    });
    new ResizeObserver(() => this.view.resize()).observe(this.canvas);
    window
      .matchMedia("(prefers-color-scheme: dark)")
      .addEventListener("change", () => this.applyTheme());
    document.addEventListener("keydown", (event) => this.keyDown(event));
    document.addEventListener("keyup", (event) => this.keyUp(event));
    window.addEventListener("blur", () => {
      this.drive.releaseKeys();
      this.userKeys.releaseAll();
    });
    // after a click of the mouse, the space bar is for the whole page again
    document.addEventListener("click", (event) => {
      const target = (event.target as HTMLElement).closest("button, summary, input[type=checkbox]");
      if (event.detail > 0 && target instanceof HTMLElement && !this.help.open) {
        target.blur();
      }
    });
    this.listenToDrops();
    this.showTab("inspect");
    this.updateNote();
    requestAnimationFrame((now) => this.draw(now));
  }

  async openFile(file: File): Promise<void> {
    await this.openSource(sourceOfBlob(file), file.name);
  }

  async openBytes(bytes: Uint8Array, name: string): Promise<void> {
    await this.openSource(sourceOfBytes(bytes), name);
  }

  openLive(first: FirstConnection): void {
    if (this.view === undefined) {
      first.socket.close(); // the page says why there is no picture
      return;
    }
    this.start(new LiveClient(this, first));
  }

  private async openSource(source: ByteSource, name: string): Promise<void> {
    if (this.view === undefined) {
      return; // the page says why there is no picture
    }
    this.root.classList.add("is-loading");
    try {
      const recording = await Recording.open(source);
      this.start(new RecordingPlayer(recording, name, this));
      this.recording = recording;
      this.scan(true);
    } catch (error) {
      this.notify(`Cannot open “${name}”: ${(error as Error).message}`, "error");
    }
    this.root.classList.remove("is-loading");
  }

  private recording: Recording | null = null;
  private scanning: Scan | null = null;

  // values of the whole recording, for plots
  private scan(withMetrics: boolean): void {
    this.scanning?.stop();
    if (this.recording === null) {
      return;
    }
    const needsMetrics = withMetrics || !this.hasAllMetrics;
    this.hasAllMetrics = false;
    this.scanning = new Scan(
      this.recording,
      (frame) => {
        const time = this.timeOf(frame.tick);
        if (needsMetrics) {
          this.collectMetrics(frame, time);
          this.hasAllMetrics = frame.tick >= this.recording!.lastTick;
        }
        this.inspector.collect(frame, time);
      },
      () => {
        this.inspector.updatePlots();
        this.updateMetricPlots();
      },
    );
    this.hasAllMetrics = !needsMetrics;
  }

  private hasAllMetrics = false;

  private updateMetricPlots(): void {
    if (this.tab === "metrics" && this.frame !== null) {
      const time = this.timeOf(this.frame.tick);
      this.metricPlots.forEach((plot) => plot.update(time));
    }
  }

  private start(session: Session): void {
    this.session?.close();
    this.scanning?.stop();
    this.recording = null;
    this.session = session;
    this.welcome.hidden = true;
    const isLive = session.kind === "live";
    this.liveTools.hidden = !isLive;
    this.log.setNote(isLive ? "Nothing was logged yet." : "Recordings do not contain the log of a run.");
    this.transport.setSession(session);
    this.changed();
  }

  opened(info: RecordingInfo): void {
    this.frame = null;
    this.inspector.clear();
    this.script.clear();
    this.perceptions.clear();
    this.metricPlots.forEach((plot) => plot.destroy());
    this.metricPlots.clear();
    this.metricArea.replaceChildren();
    this.log.clear(info.tickLength);
    const name = info.experimentFile.split("/").pop() ?? "";
    document.title = name === "" ? "ARGoS" : `${name} – ARGoS`;
    setText(this.title, name === "" ? "Experiment" : name);
    const rows: [string, string][] = [
      ["Experiment", info.experimentFile],
      ["Seed", String(info.seed)],
      ["Date", info.date.replace("T", " ")],
      ["Length of a tick", `${formatNumber(info.tickLength)} s`],
      ["Simulator", info.version],
      ["Build", info.build],
      ["Renderer", this.view.rendererName],
    ];
    this.infoList.replaceChildren(
      ...rows
        .filter(([, value]) => value !== "")
        .flatMap(([term, value]) => [h("dt", {}, term), h("dd", {}, value)]),
    );
    if (info.experiment !== "") {
      this.infoList.append(
        h("dt", {}, "File"),
        h("dd", {}, h("pre", { tabindex: 0, class: "xml" }, info.experiment)),
      );
    }
    const arena = readArena(info.experiment);
    this.hasArena = arena !== null;
    if (arena !== null) {
      this.view.setArena(arena);
    }
  }

  private hasArena = false;

  showFrame(frame: Frame, isJump: boolean): void {
    if (!this.hasArena) {
      this.hasArena = true;
      this.view.setArena(arenaAround(frame));
    }
    this.frame = frame;
    const time = this.timeOf(frame.tick);
    if (this.session?.isPast === true) {
      this.showPast(frame, time);
      return;
    }
    if (time < this.lastTime && this.session?.kind === "live") {
      this.inspector.cutAfter(time);
      this.metricPlots.forEach((plot) => plot.series.cutAfter(time));
    }
    this.lastTime = time;
    if (isJump) {
      this.view.jump(frame);
    } else {
      this.view.push(frame);
    }
    this.mapSelection();
    this.collectMetrics(frame, time);
    this.inspector.update(frame, time);
    this.selectAdded();
    this.updateMetricPlots();
    this.root.dataset.tick = String(frame.tick);
  }

  // plots keep what is later
  private showPast(frame: Frame, time: number): void {
    this.view.jump(frame);
    this.mapSelection();
    this.inspector.update(frame, time, true);
    this.updateMetricPlots();
    this.root.dataset.tick = String(frame.tick);
  }

  setBlend(blend: number): void {
    this.view.setBlend(blend);
  }

  private uiKey = "";
  private uiChangedAt = 0;
  private needsUi = false;

  changed(): void {
    const { session } = this;
    const key =
      session === null
        ? ""
        : JSON.stringify([
            ...[session.state, session.connection, session.speed, session.control],
            ...[session.viewers, session.abilities, session.typesToAdd],
            ...[session.isPast, session.times],
          ]);
    this.needsUi = true;
    if (key !== this.uiKey) {
      this.uiKey = key;
      this.updateUi();
    }
  }

  // time moves on in each picture, but drawing it costs as much as a picture
  private updateUi(): void {
    const { session } = this;
    this.needsUi = false;
    this.uiChangedAt = performance.now();
    this.transport.update();
    if (session === null) {
      return;
    }
    this.root.classList.toggle("is-past", session.isPast);
    this.root.dataset.times = session.times;
    const names = { loading: "Loading", playing: "Playing", paused: "Paused", ended: "Ended" };
    const text =
      session.connection === "lost"
        ? "Connection lost"
        : session.isPast
          ? "The past"
          : names[session.state];
    setText(this.stateChip, text);
    this.stateChip.dataset.state = session.connection === "lost" ? "lost" : session.state;
    const factor = session.realTimeFactor;
    setText(this.factor, factor === null ? "" : `${formatNumber(factor, 3)}× real time`);
    this.updateBanner(session);
    this.updatePeople(session);
    this.updateLiveTools(session);
    this.script.update();
    this.inspector.updateAbilities();
  }

  addLog(lines: LogLine[]): void {
    this.log.add(lines);
    this.script.addLog(lines);
  }

  values(entity: string, _tick: number, tree: Tree): void {
    this.inspector.setTree(entity, tree);
  }

  // The last perceptions of each entity, by tick: of states that are shown or still to come.
  private readonly perceptions = new Map<string, Map<number, Perception>>();

  perceived(entity: string, perception: Perception): void {
    const { tick } = perception;
    let known = this.perceptions.get(entity);
    if (known === undefined || tick < Math.max(...known.keys())) {
      known = new Map(); // the run was reset, or it is the first one
      this.perceptions.set(entity, known);
    }
    known.set(tick, perception);
    if (known.size > kMaxPerceptions) {
      known.delete(known.keys().next().value!);
    }
    if (tick === this.frame?.tick) {
      this.updateDevices();
    }
  }

  // Draws what pinned entities perceive at the tick that is shown; nothing of the past.
  private updateDevices(): void {
    const lines: Line[] = [];
    const dots: Dot[] = [];
    if (this.view.options.devices && this.session?.isPast === false && this.frame !== null) {
      for (const id of this.inspector.pinned) {
        const perception = this.perceptions.get(id)?.get(this.frame.tick);
        const number = this.view.find(id);
        if (perception !== undefined && number >= 0) {
          const owner = {
            pose: this.view.entity(number)!.firstPose,
            radius: this.view.radiusOf(number),
            top: this.view.topOf(number),
          };
          addDevices(owner, perception, lines, dots);
        }
      }
    }
    this.view.setDevices(lines, dots);
  }

  notify(text: string, kind: "info" | "error"): void {
    const sentence = text.charAt(0).toUpperCase() + text.slice(1);
    const toast = h("div", { class: `toast ${kind}`, role: kind === "error" ? "alert" : "status" }, sentence);
    const close = button({
      icon: "close",
      title: "Close",
      className: "quiet",
      onClick: () => toast.remove(),
    });
    toast.append(close);
    this.toasts.append(toast);
    while (this.toasts.childElementCount > 4) {
      this.toasts.firstElementChild!.remove();
    }
    setTimeout(() => toast.remove(), kind === "error" ? 9000 : 4000);
  }

  private draw(now: number): void {
    requestAnimationFrame((next) => this.draw(next));
    this.session?.update(now);
    if (this.needsUi && performance.now() - this.uiChangedAt > kUiPeriod) {
      this.updateUi();
    }
    if (this.view.render(now)) {
      this.watchSpeed(now);
      this.film.add(now, (canvas) => this.view.copyTo(canvas, this.clockText()));
    } else {
      this.film.hold(now);
    }
    ++this.frames;
    if (now - this.framesSince > 1000) {
      this.root.dataset.fps = ((1000 * this.frames) / (now - this.framesSince)).toFixed(1);
      this.frames = 0;
      this.framesSince = now;
      this.updateNote();
    }
  }

  private slowFrames = 0;
  private lastDrawn = 0;

  // where the processor draws, a smaller picture keeps it fluid
  private watchSpeed(now: number): void {
    const period = now - this.lastDrawn;
    this.lastDrawn = now;
    if (period > kSlowPeriod && period < 1000) {
      ++this.slowFrames;
    } else {
      this.slowFrames = Math.max(0, this.slowFrames - 2);
    }
    if (this.slowFrames > kMaxSlowPictures) {
      this.slowFrames = 0;
      this.view.reduce();
    }
  }

  private updateNote(): void {
    const parts: string[] = [];
    if (this.view.isSoftware) {
      parts.push(
        this.view.isReduced
          ? "Drawn by the processor: no shadows, fewer pixels"
          : "Drawn by the processor: no shadows",
      );
    }
    const { merged, points } = this.view.counts;
    if (points > 0) {
      parts.push(`${plural(points, "robot")} as points`);
    } else if (merged > 0) {
      parts.push(`${plural(merged, "entity").replace("entitys", "entities")} far away in simple form`);
    }
    if (this.session?.note != null) {
      parts.push(this.session.note);
    }
    this.note.hidden = parts.length === 0;
    setText(this.note, parts.join(" · "));
  }

  private timeOf(tick: number): number {
    return tick * (this.session?.info?.tickLength ?? 0.1);
  }

  private seekTime(): ((time: number) => void) | null {
    const { session } = this;
    if (session === null || session.abilities.seek !== null) {
      return null;
    }
    return (time) => session.seek(time / (session.info?.tickLength ?? 0.1));
  }

  private collectMetrics(frame: Frame, time: number): void {
    this.metricHint.hidden = frame.metrics.length > 0;
    for (const metric of frame.metrics) {
      let plot = this.metricPlots.get(metric.name);
      if (plot === undefined) {
        plot = new Plot(
          metric.name,
          metric.unit,
          new Series(),
          this.seekTime(),
          this.metricPlots.size,
        );
        this.metricPlots.set(metric.name, plot);
        this.metricArea.append(plot.element);
      }
      plot.series.add(time, metric.value);
    }
  }

  private selectedId(): string | null {
    const { pinned } = this.inspector;
    return pinned[pinned.length - 1] ?? null;
  }

  private picked(entity: number, withShift: boolean): void {
    if (this.addType !== null) {
      return;
    }
    const id = this.view.entity(entity)?.id ?? null;
    if (id === null && withShift) {
      return;
    }
    if (id !== null && withShift && this.inspector.pinned.includes(id)) {
      this.inspector.unpin(id);
    } else {
      this.inspector.select(id, withShift);
    }
    if (id !== null) {
      this.showTab("inspect");
    }
  }

  private selectionChanged(ids: string[]): void {
    this.mapSelection();
    if (ids.length > 0) {
      this.scan(false);
    }
    this.drive.setRobot(ids[ids.length - 1] ?? null);
    this.session?.setPinned(ids);
    this.session?.select(ids[ids.length - 1] ?? null);
    if (this.frame !== null) {
      this.inspector.update(this.frame, this.timeOf(this.frame.tick));
    }
    if (this.followId !== null && !ids.includes(this.followId)) {
      this.stopFollowing();
    }
    this.updateModes();
    for (const id of [...this.perceptions.keys()].filter((id) => !ids.includes(id))) {
      this.perceptions.delete(id);
    }
    this.updateDevices();
    this.script.update();
    if (this.session !== null) {
      this.updateLiveTools(this.session);
    }
  }

  private followId: string | null = null;

  // numbers of entities change when others are removed
  private mapSelection(): void {
    this.view.selected = this.inspector.pinned
      .map((id) => this.view.find(id))
      .filter((number) => number >= 0);
    this.view.followed = this.followId === null ? -1 : this.view.find(this.followId);
    if (this.followId !== null && this.view.followed < 0) {
      this.stopFollowing();
    }
    this.updateDevices();
  }

  private follow(id: string | null, mode: "orbit" | "eyes"): void {
    if (id === null) {
      this.notify("Select a robot first: click it", "info");
      return;
    }
    if (this.isFollowed(id, mode)) {
      this.stopFollowing();
      return;
    }
    this.followId = id;
    if (mode === "eyes") {
      this.view.camera.mode = "eyes";
    } else {
      if (this.view.camera.mode === "eyes") {
        this.view.camera.mode = "orbit";
      }
      const { arenaBox, camera } = this.view;
      const size = Math.max(arenaBox.max[0] - arenaBox.min[0], arenaBox.max[1] - arenaBox.min[1]);
      const near = 20 * this.view.radiusOf(this.view.find(id));
      camera.distance = Math.min(camera.distance, Math.max(near, 0.1 * size));
    }
    this.mapSelection();
    this.updateModes();
    this.inspectorUpdate();
  }

  private isFollowed(id: string, mode: "orbit" | "eyes"): boolean {
    return this.followId === id && (this.view.camera.mode === "eyes") === (mode === "eyes");
  }

  private stopFollowing(): void {
    this.followId = null;
    this.view.followed = -1;
    if (this.view.camera.mode === "eyes") {
      this.view.camera.mode = "orbit";
    }
    this.updateModes();
    this.inspectorUpdate();
  }

  private inspectorUpdate(): void {
    if (this.frame !== null) {
      this.inspector.update(this.frame, this.timeOf(this.frame.tick));
    }
  }

  private setMode(mode: CameraMode): void {
    if (mode === "eyes") {
      this.follow(this.selectedId(), "eyes");
      return;
    }
    const isEyes = this.view.camera.mode === "eyes";
    this.view.camera.mode = mode;
    if (isEyes) {
      this.followId = null;
      this.view.followed = -1;
    }
    this.view.camera.azimuth = -Math.PI / 2;
    this.view.camera.frameHome();
    this.updateModes();
    this.inspectorUpdate();
  }

  private updateModes(): void {
    const id = this.selectedId();
    const { mode } = this.view.camera;
    const pressed: Record<string, boolean> = {
      orbit: mode === "orbit",
      top: mode === "top",
      follow: this.followId !== null && mode !== "eyes",
      eyes: mode === "eyes",
    };
    for (const [name, element] of this.modeButtons) {
      element.setAttribute("aria-pressed", String(pressed[name] ?? false));
      if (name === "follow" || name === "eyes") {
        setEnabled(element, id === null ? "Select a robot first: click it" : null);
      }
    }
  }

  private setOption(name: keyof ViewOptions, value: boolean): void {
    this.view.options[name] = value;
    this.optionBoxes.get(name)!.checked = value;
    this.view.optionsChanged();
    this.updateDevices();
  }

  private canDrag(entity: number): boolean {
    const id = this.view.entity(entity)?.id;
    return (
      this.addType === null &&
      this.session?.abilities.move === null &&
      id !== undefined &&
      this.inspector.pinned.includes(id)
    );
  }

  private lastMove = 0;

  private dragged(entity: number, place: readonly [number, number, number], isDone: boolean): void {
    const id = this.view.entity(entity)?.id;
    const now = performance.now();
    if (id === undefined || (!isDone && now - this.lastMove < 60)) {
      return;
    }
    this.lastMove = now;
    this.session?.move(id, place, yawOf(this.view.poseOf(entity).orientation));
  }

  private turned(entity: number, yaw: number, isDone: boolean): void {
    const id = this.view.entity(entity)?.id;
    const now = performance.now();
    if (id !== undefined && (isDone || now - this.lastMove >= 60)) {
      this.lastMove = now;
      this.turnTo(id, yaw);
    }
  }

  private turnTo(id: string, yaw: number): void {
    const number = this.view.find(id);
    if (number >= 0) {
      this.session?.move(id, this.view.poseOf(number).position, yaw);
    }
  }

  private turnSelected(degrees: number): void {
    const id = this.selectedId();
    const reason = this.session?.abilities.move ?? null;
    if (id === null || reason !== null || this.view.find(id) < 0) {
      this.notify(reason ?? "Select a robot first: click it", "info");
      return;
    }
    const yaw = yawOf(this.view.poseOf(this.view.find(id)).orientation);
    this.turnTo(id, yaw + (degrees * Math.PI) / 180);
  }

  private updateBanner(session: Session): void {
    const isLost = session.connection === "lost";
    this.banner.hidden = !isLost;
    setText(this.banner, isLost ? "The connection to the run is lost. Trying again …" : "");
  }

  private peopleKey = "";

  private updatePeople(session: Session): void {
    const key = JSON.stringify([session.viewers, session.viewer, session.control, session.connection]);
    if (key === this.peopleKey) {
      return;
    }
    this.peopleKey = key;
    if (session.kind !== "live" || session.connection !== "connected") {
      this.people.replaceChildren();
      return;
    }
    const hasControl = session.control === session.viewer;
    const others = session.viewers.filter((viewer) => viewer.id !== session.viewer);
    const children: HTMLElement[] = [];
    if (others.length > 0 || !hasControl) {
      children.push(h("span", { class: "count" }, plural(session.viewers.length, "viewer")));
    }
    if (session.isOnlyWatched) {
      children.push(h("span", { class: "tag", title: "No viewer has control of this run" }, "watch only"));
    } else if (!hasControl) {
      children.push(
        button({
          icon: "hand",
          text: "Ask for control",
          title: "Another viewer has control. Ask for it",
          onClick: () => session.askControl(),
        }),
      );
    } else if (others.length > 0) {
      const list = h(
        "div",
        {},
        ...others.map((viewer) =>
          button({
            text: `Hand control to ${viewer.name === "" ? `viewer ${viewer.id}` : viewer.name}${viewer.asks === true ? ", who asks" : ""}`,
            onClick: () => session.giveControl(viewer.id),
          }),
        ),
      );
      children.push(menu(button({ icon: "hand", text: "Control", title: "You have control", onClick: () => undefined }), list));
    }
    this.people.replaceChildren(...children);
  }

  private readonly driveButton = button({
    icon: "key",
    text: "Drive",
    title: "Drive the selected robot by W, A, S and D",
    pressed: false,
    onClick: () => {
      this.drive.isOn = !this.drive.isOn;
      this.driveButton.setAttribute("aria-pressed", String(this.drive.isOn));
      if (this.drive.isOn) {
        this.notify(`W, A, S and D drive ${this.selectedId() ?? "it"} until Drive is switched off`, "info");
      }
    },
  });
  private readonly addButton = button({
    icon: "plus",
    text: "Add",
    title: "Add a robot or a thing",
    onClick: () => undefined,
  });

  private updateLiveTools(session: Session): void {
    if (session.kind !== "live") {
      return;
    }
    const needsSelection = this.selectedId() === null ? "Select a robot first: click it" : null;
    setEnabled(this.driveButton, session.abilities.drive ?? needsSelection);
    this.driveButton.hidden = session.abilities.drive === "This run does not take it";
    const noTypes = session.typesToAdd.length === 0 ? "This run has nothing that can be added" : null;
    setEnabled(this.addButton, session.abilities.move ?? noTypes);
    const key = session.typesToAdd.join();
    if (this.addMenu.dataset.key !== key) {
      this.addMenu.dataset.key = key;
      this.addMenu.replaceChildren(
        ...session.typesToAdd.map((type) =>
          button({
            text: type,
            title: `Add a ${type} in the middle of the picture`,
            onClick: () => void this.addEntity(type),
          }),
        ),
      );
    }
  }

  private addedId: string | null = null; // is selected when a state contains it

  // Adds an entity in the middle of the picture or, where that is occupied, near it.
  private async addEntity(type: string): Promise<void> {
    document.dispatchEvent(new CustomEvent("closemenus"));
    const { clientWidth, clientHeight } = this.canvas;
    const place = this.view.camera.groundPoint(clientWidth / 2, clientHeight / 2);
    if (place === null) {
      this.notify("There is no ground in the middle of the picture", "error");
      return;
    }
    let problem: string | null = null;
    for (const position of placesAround(place, kAddStep * this.view.camera.distance)) {
      const { entity, error } = (await this.session?.request("add", { type, position, yaw: 0 })) ?? {};
      if (entity !== undefined) {
        this.addedId = entity;
        this.selectAdded();
        return;
      }
      problem ??= error ?? null;
      if (error === undefined || !/overlap|outside/.test(error)) {
        break;
      }
    }
    if (problem !== null) {
      this.notify(problem, "error");
    }
  }

  private selectAdded(): void {
    if (this.addedId !== null && this.view.find(this.addedId) >= 0) {
      this.inspector.select(this.addedId);
      this.addedId = null;
    }
  }

  private keyDown(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    const isTyping =
      (target instanceof HTMLInputElement && target.type !== "range" && target.type !== "checkbox") ||
      target instanceof HTMLSelectElement ||
      target instanceof HTMLTextAreaElement ||
      target.isContentEditable;
    if (isTyping || this.help.open) {
      return;
    }
    const isOfPage = !isCommand(modifiersOf(event));
    if (isOfPage && this.drive.isOn && this.drive.key(event.key, true)) {
      event.preventDefault();
      return;
    }
    if (target === this.canvas && this.userKeys.press(event)) {
      if (!kKeysOfBrowsers.test(event.key)) {
        event.preventDefault();
      }
      return;
    }
    if (isOfPage && this.runKey(event.key, target)) {
      event.preventDefault();
    }
  }

  private keyUp(event: KeyboardEvent): void {
    // wherever the focus is now
    if (!this.userKeys.release(event) && this.drive.isOn) {
      this.drive.key(event.key, false);
    }
  }

  /** Returns false if the key means nothing. */
  private runKey(key: string, target: HTMLElement): boolean {
    const { session } = this;
    const isControl = target instanceof HTMLButtonElement || target instanceof HTMLInputElement;
    const option = kOptionNames.find(([, , letter]) => letter === key.toUpperCase());
    if (option !== undefined) {
      this.setOption(option[0], !this.view.options[option[0]]);
      return true;
    }
    switch (key) {
      case " ":
        if (isControl && target instanceof HTMLButtonElement) {
          return false; // it presses the button
        }
        this.transport.togglePlay();
        return true;
      case "ArrowRight":
      case "ArrowLeft":
        if (isControl && target instanceof HTMLInputElement) {
          return false; // it moves the slider
        }
        this.stepBy(key === "ArrowRight" ? 1 : -1);
        return true;
      case "Home":
      case "End":
        if (session !== null && session.abilities.seek === null) {
          session.seek(key === "Home" ? session.firstTick : session.lastTick);
        }
        if (key === "End") {
          session?.toLive();
        }
        return true;
      case "[":
      case "]":
        this.turnSelected(key === "[" ? 15 : -15);
        return true;
      case "+":
      case "=":
        this.transport.changeSpeed(1);
        return true;
      case "-":
        this.transport.changeSpeed(-1);
        return true;
      case "t":
        this.setMode("top");
        return true;
      case "o":
        this.setMode("orbit");
        return true;
      case "f":
        this.follow(this.selectedId(), "orbit");
        return true;
      case "e":
        this.follow(this.selectedId(), "eyes");
        return true;
      case "?":
        this.help.showModal();
        return true;
      case "Escape":
        if (this.root.querySelector(".menu:not([hidden])") !== null) {
          document.dispatchEvent(new CustomEvent("closemenus"));
        } else {
          this.inspector.select(null);
        }
        return true;
      default:
        return false;
    }
  }

  private stepBy(count: 1 | -1): void {
    const abilities = this.session?.abilities;
    if (abilities !== undefined && (count > 0 ? abilities.step : abilities.stepBack) === null) {
      this.session?.step(count);
    }
  }

  private makeLayout(): HTMLElement {
    this.welcome.append(
      h("div", { class: "logo" }, icon("view")),
      h("h2", {}, "Open a recording"),
      h(
        "p",
        {},
        "Drop a file here, or choose one. Recordings are made by ",
        h("code", {}, "argos3 -c experiment.argos --record run.rec"),
      ),
      button({
        icon: "open",
        text: "Choose a file",
        className: "primary",
        onClick: () => this.fileInput.click(),
      }),
    );
    const stage = h(
      "section",
      { class: "stage", "aria-label": "Picture" },
      this.canvas,
      this.labelCanvas,
      this.makeTools(),
      this.note,
      this.welcome,
      this.toasts,
    );
    return h(
      "div",
      { class: "page" },
      this.makeHeader(),
      this.banner,
      h("main", {}, stage, this.makePanel()),
      this.transport.element,
    );
  }

  private makeHeader(): HTMLElement {
    return h(
      "header",
      { class: "top" },
      this.title,
      this.stateChip,
      this.factor,
      h("div", { class: "space" }),
      this.people,
      this.filmButton,
      button({
        icon: "open",
        text: "Open",
        title: "Open a recording",
        className: "quiet",
        onClick: () => this.fileInput.click(),
      }),
      this.makeSaveMenu(),
      this.themeButton,
      button({
        icon: "help",
        title: "Keys and mouse",
        key: "?",
        className: "quiet",
        onClick: () => this.help.showModal(),
      }),
    );
  }

  private makeTools(): HTMLElement {
    const mode = (
      name: string,
      options: { icon: Parameters<typeof icon>[0]; text: string; title: string; key: string },
      onClick: () => void,
    ): HTMLButtonElement => {
      const element = button({ ...options, pressed: name === "orbit", onClick });
      this.modeButtons.set(name, element);
      return element;
    };
    const modes = h(
      "div",
      { class: "tools", role: "group", "aria-label": "Camera" },
      mode("orbit", { icon: "view", text: "Side", title: "From the side, the whole arena", key: "O" }, () =>
        this.setMode("orbit"),
      ),
      mode("top", { icon: "fit", text: "Top", title: "From above, the whole arena", key: "T" }, () =>
        this.setMode("top"),
      ),
      mode("follow", { icon: "follow", text: "Follow", title: "Follow the selected robot", key: "F" }, () =>
        this.follow(this.selectedId(), "orbit"),
      ),
      mode("eyes", { icon: "eye", text: "Its view", title: "Look ahead from the selected robot", key: "E" }, () =>
        this.follow(this.selectedId(), "eyes"),
      ),
    );
    for (const name of ["follow", "eyes"]) {
      setEnabled(this.modeButtons.get(name)!, "Select a robot first: click it");
    }
    const boxes = kOptionNames.map(([name, text, key]) => {
      const box = h("input", {
        type: "checkbox",
        checked: kDefaultOptions[name],
        onchange: () => this.setOption(name, box.checked),
      });
      this.optionBoxes.set(name, box);
      return h("label", {}, box, h("span", {}, text), h("kbd", {}, key));
    });
    const show = menu(
      button({ icon: "layers", text: "Show", title: "What the picture shows", onClick: () => undefined }),
      h("div", { role: "group", "aria-label": "What the picture shows" }, ...boxes),
    );
    this.liveTools.append(menu(this.addButton, this.addMenu), this.driveButton);
    return h(
      "div",
      { class: "tool-area" },
      modes,
      h("div", { class: "tools" }, show),
      this.liveTools,
    );
  }

  private makePanel(): HTMLElement {
    this.metricHint.textContent =
      "This run has no metrics. Loop functions and robots record them, in C++ by GetMetrics().Record(), in Lua by metrics.record().";
    const panels: [TabName, string, HTMLElement][] = [
      ["inspect", "Inspect", this.inspector.element],
      ["metrics", "Metrics", h("div", {}, this.metricHint, this.metricArea)],
      ["script", "Script", this.script.element],
      ["log", "Log", this.log.element],
      ["info", "About", this.infoList],
    ];
    const bar = h("div", { class: "tab-bar", role: "tablist", "aria-label": "Panels" });
    const aside = h("aside", { class: "panel", "aria-label": "Panels" }, bar);
    for (const [name, text, content] of panels) {
      const panel = h("div", { class: "tab-panel", role: "tabpanel", id: `panel-${name}` }, content);
      const tab = h(
        "button",
        {
          type: "button",
          role: "tab",
          id: `tab-${name}`,
          "aria-controls": `panel-${name}`,
          onclick: () => this.showTab(name),
          onkeydown: (event: KeyboardEvent) => this.tabKey(event),
        },
        text,
      );
      panel.setAttribute("aria-labelledby", `tab-${name}`);
      bar.append(tab);
      aside.append(panel);
      this.tabs.set(name, { tab, panel });
    }
    return aside;
  }

  private tabKey(event: KeyboardEvent): void {
    const names = [...this.tabs.keys()];
    const move = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (move !== 0) {
      event.stopPropagation();
      event.preventDefault();
      const next = names[(names.indexOf(this.tab) + move + names.length) % names.length]!;
      this.showTab(next);
      this.tabs.get(next)!.tab.focus();
    }
  }

  private showTab(name: TabName): void {
    this.tab = name;
    for (const [other, { tab, panel }] of this.tabs) {
      tab.setAttribute("aria-selected", String(other === name));
      tab.tabIndex = other === name ? 0 : -1;
      panel.hidden = other !== name;
    }
    this.script.show(name === "script");
    this.root.classList.toggle("has-editor", name === "script");
    this.updateMetricPlots();
  }

  private makeHelp(): HTMLDialogElement {
    const dialog = h(
      "dialog",
      { class: "help", "aria-label": "Keys and mouse" },
      h("h2", {}, "Keys and mouse"),
      h("dl", {}, ...kKeys.flatMap(([key, text]) => [h("dt", {}, h("kbd", {}, key)), h("dd", {}, text)])),
      h("form", { method: "dialog" }, h("button", { class: "primary" }, "Close")),
    );
    dialog.addEventListener("click", (event) => {
      if (event.target === dialog) {
        dialog.close();
      }
    });
    return dialog;
  }

  private listenToDrops(): void {
    document.addEventListener("dragover", (event) => {
      event.preventDefault();
      this.root.classList.add("is-dropping");
    });
    document.addEventListener("dragleave", (event) => {
      if (event.relatedTarget === null) {
        this.root.classList.remove("is-dropping");
      }
    });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      this.root.classList.remove("is-dropping");
      const file = event.dataTransfer?.files[0];
      if (file !== undefined) {
        void this.openFile(file);
      }
    });
  }

  private readonly filmButton = button({
    icon: "stop",
    text: "Stop the film",
    title: "Save the film as a file",
    className: "danger",
    onClick: () => {
      this.film.stop();
      this.filmButton.hidden = true;
    },
  });

  private makeSaveMenu(): HTMLElement {
    this.filmButton.hidden = true;
    const item = (text: string, title: string, onClick: () => void): HTMLElement =>
      button({
        text,
        title,
        onClick: () => {
          document.dispatchEvent(new CustomEvent("closemenus"));
          if (this.frame === null) {
            this.notify("There is nothing to save yet", "error");
          } else {
            onClick();
          }
        },
      });
    const items = h(
      "div",
      {},
      item("Picture", "Save the picture, PNG", () => void this.savePicture()),
      item("Film", "Make a film of the picture from now on, WebM", () => this.startFilm()),
      item("Recording", "Save what this page has received, for argos3 --replay", () => void this.saveRecording()),
      item("Page", "Save this page with the recording in it, HTML: it opens without a server", () => void this.savePage()),
      item("Experiment", "Save the experiment with everything where it is now", () => this.saveWorld()),
    );
    const opener = button({
      icon: "camera",
      text: "Save",
      title: "Save a picture, a film, the recording, a page, the experiment",
      className: "quiet",
      onClick: () => undefined,
    });
    return menu(opener, items);
  }

  private baseName(): string {
    return (this.title.textContent ?? "").replace(/\.argos$/, "");
  }

  private clockText(): string {
    return this.view.options.clock && this.session !== null ? formatTime(this.timeOf(this.session.position)) : "";
  }

  private async savePicture(): Promise<void> {
    const picture = this.view.capture(true, this.clockText());
    const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, "image/png"));
    if (blob === null) {
      this.notify("The browser cannot write the picture", "error");
      return;
    }
    download([blob], "image/png", `${this.baseName()}_${this.frame!.tick}.png`);
  }

  private startFilm(): void {
    const problem = this.film.start(
      this.view.sizeOnScreen,
      () => this.baseName(),
      (text) => this.notify(text, "info"),
    );
    if (problem !== null) {
      this.notify(problem, "error");
    }
    this.filmButton.hidden = problem !== null;
    this.view.optionsChanged(); // draws the first picture
  }

  private async recordingBytes(): Promise<Uint8Array<ArrayBuffer> | null> {
    const bytes = (await this.session?.saveRecording()) ?? null;
    if (bytes === null) {
      this.notify("There is nothing to save yet; a replay is a file already", "error");
    }
    return bytes as Uint8Array<ArrayBuffer> | null;
  }

  private async saveRecording(): Promise<void> {
    const bytes = await this.recordingBytes();
    if (bytes !== null) {
      download([bytes], "application/octet-stream", `${this.baseName()}.rec`);
    }
  }

  private async savePage(): Promise<void> {
    const bytes = await this.recordingBytes();
    if (bytes !== null) {
      download([makePage(bytes, document.title)], "text/html", `${this.baseName()}.html`);
    }
  }

  private saveWorld(): void {
    const { frame } = this;
    const info = this.session?.info ?? null;
    if (frame === null || info === null) {
      return;
    }
    try {
      const { text, missing } = makeWorld(info, frame);
      download([text], "application/xml", `${this.baseName()}_${frame.tick}.argos`);
      if (missing.length > 0) {
        this.notify(`Without what the experiment's code has made: ${missing.slice(0, 5).join(", ")}`, "info");
      }
    } catch (error) {
      this.notify(`The experiment cannot be saved: ${(error as Error).message}`, "error");
    }
  }

  private nextTheme(): void {
    this.theme = this.isDark() ? "light" : "dark";
    store("theme", this.theme);
    this.applyTheme();
  }

  private isDark(): boolean {
    return (
      this.theme === "dark" ||
      (this.theme === "auto" && window.matchMedia("(prefers-color-scheme: dark)").matches)
    );
  }

  private applyTheme(): void {
    const isDark = this.isDark();
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    this.view.setLook(isDark ? kDarkLook : kLightLook);
    this.inspector.restyle();
    this.metricPlots.forEach((plot) => plot.restyle());
    if (this.frame !== null) {
      this.inspectorUpdate();
      this.showTab(this.tab);
    }
  }
}
