// What the page reads of an experiment's file.

import type { Frame } from "./decode/frames";
import { TypeKind } from "./decode/types";
import type { Box } from "./view/camera";

function numbers(text: string | null): number[] {
  return (text ?? "").split(",").map(Number);
}

/** The arena of an experiment; null if its file does not say. */
export function readArena(xml: string): Box | null {
  const root = new DOMParser().parseFromString(xml, "application/xml");
  const arena = root.querySelector("argos-configuration > arena, arena");
  const size = numbers(arena?.getAttribute("size") ?? null);
  const center = numbers(arena?.getAttribute("center") ?? "0,0,0");
  if (size.length < 2 || !size.every((part) => Number.isFinite(part) && part > 0)) {
    return null;
  }
  const [cx = 0, cy = 0, cz = 0] = center.map((part) => (Number.isFinite(part) ? part : 0));
  const [sx, sy, sz = 1] = size as [number, number, number];
  return {
    min: [cx - sx / 2, cy - sy / 2, cz - sz / 2],
    max: [cx + sx / 2, cy + sy / 2, cz + sz / 2],
  };
}

/** A box around all that has a place. */
export function arenaAround(frame: Frame): Box {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const entity of frame.entities) {
    if (entity.type.kind === TypeKind.Body || entity.type.kind === TypeKind.Place) {
      const x = frame.poses[7 * entity.firstPose]!;
      const y = frame.poses[7 * entity.firstPose + 1]!;
      minX = Math.min(minX, x);
      maxX = Math.max(maxX, x);
      minY = Math.min(minY, y);
      maxY = Math.max(maxY, y);
    }
  }
  if (!(maxX >= minX)) {
    return { min: [-1, -1, 0], max: [1, 1, 1] };
  }
  const margin = 0.5 + 0.1 * Math.max(maxX - minX, maxY - minY);
  return { min: [minX - margin, minY - margin, 0], max: [maxX + margin, maxY + margin, 1] };
}
