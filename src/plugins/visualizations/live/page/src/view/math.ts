// Vectors and quaternions (w, x, y, z) as plain numbers.

import type { Quaternion, Vector } from "../decode/types";

export function add(a: Vector, b: Vector): Vector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scale(a: Vector, factor: number): Vector {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function normalize(a: Vector): Vector {
  return scale(a, 1 / (Math.hypot(a[0], a[1], a[2]) || 1));
}

export function rotate(q: Quaternion, v: Vector): Vector {
  const axis: Vector = [q[1], q[2], q[3]];
  const t = scale(cross(axis, v), 2);
  return add(add(v, scale(t, q[0])), cross(axis, t));
}

export function conjugate(q: Quaternion): Quaternion {
  return [q[0], -q[1], -q[2], -q[3]];
}

/** A position and an orientation. */
export interface Pose {
  position: Vector;
  orientation: Quaternion;
}

export function toWorld(pose: Pose, point: Vector): Vector {
  return add(pose.position, rotate(pose.orientation, point));
}

export function toLocal(pose: Pose, point: Vector): Vector {
  return rotate(conjugate(pose.orientation), subtract(point, pose.position));
}

/** Rotation about z, rad. */
export function yawOf(q: Quaternion): number {
  return Math.atan2(2 * (q[0] * q[3] + q[1] * q[2]), 1 - 2 * (q[2] * q[2] + q[3] * q[3]));
}

export function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}

/** 1, 2 or 5 times a power of ten: the greatest that is not above the value. */
export function roundDown125(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const share = value / power;
  return power * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
}

interface Area {
  readonly min: ArrayLike<number>;
  readonly max: ArrayLike<number>;
}

/** Farther than half of the arena between two states: through a joined side, or set elsewhere. */
export function jumps(
  from: ArrayLike<number>,
  to: ArrayLike<number>,
  arena: Area,
  fromAt = 0,
  toAt = 0,
): boolean {
  return [0, 1].some(
    (i) => 2 * Math.abs(to[toAt + i]! - from[fromAt + i]!) > arena.max[i]! - arena.min[i]!,
  );
}

/**
 * Poses (7 numbers each) from which those of the next state are reached without crossing the picture: where one jumps, it
 * is that of the next state. Returns the same array if none does.
 */
export function withoutJumps<BUFFER extends Float64Array>(
  from: BUFFER,
  to: BUFFER,
  arena: Area,
): BUFFER {
  let poses = from;
  for (let at = 0; at < to.length; at += 7) {
    if (jumps(from, to, arena, at, at)) {
      poses = poses === from ? (from.slice() as BUFFER) : poses;
      poses.set(to.subarray(at, at + 7), at);
    }
  }
  return poses;
}
