// What a viewer has received of a run: the states of its last minutes, in bounded memory.

import {
  BlockKind,
  type RecordingInfo,
  kBlockHeaderSize,
  kVersion,
  readBlockHeader,
  unpackBlock,
} from "../decode/blocks";
import { ByteReader } from "../decode/bytes";
import { type Floor, type Frame, FrameDecoder, writeFloor } from "../decode/frames";
import { ByteWriter, joinBytes, makeBlock } from "../decode/write";

const kMaxBytes = 64 * 1024 * 1024;
const kMaxStates = 100_000;
const kBytesOfState = 120; // beside its block, about

interface Kept {
  tick: number;
  /** As it came: a block with one state. */
  block: Uint8Array;
}

/** States from a key frame on. */
interface Group {
  floor: Floor | null;
  states: Kept[];
}

export class History {
  private groups: Group[] = [];
  private bytes = 0;
  private numStates = 0;
  private info: RecordingInfo | null = null;
  private infoBlock = new Uint8Array(0);
  // Decodes the states of the past that are shown.
  private decoder: FrameDecoder | null = null;
  private shown: { group: Group; next: number } | null = null;

  constructor(private readonly maxBytes = kMaxBytes) {}

  get size(): number {
    return this.numStates;
  }
  get numBytes(): number {
    return this.bytes;
  }
  get firstTick(): number {
    return this.groups[0]?.states[0]?.tick ?? 0;
  }
  get lastTick(): number {
    return this.groups.at(-1)?.states.at(-1)?.tick ?? 0;
  }

  /** Another run. */
  start(info: RecordingInfo, infoBlock: Uint8Array<ArrayBuffer>): void {
    this.info = info;
    this.infoBlock = infoBlock;
    this.groups = [];
    this.bytes = this.numStates = 0;
    this.shown = null;
  }

  /** Floor: before the state. A state replaces those of its tick and of later ones. */
  add(tick: number, block: Uint8Array, isKey: boolean, floor: Floor | null): void {
    if (isKey) {
      this.cutFrom(tick);
      this.groups.push({ floor, states: [] });
      this.bytes += floor === this.groups.at(-2)?.floor ? 0 : (floor?.pixels.length ?? 0);
    }
    const group = this.groups.at(-1);
    if (group === undefined) {
      return; // its key frame was not received
    }
    group.states.push({ tick, block: block.slice() });
    this.bytes += block.length + kBytesOfState;
    ++this.numStates;
    while ((this.bytes > this.maxBytes || this.numStates > kMaxStates) && this.groups.length > 1) {
      this.drop(0);
    }
  }

  private cutFrom(tick: number): void {
    while (this.lastTick >= tick && this.groups.length > 0) {
      const { states } = this.groups.at(-1)!;
      if (states.length === 0 || states[0]!.tick >= tick) {
        this.drop(this.groups.length - 1);
      } else {
        while (states.at(-1)!.tick >= tick) {
          this.bytes -= states.pop()!.block.length + kBytesOfState;
          --this.numStates;
        }
      }
    }
    this.shown = null;
  }

  private drop(at: number): void {
    const [group] = this.groups.splice(at, 1);
    const floor = group!.floor;
    const isUsed = this.groups.some((other) => other.floor === floor);
    this.bytes -= isUsed ? 0 : (floor?.pixels.length ?? 0);
    for (const { block } of group!.states) {
      this.bytes -= block.length + kBytesOfState;
      --this.numStates;
    }
    if (this.shown?.group === group) {
      this.shown = null;
    }
  }

  /** The tick of the last state at a tick or before it. */
  tickAt(tick: number): number {
    const group = this.groupAt(tick);
    const states = (group?.states ?? []).filter((state) => state.tick <= tick);
    return states.at(-1)?.tick ?? this.firstTick;
  }

  /** The tick of the state that is count after, or before, that of a tick. */
  neighbour(tick: number, count: number): number {
    const ticks = this.groups.flatMap(({ states }) => states.map((state) => state.tick));
    let at = ticks.findIndex((other) => other > tick);
    at = (at < 0 ? ticks.length : at) - 1;
    return ticks[Math.min(Math.max(at + count, 0), ticks.length - 1)] ?? tick;
  }

  // The group of the last state at the tick or before it; if there is none, the first group.
  private groupAt(tick: number): Group | undefined {
    const groups = this.groups.filter(({ states }) => states.length > 0);
    return groups.filter(({ states }) => states[0]!.tick <= tick).at(-1) ?? groups[0];
  }

  /** The last state at the tick or before it; arrays change with the next call. Null: it has none. */
  read(tick: number): Frame | null {
    const group = this.groupAt(tick);
    if (group === undefined || this.info === null) {
      return null;
    }
    if (this.decoder === null || this.shown?.group !== group || this.decoder.frame.tick > tick) {
      this.decoder = new FrameDecoder(this.info.precision);
      this.decoder.setFloor(group.floor);
      this.shown = { group, next: 0 };
    }
    const { shown } = this;
    while (
      shown!.next < group.states.length &&
      (shown!.next === 0 || group.states[shown!.next]!.tick <= tick)
    ) {
      this.decoder.decode(new ByteReader(contentOf(group.states[shown!.next]!.block)));
      ++shown!.next;
    }
    return this.decoder.frame;
  }

  /** All of it as a recording. */
  toRecording(): Uint8Array | null {
    if (this.info === null || this.numStates === 0) {
      return null;
    }
    const start = new ByteWriter();
    start.text("ARGOSREC");
    start.fixed32(kVersion);
    start.fixed32(0);
    const parts: Uint8Array[] = [start.result, this.infoBlock];
    let place = start.result.length + this.infoBlock.length;
    const add = (part: Uint8Array): number => {
      parts.push(part);
      place += part.length;
      return place - part.length;
    };
    const index = new ByteWriter();
    let floor: Floor | null = null;
    let floorPlace = 0;
    let before = 0;
    for (const group of this.groups) {
      const first = group.states[0];
      const last = group.states.at(-1);
      if (first === undefined || last === undefined) {
        continue;
      }
      if (group.floor !== floor) {
        ({ floor } = group);
        floorPlace = floor === null ? 0 : add(makeBlock(BlockKind.Floor, [0, 0], writeFloor(floor)));
      }
      const content = joinBytes(group.states.map(({ block }) => contentOf(block)));
      const at = add(makeBlock(BlockKind.Frames, [first.tick, last.tick], content, floorPlace));
      index.number(at - before);
      index.number(first.tick);
      index.number(last.tick - first.tick);
      before = at;
    }
    const indexPlace = add(makeBlock(BlockKind.Index, [0, 0], index.result));
    const end = new ByteWriter();
    end.text("ARGOSEND");
    end.fixed64(indexPlace);
    parts.push(end.result);
    return joinBytes(parts);
  }
}

function contentOf(block: Uint8Array): Uint8Array {
  return unpackBlock(readBlockHeader(block)!, block.subarray(kBlockHeaderSize));
}
