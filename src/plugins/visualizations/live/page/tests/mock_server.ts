// Serves the page, and a recording as if it were a run: for tests of the page without a simulator.

import { readFileSync } from "node:fs";
import { type Server, createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { afterEach } from "node:test";

import { type WebSocket, WebSocketServer } from "ws";

import { BlockKind, kFileHeaderSize, prepareUnpacking, readBlockHeader, unpackBlock } from "../src/decode/blocks";
import { ByteReader } from "../src/decode/bytes";
import { makeBlock as makeBlockOfTicks } from "../src/decode/write";

function makeBlock(kind: BlockKind, tick: number, content: Uint8Array, floorPlace = 0): Buffer {
  return Buffer.from(makeBlockOfTicks(kind, [tick, tick], content, floorPlace));
}


interface State {
  tick: number;
  isKey: boolean;
  bytes: Uint8Array;
}

/** The parts of a recording: information, floor, and states one by one. */
function readParts(path: string): { info: Uint8Array; floor: Uint8Array | null; states: State[] } {
  const bytes = new Uint8Array(readFileSync(path));
  let info = new Uint8Array(0) as Uint8Array;
  let floor: Uint8Array | null = null;
  const states: State[] = [];
  for (let place = kFileHeaderSize; ; ) {
    const header = readBlockHeader(bytes.subarray(place, place + 44));
    if (header === null) {
      break;
    }
    const content = unpackBlock(header, bytes.subarray(place + 44, place + 44 + header.packedSize));
    if (header.kind === BlockKind.Info) {
      info = content;
    } else if (header.kind === BlockKind.Floor) {
      floor ??= content;
    } else if (header.kind === BlockKind.Frames) {
      const input = new ByteReader(content);
      while (!input.isAtEnd) {
        const before = content.length - input.left;
        const body = new ByteReader(input.readTextBytes());
        const tick = body.readNumber();
        const isKey = body.readByte() !== 0;
        states.push({ tick, isKey, bytes: content.subarray(before, content.length - input.left) });
      }
    }
    place += 44 + header.packedSize;
  }
  return { info, floor, states };
}

interface Client {
  socket: WebSocket;
  id: number;
  next: number;
  unacknowledged: number;
  pinned: Set<string>;
}

export class MockServer {
  readonly token = "0123456789abcdef0123456789abcdef";
  /** All commands, in the order in which they came. */
  commands: Record<string, unknown>[] = [];
  run: "playing" | "paused" | "ended" = "paused";
  /** Keys that user functions use; null: there are no user functions. */
  usedKeys: Set<string> | null = null;
  private readonly parts;
  private readonly clients: Client[] = [];
  private readonly http: Server;
  private readonly sockets: WebSocketServer;
  private timer: NodeJS.Timeout | null = null;
  private lastId = 0;
  private control = 0;
  private place = 0;
  private speed = 1;

  private constructor(recording: string, page: string) {
    this.parts = readParts(recording);
    this.http = createServer((request, response) => {
      const isPage = request.url === "/";
      response.writeHead(isPage ? 200 : 404, { "content-type": "text/html; charset=utf-8" });
      response.end(isPage ? readFileSync(page) : "");
    });
    this.sockets = new WebSocketServer({ server: this.http, path: "/live" });
    this.sockets.on("connection", (socket) => this.connected(socket));
  }

  private static readonly all = new Set<MockServer>();

  /** Those of tests that have failed. */
  static async closeAll(): Promise<void> {
    await Promise.all([...MockServer.all].map((server) => server.close()));
  }

  static async start(recording: string, page: string, port = 0): Promise<MockServer> {
    await prepareUnpacking();
    const server = new MockServer(recording, page);
    MockServer.all.add(server);
    await new Promise<void>((resolve) => server.http.listen(port, "127.0.0.1", resolve));
    server.timer = setInterval(() => server.tick(), 20);
    return server;
  }

  get port(): number {
    return (this.http.address() as AddressInfo).port;
  }
  get url(): string {
    return `http://127.0.0.1:${this.port}/#${this.token}`;
  }
  get tickNow(): number {
    return this.parts.states[this.place]!.tick;
  }

  async close(): Promise<void> {
    MockServer.all.delete(this);
    clearInterval(this.timer ?? undefined);
    this.clients.forEach(({ socket }) => socket.terminate());
    this.sockets.close();
    this.http.closeAllConnections();
    await new Promise((resolve) => this.http.close(resolve));
  }

  sendAll(message: object): void {
    this.clients.forEach(({ socket }) => socket.send(JSON.stringify(message)));
  }

  private connected(socket: WebSocket): void {
    const client: Client = { socket, id: ++this.lastId, next: 0, unacknowledged: 0, pinned: new Set() };
    socket.on("message", (data) => {
      const message = JSON.parse(String(data)) as Record<string, unknown>;
      if (message.hello !== undefined) {
        this.greet(client, message.hello as { token?: string });
      } else if (message.ack !== undefined) {
        --client.unacknowledged;
        this.sendStates(client);
      } else {
        this.command(client, message);
      }
    });
    socket.on("close", () => {
      const at = this.clients.indexOf(client);
      if (at >= 0) {
        this.clients.splice(at, 1);
      }
      if (this.control === client.id) {
        this.control = this.clients[0]?.id ?? 0;
      }
      this.sendStatus();
    });
  }

  private greet(client: Client, hello: { token?: string }): void {
    if (hello.token !== this.token) {
      client.socket.send(JSON.stringify({ error: "The token in the address is not the one of this run" }));
      client.socket.close();
      return;
    }
    this.clients.push(client);
    if (this.control === 0) {
      this.control = client.id;
    }
    const welcome = {
      protocol: 1,
      version: "mock",
      experiment: "mock.argos",
      tick_length: 0.1,
      can: { edit: false, replay: false, seek: false, change: true, drive: true, user_functions: this.usedKeys !== null },
      types_to_add: ["foot-bot", "box"],
      viewer: client.id,
    };
    client.socket.send(JSON.stringify({ welcome }));
    client.socket.send(makeBlock(BlockKind.Info, 0, this.parts.info));
    if (this.parts.floor !== null) {
      client.socket.send(makeBlock(BlockKind.Floor, 0, this.parts.floor));
    }
    this.sendStatus();
    this.sendStates(client);
  }

  private tick(): void {
    const last = this.parts.states.length - 1;
    if (this.run === "playing") {
      this.place = Math.min(this.place + 1, last);
      if (this.place === last) {
        this.run = "ended";
      }
      this.sendStatus();
    }
    this.clients.forEach((client) => this.sendStates(client));
  }

  // all states up to the present one: the recording's differences need each
  private sendStates(client: Client): void {
    if (client.unacknowledged >= 2 || client.next > this.place) {
      return;
    }
    const states = this.parts.states.slice(client.next, this.place + 1);
    client.next = this.place + 1;
    ++client.unacknowledged;
    const tick = states[states.length - 1]!.tick;
    const content = Buffer.concat(states.map((state) => state.bytes));
    client.socket.send(makeBlock(BlockKind.Frames, tick, content, this.parts.floor === null ? 0 : 1));
    for (const entity of client.pinned) {
      const tree = {
        components: ["body", "leds"],
        proximity: { "proximity_1": 0.25, "proximity_2": null },
        wheels: { "left (m/s)": tick, "right (m/s)": -tick },
        messages: [{ "message_range (cm)": 12 }],
      };
      client.socket.send(JSON.stringify({ values: { entity, tick, tree } }));
    }
  }

  private sendStatus(): void {
    this.sendAll({
      status: {
        run: this.run,
        tick: this.tickNow,
        speed: this.speed,
        real_time_factor: 5,
        control: this.control,
        viewers: this.clients.map(({ id }) => ({ id, name: "" })),
      },
    });
  }

  private command(client: Client, message: Record<string, unknown>): void {
    this.commands.push(message);
    const answer = (more: object): void => {
      client.socket.send(JSON.stringify({ re: message.id, ...more }));
    };
    const name = message.do as string;
    if (name === "pin" || name === "unpin") {
      client.pinned[name === "pin" ? "add" : "delete"](message.entity as string);
      answer({ ok: true });
      return;
    }
    if (name === "ask_control") {
      this.sendAll({ log: [{ level: "info", text: `viewer ${client.id} asks for control`, tick: null }] });
      answer({ ok: true });
      return;
    }
    if (client.id !== this.control) {
      answer({ error: "Another viewer has control" });
      return;
    }
    switch (name) {
      case "play":
        this.run = "playing";
        break;
      case "pause":
        this.run = "paused";
        break;
      case "step":
        this.run = "paused";
        this.place = Math.min(this.place + (message.n as number), this.parts.states.length - 1);
        break;
      case "speed":
        this.speed = message.factor as number;
        break;
      case "reset":
        this.place = 0;
        this.run = "paused";
        this.clients.forEach((other) => (other.next = 0));
        break;
      case "give_control":
        this.control = message.viewer as number;
        break;
      case "user_key":
        answer({ ok: true, handled: this.usedKeys?.has(message.key as string) === true });
        return;
      case "move":
        answer({ error: `"${message.entity as string}" would overlap with "wall_north"` });
        return;
      default:
        break;
    }
    answer({ ok: true });
    this.sendStatus();
    this.clients.forEach((other) => this.sendStates(other));
  }
}

afterEach(() => MockServer.closeAll());
