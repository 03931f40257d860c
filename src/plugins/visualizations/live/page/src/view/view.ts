// The picture of an experiment: takes states, draws them, and tells what is where.

import {
  Color as ThreeColor,
  Matrix4,
  Mesh,
  NoToneMapping,
  OrthographicCamera,
  Points,
  LinearSRGBColorSpace,
  Scene,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderer,
} from "three";

import type { Frame } from "../decode/frames";
import { RayKind } from "../decode/frames";
import { type Shape, ShapeKind } from "../decode/drawing";
import { type Color, type Entity, TypeKind, type Vector } from "../decode/types";
import { type Box, ViewCamera } from "./camera";
import { compose } from "./compose";
import { EntityDrawer, kGpuBudget, kSoftwareBudget } from "./entities";
import { StateTextures, type Uniforms } from "./gpu";
import { Ground } from "./ground";
import { type Label, LabelCanvas, labelOfShape, makeLabel } from "./labels";
import { type Look, kLightLook } from "./looks";
import { type Dot, DotSet, type Line, LineSet, RingSet, UserDrawing, kWorld } from "./marks";
import {
  type Pose,
  clamp,
  dot,
  jumps,
  roundDown125,
  subtract,
  toLocal,
  toWorld,
  withoutJumps,
} from "./math";
import { type Surface, pixelsOf } from "./surface";

/** What is shown besides the entities. */
export interface ViewOptions {
  rays: boolean;
  devices: boolean;
  drawing: boolean;
  ids: boolean;
  trails: boolean;
  headings: boolean;
  axes: boolean;
  scaleBar: boolean;
  grid: boolean;
  /** In saved pictures and films. */
  clock: boolean;
}

export const kDefaultOptions: Readonly<ViewOptions> = {
  rays: true,
  devices: true,
  drawing: true,
  ids: false,
  trails: false,
  headings: false,
  axes: false,
  scaleBar: true,
  grid: true,
  clock: true,
};

const kFreeRay: Color = [36, 122, 196, 170];
const kObstructedRay: Color = [214, 52, 58, 230];
const kHitPoint: Color = [232, 40, 34, 255];
const kHeading: Color = [220, 38, 38, 255];
const kMaxIds = 400;
const kMaxTrailParts = 24_000;
const kTrailStates = 200;
const kChoicePeriod = 250; // ms
const kMinPixelShare = 0.4;
const kPickPixels = 9;
const kMaxHovered = 5000;

export class View {
  readonly camera = new ViewCamera();
  readonly isSoftware: boolean;
  readonly rendererName: string;
  options: ViewOptions = { ...kDefaultOptions };
  frame: Frame | null = null;
  /** Entities with a ring, the first one brightest. */
  selected: number[] = [];
  hovered = -1;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly textures: StateTextures;
  private readonly uniforms: Uniforms;
  private readonly entityDrawer: EntityDrawer;
  private readonly userDrawing: UserDrawing;
  private readonly rayLines: LineSet;
  private readonly deviceLines: LineSet;
  private readonly deviceDots: DotSet;
  private readonly extraLines: LineSet;
  private readonly trailLines: LineSet;
  private readonly hits: DotSet;
  private readonly rings: RingSet;
  private readonly labels: LabelCanvas;
  private readonly ground: Ground;
  private look: Look = kLightLook;
  private arena: Box = { min: [-1, -1, 0], max: [1, 1, 1] };
  private drawing: Shape[] | null = null;
  private version = -1;
  private fromPoses = new Float64Array(0);
  private toPoses = new Float64Array(0);
  private blend = 1;
  private lastChoice = 0;
  private trails = new Map<string, Vector[]>();
  private hasExtras = false;

  private readonly canvas: HTMLCanvasElement;

  constructor(
    { canvas, gl, rendererName, isSoftware }: Surface,
    labelCanvas: HTMLCanvasElement,
  ) {
    if (gl === null) {
      throw new Error("The picture needs WebGL 2, which this browser does not have, or which is switched off in it.");
    }
    this.canvas = canvas;
    this.rendererName = rendererName;
    this.isSoftware = isSoftware;
    this.renderer = new WebGLRenderer({ canvas, context: gl });
    this.renderer.outputColorSpace = LinearSRGBColorSpace; // the shaders encode it themselves
    this.renderer.toneMapping = NoToneMapping;
    this.renderer.autoClear = false;
    this.textures = new StateTextures(this.isSoftware);
    this.uniforms = this.makeUniforms();
    this.entityDrawer = new EntityDrawer(
      this.uniforms,
      this.isSoftware ? kSoftwareBudget : kGpuBudget,
      (isNear) => this.textures.setNear(isNear),
    );
    this.userDrawing = new UserDrawing(this.uniforms);
    this.rayLines = new LineSet(this.uniforms);
    this.deviceLines = new LineSet(this.uniforms, 9);
    this.deviceDots = new DotSet(this.uniforms);
    this.extraLines = new LineSet(this.uniforms, 10, false);
    this.trailLines = new LineSet(this.uniforms, 6);
    this.hits = new DotSet(this.uniforms);
    this.rings = new RingSet(this.uniforms);
    this.labels = new LabelCanvas(labelCanvas, isSoftware);
    this.ground = new Ground(this.uniforms, isSoftware);
    this.scene.add(this.ground.mesh, this.entityDrawer.scene, this.userDrawing.scene);
    this.scene.add(this.rayLines.batch.mesh, this.extraLines.batch.mesh);
    this.scene.add(this.deviceLines.batch.mesh, this.deviceDots.batch.mesh);
    this.scene.add(this.trailLines.batch.mesh, this.hits.batch.mesh, this.rings.batch.mesh);
    this.setLook(kLightLook);
    this.resize(); // which would wait for what is compiled
    this.compileFirst();
  }

  // what each picture needs, while the first state is on its way
  private compileFirst(): void {
    for (const mesh of [this.ground.mesh, this.extraLines.batch.mesh]) {
      this.renderer.compile(mesh, this.camera.update(), this.scene);
    }
  }

  get counts(): { near: number; merged: number; points: number } {
    return this.entityDrawer.counts;
  }

  setLook(look: Look): void {
    ++this.changes;
    this.look = look;
    const u = this.uniforms;
    const linear = (hex: string): Vector3 => {
      const color = new ThreeColor(hex); // three.js decodes it to linear light
      return new Vector3(color.r, color.g, color.b);
    };
    const marker = new ThreeColor().setStyle(look.marker, LinearSRGBColorSpace);
    u.uMarker!.value = new Vector3(marker.r, marker.g, marker.b);
    this.ground.setLook(look);
    u.uSkyLight!.value = linear(look.sky);
    u.uBounceLight!.value = linear(look.bounce);
    u.uSunIntensity!.value = look.sun;
    u.uAmbientIntensity!.value = look.ambient;
    u.uSpecularIntensity!.value = look.specular;
    u.uEdgeDarkening!.value = look.edges;
    u.uContactDarkening!.value = look.contact;
    u.uHaloStrength!.value = look.haloStrength;
    u.uHaloOpacity!.value = look.haloOpacity;
    this.renderer.setClearColor(new ThreeColor().setStyle(look.background, LinearSRGBColorSpace), 1);
    this.hasExtras = false;
  }

  setArena(arena: Box): void {
    ++this.changes;
    this.arena = arena;
    this.camera.setHome(arena);
    this.ground.setArena(arena);
    this.hasExtras = false;
  }

  get arenaBox(): Box {
    return this.arena;
  }

  /** The next state; the picture moves to it as blend goes from 0 to 1. */
  push(frame: Frame): void {
    this.show(frame, false);
  }

  /** A state without movement to it. */
  jump(frame: Frame): void {
    this.trails.clear();
    this.show(frame, true);
    this.blend = 1;
  }

  setBlend(blend: number): void {
    this.blend = clamp(blend, 0, 1);
  }

  optionsChanged(): void {
    ++this.changes;
    this.hasExtras = false;
    this.drawing = null;
    if (this.frame !== null) {
      this.showMarks(this.frame);
    }
    if (!this.options.trails) {
      this.trails.clear();
      this.trailLines.set([]);
    }
  }

  /** Numbers of the entity's pose, blended as in the picture. */
  poseOf(entity: number, anchor = 0): Pose {
    return this.poseNumber(this.entityDrawer.entities[entity]!.firstPose + anchor);
  }

  entity(number: number): Entity | undefined {
    return this.entityDrawer.entities[number];
  }

  find(id: string): number {
    return this.entityDrawer.entities.findIndex((entity) => entity.id === id);
  }

  private poseNumber(number: number): Pose {
    const at = 7 * number;
    const to = this.toPoses;
    const from = this.fromPoses;
    const position: number[] = [];
    for (let i = 0; i < 3; ++i) {
      const before = from[at + i] ?? to[at + i] ?? 0;
      position.push(before + this.blend * ((to[at + i] ?? 0) - before));
    }
    let sign = 0;
    for (let i = 3; i < 7; ++i) {
      sign += (from[at + i] ?? 0) * (to[at + i] ?? 0);
    }
    const q: number[] = [];
    for (let i = 3; i < 7; ++i) {
      const before = (sign < 0 ? -1 : 1) * (from[at + i] ?? to[at + i] ?? 0);
      q.push(before + this.blend * ((to[at + i] ?? 0) - before));
    }
    const norm = Math.hypot(...q) || 1;
    return {
      position: [position[0]!, position[1]!, position[2]!],
      orientation: [q[0]! / norm, q[1]! / norm, q[2]! / norm, q[3]! / norm],
    };
  }

  /** Half the largest extent of an entity across the ground, m. */
  radiusOf(entity: number): number {
    const { min, max } = this.entityDrawer.models[entity]!;
    return 0.5 * Math.hypot(max[0] - min[0], max[1] - min[1]) * 0.75;
  }

  topOf(entity: number): number {
    return this.entityDrawer.models[entity]!.max[2];
  }

  /** The entity below the mouse; of very many, none, because it is looked for at each movement. */
  hover(x: number, y: number): void {
    const isFew = this.entityDrawer.entities.length <= kMaxHovered;
    this.hovered = isFew ? this.pick(x, y) : -1;
  }

  /** The nearest entity at a place of the picture, pixels; -1: none. */
  pick(x: number, y: number): number {
    const { origin, direction } = this.camera.ray(x, y);
    let found = -1;
    let nearest = Infinity;
    const perUnit = this.camera.pixelsPerUnit(this.canvas.clientHeight);
    this.entityDrawer.entities.forEach((entity, i) => {
      if (entity.type.kind === TypeKind.Floor || entity.type.kind === TypeKind.Other) {
        return;
      }
      const model = this.entityDrawer.models[i]!;
      const pose = this.poseOf(i);
      const away = dot(subtract(pose.position, origin), direction);
      const depth = this.camera.isParallel ? 1 : Math.max(away, 1e-3);
      const margin = model.isRobot ? (kPickPixels * depth) / perUnit : 0;
      const start = toLocal(pose, origin);
      const ahead = subtract(toLocal(pose, [origin[0] + direction[0], origin[1] + direction[1], origin[2] + direction[2]]), start);
      const half = Math.max(model.max[0] - model.min[0], model.max[1] - model.min[1]) / 2;
      const grow = Math.max(0, margin - half);
      const hit = hitBox(start, ahead, model.min, model.max, grow);
      if (hit !== null && hit < nearest) {
        nearest = hit;
        found = i;
      }
    });
    return found;
  }

  /** Whether the picture has fewer pixels than its place. */
  isReduced = false;
  private pixelShare = 1;

  /** Draws fewer pixels from now on. Returns false if there is no more to save. */
  reduce(): boolean {
    if (!this.isSoftware || this.pixelShare <= kMinPixelShare) {
      return false;
    }
    this.pixelShare *= 0.7;
    this.resize();
    return true;
  }

  resize(): void {
    ++this.changes; // a canvas with another size is empty
    const { clientWidth, clientHeight } = this.canvas;
    const [width, height] = pixelsOf(this.canvas, this.isSoftware, this.pixelShare);
    this.isReduced = this.isSoftware && width * height < clientWidth * clientHeight;
    // a canvas gets new memory even for the size that it has
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.renderer.setSize(width, height, false);
    }
    this.camera.resize(Math.max(1, clientWidth), Math.max(1, clientHeight));
  }

  /** Draws, if the picture would be another one. Returns whether it has drawn. */
  render(now: number): boolean {
    if (!this.needsPicture(now)) {
      return false;
    }
    if (this.frame === null) {
      return false;
    }
    const size = this.renderer.getSize(new Vector2());
    const u = this.uniforms;
    this.placeCamera();
    const camera = this.camera.update();
    const perUnit = this.camera.pixelsPerUnit(size.y);
    const scale = size.y / this.canvas.clientHeight;
    u.uPixelsPerUnit!.value = perUnit;
    u.uPixelScale!.value = Math.max(scale, 0.75);
    u.uSignalPixels!.value = 4.4;
    u.uPictureSize!.value.set(size.x, size.y);
    u.uNear!.value = this.camera.isParallel ? -1e9 : this.camera.near;
    this.textures.setBlend(this.blend);
    u.uGridStrength!.value = this.options.grid ? 1 : 0;
    u.uGridSpacing!.value = 10 ** Math.round(Math.log10(this.camera.distance / 10));
    const eye = camera.position;
    if (this.camera.isParallel) {
      u.uEye!.value.set(0, 0, 1, 0);
    } else {
      u.uEye!.value.set(eye.x, eye.y, eye.z, 1);
    }
    const toSun = u.uToSun!.value as Vector3;
    u.uToSunInView!.value.copy(toSun).transformDirection(camera.matrixWorldInverse);
    if (now - this.lastChoice > kChoicePeriod) {
      this.lastChoice = now;
      this.hasChosen = true;
      this.chooseNear(camera.matrixWorldInverse, size);
    }
    this.updateExtras();
    this.updateRings();
    this.drawShadows();
    this.entityDrawer.drawPoints({
      ...{ camera, size, poses: this.textures.poses, words: this.textures.wordsOfState },
      ...{ pixelsPerUnit: perUnit, pixels: 3 * Math.max(scale, 0.75), farthest: this.farthest(eye) },
    });
    this.renderer.clear();
    this.renderer.render(this.scene, camera);
    this.canvas.classList.add("is-drawn");
    this.drawLabels();
    return true;
  }

  // from the camera to a corner of the arena
  private farthest({ x, y, z }: Vector3): number {
    const { min, max } = this.arena;
    const along = (at: number, i: number): number => Math.max(Math.abs(at - min[i]!), Math.abs(at - max[i]!));
    return Math.hypot(along(x, 0), along(y, 1), along(z, 2));
  }

  private pictureKey = "";
  private changes = 0;

  // a picture that would be the same is not drawn
  private needsPicture(now: number): boolean {
    const { target, distance, azimuth, elevation, mode } = this.camera;
    const parts = [
      ...[this.changes, this.blend, mode, ...target, distance, azimuth, elevation, this.followed],
      ...[this.hovered, ...this.selected, this.canvas.clientWidth, this.canvas.clientHeight],
      ...[this.canvas.width, window.devicePixelRatio],
    ];
    const key = parts.join();
    const isSame = key === this.pictureKey && now - this.lastChoice < 4 * kChoicePeriod;
    const isChosen = this.hasChosen;
    this.pictureKey = key;
    return !isSame || !isChosen;
  }

  private hasChosen = false;

  /** The picture as WebGL has drawn it or, with its texts, as large as on the screen. */
  capture(withLabels: boolean, clock = ""): HTMLCanvasElement {
    ++this.changes;
    this.render(performance.now());
    const picture = document.createElement("canvas");
    if (withLabels) {
      [picture.width, picture.height] = this.sizeOnScreen;
      this.copyTo(picture, clock);
    } else {
      picture.width = this.canvas.width;
      picture.height = this.canvas.height;
      picture.getContext("2d")!.drawImage(this.canvas, 0, 0);
    }
    return picture;
  }

  /** Pixels of the screen that the picture takes, even numbers for encoders of films. */
  get sizeOnScreen(): [number, number] {
    const even = (length: number): number => Math.max(2, 2 * Math.round(0.5 * length * window.devicePixelRatio));
    return [even(this.canvas.clientWidth), even(this.canvas.clientHeight)];
  }

  /** Draws the picture with its texts over a canvas. Only after render() in the same task: then the browser shows and drops it. */
  copyTo(target: HTMLCanvasElement, clock: string): void {
    compose(target, this.canvas, this.labels, this.look, clock);
  }

  private show(frame: Frame, isJump: boolean): void {
    ++this.changes;
    const isChanged = frame.entitiesVersion !== this.version || this.frame === null;
    this.frame = frame;
    if (isChanged) {
      this.version = frame.entitiesVersion;
      this.entityDrawer.setEntities(frame.entities, frame.words.length);
      this.lastChoice = 0;
      this.hasExtras = false;
    }
    const words = this.entityDrawer.signalWords(frame.words);
    const last = this.toPoses;
    this.toPoses = frame.poses.slice();
    const isNew = isChanged || isJump || last.length !== this.toPoses.length;
    this.fromPoses = isNew ? this.toPoses : withoutJumps(last, this.toPoses, this.arena);
    if (this.fromPoses !== last) {
      this.textures.push(this.fromPoses, words);
    }
    this.textures.push(this.toPoses, words);
    this.blend = 0;
    this.ground.setFloor(frame.floor);
    this.showMarks(frame);
    if (this.options.trails) {
      this.addTrails();
    }
    if (isChanged) {
      this.choose();
      this.compileShaders();
    }
  }

  // before shaders are compiled, which then are those of the next picture
  private choose(): void {
    const size = this.renderer.getSize(new Vector2());
    this.placeCamera();
    const camera = this.camera.update();
    this.uniforms.uPixelsPerUnit!.value = this.camera.pixelsPerUnit(size.y);
    this.chooseNear(camera.matrixWorldInverse, size);
  }

  // all at once, and while the page does other things: when the first picture is drawn, each would be waited for
  private compileShaders(): void {
    this.scene.traverseVisible((object) => {
      if (object instanceof Mesh || object instanceof Points) {
        this.renderer.compile(object, this.camera.update(), this.scene);
      }
    });
  }

  private showMarks(frame: Frame): void {
    if (frame.drawing !== this.drawing) {
      this.drawing = frame.drawing;
      this.userDrawing.set(this.options.drawing ? frame.drawing : []);
    }
    if (!this.options.rays || frame.rays.count === 0) {
      if (this.rayLines.batch.length > 0 || this.hits.batch.length > 0) {
        this.rayLines.set([]);
        this.hits.set([]);
      }
      return;
    }
    // Rays are in the frames of their robots, and move with them from state to state.
    const lines: Line[] = [];
    const dots: Dot[] = [];
    const { rays } = frame;
    const blend = this.blend;
    this.blend = 1;
    let robot = -1;
    let pose: Pose = { position: [0, 0, 0], orientation: [1, 0, 0, 0] };
    for (let i = 0; i < rays.count; ++i) {
      const firstPose = frame.entities[rays.robots[i]!]!.firstPose;
      if (rays.robots[i] !== robot) {
        robot = rays.robots[i]!;
        pose = this.poseNumber(firstPose);
      }
      const at = 6 * i;
      const start = toLocal(pose, [rays.ends[at]!, rays.ends[at + 1]!, rays.ends[at + 2]!]);
      if (rays.kinds[i] === RayKind.HitPoint) {
        dots.push({ pose: firstPose, position: start, color: kHitPoint, radius: 0.004, pixels: 0 });
        continue;
      }
      const end = toLocal(pose, [rays.ends[at + 3]!, rays.ends[at + 4]!, rays.ends[at + 5]!]);
      const color = rays.kinds[i] === RayKind.Obstructed ? kObstructedRay : kFreeRay;
      lines.push({ pose: firstPose, start, end, color, width: 1.4 });
    }
    this.blend = blend;
    cutAtHits(lines, dots);
    this.rayLines.set(lines);
    this.hits.set(dots);
  }

  private addTrails(): void {
    const robots = this.entityDrawer.models.flatMap((model, i) => (model.isRobot ? [i] : []));
    const states = Math.min(kTrailStates, Math.floor(kMaxTrailParts / Math.max(robots.length, 1)));
    if (states < 2) {
      return;
    }
    const lines: Line[] = [];
    const [r, g, b] = hexColor(this.look.marker);
    for (const i of robots) {
      const { id, firstPose } = this.entityDrawer.entities[i]!;
      const at = 7 * firstPose;
      const place: Vector = [this.toPoses[at]!, this.toPoses[at + 1]!, this.toPoses[at + 2]! + 0.003];
      const trail = this.trails.get(id) ?? [];
      trail.push(place);
      if (trail.length > states) {
        trail.shift();
      }
      this.trails.set(id, trail);
      for (let k = 1; k < trail.length; ++k) {
        if (jumps(trail[k - 1]!, trail[k]!, this.arena)) {
          continue;
        }
        const alpha = Math.round((220 * (k + states - trail.length)) / states);
        lines.push({
          pose: kWorld,
          start: trail[k - 1]!,
          end: trail[k]!,
          color: [r, g, b, alpha],
          width: 1.6,
        });
      }
    }
    this.trailLines.set(lines);
  }

  // headings, axes and scale bar: lines that change with the entities or the arena
  private updateExtras(): void {
    if (this.hasExtras) {
      return;
    }
    this.hasExtras = true;
    const lines: Line[] = [];
    if (this.options.headings) {
      this.entityDrawer.models.forEach((model, i) => {
        if (model.isRobot) {
          const pose = this.entityDrawer.entities[i]!.firstPose;
          const length = Math.max(model.max[0] - model.min[0], model.max[1] - model.min[1]);
          const z = model.max[2] + 0.001;
          const arrow = (start: Vector, end: Vector): void => {
            lines.push({ pose, start, end, color: kHeading, width: 2 });
          };
          arrow([0, 0, z], [length, 0, z]);
          arrow([length, 0, z], [0.72 * length, 0.14 * length, z]);
          arrow([length, 0, z], [0.72 * length, -0.14 * length, z]);
        }
      });
    }
    const color = hexColor(this.look.text);
    const line = (start: Vector, end: Vector, width: number): void => {
      lines.push({ pose: kWorld, start, end, color, width });
    };
    const { min, max } = this.arena;
    const least = Math.min(max[0] - min[0], max[1] - min[1]);
    if (this.options.scaleBar) {
      const { start, end, serif } = this.scaleBar();
      line(start, end, 2.5);
      for (const tip of [start, end]) {
        line([tip[0], tip[1] - serif, 0], [tip[0], tip[1] + serif, 0], 2.5);
      }
    }
    if (this.options.axes) {
      line([min[0], min[1], 0], [max[0], min[1], 0], 1.5);
      line([min[0], min[1], 0], [min[0], max[1], 0], 1.5);
      const tick = 0.015 * least;
      for (const x of this.axisNumbers(0)) {
        line([x, min[1], 0], [x, min[1] - tick, 0], 1.5);
      }
      for (const y of this.axisNumbers(1)) {
        line([min[0], y, 0], [min[0] - tick, y, 0], 1.5);
      }
    }
    this.extraLines.set(lines);
  }

  private scaleBar(): { start: Vector; end: Vector; serif: number; length: number } {
    const { min, max } = this.arena;
    const margin = 0.05 * Math.min(max[0] - min[0], max[1] - min[1]);
    const length = roundDown125(0.25 * (max[0] - min[0]));
    const start: Vector = [min[0] + margin, min[1] + margin, 0];
    return { start, end: [start[0] + length, start[1], 0], serif: 0.25 * margin, length };
  }

  private axisNumbers(axis: 0 | 1): number[] {
    const { min, max } = this.arena;
    const step = roundDown125(Math.max(max[0] - min[0], max[1] - min[1]) / 8);
    const numbers: number[] = [];
    for (let i = Math.ceil(min[axis] / step - 1e-6); i * step <= max[axis] + 1e-6 * step; ++i) {
      numbers.push(i * step);
    }
    return numbers;
  }

  /** What sensors perceive, in the frames of their robots. */
  setDevices(lines: Line[], dots: Dot[]): void {
    if (lines.length > 0 || this.deviceLines.batch.length > 0) {
      this.deviceLines.set(lines);
      this.deviceDots.set(dots);
      ++this.changes;
    }
  }

  private updateRings(): void {
    const accent = hexColor(this.look.accent);
    const rings = this.selected
      .filter((number) => number < this.entityDrawer.entities.length)
      .map((number) => ({
        pose: this.entityDrawer.entities[number]!.firstPose,
        radius: 1.5 * this.radiusOf(number),
        color: accent,
      }));
    if (
      this.hovered >= 0 &&
      this.hovered < this.entityDrawer.entities.length &&
      !this.selected.includes(this.hovered)
    ) {
      rings.push({
        pose: this.entityDrawer.entities[this.hovered]!.firstPose,
        radius: 1.5 * this.radiusOf(this.hovered),
        color: [accent[0], accent[1], accent[2], 130],
      });
    }
    if (rings.length > 0 || this.rings.batch.length > 0) {
      this.rings.set(rings);
    }
  }

  /** The entity that the camera follows, or through whose eyes it looks; -1: none. */
  followed = -1;

  private placeCamera(): void {
    if (this.followed >= this.entityDrawer.entities.length) {
      this.followed = -1;
    }
    if (this.followed < 0) {
      return;
    }
    const pose = this.poseOf(this.followed);
    if (this.camera.mode === "eyes") {
      const { max } = this.entityDrawer.models[this.followed]!;
      const position = toWorld(pose, [0.6 * max[0], 0, Math.max(max[2], 0.03) * 1.15]);
      this.camera.setEyes({ position, orientation: pose.orientation });
    } else {
      this.camera.target = [pose.position[0], pose.position[1], pose.position[2]];
    }
  }

  private chooseNear(toCamera: Matrix4, size: Vector2): void {
    const e = toCamera.elements;
    const perUnit = this.uniforms.uPixelsPerUnit!.value as number;
    const { isParallel } = this.camera;
    const halfX = (0.5 * size.x) / perUnit;
    const halfY = (0.5 * size.y) / perUnit;
    this.entityDrawer.chooseNear((number) => {
      const at = 7 * this.entityDrawer.entities[number]!.firstPose;
      const x = this.toPoses[at]!;
      const y = this.toPoses[at + 1]!;
      const z = this.toPoses[at + 2]!;
      const depth = -(e[2]! * x + e[6]! * y + e[10]! * z + e[14]!);
      const w = isParallel ? 1 : depth;
      const radius = this.radiusOf(number);
      if (!isParallel && depth < -radius) {
        return 0;
      }
      const across = Math.abs(e[0]! * x + e[4]! * y + e[8]! * z + e[12]!);
      const above = Math.abs(e[1]! * x + e[5]! * y + e[9]! * z + e[13]!);
      if (across > halfX * w + radius || above > halfY * w + radius) {
        return 0;
      }
      return (2 * radius * perUnit) / Math.max(w, 1e-3);
    });
  }

  private drawShadows(): void {
    if (this.isSoftware) {
      return;
    }
    const { min, max } = this.arena;
    const arenaRadius = 0.55 * Math.hypot(max[0] - min[0], max[1] - min[1]);
    const { target, distance, mode } = this.camera;
    const radius = Math.max(0.3, Math.min(arenaRadius, mode === "eyes" ? 4 : 1.1 * distance));
    const isWhole = radius >= arenaRadius;
    const center: Vector = isWhole
      ? [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1]), 0]
      : this.followed >= 0
        ? this.poseOf(this.followed).position
        : target;
    const toSun = this.uniforms.uToSun!.value as Vector3;
    const far = 4 * radius + 20;
    const sun = new OrthographicCamera(-radius, radius, radius, -radius, 0, 2 * far);
    sun.up.set(0, 1, 0);
    sun.position.set(...center).addScaledVector(toSun, far);
    sun.lookAt(new Vector3(...center));
    sun.updateMatrixWorld();
    sun.updateProjectionMatrix();
    const matrix = new Matrix4().set(0.5, 0, 0, 0.5, 0, 0.5, 0, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0, 1);
    matrix.multiply(sun.projectionMatrix).multiply(sun.matrixWorldInverse);
    this.uniforms.uWorldToShadow!.value = matrix;
    this.uniforms.uShadowOffset!.value = (1.5 * 2 * radius) / 2048;
    this.entityDrawer.drawShadows(this.renderer, sun);
  }

  private drawLabels(): void {
    const labels: Label[] = [];
    const { options, frame } = this;
    if (options.ids) {
      this.addIds(labels);
    } else {
      for (const number of this.selected) {
        this.addId(labels, number);
      }
      if (this.hovered >= 0 && !this.selected.includes(this.hovered)) {
        this.addId(labels, this.hovered);
      }
    }
    if (options.scaleBar) {
      const { start, end, serif, length } = this.scaleBar();
      const text = length >= 1 ? `${length} m` : `${+(100 * length).toPrecision(3)} cm`;
      labels.push(makeLabel([0.5 * (start[0] + end[0]), start[1] + 1.5 * serif, 0], text, { above: 2 }));
    }
    if (options.axes) {
      const { min, max } = this.arena;
      const away = 0.035 * Math.min(max[0] - min[0], max[1] - min[1]);
      for (const x of this.axisNumbers(0)) {
        labels.push(makeLabel([x, min[1] - away, 0], `${+x.toPrecision(6)}`, { above: -4 }));
      }
      for (const y of this.axisNumbers(1)) {
        labels.push(makeLabel([min[0] - away, y, 0], `${+y.toPrecision(6)}`, { above: -4 }));
      }
    }
    let overlay: Shape[] = [];
    if (options.drawing && frame !== null) {
      for (const shape of frame.drawing) {
        if (shape.kind === ShapeKind.Text && !shape.isOverlay) {
          labels.push(labelOfShape(shape));
        }
      }
      overlay = frame.drawing.filter((shape) => shape.isOverlay);
    }
    this.labels.draw(labels, overlay, this.look, (point) => this.camera.project(point), this.canvas);
  }

  private addId(labels: Label[], number: number): void {
    const entity = this.entityDrawer.entities[number];
    if (entity === undefined || entity.type.kind === TypeKind.Floor) {
      return;
    }
    const { position } = this.poseOf(number);
    const top: Vector = [position[0], position[1], position[2] + this.topOf(number)];
    labels.push(makeLabel(top, entity.id, { above: 6, weight: "600" }));
  }

  private addIds(labels: Label[]): void {
    const { clientWidth, clientHeight } = this.canvas;
    const { entities, models } = this.entityDrawer;
    for (let i = 0; i < entities.length && labels.length < kMaxIds; ++i) {
      if (models[i]!.isRobot) {
        const place = this.camera.project(this.poseOf(i).position);
        if (
          place !== null &&
          place.x > 0 &&
          place.x < clientWidth &&
          place.y > 0 &&
          place.y < clientHeight
        ) {
          this.addId(labels, i);
        }
      }
    }
  }

  private makeUniforms(): Uniforms {
    const uniforms: Uniforms = { ...this.textures.uniforms };
    const add = (name: string, value: unknown): void => {
      uniforms[name] = { value };
    };
    add("uToSun", new Vector3(-0.42, -0.38, 0.95).normalize());
    add("uToSunInView", new Vector3(0, 0, 1));
    add("uEye", new Vector4());
    add("uPictureSize", new Vector2(1, 1));
    add("uWorldToShadow", new Matrix4());
    add("uGridStrength", 1);
    add("uGridSpacing", 1);
    add("uMarker", new Vector3());
    for (const name of [
      ...["uSkyLight"],
      ...["uBounceLight", "uSunIntensity", "uAmbientIntensity", "uSpecularIntensity"],
      ...["uEdgeDarkening", "uContactDarkening", "uHaloStrength", "uHaloOpacity", "uNear"],
      ...["uPixelsPerUnit", "uPixelScale", "uSignalPixels", "uArenaMin", "uArenaMax"],
      ...["uFadeLength", "uFloor", "uFloorSize", "uShadowMap", "uShadowTexel"],
      ...["uShadowOffset"],
    ]) {
      add(name, 0);
    }
    for (const name of ["uArenaMin", "uArenaMax", "uFloorSize"]) {
      add(name, new Vector2(1, 1));
    }
    add("uFloor", null);
    add("uShadowMap", null);
    return uniforms;
  }
}

// sensors record hits in the order of their rays, but not one for each
function cutAtHits(lines: Line[], dots: Dot[]): void {
  let next = 0;
  for (const line of lines) {
    while (next < dots.length && dots[next]!.pose < line.pose) {
      ++next;
    }
    const hit = dots[next];
    if (line.color === kObstructedRay && hit !== undefined && hit.pose === line.pose) {
      const along = subtract(line.end, line.start);
      const length = Math.hypot(...along);
      const offset = subtract(hit.position, line.start);
      const reach = dot(offset, along) / (length || 1);
      const aside = Math.sqrt(Math.max(dot(offset, offset) - reach * reach, 0));
      if (aside < 1e-5 && reach > -1e-5 && reach < length + 1e-5) {
        line.end = hit.position;
        ++next;
      }
    }
  }
}

function hitBox(
  start: Vector,
  ahead: Vector,
  min: Vector,
  max: Vector,
  grow: number,
): number | null {
  let near = -Infinity;
  let far = Infinity;
  for (let axis = 0; axis < 3; ++axis) {
    const low = min[axis]! - grow - start[axis]!;
    const high = max[axis]! + grow - start[axis]!;
    const step = ahead[axis]!;
    if (Math.abs(step) < 1e-12) {
      if (low > 0 || high < 0) {
        return null;
      }
      continue;
    }
    near = Math.max(near, Math.min(low / step, high / step));
    far = Math.min(far, Math.max(low / step, high / step));
  }
  return near <= far && far > 0 ? Math.max(near, 0) : null;
}

export function hexColor(hex: string): Color {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255, 255];
}
