// What sensors of the selected robots perceive: messages, blobs of cameras, light.

import type { Color, Vector } from "../decode/types";
import type { Mark, Perception, Tree } from "../session";
import type { Dot, Line } from "./marks";

const kMessage: Color = [124, 77, 219, 210];
const kLight: Color = [214, 158, 0, 235];
const kLightLength = 0.35; // m, of the largest reading
const kLightSensors = 24; // of a foot-bot, from 7.5 degrees on

/** Of one robot: its pose's number, its radius and height. */
export interface DeviceOwner {
  pose: number;
  radius: number;
  top: number;
}

function at(mark: Mark, height: number): Vector {
  const flat = mark.range * Math.cos(mark.elevation);
  return [
    flat * Math.cos(mark.bearing),
    flat * Math.sin(mark.bearing),
    height + mark.range * Math.sin(mark.elevation),
  ];
}

function addLight(owner: DeviceOwner, readings: Tree, lines: Line[]): void {
  const { pose, radius, top } = owner;
  let [x, y] = [0, 0];
  for (let i = 0; i < kLightSensors; ++i) {
    const value = Number(readings[`footbot_light_${i + 1}`] ?? 0);
    const angle = ((7.5 + 15 * i) * Math.PI) / 180;
    if (value > 0) {
      const length = radius + kLightLength * value;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      x += value * c;
      y += value * s;
      lines.push({ pose, start: [radius * c, radius * s, top], end: [length * c, length * s, top], color: kLight, width: 1.5 });
    }
  }
  const sum = Math.hypot(x, y);
  if (sum > 1e-9) {
    const length = radius + 1.5 * kLightLength * Math.min(1, sum);
    lines.push({ pose, start: [0, 0, top], end: [(length * x) / sum, (length * y) / sum, top], color: kLight, width: 4 });
  }
}

/** Appends what is drawn of a robot. */
export function addDevices(owner: DeviceOwner, { marks, light }: Perception, lines: Line[], dots: Dot[]): void {
  const { pose, top } = owner;
  for (const mark of marks) {
    const isBlob = mark.kind === "blob";
    const height = isBlob ? 0.5 * top : top;
    const color: Color = mark.color === undefined ? kMessage : [...mark.color, 255];
    const end = at(mark, height);
    lines.push({ pose, start: [0, 0, height], end, color: [color[0], color[1], color[2], isBlob ? 150 : 210], width: isBlob ? 1.2 : 2 });
    dots.push({ pose, position: end, color, radius: 0, pixels: isBlob ? 9 : 6 });
  }
  if (light !== null) {
    addLight(owner, light, lines);
  }
}
