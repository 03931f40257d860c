// Watches a run: a WebSocket with the blocks of a recording, and commands as JSON.

import { type RecordingInfo, prepareUnpacking } from "../decode/blocks";
import type { Frame } from "../decode/frames";
import { StreamDecoder } from "../decode/stream";
import { type FirstConnection, connect } from "./connect";
import { History } from "./history";
import type {
  Abilities,
  Answer,
  LogLine,
  Modifiers,
  Perception,
  RunState,
  Session,
  SessionListener,
  Tree,
  Viewer,
} from "../session";

const kFirstRetry = 500; // ms
const kLongestRetry = 8000;
const kMaxPinned = 16; // of the protocol
const kMaxReplaySpeed = 10; // speed of the past if the run goes as fast as it can
const kMoveCommands = new Set(["move", "drive"]);

interface Welcome {
  protocol?: number;
  version?: string;
  experiment?: string;
  tick_length?: number;
  last_tick?: number;
  can?: Partial<Record<"control" | "edit" | "replay" | "seek" | "change" | "drive" | "user_functions", boolean>>;
  types_to_add?: string[];
  viewer?: number;
}

interface Status {
  run?: "playing" | "paused" | "ended";
  tick?: number;
  speed?: number;
  real_time_factor?: number;
  control?: number;
  viewers?: Viewer[];
}

interface ServerMessage {
  welcome?: Welcome;
  status?: Status;
  log?: LogLine[];
  values?: { entity: string; tick: number; tree: Tree };
  perceived?: { entity: string } & Perception;
  error?: string | undefined;
  re?: number;
  ok?: boolean;
}

const kPast = "This is the past: go back to the present first (End)";

export class LiveClient implements Session {
  readonly kind = "live";
  state: RunState = "loading";
  speed = 1;
  realTimeFactor: number | null = null;
  viewers: Viewer[] = [];
  viewer = 0;
  control = -1;
  connection: Session["connection"] = "none";
  typesToAdd: string[] = [];
  note: string | null = null;
  name = "";
  private socket: WebSocket | null = null;
  private decoder = new StreamDecoder();
  private retry = kFirstRetry;
  private timer = 0;
  private isClosed = false;
  private lastCommand = 0;
  private readonly waiting = new Map<number, string>();
  private readonly requests = new Map<number, (answer: Answer) => void>();
  private readonly history = new History();
  private tick = 0; // of the last state that has come
  private past: number | null = null; // the tick that is shown instead
  private isReplaying = false; // the past moves on
  private replayPlace = 0; // ticks
  private lastUpdate = 0;
  private pinned: string[] = [];
  private selected: string | null = null;
  private isSelectionDue = false; // the server does not know it
  private isFirstFrame = true;
  private can: NonNullable<Welcome["can"]> = {};
  private wasWelcomed = false;
  private hasRunEnded = false;
  private opened = "";
  private maxTick = 0; // 0: the run has no limit
  private arrivals: number[] = [];
  private frameAt = 0;
  private period = 100; // ms from state to state, as they arrive
  private refusal: string | null = null;
  private isSeeking = false;
  private nextSeek: number | null = null;
  private readonly url: string;
  private readonly token: string;

  constructor(
    private readonly listener: SessionListener,
    first: FirstConnection,
  ) {
    this.url = first.url;
    this.token = first.token;
    this.connect(first);
  }

  get info(): RecordingInfo | null {
    return this.decoder.info;
  }

  get position(): number {
    return this.past ?? this.tick;
  }
  get isPlaying(): boolean {
    return this.isPast ? this.isReplaying : this.state === "playing";
  }
  get isPast(): boolean {
    return this.past !== null;
  }
  get times(): Session["times"] {
    return this.can.seek === true ? "all" : this.history.size > 1 ? "received" : "none";
  }
  get firstTick(): number {
    return this.times === "received" ? this.history.firstTick : 0;
  }
  get lastTick(): number {
    return this.times === "received" ? this.tick : Math.max(this.tick, this.maxTick, 1);
  }

  private get hasControl(): boolean {
    return this.control === this.viewer;
  }

  get isOnlyWatched(): boolean {
    return this.can.control === false;
  }

  get abilities(): Abilities {
    const noControl =
      this.connection !== "connected"
        ? this.hasRunEnded
          ? "The run has ended"
          : "There is no connection to the run"
        : this.hasControl
          ? null
          : this.isOnlyWatched
            ? "This run can only be watched"
            : "Another viewer has control: ask for it";
    const atEnd = noControl ?? (this.state === "ended" ? "The run has ended: reset it first" : null);
    const isReplay = this.can.change === false ? "This is a replay, which cannot be changed" : null;
    const received = this.times === "none" ? "Nothing else was received yet" : null;
    const seek = this.can.seek === true ? noControl : received;
    const isPast = this.isPast ? kPast : null;
    const noEdit =
      this.can.edit === true
        ? null
        : 'The author of this run does not allow it: <live edit="true"> in the experiment file does';
    return {
      play: this.isPast ? null : atEnd,
      step: isPast !== null ? null : atEnd,
      stepBack: this.can.seek === true || this.position > this.firstTick ? seek : "This is the first state",
      seek,
      speed: isPast ?? noControl,
      reset: noControl,
      end: noControl,
      move: isPast ?? noControl ?? isReplay,
      drive: this.can.drive === true ? (isPast ?? atEnd ?? isReplay) : "This run does not take it",
      edit: isReplay ?? noEdit ?? noControl,
      tune: isReplay ?? noControl,
    };
  }

  private connect({ socket, messages } = connect(this.url, this.token)): void {
    this.decoder = new StreamDecoder();
    this.isFirstFrame = true;
    this.wasWelcomed = false;
    this.socket = socket;
    const read = async (event: MessageEvent<string | ArrayBuffer>): Promise<void> => {
      try {
        await prepareUnpacking(); // messages stay in their order
      } catch (error) {
        this.listener.notify(`Cannot read states: ${(error as Error).message}`, "error");
        socket.close();
        return;
      }
      if (this.socket === socket) {
        this.receive(event.data);
      }
    };
    const reading = messages.map(read);
    socket.onmessage = read;
    const closed = (): void => {
      if (this.socket === socket) {
        this.lost();
      }
    };
    socket.onclose = closed;
    // a server that refuses this viewer may have done so before
    if (socket.readyState === WebSocket.CLOSED) {
      void Promise.all(reading).then(closed);
    }
  }

  private lost(): void {
    this.socket = null;
    this.waiting.clear();
    this.requests.forEach((answer) => answer({ error: "The connection to the run was lost" }));
    this.requests.clear();
    this.isSeeking = false;
    this.nextSeek = null;
    this.viewers = [];
    this.control = -1;
    this.realTimeFactor = null;
    this.connection = this.isClosed || this.hasRunEnded ? "none" : "lost";
    // a server that has refused this viewer would do so again
    if (this.connection === "lost" && this.refusal === null) {
      this.timer = window.setTimeout(() => this.connect(), this.retry);
      this.retry = Math.min(2 * this.retry, kLongestRetry);
    }
    this.listener.changed();
  }

  private receive(data: string | ArrayBuffer): void {
    try {
      if (typeof data === "string") {
        this.receiveText(JSON.parse(data) as ServerMessage);
      } else {
        this.receiveBlock(new Uint8Array(data));
      }
    } catch (error) {
      this.listener.notify(`The run has sent what this page does not understand: ${(error as Error).message}`, "error");
      this.socket?.close();
    }
  }

  private receiveBlock(bytes: Uint8Array): void {
    const before = this.decoder.info;
    const frame = this.decoder.decode(bytes);
    if (this.decoder.info !== null && this.decoder.info !== before) {
      this.name = this.decoder.info.experimentFile;
      // after a reconnection it is usually the same run
      const { experimentFile, date, seed } = this.decoder.info;
      const key = JSON.stringify([experimentFile, date, seed]);
      if (key !== this.opened) {
        this.opened = key;
        this.past = null;
        this.history.start(this.decoder.info, this.decoder.infoBlock);
        this.listener.opened(this.decoder.info);
      }
    }
    if (frame !== null) {
      this.sendText({ ack: frame.tick });
      this.tellSelection();
      this.keep(frame, bytes);
      if (this.past === null) {
        this.showFrame(frame);
      } else {
        this.tick = frame.tick;
        this.listener.changed();
      }
    }
  }

  private keep(frame: Frame, bytes: Uint8Array): void {
    // a replay is sent again whenever a viewer wants another time
    if (this.can.seek !== true) {
      this.history.add(frame.tick, bytes, this.decoder.isKey, this.decoder.floorBefore);
    }
    if (this.past !== null && (frame.tick < this.tick || this.past < this.history.firstTick)) {
      this.past = null; // it was reset, or the state is not kept any more
      this.isFirstFrame = true;
    }
  }

  private showFrame(frame: Frame): void {
    const now = performance.now();
    const isBack = frame.tick < this.tick;
    this.arrivals.push(now);
    if (this.arrivals.length > 12) {
      this.arrivals.shift();
    }
    if (this.arrivals.length > 2) {
      const span = now - this.arrivals[0]!;
      this.period = Math.min(Math.max(span / (this.arrivals.length - 1), 10), 300);
    }
    const isJump = this.isFirstFrame || isBack;
    this.isFirstFrame = false;
    this.frameAt = now;
    this.tick = frame.tick;
    this.listener.showFrame(frame, isJump);
    if (isJump) {
      this.listener.setBlend(1);
    }
    this.listener.changed();
  }

  private receiveText(message: ServerMessage): void {
    if (message.re !== undefined) {
      const what = this.waiting.get(message.re) ?? "";
      this.waiting.delete(message.re);
      const request = this.requests.get(message.re);
      if (request !== undefined) {
        this.requests.delete(message.re);
        request(message as Answer);
        return;
      }
      if (what === "seek") {
        this.isSeeking = false;
        const next = this.nextSeek;
        this.nextSeek = null;
        if (next !== null) {
          this.seek(next);
        }
      }
      if (message.error !== undefined) {
        this.listener.notify(message.error, "error");
      } else if (what === "ask_control") {
        this.listener.notify("You have asked for control", "info");
      }
      return;
    }
    if (message.error !== undefined) {
      this.closing(message.error);
    }
    if (message.welcome !== undefined) {
      this.welcomed(message.welcome);
    }
    if (message.status !== undefined) {
      this.setStatus(message.status);
    }
    if (Array.isArray(message.log)) {
      this.listener.addLog(message.log);
    }
    if (message.values !== undefined) {
      const { entity, tick, tree } = message.values;
      this.listener.values(entity, tick, tree);
    }
    if (message.perceived !== undefined) {
      this.listener.perceived(message.perceived.entity, message.perceived);
    }
  }

  // the server says why it closes the connection
  private closing(text: string): void {
    if (/^the run has (ended|failed)/.test(text)) {
      this.hasRunEnded = true;
      this.state = "ended";
    } else if (!this.wasWelcomed) {
      this.refusal = text;
    }
    const sentence = text.charAt(0).toUpperCase() + text.slice(1);
    this.listener.notify(sentence, text === "the run has ended" ? "info" : "error");
  }

  private welcomed(welcome: Welcome): void {
    this.connection = "connected";
    this.wasWelcomed = true;
    this.retry = kFirstRetry;
    this.refusal = null;
    this.viewer = welcome.viewer ?? 0;
    this.typesToAdd = welcome.types_to_add ?? [];
    this.can = welcome.can ?? {};
    this.maxTick = welcome.last_tick ?? 0;
    for (const entity of this.pinned) {
      this.command("pin", { entity });
    }
    this.listener.changed();
  }

  private setStatus(status: Status): void {
    const hadControl = this.hasControl && this.control >= 0;
    this.state = status.run ?? this.state;
    this.speed = status.speed ?? this.speed;
    this.realTimeFactor = this.state === "playing" ? (status.real_time_factor ?? null) : null;
    this.control = status.control ?? this.control;
    const asked = new Set(this.viewers.filter(({ asks }) => asks).map(({ id }) => id));
    this.viewers = status.viewers ?? this.viewers;
    for (const { id, name, asks } of this.viewers) {
      if (asks === true && !asked.has(id) && this.hasControl) {
        this.listener.notify(`${name === "" ? `Viewer ${id}` : name} asks for control`, "info");
      }
    }
    if (!hadControl && this.hasControl) {
      this.isSelectionDue = true;
      if (this.viewers.length > 1) {
        this.listener.notify("You have control of the run", "info");
      }
    }
    this.tellSelection();
    this.listener.changed();
  }

  private sendText(message: object): void {
    if (this.socket?.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify(message));
    }
  }

  request(name: string, more: object): Promise<Answer> {
    if (this.connection !== "connected") {
      return Promise.resolve({ error: "There is no connection to the run" });
    }
    const id = ++this.lastCommand;
    this.sendText({ id, do: name, ...more });
    return new Promise((resolve) => this.requests.set(id, resolve));
  }

  saveRecording(): Promise<Uint8Array | null> {
    return Promise.resolve(this.history.toRecording());
  }

  private command(name: string, more: object = {}): void {
    const id = ++this.lastCommand;
    if (!kMoveCommands.has(name) || this.waiting.size < 8) {
      this.waiting.set(id, name);
    }
    this.sendText({ id, do: name, ...more });
  }

  play(): void {
    if (this.past !== null) {
      this.isReplaying = true;
      this.replayPlace = this.past;
      this.listener.changed();
    } else {
      this.command("play");
    }
  }
  pause(): void {
    if (this.past !== null) {
      this.isReplaying = false;
      this.listener.changed();
    } else {
      this.command("pause");
    }
  }
  step(count: number): void {
    this.isReplaying = false;
    if (this.times === "received" && (count < 0 || this.isPast)) {
      this.showPast(this.history.neighbour(this.position, count));
    } else if (count < 0) {
      this.seek(this.position + count);
    } else {
      this.command("step", { n: count });
    }
  }
  // Shows a state that was received before; the run goes on meanwhile.
  private showPast(tick: number): void {
    this.replayPlace = tick;
    const frame = tick >= this.tick ? null : this.history.read(tick);
    if (frame === null) {
      this.toLive();
      return;
    }
    this.past = frame.tick;
    this.listener.showFrame(frame, true);
    this.listener.setBlend(1);
    this.listener.changed();
  }

  toLive(): void {
    const { frame } = this.decoder;
    if (this.past !== null && frame !== null) {
      this.past = null;
      this.listener.showFrame(frame, true);
      this.listener.setBlend(1);
    }
    this.isReplaying = false;
    this.listener.changed();
  }

  seek(tick: number): void {
    if (this.times === "received") {
      this.showPast(tick);
    } else if (!this.isSeeking) {
      this.isSeeking = true;
      this.command("seek", { tick: Math.max(0, Math.round(tick)) });
    } else {
      this.nextSeek = tick; // if this happens several times before the answer, the last tick counts
    }
  }
  setSpeed(factor: number): void {
    this.speed = factor;
    this.command("speed", { factor });
  }
  reset(newSeed: boolean): void {
    const seed = 1 + Math.floor(Math.random() * 0x7ffffffe);
    this.command("reset", newSeed ? { seed } : {});
  }
  end(): void {
    this.command("end");
  }
  askControl(): void {
    this.command("ask_control");
  }
  giveControl(viewer: number): void {
    this.command("give_control", { viewer });
  }

  setPinned(ids: string[]): void {
    for (const entity of this.pinned) {
      if (!ids.includes(entity)) {
        this.command("unpin", { entity });
      }
    }
    for (const entity of ids.slice(-kMaxPinned)) {
      if (!this.pinned.includes(entity)) {
        this.command("pin", { entity });
      }
    }
    this.pinned = [...ids];
  }

  select(id: string | null): void {
    this.selected = id;
    if (this.hasControl && this.can.user_functions === true) {
      this.command("user_select", id === null ? {} : { entity: id });
    }
  }
  // what was selected without control, or before the connection was lost, counts from now on
  private tellSelection(): void {
    const entities = this.decoder.frame?.entities ?? [];
    if (!this.isSelectionDue || !this.hasControl || entities.length === 0) {
      return;
    }
    this.isSelectionDue = false;
    if (entities.some(({ id }) => id === this.selected)) {
      this.select(this.selected);
    }
  }
  move(entity: string, position: readonly [number, number, number], yaw: number): void {
    this.command("move", { entity, position, yaw });
  }
  remove(entity: string): void {
    this.command("remove", { entity });
  }
  drive(entity: string, speeds: [number, number] | null): void {
    this.command("drive", speeds === null ? { entity } : { entity, left: speeds[0], right: speeds[1] });
  }
  key(key: string, isDown: boolean, modifiers: Modifiers): Promise<boolean> | null {
    const hasFunctions = this.connection === "connected" && this.hasControl && this.can.user_functions === true;
    // User functions see only the present, so in the past keys are released, but not pressed.
    if (!hasFunctions || (isDown && this.isPast)) {
      return null;
    }
    const held = Object.fromEntries(Object.entries(modifiers).filter(([, isHeld]) => isHeld));
    return this.request("user_key", { key, down: isDown, ...held }).then(({ handled, error }) => {
      if (error !== undefined) {
        this.listener.notify(error, "error");
      }
      return handled === true || error !== undefined;
    });
  }

  update(now: number): void {
    const elapsed = Math.min((now - this.lastUpdate) / 1000, 0.25);
    this.lastUpdate = now;
    if (this.past !== null && this.isReplaying) {
      this.replayPlace += (elapsed * (this.speed === 0 ? kMaxReplaySpeed : this.speed)) / (this.info?.tickLength ?? 0.1);
      if (this.history.tickAt(this.replayPlace) !== this.past) {
        this.showPast(this.replayPlace);
      }
    }
    if (this.frameAt > 0 && this.past === null) {
      this.listener.setBlend((now - this.frameAt) / this.period);
    }
  }

  close(): void {
    this.isClosed = true;
    window.clearTimeout(this.timer);
    this.socket?.close();
  }
}
