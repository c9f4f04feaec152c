// Deformed finite-element meshes in the scene.
//
// The points, normals and indices of a mesh are uploaded once and shared by all places in which the
// mesh is displayed. A position changes only displacements and values.

import * as THREE from "three";
import { NO_FIELD, NO_VALUE, type MaterialSet } from "./materials.ts";
import { Outline } from "./outline.ts";
import type { DeformedMesh, MeshShape } from "./run_data.ts";
import { rotationsOf, seamPoints } from "./seams.ts";
import { SectionView } from "./section_view.ts";
import { hasCells } from "./section.ts";
import { buildSurface, type Surface } from "./surface.ts";
import { atVertices, seamMask } from "./surface_view.ts";

const surfaces = new WeakMap<MeshShape, Surface>();

/** Surface of a mesh with its normals; viewers share it. */
function surfaceOf(shape: MeshShape, copies: number): Surface {
  let surface = surfaces.get(shape);
  if (!surface) surfaces.set(shape, (surface = buildSurface(shape.points, shape.triangles, copies)));
  return surface;
}

/** Buffers that all places of a mesh in a scene share. */
class MeshBuffers {
  readonly surface: Surface;
  readonly position: THREE.BufferAttribute;
  readonly seam: THREE.BufferAttribute;
  readonly normal: THREE.BufferAttribute;
  readonly triangles: THREE.BufferAttribute;
  readonly outline: Outline;
  readonly edges: THREE.BufferAttribute;

  constructor(readonly shape: MeshShape, copies: number) {
    const surface = surfaceOf(shape, copies);
    this.surface = surface;
    this.position = new THREE.BufferAttribute(atVertices(seamPoints(shape.points, surface.seam), surface.nodes), 3);
    this.seam = new THREE.BufferAttribute(seamMask(surface), 1);
    this.normal = new THREE.BufferAttribute(surface.normals, 3);
    this.triangles = new THREE.BufferAttribute(surface.triangles, 1);
    this.outline = new Outline(surface.features, atVertices(shape.points, surface.nodes));
    this.edges = new THREE.BufferAttribute(Uint32Array.from(shape.edges, (node) => surface.firstVertex[node]!), 1);
  }
}

/** A place in which a mesh is displayed. */
export class MeshView {
  readonly group = new THREE.Group();
  readonly surface: THREE.Mesh;
  readonly features: THREE.LineSegments;
  readonly edges: THREE.LineSegments;
  readonly stencils: THREE.Mesh[];
  /** Section through the cells of the volume; null for a mesh without cells. */
  readonly section: SectionView | null;
  readonly triangleCount: number;
  mesh: DeformedMesh | null = null;
  values: Float64Array | null = null;

  #geometries: THREE.InstancedBufferGeometry[];
  #displacement: THREE.BufferAttribute;
  #field: THREE.BufferAttribute;
  #rotation = new THREE.InstancedBufferAttribute(new Float32Array(4), 4);

  constructor(
    private readonly buffers: MeshBuffers,
    materials: MaterialSet,
  ) {
    const { surface, shape } = buffers;
    const count = surface.nodes.length;
    this.triangleCount = shape.triangles.length / 3;
    this.#displacement = new THREE.BufferAttribute(new Float32Array(3 * count), 3).setUsage(THREE.DynamicDrawUsage);
    this.#field = new THREE.BufferAttribute(new Float32Array(count).fill(NO_VALUE), 1).setUsage(THREE.DynamicDrawUsage);
    const geometry = (index: THREE.BufferAttribute) => {
      const result = new THREE.InstancedBufferGeometry();
      result.setAttribute("position", buffers.position);
      result.setAttribute("seam", buffers.seam);
      result.setAttribute("normal", buffers.normal);
      result.setAttribute("displacement", this.#displacement);
      result.setAttribute("field", this.#field);
      result.setAttribute("copyRotation", this.#rotation);
      result.setIndex(index);
      result.instanceCount = 1;
      return result;
    };
    const faces = geometry(buffers.triangles);
    const features = geometry(buffers.outline.index(Infinity));
    const edges = geometry(buffers.edges);
    this.surface = new THREE.Mesh(faces, materials.surface);
    this.features = new THREE.LineSegments(features, materials.features);
    this.edges = new THREE.LineSegments(edges, materials.edges);
    this.stencils = [new THREE.Mesh(faces, materials.stencilBack), new THREE.Mesh(faces, materials.stencilFront)];
    this.#geometries = [faces, features, edges];
    this.section = hasCells(shape) ? new SectionView(materials) : null;
    for (const object of [this.surface, this.features, this.edges, ...this.stencils]) {
      object.frustumCulled = false;
      object.matrixAutoUpdate = false;
      this.group.add(object);
    }
    if (this.section) this.group.add(...this.section.objects);
    this.group.matrixAutoUpdate = false;
  }

  /** Chooses the outline for a view with `scale` pixels per metre. */
  setScale(scale: number): void {
    this.features.geometry.setIndex(this.buffers.outline.index(scale));
  }

  get open(): boolean {
    return this.buffers.shape.open;
  }

  /** Displays the values of a position. */
  set(mesh: DeformedMesh): void {
    if (mesh === this.mesh) return;
    this.mesh = mesh;
    this.values = null;
    this.#rotation.setXYZW(0, ...rotationsOf(mesh.copy, mesh.copies));
    this.#rotation.needsUpdate = true;
    atVertices(mesh.displacements, this.buffers.surface.nodes, this.#displacement.array as Float32Array);
    this.#displacement.needsUpdate = true;
  }

  /** Sets the values that determine the colours, one per node. */
  setField(values: Float64Array): void {
    if (values === this.values) return;
    this.values = values;
    const array = this.#field.array as Float32Array;
    const none = this.mesh?.stresses ? NO_VALUE : NO_FIELD;
    const { nodes } = this.buffers.surface;
    for (let v = 0; v < nodes.length; v++) {
      const value = values[nodes[v]!]!;
      array[v] = Number.isFinite(value) ? value : none;
    }
    this.#field.needsUpdate = true;
  }

  dispose(): void {
    for (const geometry of this.#geometries) geometry.dispose();
    this.section?.dispose();
  }
}

/** Places of the meshes of a scene. A place serves one position after the other. */
export class MeshViews {
  #buffers = new Map<MeshShape, MeshBuffers>();
  #places = new Map<string, MeshView[]>();

  /** Returns a view for each mesh of a position; `materials` are those of a part. */
  display(meshes: readonly DeformedMesh[], materials: (part: number) => MaterialSet): MeshView[] {
    const free = new Map([...this.#places].map(([key, views]) => [key, [...views]]));
    const keyOf = (mesh: DeformedMesh) => `${mesh.part} ${mesh.shape.name}`;
    // The same tooth keeps its place, so that nothing changes if its values do not.
    const taken = meshes.map((mesh) => {
      const views = free.get(keyOf(mesh)) ?? [];
      const i = views.findIndex((view) => view.mesh?.copy === mesh.copy && view.mesh.shape === mesh.shape);
      return i < 0 ? null : views.splice(i, 1)[0]!;
    });
    return meshes.map((mesh, i) => {
      const views = free.get(keyOf(mesh)) ?? [];
      const other = taken[i] ? -1 : views.findIndex((view) => view.mesh?.shape === mesh.shape);
      const view = taken[i] ?? (other < 0 ? this.create(mesh, materials(mesh.part)) : views.splice(other, 1)[0]!);
      view.set(mesh);
      return view;
    });
  }

  private create(mesh: DeformedMesh, materials: MaterialSet): MeshView {
    let buffers = this.#buffers.get(mesh.shape);
    if (!buffers) this.#buffers.set(mesh.shape, (buffers = new MeshBuffers(mesh.shape, mesh.copies)));
    const view = new MeshView(buffers, materials);
    const key = `${mesh.part} ${mesh.shape.name}`;
    this.#places.set(key, [...(this.#places.get(key) ?? []), view]);
    return view;
  }

  dispose(): void {
    for (const views of this.#places.values()) for (const view of views) view.dispose();
    this.#places.clear();
    this.#buffers.clear();
  }
}
