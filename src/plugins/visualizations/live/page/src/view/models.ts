// What the entities of a type look like, ready to be drawn.

import {
  type Color,
  type EntityType,
  PartKind,
  type Quaternion,
  TypeKind,
  type Vector,
} from "../decode/types";
import { add, rotate } from "./math";
import { MeshKind } from "./meshes";

const kDetailShare = 0.35; // of the volume of the largest part
const kHighestFoot = 0.045; // m; parts that begin above it hardly darken the ground
const kUndeclaredLED = 0.01; // m
const kLampDiameter = 0.1; // m

export interface Solid {
  kind: MeshKind;
  /** 0 is the entity's own, others are of its anchors. */
  anchor: number;
  position: Vector;
  orientation: Quaternion;
  size: Vector;
  color: Color;
  param: number;
  isDetail: boolean;
}

export interface Glow {
  anchor: number;
  position: Vector;
  diameter: number;
  /** Which word of the entity is its colour. */
  word: number;
  isLamp: boolean;
}

export interface Footprint {
  position: Vector;
  orientation: Quaternion;
  halfX: number;
  halfY: number;
  isRound: boolean;
  blur: number;
}

export interface Model {
  solids: Solid[];
  glows: Glow[];
  /** The largest solid, which stands for all of them from afar. */
  largest: Solid | null;
  footprint: Footprint | null;
  /** Around all solids, in the entity's frame, m; for picking, labels and headings. */
  min: Vector;
  max: Vector;
  isRobot: boolean;
}

const kNoTurn: Quaternion = [1, 0, 0, 0];

function volume(solid: Solid): number {
  return solid.size[0] * solid.size[1] * solid.size[2];
}

function standsOnBase(kind: MeshKind): boolean {
  return kind === MeshKind.Box || kind === MeshKind.Cylinder;
}

const kSolidKinds = new Map<PartKind, [MeshKind, number]>([
  [PartKind.Box, [MeshKind.Box, 1]],
  [PartKind.Cylinder, [MeshKind.Cylinder, 1]],
  [PartKind.Cone, [MeshKind.Cylinder, 0]],
  [PartKind.Sphere, [MeshKind.Sphere, 1]],
]);

function makeFootprint(solids: Solid[]): Footprint | null {
  let found: Solid | null = null;
  for (const solid of solids) {
    const up = rotate(solid.orientation, [0, 0, 1])[2];
    const stands = standsOnBase(solid.kind) && up > 0.999 && solid.anchor === 0;
    if (
      stands &&
      Math.abs(solid.position[2]) < kHighestFoot &&
      (found === null || solid.size[0] * solid.size[1] > found.size[0] * found.size[1])
    ) {
      found = solid;
    }
  }
  if (found === null) {
    return null;
  }
  const halfX = 0.5 * found.size[0];
  const halfY = 0.5 * found.size[1];
  const reach = 0.6 * Math.min(found.size[2], 2 * Math.min(halfX, halfY));
  return {
    position: found.position,
    orientation: found.orientation,
    halfX,
    halfY,
    isRound: found.kind !== MeshKind.Box,
    blur: Math.min(Math.max(reach, 0.01), 0.1),
  };
}

function computeBounds(model: Model, type: EntityType): void {
  let min = type.boxMin;
  let max = type.boxMax;
  const isEmpty = !(max[0] > min[0]);
  if (isEmpty) {
    min = [Infinity, Infinity, Infinity];
    max = [-Infinity, -Infinity, -Infinity];
    for (const { kind, position, orientation, size } of model.solids) {
      for (let i = 0; i < 8; ++i) {
        const corner = add(
          position,
          rotate(orientation, [
            size[0] * ((i & 1) - 0.5),
            size[1] * (((i >> 1) & 1) - 0.5),
            size[2] * ((i >> 2) - (standsOnBase(kind) ? 0 : 0.5)),
          ]),
        );
        min = [
          Math.min(min[0], corner[0]),
          Math.min(min[1], corner[1]),
          Math.min(min[2], corner[2]),
        ];
        max = [
          Math.max(max[0], corner[0]),
          Math.max(max[1], corner[1]),
          Math.max(max[2], corner[2]),
        ];
      }
    }
  }
  if (!(max[0] >= min[0])) {
    const half = 0.5 * (model.glows[0]?.diameter ?? 0.05);
    min = [-half, -half, -half];
    max = [half, half, half];
  }
  model.min = min;
  model.max = max;
}

export function makeModel(type: EntityType): Model {
  const model: Model = {
    solids: [],
    glows: [],
    largest: null,
    footprint: null,
    min: [0, 0, 0],
    max: [0, 0, 0],
    isRobot: type.isRobot,
  };
  const declared = new Set<number>();
  for (const part of type.parts) {
    const anchor = 1 + type.anchors.indexOf(part.anchor); // an unknown one is the origin
    const { position, orientation, size, color } = part;
    if (part.kind === PartKind.LED) {
      declared.add(part.led);
      const word = part.led < type.numLEDs ? 1 + part.led : -1;
      model.glows.push({ anchor, position, diameter: size[0], word, isLamp: false });
    } else if (part.kind === PartKind.Ring) {
      model.solids.push({
        kind: MeshKind.Ring,
        anchor,
        position,
        orientation,
        size: [size[0], size[1], size[0]],
        color,
        param: size[2] / size[0],
        isDetail: false,
      });
    } else {
      const [kind, param] = kSolidKinds.get(part.kind)!;
      model.solids.push({
        kind,
        anchor,
        position,
        orientation,
        size,
        color,
        param,
        isDetail: false,
      });
    }
  }
  if (type.kind === TypeKind.Light) {
    const position: Vector = [0, 0, 0];
    model.glows.push({ anchor: 0, position, diameter: kLampDiameter, word: 1, isLamp: true });
  }
  for (const solid of model.solids) {
    if (model.largest === null || volume(solid) > volume(model.largest)) {
      model.largest = solid;
    }
  }
  for (const solid of model.solids) {
    solid.isDetail = volume(solid) < kDetailShare * volume(model.largest!);
  }
  model.footprint = makeFootprint(model.solids);
  computeBounds(model, type);
  // LEDs whose places are not recorded are on top, in a row
  if (type.kind === TypeKind.Body && declared.size === 0 && type.numLEDs > 0) {
    for (let led = 0; led < type.numLEDs; ++led) {
      const x = (led - 0.5 * (type.numLEDs - 1)) * 1.5 * kUndeclaredLED;
      model.glows.push({
        anchor: 0,
        position: [x, 0, model.max[2]],
        diameter: kUndeclaredLED,
        word: 1 + led,
        isLamp: false,
      });
    }
  }
  return model;
}

export { kNoTurn };
