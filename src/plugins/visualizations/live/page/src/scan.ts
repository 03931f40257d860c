// Reads a whole recording besides what is shown, for plots of all of its time.

import type { Frame } from "./decode/frames";
import type { Recording } from "./decode/recording";

const kSlice = 12; // ms of work at once
const kPause = 30; // ms in between
const kMaxNumbers = 60e6; // poses read in full; of longer recordings, only the first of a block

/** Calls visit with states in order, until all are read or stop() is called. */
export class Scan {
  private isStopped = false;

  constructor(
    recording: Recording,
    private readonly visit: (frame: Frame) => void,
    private readonly progress: () => void,
  ) {
    void this.run(recording.copy());
  }

  stop(): void {
    this.isStopped = true;
  }

  private async run(recording: Recording): Promise<void> {
    try {
      const first = await recording.read(recording.firstTick);
      const { every } = recording.info;
      const states = (recording.lastTick - recording.firstTick) / every;
      const isShort = states * first.poses.length < kMaxNumbers;
      const ticks = isShort ? allTicks(recording) : recording.keyTicks;
      let since = performance.now();
      for (const tick of ticks) {
        const frame = await recording.read(tick);
        if (this.isStopped) {
          return;
        }
        this.visit(frame);
        if (performance.now() - since > kSlice) {
          this.progress();
          await new Promise((resolve) => setTimeout(resolve, kPause));
          since = performance.now();
        }
      }
    } catch {
      // the player says what is damaged when it gets there
    }
    this.progress();
  }
}

function* allTicks(recording: Recording): Iterable<number> {
  const { every } = recording.info;
  for (let tick = recording.firstTick; tick < recording.lastTick; tick += every) {
    yield tick;
  }
  yield recording.lastTick;
}
