// The copies of a part's shape in the scene.

import * as THREE from "three";
import { coarsen, LEVELS } from "./lod.ts";
import type { MaterialSet } from "./materials.ts";
import type { Surface } from "./surface.ts";

export interface SurfaceInput {
  points: Float32Array;
  edges: Uint32Array;
  surface: Surface;
}

/** Gathers rows of a node array at the vertices. */
export function atVertices(values: Float32Array, nodes: Uint32Array, result: Float32Array = new Float32Array(3 * nodes.length)): Float32Array {
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
  readonly triangleCount: number;
  /** Sphere around one copy, in coordinates of the part, undeformed. */
  readonly sphere: THREE.Sphere;
  readonly box: THREE.Box3;

  #geometries: THREE.InstancedBufferGeometry[];
  #full: THREE.InstancedBufferGeometry;
  #levels: (THREE.InstancedBufferGeometry | undefined)[] = [];
  #level = -1;
  #count: number;
  #copies: THREE.InstancedBufferAttribute;

  constructor(
    private readonly input: SurfaceInput,
    materials: MaterialSet,
    private readonly total: number,
  ) {
    const { surface, points } = input;
    this.#count = total;
    this.triangleCount = surface.triangles.length / 3;
    const position = new THREE.BufferAttribute(atVertices(points, surface.nodes), 3);
    this.box = new THREE.Box3().setFromBufferAttribute(position);
    this.sphere = this.box.getBoundingSphere(new THREE.Sphere());
    this.#copies = new THREE.InstancedBufferAttribute(new Float32Array(2 * total), 2);
    this.#copies.setUsage(THREE.DynamicDrawUsage);
    const geometry = (index: Uint32Array, normals = false) => {
      const result = new THREE.InstancedBufferGeometry();
      result.setAttribute("position", position);
      result.setAttribute("copyRotation", this.#copies);
      if (normals) result.setAttribute("normal", new THREE.BufferAttribute(surface.normals, 3));
      result.setIndex(new THREE.BufferAttribute(index, 1));
      result.instanceCount = total;
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
    for (const object of [this.surface, this.features, this.edges, ...this.stencils]) {
      // Three.js would cull by the bounds of one copy. The viewer culls the copies itself.
      object.frustumCulled = false;
      object.matrixAutoUpdate = false;
      this.group.add(object);
    }
    this.group.matrixAutoUpdate = false;
    this.setCopies(Array.from({ length: total }, (_, k) => k), total);
  }

  /** Draws a coarser surface: an index into `LEVELS`, or -1 for the full surface. */
  setLevel(level: number): void {
    if (level === this.#level) return;
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
    const array = attribute.array as Float32Array;
    for (let i = 0; i < length; i++) {
      const angle = (2 * Math.PI * copies[i]!) / this.total;
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

  dispose(): void {
    for (const geometry of this.#geometries) geometry.dispose();
  }
}
