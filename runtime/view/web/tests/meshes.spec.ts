// Meshes that positions refer to: place, values, and number of reads.

import { expect, test } from "@playwright/test";
import type { Viewer } from "../src/viewer/index.ts";
import { readMeshShape, readPosition, type Part } from "../src/viewer/run_data.ts";
import { edgesBySide } from "../src/viewer/seams.ts";
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

test("open edges of a twisted sector are those of their neighbours", () => {
  // Four edges around each seam of a ring of 12 copies that is twisted by more than a pitch.
  const points: number[] = [];
  for (const side of [0, 1]) {
    for (const [radius, z] of [[0.03, -0.01], [0.04, -0.01], [0.04, 0.01], [0.03, 0.01]] as const) {
      const angle = (side * 2 * Math.PI) / 12 + 40 * z;
      points.push(radius * Math.cos(angle), radius * Math.sin(angle), z);
    }
  }
  const loop = (first: number) => [0, 1, 2, 3].flatMap((k) => [first + k, first + ((k + 1) % 4)]);
  const found = edgesBySide(Uint32Array.from([...loop(4), ...loop(0)]), Float32Array.from(points), 12);
  expect(found[1]).toEqual(loop(4));
  expect(found[-1]).toEqual(loop(0));
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
  expect([...mesh.stresses]).toEqual([1, 2, 3, 0, 0, 4, 5, 6, 7, 0, 0, 8, 1, 2, 3, 0, 0, 4, 5, 6, 7, 0, 0, 8]);
  expect([...mesh.stressErrors!]).toEqual([1, 2, 1, 2]);
  expect(() => shapeOf([0, 0, 0])).toThrow("an extruded mesh needs an even number of them");
});
