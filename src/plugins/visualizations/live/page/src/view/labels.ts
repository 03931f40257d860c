// Texts over the picture: ids, what users write, numbers of axes. Drawn on a canvas of its own.

import { type Shape, ShapeKind } from "../decode/drawing";
import type { Color, Vector } from "../decode/types";
import type { Look } from "./looks";
import { cornersOf } from "./marks";
import { add, rotate } from "./math";

export interface Label {
  position: Vector;
  text: string;
  /** Null: that of the look. */
  color: Color | null;
  size: number;
  weight: string;
  family: string;
  align: CanvasTextAlign;
  /** Pixels above the position. */
  above: number;
}

export const kLabelFont = 'system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';

export function makeLabel(position: Vector, text: string, more: Partial<Label> = {}): Label {
  return {
    position,
    text,
    color: null,
    size: 12,
    weight: "500",
    family: kLabelFont,
    align: "center",
    above: 0,
    ...more,
  };
}

function css([r, g, b, a]: Color): string {
  return `rgba(${r},${g},${b},${a / 255})`;
}

function contourOf(color: Color): string {
  const isLight = 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2] > 140;
  return isLight ? "rgba(12,14,18,0.8)" : "rgba(255,255,255,0.85)";
}

export function labelOfShape(shape: Shape): Label {
  const style = shape.style!;
  const families: Record<string, string> = { serif: "serif", monospace: "monospace" };
  return makeLabel(shape.position, shape.text, {
    color: shape.color,
    size: style.size,
    weight: `${style.isItalic ? "italic " : ""}${style.isBold ? "bold" : "normal"}`,
    family: families[style.family] ?? kLabelFont,
    align: (["left", "center", "right"] as const)[style.alignment] ?? "left",
  });
}

/** Writes a text that can be read on any ground. */
export function contourText(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  color: string,
  contour: string,
): void {
  context.lineJoin = "round";
  context.lineWidth = 3;
  context.strokeStyle = contour;
  context.fillStyle = color;
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

export class LabelCanvas {
  private readonly context: CanvasRenderingContext2D;
  private isEmpty = true;

  /** @param isSoftware  the processor draws: then the browser does it without WebGL's detour. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    isSoftware: boolean,
  ) {
    this.context = canvas.getContext("2d", { willReadFrequently: isSoftware })!;
  }

  draw(
    labels: Label[],
    overlay: Shape[],
    look: Look,
    project: (point: Vector) => { x: number; y: number } | null,
    pictureScale: number,
  ): void {
    if (this.isEmpty && labels.length === 0 && overlay.length === 0) {
      return;
    }
    const hasNothing = labels.length === 0 && overlay.length === 0;
    this.canvas.style.visibility = hasNothing ? "hidden" : ""; // browsers then need not blend it
    const ratio = window.devicePixelRatio;
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (this.canvas.width !== Math.round(width * ratio)) {
      this.canvas.width = Math.round(width * ratio);
    }
    if (this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.height = Math.round(height * ratio);
    }
    const { context } = this;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    this.isEmpty = labels.length === 0 && overlay.length === 0;
    for (const shape of overlay) {
      if (shape.kind !== ShapeKind.Text) {
        this.drawShape(shape, pictureScale);
      }
    }
    for (const label of labels) {
      const place = project(label.position);
      if (place !== null && place.x > -200 && place.x < width + 200) {
        this.drawLabel(label, place.x, place.y, look, 1);
      }
    }
    for (const shape of overlay) {
      if (shape.kind === ShapeKind.Text) {
        const [x, y] = shape.position;
        const label = labelOfShape(shape);
        this.drawLabel(label, x * pictureScale, y * pictureScale, look, pictureScale);
      }
    }
  }

  private drawLabel(label: Label, x: number, y: number, look: Look, factor: number): void {
    const { context } = this;
    const size = Math.max(8, label.size * factor);
    context.font = `${label.weight} ${size}px ${label.family}`;
    context.textAlign = label.align;
    const contour = label.color === null ? look.textContour : contourOf(label.color);
    const color = label.color === null ? look.text : css(label.color);
    label.text
      .slice(0, 2000)
      .split("\n")
      .forEach((line, i) => {
        contourText(context, line, x, y - label.above + 1.2 * size * i, color, contour);
      });
  }

  private drawShape(shape: Shape, factor: number): void {
    const { context } = this;
    context.fillStyle = context.strokeStyle = css(shape.color);
    context.lineWidth = Math.max(shape.pixels, 1) * factor;
    context.beginPath();
    const [px, py] = shape.position;
    const point = (x: number, y: number): [number, number] => {
      const turned = add(shape.position, rotate(shape.orientation, [x, y, 0]));
      return [turned[0] * factor, turned[1] * factor];
    };
    const [width, height] = shape.size;
    switch (shape.kind) {
      case ShapeKind.Point:
        context.arc(px * factor, py * factor, 0.5 * shape.pixels * factor, 0, 7);
        context.fill();
        return;
      case ShapeKind.Line:
        context.moveTo(px * factor, py * factor);
        context.lineTo((px + width) * factor, (py + height) * factor);
        context.stroke();
        return;
      case ShapeKind.Cylinder:
        context.arc(px * factor, py * factor, 0.5 * width * factor, 0, 7);
        context.fill();
        return;
      case ShapeKind.Box:
        for (const [x, y] of [
          [-0.5, -0.5],
          [0.5, -0.5],
          [0.5, 0.5],
          [-0.5, 0.5],
        ] as const) {
          context.lineTo(...point(x * width, y * height));
        }
        context.fill();
        return;
      default:
        cornersOf(shape).forEach(([x, y]) => context.lineTo(...point(x, y)));
        context.closePath();
        if (shape.isFilled) {
          context.fill();
        } else {
          context.stroke();
        }
    }
  }
}
