// The camera: turns around a point of the arena, follows a robot, or looks through its eyes.

import { OrthographicCamera, PerspectiveCamera, Vector3 } from "three";

import type { Vector } from "../decode/types";
import { type Pose, add, clamp, cross, dot, normalize, rotate, scale, subtract } from "./math";

const kFieldOfView = 36; // degrees, vertical
const kEyesFieldOfView = 75;
const kMinElevation = 0.03; // rad
const kTop = Math.PI / 2;
const kToolPixels = 52; // at the upper edge of the picture, which buttons cover

export type CameraMode = "orbit" | "top" | "eyes";

export interface Box {
  min: Vector;
  max: Vector;
}

export class ViewCamera {
  mode: CameraMode = "orbit";
  target: Vector = [0, 0, 0];
  distance = 5;
  azimuth = -kTop; // of the eye, seen from the target, rad
  elevation = (52 / 180) * Math.PI;
  private readonly perspective = new PerspectiveCamera(kFieldOfView, 1, 0.01, 1000);
  private readonly parallel = new OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
  private width = 1;
  private height = 1;
  private eyes: Pose | null = null;
  private home: Box = { min: [-1, -1, 0], max: [1, 1, 0.5] };

  constructor() {
    this.perspective.up.set(0, 0, 1);
  }

  resize(width: number, height: number): void {
    const isFirst = this.width === 1;
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    // where nobody has moved the camera, it goes on showing the whole arena
    if (isFirst || this.key === this.homeKey) {
      this.frameHome();
    }
  }

  private homeKey = "";

  private get key(): string {
    return [...this.target, this.distance, this.azimuth, this.elevation, this.mode].join();
  }

  setHome(box: Box): void {
    this.home = box;
    this.frameHome();
  }

  /** Shows the whole arena. */
  frameHome(): void {
    const { min, max } = this.home;
    this.target = [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1]), 0];
    const aspect = this.width / this.height;
    if (this.mode !== "top") {
      this.azimuth = -kTop;
      this.elevation = (52 / 180) * Math.PI;
    }
    const corners: Vector[] = [];
    const top = Math.min(Math.max(max[2], 0), 0.1 * Math.max(max[0] - min[0], max[1] - min[1]));
    for (let i = 0; i < 8; ++i) {
      corners.push([i & 1 ? max[0] : min[0], i & 2 ? max[1] : min[1], i & 4 ? top : 0]);
    }
    const eye = this.direction();
    const right: Vector = [-Math.sin(this.azimuth), Math.cos(this.azimuth), 0];
    const up = cross(eye, right);
    const slope = Math.tan((kFieldOfView / 360) * Math.PI);
    const free = Math.max(this.height - kToolPixels, 0.5 * this.height) / this.height;
    this.distance = Math.hypot(max[0] - min[0], max[1] - min[1]) + 0.1;
    // centres the corners as they are seen, then takes the least distance that shows all of them
    for (let step = 0; step < 20; ++step) {
      let [left, rightmost, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
      for (const corner of corners) {
        const offset = subtract(corner, this.target);
        const along = this.mode === "top" ? 0 : dot(offset, eye);
        const ahead = Math.max(this.distance - along, 1e-3);
        const across = dot(offset, right) / ahead;
        const above = dot(offset, up) / ahead;
        left = Math.min(left, across);
        rightmost = Math.max(rightmost, across);
        low = Math.min(low, above);
        high = Math.max(high, above);
      }
      const shift = 0.5 * (high + low) * this.distance;
      const ground: Vector = [-Math.cos(this.azimuth), -Math.sin(this.azimuth), 0];
      const steep = this.mode === "top" ? 1 : Math.max(Math.sin(this.elevation), 0.3);
      this.target = add(this.target, scale(ground, shift / steep));
      const needed = Math.max(
        (0.5 * (rightmost - left)) / (slope * aspect),
        (0.5 * (high - low)) / (slope * free),
      );
      this.distance *= needed;
    }
    this.distance *= 1.05;
    this.pan(0, 0.5 * (1 - free) * this.height);
    this.homeKey = this.key;
  }

  setEyes(pose: Pose | null): void {
    this.eyes = pose;
  }

  orbit(dx: number, dy: number): void {
    if (this.mode === "orbit") {
      this.azimuth -= dx * 0.006;
      this.elevation = clamp(this.elevation + dy * 0.006, kMinElevation, kTop - 0.001);
    } else {
      this.pan(dx, dy);
    }
  }

  /** Pixels; the ground follows the pointer. */
  pan(dx: number, dy: number): void {
    const metres = this.metresPerPixel();
    const right: Vector = [-Math.sin(this.azimuth), Math.cos(this.azimuth), 0];
    const ahead: Vector = [-Math.cos(this.azimuth), -Math.sin(this.azimuth), 0];
    const steep = this.mode === "top" ? 1 : Math.max(Math.sin(this.elevation), 0.3);
    this.target = add(this.target, add(scale(right, -dx * metres), scale(ahead, (dy * metres) / steep)));
  }

  /** Factor above 1: nearer; keeps the point of the ground below the pointer where it is. */
  zoom(factor: number, x: number, y: number): void {
    const before = this.groundPoint(x, y);
    this.distance = clamp(this.distance / factor, 0.05, 2000);
    this.update();
    const after = this.groundPoint(x, y);
    if (before !== null && after !== null && this.mode !== "eyes") {
      const shift = subtract(before, after);
      if (Math.hypot(shift[0], shift[1]) < this.distance) {
        this.target = add(this.target, [shift[0], shift[1], 0]);
      }
    }
  }

  metresPerPixel(): number {
    return (2 * this.distance * Math.tan((kFieldOfView / 360) * Math.PI)) / this.height;
  }

  /** Pixels of the picture for a metre at a depth of 1 (perspective) or anywhere (parallel). */
  pixelsPerUnit(height: number): number {
    if (this.mode === "top") {
      return height / (2 * this.distance * Math.tan((kFieldOfView / 360) * Math.PI));
    }
    const angle = this.mode === "eyes" ? kEyesFieldOfView : kFieldOfView;
    return height / (2 * Math.tan((angle / 360) * Math.PI));
  }

  get isParallel(): boolean {
    return this.mode === "top";
  }

  get near(): number {
    return this.perspective.near;
  }

  /** The camera of three.js, at its place. */
  update(): PerspectiveCamera | OrthographicCamera {
    const aspect = this.width / this.height;
    if (this.mode === "top") {
      const half = this.distance * Math.tan((kFieldOfView / 360) * Math.PI);
      const camera = this.parallel;
      camera.left = -half * aspect;
      camera.right = half * aspect;
      camera.top = half;
      camera.bottom = -half;
      camera.near = 0;
      camera.far = 400;
      camera.position.set(this.target[0], this.target[1], 200);
      camera.up.set(-Math.cos(this.azimuth), -Math.sin(this.azimuth), 0);
      camera.lookAt(this.target[0], this.target[1], 0);
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
      return camera;
    }
    const camera = this.perspective;
    camera.aspect = aspect;
    if (this.mode === "eyes" && this.eyes !== null) {
      const { position, orientation } = this.eyes;
      const ahead = add(position, rotate(orientation, [1, 0, -0.12]));
      const up = rotate(orientation, [0, 0, 1]);
      camera.fov = kEyesFieldOfView;
      camera.near = 0.005;
      camera.far = 300;
      camera.position.set(...position);
      camera.up.set(...up);
      camera.lookAt(new Vector3(...ahead));
    } else {
      camera.fov = kFieldOfView;
      camera.near = Math.max(0.004, this.distance * 0.02);
      camera.far = this.distance * 30 + 50;
      camera.position.set(...add(this.target, scale(this.direction(), this.distance)));
      camera.up.set(0, 0, 1);
      camera.lookAt(new Vector3(...this.target));
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  }

  /** The ray through a place of the picture, pixels from its upper left corner. */
  ray(x: number, y: number): { origin: Vector; direction: Vector } {
    const camera = this.update();
    const ndc = [(2 * x) / this.width - 1, 1 - (2 * y) / this.height] as const;
    const near = new Vector3(ndc[0], ndc[1], -1).unproject(camera);
    const far = new Vector3(ndc[0], ndc[1], 1).unproject(camera);
    const origin: Vector = [near.x, near.y, near.z];
    return { origin, direction: normalize(subtract([far.x, far.y, far.z], origin)) };
  }

  /** Where the ground is seen at a place of the picture; null: nowhere. */
  groundPoint(x: number, y: number, height = 0): Vector | null {
    const { origin, direction } = this.ray(x, y);
    if (direction[2] > -1e-6) {
      return null;
    }
    return add(origin, scale(direction, (height - origin[2]) / direction[2]));
  }

  /** The place of a point on the picture, pixels; null: behind the eye. */
  project(point: Vector): { x: number; y: number; depth: number } | null {
    const camera = this.mode === "top" ? this.parallel : this.perspective;
    const v = new Vector3(...point).project(camera);
    if (v.z > 1 || v.z < -1) {
      return null;
    }
    return { x: 0.5 * (v.x + 1) * this.width, y: 0.5 * (1 - v.y) * this.height, depth: v.z };
  }

  private direction(): Vector {
    if (this.mode === "top") {
      return [0, 0, 1];
    }
    const flat = Math.cos(this.elevation);
    return [
      flat * Math.cos(this.azimuth),
      flat * Math.sin(this.azimuth),
      Math.sin(this.elevation),
    ];
  }
}
