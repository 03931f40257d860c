// The solids of which everything consists, each of unit size in its own frame.

export enum MeshKind {
  /** x, y in [-0.5, 0.5], z in [0, 1]. */
  Box,
  /** Radius 0.5 around z, z in [0, 1]; the parameter is the radius of the top over the base's. */
  Cylinder,
  /** Radius 0.5 around the origin. */
  Sphere,
  /** Torus around z; the parameter is the radius of the tube over the outer radius of 0.5. */
  Ring,
}

export const kMeshKinds = [MeshKind.Box, MeshKind.Cylinder, MeshKind.Sphere, MeshKind.Ring];

export interface UnitMesh {
  /** (vertices, 3) */
  positions: number[];
  normals: number[];
  /** Coordinates along which edges are at 0 and 1, (vertices, 2). */
  edges: number[];
  indices: number[];
}

const kNoEdge = 0.5;

function emptyMesh(): UnitMesh {
  return { positions: [], normals: [], edges: [], indices: [] };
}

function addVertex(mesh: UnitMesh, position: number[], normal: number[], edge: number[]): number {
  mesh.positions.push(...position);
  mesh.normals.push(...normal);
  mesh.edges.push(...edge);
  return mesh.positions.length / 3 - 1;
}

function circle(i: number, segments: number): [number, number] {
  const angle = (2 * Math.PI * (i % segments)) / segments;
  return [Math.cos(angle), Math.sin(angle)];
}

function makeBox(): UnitMesh {
  const mesh = emptyMesh();
  for (let axis = 0; axis < 3; ++axis) {
    for (const sign of [1, -1]) {
      const u = (axis + 1) % 3;
      const v = (axis + 2) % 3;
      const first = mesh.positions.length / 3;
      for (const [cornerU, cornerV] of [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ] as const) {
        const position = [0, 0, 0];
        position[axis] = 0.5 * sign;
        position[u] = (cornerU - 0.5) * sign;
        position[v] = cornerV - 0.5;
        position[2]! += 0.5;
        const normal = [0, 0, 0];
        normal[axis] = sign;
        addVertex(mesh, position, normal, [cornerU, cornerV]);
      }
      mesh.indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  return mesh;
}

function addCap(mesh: UnitMesh, z: number, segments: number): void {
  const up = z > 0.5 ? 1 : -1;
  const center = addVertex(mesh, [0, 0, z], [0, 0, up], [kNoEdge, kNoEdge]);
  for (let i = 0; i <= segments; ++i) {
    const [x, y] = circle(i, segments);
    addVertex(mesh, [0.5 * x, 0.5 * y, z], [0, 0, up], [1, kNoEdge]);
  }
  for (let i = 1; i <= segments; ++i) {
    const [a, b] = up > 0 ? [i, i + 1] : [i + 1, i];
    mesh.indices.push(center, center + a, center + b);
  }
}

/** The cap below is left out of coarse ones, which are never seen from there. */
export function makeCylinder(segments: number, hasBase = true): UnitMesh {
  const mesh = emptyMesh();
  for (let i = 0; i <= segments; ++i) {
    const [x, y] = circle(i, segments);
    for (const z of [0, 1]) {
      addVertex(mesh, [0.5 * x, 0.5 * y, z], [x, y, 0], [kNoEdge, z]);
    }
  }
  for (let i = 0; i < 2 * segments; i += 2) {
    mesh.indices.push(i, i + 2, i + 3, i, i + 3, i + 1);
  }
  addCap(mesh, 1, segments);
  if (hasBase) {
    addCap(mesh, 0, segments);
  }
  return mesh;
}

/** A cylinder whose side takes its shade from its top and its foot. */
export function makeDisc(segments: number): UnitMesh {
  const mesh = emptyMesh();
  for (const z of [1, 0]) {
    for (let i = 0; i < segments; ++i) {
      const [x, y] = circle(i, segments);
      addVertex(mesh, [0.5 * x, 0.5 * y, z], z === 1 ? [0, 0, 1] : [x, y, 0], [kNoEdge, z]);
    }
  }
  for (let i = 2; i < segments; ++i) {
    mesh.indices.push(0, i - 1, i);
  }
  for (let i = 0; i < segments; ++i) {
    const next = (i + 1) % segments;
    mesh.indices.push(segments + i, segments + next, next, segments + i, next, i);
  }
  return mesh;
}

function addGrid(mesh: UnitMesh, rows: number, columns: number): void {
  const stride = columns + 1;
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const corner = row * stride + column;
      mesh.indices.push(corner, corner + 1, corner + stride + 1);
      mesh.indices.push(corner, corner + stride + 1, corner + stride);
    }
  }
}

function makeSphere(segments: number): UnitMesh {
  const mesh = emptyMesh();
  const rows = Math.max(2, segments >> 1);
  for (let row = 0; row <= rows; ++row) {
    const latitude = Math.PI * (row / rows - 0.5);
    const radius = Math.cos(latitude);
    for (let i = 0; i <= segments; ++i) {
      const [x, y] = circle(i, segments);
      const normal = [radius * x, radius * y, Math.sin(latitude)];
      const position = normal.map((part) => 0.5 * part);
      addVertex(mesh, position, normal, [kNoEdge, kNoEdge]);
    }
  }
  addGrid(mesh, rows, segments);
  return mesh;
}

function makeRing(segments: number): UnitMesh {
  const mesh = emptyMesh();
  const rows = Math.max(4, Math.floor(segments / 3));
  for (let row = 0; row <= rows; ++row) {
    const [outward, up] = circle(row, rows);
    for (let i = 0; i <= segments; ++i) {
      const [x, y] = circle(i, segments);
      addVertex(mesh, [0.5 * x, 0.5 * y, 0], [outward * x, outward * y, up], [kNoEdge, kNoEdge]);
    }
  }
  addGrid(mesh, rows, segments);
  return mesh;
}

export function makeMesh(kind: MeshKind, segments: number): UnitMesh {
  switch (kind) {
    case MeshKind.Box:
      return makeBox();
    case MeshKind.Cylinder:
      return makeCylinder(segments);
    case MeshKind.Sphere:
      return makeSphere(segments);
    case MeshKind.Ring:
      return makeRing(segments);
  }
}
