// What is shown, whether a recording or a run: states come from it, commands go to it.

import type { RecordingInfo } from "./decode/blocks";
import type { Frame } from "./decode/frames";

export type RunState = "loading" | "playing" | "paused" | "ended";

/** A command that cannot be given has the reason. */
export interface Abilities {
  play: string | null;
  step: string | null;
  stepBack: string | null;
  seek: string | null;
  speed: string | null;
  reset: string | null;
  end: string | null;
  move: string | null;
  drive: string | null;
  /** Scripts of robots. */
  edit: string | null;
  /** Parameters that the run declares. */
  tune: string | null;
}

export interface LogLine {
  level: "info" | "warning" | "error" | "debug";
  text: string;
  tick: number | null;
}

export type Tree = { [name: string]: Tree | number | string | boolean | null | TreeList };
export type TreeList = (Tree | number | string | boolean | null)[];

/** A thing that a sensor of a robot has perceived, in the robot's frame: m and rad. */
export interface Mark {
  kind: "blob" | "message";
  sensor: string;
  range: number;
  bearing: number;
  elevation: number;
  color?: [number, number, number];
}

/** What a robot perceives at a tick. */
export interface Perception {
  tick: number;
  marks: Mark[];
  /** Readings of a foot-bot's ring of light sensors; null: it has none. */
  light: Tree | null;
}

export interface Parameter {
  name: string;
  value: number;
  min: number;
  max: number;
  unit: string;
}

/** Keys that are down with another one, after it was pressed or released. */
export interface Modifiers {
  shift: boolean;
  control: boolean;
  alt: boolean;
  meta: boolean;
}

/** What the run answers to a request. */
export interface Answer {
  error?: string;
  line?: number;
  /** User functions have used the key. */
  handled?: boolean;
  file?: string;
  text?: string;
  robots?: number;
  failed?: number;
  changed?: boolean;
  parameters?: Parameter[];
  /** Id of what was added. */
  entity?: string;
}

export interface Viewer {
  id: number;
  name: string;
  /** Has asked for control. */
  asks?: boolean;
}

/** What a session calls. */
export interface SessionListener {
  opened(info: RecordingInfo): void;
  /** A state; a jump has no movement to it. */
  showFrame(frame: Frame, isJump: boolean): void;
  setBlend(blend: number): void;
  changed(): void;
  addLog(lines: LogLine[]): void;
  values(entity: string, tick: number, tree: Tree): void;
  /** Comes before the state of its tick. */
  perceived(entity: string, perception: Perception): void;
  notify(text: string, kind: "info" | "error"): void;
}

export interface Session {
  readonly kind: "recording" | "live";
  readonly name: string;
  readonly info: RecordingInfo | null;
  readonly state: RunState;
  /** What is shown moves on: the run, the recording, or the past of the run. */
  readonly isPlaying: boolean;
  /** The tick shown, with a fraction while it moves. */
  readonly position: number;
  readonly firstTick: number;
  readonly lastTick: number;
  /** 0: as fast as it goes. */
  readonly speed: number;
  readonly realTimeFactor: number | null;
  readonly abilities: Abilities;
  /** A note on the source, such as a recording that was cut; null: none. */
  readonly note: string | null;
  readonly viewers: Viewer[];
  readonly viewer: number;
  readonly control: number;
  /** No viewer can have control. */
  readonly isOnlyWatched: boolean;
  readonly connection: "none" | "connected" | "lost";
  readonly typesToAdd: string[];
  /** A state before the present one is shown. */
  readonly isPast: boolean;
  /** Whether other times can be shown: all of a recording, or what was received of a run. */
  readonly times: "none" | "received" | "all";

  play(): void;
  pause(): void;
  step(count: number): void;
  seek(tick: number): void;
  /** Shows the present again. */
  toLive(): void;
  /** Null: there is nothing yet. */
  saveRecording(): Promise<Uint8Array | null>;
  /** For scripts and parameters. */
  request(name: string, more: object): Promise<Answer>;
  setSpeed(factor: number): void;
  reset(newSeed: boolean): void;
  end(): void;
  askControl(): void;
  giveControl(viewer: number): void;
  setPinned(ids: string[]): void;
  select(id: string | null): void;
  move(id: string, position: readonly [number, number, number], yaw: number): void;
  remove(id: string): void;
  /** Speeds of left and right wheel, cm/s; null: those of its controller count again. */
  drive(id: string, speeds: [number, number] | null): void;
  /** Tells user functions. Resolves with whether they have used the key; null: there are none to tell. */
  key(key: string, isDown: boolean, modifiers: Modifiers): Promise<boolean> | null;
  /** Once a picture. */
  update(now: number): void;
  close(): void;
}
