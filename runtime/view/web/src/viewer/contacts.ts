// Cells of the contact grids, coloured by pressure.

import * as THREE from "three";
import { ViewMaterial, type SharedUniforms } from "./materials.ts";
import type { Contacts } from "./run_data.ts";
import type { CellChoice } from "./state.ts";

export class ContactView {
  /** In ground coordinates. */
  readonly group = new THREE.Group();
  readonly materials: ViewMaterial[];

  #geometry = new THREE.BufferGeometry();
  #behind: THREE.Mesh;
  #contacts: Contacts | null = null;
  #ghost: ViewMaterial;
  #key = "";
  /** Outline of a marked cell, in ground coordinates. */
  readonly markLine = new THREE.LineLoop(
    new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({ color: "#e07b1f", transparent: true, depthTest: false }),
  );

  constructor(shared: SharedUniforms) {
    const front = new ViewMaterial(shared, ["FIELD"], { side: THREE.DoubleSide });
    // Cells between two flanks are behind one of them: a faint second pass shows where they are.
    const ghost = new ViewMaterial(shared, ["FIELD"], {
      side: THREE.DoubleSide,
      depthFunc: THREE.GreaterDepth,
      depthWrite: false,
    });
    ghost.alpha = 0.5;
    front.useField = ghost.useField = true;
    this.#ghost = ghost;
    this.materials = [front, ghost];
    const meshes = this.materials.map((material) => new THREE.Mesh(this.#geometry, material));
    for (const mesh of meshes) {
      mesh.frustumCulled = false;
      mesh.matrixAutoUpdate = false;
      this.group.add(mesh);
    }
    this.#behind = meshes[1]!;
    this.#behind.renderOrder = 99999;
    meshes[0]!.renderOrder = 5;
    this.markLine.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(12), 3));
    this.markLine.frustumCulled = false;
    this.markLine.matrixAutoUpdate = false;
    this.markLine.renderOrder = 250000;
    this.markLine.visible = false;
  }

  /** Marks a cell; -1 for none. Returns whether the picture has changed. */
  mark(contacts: Contacts | null, cell: number): boolean {
    const visible = contacts !== null && cell >= 0 && cell < contacts.count;
    if (!visible && !this.markLine.visible) return false;
    this.markLine.visible = visible;
    if (!visible) return true;
    const position = this.markLine.geometry.getAttribute("position") as THREE.BufferAttribute;
    (position.array as Float32Array).set(contacts.corners.subarray(12 * cell, 12 * cell + 12));
    position.needsUpdate = true;
    return true;
  }

  /** Sets the distance by which cells are drawn in front of the flanks, m. */
  setBias(bias: number): void {
    for (const material of this.materials) material.bias = bias;
    this.#ghost.bias = 0;
  }

  setBehind(on: boolean): void {
    this.#behind.visible = on;
  }

  get contacts(): Contacts | null {
    return this.#contacts;
  }

  /** Draws the loaded cells of the contacts that `visible` accepts. `key` changes whenever `visible` does. */
  set(contacts: Contacts | null, key: string, visible: (cell: number) => boolean): void {
    if (contacts === this.#contacts && key === this.#key) return;
    this.#contacts = contacts;
    this.#key = key;
    this.mark(null, -1);
    this.#geometry.dispose();
    this.group.visible = contacts !== null;
    if (!contacts) return;
    const cells: number[] = [];
    for (let c = 0; c < contacts.count; c++) if (contacts.pressures[c]! > 0 && visible(c)) cells.push(c);
    const points = new Float32Array(12 * cells.length);
    const values = new Float32Array(4 * cells.length);
    const index = new Uint32Array(6 * cells.length);
    cells.forEach((c, i) => {
      points.set(contacts.corners.subarray(12 * c, 12 * c + 12), 12 * i);
      values.fill(contacts.pressures[c]!, 4 * i, 4 * i + 4);
      const v = 4 * i;
      index.set([v, v + 1, v + 2, v, v + 2, v + 3], 6 * i);
    });
    this.#geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
    this.#geometry.setAttribute("field", new THREE.BufferAttribute(values, 1));
    this.#geometry.setIndex(new THREE.BufferAttribute(index, 1));
  }

  dispose(): void {
    this.#geometry.dispose();
    this.markLine.geometry.dispose();
    for (const material of this.materials) material.dispose();
  }
}

/** Zones of cells: those of the outputs `max_contact_pressure` and `max_edge_pressure`. Cells next to a side face are in neither. */
export const Zone = { Flank: 0, Edge: 1 } as const;

/** Returns whether a cell belongs to the displayed ones. */
export function isChosen(contacts: Contacts, cell: number, choice: CellChoice): boolean {
  return choice === "all" || contacts.zones[cell] === (choice === "edges" ? Zone.Edge : Zone.Flank);
}

/** Ratio of the largest pressures from which cells next to edges leave no colours for the flanks. */
const DOMINANT = 1.5;

/** Largest pressure of a choice of cells, Pa. */
export function largestPressure(contacts: Contacts, choice: CellChoice): number {
  return contacts.pressures.reduce((most, pressure, cell) => (isChosen(contacts, cell, choice) ? Math.max(most, pressure) : most), 0);
}

/** Returns whether cells outside of the flank zone have far larger pressures than the flanks. */
export function edgesDominate(contacts: Contacts): boolean {
  const flanks = largestPressure(contacts, "flanks");
  return flanks > 0 && largestPressure(contacts, "all") > DOMINANT * flanks;
}

/** Sum of pressure times area over the cells of each pair of gears, N. */
export function contactLoads(contacts: Contacts): Map<string, number> {
  const loads = new Map<string, number>();
  const p = contacts.corners;
  for (let c = 0; c < contacts.count; c++) {
    const o = 12 * c;
    // Area vector of a quadrilateral: half of the cross product of its diagonals.
    const ux = p[o + 6]! - p[o]!;
    const uy = p[o + 7]! - p[o + 1]!;
    const uz = p[o + 8]! - p[o + 2]!;
    const vx = p[o + 9]! - p[o + 3]!;
    const vy = p[o + 10]! - p[o + 4]!;
    const vz = p[o + 11]! - p[o + 5]!;
    const area = 0.5 * Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
    const key = `${contacts.parts[2 * c]} ${contacts.parts[2 * c + 1]}`;
    loads.set(key, (loads.get(key) ?? 0) + contacts.pressures[c]! * area);
  }
  return loads;
}
