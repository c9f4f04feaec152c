// The value under the pointer.

import * as THREE from "three";
import type { Core } from "./core.ts";
import { poseMatrix } from "./display.ts";
import { isNodal } from "./fields.ts";
import { clipRay, pick, pickCell, type Hit } from "./picking.ts";
import type { DeformedMesh } from "./run_data.ts";

/** Distance in pixels within which the pointer is at a node. */
const SNAP = 6;

export interface Probe {
  /** Pointer in pixels of the canvas. */
  x: number;
  y: number;
  part: string;
  tooth: number | null;
  /** Value of the selected field, SI; NaN if there is none here, null if no field is selected. */
  value: number | null;
  /** Node whose value is displayed without interpolation. */
  node: number | null;
  /** Undeformed point in ground coordinates, m. */
  point: THREE.Vector3;
}

const ray = new THREE.Ray();
const groundRay = new THREE.Ray();
const matrix = new THREE.Matrix4();

export function probeAt(core: Core, x: number, y: number): Probe | null {
  const { scene, display, state } = core;
  if (!scene || !display) return null;
  scene.ray(x, y, ray);
  const plane = display.cutPlane;
  const hit = pick(ray, display.views, display.meshes, display.factor, plane);
  const cell = probeCell(core, x, y, hit?.distance ?? Infinity);
  if (cell) return cell;
  if (!hit) return null;
  const { part } = hit.view;
  const point = new THREE.Vector3();
  const mesh = display.meshes[part.index]?.[hit.mesh];
  let value: number | null = state.colours.field === "plain" ? null : NaN;
  let node: number | null = null;
  let tooth: number | null = null;
  if (hit.cap) {
    point.copy(hit.point);
    return { x, y, part: part.name, tooth, value: null, node, point };
  }
  if (mesh) {
    interpolate(mesh.points, hit, point);
    node = nearestNode(core, mesh, hit, x, y);
    if (node !== null) point.fromArray(mesh.points, 3 * node);
    if (isNodal(state.colours.field)) {
      const values = display.values(mesh, state.colours.field);
      value = node !== null ? values[node]! : hit.nodes.reduce((sum, n, i) => sum + hit.weights[i]! * values[n]!, 0);
    }
    tooth = toothOf(mesh, hit, point);
  } else {
    interpolate(part.points, hit, point);
    point.applyAxisAngle(AXIS, (2 * Math.PI * hit.copy) / part.copies);
    tooth = part.copies > 1 ? hit.copy : null;
  }
  point.applyMatrix4(poseMatrix(display.position?.poses ?? null, part.index, matrix));
  return { x, y, part: part.name, tooth, value, node, point };
}

const AXIS = new THREE.Vector3(0, 0, 1);

function interpolate(points: Float32Array, hit: Hit, point: THREE.Vector3): void {
  point.set(0, 0, 0);
  hit.nodes.forEach((node, i) => {
    const weight = hit.weights[i]!;
    point.x += weight * points[3 * node]!;
    point.y += weight * points[3 * node + 1]!;
    point.z += weight * points[3 * node + 2]!;
  });
}

function nearestNode(core: Core, mesh: DeformedMesh, hit: Hit, x: number, y: number): number | null {
  const scene = core.scene!;
  const factor = core.display!.factor;
  let nearest: number | null = null;
  let distance = SNAP;
  const p = new THREE.Vector3();
  for (const node of hit.nodes) {
    p.fromArray(mesh.displacements, 3 * node).multiplyScalar(factor);
    p.x += mesh.points[3 * node]!;
    p.y += mesh.points[3 * node + 1]!;
    p.z += mesh.points[3 * node + 2]!;
    p.applyMatrix4(hit.view.group.matrixWorld).project(scene.camera.active);
    const d = Math.hypot((0.5 + 0.5 * p.x) * scene.width - x, (0.5 - 0.5 * p.y) * scene.height - y);
    if (d <= distance) {
      distance = d;
      nearest = node;
    }
  }
  return nearest;
}

/** Tooth at a point of a mesh: the one whose middle is nearest in angle. */
function toothOf(mesh: DeformedMesh, hit: Hit, point: THREE.Vector3): number | null {
  const { part, copies } = hit.view;
  if (part.copies <= 1) return null;
  const { center } = copies.sphere;
  const angle = Math.atan2(point.y, point.x) - Math.atan2(center.y, center.x);
  const step = (2 * Math.PI) / part.copies;
  let best: number | null = null;
  let distance = Infinity;
  for (const copy of mesh.copies) {
    const difference = Math.abs(Math.atan2(Math.sin(angle - copy * step), Math.cos(angle - copy * step)));
    if (difference < distance) {
      distance = difference;
      best = copy;
    }
  }
  return best;
}

function probeCell(core: Core, x: number, y: number, limit: number): Probe | null {
  const { display, state } = core;
  const position = display?.position;
  const contacts = state.colours.field === "contact_pressure" ? position?.contacts : null;
  if (!contacts || !position || !display) return null;
  const inverse = matrix.copy(core.scene!.root.matrixWorld).invert();
  groundRay.copy(ray).applyMatrix4(inverse);
  const range = clipRay(ray.origin, ray.direction, display.cutPlane);
  // Cells behind other surfaces count only if they are drawn there.
  if (!state.hidden_contacts) range[1] = Math.min(range[1], limit + 2e-3 * display.radius);
  const hit = pickCell(groundRay, contacts, (cell) => display.cellShown(state, position, cell), range);
  if (!hit) return null;
  const point = groundRay.at(hit.distance, new THREE.Vector3());
  // Names the gear that is shown, the first one if both are.
  const side = state.parts[name(core, contacts.parts[2 * hit.cell]!)] === "hidden" ? 1 : 0;
  const part = contacts.parts[2 * hit.cell + side]!;
  return {
    x,
    y,
    part: name(core, part),
    tooth: contacts.teeth[2 * hit.cell + side]!,
    value: contacts.pressures[hit.cell]!,
    node: null,
    point,
  };
}

function name(core: Core, part: number): string {
  return core.parts?.parts[part]?.name ?? `part ${part}`;
}
