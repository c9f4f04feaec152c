// The point of a surface under the pointer, and the value there.

import * as THREE from "three";
import type { PartView } from "./part_view.ts";
import { placesOfMesh, type Contacts, type DeformedMesh } from "./run_data.ts";

/** Intersection of the pointer's ray with a part. */
export interface Hit {
  view: PartView;
  /** Index of the copy, or -1 for a deformed mesh. */
  copy: number;
  /** Index among the part's meshes, or -1. */
  mesh: number;
  /** Nodes of the triangle; of a cap, of the surface behind it. */
  nodes: [number, number, number];
  /** Barycentric coordinates of the point. */
  weights: [number, number, number];
  /** World coordinates. */
  point: THREE.Vector3;
  distance: number;
  /** The ray enters through the cap of the cut. */
  cap: boolean;
}

/** A ray in coordinates of a surface. */
interface LocalRay {
  origin: [number, number, number];
  direction: [number, number, number];
}

interface Candidate {
  distance: number;
  triangle: number;
  u: number;
  v: number;
  facing: boolean;
}

/** Displacements to be added with a factor. */
export interface Deformation {
  displacements: Float32Array;
  factor: number;
}

/**
 * Finds the nearest intersection beyond `from` (Möller and Trumbore 1997). The ray's direction need not have unit length; distances are multiples of it.
 */
export function intersect(
  ray: LocalRay,
  points: ArrayLike<number>,
  triangles: Uint32Array,
  deformation: Deformation | null,
  from: number,
): Candidate | null {
  const [ox, oy, oz] = ray.origin;
  const [dx, dy, dz] = ray.direction;
  let best: Candidate | null = null;
  let nearest = Infinity;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!;
    const b = 3 * triangles[t + 1]!;
    const c = 3 * triangles[t + 2]!;
    let ax = points[a]!;
    let ay = points[a + 1]!;
    let az = points[a + 2]!;
    let bx = points[b]!;
    let by = points[b + 1]!;
    let bz = points[b + 2]!;
    let cx = points[c]!;
    let cy = points[c + 1]!;
    let cz = points[c + 2]!;
    if (deformation) {
      const { displacements, factor } = deformation;
      ax += factor * displacements[a]!;
      ay += factor * displacements[a + 1]!;
      az += factor * displacements[a + 2]!;
      bx += factor * displacements[b]!;
      by += factor * displacements[b + 1]!;
      bz += factor * displacements[b + 2]!;
      cx += factor * displacements[c]!;
      cy += factor * displacements[c + 1]!;
      cz += factor * displacements[c + 2]!;
    }
    const e1x = bx - ax;
    const e1y = by - ay;
    const e1z = bz - az;
    const e2x = cx - ax;
    const e2y = cy - ay;
    const e2z = cz - az;
    const px = dy * e2z - dz * e2y;
    const py = dz * e2x - dx * e2z;
    const pz = dx * e2y - dy * e2x;
    const determinant = e1x * px + e1y * py + e1z * pz;
    if (determinant === 0) continue;
    const inverse = 1 / determinant;
    const sx = ox - ax;
    const sy = oy - ay;
    const sz = oz - az;
    const u = (sx * px + sy * py + sz * pz) * inverse;
    if (u < -1e-9 || u > 1 + 1e-9) continue;
    const qx = sy * e1z - sz * e1y;
    const qy = sz * e1x - sx * e1z;
    const qz = sx * e1y - sy * e1x;
    const v = (dx * qx + dy * qy + dz * qz) * inverse;
    if (v < -1e-9 || u + v > 1 + 1e-9) continue;
    const distance = (e2x * qx + e2y * qy + e2z * qz) * inverse;
    if (distance <= from || distance >= nearest) continue;
    nearest = distance;
    best = { distance, triangle: t, u, v, facing: determinant > 0 };
  }
  return best;
}

/** Part of a ray that the cut leaves, as distances. */
export function clipRay(origin: THREE.Vector3, direction: THREE.Vector3, plane: THREE.Vector4 | null): [number, number] {
  if (!plane) return [0, Infinity];
  const start = plane.x * origin.x + plane.y * origin.y + plane.z * origin.z + plane.w;
  const slope = plane.x * direction.x + plane.y * direction.y + plane.z * direction.z;
  if (slope === 0) return start > 0 ? [Infinity, Infinity] : [0, Infinity];
  const crossing = -start / slope;
  return slope < 0 ? [Math.max(0, crossing), Infinity] : [0, crossing];
}

const inverse = new THREE.Matrix4();
const origin = new THREE.Vector3();
const direction = new THREE.Vector3();
const localRay = new THREE.Ray();
const sphere = new THREE.Sphere();

/** Finds the nearest visible point of the parts along a ray in world coordinates. */
export function pick(
  ray: THREE.Ray,
  views: readonly PartView[],
  meshes: readonly (readonly DeformedMesh[])[],
  factor: number,
  plane: THREE.Vector4 | null,
): Hit | null {
  const [from, to] = clipRay(ray.origin, ray.direction, plane);
  let best: Hit | null = null;
  const consider = (view: PartView, copy: number, mesh: number, found: Candidate | null, triangles: Uint32Array, open: boolean) => {
    if (!found) return;
    // A ray that meets the inner side of a closed surface has entered through the section, on the plane.
    const cap = plane !== null && from > 0 && !found.facing && !open;
    const distance = cap ? from : found.distance;
    if (distance > to || (best && distance >= best.distance)) return;
    const t = found.triangle;
    best = {
      view,
      copy,
      mesh,
      nodes: [triangles[t]!, triangles[t + 1]!, triangles[t + 2]!],
      weights: [1 - found.u - found.v, found.u, found.v],
      distance,
      point: ray.at(distance, new THREE.Vector3()),
      cap,
    };
  };
  for (const view of views) {
    // Translucent parts do not hide the parts behind them, so the pointer ignores them.
    if (view.visibility !== "visible" || !view.present) continue;
    inverse.copy(view.group.matrixWorld).invert();
    origin.copy(ray.origin).applyMatrix4(inverse);
    direction.copy(ray.direction).transformDirection(inverse);
    const local = view.copies.sphere;
    const { triangles } = view.part;
    const copies = view.presentCopies.map((copy) => [copy, triangles] as const);
    const rest = view.rest ? view.replacedCopies.map((copy) => [copy, view.restTriangles] as const) : [];
    for (const [copy, triangles] of [...copies, ...rest]) {
      const angle = (-2 * Math.PI * copy) / view.part.copies;
      const cos = Math.cos(angle);
      const sin = Math.sin(angle);
      localRay.origin.set(cos * origin.x - sin * origin.y, sin * origin.x + cos * origin.y, origin.z);
      localRay.direction.set(cos * direction.x - sin * direction.y, sin * direction.x + cos * direction.y, direction.z);
      sphere.copy(local);
      if (!localRay.intersectsSphere(sphere) || !localRay.intersectsBox(view.copies.box)) continue;
      const found = intersect(toArrays(localRay), view.part.points, triangles, null, from);
      consider(view, copy, -1, found, triangles, view.part.open);
    }
    localRay.origin.copy(origin);
    localRay.direction.copy(direction);
    const list = meshes[view.part.index] ?? [];
    list.forEach((mesh, i) => {
      const { triangles } = mesh.shape;
      const { displacements } = mesh;
      const found = intersect(toArrays(localRay), placesOfMesh(mesh), triangles, { displacements, factor }, from);
      consider(view, -1, i, found, triangles, mesh.shape.open);
    });
  }
  return best;
}

function toArrays(ray: THREE.Ray): LocalRay {
  return {
    origin: [ray.origin.x, ray.origin.y, ray.origin.z],
    direction: [ray.direction.x, ray.direction.y, ray.direction.z],
  };
}

/** A contact cell under the pointer. */
export interface CellHit {
  cell: number;
  distance: number;
}

/** Finds the nearest loaded contact cell along a ray in ground coordinates. */
export function pickCell(
  ray: THREE.Ray,
  contacts: Contacts,
  visible: (cell: number) => boolean,
  range: [number, number],
): CellHit | null {
  let best: CellHit | null = null;
  const local = toArrays(ray);
  for (let c = 0; c < contacts.count; c++) {
    if (!(contacts.pressures[c]! > 0) || !visible(c)) continue;
    const corners = contacts.corners.subarray(12 * c, 12 * c + 12);
    const found = intersect(local, corners, CELL, null, range[0]);
    if (found && found.distance < range[1] && (!best || found.distance < best.distance)) {
      best = { cell: c, distance: found.distance };
    }
  }
  return best;
}

const CELL = new Uint32Array([0, 1, 2, 0, 2, 3]);
