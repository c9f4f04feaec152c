// Coloured section of a mesh in the scene.

import * as THREE from "three";
import { NO_FIELD, NO_VALUE, type MaterialSet } from "./materials.ts";
import type { DeformedMesh } from "./run_data.ts";
import { Section, type Plane } from "./section.ts";

export class SectionView {
  readonly section = new Section();
  readonly objects: [THREE.Mesh, THREE.LineSegments];
  /** Plane of the displayed section in coordinates of the part; null if none is displayed. */
  plane: Plane | null = null;

  #key: unknown[] = [];
  #faces = new THREE.BufferGeometry();
  #lines = new THREE.BufferGeometry();

  constructor(materials: MaterialSet) {
    this.objects = [new THREE.Mesh(this.#faces, materials.section), new THREE.LineSegments(this.#lines, materials.sectionEdges)];
    this.objects.forEach((object, i) => {
      object.frustumCulled = false;
      object.matrixAutoUpdate = false;
      object.visible = false;
      object.renderOrder = 100000 + 2 * i;
    });
  }

  hide(): void {
    this.plane = null;
    for (const object of this.objects) object.visible = false;
  }

  /** Computes and displays the section if it has changed. Returns whether it has. */
  update(mesh: DeformedMesh, field: Float64Array | null, plane: Plane, factor: number, withEdges: boolean): boolean {
    this.plane = plane;
    const key = [mesh, field, ...plane, factor, withEdges];
    const same = key.every((value, i) => value === this.#key[i]);
    if (!same) {
      this.#key = key;
      this.section.compute(mesh, field, plane, factor, withEdges, mesh.stresses ? NO_VALUE : NO_FIELD);
      const { points, values, count, edges, edgeCount } = this.section;
      upload(this.#faces, "position", points, 3, 3 * count);
      upload(this.#faces, "field", values, 1, 3 * count);
      upload(this.#lines, "position", edges, 3, 2 * edgeCount);
      this.#faces.setDrawRange(0, 3 * count);
      this.#lines.setDrawRange(0, 2 * edgeCount);
    }
    this.objects[0].visible = this.section.count > 0;
    this.objects[1].visible = withEdges && this.section.edgeCount > 0;
    return !same;
  }

  dispose(): void {
    this.#faces.dispose();
    this.#lines.dispose();
  }
}

/** Uploads the first rows of an array; a new buffer is needed only after the array has grown. */
function upload(geometry: THREE.BufferGeometry, name: string, array: Float32Array, size: number, rows: number): void {
  let attribute = geometry.getAttribute(name) as THREE.BufferAttribute | undefined;
  if (attribute?.array !== array) {
    // The buffers of the other attributes are uploaded again too.
    geometry.dispose();
    attribute = new THREE.BufferAttribute(array, size).setUsage(THREE.DynamicDrawUsage);
    geometry.setAttribute(name, attribute);
  }
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, size * rows);
  attribute.needsUpdate = true;
}
