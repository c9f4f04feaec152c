// Parts and positions of a run, checked and decoded from array files.

import { ArrayFile, FileError, type Json } from "./array_file.ts";
import { joinSeam, placesOf, seamOf } from "./seams.ts";
import type { Vector } from "./state.ts";

export type PartKind = "gear" | "shaft" | "bearing" | "body";

export interface Part {
  index: number;
  name: string;
  kind: PartKind;
  copies: number;
  /** Number of triangles at the end of the list that no mesh replaces. */
  withoutMesh: number;
  /** The surface contains shells: both sides are visible, and it encloses no volume. */
  open: boolean;
  points: Float32Array;
  triangles: Uint32Array;
  edges: Uint32Array;
  /** Share of the motion of the outer ring in that of each point; null if the part moves as a whole. */
  withOuter: Float32Array | null;
}

export interface Parts {
  model: string;
  /** System of units of the model. */
  units: string;
  parts: Part[];
}

export interface Contacts {
  count: number;
  corners: Float32Array;
  pressures: Float32Array;
  /** Zone of each cell: 0 on the flank, 1 next to an edge, 2 next to a side face. */
  zones: Uint32Array;
  parts: Uint32Array;
  teeth: Uint32Array;
  /** Surfaces of both teeth; the two flanks of a tooth have different numbers. */
  surfaces: Uint32Array;
}

export interface Force {
  kind: "bearing" | "mesh";
  name: string;
  point: Vector;
  force: Vector;
  moment: Vector;
  parts: number[];
}

/** A finite-element mesh without its values: the content of a file `mesh-*.bin`. */
export interface MeshShape {
  name: string;
  /** The surface contains shells, as for parts. */
  open: boolean;
  /** A plane mesh, extruded: the second half of the points is its other end, and positions have values for the first half. */
  extruded: boolean;
  /** Undeformed points of copy 0. */
  points: Float32Array;
  triangles: Uint32Array;
  edges: Uint32Array;
  /** Cells of the volume, by their corners. */
  tetrahedra: Uint32Array;
  wedges: Uint32Array;
  hexahedra: Uint32Array;
}

/** A mesh in the place of a copy of a part, with its values in a position. */
export interface DeformedMesh {
  part: number;
  copy: number;
  copies: number;
  shape: MeshShape;
  /** In coordinates of the part, like the stresses: not rotated. */
  displacements: Float32Array;
  /** Null for a copy without stresses. */
  stresses: Float32Array | null;
  /** Estimated errors of the stresses as von Mises stresses; null if there are none. */
  stressErrors: Float32Array | null;
}

export interface Position {
  position: number;
  time: number;
  /** Twelve numbers per part: rotation matrix by rows, then origin. */
  poses: Float64Array;
  contacts: Contacts | null;
  forces: Force[];
  meshes: DeformedMesh[];
  /** Size of the file in bytes. */
  bytes: number;
  /** Reason why a mesh of this position is not displayed, or empty. */
  problem: string;
}

/** Largest number of copies of a shape; a damaged file could request more memory than there is. */
const MOST_COPIES = 100_000;
const KINDS: readonly string[] = ["gear", "shaft", "bearing", "body"];

function record(value: Json | undefined): { [key: string]: Json } | null {
  return typeof value === "object" && value !== null && !Array.isArray(value) ? value : null;
}

function list(value: Json | undefined): Json[] {
  return Array.isArray(value) ? value : [];
}

/** Throws if an index of `indices` is not below `count`: it would read outside of the points. */
function checkIndices(file: string, label: string, indices: Uint32Array, count: number): void {
  for (let i = 0; i < indices.length; i++) {
    if (indices[i]! >= count) throw new FileError(file, `${label}: index ${indices[i]} exceeds the ${count} points`);
  }
}

export function readParts(buffer: ArrayBuffer): Parts {
  const file = ArrayFile.parse("parts.bin", buffer);
  if (!Array.isArray(file.header.parts)) throw new FileError(file.name, "the list of parts is missing");
  const parts = file.header.parts.map((value, index): Part => {
    const entry = record(value);
    if (!entry) throw new FileError(file.name, `part ${index} is not an object`);
    const name = typeof entry.name === "string" ? entry.name : `part ${index}`;
    const copies = Number(entry.copies ?? 1);
    if (!Number.isInteger(copies) || copies < 1 || copies > MOST_COPIES) throw new FileError(file.name, `${name}: the number of copies is not valid`);
    const points = file.f32(entry.points, 3, `${name}, points`);
    const triangles = file.u32(entry.triangles, 3, `${name}, triangles`);
    const edges = entry.edges ? file.u32(entry.edges, 2, `${name}, edges`) : new Uint32Array();
    checkIndices(file.name, `${name}, triangles`, triangles, points.length / 3);
    checkIndices(file.name, `${name}, edges`, edges, points.length / 3);
    const kind = (KINDS.includes(String(entry.kind)) ? entry.kind : "body") as PartKind;
    const withoutMesh = Number(entry.without_mesh ?? 0);
    if (!Number.isInteger(withoutMesh) || withoutMesh < 0 || 3 * withoutMesh > triangles.length) {
      throw new FileError(file.name, `${name}: the number of triangles without a mesh is not valid`);
    }
    const withOuter = entry.with_outer ? file.f32(entry.with_outer, 1, `${name}, shares of the outer ring`) : null;
    if (withOuter && 3 * withOuter.length !== points.length) throw new FileError(file.name, `${name}: the shares of the outer ring do not fit the points`);
    return { index, name, kind, copies, withoutMesh, withOuter, open: entry.open === true, points, triangles, edges };
  });
  return { model: String(file.header.model ?? ""), units: String(file.header.units ?? ""), parts };
}

function vector(value: Json | undefined): Vector | null {
  if (!Array.isArray(value) || value.length !== 3) return null;
  const numbers = value.map((n) => (typeof n === "number" ? n : NaN));
  return numbers.every(Number.isFinite) ? (numbers as Vector) : null;
}

function readForce(value: Json, count: number): Force | null {
  const entry = record(value);
  const point = vector(entry?.point);
  const force = vector(entry?.force);
  // A force without a location cannot be drawn; the other forces still can.
  if (!entry || !point || !force) return null;
  return {
    kind: entry.kind === "mesh" ? "mesh" : "bearing",
    name: String(entry.name ?? ""),
    point,
    force,
    moment: vector(entry.moment) ?? [0, 0, 0],
    parts: list(entry.parts).filter((n): n is number => typeof n === "number" && n >= 0 && n < count),
  };
}

function readContacts(file: ArrayFile, value: Json | undefined): Contacts | null {
  const entry = record(value);
  if (!entry) return null;
  const corners = file.f32(entry.corners, 12, "contacts, corners");
  const pressures = file.f32(entry.pressures, 1, "contacts, pressures");
  const parts = file.u32(entry.parts, 2, "contacts, parts");
  const teeth = file.u32(entry.teeth, 2, "contacts, teeth");
  const zones = file.u32(entry.zones, 1, "contacts, zones");
  const surfaces = file.u32(entry.surfaces, 2, "contacts, surfaces");
  const count = pressures.length;
  const pairs = [parts, teeth, surfaces].every(({ length }) => length === 2 * count);
  if (corners.length !== 12 * count || zones.length !== count || !pairs) {
    throw new FileError(file.name, "contacts: the arrays have different lengths");
  }
  return count > 0 ? { count, corners, pressures, zones, parts, teeth, surfaces } : null;
}

const places = new WeakMap<MeshShape, Map<number, Float64Array>>();

/** Undeformed points of a mesh in the place of its copy, in coordinates of the part. All positions share them. */
export function placesOfMesh({ shape, copy, copies }: DeformedMesh): Float64Array {
  let ofShape = places.get(shape);
  if (!ofShape) places.set(shape, (ofShape = new Map()));
  let result = ofShape.get(copy);
  if (!result) ofShape.set(copy, (result = placesOf(shape.points, seamOf(shape.points, copies), copy, copies)));
  return result;
}

/** Returns the displaced point of a node, in coordinates of the part. */
export function displacedPoint(mesh: DeformedMesh, node: number, factor: number): Vector {
  const places = placesOfMesh(mesh);
  const u = mesh.displacements;
  const i = 3 * node;
  return [places[i]! + factor * u[i]!, places[i + 1]! + factor * u[i + 1]!, places[i + 2]! + factor * u[i + 2]!];
}

export function readMeshShape(name: string, buffer: ArrayBuffer): MeshShape {
  const file = ArrayFile.parse(name, buffer);
  const { header } = file;
  const points = file.f32(header.points, 3, "points");
  const indices = (key: string, components: number, required: boolean) => {
    if (!required && !header[key]) return new Uint32Array();
    const result = file.u32(header[key], components, key);
    checkIndices(name, key, result, points.length / 3);
    return result;
  };
  const extruded = header.extruded === true;
  if (extruded && points.length % 6 !== 0) throw new FileError(name, "points: an extruded mesh needs an even number of them");
  return {
    name,
    open: header.open === true,
    extruded,
    points,
    triangles: indices("triangles", 3, true),
    edges: indices("edges", 2, false),
    tetrahedra: indices("tetrahedra", 4, false),
    wedges: indices("wedges", 6, false),
    hexahedra: indices("hexahedra", 8, false),
  };
}

/** Reads a file `mesh-*.bin`. */
export type MeshReader = (name: string) => Promise<MeshShape>;

/** Names of mesh files: a name from a damaged file must not lead to another address. */
const MESH_NAME = /^mesh-[0-9A-Za-z_-]+\.bin$/;

async function readMesh(file: ArrayFile, value: Json, index: number, parts: Part[], read: MeshReader): Promise<DeformedMesh> {
  const entry = record(value);
  const part = parts[Number(entry?.part)];
  if (!entry || !part) throw new FileError(file.name, `mesh ${index}: the part does not exist`);
  const label = `mesh of ${part.name}`;
  const copy = Number(entry.copy ?? 0);
  if (!Number.isInteger(copy) || copy < 0 || copy >= part.copies) throw new FileError(file.name, `${label}: the copy does not exist`);
  const name = String(entry.mesh);
  if (!MESH_NAME.test(name)) throw new FileError(file.name, `${label}: the name of the mesh is not valid`);
  const shape = await read(name);
  const values = (key: string, components: number, plane: number[]) => {
    const what = `${label}, ${key.replace("_", " ")}`;
    if (!shape.extruded) return file.f32(entry[key], components, what);
    return extruded(file.f32(entry[key], plane.length, what), components, plane);
  };
  const displacements = values("displacements", 3, [0, 1]);
  // Components xx, yy, zz, yz, zx, xy: in plane strain yz and zx vanish.
  const stresses = entry.stresses ? values("stresses", 6, [0, 1, 2, 5]) : null;
  const stressErrors = entry.stress_errors ? values("stress_errors", 1, [0]) : null;
  const count = shape.points.length / 3;
  if (displacements.length !== 3 * count || (stresses && stresses.length !== 6 * count) || (stressErrors && stressErrors.length !== count)) {
    throw new FileError(file.name, `${label}: the values do not fit the ${count} points of ${name}`);
  }
  return { part: part.index, copy, copies: part.copies, shape, displacements, stresses, stressErrors };
}

/**
 * Adds the copies that a position does not mention to the meshes of their parts: these copies do not move.
 * With one shape for all copies, surfaces and sections of a part are closed. At its seams, a copy that is
 * mentioned keeps its displacements, and its neighbour follows.
 */
function completed(meshes: DeformedMesh[], parts: Part[]): DeformedMesh[] {
  const all = [...meshes];
  for (const { index, copies } of parts) {
    const first = meshes.find(({ part }) => part === index);
    if (!first || copies === 1) continue;
    const byCopy = new Map(meshes.filter(({ part }) => part === index).map((mesh) => [mesh.copy, mesh]));
    for (let copy = 0; copy < copies; copy++) {
      if (byCopy.has(copy)) continue;
      const displacements = new Float32Array(first.shape.points.length);
      const mesh = { part: index, copy, copies, shape: first.shape, displacements, stresses: null, stressErrors: null };
      byCopy.set(copy, mesh);
      all.push(mesh);
    }
    for (const [copy, mesh] of byCopy) {
      const next = byCopy.get((copy + 1) % copies)!;
      if (next.shape !== mesh.shape) continue;
      const [own, other] = [mesh, next].map((one) => meshes.includes(one));
      joinSeam(mesh.displacements, next.displacements, seamOf(mesh.shape.points, copies), own === other ? 0.5 : own ? 1 : 0);
    }
  }
  return all;
}

/** Values of a plane mesh at both ends of its extrusion. Component i of a row becomes component `places[i]`. */
function extruded(plane: Float32Array, components: number, places: number[]): Float32Array {
  const count = plane.length / places.length;
  const values = new Float32Array(2 * components * count);
  for (let row = 0; row < count; row++) {
    places.forEach((place, i) => {
      values[components * row + place] = plane[places.length * row + i]!;
    });
  }
  values.copyWithin(components * count, 0, components * count);
  return values;
}

const shapes = new WeakMap<Part, MeshShape>();

/** Shape of a part that moves without a mesh. */
function shapeOf(part: Part): MeshShape {
  let shape = shapes.get(part);
  if (!shape) {
    const none = new Uint32Array();
    const { open, points, triangles, edges } = part;
    shape = { name: `part ${part.index}`, open, extruded: false, points, triangles, edges, tetrahedra: none, wedges: none, hexahedra: none };
    shapes.set(part, shape);
  }
  return shape;
}

/** Reads the motions of bearings and rigid shafts: their surfaces are displaced, without stresses. */
function readMotions(file: ArrayFile, value: Json | undefined, parts: Part[]): DeformedMesh[] {
  const entry = record(value);
  if (!entry) return [];
  const indices = file.u32(entry.parts, 1, "motions, parts");
  const at = file.f32(entry.at, 3, "motions, reference points");
  const motions = file.f32(entry.motions, 12, "motions");
  if (at.length !== 3 * indices.length || motions.length !== 12 * indices.length) throw new FileError(file.name, "motions: the arrays have different lengths");
  return Array.from(indices, (index, i) => {
    const part = parts[index];
    if (!part || part.copies !== 1) throw new FileError(file.name, "motions: the part does not exist");
    const [inner, outer] = [motions.subarray(12 * i, 12 * i + 6), motions.subarray(12 * i + 6, 12 * i + 12)];
    const displacements = new Float32Array(part.points.length);
    for (let n = 0; n < part.points.length / 3; n++) {
      const share = part.withOuter?.[n] ?? 0;
      const [ux, uy, uz, rx, ry, rz] = Array.from(inner, (v, k) => v + share * (outer[k]! - v)) as [number, number, number, number, number, number];
      const [x, y, z] = [0, 1, 2].map((k) => part.points[3 * n + k]! - at[3 * i + k]!) as [number, number, number];
      displacements.set([ux + ry * z - rz * y, uy + rz * x - rx * z, uz + rx * y - ry * x], 3 * n);
    }
    return { part: index, copy: 0, copies: 1, shape: shapeOf(part), displacements, stresses: null, stressErrors: null };
  });
}

/** Reads a position and the meshes that it refers to. A mesh that cannot be read is left out. */
export async function readPosition(name: string, buffer: ArrayBuffer, parts: Part[], read: MeshReader): Promise<Position> {
  const file = ArrayFile.parse(name, buffer);
  const { header } = file;
  const poses = file.f64(header.poses, 12, "poses");
  if (poses.length !== 12 * parts.length) {
    throw new FileError(name, `${poses.length / 12} poses for ${parts.length} parts; the files are from different runs`);
  }
  let problem = "";
  const readable: MeshReader = (mesh) =>
    read(mesh).catch((error: unknown) => {
      problem = error instanceof Error ? error.message : String(error);
      throw new MissingMesh(problem);
    });
  const meshes = await Promise.all(
    list(header.meshes).map((value, index) =>
      readMesh(file, value, index, parts, readable).catch((error: unknown) => {
        if (error instanceof MissingMesh) return null;
        throw error;
      }),
    ),
  );
  return {
    position: Number(header.position ?? 0),
    time: Number(header.time ?? 0),
    poses,
    contacts: readContacts(file, header.contacts),
    forces: list(header.forces)
      .map((value) => readForce(value, parts.length))
      .filter((force) => force !== null),
    meshes: [...completed(meshes.filter((mesh) => mesh !== null), parts), ...readMotions(file, header.motions, parts)],
    bytes: buffer.byteLength,
    problem,
  };
}

/** Returns whether a mesh of the position has stresses: bearings have displacements alone. */
export function hasStresses({ meshes }: Position): boolean {
  return meshes.some(({ stresses }) => stresses !== null);
}

class MissingMesh extends Error {}
