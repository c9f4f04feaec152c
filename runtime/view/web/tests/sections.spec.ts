// Sections through the cells of meshes, against closed forms.

import { expect, test } from "@playwright/test";
import type { DeformedMesh } from "../src/viewer/run_data.ts";
import { Section, tetrahedraOf, weightsAt, type Plane } from "../src/viewer/section.ts";
import { box, cubes, linearError, linearStress, STRAIN, type CellKind } from "./cells_fixture.ts";
import { embeddedData, writePage } from "./fixture.ts";
import { open, pixel, restore, settle } from "./page.ts";

const KINDS: CellKind[] = ["tetrahedra", "wedges", "hexahedra"];

/** A cube with the given displacement, in the place of copy `copy` of `copies`. */
function meshOf(kind: CellKind, n: number, copy = 0, copies = 1, strain = 0): DeformedMesh {
  const content = box(kind, n);
  const array = (values: ArrayLike<number> | undefined) => Uint32Array.from(values ?? []);
  const points = Float32Array.from(content.points);
  return {
    part: 0, copy, copies,
    shape: {
      name: kind, open: false, extruded: false, points, triangles: array(content.triangles), edges: array([]),
      tetrahedra: array(content.tetrahedra), wedges: array(content.wedges), hexahedra: array(content.hexahedra),
    },
    displacements: points.map((_, i) => (i % 3 === 2 ? strain * points[i]! : 0)),
    stresses: new Float32Array(2 * points.length),
    stressErrors: null,
  };
}

const field = (x: number, y: number, z: number) => 2 * x - 3 * y + 5 * z;

function fieldOf({ shape: { points } }: DeformedMesh): Float64Array {
  return Float64Array.from({ length: points.length / 3 }, (_, i) => field(points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!));
}

function area(section: Section): number {
  let sum = 0;
  const p = section.points;
  for (let i = 0; i < 9 * section.count; i += 9) {
    const [ux, uy, uz] = [p[i + 3]! - p[i]!, p[i + 4]! - p[i + 1]!, p[i + 5]! - p[i + 2]!];
    const [vx, vy, vz] = [p[i + 6]! - p[i]!, p[i + 7]! - p[i + 1]!, p[i + 8]! - p[i + 2]!];
    sum += 0.5 * Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
  }
  return sum;
}

function length(section: Section): number {
  let sum = 0;
  const e = section.edges;
  for (let i = 0; i < 6 * section.edgeCount; i += 6) sum += Math.hypot(e[i + 3]! - e[i]!, e[i + 4]! - e[i + 1]!, e[i + 5]! - e[i + 2]!);
  return sum;
}

/** Largest difference between the values of a section and a function of its points. */
function largestError(section: Section, expected: (x: number, y: number, z: number) => number): number {
  let largest = 0;
  for (let v = 0; v < 3 * section.count; v++) {
    const [x, y, z] = section.points.subarray(3 * v, 3 * v + 3) as unknown as [number, number, number];
    largest = Math.max(largest, Math.abs(section.values[v]! - expected(x, y, z)));
  }
  return largest;
}

test("the division into tetrahedra fills each cell, and neighbours divide their faces alike", () => {
  for (const kind of KINDS) {
    const { shape } = meshOf(kind, 2);
    const { nodes } = tetrahedraOf(shape, 1);
    let volume = 0;
    const faces = new Map<string, number>();
    for (let t = 0; t < nodes.length; t += 4) {
      const four = [...nodes.subarray(t, t + 4)];
      const [a, b, c, d] = four.map((n) => [...shape.points.subarray(3 * n, 3 * n + 3)]) as [number[], number[], number[], number[]];
      const [p, q, r] = [b, c, d].map((corner) => corner.map((v, k) => v - a[k]!)) as [number[], number[], number[]];
      const six = p[0]! * (q[1]! * r[2]! - q[2]! * r[1]!) + p[1]! * (q[2]! * r[0]! - q[0]! * r[2]!) + p[2]! * (q[0]! * r[1]! - q[1]! * r[0]!);
      volume += Math.abs(six) / 6;
      for (let k = 0; k < 4; k++) {
        const face = four.filter((_, i) => i !== k).sort((x, y) => x - y).join();
        faces.set(face, (faces.get(face) ?? 0) + 1);
      }
    }
    expect(volume).toBeCloseTo(1, 6);
    // A cube of 2 x 2 x 2 cells has 24 quadrilaterals outside, two triangles each; all other faces have two sides.
    expect([...faces.values()].filter((count) => count === 1).length).toBe(48);
    expect(Math.max(...faces.values())).toBe(2);
  }
});

test("sections of a cube have the exact area and the exact values of a linear field", () => {
  const section = new Section();
  for (const kind of KINDS) {
    const mesh = meshOf(kind, 3);
    const values = fieldOf(mesh);
    const s = Math.SQRT1_2;
    const planes: [Plane, number][] = [
      [[0, 0, 1, -0.3], 1],
      [[0, 0, -1, 0.3], 1],
      [[1, 0, 0, -0.71], 1],
      // Through the middle at 45 degrees, and a corner: x + y + z = 0.5.
      [[s, s, 0, -s], Math.SQRT2],
      [[1 / Math.sqrt(3), 1 / Math.sqrt(3), 1 / Math.sqrt(3), -0.5 / Math.sqrt(3)], (Math.sqrt(3) / 2) * 0.25],
      // In the plane of element faces, and outside of the cube.
      [[0, 0, 1, -Math.fround(2 / 3)], 1],
      [[0, 0, 1, -1.2], 0],
    ];
    for (const [plane, expected] of planes) {
      section.compute(mesh, values, plane, 0, true, 1e30);
      expect(area(section)).toBeCloseTo(expected, 5);
      expect(largestError(section, field)).toBeLessThan(2e-6);
    }
    section.compute(mesh, values, [0, 0, 1, -0.3], 0, true, 1e30);
    // Borders of the cells: the outline once and the inner faces twice, without the faces between the
    // tetrahedra into which a cell is divided. At z = 0.3 with cells of 1/3: t = 0.9.
    const grid = 4 + 2 * 2 * 2;
    if (kind === "hexahedra") expect(length(section)).toBeCloseTo(grid, 5);
    if (kind === "wedges") expect(length(section)).toBeCloseTo(grid + 9 * 2 * (Math.SQRT2 / 3), 5);
    if (kind === "tetrahedra") expect(length(section)).toBeGreaterThan(grid);
  }
});

test("on a layer of nodes, points are found in the cells that contain them and nowhere else", () => {
  const section = new Section();
  for (const kind of KINDS) {
    const mesh = meshOf(kind, 2);
    const values = fieldOf(mesh);
    for (const plane of [[0, 0, 1, -0.5], [0, 0, -1, 0.5], [1, 0, 0, -0.5]] as Plane[]) {
      section.compute(mesh, values, plane, 0, false, 1e30);
      const at = (u: number, v: number) => (plane[0] ? [0.5, u, v] : [u, v, 0.5]) as [number, number, number];
      for (const [u, v] of [[1.2, 0.3], [-0.1, 0.4], [0.31, -0.2], [7, 9]] as const) expect(section.find(...at(u, v), plane)).toBe(-1);
      for (const [u, v] of [[0.11, 0.23], [0.61, 0.37], [0.83, 0.92], [0.27, 0.71]] as const) {
        const triangle = section.find(...at(u, v), plane);
        expect(triangle).toBeGreaterThanOrEqual(0);
        const { nodes, weights } = weightsAt(mesh, section.sources[triangle]!, 0, at(u, v));
        for (const weight of weights) expect(Math.abs(weight - 0.5)).toBeLessThan(0.5 + 1e-6);
        expect(nodes.reduce((sum, n, i) => sum + weights[i]! * values[n]!, 0)).toBeCloseTo(field(...at(u, v)), 5);
      }
    }
  }
});

test("sections follow the rotation of the copy and the scaled displacement", () => {
  const section = new Section();
  for (const kind of KINDS) {
    // Copy 1 of 4 is rotated by 90 degrees: x becomes -y.
    const mesh = meshOf(kind, 3, 1, 4, 0.01);
    const values = fieldOf(mesh);
    const factor = 20;
    section.compute(mesh, values, [0, 0, 1, -0.3 * (1 + 0.01 * factor)], factor, false, 1e30);
    expect(area(section)).toBeCloseTo(1, 5);
    expect(Math.max(...section.points.subarray(0, 9 * section.count).filter((_, i) => i % 3 === 0))).toBeLessThan(1e-6);
    expect(largestError(section, (x, y) => field(y, -x, 0.3))).toBeLessThan(3e-6);
    const point = [-0.41, 0.23, 0.3 * (1 + 0.01 * factor)] as const;
    const triangle = section.find(...point, [0, 0, 1, 0]);
    const { nodes, weights } = weightsAt(mesh, section.sources[triangle]!, factor, point);
    expect(weights.reduce((sum, w) => sum + w)).toBeCloseTo(1, 9);
    expect(Math.abs(nodes.reduce((sum, n, i) => sum + weights[i]! * values[n]!, 0) - field(0.23, 0.41, 0.3))).toBeLessThan(1e-6);
    expect(section.find(0.5, 0.5, 0.36, [0, 0, 1, 0])).toBe(-1);
    // A node without a value: the triangles around it have none, others do.
    values[0] = NaN;
    section.compute(mesh, values, [0, 0, 1, -0.05], 0, false, 1e30);
    expect(section.values.subarray(0, 3 * section.count).some((v) => v > 1e20)).toBe(true);
    expect(section.values.subarray(0, 3 * section.count).some((v) => v < 10)).toBe(true);
  }
});

test("200,000 tetrahedra follow the drag of the plane", () => {
  const mesh = meshOf("tetrahedra", 33);
  expect(tetrahedraOf(mesh.shape, 1).nodes.length / 4).toBeGreaterThan(200_000);
  const values = fieldOf(mesh);
  const section = new Section();
  const plane = (z: number): Plane => [0.1, 0.2, Math.sqrt(0.95), -z];
  for (let i = 0; i < 5; i++) section.compute(mesh, values, plane(0.4), 1, true, 1e30);
  const start = performance.now();
  for (let i = 0; i < 10; i++) section.compute(mesh, values, plane(0.3 + 0.05 * i), 1, true, 1e30);
  const duration = (performance.now() - start) / 10;
  console.log(`${duration.toFixed(1)} ms, ${section.count} triangles`);
  // Generous, because the machines of CI are slow and busy; the frame rate needs 30 ms.
  expect(duration).toBeLessThan(200);
});

const address = writePage("cubes", embeddedData(cubes(), "Cubes"));

test("the section is coloured, and the value at the pointer is the linear interpolation", async ({ page }) => {
  const problems = await open(page, address);
  const camera = { projection: "orthographic", target: [2, 0.5, 0.3], azimuth: -90, elevation: 90, height: 3 };
  await restore(page, {
    camera, extremes: false, cut: { on: true, normal: "z", offset: 0.3, flipped: false }, deformation: { mode: "factor", factor: 0 },
    colours: { field: "von_mises", limits: "fixed", min: 1e8, max: 7e8, scale: "grey" },
  });
  await settle(page);
  const tooltip = page.getByRole("status", { name: "Value at the pointer" });
  const box = (await page.locator("canvas[role=img]").boundingBox())!;
  // The pointer has whole pixels in Firefox.
  const at = (x: number, y: number) => ({
    x: Math.round(box.x + box.width / 2 + ((x - 2) * box.height) / 3),
    y: Math.round(box.y + box.height / 2 - ((y - 0.5) * box.height) / 3),
  });
  for (const [part, kind] of KINDS.entries()) {
    const [x, y] = [0.37, 0.62];
    const point = at(1.5 * part + x, y);
    await page.mouse.move(point.x, point.y);
    await expect(tooltip).toContainText(kind);
    const value = Number(await tooltip.getAttribute("data-value"));
    const pixelX = 2 + ((point.x - box.x - box.width / 2) * 3) / box.height - 1.5 * part;
    const pixelY = 0.5 - ((point.y - box.y - box.height / 2) * 3) / box.height;
    expect(Math.abs(value / linearStress(pixelX, pixelY, 0.3) - 1)).toBeLessThan(1e-6);
    await page.mouse.move(0, 0);
    // The colour is that of the legend: grey from 0x1a to 0xf2.
    const [r] = (await pixel(page, point.x, point.y)) as [number];
    const fraction = (linearStress(x, y, 0.3) - 1e8) / 6e8;
    expect(Math.abs(r - (0x1a + fraction * (0xf2 - 0x1a)))).toBeLessThan(4);
  }
  // The scaled deformation moves the material: at factor 30 the plane shows other points.
  await restore(page, { deformation: { mode: "factor", factor: 30 } });
  await settle(page);
  const point = at(0.5, 0.5);
  await page.mouse.move(point.x, point.y);
  await expect(tooltip).toContainText("tetrahedra");
  const value = Number(await tooltip.getAttribute("data-value"));
  expect(Math.abs(value / linearStress(0.5, 0.5, 0.3 / (1 + 30 * STRAIN)) - 1)).toBeLessThan(3e-3);
  // The stress error has values on the section, too.
  await restore(page, { deformation: { mode: "factor", factor: 0 }, colours: { field: "stress_error", limits: "position" } });
  await settle(page);
  await page.mouse.move(point.x + 1, point.y);
  await page.mouse.move(point.x, point.y);
  await expect(tooltip).toContainText("Stress error");
  expect(Math.abs(Number(await tooltip.getAttribute("data-value")) / linearError(0.5, 0.5, 0.3) - 1)).toBeLessThan(5e-3);
  expect(problems).toEqual([]);
});

test("the section shows the edges of the elements with the mesh, and hatching without a field", { tag: "@slow" }, async ({ page }) => {
  await open(page, address);
  const camera = { projection: "orthographic", target: [0.5, 0.5, 0.3], azimuth: -90, elevation: 90, height: 1.6 };
  await restore(page, { camera, extremes: false, cut: { on: true, normal: "z", offset: 0.3 }, deformation: { mode: "factor", factor: 0 }, colours: { field: "von_mises" } });
  const dark = async () => {
    await page.mouse.move(0, 0);
    await settle(page);
    const box = (await page.locator("canvas[role=img]").boundingBox())!;
    // A short line across the border between two elements at x = 1/3.
    const y = box.y + box.height / 2 + 0.08 * box.height;
    const x = box.x + box.width / 2 + ((1 / 3 - 0.5) * box.height) / 1.6;
    const colours = await Promise.all([-6, -1, 0, 1].map((d) => pixel(page, x + d, y)));
    const sum = (c: number[]) => c.reduce((s, v) => s + v);
    return sum(colours[0]!) - Math.min(...colours.slice(1).map(sum));
  };
  expect(Math.abs(await dark())).toBeLessThan(12);
  await restore(page, { mesh_edges: true });
  expect(await dark()).toBeGreaterThan(40);
});
