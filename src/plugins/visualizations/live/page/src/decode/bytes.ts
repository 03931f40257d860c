// Reads the numbers and texts of recordings: lowest byte first; whole numbers take 7 bits a byte.

export class FormatError extends Error {}

const kTwo32 = 4294967296;
const utf8 = new TextDecoder();
const words = new Uint32Array(2);
const real = new Float64Array(words.buffer);

/** The number whose bits are given. */
export function realFromBits(low: number, high: number): number {
  words[0] = low;
  words[1] = high;
  return real[0]!;
}

export class ByteReader {
  /** Halves of the last number that readNumber64() read, as signed 32-bit numbers. */
  low = 0;
  high = 0;
  private place = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get left(): number {
    return this.bytes.length - this.place;
  }
  get isAtEnd(): boolean {
    return this.place >= this.bytes.length;
  }

  /** A view of all bytes that are left, which are not read by it. */
  rest(): Uint8Array {
    return this.bytes.subarray(this.place);
  }

  readByte(): number {
    if (this.place >= this.bytes.length) {
      throw new FormatError("it is too short");
    }
    return this.bytes[this.place++]!;
  }

  /** A whole number of up to 64 bits, into low and high. */
  readNumber64(): void {
    let byte = this.readByte();
    if (byte < 0x80) {
      this.low = byte;
      this.high = 0;
      return;
    }
    let low = byte & 0x7f;
    let high = 0;
    for (let shift = 7; ; shift += 7) {
      if (shift > 63) {
        throw new FormatError("a number is too long");
      }
      byte = this.readByte();
      const part = byte & 0x7f;
      if (shift < 28) {
        low |= part << shift;
      } else if (shift === 28) {
        low |= part << 28;
        high |= part >>> 4;
      } else {
        high |= part << (shift - 32);
      }
      if (byte < 0x80) {
        break;
      }
    }
    this.low = low | 0;
    this.high = high | 0;
  }

  /** A whole number; exact below 2^53. */
  readNumber(): number {
    this.readNumber64();
    return (this.high >>> 0) * kTwo32 + (this.low >>> 0);
  }

  /** A number of at most largest; what names it in the error. */
  readNumberUpTo(largest: number, what: string): number {
    const value = this.readNumber();
    if (value > largest) {
      throw new FormatError(`its ${what} is ${value}, more than the possible ${largest}`);
    }
    return value;
  }

  /** The number of items that follow, each of at least one byte. */
  readCount(what: string): number {
    return this.readNumberUpTo(this.left, what);
  }

  readFixed32(): number {
    const bytes = this.readBytes(4);
    return (bytes[0]! | (bytes[1]! << 8) | (bytes[2]! << 16) | (bytes[3]! << 24)) >>> 0;
  }

  /** Exact below 2^53. */
  readFixed64(): number {
    const low = this.readFixed32();
    return this.readFixed32() * kTwo32 + low;
  }

  readReal(): number {
    const low = this.readFixed32();
    return realFromBits(low, this.readFixed32());
  }

  /** A view of the next bytes. */
  readBytes(count: number): Uint8Array {
    if (count > this.left) {
      throw new FormatError("it is too short");
    }
    const bytes = this.bytes.subarray(this.place, this.place + count);
    this.place += count;
    return bytes;
  }

  /** The bytes of a text. */
  readTextBytes(): Uint8Array {
    return this.readBytes(this.readNumber());
  }

  readText(): string {
    return utf8.decode(this.readTextBytes());
  }
}
