// Closing of open seams for the caps of the cut.
//
// Sectors are open where they meet their neighbours. All copies together are closed, but a deformed
// mesh no longer meets its neighbours. Fans of triangles close both sides of such a seam. They are
// drawn only into the stencil buffer, which counts how often a ray crosses the surface: any surface
// with the right border serves.

import * as THREE from "three";
import type { MaterialSet } from "./materials.ts";
import type { Surface } from "./surface.ts";

/** Points of triangles between open edges and their centre; three points each. */
function fan(edges: number[], points: Float32Array): number[] {
  const result: number[] = [];
  const centre = meanOf(edges, points);
  for (let i = 0; i < edges.length; i += 2) {
    // The surface has the edge from the first node to the second one, its closure the opposite edge.
    for (const node of [edges[i + 1]!, edges[i]!]) {
      result.push(points[3 * node]!, points[3 * node + 1]!, points[3 * node + 2]!);
    }
    result.push(...centre);
  }
  return result;
}

function meanOf(nodes: number[], values: Float32Array): number[] {
  return [0, 1, 2].map((k) => nodes.reduce((sum, node) => sum + values[3 * node + k]!, 0) / Math.max(nodes.length, 1));
}

/** Open edges in connected groups. */
function groups(edges: Uint32Array): number[][] {
  const parent = new Map<number, number>();
  const find = (node: number): number => {
    let root = node;
    for (let next = parent.get(root); next !== undefined && next !== root; next = parent.get(root)) root = next;
    parent.set(node, root);
    return root;
  };
  for (let i = 0; i < edges.length; i += 2) parent.set(find(edges[i]!), find(edges[i + 1]!));
  const result = new Map<number, number[]>();
  for (let i = 0; i < edges.length; i += 2) {
    const root = find(edges[i]!);
    const group = result.get(root) ?? [];
    group.push(edges[i]!, edges[i + 1]!);
    result.set(root, group);
  }
  return [...result.values()];
}

function stencilMeshes(geometry: THREE.InstancedBufferGeometry, materials: MaterialSet): THREE.Mesh[] {
  return [materials.stencilBack, materials.stencilFront].map((material) => {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    return mesh;
  });
}

/** Closes all open edges of a deformed mesh. */
export class MeshClosure {
  readonly geometry = new THREE.InstancedBufferGeometry();
  readonly meshes: THREE.Mesh[];
  #groups: number[][];
  #displacement: THREE.BufferAttribute;

  constructor(surface: Surface, points: Float32Array, rotation: THREE.InstancedBufferAttribute, materials: MaterialSet) {
    this.#groups = groups(surface.openEdges);
    const position = this.#groups.flatMap((edges) => fan(edges, points));
    this.#displacement = new THREE.Float32BufferAttribute(new Float32Array(position.length), 3);
    this.geometry.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
    this.geometry.setAttribute("displacement", this.#displacement);
    this.geometry.setAttribute("copyRotation", rotation);
    this.geometry.instanceCount = position.length > 0 ? 1 : 0;
    this.meshes = stencilMeshes(this.geometry, materials);
  }

  setDisplacements(displacements: Float32Array): void {
    const array = this.#displacement.array as Float32Array;
    let at = 0;
    for (const edges of this.#groups) {
      const shift = meanOf(edges, displacements);
      for (let i = 0; i < edges.length; i += 2) {
        for (const node of [edges[i + 1]!, edges[i]!]) {
          for (let k = 0; k < 3; k++) array[at++] = displacements[3 * node + k]!;
        }
        for (let k = 0; k < 3; k++) array[at++] = shift[k]!;
      }
    }
    this.#displacement.needsUpdate = true;
  }
}

/**
 * Open edges of a sector on the side of the next copy (1) and on that of the previous one (-1): the
 * copy there has an edge at the same place. Angles alone do not tell, because a helical sector is twisted.
 */
export function edgesBySide(edges: Uint32Array, points: Float32Array, copies: number): Record<1 | -1, number[]> {
  const middles: [number, number, number][] = [];
  for (let i = 0; i < edges.length; i += 2) {
    const [a, b] = [3 * edges[i]!, 3 * edges[i + 1]!];
    middles.push([points[a]! + points[b]!, points[a + 1]! + points[b + 1]!, points[a + 2]! + points[b + 2]!]);
  }
  const [cos, sin] = [Math.cos((2 * Math.PI) / copies), Math.sin((2 * Math.PI) / copies)];
  /** Square of the distance from the edges of the copy on this side. */
  const distance = ([x, y, z]: [number, number, number], side: 1 | -1) => {
    const [u, v] = [cos * x + side * sin * y, cos * y - side * sin * x];
    let least = Infinity;
    for (const [p, q, r] of middles) least = Math.min(least, (p - u) ** 2 + (q - v) ** 2 + (r - z) ** 2);
    return least;
  };
  const result: Record<1 | -1, number[]> = { 1: [], [-1]: [] };
  middles.forEach((middle, i) => {
    const side = distance(middle, 1) <= distance(middle, -1) ? 1 : -1;
    result[side].push(edges[2 * i]!, edges[2 * i + 1]!);
  });
  return result;
}

/** Closes the seams of copies next to copies that are left out. */
export class OpenCopies {
  readonly meshes: THREE.Mesh[];
  #sides: { geometry: THREE.InstancedBufferGeometry; rotation: THREE.InstancedBufferAttribute; next: number }[];

  constructor(
    surface: Surface,
    points: Float32Array,
    private readonly copies: number,
    materials: MaterialSet,
  ) {
    const bySide = edgesBySide(surface.openEdges, points, copies);
    this.#sides = ([1, -1] as const).map((sign) => {
      const edges = bySide[sign];
      const geometry = new THREE.InstancedBufferGeometry();
      geometry.setAttribute("position", new THREE.Float32BufferAttribute(fan(edges, points), 3));
      const rotation = new THREE.InstancedBufferAttribute(new Float32Array(2 * copies), 2);
      geometry.setAttribute("copyRotation", rotation);
      geometry.instanceCount = 0;
      return { geometry, rotation, next: sign };
    });
    this.meshes = this.#sides.flatMap(({ geometry }) => stencilMeshes(geometry, materials));
  }

  /** Chooses the seams to close from the copies that are left out. */
  set(omitted: ReadonlySet<number>): void {
    for (const { geometry, rotation, next } of this.#sides) {
      let count = 0;
      if (omitted.size > 0) {
        for (let k = 0; k < this.copies; k++) {
          if (omitted.has(k) || !omitted.has((k + next + this.copies) % this.copies)) continue;
          const angle = (2 * Math.PI * k) / this.copies;
          rotation.setXY(count++, Math.cos(angle), Math.sin(angle));
        }
        rotation.needsUpdate = true;
      }
      geometry.instanceCount = count;
    }
  }

  dispose(): void {
    for (const { geometry } of this.#sides) geometry.dispose();
  }
}
