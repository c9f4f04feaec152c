// Levels of detail: coarser surfaces for copies that are small in the picture.
//
// Vertices in a cell of a grid become one (vertex clustering, Rossignac and Borrel 1993). The map of
// the vertices takes a closed surface to a closed surface, so that the caps of the cut stay correct.

import { rotationOf } from "./seams.ts";
import type { Surface } from "./surface.ts";

export interface CoarseSurface {
  points: Float32Array;
  normals: Float32Array;
  /** 1 for vertices on the last cut, which are those of the next copy; otherwise 0. */
  seam: Float32Array;
  /** All triangles: a closed surface. */
  closed: Uint32Array;
  /** Triangles that face outward. The others are folds, below outward ones. */
  triangles: Uint32Array;
}

/** Cells along the diagonal of a copy, finest level first. */
export const LEVELS = [48, 32, 16, 8];
/** Largest cell in pixels. */
const PIXELS = 1.6;

/** Level for a copy whose diagonal has `size` pixels; -1 for the full surface. */
export function levelFor(size: number): number {
  let level = -1;
  LEVELS.forEach((cells, i) => {
    if (size <= PIXELS * cells) level = i;
  });
  return level;
}

/** Direction of the main component of a normal, 0 to 5. Sharp edges separate these directions. */
function direction(x: number, y: number, z: number): number {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  if (ax >= ay && ax >= az) return x > 0 ? 0 : 1;
  if (ay >= az) return y > 0 ? 2 : 3;
  return z > 0 ? 4 : 5;
}

/**
 * Importance of each node for the shape: 2 for corners, 1 for edges, 0 elsewhere. The mean of the most
 * important points of a cell keeps edges sharp and end faces plane.
 */
function importance({ nodes, features, seam }: Surface): Uint8Array {
  const ends = new Uint32Array(seam.length);
  for (const vertex of features) ends[nodes[vertex]!]!++;
  return Uint8Array.from(ends, (count) => (count === 0 ? 0 : count === 2 ? 1 : 2));
}

/** Cell of each node, the cells of the nodes on the last cut, and the points of the cells. */
function clusters(points: Float32Array, surface: Surface, cell: number) {
  const { seam } = surface;
  const rank = importance(surface);
  const first = new Set(seam);
  const cells = new Map<string, number>();
  const cellOf = new Uint32Array(seam.length);
  const lastCells = new Map<number, number>();
  const sums: number[] = [];
  const ranks: number[] = [];
  const index = (key: string) => {
    let c = cells.get(key);
    if (c === undefined) {
      c = cells.size;
      cells.set(key, c);
      sums.push(0, 0, 0, 0);
      ranks.push(0);
    }
    return c;
  };
  for (let n = 0; n < seam.length; n++) {
    const partner = seam[n]!;
    const i = 3 * (partner < 0 ? n : partner);
    const [x, y, z] = [points[i]!, points[i + 1]!, points[i + 2]!];
    const key = `${Math.floor(x / cell)},${Math.floor(y / cell)},${Math.floor(z / cell)}`;
    // Both cuts of a sector must become the same line, or gaps open between the copies.
    const c = index(partner >= 0 ? `last ${key}` : first.has(n) ? `first ${key}` : key);
    if (partner >= 0) lastCells.set(c, index(`first ${key}`));
    cellOf[n] = c;
    if (rank[n]! < ranks[c]!) continue;
    if (rank[n]! > ranks[c]!) sums.fill(0, 4 * c, 4 * c + 4);
    ranks[c] = rank[n]!;
    [x, y, z, 1].forEach((v, k) => (sums[4 * c + k]! += v));
  }
  const places = Float32Array.from({ length: 3 * ranks.length }, (_, i) => {
    const c = lastCells.get(Math.floor(i / 3)) ?? Math.floor(i / 3);
    return sums[4 * c + (i % 3)]! / sums[4 * c + 3]!;
  });
  return { cellOf, lastCells, places };
}

/** Simplifies a surface with cells of the given size, m. */
export function coarsen(points: Float32Array, surface: Surface, copies: number, cell: number): CoarseSurface {
  const { nodes, normals, triangles } = surface;
  const { cellOf, lastCells, places } = clusters(points, surface, cell);
  const vertices = new Map<number, number>();
  const cellOfVertex: number[] = [];
  const directions: number[] = [];
  const map = new Uint32Array(nodes.length);
  for (let v = 0; v < nodes.length; v++) {
    const c = cellOf[nodes[v]!]!;
    const [nx, ny, nz] = [normals[3 * v]!, normals[3 * v + 1]!, normals[3 * v + 2]!];
    const key = 6 * c + direction(nx, ny, nz);
    let vertex = vertices.get(key);
    if (vertex === undefined) {
      vertex = vertices.size;
      vertices.set(key, vertex);
      cellOfVertex.push(c);
      directions.push(0, 0, 0);
    }
    directions[3 * vertex]! += nx;
    directions[3 * vertex + 1]! += ny;
    directions[3 * vertex + 2]! += nz;
    map[v] = vertex;
  }
  const result = {
    points: Float32Array.from(cellOfVertex.flatMap((c) => [...places.subarray(3 * c, 3 * c + 3)])),
    normals: new Float32Array(directions.length),
    seam: Float32Array.from(cellOfVertex, (c) => (lastCells.has(c) ? 1 : 0)),
  };
  for (let i = 0; i < directions.length; i += 3) {
    const size = Math.hypot(directions[i]!, directions[i + 1]!, directions[i + 2]!) || 1;
    for (let k = 0; k < 3; k++) result.normals[i + k] = directions[i + k]! / size;
  }
  const closed: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [map[triangles[t]!]!, map[triangles[t + 1]!]!, map[triangles[t + 2]!]!];
    const [p, q, r] = [cellOfVertex[a], cellOfVertex[b], cellOfVertex[c]];
    if (p !== q && q !== r && r !== p) closed.push(a, b, c);
  }
  const outward = closed.filter((_, i) => facesOutward(result, closed, i - (i % 3), copies));
  return { ...result, closed: Uint32Array.from(closed), triangles: Uint32Array.from(outward) };
}

/** Returns whether the normal of a triangle has the direction of the normals at its corners. */
function facesOutward({ points, normals, seam }: Omit<CoarseSurface, "closed" | "triangles">, triangles: number[], t: number, copies: number): boolean {
  const [cos, sin] = rotationOf(1, copies);
  const corners = triangles.slice(t, t + 3).map((vertex) => {
    const [x, y, z] = points.subarray(3 * vertex, 3 * vertex + 3) as unknown as [number, number, number];
    return seam[vertex] ? [cos * x - sin * y, sin * x + cos * y, z] : [x, y, z];
  });
  const edge = (k: number) => corners[k]!.map((v, i) => v - corners[0]![i]!) as [number, number, number];
  const [[ux, uy, uz], [vx, vy, vz]] = [edge(1), edge(2)];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  let sum = 0;
  for (let i = t; i < t + 3; i++) for (let k = 0; k < 3; k++) sum += normal[k]! * normals[3 * triangles[i]! + k]!;
  return sum >= 0;
}
