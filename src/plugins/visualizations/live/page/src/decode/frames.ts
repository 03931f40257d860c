// States as differences to the one before.

import { ByteReader, FormatError } from "./bytes";
import { Precision, PredictedColumn, invertSparse } from "./columns";
import { type Shape, readDrawing } from "./drawing";
import { ByteWriter, joinBytes } from "./write";
import { type Entity, EntityTable, type EntityType } from "./types";

export enum RayKind {
  Free,
  Obstructed,
  HitPoint,
}

export interface Rays {
  count: number;
  /** Numbers of the entities, ascending. */
  robots: Uint32Array;
  kinds: Uint8Array;
  /** Start and end of each, m; (count, 6). */
  ends: Float64Array;
}

/** Colours of the ground, three bytes a pixel, the row of the lowest y first. */
export interface Floor {
  width: number;
  height: number;
  pixels: Uint8Array;
}

/** Values of a field that was recorded on request, one for each entity. */
export interface Column {
  field: string;
  name: string;
  unit: string;
  /** Null, or the texts of which values are places. */
  texts: string[] | null;
  values: Float64Array;
}

export interface Metric {
  name: string;
  unit: string;
  value: number;
}

/** All that is shown of one tick. Arrays are shared with the decoder: they change with the next. */
export interface Frame {
  tick: number;
  types: EntityType[];
  entities: Entity[];
  /** Changes with entities and types. */
  entitiesVersion: number;
  /** x, y, z, then w, x, y, z of the orientation; (poses, 7). */
  poses: Float64Array;
  words: Uint32Array;
  rays: Rays;
  floor: Floor | null;
  columns: Column[];
  metrics: Metric[];
  drawing: Shape[];
}

const kNumbers = 7;
let lastVersion = 0; // shared by all decoders: equal versions mean equal entities
const kMaxRays = 1 << 22;
const kMaxPixels = 1 << 14;
const kMaxValues = 1 << 24;

function equalBytes(a: Uint8Array, b: Uint8Array): boolean {
  if (a.length !== b.length) {
    return false;
  }
  for (let i = 0; i < a.length; ++i) {
    if (a[i] !== b[i]) {
      return false;
    }
  }
  return true;
}

class RayColumns {
  private readonly ends = new PredictedColumn();
  private readonly points = new PredictedColumn();

  constructor(private readonly precision: Precision) {}

  restart(): void {
    this.ends.restart(0);
    this.points.restart(0);
  }

  decode(numEntities: number, input: ByteReader): Rays {
    const count = input.readNumberUpTo(kMaxRays, "number of rays");
    const rays: Rays = {
      count,
      robots: new Uint32Array(count),
      kinds: new Uint8Array(count),
      ends: new Float64Array(6 * count),
    };
    if (count > 0 && numEntities === 0) {
      throw new FormatError("it has rays, but no entity");
    }
    let robot = 0;
    let points = 0;
    for (let i = 0; i < count; ++i) {
      const code = input.readNumber();
      if (code === 0) {
        // further rays of the same robot and kind are counted
        const last = Math.min(i + input.readNumber(), count - 1);
        rays.robots.fill(robot, i, last + 1);
        i = last;
        continue;
      }
      const kind = code % 4;
      robot += Math.floor(code / 4);
      if (robot >= numEntities || kind > RayKind.HitPoint) {
        throw new FormatError("it has a ray of a kind, or of an entity, that does not exist");
      }
      rays.robots[i] = robot;
      rays.kinds[i] = kind;
      points += kind === RayKind.HitPoint ? 1 : 0;
    }
    this.decodeColumn(this.ends, 6 * (count - points), input);
    this.decodeColumn(this.points, 3 * points, input);
    let end = 0;
    let point = 0;
    for (let i = 0; i < count; ++i) {
      for (let axis = 0; axis < 6; ++axis) {
        rays.ends[6 * i + axis] =
          rays.kinds[i] === RayKind.HitPoint
            ? this.points.value(point + (axis % 3), this.precision)
            : this.ends.value(end + axis, this.precision);
      }
      if (rays.kinds[i] === RayKind.HitPoint) {
        point += 3;
      } else {
        end += 6;
      }
    }
    return rays;
  }

  private decodeColumn(column: PredictedColumn, size: number, input: ByteReader): void {
    if (column.size !== size) {
      column.restart(size);
    }
    column.decode(input);
  }
}

export function readFloor(content: Uint8Array): Floor {
  const input = new ByteReader(content);
  const width = input.readNumberUpTo(kMaxPixels, "width of the floor");
  const height = input.readNumberUpTo(kMaxPixels, "height of the floor");
  const pixels = input.readTextBytes();
  if (pixels.length !== 3 * width * height) {
    throw new FormatError("the size of its floor is wrong");
  }
  return { width, height, pixels };
}

/** The content of a block that readFloor() reads. */
export function writeFloor(floor: Floor): Uint8Array {
  const head = new ByteWriter();
  head.number(floor.width);
  head.number(floor.height);
  head.number(floor.pixels.length);
  return joinBytes([head.result, floor.pixels]);
}

function readFloorChange(before: Floor, input: ByteReader): Floor {
  const first = input.readNumberUpTo(before.height, "first row of a floor");
  const rows = input.readNumberUpTo(before.height - first, "number of rows of a floor");
  const rowBytes = 3 * before.width;
  const changes = input.readBytes(rows * rowBytes);
  const pixels = before.pixels.slice();
  for (let i = 0, place = first * rowBytes; i < changes.length; ++i, ++place) {
    pixels[place]! ^= changes[i]!;
  }
  return { width: before.width, height: before.height, pixels };
}

function readMetrics(input: ByteReader): Metric[] {
  const metrics: Metric[] = [];
  for (let left = input.readCount("number of metrics"); left > 0; --left) {
    const name = input.readText();
    const unit = input.readText();
    metrics.push({ name, unit, value: input.readReal() });
  }
  return metrics;
}

const kNoRays: Rays = {
  count: 0,
  robots: new Uint32Array(0),
  kinds: new Uint8Array(0),
  ends: new Float64Array(0),
};

/** Decodes states one after the other. After an error the next one must be a key frame. */
export class FrameDecoder {
  private readonly table = new EntityTable();
  private readonly poseColumns = Array.from({ length: kNumbers }, () => new PredictedColumn());
  private readonly rayColumns: RayColumns;
  private readonly namedColumns: PredictedColumn[] = [];
  private needsKey = true;
  /** Bytes of the table of the last key frame; null: it has changed since. */
  private keyTable: Uint8Array | null = null;
  readonly frame: Frame = {
    tick: 0,
    types: [],
    entities: [],
    entitiesVersion: 0,
    poses: new Float64Array(0),
    words: new Uint32Array(0),
    rays: kNoRays,
    floor: null,
    columns: [],
    metrics: [],
    drawing: [],
  };

  constructor(private readonly precision: Precision) {
    this.rayColumns = new RayColumns(precision);
  }

  /** The floor of the next key frame. */
  setFloor(floor: Floor | null): void {
    this.frame.floor = floor;
  }

  /** Reads the next state into frame. */
  decode(input: ByteReader): Frame {
    const body = new ByteReader(input.readTextBytes());
    const lastTick = this.frame.tick;
    const tick = body.readNumberUpTo(0xffffffff, "tick");
    const isKey = body.readByte() !== 0;
    if (!isKey && this.needsKey) {
      throw new FormatError(`the state of tick ${tick} is not complete`);
    }
    if (!isKey && tick <= lastTick) {
      throw new FormatError(`tick ${tick} follows tick ${lastTick}`);
    }
    this.needsKey = true;
    const { frame } = this;
    frame.tick = tick;
    frame.rays = kNoRays;
    frame.columns = [];
    frame.metrics = [];
    if (isKey) {
      this.restart();
      frame.drawing = [];
    }
    while (!body.isAtEnd) {
      const number = body.readNumber();
      this.decodeSection(number, new ByteReader(body.readTextBytes()), isKey);
    }
    this.needsKey = false;
    return frame;
  }

  private restart(): void {
    this.poseColumns.forEach((column) => column.restart(0));
    this.frame.words = new Uint32Array(0);
    this.rayColumns.restart();
    this.namedColumns.length = 0;
  }

  private decodeSection(number: number, input: ByteReader, isKey: boolean): void {
    const { frame } = this;
    switch (number) {
      case 1:
        this.readEntities(input, isKey);
        break;
      case 2:
        this.decodePoses(input);
        break;
      case 3:
        invertSparse(frame.words, input);
        break;
      case 4:
        frame.rays = this.rayColumns.decode(this.table.entities.length, input);
        break;
      case 5:
        if (frame.floor === null) {
          throw new FormatError("a floor changes that there is not");
        }
        frame.floor = readFloorChange(frame.floor, input);
        break;
      case 6:
        this.decodeColumns(input);
        break;
      case 7:
        frame.drawing = readDrawing(input.readTextBytes());
        break;
      case 8:
        frame.metrics = readMetrics(input);
        break;
      default:
        break; // a section of a later version is skipped
    }
  }

  private readEntities(input: ByteReader, isKey: boolean): void {
    const bytes = input.rest();
    const isSame = isKey && this.keyTable !== null && equalBytes(bytes, this.keyTable);
    if (!isSame) {
      this.keyTable = null;
    }
    const change = isSame ? this.table.readAgain() : this.table.read(input);
    if (isKey && !isSame) {
      this.keyTable = bytes.slice();
    }
    const { frame } = this;
    let { words } = frame;
    if (change.isRestart) {
      this.poseColumns.forEach((column) => column.restart(0));
      words = new Uint32Array(0);
    } else if (change.removedPoses !== null && change.removedWords !== null) {
      const { removedPoses, removedWords } = change;
      this.poseColumns.forEach((column) => column.remove(removedPoses));
      words = words.filter((_, i) => removedWords[i] === 0);
    }
    this.poseColumns.forEach((column) => column.append(change.addedPoses));
    frame.words = new Uint32Array(words.length + change.addedWords);
    frame.words.set(words);
    this.rayColumns.restart();
    this.namedColumns.length = 0;
    if (!isSame) {
      frame.types = this.table.types;
      frame.entities = this.table.entities;
      frame.entitiesVersion = ++lastVersion;
    }
  }

  private decodePoses(input: ByteReader): void {
    const size = this.table.numPoses;
    if (this.frame.poses.length !== kNumbers * size) {
      this.frame.poses = new Float64Array(kNumbers * size);
    }
    const { poses } = this.frame;
    this.poseColumns.forEach((column, number) => {
      column.decode(input);
      column.copyTo(poses, number, kNumbers, this.precision);
    });
  }

  private decodeColumns(input: ByteReader): void {
    const numEntities = this.table.entities.length;
    const count = input.readNumberUpTo(
      Math.floor(kMaxValues / (numEntities + 1)),
      "number of columns",
    );
    for (let i = 0; i < count; ++i) {
      const field = input.readText();
      const name = input.readText();
      const unit = input.readText();
      let texts: string[] | null = null;
      if (input.readByte() !== 0) {
        texts = [];
        for (let left = input.readCount("number of texts"); left > 0; --left) {
          texts.push(input.readText());
        }
      }
      const column = (this.namedColumns[i] ??= new PredictedColumn());
      if (column.size !== numEntities) {
        column.restart(numEntities);
      }
      column.decode(input);
      const values = new Float64Array(numEntities);
      for (let entity = 0; entity < numEntities; ++entity) {
        values[entity] = column.value(entity, Precision.Exact);
      }
      this.frame.columns.push({ field, name, unit, texts, values });
    }
  }
}
