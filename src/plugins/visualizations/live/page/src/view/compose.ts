// Pictures for files: the picture, the texts over it, and the clock, on one canvas.

import { type LabelCanvas, contourText, kLabelFont } from "./labels";
import type { Look } from "./looks";

const kClockShare = 0.025; // of the height

/** Draws a picture and its texts in the middle of a canvas, as large as they fit. */
export function compose(
  target: HTMLCanvasElement,
  picture: HTMLCanvasElement,
  { canvas: texts, covered }: LabelCanvas,
  look: Look,
  clock: string,
): void {
  const context = target.getContext("2d")!;
  const { clientWidth, clientHeight } = picture;
  const factor = Math.min(target.width / clientWidth, target.height / clientHeight);
  const [width, height] = [factor * clientWidth, factor * clientHeight];
  const [left, top] = [0.5 * (target.width - width), 0.5 * (target.height - height)];
  context.fillStyle = look.background;
  context.fillRect(0, 0, target.width, target.height);
  context.drawImage(picture, left, top, width, height);
  if (covered.right > covered.left) {
    context.save();
    context.beginPath();
    context.rect(left, top, width, height);
    context.clip(); // the canvas of the texts may reach over the picture's sides
    const [x, y] = [left + factor * covered.left, top + factor * covered.top];
    context.drawImage(texts, x, y, factor * (covered.right - covered.left), factor * (covered.bottom - covered.top));
    context.restore();
  }
  if (clock !== "") {
    const size = Math.max(kClockShare * target.height, 11);
    context.font = `600 ${size}px ${kLabelFont}`;
    context.textAlign = "right";
    contourText(context, clock, target.width - size, target.height - size, look.text, look.textContour);
  }
}
