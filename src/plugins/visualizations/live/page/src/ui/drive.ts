// Drives the selected robot by keys.

const kSpeed = 10; // cm/s
const kTurn = 4; // cm/s, of a wheel

const kWays: Record<string, [number, number]> = {
  w: [kSpeed, kSpeed],
  s: [-kSpeed, -kSpeed],
  a: [-kTurn, kTurn],
  d: [kTurn, -kTurn],
};

export class DriveKeys {
  isOn = false;
  private readonly down = new Set<string>();

  /** @param send  takes the speeds of left and right wheel, cm/s. */
  constructor(private readonly send: (left: number, right: number) => void) {}

  /** Returns false if the key does not drive. */
  key(key: string, isDown: boolean): boolean {
    const letter = key.toLowerCase();
    if (!(letter in kWays)) {
      return false;
    }
    if (this.down.has(letter) !== isDown) {
      if (isDown) {
        this.down.add(letter);
      } else {
        this.down.delete(letter);
      }
      let left = 0;
      let right = 0;
      for (const pressed of this.down) {
        left += kWays[pressed]![0];
        right += kWays[pressed]![1];
      }
      this.send(left, right);
    }
    return true;
  }
}
