// Contact patterns on unrolled flanks, choices of cells, and stress errors, against known values.

import { expect, test, type Page } from "@playwright/test";
import { edgesDominate, largestPressure } from "../src/viewer/contacts.ts";
import { boundsOf, cellAt, Envelope, isIncluded, loadedSide, PatternAxes, patternCells } from "../src/viewer/pattern.ts";
import { roundTicks } from "../src/viewer/ticks.ts";
import type { Contacts, Part, Position } from "../src/viewer/run_data.ts";
import { toothOf } from "../src/viewer/tooth.ts";
import { contactCells, createFixture, embeddedData, PINION, stressError, writePage } from "./fixture.ts";
import { gearSector, halfAngle, type Shape } from "./gear_shapes.ts";
import { open, openWith, pageAddress, project, restore, settle, state } from "./page.ts";

function partOf(shape: Shape, copies: number): Part {
  return {
    index: 0, name: "gear", kind: "gear", copies, withoutMesh: 0, withOuter: null, open: false,
    points: Float32Array.from(shape.points), triangles: Uint32Array.from(shape.triangles), edges: new Uint32Array(),
  };
}

/**
 * Maps a spur tooth to a conical one with the pitch cone angle `delta`: cross sections become similar
 * ones on spheres about the apex. The angular thickness is constant along each generatrix.
 */
function conical(shape: Shape, pitch: number, delta: number): Shape {
  const points: number[] = [];
  const length = pitch / Math.sin(delta);
  for (let i = 0; i < shape.points.length; i += 3) {
    const [x, y, z] = [shape.points[i]!, shape.points[i + 1]!, shape.points[i + 2]!];
    const [radius, angle] = [Math.hypot(x, y), Math.atan2(y, x)];
    // Height above the pitch cone and distance from the apex; the tooth shrinks towards the apex.
    const s = (length + z) / length;
    const height = (radius - pitch) * s;
    const along = length + z;
    const [axial, radial] = [along * Math.cos(delta) - height * Math.sin(delta), along * Math.sin(delta) + height * Math.cos(delta)];
    points.push(radial * Math.cos(angle), radial * Math.sin(angle), axial);
  }
  return { ...shape, points };
}

test("the flank of a spur tooth is a rectangle in the axial section", () => {
  const tooth = toothOf(partOf(gearSector(PINION, 8, 6, 4), PINION.teeth))!;
  expect(tooth.direction).toBe(0);
  for (const [side, sign] of [["left", 1], ["right", -1]] as const) {
    const { outline, angle } = tooth.flanks[side];
    expect(outline.length).toBe(1);
    const z = outline[0]!.filter((_, i) => i % 2 === 0);
    const r = outline[0]!.filter((_, i) => i % 2 === 1);
    expect([Math.min(...z), Math.max(...z)].map((v) => v * 1e3)).toEqual([expect.closeTo(-15, 3), expect.closeTo(15, 3)]);
    expect(Math.max(...r)).toBeCloseTo(38e-3, 6);
    expect(Math.min(...r)).toBeGreaterThan(28e-3);
    // The affine approximation of the involute is near the tooth's half angle at the pitch circle.
    expect(angle[0] + angle[2] * 34e-3).toBeCloseTo(sign * halfAngle(PINION, 34e-3), 1);
    expect(Math.abs(angle[1])).toBeLessThan(0.01);
  }
});

test("the direction along the face of a conical tooth is its pitch cone angle", () => {
  for (const degrees of [15, 30, 45, 63, 80]) {
    const delta = (degrees * Math.PI) / 180;
    const shape = conical(gearSector({ ...PINION, width: 10e-3 }, 8, 6, 4), 34e-3, delta);
    const tooth = toothOf(partOf(shape, PINION.teeth))!;
    expect(Math.abs((tooth.direction * 180) / Math.PI - degrees)).toBeLessThan(2);
    // The face is horizontal in the picture: 10 mm long.
    const axes = new PatternAxes(tooth.direction);
    const { u0, u1 } = boundsOf(partOf(shape, PINION.teeth), "left", axes);
    expect(u1 - u0).toBeGreaterThan(9.5e-3);
    expect(u1 - u0).toBeLessThan(12e-3);
  }
});

test("conical teeth have the tip at the top and the toe on the left, cylindrical ones the radius upwards", () => {
  const spur = gearSector({ ...PINION, width: 10e-3 }, 8, 6, 4);
  const radius = (i: number) => Math.hypot(spur.points[3 * i]!, spur.points[3 * i + 1]!);
  const nodes = Array.from({ length: spur.points.length / 3 }, (_, i) => i);
  const tip = nodes.reduce((a, b) => (radius(b) > radius(a) + 1e-9 ? b : a));
  const root = nodes.filter((i) => Math.abs(spur.points[3 * i + 2]! - spur.points[3 * tip + 2]!) < 1e-9).reduce((a, b) => (radius(b) < radius(a) ? b : a));
  const [toe, heel] = [Math.min, Math.max].map((pick) => nodes.find((i) => spur.points[3 * i + 2] === pick(...nodes.map((k) => spur.points[3 * k + 2]!)) && Math.abs(radius(i) - radius(tip)) < 1e-9)!);
  for (const degrees of [20, 63, 90]) {
    for (const turn of [1, -1]) {
      const shape = conical(spur, 34e-3, (degrees * Math.PI) / 180);
      // The apex is on either side.
      const points = shape.points.map((v, i) => (i % 3 === 0 ? v : turn * v));
      const tooth = toothOf(partOf({ ...shape, points }, PINION.teeth))!;
      const axes = new PatternAxes(tooth.direction, tooth.tip);
      const at = (i: number) => [points[3 * i + 2]!, Math.hypot(points[3 * i]!, points[3 * i + 1]!)] as const;
      expect(axes.across(...at(tip))).toBeGreaterThan(axes.across(...at(root)) + 5e-3);
      expect(axes.along(...at(heel!))).toBeGreaterThan(axes.along(...at(toe!)) + 5e-3);
      const [z, r] = axes.inverse(axes.along(...at(tip)), axes.across(...at(tip)));
      expect(Math.hypot(z - at(tip)[0], r - at(tip)[1])).toBeLessThan(1e-12);
      expect(axes.ends).toEqual(["toe", "heel", "root", "tip"]);
    }
  }
  // An internal tooth: radii mirrored at the pitch circle.
  const mirrored = spur.points.map((v, i) => (i % 3 === 2 ? v : (v / radius(Math.floor(i / 3))) * (68e-3 - radius(Math.floor(i / 3)))));
  const triangles = spur.triangles.map((_, i) => spur.triangles[i - (i % 3) + [0, 2, 1][i % 3]!]!);
  const ring = toothOf(partOf({ ...spur, points: mirrored, triangles }, PINION.teeth))!;
  expect(new PatternAxes(ring.direction, ring.tip).ends).toEqual(["−z end", "+z end", "tip", "root"]);
  const external = toothOf(partOf(spur, PINION.teeth))!;
  expect(new PatternAxes(external.direction, external.tip).ends).toEqual(["−z end", "+z end", "root", "tip"]);
});

test("helical teeth have the direction of the axis, also with more than half a turn", () => {
  for (const twist of [0.2, -2, 9]) {
    const shape = gearSector(PINION, 8, 24, 4);
    const points = shape.points.slice();
    for (let i = 0; i < points.length; i += 3) {
      const angle = (twist * points[i + 2]!) / PINION.width;
      const [x, y] = [points[i]!, points[i + 1]!];
      points[i] = Math.cos(angle) * x - Math.sin(angle) * y;
      points[i + 1] = Math.sin(angle) * x + Math.cos(angle) * y;
    }
    const tooth = toothOf(partOf({ ...shape, points }, PINION.teeth))!;
    expect(tooth.direction).toBe(0);
    expect(tooth.flanks.left.angle[1]).toBeCloseTo(twist / PINION.width, 0);
    if (Math.abs(twist) < 1) expect(tooth.flanks.left.outline.length).toBe(1);
  }
});

/** A position with the contact cells of the fixture and a rotated, moved pinion. */
function positionAt(phase: number): Position {
  const cells = contactCells(phase);
  const [c, s] = [Math.cos(phase), Math.sin(phase)];
  const contacts: Contacts = {
    count: cells.pressures.length,
    corners: Float32Array.from(cells.corners),
    pressures: Float32Array.from(cells.pressures),
    zones: Uint32Array.from(cells.zones), parts: Uint32Array.from(cells.parts),
    teeth: Uint32Array.from(cells.teeth), surfaces: Uint32Array.from(cells.surfaces),
  };
  const poses = Float64Array.from([c, -s, 0, s, c, 0, 0, 0, 1, 0, 0, 0]);
  return { position: 0, time: 0, poses, contacts, forces: [], meshes: [], bytes: 0, problem: "" };
}

test("the outline of a helical flank is straight along the face", () => {
  const shape = gearSector(PINION, 8, 6, 4);
  const points = [...shape.points];
  for (let i = 0; i < points.length; i += 3) {
    const angle = points[i + 2]! * 25;
    const [x, y] = [points[i]!, points[i + 1]!];
    points[i] = Math.cos(angle) * x - Math.sin(angle) * y;
    points[i + 1] = Math.sin(angle) * x + Math.cos(angle) * y;
  }
  const tooth = toothOf(partOf({ ...shape, points }, PINION.teeth))!;
  for (const side of ["left", "right"] as const) {
    const [outline] = tooth.flanks[side].outline;
    const radii: number[] = [];
    for (let i = 0; i < outline!.length; i += 2) if (Math.abs(outline![i]!) < 0.49 * PINION.width) radii.push(outline![i + 1]!);
    const [low, high] = [Math.min(...radii), Math.max(...radii)];
    expect(radii.filter((r) => r - low > 1e-6 && high - r > 1e-6)).toEqual([]);
  }
});

test("cells have the coordinates of the gear, and the flank of their surface", () => {
  const part = partOf(gearSector(PINION, 4, 6, 4), PINION.teeth);
  const position = positionAt(0.21);
  const cells = patternCells(position, part, "all");
  const loaded = [...position.contacts!.pressures].filter((p) => p > 0);
  expect(cells.length).toBe(loaded.length);
  // The fixture's contacts are where the angles of a tooth are smallest: on the right flank.
  expect(new Set(cells.map(({ side }) => side))).toEqual(new Set(["right"]));
  expect(loadedSide(cells)).toBe("right");
  let error = 0;
  for (const { cell, corners, pressure } of cells) {
    const c = position.contacts!.corners.subarray(12 * cell, 12 * cell + 12);
    // The pinion rotates about the origin: radius and z are those of the ground.
    for (let k = 0; k < 4; k++) {
      error = Math.max(error, Math.abs(corners[2 * k]! - c[3 * k + 2]!));
      error = Math.max(error, Math.abs(corners[2 * k + 1]! - Math.hypot(c[3 * k]!, c[3 * k + 1]!)));
    }
    if (pressure !== position.contacts!.pressures[cell]) error = Infinity;
  }
  expect(error).toBeLessThan(1e-9);
  const edges = patternCells(position, part, "edges");
  const flanks = patternCells(position, part, "flanks");
  expect(edges.length + flanks.length).toBe(cells.length);
  expect(edges.every(({ cell }) => position.contacts!.zones[cell] === 1)).toBe(true);
  const top = cells[cells.length - 1]!;
  const [z, r] = [(top.corners[0]! + top.corners[4]!) / 2, (top.corners[1]! + top.corners[5]!) / 2];
  expect(cellAt(cells, z, r)!.pressure).toBe(Math.max(...loaded));
  expect(cellAt(cells, 0, 20e-3)).toBeNull();
});

test("edges dominate if they exceed the flank zone by more than half", () => {
  const contacts = (pressures: number[], zones: number[]): Contacts => ({
    count: pressures.length, pressures: Float32Array.from(pressures), zones: Uint32Array.from(zones), corners: new Float32Array(12 * pressures.length),
    parts: new Uint32Array(2 * pressures.length), teeth: new Uint32Array(2 * pressures.length), surfaces: new Uint32Array(2 * pressures.length),
  });
  expect(edgesDominate(contacts([10, 16, 3], [0, 1, 2]))).toBe(true);
  expect(edgesDominate(contacts([10, 3, 16], [0, 1, 2]))).toBe(true);
  expect(edgesDominate(contacts([10, 14, 3], [0, 1, 2]))).toBe(false);
  // Without cells on flanks, there is nothing else to display.
  expect(edgesDominate(contacts([16], [1]))).toBe(false);
  expect(largestPressure(contacts([10, 14, 20], [0, 1, 2]), "edges")).toBe(14);
});

test("the envelope is the maximum over the positions", () => {
  const part = partOf(gearSector(PINION, 4, 6, 4), PINION.teeth);
  const axes = new PatternAxes(0);
  const envelope = new Envelope(boundsOf(part, "right", axes), axes, 1600);
  const all = [0, 0.05, 0.1, 0.15, 0.2].flatMap((phase) => patternCells(positionAt(phase), part, "all"));
  const cells = all.filter((cell) => isIncluded(cell, { tooth: null, side: "right" }));
  envelope.add(cells);
  const sorted = cells.sort((a, b) => a.pressure - b.pressure);
  expect(envelope.largest).toBe(sorted[sorted.length - 1]!.pressure);
  const { bounds, columns, rows } = envelope;
  let [compared, different] = [0, 0];
  for (let j = 0; j < rows; j += 5) {
    for (let i = 0; i < columns; i += 23) {
      const u = bounds.u0 + ((i + 0.5) / columns) * (bounds.u1 - bounds.u0);
      const v = bounds.v0 + ((j + 0.5) / rows) * (bounds.v1 - bounds.v0);
      const expected = cellAt(sorted, u, v)?.pressure ?? 0;
      if (expected === 0) continue;
      compared++;
      if (envelope.at(u, v) !== Math.fround(expected)) different++;
    }
  }
  expect(compared).toBeGreaterThan(300);
  expect(different).toBe(0);
  const included = (tooth: number, side: "left" | "right") => all.some((cell) => isIncluded(cell, { tooth, side }));
  expect([included(0, "right"), included(0, "left"), included(5, "right")]).toEqual([true, false, false]);
});

test("ticks are round numbers", () => {
  const ticks = roundTicks(-15.9, 15.9, 6).map((t) => Number(t.toPrecision(6)));
  expect(ticks).toEqual([-10, 0, 10]);
  expect(roundTicks(0.101, 0.139, 4).map((t) => Number(t.toPrecision(6)))).toEqual([0.11, 0.12, 0.13]);
});

const LEGEND = /Legend: Contact pressure from 0 to ([\d.]+) MPa/;

test("pressures of flanks and edges are chosen separately", async ({ page }) => {
  const problems = await open(page);
  await page.getByLabel("Colours").selectOption("contact_pressure");
  const { pressures, zones } = contactCells(0);
  const choice = page.getByRole("toolbar").getByLabel("Contact cells");
  for (const [name, note, wanted] of [
    ["all", "edges included", () => true],
    ["flanks", "flanks only", (i: number) => zones[i] === 0],
    ["edges", "edges only", (i: number) => zones[i] === 1],
  ] as const) {
    await choice.selectOption(name);
    const largest = Math.max(...pressures.filter((_, i) => wanted(i))) / 1e6;
    const legend = page.getByRole("button", { name: /Legend/ });
    await expect(legend).toContainText(note);
    const shown = Number(LEGEND.exec((await legend.getAttribute("aria-label"))!)![1]);
    expect(Math.abs(shown / largest - 1)).toBeLessThan(6e-4);
    await expect(page.locator(".cv-label-maximum")).toContainText(String(shown));
    expect((await state(page)).colours.cells).toBe(name);
  }
  expect(problems).toEqual([]);
});

test("the stress error has a legend, an explanation and the value of the file at the pointer", async ({ page }) => {
  await open(page);
  await page.getByLabel("Colours").selectOption("stress_error");
  const legend = page.getByRole("button", { name: /Legend: Stress error from 5 to 35 MPa/ });
  await expect(legend).toContainText("estimated, as von Mises stress");
  await legend.click();
  await expect(page.getByRole("complementary", { name: "Settings" })).toContainText("Zienkiewicz and Zhu");
  const { points } = gearSector(PINION, 4, 6, 4);
  const node = points.findIndex((_, i) => i % 3 === 0 && points[i + 2]! > 14.9e-3 && Math.abs(points[i]! - 25e-3) < 4e-3 && Math.abs(points[i + 1]!) < 1e-3) / 3;
  const expected = Math.fround(stressError(Math.fround(points[3 * node + 2]!)));
  const value = await page.evaluate((n) => window.calyxViewer!.nodalValue("pinion", n), node);
  expect(Math.abs(value / expected - 1)).toBeLessThan(1e-6);
});

test("automatic limits of the stress error leave out outliers, and the legend states them", async ({ page }) => {
  await openWith(page, "outlier", { outlier: true });
  await page.getByLabel("Colours").selectOption("stress_error");
  const legend = page.getByRole("button", { name: /Legend: Stress error from 5 to 35 MPa/ });
  await expect(legend).toContainText(/0\.\d+ % of the nodes are above, up to 1000 MPa/);
  // The mark is that of the largest value.
  await expect(page.locator(".cv-label-maximum")).toContainText("max 1000 MPa");
  await expect(page.locator(".cv-label-minimum")).toHaveCount(0);
  await restore(page, { colours: { field: "min_principal" } });
  await expect(page.locator(".cv-label-minimum")).toContainText("min");
  await expect(page.locator(".cv-label-maximum")).toHaveCount(0);
});

/** Moves the pointer to a point of the flank's picture in the panel, given as z and radius. */
async function pointAt(page: Page, z: number, r: number): Promise<void> {
  const canvas = page.getByRole("region", { name: "Contact pattern" }).getByRole("img");
  const box = (await canvas.boundingBox())!;
  const part = partOf(gearSector(PINION), PINION.teeth);
  const bounds = boundsOf(part, "right", new PatternAxes(0));
  const { PatternLayout } = await import("../src/viewer/pattern_drawing.ts");
  const layout = new PatternLayout(box.width, box.height, { bounds } as never);
  await page.mouse.move(box.x + layout.x(z) - 1, box.y + layout.y(r));
  await page.mouse.move(box.x + layout.x(z), box.y + layout.y(r));
}

test("the contact pattern shows the cells, their values and the marked cell", async ({ page }) => {
  const problems = await open(page);
  await restore(page, { colours: { field: "contact_pressure" } });
  await page.keyboard.press("u");
  const panel = page.getByRole("region", { name: "Contact pattern" });
  await expect(panel.getByRole("img", { name: "Contact pattern of pinion, all teeth, right flank, position 0" })).toBeVisible();
  const cells = contactCells(0);
  const largest = cells.pressures.indexOf(Math.max(...cells.pressures));
  const corner = (k: number) => cells.corners.slice(12 * largest + 3 * k, 12 * largest + 3 * k + 3) as [number, number, number];
  const [a, b] = [corner(0), corner(2)];
  const z = (a[2] + b[2]) / 2;
  const r = (Math.hypot(a[0], a[1]) + Math.hypot(b[0], b[1])) / 2;
  await settle(page);
  const frames = () => page.evaluate(() => window.calyxViewer!.frames);
  const drawn = await frames();
  await pointAt(page, z, r);
  const reading = page.getByRole("status", { name: "Value in the pattern" });
  await expect(reading).toContainText("tooth");
  const value = Number(await reading.getAttribute("data-value"));
  // The cell is marked in the scene.
  await expect.poll(frames).toBeGreaterThan(drawn);
  // The rows are a pixel high: the reading is that of the largest cell or of a neighbour.
  expect(value / cells.pressures[largest]!).toBeGreaterThan(0.95);
  const shown = /z (\S+) mm, radius (\S+) mm/.exec((await reading.textContent())!)!;
  expect(Math.abs(Number(shown[1]!.replace("−", "-")) - z * 1e3)).toBeLessThan(0.05);
  expect(Math.abs(Number(shown[2]) - r * 1e3)).toBeLessThan(0.05);
  // Pointing at a cell of the scene marks it in the pattern.
  const marked = () => panel.getByRole("img").evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL().length);
  await page.mouse.move(5, 5);
  await settle(page);
  const before = await marked();
  const centre = await project(page, "pinion", [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, z]);
  await page.mouse.move(centre.x - 1, centre.y);
  await page.mouse.move(centre.x, centre.y);
  await expect(page.getByRole("status", { name: "Value at the pointer" })).toBeVisible();
  await expect.poll(marked).not.toBe(before);
  expect(problems).toEqual([]);
});

test("the envelope reads all positions, and the pattern is exported as vectors", { tag: "@slow" }, async ({ page }) => {
  await open(page, writePage("pattern", embeddedData(createFixture({ positions: 8, meshes: false }))));
  await restore(page, { panels: { pattern: true }, colours: { field: "contact_pressure", limits: "all" } });
  const panel = page.getByRole("region", { name: "Contact pattern" });
  await panel.getByLabel("Positions of the pattern").selectOption("all");
  await expect(panel.getByRole("img", { name: /maximum over 8 positions/ })).toBeVisible();
  const largest = Math.max(...Array.from({ length: 8 }, (_, i) => Math.max(...contactCells((0.3 * i) / 8).pressures)));
  await expect(page.getByRole("button", { name: /Legend/ })).toContainText("all positions");
  const svg = await page.evaluate(async () => (await window.calyxViewer!.patternImage("svg")).text());
  expect(svg).toContain("Contact pattern of pinion, all teeth, right flank, maximum over 8 positions");
  expect(svg).not.toContain("<image");
  expect(svg.match(/<path /g)!.length).toBeGreaterThan(100);
  const legend = (await page.getByRole("button", { name: /Legend/ }).getAttribute("aria-label"))!;
  expect(Math.abs(Number(LEGEND.exec(legend)![1]) / (largest / 1e6) - 1)).toBeLessThan(6e-4);
  await panel.getByLabel("Gear").selectOption("wheel");
  await expect(panel.getByRole("img", { name: /pattern of wheel/ })).toBeVisible();
  expect((await state(page)).pattern).toMatchObject({ gear: "wheel", envelope: true });
  for (const [format, head] of [["png", "\x89PNG"], ["pdf", "%PDF-1.4"]] as const) {
    const start = await page.evaluate(async (f) => [...new Uint8Array(await (await window.calyxViewer!.patternImage(f)).arrayBuffer()).slice(0, 8)], format);
    expect(String.fromCharCode(...start).startsWith(head)).toBe(true);
  }
});

test("a mark behind a surface is dashed, in front of it not", { tag: "@slow" }, async ({ page }) => {
  await open(page);
  await restore(page, { colours: { field: "stress_error" }, deformation: { mode: "factor", factor: 0 }, parts: { wheel: "hidden", "bearing A": "hidden", "bearing B": "hidden" } });
  const camera = (await state(page)).camera!;
  const mark = page.locator(".cv-label-maximum");
  // The largest stress error of the fixture is on the upper face of the pinion.
  await restore(page, { camera: { ...camera, fitted: false, azimuth: -10, elevation: 60 } });
  await expect(mark).not.toHaveClass(/cv-label-hidden/);
  await restore(page, { camera: { ...camera, fitted: false, azimuth: 170, elevation: -30 } });
  await expect(mark).toHaveClass(/cv-label-hidden/);
});

test("a viewer of medium width has all tools, and panels above the scene", async ({ page }) => {
  await page.setViewportSize({ width: 800, height: 600 });
  await open(page, pageAddress);
  await restore(page, { colours: { field: "contact_pressure" }, panels: { parts: true, settings: true, pattern: true } });
  const canvas = page.getByRole("img", { name: /Three-dimensional view/ });
  for (const name of ["Parts", "Settings"]) await expect(page.getByRole("complementary", { name })).toHaveCount(0);
  expect((await canvas.boundingBox())!.width).toBe(800);
  await page.getByRole("button", { name: "Settings", exact: true }).click();
  await expect(page.getByRole("complementary", { name: "Settings" })).toBeVisible();
  expect((await canvas.boundingBox())!.width).toBe(800);
  await expect(page.getByRole("button", { name: "Force vectors" })).toBeVisible();
  await page.setViewportSize({ width: 1000, height: 600 });
  for (const name of ["Parts", "Settings"]) await expect(page.getByRole("complementary", { name })).toBeVisible();
});

test("narrow viewers have drawers, and nothing is cut off", { tag: "@slow" }, async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 520 });
  const problems = await open(page, pageAddress);
  await restore(page, { colours: { field: "contact_pressure" } });
  const inside = async () => {
    const outside = await page.evaluate(() =>
      [...document.querySelectorAll(".cv-toolbar > *, .cv-tools > *, .cv-timeline > *, .cv-legend, .cv-panel, .cv-pattern-head > *, .cv-tooltip")]
        .map((element) => ({ name: element.className || element.tagName, box: element.getBoundingClientRect() }))
        .filter(({ box }) => box.width > 0 && (box.left < -0.5 || box.right > innerWidth + 0.5 || box.bottom > innerHeight + 0.5))
        .map(({ name }) => name));
    expect(outside).toEqual([]);
  };
  // The panel of parts is open in the state, but there is no room for it.
  await expect(page.getByRole("complementary", { name: "Parts" })).toHaveCount(0);
  await inside();
  await page.getByRole("button", { name: "More tools" }).click();
  const tools = page.getByRole("group", { name: "More tools" });
  for (const name of ["Fit", "Mesh edges", "Plots", "Contact pattern", "Help"]) await expect(tools.getByRole("button", { name })).toBeVisible();
  await expect(tools.getByLabel("Contact cells")).toBeVisible();
  await inside();
  await tools.getByRole("button", { name: "Contact pattern" }).click();
  await page.keyboard.press("Escape");
  await expect(tools).toHaveCount(0);
  await expect(page.getByRole("region", { name: "Contact pattern" }).getByRole("img")).toBeVisible();
  await inside();
  await page.getByRole("button", { name: "Parts" }).click();
  await expect(page.getByRole("complementary", { name: "Parts" })).toBeVisible();
  await page.keyboard.press("s");
  await expect(page.getByRole("complementary", { name: "Parts" })).toHaveCount(0);
  await expect(page.getByRole("complementary", { name: "Settings" })).toBeVisible();
  await inside();
  await page.setViewportSize({ width: 1000, height: 520 });
  await expect(page.getByRole("complementary", { name: "Parts" })).toBeVisible();
  expect(problems).toEqual([]);
});
