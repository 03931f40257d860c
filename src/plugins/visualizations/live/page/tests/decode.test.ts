import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { kFileHeaderSize } from "../src/decode/blocks";
import { ByteReader } from "../src/decode/bytes";
import { Precision, PredictedColumn, invertSparse } from "../src/decode/columns";
import { ShapeKind } from "../src/decode/drawing";
import { RayKind } from "../src/decode/frames";
import { Recording, sourceOfBlob, sourceOfBytes } from "../src/decode/recording";
import { StreamDecoder } from "../src/decode/stream";
import { withoutJumps } from "../src/view/math";
import { changedExperiment, experiment, folder, readTable, record, run } from "./runs";

function open(path: string): Promise<Recording> {
  return Recording.open(sourceOfBytes(new Uint8Array(readFileSync(path))));
}

const flocking = record("flocking", 12);

test("decoder: of words that change, runs of others are counted, also beyond the last one", () => {
  const words = new Uint32Array([1, 2, 3, 4, 5, 6]);
  invertSparse(words, new ByteReader(new Uint8Array([4, 0, 2, 7, 0, 9])));
  assert.deepEqual([...words], [1 ^ 4, 2, 3, 4, 5 ^ 7, 6]);
});

test("decoder: a column is copied to every third place as its values are", () => {
  // differences to straight lines: 3, -1, and a number of 33 bits
  const bytes = [6, 1, 0x80, 0x80, 0x80, 0x80, 0x20];
  for (const precision of [Precision.Grid, Precision.Exact]) {
    const column = new PredictedColumn();
    column.append(3);
    column.decode(new ByteReader(new Uint8Array(bytes)));
    const values = new Float64Array(9).fill(-5);
    column.copyTo(values, 1, 3, precision);
    const expected = [0, 1, 2].flatMap((i) => [-5, column.value(i, precision), -5]);
    assert.deepEqual([...values], expected);
  }
  const grid = new PredictedColumn();
  grid.append(3);
  grid.decode(new ByteReader(new Uint8Array(bytes)));
  assert.deepEqual([0, 1, 2].map((i) => grid.value(i, Precision.Grid) * 2 ** 20), [3, -1, 2 ** 32]);
});

test("decoder: whole numbers take 7 bits a byte, up to 64 bits", () => {
  const input = new ByteReader(
    new Uint8Array([5, 0x80, 1, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1]),
  );
  assert.equal(input.readNumber(), 5);
  assert.equal(input.readNumber(), 128);
  input.readNumber64();
  assert.deepEqual([input.low, input.high], [-1, -1]);
  assert.throws(() => input.readByte(), /too short/);
});

test("decoder: poses of each tick are those that the replay has", async () => {
  run("-z", "--quiet", "--replay", flocking, "--csv", join(folder, "replayed"));
  const recording = await open(flocking);
  assert.equal(recording.lastTick, 120);
  let rows = 0;
  for (const row of readTable(join(folder, "replayed/robots.csv"))) {
    const frame = await recording.read(Number(row.get("tick")));
    const entity = frame.entities.find((candidate) => candidate.id === row.get("robot"))!;
    const pose = frame.poses.subarray(7 * entity.firstPose, 7 * entity.firstPose + 7);
    assert.deepEqual(
      [pose[0], pose[1], pose[2]],
      ["x", "y", "z"].map((name) => Number(row.get(name))),
    );
    const yaw = Math.atan2(
      2 * (pose[3]! * pose[6]! + pose[4]! * pose[5]!),
      1 - 2 * (pose[5]! ** 2 + pose[6]! ** 2),
    );
    assert.ok(Math.abs(yaw - Number(row.get("yaw"))) < 1e-12);
    ++rows;
  }
  assert.equal(rows, 20 * 121);
});

test("decoder: exact recordings keep all bits of poses", async () => {
  const exact = join(folder, "exact.rec");
  run(
    ...["-zc", experiment("flocking"), "--quiet", "--record", exact, "--length", "3"],
    ...["--csv", join(folder, "exact"), "--set", "//recording/@precision=exact"],
  );
  const recording = await open(exact);
  for (const row of readTable(join(folder, "exact/robots.csv"))) {
    const frame = await recording.read(Number(row.get("tick")));
    const { firstPose } = frame.entities.find((entity) => entity.id === row.get("robot"))!;
    assert.equal(frame.poses[7 * firstPose], Number(row.get("x")));
    assert.equal(frame.poses[7 * firstPose + 1], Number(row.get("y")));
  }
});

test("decoder: LEDs, metrics and recorded fields are those of the run's tables", async () => {
  const path = join(folder, "fields.rec");
  run(
    ...["-zc", experiment("synchronization"), "--quiet", "--record", path, "--length", "10"],
    ...["--csv", join(folder, "fields"), "--set", "//table/@fields=leds"],
    ...["--set", "//recording/@fields=wheels,leds"],
  );
  const recording = await open(path);
  let lit = 0;
  for (const row of readTable(join(folder, "fields/robots.csv"))) {
    const frame = await recording.read(Number(row.get("tick")));
    const number = frame.entities.findIndex((entity) => entity.id === row.get("robot"));
    const { firstWord, type } = frame.entities[number]!;
    for (let led = 0; led < type.numLEDs; ++led) {
      const word = frame.words[firstWord + 1 + led]!;
      const rgb = ((word & 255) << 16) | (word & 0xff00) | ((word >>> 16) & 255);
      const expected = Number(row.get(`led_${led + 1}`));
      assert.equal(rgb, expected);
      const column = frame.columns.find((candidate) => candidate.name === `led_${led + 1}`)!;
      assert.equal(column.values[number], expected);
      lit += rgb !== 0 ? 1 : 0;
    }
  }
  assert.ok(lit > 0);
  for (const row of readTable(join(folder, "fields/metrics.csv"))) {
    for (const metric of (await recording.read(Number(row.get("tick")))).metrics) {
      const cell = row.get(metric.name)!;
      assert.ok(Object.is(metric.value, cell === "" ? NaN : Number(cell)));
    }
  }
});

test("decoder: the floor is that of the run, and changes where it did", async () => {
  const recording = await open(record("foraging", 30));
  const first = (await recording.read(0)).floor!;
  assert.equal(first.pixels.length, 3 * first.width * first.height);
  const last = (await recording.read(recording.lastTick)).floor!;
  assert.notDeepEqual(first.pixels, last.pixels);
  assert.deepEqual((await recording.read(0)).floor!.pixels, first.pixels);
});

test("decoder: rays begin at their robot, and hits lie on their rays", async () => {
  const recording = await open(record("diffusion_10", 5));
  const { rays, entities, poses } = await recording.read(50);
  assert.ok(rays.count > 10);
  const seen = new Set<number>();
  for (let i = 0; i < rays.count; ++i) {
    seen.add(rays.kinds[i]!);
    const pose = 7 * entities[rays.robots[i]!]!.firstPose;
    const distance = Math.hypot(
      rays.ends[6 * i]! - poses[pose]!,
      rays.ends[6 * i + 1]! - poses[pose + 1]!,
    );
    assert.ok(distance < 0.25, `ray ${i} begins ${distance} m from its robot`);
  }
  assert.ok(seen.has(RayKind.Free) && seen.has(RayKind.Obstructed) && seen.has(RayKind.HitPoint));
});

test("decoder: what users' code draws is there, shape by shape", async () => {
  const changed = changedExperiment("trajectories", (xml) =>
    xml.replace(
      "</argos-configuration>",
      `<outputs><recording file="${join(folder, "drawn.rec")}" drawing="true">
        <user_functions label="trajectory_user_functions" /></recording></outputs>
      </argos-configuration>`,
    ),
  );
  run("-zc", changed, "--quiet", "--length", "5");
  const recording = await open(join(folder, "drawn.rec"));
  const { drawing } = await recording.read(50);
  assert.ok(drawing.filter((shape) => shape.kind === ShapeKind.Line).length > 50);
  assert.ok(drawing.every((shape) => shape.position.every(Number.isFinite)));
});

test("decoder: any tick is found, in any order, from a file read in parts", async () => {
  const recording = await Recording.open(sourceOfBlob(new Blob([readFileSync(flocking)])));
  const x = async (tick: number): Promise<number> => {
    const frame = await recording.read(tick);
    assert.equal(frame.tick, tick);
    return frame.poses[0]!;
  };
  const late = await x(119);
  const early = await x(3);
  assert.equal(await x(119), late);
  assert.equal(await x(3), early);
  assert.equal((await recording.read(1000)).tick, 120);
});

test("decoder: a recording that was cut is shown up to its last whole block", async () => {
  const bytes = new Uint8Array(readFileSync(flocking));
  const recording = await Recording.open(sourceOfBytes(bytes.subarray(0, bytes.length - 700)));
  assert.match(recording.damage ?? "", /stopped/);
  assert.ok(recording.lastTick >= 99);
});

test("decoder: damage is found by checksums, and other files are refused", async () => {
  const bytes = new Uint8Array(readFileSync(flocking));
  bytes[kFileHeaderSize + 1500]! ^= 4;
  await assert.rejects(async () => {
    const recording = await Recording.open(sourceOfBytes(bytes));
    await recording.read(50);
  }, /checksum|damaged/);
  const other = new TextEncoder().encode("something else, which is long enough");
  await assert.rejects(Recording.open(sourceOfBytes(other)), /no recording/);
  const later = new Uint8Array(readFileSync(flocking));
  later[8] = 2;
  await assert.rejects(Recording.open(sourceOfBytes(later)), /version 2/);
});

test("decoder: the blocks of a file, one by one, are a stream", async () => {
  const bytes = new Uint8Array(readFileSync(flocking));
  const stream = new StreamDecoder();
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  let tick = 0;
  for (let place = kFileHeaderSize; place + 44 < bytes.length; ) {
    const end = place + 44 + view.getUint32(place + 28, true);
    tick = stream.decode(bytes.subarray(place, end))?.tick ?? tick;
    place = end;
  }
  assert.equal(tick, 120);
  const direct = await (await open(flocking)).read(120);
  assert.equal(stream.info?.seed, 124);
  assert.equal(direct.tick, 120);
});

test("poses: what crosses a joined side of the arena does not move over the picture", () => {
  const arena = { min: [-2, -1, 0], max: [2, 1, 1] };
  const turn = [1, 0, 0, 0];
  const state = (...places: number[][]): Float64Array =>
    new Float64Array(places.flatMap((place) => [...place, ...turn]));
  const from = state([1.9, 0, 0], [0, 0.9, 0], [0, 0, 0]);
  // less than half of the sides
  const near = state([0, 0, 0], [0, 0, 0], [0, 0, 0.5]);
  assert.equal(withoutJumps(from, near, arena), from);
  const across = state([-1.9, 0, 0], [0, -0.9, 0], [0.1, 0, 0]);
  assert.deepEqual(withoutJumps(from, across, arena), state([-1.9, 0, 0], [0, -0.9, 0], [0, 0, 0]));
  assert.equal(from[0], 1.9);
});
