// Force vectors at bearings and meshes.

import * as THREE from "three";
import { ViewMaterial, type SharedUniforms } from "./materials.ts";
import type { Label } from "./labels.ts";
import type { Force } from "./run_data.ts";
import { shortNames } from "./names.ts";
import { formatValue } from "./units.ts";

const COLOURS = { bearing: "#2f6fb5", mesh: "#c2502b" };
const UP = new THREE.Vector3(0, 1, 0);

export interface ForceOptions {
  bearings: boolean;
  meshes: boolean;
  labels: boolean;
  /** Names of the parts. */
  names: string[];
  scale: number;
  /** Radius of the scene, m. The longest arrow has half of it. */
  radius: number;
}

export class ForceView {
  /** In ground coordinates. */
  readonly group = new THREE.Group();
  labels: Label[] = [];

  #shaft = new THREE.CylinderGeometry(1, 1, 1, 20).translate(0, 0.5, 0);
  #head = new THREE.ConeGeometry(1, 1, 24).translate(0, 0.5, 0);
  #materials: Record<Force["kind"], ViewMaterial>;
  #clear = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ transparent: true }));

  constructor(shared: SharedUniforms) {
    const material = (colour: string) => {
      const result = new ViewMaterial(shared, ["LIT"], { transparent: true });
      result.colour.set(colour);
      return result;
    };
    this.#materials = { bearing: material(COLOURS.bearing), mesh: material(COLOURS.mesh) };
    // Bearings and contacts lie inside of parts: the arrows are drawn over them, with a depth of their own.
    this.#clear.renderOrder = 200000;
    this.#clear.frustumCulled = false;
    this.#clear.onBeforeRender = (renderer) => renderer.clearDepth();
  }

  set(forces: Force[], options: ForceOptions): void {
    this.group.clear();
    this.labels = [];
    const gearOf = ({ kind, parts }: Force) => (kind === "mesh" ? options.names[parts[0] ?? -1] : undefined);
    const short = shortNames(forces.flatMap((force) => [force.name, gearOf(force) ?? ""]).filter((name) => name !== ""));
    let largest = 0;
    for (const { force } of forces) largest = Math.max(largest, Math.hypot(...force));
    if (!(largest > 0)) return;
    this.group.add(this.#clear);
    for (const force of forces) {
      if (force.kind === "bearing" ? !options.bearings : !options.meshes) continue;
      const size = Math.hypot(...force.force);
      if (!(size > 0)) continue;
      const length = (options.scale * 0.5 * options.radius * size) / largest;
      const arrow = this.arrow(force, length, options.radius * 0.011);
      this.group.add(arrow);
      const tip = new THREE.Vector3(...force.force).multiplyScalar(length / size).add(new THREE.Vector3(...force.point));
      if (options.labels) {
        const name = short.get(force.name) ?? force.name;
        const gear = gearOf(force);
        const on = gear && short.get(gear);
        const text = `${name ? `${name}: ` : ""}${formatValue(size, "N", 3)}${on ? ` on ${on}` : ""}`;
        this.labels.push({ text, point: tip, kind: force.kind, weight: size });
      }
    }
  }

  private arrow(force: Force, length: number, thickness: number): THREE.Group {
    const material = this.#materials[force.kind];
    const arrow = new THREE.Group();
    const head = Math.min(5.2 * thickness, 0.45 * length);
    const shaft = new THREE.Mesh(this.#shaft, material);
    shaft.scale.set(0.55 * thickness, length - head, 0.55 * thickness);
    const tip = new THREE.Mesh(this.#head, material);
    tip.scale.set(0.33 * head, head, 0.33 * head);
    tip.position.y = length - head;
    arrow.add(shaft, tip);
    arrow.position.set(...force.point);
    arrow.quaternion.setFromUnitVectors(UP, new THREE.Vector3(...force.force).normalize());
    for (const mesh of [shaft, tip]) mesh.renderOrder = 200001;
    return arrow;
  }

  dispose(): void {
    this.#shaft.dispose();
    this.#head.dispose();
    this.#clear.geometry.dispose();
    this.#clear.material.dispose();
    for (const material of Object.values(this.#materials)) material.dispose();
  }
}
