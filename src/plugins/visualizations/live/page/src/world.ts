// The experiment file of a run with the entities where a state has them.

import type { RecordingInfo } from "./decode/blocks";
import type { Frame } from "./decode/frames";
import { type Entity, type Quaternion, TypeKind } from "./decode/types";

const kAdded = /_added_\d+$/; // ids of what viewers have added
const kMassOfAdded = "0.1"; // kg

export interface World {
  text: string;
  /** Ids of entities that the file does not have, because the experiment's code has made them. */
  missing: string[];
}

function number(value: number): string {
  return String(+value.toFixed(7));
}

/** Degrees about z, y and x, in this order. */
function anglesOf([w, x, y, z]: Quaternion): string {
  const degrees = 180 / Math.PI;
  const sine = Math.min(1, Math.max(-1, 2 * (w * y - z * x)));
  return [
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
    Math.asin(sine),
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
  ]
    .map((angle) => number(angle * degrees))
    .join(",");
}

/** Elements from which entities were made: those with an id, and those of <distribute>. */
class Elements {
  readonly own = new Map<string, Element>();
  private readonly models: Element[] = [];

  constructor(readonly arena: Element) {
    for (const element of [...arena.children]) {
      if (element.tagName === "distribute") {
        const model = element.querySelector(":scope > entity > *");
        if (model !== null) {
          this.models.push(model);
        }
        element.remove();
      } else if (element.hasAttribute("id")) {
        this.own.set(element.getAttribute("id")!, element);
      }
    }
  }

  /** A copy of the element that makes such an entity; null: there is none. */
  copyFor({ id, type }: Entity): Element | null {
    const same = [...this.models, ...this.own.values()].filter(({ tagName }) => tagName === type.tag);
    const prefix = (element: Element): number => {
      const other = element.getAttribute("id") ?? "";
      return id.startsWith(other) ? other.length : -1;
    };
    const model = same.sort((a, b) => prefix(b) - prefix(a))[0];
    if (model === undefined || (prefix(model) < 0 && !kAdded.test(id))) {
      return null;
    }
    return model.cloneNode(true) as Element;
  }
}

function makeAdded({ id, type }: Entity, document: Document): Element | null {
  if (!kAdded.test(id) || (type.tag !== "box" && type.tag !== "cylinder")) {
    return null;
  }
  const element = document.createElementNS(null, type.tag);
  const size = [0, 1, 2].map((axis) => type.boxMax[axis]! - type.boxMin[axis]!);
  if (type.tag === "box") {
    element.setAttribute("size", size.map(number).join(","));
  } else {
    element.setAttribute("radius", number(0.5 * size[0]!));
    element.setAttribute("height", number(size[2]!));
  }
  element.setAttribute("movable", String(type.isMovable));
  if (type.isMovable) {
    element.setAttribute("mass", kMassOfAdded);
  }
  return element;
}

function place(element: Element, entity: Entity, frame: Frame): void {
  const at = 7 * entity.firstPose;
  const pose = frame.poses.subarray(at, at + 7);
  let target = element;
  if (entity.type.kind === TypeKind.Body) {
    target = element.querySelector(":scope > body") ?? element.ownerDocument.createElementNS(null, "body");
    if (target.parentElement !== element) {
      element.prepend(target);
    }
  }
  target.setAttribute("position", [pose[0]!, pose[1]!, pose[2]!].map(number).join(","));
  target.setAttribute("orientation", anglesOf([pose[3]!, pose[4]!, pose[5]!, pose[6]!]));
}

/** Throws if the recording does not contain the experiment. */
export function makeWorld(info: RecordingInfo, frame: Frame): World {
  const document = new DOMParser().parseFromString(info.experiment, "application/xml");
  const arena = document.querySelector("arena");
  if (arena === null || document.querySelector("parsererror") !== null) {
    throw new Error("the experiment file is not known");
  }
  const elements = new Elements(arena);
  const missing: string[] = [];
  const seen = new Set<string>();
  for (const entity of frame.entities) {
    const { kind, isMovable } = entity.type;
    if (kind === TypeKind.Floor || kind === TypeKind.Other) {
      seen.add(entity.id);
      continue;
    }
    let element = elements.own.get(entity.id) ?? null;
    if (element === null) {
      element = makeAdded(entity, document) ?? elements.copyFor(entity);
      if (element === null) {
        // <walls> and the like make what does not move
        if (isMovable) {
          missing.push(entity.id);
        }
        continue;
      }
      element.setAttribute("id", entity.id);
      arena.append("  ", element, "\n  ");
    }
    seen.add(entity.id);
    place(element, entity, frame);
  }
  for (const [id, element] of elements.own) {
    if (!seen.has(id)) {
      element.remove();
    }
  }
  document.querySelector("framework > experiment")?.setAttribute("random_seed", String(info.seed));
  const text = new XMLSerializer().serializeToString(document);
  const start = text.startsWith("<?xml") ? "" : '<?xml version="1.0" ?>\n';
  return { text: `${start}${text}\n`, missing };
}
