// A large scene for measurements: a gear of 1,000 teeth with 12 planets in a ribbed housing, whose
// displacements and stresses are known at the nodes of a mesh of tetrahedra.

import { ArrayWriter, meshFile } from "./array_writer.ts";
import type { Fixture } from "./fixture.ts";
import { gearSector } from "./gear_shapes.ts";

export const RING = { teeth: 1000, module: 1e-3, width: 40e-3, bore: 0.45 };
export const PLANET = { teeth: 60, module: 1e-3, width: 40e-3, bore: 10e-3 };
export const PLANETS = 12;

export const ring = gearSector(RING, 6, 14, 4);
export const planet = gearSector(PLANET, 6, 14, 4);

/** Cells of the housing in x, y and z, and their size, m. */
const SHAPE: [number, number, number] = [100, 100, 20];
const CELL = 13e-3;
/** Thickness of the walls and pitch of the ribs in cells. */
const WALL = 2;
const PITCH = 25;

export interface SolidMesh {
  points: Float32Array;
  /** Outer surface and its edges. */
  triangles: Uint32Array;
  edges: Uint32Array;
  /** Four nodes each. */
  tetrahedra: Uint32Array;
}

/** A box that is open at the top, with ribs below its bottom. */
function isSolid(i: number, j: number, k: number): boolean {
  const [nx, ny, nz] = SHAPE;
  if (i < 0 || j < 0 || k < 0 || i >= nx || j >= ny || k >= nz) return false;
  const ribs = 2;
  if (k < ribs) return i % PITCH < WALL || j % PITCH < WALL;
  return k < ribs + WALL || i < WALL || j < WALL || i >= nx - WALL || j >= ny - WALL;
}

/** Orders in which the six tetrahedra of a cell go along the axes from one corner to the opposite one. */
const PATHS = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] as const;

/** Divides each cell into six tetrahedra (Kuhn 1960), whose faces match those of the next cells. */
export function housingMesh(): SolidMesh {
  const [nx, ny, nz] = SHAPE;
  const numbers = new Map<number, number>();
  const points: number[] = [];
  const node = (i: number, j: number, k: number): number => {
    const key = (k * (ny + 1) + j) * (nx + 1) + i;
    let number = numbers.get(key);
    if (number === undefined) {
      number = numbers.size;
      numbers.set(key, number);
      points.push((i - nx / 2) * CELL, (j - ny / 2) * CELL, (k - nz / 2) * CELL);
    }
    return number;
  };
  // A face of the surface belongs to one tetrahedron. Keys are sorted nodes below 2^17.
  const faces = new Map<bigint, [number, number, number]>();
  const tetrahedra: number[] = [];
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      for (let i = 0; i < nx; i++) {
        if (!isSolid(i, j, k)) continue;
        for (const path of PATHS) {
          const at: [number, number, number] = [i, j, k];
          const t = [node(...at)];
          for (const axis of path) {
            at[axis]!++;
            t.push(node(...at));
          }
          tetrahedra.push(...(isEven(path) ? t : [t[0]!, t[2]!, t[1]!, t[3]!]));
          toggleFaces(faces, t, isEven(path));
        }
      }
    }
  }
  const triangles = Uint32Array.from([...faces.values()].flat());
  return { points: Float32Array.from(points), triangles, edges: edgesOf(triangles), tetrahedra: Uint32Array.from(tetrahedra) };
}

const isEven = ([a, b]: readonly [number, number, number]) => (b - a + 3) % 3 === 1;

function toggleFaces(faces: Map<bigint, [number, number, number]>, [a, b, c, d]: number[], even: boolean): void {
  for (const face of [[a, c, b], [a, b, d], [b, c, d], [a, d, c]] as [number, number, number][]) {
    const [p, q, r] = [...face].sort((x, y) => x - y) as [number, number, number];
    const key = (BigInt(p) << 34n) | (BigInt(q) << 17n) | BigInt(r);
    if (!faces.delete(key)) faces.set(key, even ? face : [face[0], face[2], face[1]]);
  }
}

function edgesOf(triangles: Uint32Array): Uint32Array {
  const edges: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let e = 0; e < 3; e++) {
      const [a, b] = [triangles[t + e]!, triangles[t + ((e + 1) % 3)]!];
      // The neighbour has the edge in the other direction.
      if (a < b) edges.push(a, b);
    }
  }
  return Uint32Array.from(edges);
}

/** Displacements and stresses that vary smoothly over the housing. */
function solution({ points }: SolidMesh): { displacements: Float32Array; stresses: Float32Array } {
  const count = points.length / 3;
  const displacements = new Float32Array(3 * count);
  const stresses = new Float32Array(6 * count);
  for (let n = 0; n < count; n++) {
    const [x, y, z] = [points[3 * n]!, points[3 * n + 1]!, points[3 * n + 2]!];
    const wave = Math.sin(9 * x) * Math.cos(7 * y);
    displacements.set([2e-4 * y * z, 1e-4 * x * z, 4e-5 * wave], 3 * n);
    stresses.set([8e7 * wave, 6e7 * Math.cos(5 * x + 3 * z), 2e7 * z, 1e7 * y, 2e7 * x, 3e7 * wave], 6 * n);
  }
  return { displacements, stresses };
}

/** Poses of the large gear, the planets and the housing. */
export function poses(): number[][] {
  const radius = 0.5e-3 * (RING.teeth + PLANET.teeth);
  const identity = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const planets = Array.from({ length: PLANETS }, (_, i) => {
    const a = (2 * Math.PI * i) / PLANETS;
    return [...identity, radius * Math.cos(a), radius * Math.sin(a), 0];
  });
  return [[...identity, 0, 0, 0], ...planets, [...identity, 0, 0, 0]];
}

/** The files of the scene, with a housing if there is a mesh of it. */
export function largeScene(housing: SolidMesh | null): Fixture {
  const parts = new ArrayWriter();
  const part = (name: string, kind: string, copies: number, shape: { points: ArrayLike<number>; triangles: ArrayLike<number>; edges: ArrayLike<number> }) => ({
    name, kind, copies,
    points: parts.add("f32", 3, shape.points),
    triangles: parts.add("u32", 3, shape.triangles),
    edges: parts.add("u32", 2, shape.edges),
  });
  const list = [part("ring", "gear", RING.teeth, ring)];
  for (let i = 1; i <= PLANETS; i++) list.push(part(`planet ${i}`, "gear", PLANET.teeth, planet));
  if (housing) list.push(part("housing", "body", 1, housing));
  const position = new ArrayWriter();
  const mesh = housing ? meshFile(housing) : null;
  const meshes = housing && mesh ? [deformedHousing(position, list.length - 1, housing, mesh.name)] : [];
  const header = { position: 0, time: 0, poses: position.add("f64", 12, poses().slice(0, list.length).flat()), forces: [], meshes };
  return {
    parts: parts.finish({ model: "ring.cx", parts: list }),
    positions: [{ position: 0, time: 0, data: position.finish(header) }],
    meshes: mesh ? { [mesh.name]: mesh.data } : {},
    meshPoints: [],
  };
}

function deformedHousing(writer: ArrayWriter, part: number, housing: SolidMesh, mesh: string) {
  const { displacements, stresses } = solution(housing);
  return {
    mesh,
    part,
    copy: 0,
    displacements: writer.add("f32", 3, displacements),
    stresses: writer.add("f32", 6, stresses),
    stress_errors: writer.add("f32", 1, new Float32Array(housing.points.length / 3)),
  };
}
