// The value under the pointer.

import * as THREE from "three";
import type { Core } from "./core.ts";
import { poseMatrix } from "./display.ts";
import { isNodal } from "./fields.ts";
import { clipRay, pick, pickCell, type Hit } from "./picking.ts";
import { displacedPoint, type DeformedMesh } from "./run_data.ts";
import { weightsAt } from "./section.ts";

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
  /** Contact cell under the pointer. */
  cell?: number;
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
  const section = plane && isNodal(state.colours.field) ? probeSection(core, x, y, plane) : null;
  if (section) return section;
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
    // Hatched solids have no displacements: the point of the section is that of the undeformed part.
    point.copy(hit.point).applyMatrix4(matrix.copy(hit.view.group.matrixWorld).invert());
    point.applyMatrix4(poseMatrix(display.position?.poses ?? null, part.index, matrix));
    tooth = part.copies > 1 ? (mesh?.copy ?? hit.copy) : null;
    return { x, y, part: part.name, tooth, value: null, node, point };
  }
  if (mesh) {
    node = nearestNode(core, mesh, hit, x, y);
    if (node !== null) point.set(...displacedPoint(mesh, node, 0));
    else hit.nodes.forEach((n, i) => point.addScaledVector(scratch.set(...displacedPoint(mesh, n, 0)), hit.weights[i]!));
    if (isNodal(state.colours.field)) {
      const values = display.values(mesh, state.colours.field);
      value = node !== null ? values[node]! : hit.nodes.reduce((sum, n, i) => sum + hit.weights[i]! * values[n]!, 0);
    }
    tooth = part.copies > 1 ? mesh.copy : null;
  } else {
    interpolate(part.points, hit, point);
    point.applyAxisAngle(AXIS, (2 * Math.PI * hit.copy) / part.copies);
    tooth = part.copies > 1 ? hit.copy : null;
  }
  point.applyMatrix4(poseMatrix(display.position?.poses ?? null, part.index, matrix));
  return { x, y, part: part.name, tooth, value, node, point };
}

const AXIS = new THREE.Vector3(0, 0, 1);
const scratch = new THREE.Vector3();

/** Value on a section through the cells of a mesh: linear interpolation in the cell. */
function probeSection(core: Core, x: number, y: number, plane: THREE.Vector4): Probe | null {
  const { display, state } = core;
  const { field } = state.colours;
  if (!display || !isNodal(field)) return null;
  const [distance] = clipRay(ray.origin, ray.direction, plane);
  // The ray enters through the plane, or the section is not the first thing that it meets.
  if (!(distance > 0) || !Number.isFinite(distance)) return null;
  const world = ray.at(distance, new THREE.Vector3());
  for (const view of display.views) {
    if (!view.showsSections) continue;
    const local = world.clone().applyMatrix4(matrix.copy(view.group.matrixWorld).invert());
    for (const { mesh, section } of view.meshes) {
      if (!mesh || !section?.plane) continue;
      const triangle = section.section.find(local.x, local.y, local.z, section.plane);
      if (triangle < 0) continue;
      const { nodes, weights } = weightsAt(mesh, section.section.sources[triangle]!, display.factor, [local.x, local.y, local.z]);
      const values = display.values(mesh, field);
      const point = new THREE.Vector3();
      nodes.forEach((n, i) => point.addScaledVector(scratch.set(...displacedPoint(mesh, n, 0)), weights[i]!));
      point.applyMatrix4(poseMatrix(display.position?.poses ?? null, view.part.index, matrix));
      const value = nodes.reduce((sum, n, i) => sum + weights[i]! * values[n]!, 0);
      return { x, y, part: view.part.name, tooth: view.part.copies > 1 ? mesh.copy : null, value, node: null, point };
    }
  }
  return null;
}

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
    p.set(...displacedPoint(mesh, node, factor));
    p.applyMatrix4(hit.view.group.matrixWorld).project(scene.camera.active);
    const d = Math.hypot((0.5 + 0.5 * p.x) * scene.width - x, (0.5 - 0.5 * p.y) * scene.height - y);
    if (d <= distance) {
      distance = d;
      nearest = node;
    }
  }
  return nearest;
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
    cell: hit.cell,
    value: contacts.pressures[hit.cell]!,
    node: null,
    point,
  };
}

function name(core: Core, part: number): string {
  return core.parts?.parts[part]?.name ?? `part ${part}`;
}
