// Many robots as points, drawn into a picture here instead of by WebGL, which takes 3 us for each where the processor draws.

import {
  type Camera,
  DataTexture,
  Matrix4,
  Mesh,
  NearestFilter,
  RedIntegerFormat,
  UnsignedShortType,
} from "three";

import { type Uniforms, makeMaterial, makeQuad } from "./gpu";
import { kPointPictureFragment, kPointPictureVertex } from "./shaders";

/** A robot: numbers of its pose and of its word of flags, height of its top, and radius (m). */
export interface PointRobot {
  pose: number;
  word: number;
  top: number;
  radius: number;
}

/** What is drawn, from where. */
export interface PointScene {
  camera: Camera;
  size: { x: number; y: number };
  /** Eight numbers for each pose, of which three are its position. */
  poses: Float32Array;
  words: Uint32Array;
  pixelsPerUnit: number;
  /** Least diameter of a point. */
  pixels: number;
  /** Distance from the camera of the farthest robot (m); what is farther counts as being there. */
  farthest: number;
}

const kNone = 0xffffffff;
const kMostSteps = 32_767;

/**
 * The picture has a number for each pixel: 0 for nothing, else twice the distance from the camera in steps, and 1 for robots in
 * quarantine. The shader makes the pixel's depth and colour of it.
 */
export class PointPicture {
  readonly mesh: Mesh;
  robots: PointRobot[] = [];
  private readonly uniforms: Uniforms;
  private picture: Uint16Array = new Uint16Array(1);
  private texture: DataTexture | null = null;
  private readonly toPicture = new Matrix4();

  constructor(shared: Uniforms) {
    this.uniforms = { ...shared, uPicture: { value: null }, uStep: { value: 1 } };
    const material = makeMaterial(kPointPictureVertex, kPointPictureFragment, this.uniforms);
    this.mesh = new Mesh(makeQuad(), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 3;
  }

  draw(scene: PointScene): void {
    const { camera, size, poses, words, farthest } = scene;
    const [width, height] = [size.x, size.y];
    if (this.texture === null || this.texture.image.width !== width || this.texture.image.height !== height) {
      this.texture?.dispose();
      this.picture = new Uint16Array(width * height);
      this.texture = new DataTexture(this.picture, width, height, RedIntegerFormat, UnsignedShortType);
      this.texture.internalFormat = "R16UI";
      this.texture.magFilter = this.texture.minFilter = NearestFilter;
      this.uniforms.uPicture!.value = this.texture;
    }
    const { picture } = this;
    picture.fill(0);
    const view = camera.matrixWorldInverse.elements;
    const m = this.toPicture.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    const step = farthest / kMostSteps;
    const leastRadius = 0.5 * scene.pixels;
    for (const { pose, word, top, radius } of this.robots) {
      const place = 8 * pose;
      const x = pose === kNone ? 0 : poses[place]!;
      const y = pose === kNone ? 0 : poses[place + 1]!;
      const z = (pose === kNone ? 0 : poses[place + 2]!) + top;
      const w = m[3]! * x + m[7]! * y + m[11]! * z + m[15]!;
      const away = -(view[2]! * x + view[6]! * y + view[10]! * z + view[14]!);
      if (!(w > 0 && away > 0)) {
        continue;
      }
      const steps = Math.min(Math.ceil(away / step), kMostSteps);
      const pixel = 2 * steps + (word === kNone ? 0 : words[word]! & 1);
      const pointRadius = Math.max((radius * scene.pixelsPerUnit) / w, leastRadius);
      const square = pointRadius * pointRadius;
      // of the first pixel's middle
      const atX = (0.5 * (m[0]! * x + m[4]! * y + m[8]! * z + m[12]!) / w + 0.5) * width - 0.5;
      const atY = (0.5 * (m[1]! * x + m[5]! * y + m[9]! * z + m[13]!) / w + 0.5) * height - 0.5;
      const lastX = Math.min(Math.floor(atX + pointRadius), width - 1);
      const lastY = Math.min(Math.floor(atY + pointRadius), height - 1);
      for (let row = Math.max(Math.ceil(atY - pointRadius), 0); row <= lastY; ++row) {
        const left = square - (row - atY) * (row - atY);
        for (let column = Math.max(Math.ceil(atX - pointRadius), 0); column <= lastX; ++column) {
          const i = row * width + column;
          const before = picture[i]!;
          if ((column - atX) * (column - atX) <= left && (before === 0 || before >> 1 > steps)) {
            picture[i] = pixel;
          }
        }
      }
    }
    this.texture.needsUpdate = true;
    this.uniforms.uStep!.value = step;
  }
}
