// The bar with play, pause, steps, speed and time.

import type { Session } from "../session";
import { button, h, setEnabled, setIcon, setText } from "./dom";
import { formatSpeed, formatTime } from "./format";

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50, 0];

export class Transport {
  readonly element: HTMLElement;
  private session: Session | null = null;
  private readonly play = button({
    icon: "play",
    title: "Play",
    key: "Space",
    className: "primary round",
    onClick: () => this.togglePlay(),
  });
  private readonly back = button({
    icon: "stepBack",
    title: "One state back",
    key: "←",
    onClick: () => this.session?.step(-1),
  });
  private readonly forward = button({
    icon: "stepForward",
    title: "One tick ahead",
    key: "→",
    onClick: () => this.session?.step(1),
  });
  private readonly start = button({
    icon: "toStart",
    title: "To the start",
    key: "Home",
    onClick: () => this.session?.seek(this.session.firstTick),
  });
  private readonly reset = button({
    icon: "reset",
    text: "Reset",
    title: "Reset the run, with the same seed",
    onClick: () => this.session?.reset(false),
  });
  private readonly newSeed = button({
    icon: "dice",
    text: "New seed",
    title: "Reset the run, with a new seed",
    onClick: () => this.session?.reset(true),
  });
  private readonly end = button({
    icon: "stop",
    text: "End",
    title: "End the run",
    className: "danger",
    onClick: () => this.askEnd(),
  });
  private readonly stepCount = h("input", {
    type: "number",
    min: 1,
    max: 100000,
    value: 10,
    "aria-label": "Number of ticks",
    title: "Number of ticks",
  });
  private readonly stepMany = button({
    text: "Step",
    title: "Go ahead by this number of ticks",
    onClick: () => this.session?.step(Math.max(1, Math.floor(Number(this.stepCount.value) || 1))),
  });
  private readonly speed = h(
    "select",
    { "aria-label": "Speed", onchange: () => this.session?.setSpeed(Number(this.speed.value)) },
    ...kSpeeds.map((speed) => h("option", { value: speed }, formatSpeed(speed))),
  );
  private readonly slider = h("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 1,
    value: 0,
    class: "time",
    "aria-label": "Time",
    oninput: () => this.session?.seek(Number(this.slider.value)),
  });
  private readonly live = button({
    text: "Present",
    title: "Back to the present",
    key: "End",
    className: "primary",
    onClick: () => this.session?.toLive(),
  });
  private readonly now = h("output", { class: "now", title: "Time in the experiment" });
  private readonly total = h("span", { class: "total" });
  private readonly runOnly: HTMLElement;

  constructor() {
    this.speed.dataset.title = "Speed, in times of real time (+ and −)";
    this.slider.dataset.title = "Drag to another time";
    this.runOnly = h("div", { class: "group run-only" }, this.reset, this.newSeed, this.end);
    this.element = h(
      "footer",
      { class: "transport", "aria-label": "Time" },
      h("div", { class: "time-row" }, this.now, this.slider, this.total, this.live),
      h(
        "div",
        { class: "buttons" },
        h("div", { class: "group" }, this.start, this.back, this.play, this.forward),
        h("div", { class: "group step-many" }, this.stepCount, this.stepMany),
        h("label", { class: "group speed" }, h("span", {}, "Speed"), this.speed),
        this.runOnly,
      ),
    );
    this.update();
  }

  setSession(session: Session | null): void {
    this.session = session;
    this.update();
  }

  togglePlay(): void {
    const { session } = this;
    if (session === null || session.abilities.play !== null) {
      return;
    }
    if (session.isPlaying) {
      session.pause();
    } else {
      session.play();
    }
  }

  /** One faster (1) or slower (-1). */
  changeSpeed(direction: 1 | -1): void {
    const { session } = this;
    if (session === null || session.abilities.speed !== null) {
      return;
    }
    const index = kSpeeds.indexOf(session.speed);
    const next = kSpeeds[Math.min(Math.max(index + direction, 0), kSpeeds.length - 1)]!;
    session.setSpeed(next);
  }

  update(): void {
    const { session } = this;
    const none = "Open a recording first";
    const abilities = session?.abilities;
    const isPlaying = session?.isPlaying === true;
    if (this.play.dataset.state !== String(isPlaying)) {
      this.play.dataset.state = String(isPlaying);
      setIcon(this.play, isPlaying ? "pause" : "play", isPlaying ? "Pause (Space)" : "Play (Space)");
    }
    setEnabled(this.play, abilities === undefined ? none : abilities.play);
    setEnabled(this.forward, abilities === undefined ? none : abilities.step);
    setEnabled(this.stepMany, abilities === undefined ? none : abilities.step);
    setEnabled(this.back, abilities === undefined ? none : abilities.stepBack);
    setEnabled(this.start, abilities === undefined ? none : abilities.seek);
    setEnabled(this.speed, abilities === undefined ? none : abilities.speed);
    setEnabled(this.slider, abilities === undefined ? none : abilities.seek);
    setEnabled(this.reset, abilities === undefined ? none : abilities.reset);
    setEnabled(this.newSeed, abilities === undefined ? none : abilities.reset);
    setEnabled(this.end, abilities === undefined ? none : abilities.end);
    this.live.hidden = session?.isPast !== true;
    this.runOnly.hidden = session === null || session.kind === "recording";
    const tickLength = session?.info?.tickLength ?? 0.1;
    const position = session?.position ?? 0;
    this.slider.min = String(session?.firstTick ?? 0);
    this.slider.max = String(session?.lastTick ?? 1);
    if (document.activeElement !== this.slider || isPlaying || session?.times === "received") {
      this.slider.value = String(Math.round(position));
    }
    const span = Math.max(1, Number(this.slider.max) - Number(this.slider.min));
    const share = (100 * (Number(this.slider.value) - Number(this.slider.min))) / span;
    this.slider.style.setProperty("--share", `${share}%`);
    this.slider.setAttribute("aria-valuetext", formatTime(position * tickLength));
    setText(this.now, session === null ? "0.0 s" : formatTime(position * tickLength));
    setText(
      this.total,
      session === null ? "" : session.times === "none"
          ? `tick ${Math.round(position)}`
          : formatTime(session.lastTick * tickLength),
    );
    const speed = String(session?.speed ?? 1);
    if (this.speed.value !== speed && document.activeElement !== this.speed) {
      this.speed.value = speed;
    }
  }

  private askEnd(): void {
    if (window.confirm("End the run? Its outputs are written, and the program ends.")) {
      this.session?.end();
    }
  }
}
