// Seams between the copies of a sector.
//
// The last cut of a copy is the first cut of the next one. Both copies draw the nodes there at the same
// place, to the last bit: a node of the last cut is the corresponding node of the first cut, with the
// rotation of the next copy. Otherwise rounding would leave gaps of single pixels.

/** Relative size of a cell within which points are the same. */
const SAME = 2e-5;

const known = new WeakMap<Float32Array, { copies: number; seam: Int32Array }>();

/**
 * Returns for each point of a sector on its last cut the point on its first cut that a rotation by the
 * pitch takes there, and -1 for all other points. Angles alone do not tell, because a helical sector is twisted.
 */
export function seamOf(points: Float32Array, copies: number): Int32Array {
  const found = known.get(points);
  if (found?.copies === copies) return found.seam;
  const seam = new Int32Array(points.length / 3).fill(-1);
  if (copies > 1) match(points, (2 * Math.PI) / copies, seam);
  known.set(points, { copies, seam });
  return seam;
}

function match(points: Float32Array, pitch: number, seam: Int32Array): void {
  let size = 0;
  for (let i = 0; i < points.length; i++) size = Math.max(size, Math.abs(points[i]!));
  if (!(size > 0)) return;
  const cell = size * SAME;
  // Three coordinates of at most 17 bits.
  const index = (v: number) => Math.round(v / cell) + 65536;
  const key = (x: number, y: number, z: number) => (index(x) * 131072 + index(y)) * 131072 + index(z);
  const grid = new Map<number, number>();
  for (let n = seam.length - 1; n >= 0; n--) grid.set(key(points[3 * n]!, points[3 * n + 1]!, points[3 * n + 2]!), n);
  const [cos, sin] = [Math.cos(pitch), Math.sin(pitch)];
  for (let n = 0; n < seam.length; n++) {
    // The place of this point in the next copy.
    const x = cos * points[3 * n]! + sin * points[3 * n + 1]!;
    const y = cos * points[3 * n + 1]! - sin * points[3 * n]!;
    const z = points[3 * n + 2]!;
    // A point near the border of a grid cell may be in the next one.
    for (let d = 0; d < 8; d++) {
      const [dx, dy, dz] = [d & 1 ? -0.25 : 0.25, d & 2 ? -0.25 : 0.25, d & 4 ? -0.25 : 0.25];
      const found = grid.get(key(x + dx * cell, y + dy * cell, z + dz * cell));
      // A point on the axis is its own partner.
      if (found === undefined || found === n) continue;
      seam[n] = found;
      break;
    }
  }
}

/** Rotation of a copy: cosine and sine. */
export function rotationOf(copy: number, copies: number): [number, number] {
  const angle = (2 * Math.PI * (copy % copies)) / copies;
  return [Math.cos(angle), Math.sin(angle)];
}

/** Rotations of a copy and of the next one, as the shaders need them. */
export function rotationsOf(copy: number, copies: number): [number, number, number, number] {
  return [...rotationOf(copy, copies), ...rotationOf(copy + 1, copies)];
}

/** Points whose nodes on the last cut are those of the first one, in the coordinates of the next copy. */
export function seamPoints(points: Float32Array, seam: Int32Array): Float32Array {
  const result = points.slice();
  seam.forEach((partner, n) => {
    if (partner >= 0) result.set(points.subarray(3 * partner, 3 * partner + 3), 3 * n);
  });
  return result;
}

/** Points of a copy in its place. */
export function placesOf(points: Float32Array, seam: Int32Array, copy: number, copies: number): Float64Array {
  const [cos, sin, nextCos, nextSin] = rotationsOf(copy, copies);
  const places = new Float64Array(points.length);
  for (let n = 0; n < seam.length; n++) {
    const partner = seam[n]!;
    const i = 3 * (partner < 0 ? n : partner);
    const [c, s] = partner < 0 ? [cos, sin] : [nextCos, nextSin];
    places[3 * n] = c * points[i]! - s * points[i + 1]!;
    places[3 * n + 1] = s * points[i]! + c * points[i + 1]!;
    places[3 * n + 2] = points[i + 2]!;
  }
  return places;
}

/**
 * Makes the displacements of two neighbouring copies equal at their seam. `weight` is that of the copy before the
 * seam: 0.5 for two computed copies, whose displacements differ by rounding, 0 or 1 if only one is computed.
 */
export function joinSeam(before: Float32Array, after: Float32Array, seam: Int32Array, weight: number): void {
  seam.forEach((partner, n) => {
    if (partner < 0) return;
    for (let k = 0; k < 3; k++) {
      const mean = weight * before[3 * n + k]! + (1 - weight) * after[3 * partner + k]!;
      before[3 * n + k] = after[3 * partner + k] = mean;
    }
  });
}
