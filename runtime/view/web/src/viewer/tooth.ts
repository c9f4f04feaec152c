// Flanks of a tooth in the axial section: coordinates z and radius, with the angle left out.

import type { Part } from "./run_data.ts";

/** Affine function of z and radius: constant, coefficient of z, coefficient of the radius. */
type Affine = [number, number, number];

export type Side = "left" | "right";

/** A flank of a tooth. The left one has the larger angles about the z axis. */
export interface Flank {
  /** Closed outlines: z and radius alternate. */
  outline: number[][];
  /** Angle about the z axis, approximated; the first tooth is at angles near that of its sector. */
  angle: Affine;
}

/** Tooth of copy 0 of a gear. */
export interface Tooth {
  flanks: Record<Side, Flank>;
  /** Angle between the z axis and the direction along the face: 0 for cylindrical gears. */
  direction: number;
  /** 1 if the tip is on the side of the direction across the face, which is that of larger radii on cylindrical gears; otherwise -1. */
  tip: 1 | -1;
}

/** Share of the largest circumferential component of the normals from which a triangle belongs to a flank. */
const FLANK = 0.35;
/** Share of the largest area below which a line is not part of the outline. */
const FRAGMENT = 0.02;
/** Angles below which the direction along the face is an axis, rad. */
const SNAP = (2 * Math.PI) / 180;

const teeth = new WeakMap<Part, Tooth | null>();

/** Returns the tooth of a gear, or null if the part has none. */
export function toothOf(part: Part): Tooth | null {
  let tooth = teeth.get(part);
  if (tooth === undefined) teeth.set(part, (tooth = part.copies > 1 ? findTooth(part) : null));
  return tooth;
}

function findTooth({ points, triangles }: Part): Tooth | null {
  const angles = continuousAngles(points, triangles);
  const count = triangles.length / 3;
  const partner = quadrilaterals(points, triangles);
  // Circumferential component of the normals times twice the area.
  const around = new Float64Array(count);
  const area = new Float64Array(count);
  for (let t = 0; t < count; t++) {
    const [i, j, k] = [3 * triangles[3 * t]!, 3 * triangles[3 * t + 1]!, 3 * triangles[3 * t + 2]!];
    const [ux, uy, uz] = [points[j]! - points[i]!, points[j + 1]! - points[i + 1]!, points[j + 2]! - points[i + 2]!];
    const [vx, vy, vz] = [points[k]! - points[i]!, points[k + 1]! - points[i + 1]!, points[k + 2]! - points[i + 2]!];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const size = Math.hypot(nx, ny, nz);
    const [x, y] = [points[i]! + points[j]! + points[k]!, points[i + 1]! + points[j + 1]! + points[k + 1]!];
    if (!(size > 0)) continue;
    area[t] = size / 2;
    around[t] = (ny * x - nx * y) / (Math.hypot(x, y) || 1);
  }
  // Both halves of a quadrilateral belong to the flank, or none: the border would be a saw otherwise.
  const turn = around.map((value, t) => {
    const other = partner[t]!;
    return other < 0 ? value / (2 * area[t]! || 1) : (value + around[other]!) / (2 * (area[t]! + area[other]!) || 1);
  });
  const largest = turn.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const side = (sign: number): Flank | null => {
    const own: number[] = [];
    for (let t = 0; t < count; t++) if (area[t]! > 0 && sign * turn[t]! > FLANK * largest) own.push(t);
    const angle = fitAngle(points, triangles, angles, area, own);
    return angle && { outline: outlineOf(points, triangles, own), angle };
  };
  const [left, right] = [side(1), side(-1)];
  if (!left || !right) return null;
  const direction = faceDirection(left.angle, right.angle);
  return { flanks: { left, right }, direction, tip: tipSide(left, right, direction) };
}

/** For each triangle the one with which it has its longest edge in common, if it is the longest of both; otherwise -1. */
function quadrilaterals(points: Float32Array, triangles: Uint32Array): Int32Array {
  const partner = new Int32Array(triangles.length / 3).fill(-1);
  const open = new Map<string, number>();
  const length = (n: number, m: number) =>
    Math.hypot(points[3 * n]! - points[3 * m]!, points[3 * n + 1]! - points[3 * m + 1]!, points[3 * n + 2]! - points[3 * m + 2]!);
  for (let t = 0; t < partner.length; t++) {
    const corners = [...triangles.subarray(3 * t, 3 * t + 3)];
    const sides = corners.map((n, k) => [n, corners[(k + 1) % 3]!] as const);
    const [n, m] = sides.reduce((longest, side) => (length(...side) > length(...longest) ? side : longest));
    const key = n < m ? `${n} ${m}` : `${m} ${n}`;
    const other = open.get(key);
    if (other === undefined) open.set(key, t);
    else [partner[t], partner[other]] = [other, t];
  }
  return partner;
}

/**
 * Direction along the face. The thickness of the tooth, as an angle, changes from root to tip and is
 * constant along the face: on a conical tooth along the generatrices through the apex.
 */
function faceDirection(left: Affine, right: Affine): number {
  const z = left[1] - right[1];
  const r = left[2] - right[2];
  if (!(Math.hypot(z, r) > 0)) return 0;
  // Perpendicular to the gradient, towards positive z.
  const direction = Math.atan2(r >= 0 ? -z : z, Math.abs(r));
  if (Math.abs(direction) < SNAP) return 0;
  if (Math.abs(direction) > Math.PI / 2 - SNAP) return Math.PI / 2;
  return direction;
}

/** Side of the tip: the thickness of the tooth decreases from root to tip. */
function tipSide(left: Flank, right: Flank, direction: number): 1 | -1 {
  const outline = left.outline[0] ?? [];
  const mean = (offset: number) => outline.reduce((sum, value, i) => (i % 2 === offset ? sum + (2 * value) / outline.length : sum), 0);
  const thickness = evaluate(left.angle, mean(0), mean(1)) - evaluate(right.angle, mean(0), mean(1));
  const across = Math.cos(direction) * (left.angle[2] - right.angle[2]) - Math.sin(direction) * (left.angle[1] - right.angle[1]);
  // A sector around a gap has the flanks of two teeth, and the width of the gap in place of the thickness.
  return across * thickness <= 0 ? 1 : -1;
}

/** Angles of the points about the z axis, continuous along the triangles: helical teeth exceed half a turn. */
function continuousAngles(points: Float32Array, triangles: Uint32Array): Float64Array {
  const count = points.length / 3;
  let [x, y] = [0, 0];
  for (let i = 0; i < points.length; i += 3) {
    x += points[i]!;
    y += points[i + 1]!;
  }
  const middle = Math.atan2(y, x);
  const near = (angle: number, reference: number) => angle - 2 * Math.PI * Math.round((angle - reference) / (2 * Math.PI));
  const raw = (n: number) => Math.atan2(points[3 * n + 1]!, points[3 * n]!);
  const starts = new Uint32Array(count + 1);
  for (const n of triangles) starts[n + 1]!++;
  for (let n = 0; n < count; n++) starts[n + 1]! += starts[n]!;
  const next = starts.slice(0, count);
  const corners = new Uint32Array(triangles.length);
  triangles.forEach((n, c) => (corners[next[n]!++] = c));
  const angles = new Float64Array(count).fill(NaN);
  for (let seed = 0; seed < count; seed++) {
    if (!Number.isNaN(angles[seed]!)) continue;
    angles[seed] = near(raw(seed), middle);
    const queue = [seed];
    for (let n = queue.pop(); n !== undefined; n = queue.pop()) {
      for (let s = starts[n]!; s < starts[n + 1]!; s++) {
        const t = corners[s]! - (corners[s]! % 3);
        for (let k = 0; k < 3; k++) {
          const m = triangles[t + k]!;
          if (!Number.isNaN(angles[m]!)) continue;
          angles[m] = near(raw(m), angles[n]!);
          queue.push(m);
        }
      }
    }
  }
  return angles;
}

/** Fits the angle of triangles as an affine function of z and radius, by weighted least squares. */
function fitAngle(points: Float32Array, triangles: Uint32Array, angles: Float64Array, area: Float64Array, own: number[]): Affine | null {
  const rows: [number, number, number, number][] = own.map((t) => {
    let [z, r, a] = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const n = triangles[3 * t + k]!;
      z += points[3 * n + 2]! / 3;
      r += Math.hypot(points[3 * n]!, points[3 * n + 1]!) / 3;
      a += angles[n]! / 3;
    }
    return [area[t]!, z, r, a];
  });
  const total = rows.reduce((sum, [w]) => sum + w, 0);
  if (!(total > 0)) return null;
  const mean = [1, 2, 3].map((k) => rows.reduce((sum, row) => sum + row[0] * row[k]!, 0) / total) as Affine;
  let [zz, zr, rr, za, ra] = [0, 0, 0, 0, 0];
  for (const [w, z, r, a] of rows) {
    const [dz, dr, da] = [z - mean[0], r - mean[1], a - mean[2]];
    zz += w * dz * dz;
    zr += w * dz * dr;
    rr += w * dr * dr;
    za += w * dz * da;
    ra += w * dr * da;
  }
  const determinant = zz * rr - zr * zr;
  // A flank that is a single line has no gradient.
  const [b, c] = determinant > 1e-12 * (zz + rr) ** 2 ? [(za * rr - ra * zr) / determinant, (ra * zz - za * zr) / determinant] : [0, 0];
  return [mean[2] - b * mean[0] - c * mean[1], b, c];
}

/** Borders of a set of triangles as closed lines in the axial section. */
function outlineOf(points: Float32Array, triangles: Uint32Array, own: number[]): number[][] {
  const first = new Map<string, number>();
  const welded = (n: number) => {
    const key = `${points[3 * n]} ${points[3 * n + 1]} ${points[3 * n + 2]}`;
    const known = first.get(key);
    if (known === undefined) first.set(key, n);
    return known ?? n;
  };
  const edges = new Set<string>();
  for (const t of own) {
    const corners = [0, 1, 2].map((k) => welded(triangles[3 * t + k]!));
    for (let k = 0; k < 3; k++) {
      const [a, b] = [corners[k]!, corners[(k + 1) % 3]!];
      if (!edges.delete(`${b} ${a}`)) edges.add(`${a} ${b}`);
    }
  }
  const next = new Map<number, number[]>();
  for (const edge of edges) {
    const [a, b] = edge.split(" ").map(Number) as [number, number];
    next.set(a, [...(next.get(a) ?? []), b]);
  }
  const loops: number[][] = [];
  for (const start of next.keys()) {
    const loop: number[] = [];
    for (let n: number | undefined = start; n !== undefined; n = next.get(n)?.pop()) {
      if (loop.length > 0 && n === start) break;
      loop.push(points[3 * n + 2]!, Math.hypot(points[3 * n]!, points[3 * n + 1]!));
    }
    if (loop.length > 4) loops.push(loop);
  }
  // Single triangles in the fillet are not an outline.
  const largest = Math.max(...loops.map(enclosed), 0);
  return loops.filter((loop) => enclosed(loop) > FRAGMENT * largest);
}

/** Area within a closed line. */
function enclosed(loop: number[]): number {
  let twice = 0;
  for (let i = 0; i < loop.length; i += 2) {
    const [x, y, u, v] = [loop[i]!, loop[i + 1]!, loop[(i + 2) % loop.length]!, loop[(i + 3) % loop.length]!];
    twice += x * v - y * u;
  }
  return Math.abs(twice) / 2;
}

export function evaluate([a, b, c]: Affine, z: number, r: number): number {
  return a + b * z + c * r;
}
