// Columns of values in time, coded as differences to the straight line through the two last ones.

import { ByteReader, realFromBits } from "./bytes";

const kPoseGrid = 1 / (1 << 20);
const kTwo32 = 4294967296;
const kNoneHigh = 0x40000000; // of the number that stands for none

/** How exactly a recording keeps poses and rays. */
export enum Precision {
  Grid = 0,
  Exact = 1,
}

/**
 * Values of 64 bits, predicted by the two last ones. JavaScript has no fast numbers of 64 bits, so
 * that each is two of 32.
 */
export class PredictedColumn {
  private low = new Int32Array(0);
  private high = new Int32Array(0);
  private lowBefore = new Int32Array(0);
  private highBefore = new Int32Array(0);
  private isNew = new Uint8Array(0);
  private hasNew = false;

  get size(): number {
    return this.low.length;
  }

  /** Predicts 0 from now on, for size values. */
  restart(size: number): void {
    this.low = new Int32Array(size);
    this.high = new Int32Array(size);
    this.lowBefore = new Int32Array(size);
    this.highBefore = new Int32Array(size);
    this.isNew = new Uint8Array(size).fill(1);
    this.hasNew = size > 0;
  }

  /** Adds values at the end, which are predicted as 0 at first. */
  append(count: number): void {
    if (count === 0) {
      return;
    }
    const size = this.size + count;
    const grow = (old: Int32Array): Int32Array<ArrayBuffer> => {
      const grown = new Int32Array(size);
      grown.set(old);
      return grown;
    };
    const isNew = new Uint8Array(size).fill(1);
    isNew.set(this.isNew);
    this.low = grow(this.low);
    this.high = grow(this.high);
    this.lowBefore = grow(this.lowBefore);
    this.highBefore = grow(this.highBefore);
    this.isNew = isNew;
    this.hasNew = true;
  }

  /** Removes the values whose flag is set. */
  remove(isRemoved: Uint8Array): void {
    const keep = <T extends Int32Array | Uint8Array>(old: T): T =>
      old.filter((_, i) => isRemoved[i] === 0) as T;
    this.low = keep(this.low);
    this.high = keep(this.high);
    this.lowBefore = keep(this.lowBefore);
    this.highBefore = keep(this.highBefore);
    this.isNew = keep(this.isNew);
  }

  /** Reads the next value of each, of which value() tells. */
  decode(input: ByteReader): void {
    const { low, high, lowBefore, highBefore } = this;
    let zeros = 0;
    for (let i = 0; i < low.length; ++i) {
      let deltaLow = 0;
      let deltaHigh = 0;
      if (zeros > 0) {
        --zeros;
      } else {
        input.readNumber64();
        if (input.low === 0 && input.high === 0) {
          zeros = input.readNumber();
        } else {
          // 0, 1, 2, 3, ... stand for 0, -1, 1, -2, ...
          const sign = -(input.low & 1);
          deltaLow = ((input.low >>> 1) | (input.high << 31)) ^ sign;
          deltaHigh = (input.high >>> 1) ^ sign;
        }
      }
      const lastLow = low[i]!;
      const lastHigh = high[i]!;
      const sum = 2 * (lastLow >>> 0) - (lowBefore[i]! >>> 0) + (deltaLow >>> 0);
      const nextHigh = 2 * lastHigh - highBefore[i]! + deltaHigh + Math.floor(sum / kTwo32);
      lowBefore[i] = lastLow;
      highBefore[i] = lastHigh;
      low[i] = sum; // the array keeps the lowest 32 bits
      high[i] = nextHigh;
    }
    this.finishNew();
  }

  /** A value that was read, as the number that it stands for. */
  value(i: number, precision: Precision): number {
    let low = this.low[i]!;
    let high = this.high[i]!;
    if (precision === Precision.Grid) {
      if (high === kNoneHigh && low === 0) {
        return NaN;
      }
      return (high * kTwo32 + (low >>> 0)) * kPoseGrid;
    }
    // negative numbers descend in their bits
    if (high < 0) {
      high ^= 0x7fffffff;
      low = ~low;
    }
    return realFromBits(low, high);
  }

  /** Writes all values into every stride-th place from first on. */
  copyTo(values: Float64Array, first: number, stride: number, precision: Precision): void {
    const { low, high } = this;
    if (precision === Precision.Exact) {
      for (let i = 0, place = first; i < low.length; ++i, place += stride) {
        values[place] = this.value(i, precision);
      }
      return;
    }
    for (let i = 0, place = first; i < low.length; ++i, place += stride) {
      const isNone = high[i] === kNoneHigh && low[i] === 0;
      values[place] = isNone ? NaN : (high[i]! * kTwo32 + (low[i]! >>> 0)) * kPoseGrid;
    }
  }

  // new values are predicted to rest after their first one
  private finishNew(): void {
    if (!this.hasNew) {
      return;
    }
    for (let i = 0; i < this.low.length; ++i) {
      if (this.isNew[i] !== 0) {
        this.lowBefore[i] = this.low[i]!;
        this.highBefore[i] = this.high[i]!;
        this.isNew[i] = 0;
      }
    }
    this.hasNew = false;
  }
}

/** Reads a number for each word, and inverts the bits that it has; runs of 0 are counted, not listed. */
export function invertSparse(words: Uint32Array, input: ByteReader): void {
  for (let i = 0; i < words.length; ++i) {
    const bits = input.readNumber();
    if (bits === 0) {
      i += input.readNumber(); // number of further words that did not change
    } else {
      words[i]! ^= bits;
    }
  }
}
