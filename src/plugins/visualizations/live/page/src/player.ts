// Plays a recording.

import type { Frame } from "./decode/frames";
import type { Recording } from "./decode/recording";
import type { Abilities, Answer, RunState, Session, SessionListener } from "./session";

const kIsRecording = "A recording can be watched, but not changed";

export class RecordingPlayer implements Session {
  readonly kind = "recording";
  readonly viewers = [];
  readonly viewer = 0;
  readonly control = 0;
  readonly connection = "none";
  readonly typesToAdd = [];
  readonly isPast = false;
  readonly isOnlyWatched = true;
  readonly times = "all";
  state: RunState = "loading";
  position: number;
  speed = 1;
  private from: number;
  private to: number;
  private lastNow = 0;
  private isReading = false;
  private wanted: number | null = null;

  constructor(
    private readonly recording: Recording,
    readonly name: string,
    private readonly listener: SessionListener,
  ) {
    this.position = this.from = this.to = recording.firstTick;
    listener.opened(recording.info);
    this.seek(recording.firstTick);
  }

  get isPlaying(): boolean {
    return this.state === "playing";
  }
  get info(): Recording["info"] {
    return this.recording.info;
  }
  get firstTick(): number {
    return this.recording.firstTick;
  }
  get lastTick(): number {
    return this.recording.lastTick;
  }
  get note(): string | null {
    const { damage } = this.recording;
    return damage === null ? null : `This recording is not whole: ${damage}.`;
  }
  get realTimeFactor(): number | null {
    return null;
  }

  get abilities(): Abilities {
    const isAtStart = this.position <= this.firstTick;
    const isAtEnd = this.position >= this.lastTick;
    return {
      play: null,
      step: isAtEnd ? "This is the last state" : null,
      stepBack: isAtStart ? "This is the first state" : null,
      seek: null,
      speed: null,
      reset: kIsRecording,
      end: kIsRecording,
      move: kIsRecording,
      drive: kIsRecording,
      edit: kIsRecording,
      tune: kIsRecording,
    };
  }

  play(): void {
    if (this.position >= this.lastTick) {
      this.seek(this.firstTick);
    }
    this.state = "playing";
    this.listener.changed();
  }

  pause(): void {
    this.state = this.position >= this.lastTick ? "ended" : "paused";
    this.listener.changed();
  }

  step(count: number): void {
    this.state = "paused";
    const { every } = this.info;
    const base = count > 0 ? Math.floor(this.position / every) : Math.ceil(this.position / every);
    this.seek((base + count) * every);
  }

  seek(tick: number): void {
    const bounded = Math.min(Math.max(Math.round(tick), this.firstTick), this.lastTick);
    this.position = bounded;
    this.wanted = bounded;
    if (this.state === "ended" && bounded < this.lastTick) {
      this.state = "paused";
    }
    void this.readWanted();
  }

  setSpeed(factor: number): void {
    this.speed = factor;
    this.listener.changed();
  }

  update(now: number): void {
    const elapsed = Math.min((now - this.lastNow) / 1000, 0.25);
    this.lastNow = now;
    if (this.state !== "playing" || this.wanted !== null) {
      return;
    }
    // as fast as it goes: a state in each picture, at least a hundred times as fast
    const factor = this.speed === 0 ? 100 : this.speed;
    this.position += (elapsed * factor) / this.info.tickLength;
    if (this.position >= this.lastTick) {
      this.position = this.lastTick;
    }
    if (this.position > this.to && !this.isReading) {
      void this.readNext();
    }
    if (this.position <= this.to) {
      const span = this.to - this.from;
      this.listener.setBlend(span > 0 ? (this.position - this.from) / span : 1);
    }
    if (this.position >= this.lastTick && this.to >= this.lastTick) {
      this.listener.setBlend(1);
      this.state = "ended";
    }
    this.listener.changed();
  }

  // the state at the position, or the next one after it
  private async readNext(): Promise<void> {
    const { every } = this.info;
    const next = Math.min(Math.ceil(this.position / every) * every, this.lastTick);
    this.isReading = true;
    try {
      const frame = await this.recording.read(next);
      if (this.wanted === null) {
        this.from = this.to;
        this.to = frame.tick;
        this.show(frame, false);
        const span = this.to - this.from;
        this.listener.setBlend(span > 0 ? (this.position - this.from) / span : 1);
      }
    } catch (error) {
      this.fail(error);
    }
    this.isReading = false;
  }

  // only the last wish is read
  private async readWanted(): Promise<void> {
    if (this.isReading) {
      return;
    }
    this.isReading = true;
    while (this.wanted !== null) {
      const wanted = this.wanted;
      try {
        const frame = await this.recording.read(wanted);
        this.from = this.to = frame.tick;
        if (this.wanted === wanted) {
          this.wanted = null;
          this.position = frame.tick;
        }
        if (this.state === "loading") {
          this.state = "paused";
        }
        this.show(frame, true);
      } catch (error) {
        this.wanted = null;
        this.fail(error);
      }
    }
    this.isReading = false;
    this.listener.changed();
  }

  private show(frame: Frame, isJump: boolean): void {
    this.listener.showFrame(frame, isJump);
  }

  private fail(error: unknown): void {
    this.state = "paused";
    this.listener.notify(`Cannot read the recording: ${(error as Error).message}`, "error");
    this.listener.changed();
  }

  close(): void {
    this.state = "ended";
  }

  saveRecording(): Promise<Uint8Array | null> {
    return this.recording.readAll();
  }
  request(): Promise<Answer> {
    return Promise.resolve({ error: kIsRecording });
  }
  toLive(): void {}
  reset(): void {}
  end(): void {}
  askControl(): void {}
  giveControl(): void {}
  setPinned(): void {}
  select(): void {}
  move(): void {}
  remove(): void {}
  drive(): void {}
  key(): null {
    return null;
  }
}
