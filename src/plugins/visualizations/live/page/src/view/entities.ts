// Draws the entities: near ones in full, by instances; far ones as one merged mesh, or as points.

import {
  BufferAttribute,
  BufferGeometry,
  DepthTexture,
  LessEqualCompare,
  Mesh,
  NearestFilter,
  type OrthographicCamera,
  Points,
  type RawShaderMaterial,
  Scene,
  UnsignedIntType,
  WebGLRenderTarget,
  type WebGLRenderer,
} from "three";

import type { Entity, Vector } from "../decode/types";
import type { EntityType } from "../decode/types";
import { type FieldSpec, InstanceBatch, type Uniforms, makeMaterial, makeQuad } from "./gpu";
import { add, rotate } from "./math";
import { MeshKind, kMeshKinds, makeCylinder, makeDisc, makeMesh } from "./meshes";
import { type Model, type Solid, makeModel } from "./models";
import { PointPicture, type PointRobot, type PointScene } from "./point_picture";
import {
  kContactFragment,
  kContactVertex,
  kDepthFragment,
  kGlowFragment,
  kGlowVertex,
  kMergedVertex,
  kPlainFragment,
  kPointFragment,
  kPointVertex,
  kSolidFragment,
  kSolidVertex,
} from "./shaders";

const kSolidFields: FieldSpec[] = [
  { name: "inPlace", size: 2, type: "uint" },
  { name: "inOffset", size: 3, type: "float" },
  { name: "inTurn", size: 4, type: "float" },
  { name: "inSize", size: 3, type: "float" },
  { name: "inColor", size: 4, type: "color" },
  { name: "inShape", size: 2, type: "float" },
];
const kContactFields: FieldSpec[] = [
  { name: "inPlace", size: 2, type: "uint" },
  { name: "inOffset", size: 3, type: "float" },
  { name: "inTurn", size: 4, type: "float" },
  { name: "inHalfExtent", size: 2, type: "float" },
  { name: "inShape", size: 2, type: "float" },
];
export const kGlowFields: FieldSpec[] = [
  { name: "inPlace", size: 2, type: "uint" },
  { name: "inOffset", size: 3, type: "float" },
  { name: "inColor", size: 4, type: "color" },
  { name: "inShape", size: 3, type: "float" },
];

const kShadowSize = 2048; // pixels
const kNearPixels = 14; // diameter of robots from which they are drawn in full, if they are many
const kDetailPixels = 48; // the same for small parts of them
const kSmallPart = 0.3; // of the extent of an entity
const kPointPixels = 5;

const kWithoutDetails = 2;

/** What the machine can draw well. */
export interface Budget {
  /** Solids drawn one by one. */
  solids: number;
  /** Merged entities; more are points. */
  merged: number;
  segments: number;
  mergedSegments: number;
  /** Merged discs have half the corners, and no edge between top and side. */
  hasSmoothDiscs: boolean;
  hasShadows: boolean;
  /** Points that WebGL draws; the page draws more itself, which costs as much as about 4,000 of WebGL. */
  pointsByWebGL: number;
}

export const kGpuBudget: Budget = {
  solids: 40_000,
  merged: 40_000,
  segments: 32,
  mergedSegments: 12,
  hasSmoothDiscs: false,
  hasShadows: true,
  pointsByWebGL: Infinity,
};

export const kSoftwareBudget: Budget = {
  solids: 900,
  merged: 12_000,
  segments: 16,
  mergedSegments: 6,
  hasSmoothDiscs: true,
  hasShadows: false,
  pointsByWebGL: 4000,
};

function makeGeometry(kind: MeshKind, segments: number): BufferGeometry {
  const mesh = makeMesh(kind, segments);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(mesh.positions), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array(mesh.normals), 3));
  geometry.setAttribute("edge", new BufferAttribute(new Float32Array(mesh.edges), 2));
  geometry.setIndex(mesh.indices);
  return geometry;
}

export class EntityDrawer {
  readonly scene = new Scene();
  readonly shadowScene = new Scene();
  entities: Entity[] = [];
  /** By entity. */
  models: Model[] = [];
  private readonly opaque: InstanceBatch[];
  private readonly translucent: InstanceBatch[];
  private readonly casters: Mesh[] = [];
  private readonly glows: InstanceBatch;
  private readonly contacts: InstanceBatch;
  private readonly mergedMaterial: RawShaderMaterial;
  private readonly pointMaterial: RawShaderMaterial;
  private merged: Mesh | null = null;
  private points: Points | Mesh | null = null;
  private pointPicture: PointPicture | null = null;
  private modelsOfTypes = new Map<EntityType, Model>();
  private isNear = new Uint8Array(0);
  private numSolids = 0;
  private allNear = false;
  private firstSignalWord = 0;
  private hasSignals = false;
  readonly shadowTarget: WebGLRenderTarget | null = null;
  /** How entities are drawn now, for the line that says so. */
  counts = { near: 0, merged: 0, points: 0 };

  constructor(
    private readonly uniforms: Uniforms,
    private readonly budget: Budget,
    private readonly setNear: (isNear: Uint8Array) => void,
  ) {
    const shadows: Record<string, number> = budget.hasShadows ? { HAS_SHADOWS: 1 } : {};
    const makeBatches = (isBlended: boolean): InstanceBatch[] =>
      kMeshKinds.map((kind) => {
        const material = makeMaterial(kSolidVertex, kSolidFragment, uniforms, {
          isBlended,
          defines: { KIND: kind, ...shadows },
        });
        const geometry = makeGeometry(kind, budget.segments);
        return new InstanceBatch(geometry, kSolidFields, material, isBlended ? 6 : 3);
      });
    this.opaque = makeBatches(false);
    this.translucent = makeBatches(true);
    this.glows = new InstanceBatch(
      makeQuad(),
      kGlowFields,
      makeMaterial(kGlowVertex, kGlowFragment, uniforms, { isBlended: true }),
      9,
    );
    this.contacts = new InstanceBatch(
      makeQuad(),
      kContactFields,
      makeMaterial(kContactVertex, kContactFragment, uniforms, {
        isBlended: true,
        depthTest: false,
      }),
      1,
    );
    this.contacts.mesh.material = [this.contacts.mesh.material].flat()[0]!;
    // blended, but drawn before all solids
    ([this.contacts.mesh.material].flat()[0] as RawShaderMaterial).transparent = false;
    this.mergedMaterial = makeMaterial(
      kMergedVertex,
      budget.hasShadows ? kSolidFragment : kPlainFragment,
      uniforms,
      { defines: shadows },
    );
    this.pointMaterial = makeMaterial(kPointVertex, kPointFragment, uniforms);
    for (const batch of [...this.opaque, ...this.translucent, this.glows, this.contacts]) {
      this.scene.add(batch.mesh);
    }
    if (budget.hasShadows) {
      this.shadowTarget = this.makeShadowTarget();
      this.opaque.forEach((batch, kind) => {
        const material = makeMaterial(kSolidVertex, kDepthFragment, uniforms, {
          defines: { KIND: kind },
        });
        material.polygonOffset = true;
        material.polygonOffsetFactor = 1.5;
        material.polygonOffsetUnits = 2;
        const caster = new Mesh(batch.geometry, material);
        caster.frustumCulled = false;
        this.casters.push(caster);
        this.shadowScene.add(caster);
      });
      uniforms.uShadowMap!.value = this.shadowTarget.depthTexture;
      uniforms.uShadowTexel!.value = 1 / kShadowSize;
    }
  }

  /** Number of the first word after those of the state: the colours that stand for entities. */
  signalWords(words: Uint32Array): Uint32Array {
    if (this.allNear) {
      return words;
    }
    const all = new Uint32Array(this.firstSignalWord + this.entities.length);
    all.set(words);
    let isLit = false;
    this.entities.forEach((entity, i) => {
      const first = entity.firstWord + 1;
      for (let led = 0; led < entity.type.numLEDs; ++led) {
        const word = words[first + led]!;
        if ((word & 0xffffff) !== 0) {
          all[this.firstSignalWord + i] = word;
          isLit = true;
          break;
        }
      }
    });
    if (isLit !== this.hasSignals) {
      this.hasSignals = isLit;
      this.fill();
    }
    return all;
  }

  /** The entities have changed. */
  setEntities(entities: Entity[], numWords: number): void {
    this.entities = entities;
    const models = new Map<EntityType, Model>();
    this.models = entities.map(({ type }) => {
      let model = models.get(type) ?? this.modelsOfTypes.get(type);
      if (model === undefined) {
        model = makeModel(type);
      }
      models.set(type, model);
      return model;
    });
    this.modelsOfTypes = models;
    this.firstSignalWord = numWords;
    this.numSolids = this.models.reduce(
      (sum, model) => sum + model.solids.length + 0.5 * model.glows.length,
      0,
    );
    this.allNear = this.numSolids <= this.budget.solids;
    this.isNear = new Uint8Array(entities.length);
    this.dropMerged();
    if (this.allNear) {
      this.isNear.fill(1);
      this.counts = { near: entities.length, merged: 0, points: 0 };
      this.fill();
    } else {
      this.makePoints();
      this.fill();
      this.setNear(this.isNear);
    }
  }

  /**
   * Chooses which entities are drawn in full.
   * @param pixels  diameter of an entity on the picture; 0: not seen.
   */
  chooseNear(pixels: (entity: number) => number): void {
    if (this.allNear) {
      return;
    }
    const sizes: [number, number][] = [];
    let largest = 0;
    this.models.forEach((model, i) => {
      const size = pixels(i);
      largest = Math.max(largest, model.isRobot ? size : 0);
      // walls and other things are few, and large
      if (size >= kNearPixels || !model.isRobot) {
        sizes.push([model.isRobot ? size : Infinity, i]);
      }
    });
    sizes.sort((a, b) => b[0] - a[0]);
    const isNear = new Uint8Array(this.entities.length);
    let left = this.budget.solids;
    let near = 0;
    for (const [size, i] of sizes) {
      const model = this.models[i]!;
      left -= model.solids.length + 0.5 * model.glows.length;
      if (left < 0) {
        break;
      }
      isNear[i] = size < kDetailPixels ? kWithoutDetails : 1;
      ++near;
    }
    const far = this.entities.length - near;
    const asPoints = far > this.budget.merged || largest < kPointPixels;
    if (!asPoints) {
      this.merged ??= this.makeMerged();
    }
    if (this.merged !== null) {
      this.merged.visible = !asPoints;
    }
    this.points!.visible = asPoints;
    this.counts = { near, merged: asPoints ? 0 : far, points: asPoints ? far : 0 };
    if (isNear.some((value, i) => value !== this.isNear[i])) {
      this.isNear = isNear;
      this.fill();
      this.setNear(isNear);
    }
  }

  /** Draws the shadow map. */
  drawShadows(renderer: WebGLRenderer, sun: OrthographicCamera): void {
    if (this.shadowTarget === null) {
      return;
    }
    this.casters.forEach((caster, kind) => {
      caster.visible = this.opaque[kind]!.length > 0;
    });
    const texture = this.uniforms.uShadowMap!;
    texture.value = null;
    renderer.setRenderTarget(this.shadowTarget);
    renderer.clear();
    renderer.render(this.shadowScene, sun);
    renderer.setRenderTarget(null);
    texture.value = this.shadowTarget.depthTexture;
  }

  private makeShadowTarget(): WebGLRenderTarget {
    const depthTexture = new DepthTexture(kShadowSize, kShadowSize, UnsignedIntType);
    depthTexture.compareFunction = LessEqualCompare;
    depthTexture.minFilter = depthTexture.magFilter = NearestFilter;
    return new WebGLRenderTarget(kShadowSize, kShadowSize, { depthTexture });
  }

  // the instances of near entities
  private fill(): void {
    const solids = new Map<InstanceBatch, [Solid, Entity][]>();
    const glows: [number, Entity, Model["glows"][number]][] = [];
    const feet: [Entity, Model][] = [];
    const signals: number[] = [];
    this.entities.forEach((entity, i) => {
      const model = this.models[i]!;
      if (this.isNear[i] === 0) {
        if (entity.type.numLEDs > 0 && this.hasSignals) {
          signals.push(i);
        }
        return;
      }
      const least =
        this.isNear[i] === kWithoutDetails ? kSmallPart * (model.max[0] - model.min[0]) : 0;
      for (const solid of model.solids) {
        if (solid.isDetail && Math.max(...solid.size) < least) {
          continue;
        }
        const batches = solid.color[3] === 255 ? this.opaque : this.translucent;
        const batch = batches[solid.kind]!;
        const list = solids.get(batch) ?? [];
        list.push([solid, entity]);
        solids.set(batch, list);
      }
      for (const glow of model.glows) {
        glows.push([i, entity, glow]);
      }
      if (model.footprint !== null) {
        feet.push([entity, model]);
      }
    });
    for (const batch of [...this.opaque, ...this.translucent]) {
      this.fillSolids(batch, solids.get(batch) ?? []);
    }
    this.fillGlows(glows, signals);
    this.fillContacts(feet);
  }

  private fillSolids(batch: InstanceBatch, list: [Solid, Entity][]): void {
    const fields = batch.begin(list.length);
    const place = fields.get("inPlace")!;
    const offset = fields.get("inOffset")!;
    const turn = fields.get("inTurn")!;
    const size = fields.get("inSize")!;
    const color = fields.get("inColor")!;
    const shape = fields.get("inShape")!;
    list.forEach(([solid, entity], i) => {
      place[2 * i] = entity.firstPose + solid.anchor;
      place[2 * i + 1] = entity.firstWord;
      offset.set(solid.position, 3 * i);
      const [w, x, y, z] = solid.orientation;
      turn.set([x, y, z, w], 4 * i);
      size.set(solid.size, 3 * i);
      color.set(solid.color, 4 * i);
      shape[2 * i] = solid.param;
      shape[2 * i + 1] = solid.isDetail ? 1 : 0;
    });
    batch.end(list.length);
  }

  private fillGlows(list: [number, Entity, Model["glows"][number]][], signals: number[]): void {
    const fields = this.glows.begin(list.length + signals.length);
    const place = fields.get("inPlace")!;
    const offset = fields.get("inOffset")!;
    const color = fields.get("inColor")!;
    const shape = fields.get("inShape")!;
    list.forEach(([, entity, glow], i) => {
      place[2 * i] = entity.firstPose + glow.anchor;
      place[2 * i + 1] = entity.firstWord + Math.max(glow.word, 0);
      offset.set(glow.position, 3 * i);
      color.set([46, 48, 54, 255], 4 * i);
      shape.set([0.5 * glow.diameter, 0, glow.isLamp ? 2 : glow.word < 0 ? 0 : 1], 3 * i);
    });
    signals.forEach((number, k) => {
      const i = list.length + k;
      const entity = this.entities[number]!;
      place[2 * i] = entity.firstPose;
      place[2 * i + 1] = this.firstSignalWord + number;
      offset.set([0, 0, this.models[number]!.max[2]], 3 * i);
      shape.set([0.006, 0, 3], 3 * i);
    });
    this.glows.end(list.length + signals.length);
  }

  private fillContacts(list: [Entity, Model][]): void {
    const fields = this.contacts.begin(list.length);
    list.forEach(([entity, { footprint }], i) => {
      const { position, orientation, halfX, halfY, isRound, blur } = footprint!;
      fields.get("inPlace")!.set([entity.firstPose, entity.firstWord], 2 * i);
      fields.get("inOffset")!.set(position, 3 * i);
      const [w, x, y, z] = orientation;
      fields.get("inTurn")!.set([x, y, z, w], 4 * i);
      fields.get("inHalfExtent")!.set([halfX, halfY], 2 * i);
      fields.get("inShape")!.set([isRound ? Math.min(halfX, halfY) : 0, blur], 2 * i);
    });
    this.contacts.end(list.length);
  }

  private dropMerged(): void {
    for (const object of [this.merged, this.points]) {
      if (object !== null) {
        object.geometry.dispose();
        this.scene.remove(object);
      }
    }
    this.merged = this.points = null;
  }

  // the largest solid of each, of few corners
  private makeMerged(): Mesh {
    const corners = this.budget.hasSmoothDiscs
      ? makeDisc(this.budget.mergedSegments)
      : makeCylinder(this.budget.mergedSegments, false);
    const box = makeMesh(MeshKind.Box, 0);
    const meshOf = (solid: Solid): typeof box => (solid.kind === MeshKind.Box ? box : corners);
    let numVertices = 0;
    let numIndices = 0;
    for (const { largest } of this.models) {
      if (largest !== null) {
        numVertices += meshOf(largest).positions.length / 3;
        numIndices += meshOf(largest).indices.length;
      }
    }
    const positions = new Float32Array(3 * numVertices);
    const normals = new Float32Array(3 * numVertices);
    const places = new Uint32Array(3 * numVertices);
    const colors = new Uint8Array(4 * numVertices);
    const indices = new Uint32Array(numIndices);
    const shapes = new Map<Solid, { positions: number[]; normals: number[] }>();
    let vertex = 0;
    let index = 0;
    this.entities.forEach((entity, number) => {
      const solid = this.models[number]!.largest;
      if (solid === null) {
        return;
      }
      const mesh = meshOf(solid);
      let shape = shapes.get(solid);
      if (shape === undefined) {
        shape = placeMesh(mesh, solid);
        shapes.set(solid, shape);
      }
      positions.set(shape.positions, 3 * vertex);
      normals.set(shape.normals, 3 * vertex);
      for (const corner of mesh.indices) {
        indices[index++] = vertex + corner;
      }
      const count = mesh.positions.length / 3;
      for (let i = 0; i < count; ++i, ++vertex) {
        places[3 * vertex] = entity.firstPose + solid.anchor;
        places[3 * vertex + 1] = entity.firstWord;
        places[3 * vertex + 2] = number;
        colors.set(solid.color, 4 * vertex);
      }
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    geometry.setAttribute("inPlace", new BufferAttribute(places, 3));
    geometry.setAttribute("inColor", new BufferAttribute(colors, 4, true));
    geometry.setIndex(new BufferAttribute(indices, 1));
    const merged = new Mesh(geometry, this.mergedMaterial);
    merged.frustumCulled = false;
    merged.renderOrder = 3;
    this.scene.add(merged);
    return merged;
  }

  private makePoints(): void {
    const robots = this.models.flatMap(({ isRobot, max, min }, i) => {
      const { firstPose: pose, firstWord: word } = this.entities[i]!;
      return isRobot ? [{ pose, word, top: max[2], radius: 0.5 * Math.max(max[0] - min[0], max[1] - min[1]) }] : [];
    });
    if (robots.length <= this.budget.pointsByWebGL) {
      this.points = new Points(makePointGeometry(robots), this.pointMaterial);
      this.points.frustumCulled = false;
      this.points.renderOrder = 3;
    } else {
      this.pointPicture ??= new PointPicture(this.uniforms); // its shader is kept when entities change
      this.pointPicture.robots = robots;
      this.points = this.pointPicture.mesh;
    }
    this.points.visible = false;
    this.scene.add(this.points);
  }

  /** Draws the points that WebGL does not draw. */
  drawPoints(scene: PointScene): void {
    if (this.pointPicture !== null && this.points === this.pointPicture.mesh && this.points.visible) {
      this.pointPicture.draw(scene);
    }
  }
}

function makePointGeometry(robots: PointRobot[]): BufferGeometry {
  const positions = new Float32Array(3 * robots.length);
  const places = new Uint32Array(2 * robots.length);
  robots.forEach(({ pose, word, top }, i) => {
    positions[3 * i + 2] = top;
    places.set([pose, word], 2 * i);
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("inPlace", new BufferAttribute(places, 2));
  geometry.setAttribute("inRadius", new BufferAttribute(Float32Array.from(robots, ({ radius }) => radius), 1));
  return geometry;
}

function placeMesh(
  mesh: { positions: number[]; normals: number[] },
  solid: Solid,
): { positions: number[]; normals: number[] } {
  const placed = { positions: [] as number[], normals: [] as number[] };
  const [sx, sy, sz] = solid.size;
  const isCentred = solid.kind === MeshKind.Sphere || solid.kind === MeshKind.Ring;
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const [x, y, z] = mesh.positions.slice(i, i + 3) as unknown as Vector;
    const [nx, ny, nz] = mesh.normals.slice(i, i + 3) as unknown as Vector;
    const local: Vector = [x * sx, y * sy, (isCentred ? z - 0.5 : z) * sz];
    placed.positions.push(...add(solid.position, rotate(solid.orientation, local)));
    placed.normals.push(...rotate(solid.orientation, [nx / sx, ny / sy, nz / sz]));
  }
  return placed;
}
