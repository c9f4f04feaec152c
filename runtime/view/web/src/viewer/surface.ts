// Display surfaces: vertex normals with sharp creases, and feature edges.

import { seamOf } from "./seams.ts";

/** A surface with its points split at creases, so that each vertex has one normal. */
export interface Surface {
  /** Node of the input from which each vertex comes. */
  nodes: Uint32Array;
  /** First vertex of each node. */
  firstVertex: Uint32Array;
  normals: Float32Array;
  triangles: Uint32Array;
  /** Pairs of vertices at creases and open borders. */
  features: Uint32Array;
  /** Partners of the nodes on the last cut. */
  seam: Int32Array;
}

/** Cosine of the angle between faces from which an edge is a crease: 32°. */
const CREASE = Math.cos((32 * Math.PI) / 180);

/** Bits of a number, the same for 0 and −0. */
const unsigned = (bits: number) => (bits === 0x80000000 ? 0 : bits);

/** For each point the first point at the same location: faces that meet there are neighbours. */
function weld(points: Float32Array): Uint32Array {
  const count = points.length / 3;
  const bits = new Uint32Array(points.buffer, points.byteOffset, points.length);
  let size = 1;
  while (size < 2 * count) size *= 2;
  // Open addressing: 0 is an empty slot, n + 1 the point n.
  const table = new Uint32Array(size);
  const result = new Uint32Array(count);
  for (let n = 0; n < count; n++) {
    const [x, y, z] = [unsigned(bits[3 * n]!), unsigned(bits[3 * n + 1]!), unsigned(bits[3 * n + 2]!)];
    let slot = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
    slot = (slot ^ (slot >>> 15)) & (size - 1);
    for (;;) {
      const entry = table[slot]!;
      if (entry === 0) {
        table[slot] = n + 1;
        result[n] = n;
        break;
      }
      const m = 3 * (entry - 1);
      if (unsigned(bits[m]!) === x && unsigned(bits[m + 1]!) === y && unsigned(bits[m + 2]!) === z) {
        result[n] = entry - 1;
        break;
      }
      slot = (slot + 1) & (size - 1);
    }
  }
  return result;
}

/** Corners of triangles at each node, in compressed rows. */
function incidence(triangles: Uint32Array, count: number): { starts: Uint32Array; corners: Uint32Array } {
  const starts = new Uint32Array(count + 1);
  for (let c = 0; c < triangles.length; c++) starts[triangles[c]! + 1]!++;
  for (let n = 0; n < count; n++) starts[n + 1]! += starts[n]!;
  const next = starts.slice(0, count);
  const corners = new Uint32Array(triangles.length);
  for (let c = 0; c < triangles.length; c++) corners[next[triangles[c]!]!++] = c;
  return { starts, corners };
}

/** Normals of the triangles; their lengths are twice the areas. */
function faceNormals(points: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const i = 3 * triangles[t]!;
    const j = 3 * triangles[t + 1]!;
    const k = 3 * triangles[t + 2]!;
    const ux = points[j]! - points[i]!;
    const uy = points[j + 1]! - points[i + 1]!;
    const uz = points[j + 2]! - points[i + 2]!;
    const vx = points[k]! - points[i]!;
    const vy = points[k + 1]! - points[i + 1]!;
    const vz = points[k + 2]! - points[i + 2]!;
    normals[t] = uy * vz - uz * vy;
    normals[t + 1] = uz * vx - ux * vz;
    normals[t + 2] = ux * vy - uy * vx;
  }
  return normals;
}

/** Returns the first corner of the triangle that has the edge from `a` to `b`, or -1. */
function triangleWithEdge(
  triangles: Uint32Array,
  starts: Uint32Array,
  corners: Uint32Array,
  a: number,
  b: number,
): number {
  for (let s = starts[a]!; s < starts[a + 1]!; s++) {
    const c = corners[s]!;
    const t = c - (c % 3);
    if (triangles[t + ((c + 1) % 3)] === b) return t;
  }
  return -1;
}

/**
 * Faces of the neighbouring copies at the nodes of a seam: the normals at a seam must include them,
 * or a line appears between the copies. Returns for each seam node the partner nodes and the sign
 * of the rotation to them.
 */
function seamPartners(seam: Int32Array, welded: Uint32Array, open: Uint8Array): Map<number, [number, number][]> {
  const partners = new Map<number, [number, number][]>();
  const add = (node: number, partner: number, sign: number) => partners.set(node, [...(partners.get(node) ?? []), [partner, sign]]);
  seam.forEach((partner, n) => {
    if (partner < 0 || welded[n] !== n || !open[n]) return;
    add(n, welded[partner]!, 1);
    add(welded[partner]!, n, -1);
  });
  return partners;
}

/**
 * Splits the points of a surface at creases and computes normals. `copies` is the number of copies
 * about the z axis if the surface is one sector of them, otherwise 1.
 */
export function buildSurface(points: Float32Array, triangles: Uint32Array, copies: number): Surface {
  const count = points.length / 3;
  const welded = weld(points);
  const joined = triangles.map((node) => welded[node]!);
  const { starts, corners } = incidence(joined, count);
  const faces = faceNormals(points, triangles);

  const open = new Uint8Array(count);
  const featureCorners: number[] = [];
  for (let c = 0; c < triangles.length; c++) {
    const t = c - (c % 3);
    const a = joined[c]!;
    const b = joined[t + ((c + 1) % 3)]!;
    // Both ends of an edge of a degenerate triangle are the same point.
    if (a === b) continue;
    const other = triangleWithEdge(joined, starts, corners, b, a);
    if (other < 0) {
      open[a] = open[b] = 1;
      if (copies === 1) featureCorners.push(c);
    } else if (t < other && cosine(faces, t, faces, other) < CREASE) {
      featureCorners.push(c);
    }
  }

  const seam = seamOf(points, copies);
  const partners = seamPartners(seam, welded, open);
  const result = splitVertices(triangles, welded, copies, starts, corners, faces, partners);
  const features = new Uint32Array(2 * featureCorners.length);
  featureCorners.forEach((c, i) => {
    const t = c - (c % 3);
    // Lines have no normals: one vertex per point makes them continuous.
    features[2 * i] = result.firstVertex[joined[c]!]!;
    features[2 * i + 1] = result.firstVertex[joined[t + ((c + 1) % 3)]!]!;
  });
  return { ...result, features, seam };
}

/** Several times as fast as Math.hypot. The squares of single-precision numbers neither overflow nor underflow. */
const length = (x: number, y: number, z: number) => Math.sqrt(x * x + y * y + z * z);

function cosine(a: Float32Array, i: number, b: ArrayLike<number>, j: number): number {
  const dot = a[i]! * b[j]! + a[i + 1]! * b[j + 1]! + a[i + 2]! * b[j + 2]!;
  const sizes = length(a[i]!, a[i + 1]!, a[i + 2]!) * length(b[j]!, b[j + 1]!, b[j + 2]!);
  // A degenerate triangle has no direction and makes no crease.
  return sizes > 0 ? dot / sizes : 1;
}

function splitVertices(
  triangles: Uint32Array,
  welded: Uint32Array,
  copies: number,
  starts: Uint32Array,
  corners: Uint32Array,
  faces: Float32Array,
  partners: Map<number, [number, number][]>,
) {
  const count = welded.length;
  const nodes: number[] = [];
  const normals: number[] = [];
  const firstVertex = new Uint32Array(count);
  const split = new Uint32Array(triangles.length);
  const step = (2 * Math.PI) / copies;
  for (let n = 0; n < count; n++) {
    const first = nodes.length;
    firstVertex[n] = first;
    const w = welded[n]!;
    const extra = partnerFaces(w, partners, starts, corners, faces, step);
    for (let s = starts[w]!; s < starts[w + 1]!; s++) {
      const c = corners[s]!;
      // Other points at the same location have vertices of their own, because their fields can differ.
      if (triangles[c] !== n) continue;
      const t = c - (c % 3);
      let x = 0;
      let y = 0;
      let z = 0;
      for (let o = starts[w]!; o < starts[w + 1]!; o++) {
        const u = corners[o]! - (corners[o]! % 3);
        if (u !== t && cosine(faces, t, faces, u) < CREASE) continue;
        x += faces[u]!;
        y += faces[u + 1]!;
        z += faces[u + 2]!;
      }
      for (let e = 0; e < extra.length; e += 3) {
        if (cosine(faces, t, extra, e) < CREASE) continue;
        x += extra[e]!;
        y += extra[e + 1]!;
        z += extra[e + 2]!;
      }
      const size = length(x, y, z) || 1;
      x /= size;
      y /= size;
      z /= size;
      let vertex = first;
      while (vertex < nodes.length) {
        const i = 3 * vertex;
        if (normals[i]! * x + normals[i + 1]! * y + normals[i + 2]! * z > 0.99999) break;
        vertex++;
      }
      if (vertex === nodes.length) {
        nodes.push(n);
        normals.push(x, y, z);
      }
      split[c] = vertex;
    }
    if (nodes.length === first) {
      // A node without a triangle can still be the end of an edge.
      nodes.push(n);
      normals.push(0, 0, 1);
    }
  }
  return {
    nodes: Uint32Array.from(nodes),
    firstVertex,
    normals: Float32Array.from(normals),
    triangles: split,
  };
}

const NO_FACES: number[] = [];

function partnerFaces(
  node: number,
  partners: Map<number, [number, number][]>,
  starts: Uint32Array,
  corners: Uint32Array,
  faces: Float32Array,
  step: number,
): number[] {
  const list = partners.get(node);
  if (!list) return NO_FACES;
  const result: number[] = [];
  for (const [partner, sign] of list) {
    const cos = Math.cos(sign * step);
    const sin = Math.sin(sign * step);
    for (let s = starts[partner]!; s < starts[partner + 1]!; s++) {
      const u = corners[s]! - (corners[s]! % 3);
      result.push(cos * faces[u]! - sin * faces[u + 1]!, sin * faces[u]! + cos * faces[u + 1]!, faces[u + 2]!);
    }
  }
  return result;
}
