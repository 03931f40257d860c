// Drives the selected robot by keys.

const kSpeed = 10; // cm/s
const kTurn = 4; // cm/s, of a wheel

const kWays: Record<string, [number, number]> = {
  w: [kSpeed, kSpeed],
  s: [-kSpeed, -kSpeed],
  a: [-kTurn, kTurn],
  d: [kTurn, -kTurn],
};

export interface DriveHost {
  /** Speeds of left and right wheel, cm/s; null: those of its controller count again. */
  drive(id: string, speeds: [number, number] | null): void;
}

export class DriveKeys {
  private readonly down = new Set<string>();
  private robot: string | null = null;
  private isDriven = false; // since it was chosen
  private isOnNow = false;

  constructor(private readonly host: DriveHost) {}

  get isOn(): boolean {
    return this.isOnNow;
  }
  set isOn(value: boolean) {
    this.isOnNow = value;
    if (!value) {
      this.letGo();
    }
  }

  /** The robot that keys drive from now on; null: none. */
  setRobot(id: string | null): void {
    if (id !== this.robot) {
      this.letGo();
      this.robot = id;
    }
  }

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
      this.send();
    }
    return true;
  }

  /** The window has lost the keyboard, and does not hear that keys are released. */
  releaseKeys(): void {
    if (this.down.size > 0) {
      this.down.clear();
      this.send();
    }
  }

  private send(): void {
    const speeds: [number, number] = [0, 0];
    for (const letter of this.down) {
      speeds[0] += kWays[letter]![0];
      speeds[1] += kWays[letter]![1];
    }
    if (this.robot !== null) {
      this.isDriven = true;
      this.host.drive(this.robot, speeds);
    }
  }

  private letGo(): void {
    this.down.clear();
    if (this.robot !== null && this.isDriven) {
      this.host.drive(this.robot, null);
    }
    this.isDriven = false;
  }
}
