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

function linesOf(label: Label): string[] {
  return label.text.slice(0, kMaxText).split("\n");
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
  context.lineWidth = kContour;
  context.strokeStyle = contour;
  context.fillStyle = color;
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

/** A part of the picture, in its pixels (those of CSS). */
export interface Part {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

interface PlacedLabel {
  label: Label;
  x: number;
  y: number;
  factor: number;
}

const kMaxText = 2000;
const kContour = 3; // pixels
const kLineHeight = 1.2; // of the size
const kStep = 32; // pixels of the screen: the canvas seldom changes its size

/**
 * The canvas covers only what is written, and is drawn only when that changes: where the processor draws, a browser that blends
 * a second canvas over the whole picture takes as long as for the picture itself.
 */
export class LabelCanvas {
  private readonly context: CanvasRenderingContext2D;
  private drawn = "";
  private part: Part = { left: 0, top: 0, right: 0, bottom: 0 };

  /** @param isSoftware  the processor draws: then the browser does it without WebGL's detour. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    isSoftware: boolean,
  ) {
    this.context = canvas.getContext("2d", { willReadFrequently: isSoftware })!;
  }

  /** What the canvas covers. */
  get covered(): Readonly<Part> {
    return this.part;
  }

  draw(
    labels: Label[],
    overlay: Shape[],
    look: Look,
    project: (point: Vector) => { x: number; y: number } | null,
    { clientWidth: width, clientHeight: height }: HTMLCanvasElement,
  ): void {
    // recordings draw for a picture 960 pixels high
    const pictureScale = height / 960;
    const placed: PlacedLabel[] = [];
    for (const label of labels) {
      const place = project(label.position);
      if (place !== null && place.x > -200 && place.x < width + 200) {
        placed.push({ label, ...place, factor: 1 });
      }
    }
    const shapes = overlay.filter((shape) => shape.kind !== ShapeKind.Text);
    for (const shape of overlay.filter(({ kind }) => kind === ShapeKind.Text)) {
      const [x, y] = shape.position;
      placed.push({ label: labelOfShape(shape), x: x * pictureScale, y: y * pictureScale, factor: pictureScale });
    }
    const ratio = window.devicePixelRatio;
    const { text, textContour } = look;
    const toDraw = JSON.stringify([width, height, ratio, text, textContour, placed, shapes]);
    if (toDraw === this.drawn) {
      return;
    }
    this.drawn = toDraw;
    const whole = { left: 0, top: 0, right: width, bottom: height };
    this.cover(shapes.length > 0 ? whole : this.partOf(placed, whole), ratio);
    for (const shape of shapes) {
      this.drawShape(shape, pictureScale);
    }
    for (const label of placed) {
      this.drawLabel(label, look);
    }
  }

  private partOf(placed: PlacedLabel[], whole: Part): Part {
    const part = { left: whole.right, top: whole.bottom, right: 0, bottom: 0 };
    for (const { label, x, y, factor } of placed) {
      const size = this.setFont(label, factor);
      const lines = linesOf(label);
      const length = Math.max(...lines.map((line) => this.context.measureText(line).width)) + 2 * kContour;
      const start = { left: 0, center: 0.5, right: 1 }[label.align as "left" | "center" | "right"] * length;
      part.left = Math.min(part.left, x - start - kContour);
      part.right = Math.max(part.right, x - start + length + kContour);
      part.top = Math.min(part.top, y - label.above - kLineHeight * size - kContour);
      part.bottom = Math.max(part.bottom, y - label.above + kLineHeight * size * (lines.length - 0.5) + kContour);
    }
    return {
      left: Math.max(part.left, 0),
      top: Math.max(part.top, 0),
      right: Math.min(part.right, whole.right),
      bottom: Math.min(part.bottom, whole.bottom),
    };
  }

  // empties the canvas and places it over a part of the picture, at whole pixels of the screen
  private cover(part: Part, ratio: number): void {
    const { style } = this.canvas;
    if (part.right <= part.left || part.bottom <= part.top) {
      this.part = { left: 0, top: 0, right: 0, bottom: 0 };
      style.visibility = "hidden"; // browsers then need not blend it
      return;
    }
    const down = (length: number): number => Math.floor((length * ratio) / kStep) * kStep;
    const up = (length: number): number => Math.ceil((length * ratio) / kStep) * kStep;
    const [left, top, right, bottom] = [down(part.left), down(part.top), up(part.right), up(part.bottom)];
    this.part = { left: left / ratio, top: top / ratio, right: right / ratio, bottom: bottom / ratio };
    style.visibility = "visible";
    style.left = `${this.part.left}px`;
    style.top = `${this.part.top}px`;
    style.width = `${this.part.right - this.part.left}px`;
    style.height = `${this.part.bottom - this.part.top}px`;
    this.canvas.width = right - left; // also when it stays: that empties it
    this.canvas.height = bottom - top;
    this.context.setTransform(ratio, 0, 0, ratio, -left, -top);
  }

  private setFont(label: Label, factor: number): number {
    const size = Math.max(8, label.size * factor);
    this.context.font = `${label.weight} ${size}px ${label.family}`;
    return size;
  }

  private drawLabel({ label, x, y, factor }: PlacedLabel, look: Look): void {
    const { context } = this;
    const size = this.setFont(label, factor);
    context.textAlign = label.align;
    const contour = label.color === null ? look.textContour : contourOf(label.color);
    const color = label.color === null ? look.text : css(label.color);
    linesOf(label).forEach((line, i) => {
      contourText(context, line, x, y - label.above + kLineHeight * size * i, color, contour);
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
