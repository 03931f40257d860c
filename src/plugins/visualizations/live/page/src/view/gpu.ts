// Helpers around three.js: materials of own shaders, buffers that grow, textures of poses.

import {
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  DataTexture,
  DoubleSide,
  DynamicDrawUsage,
  FloatType,
  FrontSide,
  GLSL3,
  type IUniform,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  NearestFilter,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RGBAFormat,
  RawShaderMaterial,
  RedIntegerFormat,
  UnsignedByteType,
  UnsignedIntType,
} from "three";

export type Uniforms = Record<string, IUniform>;

export interface MaterialOptions {
  isBlended?: boolean;
  depthTest?: boolean;
  depthWrite?: boolean;
  defines?: Record<string, string | number>;
}

export function makeMaterial(
  vertexShader: string,
  fragmentShader: string,
  uniforms: Uniforms,
  options: MaterialOptions = {},
): RawShaderMaterial {
  const isBlended = options.isBlended ?? false;
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    defines: options.defines ?? {},
    depthTest: options.depthTest ?? true,
    depthWrite: options.depthWrite ?? !isBlended,
    side: isBlended ? DoubleSide : FrontSide, // quads that face the viewer have either side there
    ...(isBlended
      ? {
          transparent: true,
          blending: CustomBlending,
          blendSrc: OneFactor,
          blendDst: OneMinusSrcAlphaFactor,
        }
      : {}),
  });
}

export interface FieldSpec {
  name: string;
  size: number;
  /** Floats, whole numbers of 32 bits, or bytes as shares of 255. */
  type: "float" | "uint" | "color";
}

type Values = Float32Array | Uint32Array | Uint8Array;

function makeValues(type: FieldSpec["type"], size: number): Values {
  return type === "float"
    ? new Float32Array(size)
    : type === "uint"
      ? new Uint32Array(size)
      : new Uint8Array(size);
}

/** Instances of a small mesh; buffers grow with their number. */
export class InstanceBatch {
  readonly geometry = new InstancedBufferGeometry();
  readonly mesh: Mesh;
  readonly fields = new Map<string, Values>();
  private capacity = 0;
  private count = 0;

  constructor(
    base: BufferGeometry,
    private readonly specs: FieldSpec[],
    material: RawShaderMaterial,
    renderOrder: number,
  ) {
    for (const [name, attribute] of Object.entries(base.attributes)) {
      this.geometry.setAttribute(name, attribute as BufferAttribute);
    }
    this.geometry.setIndex(base.index);
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = renderOrder;
    this.begin(16);
    this.end(0);
  }

  /** Makes room for so many instances; returns the arrays to be filled. */
  begin(count: number): Map<string, Values> {
    if (count > this.capacity) {
      this.geometry.dispose();
      this.capacity = Math.max(16, Math.ceil(count * 1.25));
      for (const { name, size, type } of this.specs) {
        const values = makeValues(type, size * this.capacity);
        const attribute = new InstancedBufferAttribute(values, size, type === "color");
        attribute.setUsage(DynamicDrawUsage);
        this.fields.set(name, values);
        this.geometry.setAttribute(name, attribute);
      }
    }
    return this.fields;
  }

  /** Uploads the first so many instances. */
  end(count: number): void {
    this.count = count;
    this.geometry.instanceCount = count;
    this.mesh.visible = count > 0;
    for (const { name, size } of this.specs) {
      const attribute = this.geometry.getAttribute(name) as InstancedBufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, size * count);
      attribute.needsUpdate = true;
    }
  }

  get length(): number {
    return this.count;
  }
}

/** Corners (0, 0), (1, 0), (0, 1), (1, 1). */
export function makeQuad(): BufferGeometry {
  const geometry = new BufferGeometry();
  const corners = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]);
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  return geometry;
}

const kPosesPerRow = 512;
const kWordsPerRow = 1024;

function makePoseTexture(rows: number): DataTexture {
  const data = new Float32Array(4 * 2 * kPosesPerRow * rows);
  const texture = new DataTexture(data, 2 * kPosesPerRow, rows, RGBAFormat, FloatType);
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

function makeWordTexture(rows: number): DataTexture {
  const data = new Uint32Array(kWordsPerRow * rows);
  const texture = new DataTexture(data, kWordsPerRow, rows, RedIntegerFormat, UnsignedIntType);
  texture.internalFormat = "R32UI";
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The poses of the last two states, the words of the last one, and flags of entities. */
export class StateTextures {
  private from = makePoseTexture(1);
  private to = makePoseTexture(1);
  private words = makeWordTexture(1);
  private near: DataTexture;
  private blended: DataTexture | null = null;
  readonly uniforms: Uniforms;

  /** @param blendsHere  once a picture for all, instead of in the shaders for each corner. */
  constructor(private readonly blendsHere: boolean) {
    this.near = this.makeNear(1);
    this.uniforms = {
      uFrom: { value: this.from },
      uTo: { value: this.to },
      uWords: { value: this.words },
      uIsNear: { value: this.near },
      uBlend: { value: 1 },
    };
  }

  /** The last state becomes the one before it. */
  push(poses: Float64Array, words: Uint32Array): void {
    const poseRows = Math.max(1, Math.ceil(poses.length / 7 / kPosesPerRow));
    if (this.to.image.height !== poseRows) {
      this.from.dispose();
      this.to.dispose();
      this.from = makePoseTexture(poseRows);
      this.to = makePoseTexture(poseRows);
    }
    [this.from, this.to] = [this.to, this.from];
    const data = this.to.image.data as Float32Array;
    this.numPoses = poses.length / 7;
    for (let i = 0, place = 0; i < poses.length; i += 7, place += 8) {
      data[place] = poses[i]!;
      data[place + 1] = poses[i + 1]!;
      data[place + 2] = poses[i + 2]!;
      data[place + 4] = poses[i + 4]!;
      data[place + 5] = poses[i + 5]!;
      data[place + 6] = poses[i + 6]!;
      data[place + 7] = poses[i + 3]!;
    }
    this.to.needsUpdate = true;
    const wordRows = Math.max(1, Math.ceil(words.length / kWordsPerRow));
    if (this.words.image.height !== wordRows) {
      this.words.dispose();
      this.words = makeWordTexture(wordRows);
    }
    (this.words.image.data as Uint32Array).set(words);
    this.words.needsUpdate = true;
    this.uniforms.uFrom!.value = this.from;
    this.uniforms.uTo!.value = this.to;
    this.uniforms.uWords!.value = this.words;
  }

  /** The share of the way from the last state to this one. */
  setBlend(blend: number): void {
    const { uniforms } = this;
    if (!this.blendsHere || blend >= 1) {
      uniforms.uBlend!.value = blend;
      uniforms.uTo!.value = this.to;
      return;
    }
    if (this.blended === null || this.blended.image.height !== this.to.image.height) {
      this.blended?.dispose();
      this.blended = makePoseTexture(this.to.image.height);
    }
    const from = this.from.image.data as Float32Array;
    const to = this.to.image.data as Float32Array;
    const data = this.blended.image.data as Float32Array;
    for (let i = 0; i < 8 * this.numPoses; i += 8) {
      let dot = 0;
      for (let k = i + 4; k < i + 8; ++k) {
        dot += from[k]! * to[k]!;
      }
      const before = dot < 0 ? blend - 1 : 1 - blend;
      for (let k = i; k < i + 3; ++k) {
        data[k] = from[k]! + blend * (to[k]! - from[k]!);
      }
      let norm = 0;
      for (let k = i + 4; k < i + 8; ++k) {
        const value = before * from[k]! + blend * to[k]!;
        data[k] = value;
        norm += value * value;
      }
      norm = 1 / Math.sqrt(norm || 1);
      for (let k = i + 4; k < i + 8; ++k) {
        data[k]! *= norm;
      }
    }
    this.blended.needsUpdate = true;
    uniforms.uBlend!.value = 1;
    uniforms.uTo!.value = this.blended;
  }

  private numPoses = 0;

  /** Of this picture: eight numbers for each pose, of which three are its position. */
  get poses(): Float32Array {
    return (this.uniforms.uTo!.value as DataTexture).image.data as Float32Array;
  }

  get wordsOfState(): Uint32Array {
    return this.words.image.data as Uint32Array;
  }

  /** Which entities are drawn in full, by number. */
  setNear(isNear: Uint8Array): void {
    const rows = Math.max(1, Math.ceil(isNear.length / kWordsPerRow));
    if (this.near.image.height !== rows) {
      this.near.dispose();
      this.near = this.makeNear(rows);
      this.uniforms.uIsNear!.value = this.near;
    }
    (this.near.image.data as Uint8Array).set(isNear);
    this.near.needsUpdate = true;
  }

  private makeNear(rows: number): DataTexture {
    const data = new Uint8Array(kWordsPerRow * rows);
    const texture = new DataTexture(data, kWordsPerRow, rows, RedIntegerFormat, UnsignedByteType);
    texture.internalFormat = "R8UI";
    texture.magFilter = texture.minFilter = NearestFilter;
    texture.needsUpdate = true;
    return texture;
  }
}
