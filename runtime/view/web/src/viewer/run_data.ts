// Parts and positions of a run, checked and decoded from array files.

import { ArrayFile, FileError, type Json } from "./array_file.ts";
import type { Vector } from "./state.ts";

export type PartKind = "gear" | "shaft" | "bearing" | "body";

export interface Part {
  index: number;
  name: string;
  kind: PartKind;
  copies: number;
  /** The surface contains shells: both sides are visible, and it encloses no volume. */
  open: boolean;
  points: Float32Array;
  triangles: Uint32Array;
  edges: Uint32Array;
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
  parts: Uint32Array;
  teeth: Uint32Array;
}

export interface Force {
  kind: "bearing" | "mesh";
  name: string;
  point: Vector;
  force: Vector;
  moment: Vector;
  parts: number[];
}

export interface DeformedMesh {
  part: number;
  copies: number[];
  points: Float32Array;
  displacements: Float32Array;
  stresses: Float32Array;
  triangles: Uint32Array;
  edges: Uint32Array;
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
    return { index, name, kind, copies, open: entry.open === true, points, triangles, edges };
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
  const count = pressures.length;
  if (corners.length !== 12 * count || parts.length !== 2 * count || teeth.length !== 2 * count) {
    throw new FileError(file.name, "contacts: the arrays have different lengths");
  }
  return count > 0 ? { count, corners, pressures, parts, teeth } : null;
}

function readMesh(file: ArrayFile, value: Json, index: number, parts: Part[]): DeformedMesh {
  const entry = record(value);
  const part = parts[Number(entry?.part)];
  if (!entry || !part) throw new FileError(file.name, `mesh ${index}: the part does not exist`);
  const label = `mesh of ${part.name}`;
  const points = file.f32(entry.points, 3, `${label}, points`);
  const displacements = file.f32(entry.displacements, 3, `${label}, displacements`);
  const stresses = file.f32(entry.stresses, 6, `${label}, stresses`);
  const triangles = file.u32(entry.triangles, 3, `${label}, triangles`);
  const edges = entry.edges ? file.u32(entry.edges, 2, `${label}, edges`) : new Uint32Array();
  const count = points.length / 3;
  if (displacements.length !== 3 * count || stresses.length !== 6 * count) {
    throw new FileError(file.name, `${label}: the arrays have different lengths`);
  }
  checkIndices(file.name, `${label}, triangles`, triangles, count);
  checkIndices(file.name, `${label}, edges`, edges, count);
  const copies = list(entry.copies).filter((n): n is number => typeof n === "number" && n >= 0 && n < part.copies);
  return { part: part.index, copies, points, displacements, stresses, triangles, edges };
}

export function readPosition(name: string, buffer: ArrayBuffer, parts: Part[]): Position {
  const file = ArrayFile.parse(name, buffer);
  const { header } = file;
  const poses = file.f64(header.poses, 12, "poses");
  if (poses.length !== 12 * parts.length) {
    throw new FileError(name, `${poses.length / 12} poses for ${parts.length} parts; the files are from different runs`);
  }
  return {
    position: Number(header.position ?? 0),
    time: Number(header.time ?? 0),
    poses,
    contacts: readContacts(file, header.contacts),
    forces: list(header.forces)
      .map((value) => readForce(value, parts.length))
      .filter((force) => force !== null),
    meshes: list(header.meshes).map((value, index) => readMesh(file, value, index, parts)),
    bytes: buffer.byteLength,
  };
}
