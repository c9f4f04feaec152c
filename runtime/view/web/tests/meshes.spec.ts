// Meshes that positions refer to: place, values, and number of reads.

import { expect, test } from "@playwright/test";
import type { Viewer } from "../src/viewer/index.ts";
import { readMeshShape, readPosition, type Part } from "../src/viewer/run_data.ts";
import { simplified } from "../src/viewer/outline.ts";
import { coarsen } from "../src/viewer/lod.ts";
import { placesOf, seamOf } from "../src/viewer/seams.ts";
import { Section } from "../src/viewer/section.ts";
import { buildSurface } from "../src/viewer/surface.ts";
import { displacement, embeddedData, createFixture, WHEEL, writePage } from "./fixture.ts";
import { ArrayWriter } from "./array_writer.ts";
import { gearSector } from "./gear_shapes.ts";
import { fixture, open, project, restore, settle, state } from "./page.ts";

test("a mesh appears in the place of its copy, with displacements in coordinates of the part", async ({ page }) => {
  await open(page);
  await restore(page, { parts: { pinion: "hidden", "bearing D": "hidden", "output shaft": "hidden" }, colours: { field: "displacement" }, extremes: false });
  const { points } = gearSector(WHEEL, 4, 6, 4);
  const angle = (2 * Math.PI * 17) / WHEEL.teeth;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const placed = (n: number): [number, number, number] => {
    const [x, y, z] = [points[3 * n]!, points[3 * n + 1]!, points[3 * n + 2]!];
    return [c * x - s * y, s * x + c * y, z];
  };
  // Nodes within the upper face, at true and at a large displayed deformation.
  const nodes = Array.from({ length: points.length / 3 }, (_, n) => n).filter((n) => {
    const r = Math.hypot(points[3 * n]!, points[3 * n + 1]!);
    return points[3 * n + 2]! > 13.9e-3 && r > 30e-3 && r < 55e-3 && Math.abs(points[3 * n + 1]!) < 2e-3;
  });
  expect(nodes.length).toBeGreaterThan(2);
  const camera = (await state(page)).camera!;
  for (const factor of [0, 100]) {
    await restore(page, { deformation: { mode: "factor", factor }, camera: { ...camera, target: [0.102 + 0.045, 0, 0.014], azimuth: -90, elevation: 89, height: 0.05, fitted: false } });
    await settle(page);
    for (const node of nodes.slice(0, 3)) {
      const at = placed(node);
      const u = displacement(...at).map((v) => -0.4 * v);
      const { x, y } = await project(page, "wheel", at.map((v, k) => v + factor * u[k]!) as [number, number, number]);
      await page.mouse.move(x - 1, y);
      await page.mouse.move(x, y);
      const tooltip = page.getByRole("status", { name: "Value at the pointer" });
      await expect(tooltip).toContainText("wheel, tooth 17");
      await expect(tooltip).toContainText(`node ${node}`);
      expect(Math.abs(Number(await tooltip.getAttribute("data-value")) / Math.hypot(...u) - 1)).toBeLessThan(1e-5);
    }
  }
});

test("each mesh is read once, for all positions and viewers of a run", { tag: "@slow" }, async ({ page }) => {
  const problems = await open(page, writePage("no_run", embeddedData(createFixture({ positions: 0 }))));
  const reads = await page.evaluate(async (data) => {
    const first = window.calyxViewer!;
    const read = async (text: string) => {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
    };
    const counts: Record<string, number> = {};
    const source = {
      title: "Run",
      parts: () => read(data.parts),
      positions: async () => data.positions,
      position: (index: number) => read(data.positions[index]!.data),
      mesh: (name: string) => {
        counts[name] = (counts[name] ?? 0) + 1;
        return read(data.meshes[name]!);
      },
    };
    const holder = document.createElement("div");
    holder.style.cssText = "width: 400px; height: 300px";
    document.body.append(holder);
    const second = new (first.constructor as new (container: HTMLElement) => Viewer)(holder);
    await Promise.all([first.show(source), second.show(source)]);
    for (const position of [1, 2, 0, 2]) {
      for (const viewer of [first, second]) viewer.restore({ position });
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
    await first.reload();
    const values = [first, second].map((viewer) => viewer.nodalValue("pinion", 40));
    second.dispose();
    return { counts, values };
  }, embeddedData(fixture));
  expect(Object.keys(reads.counts).sort()).toEqual(Object.keys(fixture.meshes).sort());
  expect(Object.values(reads.counts)).toEqual([1, 1]);
  expect(reads.values[0]).toBe(reads.values[1]);
  expect(problems).toEqual([]);
});

/** A sector of a twisted ring of 12 copies, by two hexahedra along the angle, two radially and three axially. */
function twistedSector() {
  const points: number[] = [];
  const hexahedra: number[] = [];
  const node = (i: number, j: number, k: number) => (k * 3 + j) * 3 + i;
  for (let k = 0; k <= 3; k++) {
    for (let j = 0; j <= 2; j++) {
      for (let i = 0; i <= 2; i++) {
        // The twist exceeds a pitch, and the cuts are curved.
        const [radius, z] = [0.03 + 0.005 * j, 0.007 * k - 0.01];
        const angle = (2 * Math.PI * i) / 2 / 12 + 40 * z + 0.02 * j * j;
        points.push(radius * Math.cos(angle), radius * Math.sin(angle), z);
        if (i < 2 && j < 2 && k < 3) {
          const corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] as const;
          hexahedra.push(...corners.map(([a, b, c]) => node(i + a, j + b, k + c)));
        }
      }
    }
  }
  const triangles: number[] = [];
  const quad = (...[a, b, c, d]: [number, number, number, number]) => triangles.push(a, c, b, a, d, c);
  for (let a = 0; a < 2; a++) {
    for (let b = 0; b < 2; b++) {
      quad(node(a, b, 0), node(a, b + 1, 0), node(a + 1, b + 1, 0), node(a + 1, b, 0));
      quad(node(a, b, 3), node(a + 1, b, 3), node(a + 1, b + 1, 3), node(a, b + 1, 3));
    }
    for (let k = 0; k < 3; k++) {
      quad(node(a, 0, k), node(a + 1, 0, k), node(a + 1, 0, k + 1), node(a, 0, k + 1));
      quad(node(a, 2, k), node(a, 2, k + 1), node(a + 1, 2, k + 1), node(a + 1, 2, k));
    }
  }
  return { points: Float32Array.from(points), triangles: Uint32Array.from(triangles), hexahedra: Uint32Array.from(hexahedra) };
}

test("neighbouring copies have the same nodes at their seam, to the last bit", () => {
  const { points } = twistedSector();
  const seam = seamOf(points, 12);
  const last = Array.from(seam.keys()).filter((n) => n % 3 === 2);
  expect(Array.from(seam.keys()).filter((n) => seam[n]! >= 0)).toEqual(last);
  for (const copy of [0, 4, 11]) {
    const [own, next] = [copy, (copy + 1) % 12].map((k) => placesOf(points, seam, k, 12)) as [Float64Array, Float64Array];
    for (const n of last) expect([...own.subarray(3 * n, 3 * n + 3)]).toEqual([...next.subarray(3 * n - 6, 3 * n - 3)]);
  }
});

/** A position of a ring of 12 copies, of which the first one moves. */
async function partlyMoving() {
  const { points, triangles, hexahedra } = twistedSector();
  const none = new Uint32Array();
  const shape = { name: "mesh-a.bin", open: false, extruded: false, points, triangles, hexahedra, edges: none, tetrahedra: none, wedges: none };
  const writer = new ArrayWriter();
  const mesh = { mesh: "mesh-a.bin", part: 0, copy: 0, displacements: writer.add("f32", 3, Array.from(points, (x) => 0.1 * x)) };
  const file = writer.finish({ poses: writer.add("f64", 12, Array(12).fill(0)), meshes: [mesh] });
  return readPosition("position-0000.bin", file.buffer as ArrayBuffer, [{ index: 0, name: "gear", copies: 12 } as Part], async () => shape);
}

test("copies without values complete a part, and its section has a closed outline", async () => {
  const { meshes } = await partlyMoving();
  expect(meshes.map(({ copy }) => copy).sort((a, b) => a - b)).toEqual(Array.from({ length: 12 }, (_, k) => k));
  expect(meshes.filter(({ stresses }) => stresses === null).length).toBe(12);
  // The copy in the file keeps its values, its neighbours follow at the seams, and the next ones do not move.
  const moved = meshes.map(({ copy, displacements }) => [copy, displacements.filter((u) => u !== 0).length] as const);
  expect(moved[0]).toEqual([0, meshes[0]!.shape.points.length]);
  expect([...meshes[0]!.displacements]).toEqual([...meshes[0]!.shape.points.map((x) => 0.1 * x)]);
  expect(moved.slice(1).filter(([, count]) => count > 0).map(([copy]) => copy).sort()).toEqual([1, 11]);
  // Sides of the triangles of all sections: inner ones have two triangles, those of the outline one.
  const sides = new Map<string, number>();
  const section = new Section();
  let area = 0;
  for (const mesh of meshes) {
    section.compute(mesh, null, [0.1, 0.2, 1, 0.0002], 1, false, 1e30);
    for (let t = 0; t < section.count; t++) {
      const corners = [0, 1, 2].map((k) => section.points.slice(9 * t + 3 * k, 9 * t + 3 * k + 3).join());
      for (const k of [0, 1, 2]) {
        if (corners[k] === corners[(k + 1) % 3]) continue;
        const side = [corners[k], corners[(k + 1) % 3]].sort().join(" to ");
        sides.set(side, (sides.get(side) ?? 0) + 1);
      }
      const [a, b, c] = [0, 3, 6].map((k) => [section.points[9 * t + k]!, section.points[9 * t + k + 1]!]) as [[number, number], [number, number], [number, number]];
      area += 0.5 * Math.abs((b[0]! - a[0]!) * (c[1]! - a[1]!) - (b[1]! - a[1]!) * (c[0]! - a[0]!));
    }
  }
  expect(area).toBeGreaterThan(0.9 * Math.PI * (0.04 ** 2 - 0.03 ** 2));
  const outline = [...sides].filter(([, count]) => count === 1).map(([side]) => side);
  // Each point of the outline has two sides, and there are two closed curves: the bore and the outer diameter.
  const neighbours = new Map<string, string[]>();
  for (const [a, b] of outline.map((side) => side.split(" to ") as [string, string])) {
    neighbours.set(a, [...(neighbours.get(a) ?? []), b]);
    neighbours.set(b, [...(neighbours.get(b) ?? []), a]);
  }
  expect([...neighbours.values()].filter(({ length }) => length !== 2)).toEqual([]);
  let curves = 0;
  for (const start of [...neighbours.keys()]) {
    if (neighbours.has(start)) curves++;
    for (let at: string | undefined = start; at !== undefined; ) {
      const next: string[] = neighbours.get(at) ?? [];
      neighbours.delete(at);
      at = next.find((other) => neighbours.has(other));
    }
  }
  expect(curves).toBe(2);
});

test("a surface of few triangles has plane end faces, no folds, and the same points at both cuts", () => {
  for (const [shape, teeth] of [[gearSector(WHEEL, 8, 24, 8), WHEEL.teeth], [twistedSector(), 12]] as const) {
    const points = Float32Array.from(shape.points);
    const surface = buildSurface(points, Uint32Array.from(shape.triangles), teeth);
    const top = Math.max(...points.filter((_, i) => i % 3 === 2));
    // Cells with points of the end face and of the layers below it.
    for (const cell of [2.5e-3, 4e-3, 5e-3]) {
      const coarse = coarsen(points, surface, teeth, cell);
      const [cos, sin] = [Math.cos((2 * Math.PI) / teeth), Math.sin((2 * Math.PI) / teeth)];
      const at = (v: number): [number, number, number] => {
        const [x, y, z] = coarse.points.subarray(3 * v, 3 * v + 3) as unknown as [number, number, number];
        return coarse.seam[v] ? [cos * x - sin * y, sin * x + cos * y, z] : [x, y, z];
      };
      expect(coarse.triangles.length).toBeGreaterThan(0);
      for (let t = 0; t < coarse.triangles.length; t += 3) {
        const corners = [...coarse.triangles.subarray(t, t + 3)];
        const [a, b, c] = corners.map(at) as [[number, number, number], [number, number, number], [number, number, number]];
        const normals = corners.map((v) => coarse.normals.subarray(3 * v, 3 * v + 3));
        const z = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        // The end face lies in its plane and faces upward.
        if (normals.every((n) => n[2]! > 0.99)) {
          expect(z).toBeGreaterThanOrEqual(0);
          for (const corner of [a, b, c]) expect(corner[2]).toBeCloseTo(top, 8);
        }
      }
    }
  }
});

test("outlines of small views keep corners and have no short lines between them", () => {
  // A square of which each side has 50 lines, and a circle of 100 lines.
  const points: number[] = [];
  const lines: number[] = [];
  const corners = [[0, 0], [1, 0], [1, 1], [0, 1]] as const;
  for (let i = 0; i < 200; i++) {
    const [[x, y], [u, v]] = [corners[Math.floor(i / 50)]!, corners[(Math.floor(i / 50) + 1) % 4]!];
    const t = (i % 50) / 50;
    points.push(x + t * (u - x), y + t * (v - y), 0);
    lines.push(i, (i + 1) % 200);
  }
  for (let i = 0; i < 100; i++) {
    points.push(3 + Math.cos((2 * Math.PI * i) / 100), Math.sin((2 * Math.PI * i) / 100), 0);
    lines.push(200 + ((i + 1) % 100), 200 + i);
  }
  expect(simplified(Uint32Array.from(lines), points, 0).length).toBe(lines.length);
  const found = simplified(Uint32Array.from(lines), points, 0.3);
  const degree = new Map<number, number>();
  for (const n of found) degree.set(n, (degree.get(n) ?? 0) + 1);
  expect([...degree.values()].every((count) => count === 2)).toBe(true);
  for (const corner of [0, 50, 100, 150]) expect(degree.has(corner)).toBe(true);
  const lengths = Array.from({ length: found.length / 2 }, (_, i) => Math.hypot(...[0, 1].map((k) => points[3 * found[2 * i]! + k]! - points[3 * found[2 * i + 1]! + k]!)));
  // The last line before a corner may be shorter.
  expect(lengths.filter((each) => each < 0.3).length).toBeLessThanOrEqual(5);
  expect(found.length / 2).toBeLessThan(40);
});

test("an extruded mesh has the values of its section at both ends", async () => {
  const buffer = (bytes: Uint8Array) => bytes.buffer as ArrayBuffer;
  const shapeOf = (points: number[]) => {
    const writer = new ArrayWriter();
    const arrays = { points: writer.add("f32", 3, points), triangles: writer.add("u32", 3, [0, 1, 2]) };
    return readMeshShape("mesh-a.bin", buffer(writer.finish({ open: false, extruded: true, ...arrays })));
  };
  const shape = shapeOf([1, 2, 0, 3, 4, 0, 1, 2, 5, 3, 4, 5]);
  const writer = new ArrayWriter();
  const values = {
    displacements: writer.add("f32", 2, [1, 2, 3, 4]),
    stresses: writer.add("f32", 4, [1, 2, 3, 4, 5, 6, 7, 8]),
    stress_errors: writer.add("f32", 1, [1, 2]),
  };
  const file = writer.finish({ poses: writer.add("f64", 12, Array(12).fill(0)), meshes: [{ mesh: "mesh-a.bin", part: 0, copy: 0, ...values }] });
  const position = await readPosition("position-0000.bin", buffer(file), [{ index: 0, name: "gear", copies: 1 } as Part], async () => shape);
  const mesh = position.meshes[0]!;
  expect([...mesh.displacements]).toEqual([1, 2, 0, 3, 4, 0, 1, 2, 0, 3, 4, 0]);
  expect([...mesh.stresses!]).toEqual([1, 2, 3, 0, 0, 4, 5, 6, 7, 0, 0, 8, 1, 2, 3, 0, 0, 4, 5, 6, 7, 0, 0, 8]);
  expect([...mesh.stressErrors!]).toEqual([1, 2, 1, 2]);
  expect(() => shapeOf([0, 0, 0])).toThrow("an extruded mesh needs an even number of them");
});
