// A whole recording: which ticks it has, and the state of any of them.

import {
  type BlockHeader,
  BlockKind,
  type RecordingInfo,
  checkFileHeader,
  kBlockHeaderSize,
  kFileFooterSize,
  kFileHeaderSize,
  prepareUnpacking,
  readBlockHeader,
  readFooter,
  readInfo,
  unpackBlock,
} from "./blocks";
import { ByteReader, FormatError } from "./bytes";
import { type Floor, type Frame, FrameDecoder, readFloor } from "./frames";

/** Bytes of a recording, in memory or in a file that is read in parts. */
export interface ByteSource {
  size: number;
  read(place: number, size: number): Promise<Uint8Array>;
}

export function sourceOfBytes(bytes: Uint8Array): ByteSource {
  return {
    size: bytes.length,
    read: (place, size) => Promise.resolve(bytes.subarray(place, place + size)),
  };
}

export function sourceOfBlob(blob: Blob): ByteSource {
  return {
    size: blob.size,
    read: async (place, size) =>
      new Uint8Array(await blob.slice(place, place + size).arrayBuffer()),
  };
}

interface Block {
  place: number;
  firstTick: number;
  lastTick: number;
}

/** Reads the states of a recording, at best in their order. */
export class Recording {
  readonly info: RecordingInfo;
  readonly firstTick: number;
  readonly lastTick: number;
  private readonly decoder: FrameDecoder;
  private content = new ByteReader(new Uint8Array(0));
  private block = -1;
  private floors = new Map<number, Floor>();
  private queue: Promise<unknown> = Promise.resolve();

  private constructor(
    private readonly source: ByteSource,
    info: RecordingInfo,
    private readonly blocks: Block[],
    /** Null, or why the recording ends before its end. */
    readonly damage: string | null,
  ) {
    this.info = info;
    this.firstTick = blocks[0]!.firstTick;
    this.lastTick = blocks[blocks.length - 1]!.lastTick;
    this.decoder = new FrameDecoder(info.precision);
  }

  static async open(source: ByteSource): Promise<Recording> {
    await prepareUnpacking();
    checkFileHeader(await source.read(0, kFileHeaderSize));
    const header = readBlockHeader(await source.read(kFileHeaderSize, kBlockHeaderSize));
    if (header === null || header.kind !== BlockKind.Info) {
      throw new FormatError("its first block is damaged");
    }
    const info = readInfo(await readContent(source, kFileHeaderSize, header));
    let damage: string | null = null;
    let blocks = await tryReadIndex(source);
    if (blocks === null) {
      ({ blocks, damage } = await findBlocks(source));
    }
    if (blocks.length === 0) {
      throw new FormatError("it has no state of any tick");
    }
    return new Recording(source, info, blocks, damage);
  }

  /** Another reader of the same recording, with a place of its own. */
  copy(): Recording {
    return new Recording(this.source, this.info, this.blocks, this.damage);
  }

  /** All bytes of it. */
  readAll(): Promise<Uint8Array> {
    return this.source.read(0, this.source.size);
  }

  /** Ticks from which reading needs least: the first one of each block. */
  get keyTicks(): number[] {
    return this.blocks.map((block) => block.firstTick);
  }

  /** The last state that was read. */
  get frame(): Frame {
    return this.decoder.frame;
  }

  /** The state of a tick, or the last one before it. Calls are served one after the other. */
  read(tick: number): Promise<Frame> {
    const result = this.queue.then(() => this.readNow(tick));
    this.queue = result.catch(() => undefined);
    return result;
  }

  private async readNow(tick: number): Promise<Frame> {
    const wanted = Math.max(this.firstTick, tick);
    const number = this.findBlock(wanted);
    if (number !== this.block || wanted < this.decoder.frame.tick) {
      await this.startBlock(number);
    }
    while (!this.content.isAtEnd && this.peekTick() <= wanted) {
      this.decode();
    }
    return this.decoder.frame;
  }

  // the last block that begins at the tick or before it
  private findBlock(tick: number): number {
    let low = 0;
    let high = this.blocks.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.blocks[middle]!.firstTick <= tick) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  private async startBlock(number: number): Promise<void> {
    this.block = -1;
    const { place } = this.blocks[number]!;
    const header = readBlockHeader(await this.source.read(place, kBlockHeaderSize));
    if (header === null || header.kind !== BlockKind.Frames) {
      throw new FormatError(`its block at byte ${place} is damaged`);
    }
    let floor: Floor | null = null;
    if (header.floorPlace !== 0) {
      floor = this.floors.get(header.floorPlace) ?? null;
      if (floor === null) {
        const place = header.floorPlace;
        const floorHeader = readBlockHeader(await this.source.read(place, kBlockHeaderSize));
        if (floorHeader === null || floorHeader.kind !== BlockKind.Floor) {
          throw new FormatError(`its floor at byte ${place} is damaged`);
        }
        floor = readFloor(await readContent(this.source, place, floorHeader));
        this.floors.clear();
        this.floors.set(place, floor);
      }
    }
    this.content = new ByteReader(await readContent(this.source, place, header));
    this.decoder.setFloor(floor);
    this.decode();
    this.block = number;
  }

  private decode(): void {
    try {
      this.decoder.decode(this.content);
    } catch (error) {
      this.block = -1;
      throw error;
    }
  }

  // the tick of the next state of the block
  private peekTick(): number {
    const body = new ByteReader(this.content.rest());
    body.readNumber(); // its length
    return body.readNumber();
  }
}

async function readContent(
  source: ByteSource,
  place: number,
  header: BlockHeader,
): Promise<Uint8Array> {
  try {
    return unpackBlock(header, await source.read(place + kBlockHeaderSize, header.packedSize));
  } catch (error) {
    throw new FormatError(`its block at byte ${place}: ${(error as Error).message}`);
  }
}

async function tryReadIndex(source: ByteSource): Promise<Block[] | null> {
  try {
    const place = readFooter(await source.read(source.size - kFileFooterSize, kFileFooterSize));
    if (place === null) {
      return null;
    }
    const header = readBlockHeader(await source.read(place, kBlockHeaderSize));
    if (header === null || header.kind !== BlockKind.Index) {
      return null;
    }
    const input = new ByteReader(await readContent(source, place, header));
    const blocks: Block[] = [];
    let next = 0;
    while (!input.isAtEnd) {
      next += input.readNumber();
      const firstTick = input.readNumber();
      blocks.push({ place: next, firstTick, lastTick: firstTick + input.readNumber() });
    }
    return blocks;
  } catch {
    return null; // the blocks can be found without it
  }
}

async function findBlocks(source: ByteSource): Promise<{ blocks: Block[]; damage: string }> {
  const blocks: Block[] = [];
  let place = kFileHeaderSize;
  while (place < source.size) {
    const header = readBlockHeader(await source.read(place, kBlockHeaderSize));
    if (header === null || place + kBlockHeaderSize + header.packedSize > source.size) {
      break;
    }
    if (header.kind === BlockKind.Frames) {
      blocks.push({ place, firstTick: header.firstTick, lastTick: header.lastTick });
    }
    place += kBlockHeaderSize + header.packedSize;
  }
  const last = blocks[blocks.length - 1]?.lastTick ?? 0;
  const damage = `the run that made it was stopped, or the file was cut: it ends at tick ${last}`;
  return { blocks, damage };
}
