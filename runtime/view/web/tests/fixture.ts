// A synthetic run: two spur gears on shafts with bearings, contacts, forces and deformed meshes with
// known fields.

import { gzipSync } from "node:zlib";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { ArrayWriter, meshFile } from "./array_writer.ts";
import { baseRadius, cylinder, gearSector, halfAngle, ring, type GearData, type Shape } from "./gear_shapes.ts";

const HERE = dirname(fileURLToPath(import.meta.url));
export const PINION: GearData = { teeth: 17, module: 4e-3, width: 30e-3, bore: 12e-3 };
export const WHEEL: GearData = { teeth: 34, module: 4e-3, width: 28e-3, bore: 18e-3 };
const DISTANCE = 0.5 * 4e-3 * (17 + 34);
const ALPHA = (20 * Math.PI) / 180;

export interface FixtureOptions {
  positions?: number;
  meshes?: boolean;
  contacts?: boolean;
  /** Stresses of the nodes in the bore are NaN. */
  unknown?: boolean;
  /** Name of a part that has no position. */
  lost?: string | null;
  /** The first node of the pinion's mesh has a stress error of 1 GPa. */
  outlier?: boolean;
}

export interface Fixture {
  parts: Uint8Array;
  positions: { position: number; time: number; data: Uint8Array }[];
  /** Files of meshes by name. */
  meshes: Record<string, Uint8Array>;
  /** Points of the pinion's mesh, three per node. */
  meshPoints: number[];
}

/** Displacement of the fixture: linear in the coordinates. */
export const displacement = (x: number, y: number, z: number): [number, number, number] => [
  2e-4 * x - 1e-4 * y,
  1e-4 * x + 1e-4 * y,
  -5e-5 * z,
];

/** Uniaxial stress of the fixture along x; its absolute value is the von Mises stress. */
export function uniaxialStress(x: number, y: number, z: number): number {
  const pitch = 0.5 * PINION.module * PINION.teeth;
  const depth = (Math.hypot(x, y) - (pitch - PINION.module)) / (1.1 * PINION.module);
  const side = y >= 0 ? 1 : -1;
  return side * 3.2e8 * Math.exp(-depth * depth) * (1 - 0.25 * (z / (0.5 * PINION.width)) ** 2) * Math.min(1, Math.abs(y) / 2e-3) + 1e6;
}

interface PartShape extends Shape {
  name: string;
  kind: string;
  copies: number;
  x: number;
}

function partShapes(): PartShape[] {
  const bearing = (name: string, x: number, inner: number, z: number): PartShape => ({
    name, kind: "bearing", copies: 1, x, ...ring(inner, inner + 9e-3, z - 6e-3, z + 6e-3),
  });
  return [
    { name: "pinion", kind: "gear", copies: PINION.teeth, x: 0, ...gearSector(PINION) },
    { name: "wheel", kind: "gear", copies: WHEEL.teeth, x: DISTANCE, ...gearSector(WHEEL) },
    { name: "input shaft", kind: "shaft", copies: 1, x: 0, ...cylinder(12e-3, -65e-3, 45e-3) },
    { name: "output shaft", kind: "shaft", copies: 1, x: DISTANCE, ...cylinder(18e-3, -45e-3, 65e-3) },
    bearing("bearing A", 0, 12e-3, -32e-3),
    bearing("bearing B", 0, 12e-3, 32e-3),
    bearing("bearing C", DISTANCE, 18e-3, -32e-3),
    bearing("bearing D", DISTANCE, 18e-3, 32e-3),
  ];
}

function angles(phase: number): [number, number] {
  const wheel = Math.PI + Math.PI / WHEEL.teeth - (phase * PINION.teeth) / WHEEL.teeth;
  return [phase, wheel];
}

function pose(angle: number, x: number): number[] {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return [c, -s, 0, s, c, 0, 0, 0, 1, x, 0, 0];
}

/** Contact cells on the pinion's teeth along the line of action. */
export function contactCells(phase: number) {
  const corners: number[] = [];
  const pressures: number[] = [];
  const parts: number[] = [];
  const teeth: number[] = [];
  const zones: number[] = [];
  const surfaces: number[] = [];
  const centres: [number, number, number][] = [];
  const base = baseRadius(PINION);
  const pitch = 0.5 * PINION.module * PINION.teeth;
  const [across, along] = [8, 24];
  for (let tooth = 0; tooth < PINION.teeth; tooth++) {
    const middle = Math.atan2(Math.sin(phase + (2 * Math.PI * tooth) / PINION.teeth), Math.cos(phase + (2 * Math.PI * tooth) / PINION.teeth));
    const roll = Math.tan(ALPHA) + Math.PI / (2 * PINION.teeth) - middle;
    const radius = base * Math.hypot(1, roll);
    if (roll < 0.12 || radius > pitch + 0.9 * PINION.module) continue;
    const half = 0.35e-3;
    const width = 0.94 * WHEEL.width;
    const at = (i: number, k: number) => {
      const r = Math.max(base, radius + half * ((2 * i) / across - 1));
      const angle = middle - halfAngle(PINION, r);
      return [r * Math.cos(angle), r * Math.sin(angle), width * (k / along - 0.5)];
    };
    centres.push(at(across / 2, along / 2) as [number, number, number]);
    const partner = ((Math.round(WHEEL.teeth / 2 - tooth) % WHEEL.teeth) + WHEEL.teeth) % WHEEL.teeth;
    for (let i = 0; i < across; i++) {
      for (let k = 0; k < along; k++) {
        corners.push(...at(i, k), ...at(i + 1, k), ...at(i + 1, k + 1), ...at(i, k + 1));
        const u = ((2 * (i + 0.5)) / across - 1) ** 2;
        const v = ((2 * (k + 0.5)) / along - 1) ** 4;
        pressures.push(u + v < 1 ? 9.5e8 * Math.sqrt(1 - u - v) : 0);
        parts.push(0, 1);
        teeth.push(tooth, partner);
        // The outermost row of each contact is in the edge zone.
        zones.push(i === across - 1 ? 1 : 0);
        surfaces.push(1, 0);
      }
    }
  }
  return { corners, pressures, parts, teeth, zones, surfaces, centres };
}

/** Normal force of the fixture's contact cells, N: arc length by width by pressure. */
export function contactLoad(phase: number): number {
  const { corners, pressures } = contactCells(phase);
  return pressures.reduce((sum, pressure, cell) => {
    const [x0, y0, z0, x1, y1] = corners.slice(12 * cell, 12 * cell + 5) as [number, number, number, number, number];
    const z3 = corners[12 * cell + 11]!;
    return sum + pressure * Math.hypot(x1 - x0, y1 - y0) * Math.abs(z3 - z0);
  }, 0);
}

const PINION_MESH = gearSector(PINION, 4, 6, 4);
const WHEEL_MESH = gearSector(WHEEL, 4, 6, 4);
const WHEEL_COPY = 17;

/** Estimated stress error of the fixture: linear in z. */
export const stressError = (z: number): number => 2e7 + 1e9 * z;

/** Deformed mesh of the pinion's tooth 0. */
function pinionMesh(writer: ArrayWriter, unknown: boolean, outlier: boolean) {
  const { points } = PINION_MESH;
  const displacements: number[] = [];
  const stresses: number[] = [];
  const errors: number[] = [];
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = [points[i]!, points[i + 1]!, points[i + 2]!];
    displacements.push(...displacement(x, y, z));
    const none = unknown && Math.hypot(x, y) < PINION.bore + 1e-6;
    stresses.push(none ? NaN : uniaxialStress(x, y, z), ...(none ? [NaN, NaN, NaN, NaN, NaN] : [0, 0, 0, 0, 0]));
    errors.push(none ? NaN : stressError(z));
  }
  if (outlier) errors[0] = 1e9;
  return mesh(writer, 0, 0, meshFile(PINION_MESH).name, displacements, stresses, errors);
}

function mesh(
  writer: ArrayWriter, part: number, copy: number, name: string, displacements: number[], stresses: number[], errors: number[],
) {
  return {
    mesh: name,
    part,
    copy,
    displacements: writer.add("f32", 3, displacements),
    stresses: writer.add("f32", 6, stresses),
    stress_errors: writer.add("f32", 1, errors),
  };
}

/** Deformed mesh of the wheel's tooth that meshes with the pinion's tooth 0. */
function wheelMesh(writer: ArrayWriter) {
  const { points } = WHEEL_MESH;
  const angle = (2 * Math.PI * WHEEL_COPY) / WHEEL.teeth;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const displacements: number[] = [];
  const stresses: number[] = [];
  const errors: number[] = [];
  for (let i = 0; i < points.length; i += 3) {
    // Displacements are given in coordinates of the part, at the place of the copy.
    const [x, y, z] = [c * points[i]! - s * points[i + 1]!, s * points[i]! + c * points[i + 1]!, points[i + 2]!];
    displacements.push(...displacement(x, y, z).map((u) => -0.4 * u));
    const depth = (Math.hypot(x, y) - 62.5e-3) / 4.4e-3;
    stresses.push(-2.4e8 * Math.exp(-depth * depth), 0, 0, 0, 0, 0);
    errors.push(1e7);
  }
  return mesh(writer, 1, WHEEL_COPY, meshFile(WHEEL_MESH).name, displacements, stresses, errors);
}

export function createFixture(options: FixtureOptions = {}): Fixture {
  const { positions: count = 3, meshes = true, contacts = true, unknown = true, lost = null, outlier = false } = options;
  const shapes = partShapes();
  const writer = new ArrayWriter();
  const parts = writer.finish({
    model: "spur_pair.cx",
    parts: shapes.map(({ name, kind, copies, points, triangles, edges }) => ({
      name, kind, copies,
      points: writer.add("f32", 3, points),
      triangles: writer.add("u32", 3, triangles),
      edges: writer.add("u32", 2, edges),
    })),
  });
  const positions = Array.from({ length: count }, (_, position) => {
    const phase = (0.3 * position) / Math.max(count, 3);
    const time = position * 0.5e-3;
    const [pinion, wheel] = angles(phase);
    const file = new ArrayWriter();
    const cells = contactCells(phase);
    const centre = cells.centres[0] ?? [pinion, 0, 0];
    const force = [-2400 * Math.sin(ALPHA), 2400 * Math.cos(ALPHA), 0];
    const header = {
      position,
      time,
      poses: file.add("f64", 12, shapes.flatMap(({ name, x }) =>
        name === lost ? Array<number>(12).fill(NaN) : pose(name === "pinion" ? pinion : name === "wheel" ? wheel : 0, x))),
      ...(contacts
        ? {
            contacts: {
              corners: file.add("f32", 12, cells.corners),
              pressures: file.add("f32", 1, cells.pressures),
              zones: file.add("u32", 1, cells.zones),
              surfaces: file.add("u32", 2, cells.surfaces),
              parts: file.add("u32", 2, cells.parts),
              teeth: file.add("u32", 2, cells.teeth),
            },
            forces: [
              { kind: "mesh", name: "pinion and wheel", point: centre, force, moment: [0, 0, 0], parts: [0, 1] },
              ...["A", "B"].map((n, i) => ({ kind: "bearing", name: n, point: [0, 0, i ? 32e-3 : -32e-3], force: force.map((f) => -0.5 * f), moment: [0, 0, 0], parts: [2] })),
              ...["C", "D"].map((n, i) => ({ kind: "bearing", name: n, point: [DISTANCE, 0, i ? 32e-3 : -32e-3], force: force.map((f) => 0.5 * f), moment: [0, 0, 0], parts: [3] })),
            ],
          }
        : {}),
      meshes: meshes ? [pinionMesh(file, unknown, outlier), wheelMesh(file)] : [],
    };
    return { position, time, data: file.finish(header) };
  });
  const files = meshes ? [meshFile(PINION_MESH), meshFile(WHEEL_MESH)] : [];
  return { parts, positions, meshes: Object.fromEntries(files.map(({ name, data }) => [name, data])), meshPoints: PINION_MESH.points };
}

const base64 = (bytes: Uint8Array) => gzipSync(bytes).toString("base64");

/** Data of the page in the form that `calyx view --html` writes. */
export function embeddedData(fixture: Fixture, title = "Spur pair") {
  const n = 25;
  const rows = Array.from({ length: n }, (_, i) => i);
  const end = fixture.positions[fixture.positions.length - 1]?.time ?? 1;
  return {
    title,
    provenance: [["Model", "spur_pair.cx"], ["Fidelity", "fe"], ["Version", "1.0.0"], ["Date", "2026-01-15"]],
    outputs: {
      columns: [
        { name: "step", unit: "", values: rows },
        { name: "time", unit: "s", values: rows.map((i) => (end * i) / (n - 1)) },
        { name: "transmission_error", unit: "rad", values: rows.map((i) => 3.3e-4 + 2e-5 * Math.sin(i / 3) + 8e-6 * Math.cos(i)) },
        { name: "max_contact_pressure", unit: "Pa", values: rows.map((i) => (i === 7 ? null : 9e8 + 6e7 * Math.sin(i / 2))) },
      ],
    },
    parts: base64(fixture.parts),
    positions: fixture.positions.map(({ position, time, data }) => ({ position, time, data: base64(data) })),
    meshes: Object.fromEntries(Object.entries(fixture.meshes).map(([name, data]) => [name, base64(data)])),
  };
}

/** Writes a self-contained page and returns its address. */
export function writePage(name: string, data: object, head = ""): string {
  const dist = join(HERE, "..", "dist");
  const script = readFileSync(join(dist, "viewer.js"), "utf8").replaceAll("</script", "<\\/script");
  const style = readFileSync(join(dist, "viewer.css"), "utf8");
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  const html =
    `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">` +
    `<title>Calyx</title>${head}<style>${style}</style></head><body><script type="application/json" id="calyx-view">${json}</script>` +
    `<script>${script}</script></body></html>`;
  const directory = join(HERE, "..", "test-results", "pages");
  mkdirSync(directory, { recursive: true });
  const path = join(directory, `${name}.html`);
  writeFileSync(path, html);
  return `file://${path}`;
}
