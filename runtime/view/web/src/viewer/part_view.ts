// A part in the scene: its copies, the deformed meshes that replace some of them, and its cap.

import * as THREE from "three";
import { createCapMaterial, createMaterialSet, type MaterialSet, type SharedUniforms, type ViewMaterial } from "./materials.ts";
import { levelFor } from "./lod.ts";
import type { Part } from "./run_data.ts";
import type { MeshView } from "./mesh_view.ts";
import { rotationOf } from "./seams.ts";
import type { Visibility } from "./state.ts";
import { buildSurface, type Surface } from "./surface.ts";
import { SurfaceView } from "./surface_view.ts";

const TRANSLUCENT = 0.28;
/** Projected pitch of the copies in pixels below which their outlines would only darken the picture. */
const OUTLINE_PIXELS = 7;
/** Triangles of a part below which a coarser surface does not pay. */
const COARSE_FROM = 60_000;

export class PartView {
  /** Moves with the part. */
  readonly group = new THREE.Group();
  readonly cap: THREE.Mesh;
  readonly copies: SurfaceView;
  readonly surface: Surface;
  readonly radius: number;
  /** Triangles that no mesh replaces. */
  readonly restTriangles: Uint32Array;
  meshes: MeshView[] = [];
  visibility: Visibility = "visible";
  present = true;

  #instanced: MaterialSet;
  #deformed: MaterialSet;
  #capMaterial: ViewMaterial;
  #colour: THREE.Color;
  /** Colour where there is no field: a hint of the part's colour, which does not compete with the scale. */
  #neutral: THREE.Color;
  /** Copies that no mesh replaces. */
  #candidates: number[];
  #replaced: number[] = [];
  /** Copies of what no mesh replaces, where a mesh replaces the rest; null if there is nothing. */
  readonly rest: SurfaceView | null;
  #shown: Uint32Array;
  #shownCount = -1;
  #shownHash = NaN;
  #fieldMode = false;
  #edges = false;
  #cut = false;
  /** Meshes with cells have a section through them instead of a cap. */
  #sections = false;
  #order: number;

  constructor(
    readonly part: Part,
    shared: SharedUniforms,
    capGeometry: THREE.BufferGeometry,
    colour: string,
  ) {
    this.#colour = new THREE.Color(colour);
    this.#neutral = new THREE.Color("#b4b9bf").lerp(this.#colour, 0.4);
    this.#instanced = createMaterialSet(shared, false);
    this.#deformed = createMaterialSet(shared, true);
    this.#capMaterial = createCapMaterial(shared);
    this.surface = buildSurface(part.points, part.triangles, part.copies);
    this.copies = new SurfaceView({ ...part, surface: this.surface }, this.#instanced, part.copies);
    this.#candidates = Array.from({ length: part.copies }, (_, k) => k);
    this.#shown = new Uint32Array(part.copies);
    let square = 0;
    for (let i = 0; i < part.points.length; i += 3) {
      square = Math.max(square, part.points[i]! ** 2 + part.points[i + 1]! ** 2 + part.points[i + 2]! ** 2);
    }
    this.radius = Math.sqrt(square);
    this.group.matrixAutoUpdate = false;
    this.restTriangles = part.triangles.subarray(part.triangles.length - 3 * part.withoutMesh);
    this.rest = part.withoutMesh > 0 ? this.createRest() : null;
    this.group.add(this.copies.group);
    if (this.rest) this.group.add(this.rest.group);
    this.cap = new THREE.Mesh(capGeometry, this.#capMaterial);
    this.cap.frustumCulled = false;
    this.cap.matrixAutoUpdate = false;
    // Each cap uses the stencil alone: its part is counted, drawn and cleared before the next one.
    this.cap.onAfterRender = (renderer) => renderer.clearStencil();
    this.#order = part.index;
    // Magnified deformations overlap. In the same plane, the last part is in front.
    this.#deformed.section.polygonOffsetUnits = -SECTION_OFFSET * part.index;
    this.refresh();
  }

  get materials(): ViewMaterial[] {
    return [...Object.values(this.#instanced), ...Object.values(this.#deformed), this.#capMaterial] as ViewMaterial[];
  }

  /** Replaces the deformed meshes and the copies that they stand for. */
  setMeshes(meshes: MeshView[], replaced: ReadonlySet<number>): void {
    for (const mesh of this.meshes) if (!meshes.includes(mesh)) this.group.remove(mesh.group);
    for (const mesh of meshes) if (mesh.group.parent !== this.group) this.group.add(mesh.group);
    this.meshes = meshes;
    this.#candidates = [];
    for (let k = 0; k < this.part.copies; k++) if (!replaced.has(k)) this.#candidates.push(k);
    this.#shownHash = NaN;
    this.#replaced = [...replaced];
    this.rest?.setCopies(this.#replaced, this.#replaced.length);
    this.refresh();
  }

  private createRest(): SurfaceView {
    const { points, copies, edges } = this.part;
    const first = this.restTriangles.reduce((least, node) => Math.min(least, node), Infinity);
    const surface = buildSurface(points, this.restTriangles, copies);
    return new SurfaceView({ points, surface, edges: edges.filter((_, i) => edges[i - (i % 2)]! >= first) }, this.#instanced, copies);
  }

  /** Copies of which only the rest is displayed. */
  get replacedCopies(): readonly number[] {
    return this.#replaced;
  }

  get meshMaterials(): MaterialSet {
    return this.#deformed;
  }

  /** Copies that the scene contains, whether or not they are in the picture. */
  get presentCopies(): readonly number[] {
    return this.#candidates;
  }

  setVisibility(visibility: Visibility): void {
    this.visibility = visibility;
    this.refresh();
  }

  /** Colours the meshes by a field; everything without a field becomes neutral. */
  setFieldMode(on: boolean): void {
    this.#fieldMode = on;
    this.refresh();
  }

  setEdges(on: boolean): void {
    this.#edges = on;
    this.refresh();
  }

  /** Shows sections through the cells of meshes, or caps. */
  setSections(on: boolean): void {
    if (on === this.#sections) return;
    this.#sections = on;
    this.refresh();
  }

  get showsField(): boolean {
    return this.#fieldMode;
  }

  get showsSections(): boolean {
    return this.#sections && this.#cut && this.group.visible;
  }

  setCut(on: boolean): void {
    this.#cut = on;
    for (const material of this.materials) material.cut = on;
    this.refresh();
  }

  /** A part without a position is not displayed. */
  setPresent(present: boolean): void {
    this.present = present;
    this.refresh();
  }

  private refresh(): void {
    const translucent = this.visibility === "translucent";
    const visible = this.visibility !== "hidden" && this.present;
    this.group.visible = visible;
    this.cap.visible = visible && this.#cut && !this.part.open;
    const alpha = translucent ? TRANSLUCENT : 1;
    for (const set of [this.#instanced, this.#deformed]) {
      set.surface.alpha = alpha;
      set.surface.depthWrite = !translucent;
      const open = this.part.open || this.#cut;
      set.surface.side = open && !translucent ? THREE.DoubleSide : THREE.FrontSide;
      set.surface.colour.copy(this.#fieldMode ? this.#neutral : this.#colour);
      set.features.alpha = translucent ? 0.25 : 0.5;
      set.edges.alpha = translucent ? 0.12 : 0.34;
      set.stencilBack.transparent = set.stencilFront.transparent = translucent;
    }
    this.#deformed.surface.useField = this.#deformed.section.useField = this.#fieldMode;
    this.#deformed.section.colour.copy(this.#fieldMode ? this.#neutral : this.#colour).multiplyScalar(0.86);
    this.#capMaterial.alpha = translucent ? 0.5 : 1;
    this.#capMaterial.depthWrite = !translucent;
    this.#capMaterial.colour.copy(this.#fieldMode ? this.#neutral : this.#colour).multiplyScalar(0.86);
    const first = 10 + 3 * this.#order;
    this.cap.renderOrder = first + 2;
    for (const view of [this.copies, ...(this.rest ? [this.rest] : []), ...this.meshes]) {
      view.edges.visible = this.#edges;
      view.surface.renderOrder = translucent ? 100000 : 0;
      view.features.renderOrder = view.edges.renderOrder = 100001;
    }
    this.refreshStencils(this.copies.stencils, first, true);
    if (this.rest) this.refreshStencils(this.rest.stencils, first, true);
    for (const mesh of this.meshes) {
      const cap = !mesh.open && !(this.#sections && mesh.section);
      this.refreshStencils(mesh.stencils, first, cap);
    }
  }

  private refreshStencils(pair: THREE.Mesh[], first: number, on: boolean): void {
    pair.forEach((stencil, i) => {
      // A surface that encloses no volume has no section.
      stencil.visible = on && this.#cut && !this.part.open;
      stencil.renderOrder = first + i;
    });
  }

  /** Leaves out the copies outside of the picture. Returns the number of triangles that are drawn. */
  prepare(frustum: THREE.Frustum, pixelsPerMetre: (centre: THREE.Vector3) => number): number {
    if (!this.group.visible) return 0;
    const { sphere } = this.copies;
    let count = 0;
    let hash = 0;
    let detail = 0;
    const matrix = this.group.matrixWorld;
    scratch.radius = sphere.radius;
    for (const k of this.#candidates) {
      const [cos, sin] = rotationOf(k, this.part.copies);
      const { x, y, z } = sphere.center;
      scratch.center.set(cos * x - sin * y, sin * x + cos * y, z).applyMatrix4(matrix);
      if (!frustum.intersectsSphere(scratch)) continue;
      this.#shown[count++] = k;
      hash = (hash * 31 + k + 1) % 4294967291;
      detail = Math.max(detail, sphere.radius * 2 * pixelsPerMetre(scratch.center));
    }
    if (count !== this.#shownCount || hash !== this.#shownHash) {
      this.copies.setCopies(this.#shown, count);
      this.#shownCount = count;
      this.#shownHash = hash;
    }
    // A field of lines is denser than the diagonal of a narrow sector suggests.
    const pitch = this.part.copies > 1 ? (2 * Math.PI * this.radius) / this.part.copies : 2 * sphere.radius;
    const pitchPixels = (detail * Math.min(pitch, 2 * sphere.radius)) / (2 * sphere.radius || 1);
    this.copies.features.visible = pitchPixels > OUTLINE_PIXELS;
    const scale = pixelsPerMetre(scratch.center.setFromMatrixPosition(matrix));
    const isClear = this.part.copies === 1 || pitch * scale > OUTLINE_PIXELS;
    for (const view of [this.copies, ...(this.rest ? [this.rest] : []), ...this.meshes]) {
      view.setScale(scale);
      if (view !== this.copies) view.features.visible = isClear;
    }
    this.copies.edges.visible = this.#edges && pitchPixels > 2 * OUTLINE_PIXELS;
    this.copies.setLevel(count * this.copies.triangleCount > COARSE_FROM ? levelFor(detail) : -1);
    let triangles = count * this.copies.drawnTriangles + this.#replaced.length * this.part.withoutMesh;
    for (const mesh of this.meshes) triangles += mesh.triangleCount;
    return triangles;
  }

  dispose(): void {
    this.copies.dispose();
    this.rest?.dispose();
    for (const material of this.materials) material.dispose();
  }
}

/** Offset of the depths of sections from one part to the next, in the resolution of the depth buffer. */
const SECTION_OFFSET = 8;

const scratch = new THREE.Sphere();
