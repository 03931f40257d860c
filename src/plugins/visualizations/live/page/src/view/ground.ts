// The ground: the arena's floor with a grid, and what is around it, which fades into the background.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearSRGBColorSpace,
  Mesh,
  RGBAFormat,
  type RawShaderMaterial,
  Vector2,
  Vector3,
} from "three";

import type { Floor } from "../decode/frames";
import type { Box } from "./camera";
import { type Uniforms, makeMaterial } from "./gpu";
import type { Look } from "./looks";
import { kGroundFragment, kGroundVertex, kPlainGroundFragment } from "./shaders";

const kReach = 0.6; // of the arena's larger side

/**
 * A sheet of nine parts, all drawn by one material. Where the processor draws, most pixels of the picture are the ground's, so
 * the middle part, which neither the boundary nor the fading comes to, has a material of its own that knows neither.
 */
export class Ground {
  readonly mesh: Mesh;
  private readonly uniforms: Uniforms;
  private readonly materials: RawShaderMaterial[];
  private texture: DataTexture | null = null;
  private floor: Floor | null = null;

  constructor(
    shared: Uniforms,
    private readonly isSoftware: boolean,
  ) {
    this.uniforms = { ...shared };
    for (const name of ["uBackground", "uGround", "uGroundOutside", "uGridLine", "uBoundary"]) {
      this.uniforms[name] = { value: new Vector3() };
    }
    this.materials = isSoftware
      ? [this.makeMaterial(kPlainGroundFragment, {}), this.makeMaterial(kPlainGroundFragment, { IS_INSIDE: 1 })]
      : [this.makeMaterial(kGroundFragment, { HAS_SHADOWS: 1 })];
    this.mesh = new Mesh(makeSheet(), isSoftware ? this.materials : this.materials[0]);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 0;
  }

  private makeMaterial(fragmentShader: string, defines: Record<string, number>): RawShaderMaterial {
    const material = makeMaterial(kGroundVertex, fragmentShader, this.uniforms, { defines });
    material.side = DoubleSide;
    return material;
  }

  setLook(look: Look): void {
    const set = (name: string, hex: string): void => {
      // without shadows, colours stay as they are; else three.js decodes them to linear light
      const { r, g, b } = this.isSoftware ? new Color().setStyle(hex, LinearSRGBColorSpace) : new Color(hex);
      this.uniforms[name]!.value = new Vector3(r, g, b);
    };
    set("uBackground", look.background);
    set("uGround", look.ground);
    set("uGroundOutside", look.groundOutside);
    set("uGridLine", look.gridLine);
    set("uBoundary", look.boundary);
  }

  setArena({ min, max }: Box): void {
    const reach = kReach * Math.max(max[0] - min[0], max[1] - min[1]);
    const u = this.uniforms;
    u.uArenaMin!.value = new Vector2(min[0], min[1]);
    u.uArenaMax!.value = new Vector2(max[0], max[1]);
    u.uFadeLength!.value = reach;
  }

  setFloor(floor: Floor | null): void {
    if (floor === this.floor) {
      return;
    }
    const isSame = this.floor?.width === floor?.width && this.floor?.height === floor?.height;
    this.floor = floor;
    if (!isSame || this.texture === null) {
      this.texture?.dispose();
      this.texture = floor === null ? null : this.makeTexture(floor);
      for (const material of this.materials) {
        const defines = material.defines as Record<string, number>;
        delete defines.HAS_FLOOR;
        if (floor !== null) {
          defines.HAS_FLOOR = 1;
        }
        material.needsUpdate = true;
      }
    }
    if (floor !== null && this.texture !== null) {
      const data = this.texture.image.data as Uint8Array;
      for (let i = 0, place = 0; i < floor.pixels.length; i += 3, place += 4) {
        data[place] = floor.pixels[i]!;
        data[place + 1] = floor.pixels[i + 1]!;
        data[place + 2] = floor.pixels[i + 2]!;
        data[place + 3] = 255;
      }
      this.texture.needsUpdate = true;
      this.uniforms.uFloor!.value = this.texture;
      this.uniforms.uFloorSize!.value = new Vector2(floor.width, floor.height);
    }
  }

  private makeTexture({ width, height }: Floor): DataTexture {
    const texture = new DataTexture(new Uint8Array(4 * width * height), width, height, RGBAFormat);
    texture.magFilter = LinearFilter;
    texture.minFilter = this.isSoftware ? LinearFilter : LinearMipmapLinearFilter;
    texture.generateMipmaps = !this.isSoftware;
    return texture;
  }
}

// 4 x 4 corners, whose numbers the vertex shader places; the part in the middle is the last
function makeSheet(): BufferGeometry {
  const corners: number[] = [];
  const around: number[] = [];
  const inside: number[] = [];
  for (let y = 0; y < 4; ++y) {
    for (let x = 0; x < 4; ++x) {
      corners.push(x, y, 0);
      if (x < 3 && y < 3) {
        const corner = 4 * y + x;
        const part = x === 1 && y === 1 ? inside : around;
        part.push(corner, corner + 1, corner + 4, corner + 4, corner + 1, corner + 5);
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  geometry.setIndex([...around, ...inside]);
  geometry.addGroup(0, around.length, 0);
  geometry.addGroup(around.length, inside.length, 1);
  return geometry;
}
