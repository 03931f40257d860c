// The shapes that users' code has drawn.

import { ByteReader } from "./bytes";
import { type Color, type Quaternion, type Vector, readQuaternion, readVector } from "./types";

export enum ShapeKind {
  Point,
  Line,
  Polygon,
  Circle,
  Cylinder,
  Box,
  Text,
}

export interface TextStyle {
  family: string;
  size: number;
  isBold: boolean;
  isItalic: boolean;
  /** 0 left, 1 centre, 2 right. */
  alignment: number;
}

/** One shape; sizes as in the C++ class SDrawnShape. */
export interface Shape {
  kind: ShapeKind;
  isOverlay: boolean;
  isFilled: boolean;
  color: Color;
  position: Vector;
  size: Vector;
  pixels: number;
  count: number;
  orientation: Quaternion;
  /** x and y of each corner of a polygon. */
  corners: Float64Array;
  text: string;
  style: TextStyle | null;
}

const kNoCorners = new Float64Array(0);

function readShape(input: ByteReader): Shape {
  const kind = input.readNumberUpTo(ShapeKind.Text, "kind of shape");
  const isOverlay = input.readNumberUpTo(1, "space of a shape") === 1;
  const isFilled = input.readByte() !== 0;
  const rgba = input.readBytes(4);
  const position = readVector(input);
  const size = readVector(input);
  const pixels = input.readReal();
  const count = input.readNumberUpTo(0xffffffff, "number of corners");
  const orientation = readQuaternion(input);
  let corners = kNoCorners;
  let text = "";
  let style: TextStyle | null = null;
  if (kind === ShapeKind.Polygon) {
    corners = new Float64Array(2 * Math.min(count, input.left));
    for (let i = 0; i < corners.length; ++i) {
      corners[i] = input.readReal();
    }
  } else if (kind === ShapeKind.Text) {
    text = input.readText();
    style = {
      family: input.readText(),
      size: input.readReal(),
      isBold: input.readByte() !== 0,
      isItalic: input.readByte() !== 0,
      alignment: input.readNumberUpTo(2, "alignment"),
    };
  }
  const color: Color = [rgba[0]!, rgba[1]!, rgba[2]!, rgba[3]!];
  return {
    kind,
    isOverlay,
    isFilled,
    color,
    position,
    size,
    pixels,
    count,
    orientation,
    corners,
    text,
    style,
  };
}

/** All shapes, in the order in which they were drawn. */
export function readDrawing(bytes: Uint8Array): Shape[] {
  const input = new ByteReader(bytes);
  const shapes: Shape[] = [];
  while (!input.isAtEnd) {
    shapes.push(readShape(input));
  }
  return shapes;
}
