// A surface in the scene: the copies of a part's shape, or a deformed mesh.

import * as THREE from "three";
import { coarsen, LEVELS } from "./lod.ts";
import { NO_VALUE, type MaterialSet } from "./materials.ts";
import { closeMesh } from "./seams.ts";
import type { Surface } from "./surface.ts";

export interface SurfaceInput {
  points: Float32Array;
  edges: Uint32Array;
  surface: Surface;
  /** Present for deformed meshes. */
  displacements?: Float32Array;
}

/** Gathers rows of a node array at the vertices. */
function atVertices(values: Float32Array, nodes: Uint32Array): Float32Array {
  const result = new Float32Array(3 * nodes.length);
  for (let v = 0; v < nodes.length; v++) {
    const n = 3 * nodes[v]!;
    result[3 * v] = values[n]!;
    result[3 * v + 1] = values[n + 1]!;
    result[3 * v + 2] = values[n + 2]!;
  }
  return result;
}

export class SurfaceView {
  readonly group = new THREE.Group();
  readonly surface: THREE.Mesh;
  readonly features: THREE.LineSegments;
  readonly edges: THREE.LineSegments;
  readonly stencils: THREE.Mesh[];
  /** Close the open seams of a deformed mesh in the stencil buffer. */
  readonly closures: THREE.Mesh[] = [];
  readonly triangleCount: number;
  /** Sphere around one copy, in coordinates of the part, undeformed. */
  readonly sphere: THREE.Sphere;
  readonly box: THREE.Box3;

  #geometries: THREE.InstancedBufferGeometry[];
  #full: THREE.InstancedBufferGeometry;
  #levels: (THREE.InstancedBufferGeometry | undefined)[] = [];
  #level = -1;
  #count: number;
  #nodes: Uint32Array;
  #field: THREE.BufferAttribute | null = null;
  #copies: THREE.InstancedBufferAttribute | null = null;
  #total = 1;

  constructor(
    private readonly input: SurfaceInput,
    materials: MaterialSet,
    copies: number | null,
  ) {
    const { surface, points } = input;
    this.#count = copies ?? 1;
    this.#nodes = surface.nodes;
    this.triangleCount = surface.triangles.length / 3;
    const position = new THREE.BufferAttribute(atVertices(points, surface.nodes), 3);
    const attributes: Record<string, THREE.BufferAttribute> = { position };
    if (input.displacements) {
      attributes.displacement = new THREE.BufferAttribute(atVertices(input.displacements, surface.nodes), 3);
      this.#field = new THREE.BufferAttribute(new Float32Array(surface.nodes.length).fill(NO_VALUE), 1);
      attributes.field = this.#field;
    }
    this.box = new THREE.Box3().setFromBufferAttribute(position);
    this.sphere = this.box.getBoundingSphere(new THREE.Sphere());
    if (copies !== null) {
      this.#total = copies;
      this.#copies = new THREE.InstancedBufferAttribute(new Float32Array(2 * copies), 2);
      this.#copies.setUsage(THREE.DynamicDrawUsage);
      attributes.copyRotation = this.#copies;
    }
    const geometry = (index: Uint32Array, normals = false) => {
      const result = new THREE.InstancedBufferGeometry();
      for (const [name, attribute] of Object.entries(attributes)) result.setAttribute(name, attribute);
      if (normals) result.setAttribute("normal", new THREE.BufferAttribute(surface.normals, 3));
      result.setIndex(new THREE.BufferAttribute(index, 1));
      result.instanceCount = copies ?? 1;
      return result;
    };
    const edgeVertices = Uint32Array.from(input.edges, (node) => surface.firstVertex[node]!);
    const faces = geometry(surface.triangles, true);
    const features = geometry(surface.features);
    const edges = geometry(edgeVertices);
    this.#geometries = [faces, features, edges];
    this.#full = faces;
    this.surface = new THREE.Mesh(faces, materials.surface);
    this.features = new THREE.LineSegments(features, materials.features);
    this.edges = new THREE.LineSegments(edges, materials.edges);
    this.stencils = [new THREE.Mesh(faces, materials.stencilBack), new THREE.Mesh(faces, materials.stencilFront)];
    if (input.displacements) {
      const closure = closeMesh(surface, points, input.displacements, materials);
      this.#geometries.push(closure.geometry);
      this.closures = closure.meshes;
    }
    for (const object of [this.surface, this.features, this.edges, ...this.stencils, ...this.closures]) {
      // Three.js would cull by the bounds of one copy. The viewer culls the copies itself.
      object.frustumCulled = false;
      object.matrixAutoUpdate = false;
      this.group.add(object);
    }
    this.group.matrixAutoUpdate = false;
    if (copies !== null) this.setCopies(Array.from({ length: copies }, (_, k) => k), copies);
  }

  /** Draws a coarser surface: an index into `LEVELS`, or -1 for the full surface. */
  setLevel(level: number): void {
    if (level === this.#level || !this.#copies) return;
    this.#level = level;
    let geometry = level < 0 ? this.#full : this.#levels[level];
    if (!geometry) {
      const cell = (2 * this.sphere.radius) / LEVELS[level]!;
      const coarse = coarsen(this.input.points, this.input.surface, cell);
      geometry = new THREE.InstancedBufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(coarse.points, 3));
      geometry.setAttribute("normal", new THREE.BufferAttribute(coarse.normals, 3));
      geometry.setAttribute("copyRotation", this.#copies);
      geometry.setIndex(new THREE.BufferAttribute(coarse.triangles, 1));
      this.#levels[level] = geometry;
      this.#geometries.push(geometry);
    }
    geometry.instanceCount = this.#count;
    for (const mesh of [this.surface, ...this.stencils]) mesh.geometry = geometry;
  }

  /** Number of triangles of a copy as it is drawn. */
  get drawnTriangles(): number {
    return this.surface.geometry.index!.count / 3;
  }

  /** Draws only some of the copies. */
  setCopies(copies: ArrayLike<number>, length: number): void {
    const attribute = this.#copies;
    if (!attribute) return;
    const array = attribute.array as Float32Array;
    for (let i = 0; i < length; i++) {
      const angle = (2 * Math.PI * copies[i]!) / this.#total;
      array[2 * i] = Math.cos(angle);
      array[2 * i + 1] = Math.sin(angle);
    }
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, 2 * length);
    attribute.needsUpdate = true;
    this.#count = length;
    for (const geometry of this.#geometries) geometry.instanceCount = length;
    this.group.visible = length > 0;
  }

  /** Sets the values that determine the colours, one per node of the input. */
  setField(values: ArrayLike<number> | null): void {
    if (!this.#field) return;
    const array = this.#field.array as Float32Array;
    for (let v = 0; v < this.#nodes.length; v++) {
      const value = values ? values[this.#nodes[v]!]! : NaN;
      array[v] = Number.isFinite(value) ? value : NO_VALUE;
    }
    this.#field.needsUpdate = true;
  }

  dispose(): void {
    for (const geometry of this.#geometries) geometry.dispose();
  }
}
