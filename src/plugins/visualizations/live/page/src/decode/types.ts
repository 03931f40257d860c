// The types and entities of a recording, and what they look like.

import { ByteReader, FormatError } from "./bytes";

export type Vector = readonly [number, number, number];
/** w, x, y, z. */
export type Quaternion = readonly [number, number, number, number];
/** Red, green, blue, alpha; 0 to 255. */
export type Color = readonly [number, number, number, number];

export enum TypeKind {
  Body,
  Place,
  Light,
  Floor,
  Other,
}

export enum PartKind {
  Box,
  Cylinder,
  Cone,
  Sphere,
  Ring,
  LED,
}

/** One solid of an appearance, in the frame of an anchor. */
export interface VisualPart {
  kind: PartKind;
  position: Vector;
  orientation: Quaternion;
  size: Vector;
  color: Color;
  anchor: string;
  led: number;
}

/** What the entities of a type have in common. */
export interface EntityType {
  kind: TypeKind;
  tag: string;
  isRobot: boolean;
  isMovable: boolean;
  flies: boolean;
  numLEDs: number;
  boxMin: Vector;
  boxMax: Vector;
  parts: VisualPart[];
  anchors: string[];
}

export interface Entity {
  id: string;
  type: EntityType;
  /** Places of its first pose and word. */
  firstPose: number;
  firstWord: number;
}

const kMaxLEDs = 1 << 16;
const kMaxPoses = 1 << 23;
const kMaxWords = 1 << 26;

export function numPoses(type: EntityType): number {
  return type.kind === TypeKind.Floor || type.kind === TypeKind.Other ? 0 : 1 + type.anchors.length;
}

export function numWords(type: EntityType): number {
  return type.kind === TypeKind.Light ? 4 : 1 + type.numLEDs;
}

export function colorOfWord(word: number): Color {
  return [word & 255, (word >>> 8) & 255, (word >>> 16) & 255, word >>> 24];
}

export function readVector(input: ByteReader): Vector {
  const x = input.readReal();
  const y = input.readReal();
  return [x, y, input.readReal()];
}

export function readQuaternion(input: ByteReader): Quaternion {
  const w = input.readReal();
  const [x, y, z] = readVector(input);
  return [w, x, y, z];
}

function readPart(input: ByteReader): VisualPart {
  const kind = input.readNumberUpTo(PartKind.LED, "kind of a part");
  const position = readVector(input);
  const orientation = readQuaternion(input);
  const size = readVector(input);
  const color = colorOfWord(input.readFixed32());
  const anchor = input.readText();
  const led = input.readNumberUpTo(kMaxLEDs, "number of an LED");
  return { kind, position, orientation, size, color, anchor, led };
}

function readType(input: ByteReader): EntityType {
  const kind = input.readNumberUpTo(TypeKind.Other, "kind of a type");
  const tag = input.readText();
  const flags = input.readByte();
  input.readNumber(); // the parameter, of floors
  const numLEDs = input.readNumberUpTo(kMaxLEDs, "number of LEDs");
  const boxMin = readVector(input);
  const boxMax = readVector(input);
  const parts: VisualPart[] = [];
  for (let left = input.readCount("number of parts"); left > 0; --left) {
    parts.push(readPart(input));
  }
  const anchors: string[] = [];
  for (let left = input.readCount("number of anchors"); left > 0; --left) {
    anchors.push(input.readText());
  }
  return {
    kind,
    tag,
    isRobot: (flags & 1) !== 0,
    isMovable: (flags & 2) !== 0,
    flies: (flags & 4) !== 0,
    numLEDs,
    boxMin,
    boxMax,
    parts,
    anchors,
  };
}

// the solids of an entity without an appearance become its appearance
function readSolids(input: ByteReader, type: EntityType): void {
  const parts: VisualPart[] = [];
  for (let left = input.readCount("number of solids"); left > 0; --left) {
    const solid = input.readNumberUpTo(3, "kind of a solid");
    let position = readVector(input);
    const orientation = readQuaternion(input);
    const size = readVector(input);
    input.readReal(); // its radius
    for (let corners = input.readCount("number of corners"); corners > 0; --corners) {
      input.readReal();
      input.readReal();
    }
    if (solid === 2) {
      position = [position[0], position[1], position[2] + 0.5 * size[2]];
    }
    const kind = solid === 1 ? PartKind.Cylinder : solid === 2 ? PartKind.Sphere : PartKind.Box;
    const color: Color = [150, 154, 160, 255];
    parts.push({ kind, position, orientation, size, color, anchor: "origin", led: 0 });
  }
  if (type.parts.length === 0) {
    type.parts = parts;
  }
}

/** What a change of the table removes, by place before it, and adds. */
export interface TableChange {
  isRestart: boolean;
  removedPoses: Uint8Array | null;
  removedWords: Uint8Array | null;
  addedPoses: number;
  addedWords: number;
}

/** The types and entities at one tick. */
export class EntityTable {
  types: EntityType[] = [];
  entities: Entity[] = [];
  numPoses = 0;
  numWords = 0;

  /** Reads and applies a change. */
  read(input: ByteReader): TableChange {
    const isRestart = input.readByte() !== 0;
    if (isRestart) {
      this.types = [];
      this.entities = [];
      this.numPoses = this.numWords = 0;
    }
    const newTypes: EntityType[] = [];
    for (let left = input.readCount("number of types"); left > 0; --left) {
      newTypes.push(readType(input));
    }
    this.types = [...this.types, ...newTypes];
    const removed: number[] = [];
    let next = 0;
    for (let left = input.readCount("number of removed entities"); left > 0; --left) {
      next += input.readNumber();
      removed.push(next++);
    }
    const change: TableChange = {
      isRestart,
      removedPoses: null,
      removedWords: null,
      addedPoses: 0,
      addedWords: 0,
    };
    let entities = this.entities;
    if (removed.length > 0) {
      entities = this.remove(removed, change);
    }
    const all = [...entities];
    this.numPoses = this.numWords = 0;
    for (const entity of all) {
      this.place(entity);
    }
    const poses = this.numPoses;
    const words = this.numWords;
    for (let left = input.readCount("number of added entities"); left > 0; --left) {
      const id = input.readText();
      const type = this.types[input.readNumber()];
      if (type === undefined) {
        throw new FormatError(`the entity "${id}" has a type that does not exist`);
      }
      const entity = { id, type, firstPose: 0, firstWord: 0 };
      this.place(entity);
      all.push(entity);
    }
    change.addedPoses = this.numPoses - poses;
    change.addedWords = this.numWords - words;
    this.entities = all;
    if (!input.isAtEnd) {
      for (const type of newTypes) {
        readSolids(input, type);
      }
    }
    return change;
  }

  /** The change that has made the present table, if it began anew. */
  readAgain(): TableChange {
    return {
      isRestart: true,
      removedPoses: null,
      removedWords: null,
      addedPoses: this.numPoses,
      addedWords: this.numWords,
    };
  }

  private place(entity: Entity): void {
    entity.firstPose = this.numPoses;
    entity.firstWord = this.numWords;
    this.numPoses += numPoses(entity.type);
    this.numWords += numWords(entity.type);
    if (this.numPoses > kMaxPoses || this.numWords > kMaxWords) {
      throw new FormatError("it has more entities than can be shown");
    }
  }

  private remove(removed: number[], change: TableChange): Entity[] {
    if (removed[removed.length - 1]! >= this.entities.length) {
      throw new FormatError("it removes an entity that it does not have");
    }
    const isRemoved = new Uint8Array(this.entities.length);
    removed.forEach((number) => (isRemoved[number] = 1));
    const poses = new Uint8Array(this.numPoses);
    const words = new Uint8Array(this.numWords);
    const kept: Entity[] = [];
    this.entities.forEach((entity, i) => {
      if (isRemoved[i] === 1) {
        poses.fill(1, entity.firstPose, entity.firstPose + numPoses(entity.type));
        words.fill(1, entity.firstWord, entity.firstWord + numWords(entity.type));
      } else {
        kept.push({ ...entity });
      }
    });
    change.removedPoses = poses;
    change.removedWords = words;
    return kept;
  }
}
