// The blocks of recordings and of live streams: a header of 44 bytes, then content packed by zstd.

import { ZSTDDecoder } from "zstddec";

import { ByteReader, FormatError } from "./bytes";
import { Precision } from "./columns";

export const kFileHeaderSize = 16;
export const kFileFooterSize = 16;
export const kBlockHeaderSize = 44;
export const kVersion = 1;
export const kBlockMagic = 0x4b4c4241;
const kMaxBlockBytes = 2 ** 29;

export enum BlockKind {
  Info = 1,
  Floor = 2,
  Frames = 3,
  Index = 4,
}

export interface BlockHeader {
  kind: number;
  firstTick: number;
  lastTick: number;
  /** Place in the file of the floor at the first tick; 0: there is none. */
  floorPlace: number;
  size: number;
  packedSize: number;
  checksumLow: number;
  checksumHigh: number;
}

/** What a recording tells of its run. */
export interface RecordingInfo {
  experimentFile: string;
  experiment: string;
  seed: number;
  version: string;
  build: string;
  date: string;
  tickLength: number;
  every: number;
  precision: Precision;
}

// the low and high half of the 64-bit checksum of the format
export function checksum(bytes: Uint8Array): [number, number] {
  let low = (0x7f4a7c15 ^ bytes.length) | 0;
  let high = 0x9e3779b9 | 0;
  const mix = (wordLow: number, wordHigh: number): void => {
    // times 0xff51afd7ed558ccd, by the halves of 16 bits of the lower word
    const a = low ^ wordLow;
    const b = high ^ wordHigh;
    const a0 = a & 0xffff;
    const a1 = a >>> 16;
    const p00 = a0 * 0x8ccd;
    const middle = a1 * 0x8ccd + (p00 >>> 16);
    const middle2 = a0 * 0xed55 + (middle & 0xffff);
    const carry = a1 * 0xed55 + Math.floor(middle / 65536) + Math.floor(middle2 / 65536);
    low = (middle2 << 16) | (p00 & 0xffff);
    high = (carry + Math.imul(a, 0xff51afd7) + Math.imul(b, 0xed558ccd)) | 0;
    low ^= high; // sum ^= sum >> 32
  };
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let place = 0;
  for (; place + 8 <= bytes.length; place += 8) {
    mix(view.getInt32(place, true), view.getInt32(place + 4, true));
  }
  let restLow = 0;
  let restHigh = 0;
  for (; place < bytes.length; ++place) {
    restHigh = (restHigh << 8) | (restLow >>> 24);
    restLow = (restLow << 8) | bytes[place]!;
  }
  mix(restLow, restHigh);
  return [low >>> 0, high >>> 0];
}

/** Throws if the bytes are not the begin of a recording that this page can read. */
export function checkFileHeader(bytes: Uint8Array): void {
  const magic = new TextDecoder().decode(bytes.subarray(0, 8));
  if (bytes.length < kFileHeaderSize || magic !== "ARGOSREC") {
    throw new FormatError("it is no recording");
  }
  const version = new ByteReader(bytes.subarray(8)).readFixed32();
  if (version > kVersion) {
    throw new FormatError(
      `it has version ${version} of the format; this page can read versions up to ${kVersion}`,
    );
  }
}

/** The place of the index, or null if the recording was not finished. */
export function readFooter(bytes: Uint8Array): number | null {
  if (
    bytes.length !== kFileFooterSize ||
    new TextDecoder().decode(bytes.subarray(0, 8)) !== "ARGOSEND"
  ) {
    return null;
  }
  return new ByteReader(bytes.subarray(8)).readFixed64();
}

/** Null if the bytes are no header. */
export function readBlockHeader(bytes: Uint8Array): BlockHeader | null {
  if (bytes.length < kBlockHeaderSize) {
    return null;
  }
  const input = new ByteReader(bytes);
  if (input.readFixed32() !== kBlockMagic) {
    return null;
  }
  const header: BlockHeader = {
    kind: input.readFixed32(),
    firstTick: input.readFixed32(),
    lastTick: input.readFixed32(),
    floorPlace: input.readFixed64(),
    size: input.readFixed32(),
    packedSize: input.readFixed32(),
    checksumLow: input.readFixed32(),
    checksumHigh: input.readFixed32(),
  };
  const own = checksum(bytes.subarray(0, kBlockHeaderSize - 4))[0];
  if (
    input.readFixed32() !== own ||
    header.size > kMaxBlockBytes ||
    header.firstTick > header.lastTick
  ) {
    return null;
  }
  return header;
}

const zstd = new ZSTDDecoder();

/** Must have been awaited before blocks are unpacked: compiles the decompressor, which is WebAssembly. */
export function prepareUnpacking(): Promise<void> {
  return zstd.init();
}

/** The content of a block; packed is what follows its header. */
export function unpackBlock(header: BlockHeader, packed: Uint8Array): Uint8Array {
  const [low, high] = checksum(packed);
  if (
    packed.length !== header.packedSize ||
    low !== header.checksumLow ||
    high !== header.checksumHigh
  ) {
    throw new FormatError("its checksum is wrong");
  }
  const content = zstd.decode(packed, header.size);
  if (content.length !== header.size) {
    throw new FormatError("it cannot be decompressed");
  }
  return content;
}

export function readInfo(content: Uint8Array): RecordingInfo {
  const info: RecordingInfo = {
    experimentFile: "",
    experiment: "",
    seed: 0,
    version: "",
    build: "",
    date: "",
    tickLength: 0.1,
    every: 1,
    precision: Precision.Grid,
  };
  const input = new ByteReader(content);
  const decoder = new TextDecoder();
  while (!input.isAtEnd) {
    const name = input.readText();
    const bytes = input.readTextBytes();
    const value = new ByteReader(bytes);
    switch (name) {
      case "experiment_file":
        info.experimentFile = decoder.decode(bytes);
        break;
      case "experiment":
        info.experiment = decoder.decode(bytes);
        break;
      case "seed":
        info.seed = value.readNumber();
        break;
      case "version":
        info.version = decoder.decode(bytes);
        break;
      case "build":
        info.build = decoder.decode(bytes);
        break;
      case "date":
        info.date = decoder.decode(bytes);
        break;
      case "tick_length":
        info.tickLength = value.readReal();
        break;
      case "every":
        info.every = value.readNumber();
        break;
      case "precision":
        info.precision = value.readNumberUpTo(Precision.Exact, "precision");
        break;
      default:
        break;
    }
  }
  if (!(info.tickLength > 0) || !Number.isFinite(info.tickLength)) {
    throw new FormatError(`its length of a tick is ${info.tickLength} s`);
  }
  return info;
}
