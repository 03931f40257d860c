// The blocks of a live stream: the same as in a file, one in a message.

import {
  BlockKind,
  type RecordingInfo,
  kBlockHeaderSize,
  readBlockHeader,
  readInfo,
  unpackBlock,
} from "./blocks";
import { ByteReader, FormatError } from "./bytes";
import { type Floor, type Frame, FrameDecoder, readFloor } from "./frames";

export class StreamDecoder {
  info: RecordingInfo | null = null;
  /** The message with the information, as it came. */
  infoBlock = new Uint8Array(0);
  /** Of the last state: whether it needs none before it, and the floor before it. */
  isKey = false;
  floorBefore: Floor | null = null;
  private decoder: FrameDecoder | null = null;

  /** The last state; null before the first one. */
  get frame(): Frame | null {
    return this.decoder?.frame ?? null;
  }

  /** Takes a message. Returns the last state in it, or null if it has none. */
  decode(message: Uint8Array): Frame | null {
    const header = readBlockHeader(message);
    if (header === null) {
      throw new FormatError("the server has sent something that is no block");
    }
    const content = unpackBlock(header, message.subarray(kBlockHeaderSize));
    if (header.kind === BlockKind.Info) {
      this.info = readInfo(content);
      this.infoBlock = message.slice();
      this.decoder = new FrameDecoder(this.info.precision);
      return null;
    }
    if (this.decoder === null) {
      throw new FormatError("the server has sent a state before the information");
    }
    if (header.kind === BlockKind.Floor) {
      this.decoder.setFloor(readFloor(content));
    } else if (header.kind === BlockKind.Frames) {
      if (header.floorPlace === 0) {
        this.decoder.setFloor(null);
      }
      this.floorBefore = this.decoder.frame.floor;
      this.isKey = isKeyFrame(content);
      const input = new ByteReader(content);
      while (!input.isAtEnd) {
        this.decoder.decode(input);
      }
      return this.decoder.frame;
    }
    return null;
  }
}

function isKeyFrame(content: Uint8Array): boolean {
  const body = new ByteReader(new ByteReader(content).readTextBytes());
  body.readNumber(); // its tick
  return body.readByte() !== 0;
}
