// Writes recordings: blocks whose contents are stored without compression.

import { BlockKind, checksum, kBlockHeaderSize, kBlockMagic } from "./blocks";

const kMaxChunk = 100_000; // of a zstd block at most 128 KiB

/** Numbers and texts as ByteReader reads them. */
export class ByteWriter {
  private readonly bytes: number[] = [];

  get result(): Uint8Array {
    return new Uint8Array(this.bytes);
  }

  number(value: number): void {
    let left = value;
    while (left >= 128) {
      this.bytes.push((left % 128) + 128);
      left = Math.floor(left / 128);
    }
    this.bytes.push(left);
  }
  fixed32(value: number): void {
    for (let shift = 0; shift < 32; shift += 8) {
      this.bytes.push((value >>> shift) & 255);
    }
  }
  fixed64(value: number): void {
    this.fixed32(value % 4294967296);
    this.fixed32(Math.floor(value / 4294967296));
  }
  text(value: string): void {
    this.bytes.push(...new TextEncoder().encode(value));
  }
}

/** One after the other. */
export function joinBytes(parts: Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let place = 0;
  for (const part of parts) {
    whole.set(part, place);
    place += part.length;
  }
  return whole;
}

/** A zstd frame that holds the bytes as they are. */
export function storeAsZstd(content: Uint8Array): Uint8Array {
  const start = new ByteWriter();
  start.fixed32(0xfd2fb528);
  const size = new ByteWriter();
  size.fixed32(content.length);
  // one segment, whose size has 4 bytes
  const parts = [start.result, new Uint8Array([0xa0]), size.result];
  for (let place = 0; place < content.length || place === 0; place += kMaxChunk) {
    const chunk = content.subarray(place, place + kMaxChunk);
    const isLast = place + kMaxChunk >= content.length;
    const header = (chunk.length << 3) | (isLast ? 1 : 0);
    parts.push(new Uint8Array([header & 255, (header >> 8) & 255, header >> 16]), chunk);
  }
  return joinBytes(parts);
}

/** A block with its header. */
export function makeBlock(
  kind: BlockKind,
  ticks: readonly [number, number],
  content: Uint8Array,
  floorPlace = 0,
): Uint8Array {
  const packed = storeAsZstd(content);
  const [low, high] = checksum(packed);
  const header = new ByteWriter();
  for (const word of [kBlockMagic, kind, ticks[0], ticks[1]]) {
    header.fixed32(word);
  }
  header.fixed64(floorPlace);
  for (const word of [content.length, packed.length, low, high]) {
    header.fixed32(word);
  }
  const bytes = header.result;
  const own = new ByteWriter();
  own.fixed32(checksum(bytes)[0]);
  const block = joinBytes([bytes, own.result, packed]);
  if (bytes.length + 4 !== kBlockHeaderSize) {
    throw new Error("the header of a block has another size");
  }
  return block;
}
