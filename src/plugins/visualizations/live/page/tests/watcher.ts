// A viewer without a page: takes states as the page does, and notes when each came.

import { WebSocket } from "ws";

import { prepareUnpacking } from "../src/decode/blocks";
import { StreamDecoder } from "../src/decode/stream";

export class Watcher {
  /** When states came, ms, and their ticks. */
  readonly arrivals: { at: number; tick: number }[] = [];
  private readonly decoder = new StreamDecoder();
  private readonly socket: WebSocket;
  private lastCommand = 0;

  /** @param url  the address of the page, with its token. */
  static async open(url: string, port = Number(new URL(url).port)): Promise<Watcher> {
    await prepareUnpacking();
    return new Watcher(url, port);
  }

  private constructor(url: string, port: number) {
    const address = new URL(url);
    address.port = String(port);
    this.socket = new WebSocket(`ws://${address.host}/live`, "argos-live.1", { origin: address.origin });
    this.socket.on("open", () => this.send({ hello: { token: address.hash.slice(1), name: "watcher" } }));
    this.socket.on("message", (data: Buffer, isBinary: boolean) => {
      const frame = isBinary ? this.decoder.decode(new Uint8Array(data)) : null;
      if (frame !== null) {
        this.arrivals.push({ at: performance.now(), tick: frame.tick });
        this.send({ ack: frame.tick });
      }
    });
  }

  command(name: string, more: object = {}): void {
    this.send({ id: ++this.lastCommand, do: name, ...more });
  }

  async waitForTick(tick: number): Promise<void> {
    while ((this.arrivals.at(-1)?.tick ?? -1) < tick) {
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  close(): void {
    this.socket.close();
  }

  private send(message: object): void {
    this.socket.send(JSON.stringify(message));
  }
}

/**
 * How far behind the run a viewer was at most, ticks, from when it has the first tick on: the last tick that another one
 * without delays had when this one got its next state.
 */
export function mostBehind(run: Watcher["arrivals"], viewer: Watcher["arrivals"], firstTick: number): number {
  let most = 0;
  let shown = Infinity;
  for (const { at, tick } of viewer) {
    const now = run.filter((state) => state.at <= at).at(-1)?.tick ?? 0;
    if (shown >= firstTick && shown !== Infinity) {
      most = Math.max(most, now - shown);
    }
    shown = tick;
  }
  return most;
}
