// Levels of detail: coarser surfaces for copies that are small in the picture.
//
// Vertices in a cell of a grid become one (vertex clustering, Rossignac and Borrel 1993). The map of
// the vertices takes a closed surface to a closed surface, so that the caps of the cut stay correct.

import type { Surface } from "./surface.ts";

export interface CoarseSurface {
  points: Float32Array;
  normals: Float32Array;
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

/** Simplifies a surface with cells of the given size, m. */
export function coarsen(points: Float32Array, surface: Surface, cell: number): CoarseSurface {
  const { nodes, normals, triangles, open } = surface;
  const middle = middleAngle(points);
  const cells = new Map<string, number>();
  const sums: number[] = [];
  const vertices = new Map<number, number>();
  const cellOf: number[] = [];
  const directions: number[] = [];
  const map = new Uint32Array(nodes.length);
  for (let v = 0; v < nodes.length; v++) {
    const n = 3 * nodes[v]!;
    const [x, y, z] = [points[n]!, points[n + 1]!, points[n + 2]!];
    // Both seams of a sector must become the same line, or gaps open between the copies. Radius and z
    // are the same on both of them.
    const key = open[nodes[v]!]
      ? `${side(x, y, middle)} ${Math.floor(Math.hypot(x, y) / cell + 1e-6)} ${Math.floor(z / cell + 1e-6)}`
      : `${Math.floor(x / cell)},${Math.floor(y / cell)},${Math.floor(z / cell)}`;
    let c = cells.get(key);
    if (c === undefined) {
      c = cells.size;
      cells.set(key, c);
      sums.push(0, 0, 0, 0);
    }
    sums[4 * c]! += x;
    sums[4 * c + 1]! += y;
    sums[4 * c + 2]! += z;
    sums[4 * c + 3]! += 1;
    const [nx, ny, nz] = [normals[3 * v]!, normals[3 * v + 1]!, normals[3 * v + 2]!];
    const vertexKey = 6 * c + direction(nx, ny, nz);
    let vertex = vertices.get(vertexKey);
    if (vertex === undefined) {
      vertex = vertices.size;
      vertices.set(vertexKey, vertex);
      cellOf.push(c);
      directions.push(0, 0, 0);
    }
    directions[3 * vertex]! += nx;
    directions[3 * vertex + 1]! += ny;
    directions[3 * vertex + 2]! += nz;
    map[v] = vertex;
  }
  const coarse = new Float32Array(3 * cellOf.length);
  const coarseNormals = new Float32Array(3 * cellOf.length);
  cellOf.forEach((c, vertex) => {
    const size = Math.hypot(directions[3 * vertex]!, directions[3 * vertex + 1]!, directions[3 * vertex + 2]!) || 1;
    for (let k = 0; k < 3; k++) {
      coarse[3 * vertex + k] = sums[4 * c + k]! / sums[4 * c + 3]!;
      coarseNormals[3 * vertex + k] = directions[3 * vertex + k]! / size;
    }
  });
  const kept: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [map[triangles[t]!]!, map[triangles[t + 1]!]!, map[triangles[t + 2]!]!];
    if (cellOf[a] === cellOf[b] || cellOf[b] === cellOf[c] || cellOf[c] === cellOf[a]) continue;
    kept.push(a, b, c);
  }
  return { points: coarse, normals: coarseNormals, triangles: Uint32Array.from(kept) };
}

/** Angle of the middle of a sector. */
function middleAngle(points: Float32Array): number {
  let x = 0;
  let y = 0;
  for (let i = 0; i < points.length; i += 3) {
    x += points[i]!;
    y += points[i + 1]!;
  }
  return Math.atan2(y, x);
}

function side(x: number, y: number, middle: number): "l" | "r" {
  return Math.sin(Math.atan2(y, x) - middle) > 0 ? "l" : "r";
}
