// Lines, dots, flat shapes and rings: rays, trails, headings, axes, what users draw, selections.

import { BufferAttribute, BufferGeometry, Mesh, Scene, ShapeUtils, Vector2 } from "three";

import { type Shape, ShapeKind } from "../decode/drawing";
import type { Color, Vector } from "../decode/types";
import { kGlowFields } from "./entities";
import { type FieldSpec, InstanceBatch, type Uniforms, makeMaterial, makeQuad } from "./gpu";
import { add, rotate } from "./math";
import {
  kFlatFragment,
  kFlatVertex,
  kGlowFragment,
  kGlowVertex,
  kLineFragment,
  kLineVertex,
  kRingFragment,
  kRingVertex,
  kSolidFragment,
  kSolidVertex,
} from "./shaders";
import { makeMesh, MeshKind } from "./meshes";

export const kWorld = 0xffffffff;

const kRoundCorners = 96;
const kNearer = 5e-4;
const kNearerPerShape = 2e-6;
const kNearest = 2.5e-3;

const kLineFields: FieldSpec[] = [
  { name: "inPlace", size: 2, type: "uint" },
  { name: "inStart", size: 3, type: "float" },
  { name: "inEnd", size: 3, type: "float" },
  { name: "inColor", size: 4, type: "color" },
  { name: "inWidth", size: 1, type: "float" },
];
const kRingFields: FieldSpec[] = [
  { name: "inPlace", size: 2, type: "uint" },
  { name: "inRadius", size: 1, type: "float" },
  { name: "inColor", size: 4, type: "color" },
];

export interface Line {
  /** Number of the pose in whose frame it is, or kWorld. */
  pose: number;
  start: Vector;
  end: Vector;
  color: Color;
  width: number;
}

export interface Dot {
  pose: number;
  position: Vector;
  color: Color;
  /** m; or, if pixels are not 0, pixels. */
  radius: number;
  pixels: number;
}

/** Lines that are filled again when they change. */
export class LineSet {
  readonly batch: InstanceBatch;

  constructor(uniforms: Uniforms, renderOrder = 7, depthTest = true) {
    const material = makeMaterial(kLineVertex, kLineFragment, uniforms, {
      isBlended: true,
      depthTest,
    });
    this.batch = new InstanceBatch(makeQuad(), kLineFields, material, renderOrder);
  }

  set(lines: Line[]): void {
    const fields = this.batch.begin(lines.length);
    const place = fields.get("inPlace")!;
    const start = fields.get("inStart")!;
    const end = fields.get("inEnd")!;
    const color = fields.get("inColor")!;
    const width = fields.get("inWidth")!;
    lines.forEach((line, i) => {
      place[2 * i] = line.pose;
      start.set(line.start, 3 * i);
      end.set(line.end, 3 * i);
      color.set(line.color, 4 * i);
      width[i] = line.width;
    });
    this.batch.end(lines.length);
  }
}

export class DotSet {
  readonly batch: InstanceBatch;

  constructor(uniforms: Uniforms) {
    const material = makeMaterial(kGlowVertex, kGlowFragment, uniforms, { isBlended: true });
    this.batch = new InstanceBatch(makeQuad(), kGlowFields, material, 8);
  }

  set(dots: Dot[]): void {
    const fields = this.batch.begin(dots.length);
    dots.forEach((dot, i) => {
      fields.get("inPlace")!.set([dot.pose, 0], 2 * i);
      fields.get("inOffset")!.set(dot.position, 3 * i);
      fields.get("inColor")!.set(dot.color, 4 * i);
      fields.get("inShape")!.set([dot.radius, dot.pixels, 0], 3 * i);
    });
    this.batch.end(dots.length);
  }
}

export interface Ring {
  pose: number;
  radius: number;
  color: Color;
}

export class RingSet {
  readonly batch: InstanceBatch;

  constructor(uniforms: Uniforms) {
    const material = makeMaterial(kRingVertex, kRingFragment, uniforms, {
      isBlended: true,
      depthTest: false,
    });
    material.transparent = false; // drawn before the solids
    this.batch = new InstanceBatch(makeQuad(), kRingFields, material, 2);
  }

  set(rings: Ring[]): void {
    const fields = this.batch.begin(rings.length);
    rings.forEach((ring, i) => {
      fields.get("inPlace")!.set([ring.pose, 0], 2 * i);
      fields.get("inRadius")![i] = ring.radius;
      fields.get("inColor")!.set(ring.color, 4 * i);
    });
    this.batch.end(rings.length);
  }
}

const kSolidFields: FieldSpec[] = [
  { name: "inPlace", size: 2, type: "uint" },
  { name: "inOffset", size: 3, type: "float" },
  { name: "inTurn", size: 4, type: "float" },
  { name: "inSize", size: 3, type: "float" },
  { name: "inColor", size: 4, type: "color" },
  { name: "inShape", size: 2, type: "float" },
];

/** What users' code draws in the world. Its texts and overlays are the labels'. */
export class UserDrawing {
  readonly scene = new Scene();
  private readonly lines: LineSet;
  private readonly dots: DotSet;
  private readonly cylinders: InstanceBatch;
  private readonly boxes: InstanceBatch;
  private flats: Mesh | null = null;
  private readonly flatMaterial;

  constructor(uniforms: Uniforms) {
    this.lines = new LineSet(uniforms);
    this.dots = new DotSet(uniforms);
    const solid = (kind: MeshKind): InstanceBatch => {
      const mesh = makeMesh(kind, 32);
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(new Float32Array(mesh.positions), 3));
      geometry.setAttribute("normal", new BufferAttribute(new Float32Array(mesh.normals), 3));
      geometry.setAttribute("edge", new BufferAttribute(new Float32Array(mesh.edges), 2));
      geometry.setIndex(mesh.indices);
      const material = makeMaterial(kSolidVertex, kSolidFragment, uniforms, {
        isBlended: true,
        depthWrite: true,
        defines: { KIND: kind },
      });
      return new InstanceBatch(geometry, kSolidFields, material, 5);
    };
    this.cylinders = solid(MeshKind.Cylinder);
    this.boxes = solid(MeshKind.Box);
    this.flatMaterial = makeMaterial(kFlatVertex, kFlatFragment, uniforms, { isBlended: true });
    this.flatMaterial.side = 2;
    this.scene.add(this.lines.batch.mesh, this.dots.batch.mesh);
    this.scene.add(this.cylinders.mesh, this.boxes.mesh);
  }

  set(shapes: Shape[]): void {
    const lines: Line[] = [];
    const dots: Dot[] = [];
    const flats = { positions: [] as number[], colors: [] as number[], nearer: [] as number[] };
    const solids: Shape[][] = [[], []];
    let nearer = kNearer;
    for (const shape of shapes) {
      nearer = Math.min(nearer + kNearerPerShape, kNearest);
      if (shape.isOverlay) {
        continue;
      }
      const { color, position, pixels } = shape;
      switch (shape.kind) {
        case ShapeKind.Point:
          dots.push({ pose: kWorld, position, color, radius: 0, pixels });
          break;
        case ShapeKind.Line:
          lines.push({
            pose: kWorld,
            start: position,
            end: add(position, shape.size),
            color,
            width: pixels,
          });
          break;
        case ShapeKind.Polygon:
        case ShapeKind.Circle:
          addArea(shape, nearer, lines, flats);
          break;
        case ShapeKind.Cylinder:
          solids[0]!.push(shape);
          break;
        case ShapeKind.Box:
          solids[1]!.push(shape);
          break;
        case ShapeKind.Text:
          break;
      }
    }
    this.lines.set(lines);
    this.dots.set(dots);
    fillSolids(this.cylinders, solids[0]!);
    fillSolids(this.boxes, solids[1]!);
    this.setFlats(flats);
  }

  private setFlats(flats: { positions: number[]; colors: number[]; nearer: number[] }): void {
    if (this.flats !== null) {
      this.flats.geometry.dispose();
      this.scene.remove(this.flats);
      this.flats = null;
    }
    if (flats.nearer.length === 0) {
      return;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(flats.positions), 3));
    geometry.setAttribute("inColor", new BufferAttribute(new Uint8Array(flats.colors), 4, true));
    geometry.setAttribute("inNearer", new BufferAttribute(new Float32Array(flats.nearer), 1));
    this.flats = new Mesh(geometry, this.flatMaterial);
    this.flats.frustumCulled = false;
    this.flats.renderOrder = 4;
    this.scene.add(this.flats);
  }
}

/** The corners of a polygon or circle, in its frame, x and y. */
export function cornersOf(shape: Shape): [number, number][] {
  const corners: [number, number][] = [];
  if (shape.kind === ShapeKind.Polygon) {
    for (let i = 0; i < shape.corners.length; i += 2) {
      corners.push([shape.corners[i]!, shape.corners[i + 1]!]);
    }
    return corners;
  }
  const count = shape.count === 0 ? kRoundCorners : Math.min(shape.count, 1000);
  for (let i = 0; i < count; ++i) {
    const angle = (2 * Math.PI * i) / count;
    corners.push([shape.size[0] * Math.cos(angle), shape.size[0] * Math.sin(angle)]);
  }
  return corners;
}

function addArea(
  shape: Shape,
  nearer: number,
  lines: Line[],
  flats: { positions: number[]; colors: number[]; nearer: number[] },
): void {
  const corners = cornersOf(shape);
  const world = corners.map(([x, y]) =>
    add(shape.position, rotate(shape.orientation, [x, y, 0])),
  );
  if (!shape.isFilled) {
    world.forEach((start, i) => {
      const end = world[(i + 1) % world.length]!;
      lines.push({ pose: kWorld, start, end, color: shape.color, width: shape.pixels });
    });
    return;
  }
  const triangles = ShapeUtils.triangulateShape(
    corners.map(([x, y]) => new Vector2(x, y)),
    [],
  );
  for (const triangle of triangles) {
    for (const corner of triangle) {
      flats.positions.push(...world[corner]!);
      flats.colors.push(...shape.color);
      flats.nearer.push(nearer);
    }
  }
}

function fillSolids(batch: InstanceBatch, shapes: Shape[]): void {
  const fields = batch.begin(shapes.length);
  shapes.forEach((shape, i) => {
    const [w, x, y, z] = shape.orientation;
    const base = rotate(shape.orientation, [0, 0, -0.5 * shape.size[2]]);
    fields.get("inPlace")!.set([kWorld, kWorld], 2 * i);
    fields.get("inOffset")!.set(add(shape.position, base), 3 * i);
    fields.get("inTurn")!.set([x, y, z, w], 4 * i);
    fields.get("inSize")!.set(shape.size, 3 * i);
    fields.get("inColor")!.set(shape.color, 4 * i);
    fields.get("inShape")!.set([1, 0], 2 * i);
  });
  batch.end(shapes.length);
}
