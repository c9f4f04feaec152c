// The copies of a part's shape in the scene.

import * as THREE from "three";
import { coarsen, LEVELS } from "./lod.ts";
import type { MaterialSet } from "./materials.ts";
import { Outline } from "./outline.ts";
import { rotationsOf, seamPoints } from "./seams.ts";
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

/** 1 for vertices on the last cut, otherwise 0. */
export function seamMask({ nodes, seam }: Surface): Float32Array {
  return Float32Array.from(nodes, (node) => (seam[node]! < 0 ? 0 : 1));
}

/** Geometry that is drawn, and the closed one for the caps of the cut. */
interface Geometries {
  shown: THREE.InstancedBufferGeometry;
  closed: THREE.InstancedBufferGeometry;
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
  #full: Geometries;
  #levels: (Geometries | undefined)[] = [];
  #level = -1;
  #outline: Outline;
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
    this.box = new THREE.Box3().setFromArray(atVertices(points, surface.nodes));
    const position = new THREE.BufferAttribute(atVertices(seamPoints(points, surface.seam), surface.nodes), 3);
    const seam = new THREE.BufferAttribute(seamMask(surface), 1);
    this.sphere = this.box.getBoundingSphere(new THREE.Sphere());
    this.#copies = new THREE.InstancedBufferAttribute(new Float32Array(4 * total), 4);
    this.#copies.setUsage(THREE.DynamicDrawUsage);
    const geometry = (index: Uint32Array, normals = false) => {
      const result = new THREE.InstancedBufferGeometry();
      result.setAttribute("position", position);
      result.setAttribute("seam", seam);
      result.setAttribute("copyRotation", this.#copies);
      if (normals) result.setAttribute("normal", new THREE.BufferAttribute(surface.normals, 3));
      result.setIndex(new THREE.BufferAttribute(index, 1));
      result.instanceCount = total;
      return result;
    };
    const edgeVertices = Uint32Array.from(input.edges, (node) => surface.firstVertex[node]!);
    const faces = geometry(surface.triangles, true);
    this.#outline = new Outline(surface.features, atVertices(points, surface.nodes));
    const features = geometry(surface.features);
    const edges = geometry(edgeVertices);
    this.#geometries = [faces, features, edges];
    this.#full = { shown: faces, closed: faces };
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
    const geometries = level < 0 ? this.#full : (this.#levels[level] ??= this.coarse(level));
    geometries.shown.instanceCount = geometries.closed.instanceCount = this.#count;
    this.surface.geometry = geometries.shown;
    for (const mesh of this.stencils) mesh.geometry = geometries.closed;
  }

  private coarse(level: number): Geometries {
    const cell = (2 * this.sphere.radius) / LEVELS[level]!;
    const coarse = coarsen(this.input.points, this.input.surface, this.total, cell);
    const attributes = {
      position: new THREE.BufferAttribute(coarse.points, 3),
      normal: new THREE.BufferAttribute(coarse.normals, 3),
      seam: new THREE.BufferAttribute(coarse.seam, 1),
      copyRotation: this.#copies,
    };
    const geometry = (index: Uint32Array) => {
      const result = new THREE.InstancedBufferGeometry();
      for (const [name, attribute] of Object.entries(attributes)) result.setAttribute(name, attribute);
      result.setIndex(new THREE.BufferAttribute(index, 1));
      this.#geometries.push(result);
      return result;
    };
    return { shown: geometry(coarse.triangles), closed: geometry(coarse.closed) };
  }

  /** Chooses the outline for a view with `scale` pixels per metre. */
  setScale(scale: number): void {
    this.features.geometry.setIndex(this.#outline.index(scale));
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
      array.set(rotationsOf(copies[i]!, this.total), 4 * i);
    }
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, 4 * length);
    attribute.needsUpdate = true;
    this.#count = length;
    for (const geometry of this.#geometries) geometry.instanceCount = length;
    this.group.visible = length > 0;
  }

  dispose(): void {
    for (const geometry of this.#geometries) geometry.dispose();
  }
}
