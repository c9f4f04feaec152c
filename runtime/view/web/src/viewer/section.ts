// Plane sections through the cells of a mesh, by marching tetrahedra.

import { displacedPoint, placesOfMesh, type DeformedMesh, type MeshShape } from "./run_data.ts";
import { seamOf } from "./seams.ts";

/** Cells of a mesh, divided into tetrahedra. */
export interface Tetrahedra {
  /** Four nodes each. */
  nodes: Uint32Array;
  /** Bit i is set if the face opposite to node i is on the border of its cell. */
  borders: Uint8Array;
}

export function hasCells({ tetrahedra, wedges, hexahedra }: MeshShape): boolean {
  return tetrahedra.length + wedges.length + hexahedra.length > 0;
}

/** Faces of the cells by their corners. */
const WEDGE = [[0, 1, 2], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]];
const HEXAHEDRON = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/**
 * Divides a cell into tetrahedra from its lowest node to the faces without that node. The lowest node
 * of each quadrilateral determines its diagonal, so that neighbours divide their common face alike
 * (Dompierre, Labbé, Vallet and Camarero 1999). `ranks` is the order of the nodes.
 */
function divide(corners: Uint32Array, ranks: Float64Array, faces: number[][], nodes: number[], borders: number[]): void {
  let apex = 0;
  for (let i = 1; i < corners.length; i++) if (ranks[corners[i]!]! < ranks[corners[apex]!]!) apex = i;
  const sets = faces.map((face) => face.reduce((set, i) => set | (1 << i), 0));
  const onBorder = (...three: number[]) => {
    const set = three.reduce((bits, i) => bits | (1 << i), 0);
    return sets.some((face) => (face & set) === set);
  };
  for (const face of faces) {
    if (face.includes(apex)) continue;
    let first = 0;
    face.forEach((i, k) => (first = ranks[corners[i]!]! < ranks[corners[face[first]!]!]! ? k : first));
    for (let k = 1; k + 1 < face.length; k++) {
      const [a, b, c] = [face[first]!, face[(first + k) % face.length]!, face[(first + k + 1) % face.length]!];
      nodes.push(corners[apex]!, corners[a]!, corners[b]!, corners[c]!);
      borders.push(1 | (onBorder(apex, b, c) ? 2 : 0) | (onBorder(apex, a, c) ? 4 : 0) | (onBorder(apex, a, b) ? 8 : 0));
    }
  }
}

const divided = new WeakMap<MeshShape, Tetrahedra>();

/** Divides the cells of a mesh, of which there are `copies` around the axis. */
export function tetrahedraOf(shape: MeshShape, copies: number): Tetrahedra {
  let result = divided.get(shape);
  if (result) return result;
  const ranks = ranksOf(shape, copies);
  const nodes: number[] = [];
  const borders: number[] = [];
  for (const [cells, size, faces] of [[shape.wedges, 6, WEDGE], [shape.hexahedra, 8, HEXAHEDRON]] as const) {
    for (let i = 0; i < cells.length; i += size) divide(cells.subarray(i, i + size), ranks, faces, nodes, borders);
  }
  const { tetrahedra } = shape;
  const all = new Uint32Array(tetrahedra.length + nodes.length);
  all.set(tetrahedra);
  all.set(nodes, tetrahedra.length);
  const masks = new Uint8Array(all.length / 4).fill(15);
  masks.set(borders, tetrahedra.length / 4);
  result = { nodes: all, borders: masks };
  divided.set(shape, result);
  return result;
}

/** Order of the nodes in which the nodes of both cuts of a sector follow each other alike. */
function ranksOf(shape: MeshShape, copies: number): Float64Array {
  return Float64Array.from(seamOf(shape.points, copies), (partner, n) => (partner < 0 ? n : partner + 0.5));
}

/** Area of a triangle relative to squared distances from its corners that is zero but for rounding. */
const NO_AREA = 1e-13;

/** A plane in coordinates of a part: the section is the border of the side with negative distances. */
export type Plane = readonly [number, number, number, number];

/** Section of a deformed mesh with a plane. The arrays grow and are used again. */
export class Section {
  /** Three points per triangle, in coordinates of the part. */
  points = new Float32Array(9 * 1024);
  /** A value per point. */
  values = new Float32Array(3 * 1024);
  /** Tetrahedron of each triangle. */
  sources = new Uint32Array(1024);
  count = 0;
  /** Two points per segment: borders of the cells. */
  edges = new Float32Array(6 * 2048);
  edgeCount = 0;

  #distances = new Float64Array();
  #places: ArrayLike<number> = [];
  #corner = new Float64Array(12);
  #cornerValues = new Float64Array(4);

  /** Computes the section. A triangle with an unknown value at one of its nodes gets `noValue`. */
  compute(mesh: DeformedMesh, field: Float64Array | null, plane: Plane, factor: number, withEdges: boolean, noValue: number): void {
    const { nodes, borders } = tetrahedraOf(mesh.shape, mesh.copies);
    const distances = this.measure(mesh, plane, factor);
    this.count = 0;
    this.edgeCount = 0;
    for (let t = 0; t < nodes.length; t += 4) {
      const negative =
        (distances[nodes[t]!]! < 0 ? 1 : 0) |
        (distances[nodes[t + 1]!]! < 0 ? 2 : 0) |
        (distances[nodes[t + 2]!]! < 0 ? 4 : 0) |
        (distances[nodes[t + 3]!]! < 0 ? 8 : 0);
      if (negative === 0 || negative === 15) continue;
      const border = withEdges ? borders[t / 4]! : 0;
      const cycle = CYCLES[negative]!;
      const corners = cycle.length / 3;
      for (let i = 0; i < corners; i++) {
        this.cross(mesh, field, factor, noValue, nodes[t + cycle[3 * i]!]!, nodes[t + cycle[3 * i + 1]!]!, i);
      }
      this.push(t / 4, 0, 1, 2);
      if (corners === 4) this.push(t / 4, 0, 2, 3);
      for (let i = 0; border && i < corners; i++) {
        if (border & (1 << cycle[3 * i + 2]!)) this.pushEdge(i, (i + 1) % corners);
      }
    }
  }

  /** Distances of the displaced nodes from the plane. */
  private measure(mesh: DeformedMesh, [a, b, c, d]: Plane, factor: number): Float64Array {
    const places = (this.#places = placesOfMesh(mesh));
    const u = mesh.displacements;
    const count = places.length / 3;
    if (this.#distances.length < count) this.#distances = new Float64Array(count);
    const distances = this.#distances;
    for (let n = 0, i = 0; n < count; n++, i += 3) {
      distances[n] =
        a * (places[i]! + factor * u[i]!) + b * (places[i + 1]! + factor * u[i + 1]!) + c * (places[i + 2]! + factor * u[i + 2]!) + d;
    }
    return distances;
  }

  /** Computes corner `i` of a polygon, where the edge between two nodes crosses the plane. */
  private cross(mesh: DeformedMesh, field: Float64Array | null, factor: number, noValue: number, from: number, to: number, i: number): void {
    const places = this.#places;
    const u = mesh.displacements;
    const s = this.#distances[from]!;
    const t = s / (s - this.#distances[to]!);
    const p = 3 * from;
    const q = 3 * to;
    for (let k = 0; k < 3; k++) {
      const start = places[p + k]! + factor * u[p + k]!;
      this.#corner[3 * i + k] = start + t * (places[q + k]! + factor * u[q + k]! - start);
    }
    const value = field ? field[from]! + t * (field[to]! - field[from]!) : NaN;
    this.#cornerValues[i] = Number.isFinite(value) ? value : noValue;
  }

  private push(source: number, i: number, j: number, k: number): void {
    if (this.count === this.sources.length) {
      this.points = grown(this.points, Float32Array);
      this.values = grown(this.values, Float32Array);
      this.sources = grown(this.sources, Uint32Array);
    }
    const n = this.count++;
    const corner = this.#corner;
    this.sources[n] = source;
    for (let v = 0; v < 3; v++) {
      const c = v === 0 ? i : v === 1 ? j : k;
      this.values[3 * n + v] = this.#cornerValues[c]!;
      for (let e = 0; e < 3; e++) this.points[9 * n + 3 * v + e] = corner[3 * c + e]!;
    }
  }

  private pushEdge(i: number, j: number): void {
    if (6 * this.edgeCount === this.edges.length) this.edges = grown(this.edges, Float32Array);
    const at = 6 * this.edgeCount++;
    for (let e = 0; e < 3; e++) {
      this.edges[at + e] = this.#corner[3 * i + e]!;
      this.edges[at + 3 + e] = this.#corner[3 * j + e]!;
    }
  }

  /** Finds the triangle at a point of the plane; -1 if there is none. `normal` is that of the plane. */
  find(x: number, y: number, z: number, normal: Plane): number {
    // The projection along the largest component of the normal is the least distorted.
    const size = [Math.abs(normal[0]), Math.abs(normal[1]), Math.abs(normal[2])];
    const along = size[0]! >= size[1]! && size[0]! >= size[2]! ? 0 : size[1]! >= size[2]! ? 1 : 2;
    const [e, f] = along === 0 ? [1, 2] : along === 1 ? [2, 0] : [0, 1];
    const point = [x, y, z];
    const [u, v] = [point[e]!, point[f]!];
    for (let n = 0; n < this.count; n++) {
      const i = 9 * n;
      const { points } = this;
      const [ax, ay] = [points[i + e]! - u, points[i + f]! - v];
      const [bx, by] = [points[i + 3 + e]! - u, points[i + 3 + f]! - v];
      const [cx, cy] = [points[i + 6 + e]! - u, points[i + 6 + f]! - v];
      const ab = ax * by - ay * bx;
      const bc = bx * cy - by * cx;
      const ca = cx * ay - cy * ax;
      // A cell that touches the plane with a corner or an edge only has a section without area, whose
      // sides contain every point in this test.
      if (Math.abs(ab + bc + ca) <= NO_AREA * (ax * ax + ay * ay + bx * bx + by * by + cx * cx + cy * cy)) continue;
      if ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)) return n;
    }
    return -1;
  }
}

function grown<A extends Float32Array | Uint32Array>(array: A, type: new (length: number) => A): A {
  const result = new type(2 * array.length);
  result.set(array);
  return result;
}

/**
 * Polygon of the section for each set of nodes with a negative distance: per corner the two ends of its
 * edge, and the node opposite to the face that contains the side from this corner to the next one.
 */
const CYCLES: number[][] = Array.from({ length: 16 }, (_, set) => {
  const inside = [0, 1, 2, 3].filter((i) => set & (1 << i));
  const outside = [0, 1, 2, 3].filter((i) => !(set & (1 << i)));
  if (inside.length === 2 && outside.length === 2) {
    const [a, b, c, d] = [inside[0]!, inside[1]!, outside[0]!, outside[1]!];
    return [a, c, b, a, d, c, b, d, a, b, c, d];
  }
  const [one, three] = inside.length === 1 ? [inside[0]!, outside] : [outside[0]!, inside];
  if (three.length !== 3) return [];
  const [b, c, d] = three as [number, number, number];
  return [one, b, d, one, c, b, one, d, c];
});

/** Weights of the nodes of a tetrahedron at a point of its displaced shape. */
export function weightsAt(mesh: DeformedMesh, tetrahedron: number, factor: number, point: readonly [number, number, number]): { nodes: number[]; weights: number[] } {
  const all = tetrahedraOf(mesh.shape, mesh.copies).nodes;
  const nodes = [0, 1, 2, 3].map((i) => all[4 * tetrahedron + i]!);
  const corners: (readonly number[])[] = nodes.map((node) => displacedPoint(mesh, node, factor));
  const from = (p: readonly number[], q: readonly number[]) => [q[0]! - p[0]!, q[1]! - p[1]!, q[2]! - p[2]!] as const;
  const volume = (a: readonly number[], b: readonly number[], c: readonly number[], d: readonly number[]) => {
    const [p, q, r] = [from(a, b), from(a, c), from(a, d)];
    return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  };
  const total = volume(corners[0]!, corners[1]!, corners[2]!, corners[3]!);
  const weights = [0, 1, 2, 3].map((k) => {
    const c = corners.map((corner, i) => (i === k ? point : corner));
    return volume(c[0]!, c[1]!, c[2]!, c[3]!) / total;
  });
  return { nodes, weights };
}
