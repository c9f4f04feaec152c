// Units: principal stresses, array files, surfaces, numbers.

import { expect, test } from "@playwright/test";
import { ArrayFile } from "../src/viewer/array_file.ts";
import { principalStresses, vonMises } from "../src/viewer/fields.ts";
import { readMeshShape, readParts, readPosition } from "../src/viewer/run_data.ts";
import { completeState, defaultState } from "../src/viewer/state.ts";
import { buildSurface } from "../src/viewer/surface.ts";
import { scaleTicks } from "../src/viewer/ticks.ts";
import { displayUnit, formatNumber, formatValue, roundDown125, useUnitsOf } from "../src/viewer/units.ts";
import { ArrayWriter } from "./array_writer.ts";
import { createFixture } from "./fixture.ts";
import { cylinder, gearSector } from "./gear_shapes.ts";

const buffer = (bytes: Uint8Array) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) as ArrayBuffer;

/** Components of R diag(values) Rᵀ for a rotation from three angles. */
function rotatedTensor(values: [number, number, number], a: number, b: number, c: number): [number, number, number, number, number, number] {
  const [ca, sa, cb, sb, cc, sc] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b), Math.cos(c), Math.sin(c)];
  const r = [
    [ca * cb, ca * sb * sc - sa * cc, ca * sb * cc + sa * sc],
    [sa * cb, sa * sb * sc + ca * cc, sa * sb * cc - ca * sc],
    [-sb, cb * sc, cb * cc],
  ];
  const t = (i: number, j: number) => values.reduce((sum, v, k) => sum + v * r[i]![k]! * r[j]![k]!, 0);
  return [t(0, 0), t(1, 1), t(2, 2), t(1, 2), t(2, 0), t(0, 1)];
}

test("principal stresses equal the eigenvalues of rotated tensors, also for repeated roots", () => {
  const cases: [number, number, number][] = [
    [3e8, 1e8, -2e8],
    [5e8, 5e8, -1e8],
    [5e8, -1e8, -1e8],
    [2e8, 2e8, 2e8],
    [1e8 + 1, 1e8, 1e8],
    [0, 0, -4e8],
    [1e-12, 0, -1e-12],
    [1e30, 1, -1e30],
  ];
  for (const values of cases) {
    for (const angles of [[0, 0, 0], [0.3, -1.1, 2], [1.5, 0.7, -0.4], [Math.PI / 4, 0, 0]] as const) {
      const found = principalStresses(...rotatedTensor(values, angles[0], angles[1], angles[2]));
      const scale = Math.max(...values.map(Math.abs));
      found.forEach((value, i) => expect(Math.abs(value - values[i]!)).toBeLessThan(4e-15 * scale + 1e-300));
      expect(found[0]).toBeGreaterThanOrEqual(found[2]);
    }
  }
  expect(principalStresses(0, 0, 0, 0, 0, 0)).toEqual([0, 0, 0]);
  expect(principalStresses(NaN, 0, 0, 0, 0, 0)).toEqual([NaN, NaN, NaN]);
});

test("the von Mises stress of uniaxial tension, pure shear and pressure", () => {
  expect(vonMises(2e8, 0, 0, 0, 0, 0)).toBeCloseTo(2e8, 5);
  expect(vonMises(0, 0, 0, 0, 0, 1e8)).toBeCloseTo(Math.sqrt(3) * 1e8, 5);
  expect(vonMises(-3e8, -3e8, -3e8, 0, 0, 0)).toBe(0);
});

test("array files are read, and damaged ones name the file and the reason", async () => {
  const fixture = createFixture();
  const parts = readParts(buffer(fixture.parts));
  expect(parts.parts.map(({ name }) => name).slice(0, 2)).toEqual(["pinion", "wheel"]);
  const data = fixture.positions[1]!.data;
  const meshes = async (name: string) => readMeshShape(name, buffer(fixture.meshes[name]!));
  const position = await readPosition("position-0001.bin", buffer(data), parts.parts, meshes);
  expect(position.meshes[0]!.shape.points.length).toBe(fixture.meshPoints.length);
  expect(position.forces.length).toBe(5);
  for (const length of [0, 10, 40, 300, data.length - 4]) {
    await expect(readPosition("position-0001.bin", buffer(data.slice(0, length)), parts.parts, meshes)).rejects.toThrow(/^position-0001\.bin: .*truncated/);
  }
  const other = data.slice();
  other[8] = 7;
  expect(() => ArrayFile.parse("a.bin", buffer(other))).toThrow("a.bin: version 7 of the format is not supported");
  other[8] = 1;
  expect(() => ArrayFile.parse("a.bin", buffer(other))).toThrow("a.bin: written by an older version of Calyx: run the model again");
  other.set([1, 2, 3], 0);
  expect(() => ArrayFile.parse("a.bin", buffer(other))).toThrow("a.bin: not an array file");
  await expect(readPosition("p.bin", buffer(data), parts.parts.slice(1), meshes)).rejects.toThrow(/8 poses for 7 parts/);
  // A missing mesh is reported; everything else is displayed.
  const without = await readPosition("p.bin", buffer(data), parts.parts, () => Promise.reject(new Error("no such file")));
  expect([without.meshes.length, without.problem, without.forces.length]).toEqual([0, "no such file", 5]);
});

test("a number of copies that needs more memory than there is is refused", () => {
  for (const copies of [1e9, 1e15, 0, -1, 1.5, "many"]) {
    const file = new ArrayWriter().finish({ parts: [{ name: "a", copies, points: null, triangles: null }] });
    expect(() => readParts(buffer(file))).toThrow("parts.bin: a: the number of copies is not valid");
  }
});

test("surfaces have sharp edges where faces meet at an angle and smooth normals elsewhere", () => {
  const shape = cylinder(1, 0, 2);
  const surface = buildSurface(Float32Array.from(shape.points), Uint32Array.from(shape.triangles), 1);
  // The two rims, without lines along the smooth lateral surface.
  expect(surface.features.length / 2).toBe(96);
  for (let i = 0; i < surface.normals.length; i += 3) {
    expect(Math.hypot(surface.normals[i]!, surface.normals[i + 1]!, surface.normals[i + 2]!)).toBeCloseTo(1, 5);
  }
});

test("normals continue over the seam between copies", () => {
  const gear = { teeth: 17, module: 4e-3, width: 30e-3, bore: 12e-3 };
  const shape = gearSector(gear);
  const surface = buildSurface(Float32Array.from(shape.points), Uint32Array.from(shape.triangles), gear.teeth);
  let checked = 0;
  for (let v = 0; v < surface.nodes.length; v++) {
    const n = 3 * surface.nodes[v]!;
    const [x, y, z] = [shape.points[n]!, shape.points[n + 1]!, shape.points[n + 2]!];
    if (Math.abs(Math.hypot(x, y) - gear.bore) > 1e-9 || Math.abs(z) > 14e-3) continue;
    // The bore is a cylinder: its normals are radial to within the error of its facets, at seams too.
    const radial = -(surface.normals[3 * v]! * x + surface.normals[3 * v + 1]! * y) / gear.bore;
    expect(radial).toBeGreaterThan(0.99999);
    checked++;
  }
  expect(checked).toBeGreaterThan(50);
});

test("numbers and units", () => {
  expect(formatNumber(1234.5678)).toBe("1235");
  expect(formatNumber(-0.25)).toBe("−0.25");
  expect(formatNumber(NaN)).toBe("no value");
  expect(displayUnit("m", 2e-6).symbol).toBe("µm");
  expect(displayUnit("Pa", 5e8)).toEqual({ symbol: "MPa", factor: 1e-6 });
  useUnitsOf("inch_lbf_s");
  expect(formatValue(6894757.293168361, "Pa")).toBe("1000 psi");
  expect(formatValue(0.0254, "m")).toBe("1 inch");
  useUnitsOf("mm_N_s");
  expect(formatValue(2.5e8, "Pa")).toBe("250 MPa");
  expect([1, 3, 7, 0.04, 1234].map(roundDown125)).toEqual([1, 2, 5, 0.02, 1000]);
});

test("a stored state of another form does not break the view", () => {
  const state = completeState({ colours: { bands: 8 }, camera: 3, parts: { a: "hidden" }, cut: null } as never);
  expect(state.colours).toEqual({ ...defaultState().colours, bands: 8 });
  expect(state.camera).toBeNull();
  expect(state.parts).toEqual({ a: "hidden" });
  expect(state.cut).toEqual(defaultState().cut);
});

test("legends have round numbers between their ends", () => {
  const ticks = (low: number, high: number) => scaleTicks(low, high, 5).map((tick) => Number(tick.toPrecision(6)));
  expect(ticks(0, 374.95)).toEqual([0, 100, 200, 300, 374.95]);
  // A round number beside an end would touch it.
  expect(ticks(1.98, 10.1)).toEqual([1.98, 4, 6, 8, 10.1]);
  expect(ticks(-3, 3)).toEqual([-3, -2, 0, 2, 3]);
});
