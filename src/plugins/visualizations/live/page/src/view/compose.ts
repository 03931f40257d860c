// Pictures for files: the picture, the texts over it, and the clock, on one canvas.

import { contourText, kLabelFont } from "./labels";
import type { Look } from "./looks";

const kClockShare = 0.025; // of the height

/** Draws pictures, one over the other, in the middle of a canvas, as large as they fit. */
export function compose(target: HTMLCanvasElement, layers: HTMLCanvasElement[], look: Look, clock: string): void {
  const context = target.getContext("2d")!;
  const { clientWidth, clientHeight } = layers[0]!;
  const factor = Math.min(target.width / clientWidth, target.height / clientHeight);
  const [width, height] = [factor * clientWidth, factor * clientHeight];
  const [left, top] = [0.5 * (target.width - width), 0.5 * (target.height - height)];
  context.fillStyle = look.background;
  context.fillRect(0, 0, target.width, target.height);
  for (const layer of layers.filter((canvas) => canvas.width > 0 && canvas.height > 0)) {
    context.drawImage(layer, left, top, width, height);
  }
  if (clock !== "") {
    const size = Math.max(kClockShare * target.height, 11);
    context.font = `600 ${size}px ${kLabelFont}`;
    context.textAlign = "right";
    contourText(context, clock, target.width - size, target.height - size, look.text, look.textContour);
  }
}
