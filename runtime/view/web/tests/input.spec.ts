// Pointer, keyboard, accessibility and linked cameras.

import AxeBuilder from "@axe-core/playwright";
import { expect, test } from "@playwright/test";
import type { Viewer } from "../src/viewer/index.ts";
import { centreOfColour, open, project, restore, settle, state } from "./page.ts";

test("the handle of the cutting plane can be dragged, also of a plane along the view", async ({ page }) => {
  await open(page);
  await restore(page, { cut: { on: true, normal: "x" }, panels: { settings: true } });
  await page.getByRole("img", { name: /Three-dimensional/ }).focus();
  await page.keyboard.press("-");
  await page.keyboard.press("-");
  await settle(page);
  const before = (await state(page)).cut.offset ?? 0;
  const handle = await centreOfColour(page, [0xe0, 0x7b, 0x1f]);
  await page.mouse.move(handle.x, handle.y);
  await expect(page.locator("canvas[role=img]")).toHaveAttribute("data-handle", "true");
  await page.mouse.down();
  await page.mouse.move(handle.x + 60, handle.y, { steps: 4 });
  await page.mouse.up();
  expect((await state(page)).cut.offset!).toBeGreaterThan(before + 5e-3);
  const camera = (await state(page)).camera;
  await page.getByRole("complementary", { name: "Settings" }).getByLabel("Normal").selectOption("view");
  const { normal } = (await state(page)).cut;
  expect(Math.hypot(...(normal as [number, number, number]))).toBeCloseTo(1, 6);
  expect((await state(page)).camera).toEqual(camera);
});

test("orbit, pan and zoom with the pointer", { tag: "@slow" }, async ({ page }) => {
  await open(page);
  const { x, y } = await project(page, "wheel", [0, 0, 0]);
  const first = (await state(page)).camera!;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 50, y + 20, { steps: 3 });
  await page.mouse.up();
  const orbited = (await state(page)).camera!;
  expect([orbited.azimuth < first.azimuth, orbited.elevation > first.elevation]).toEqual([true, true]);
  await page.mouse.down({ button: "right" });
  await page.mouse.move(x + 80, y, { steps: 3 });
  await page.mouse.up({ button: "right" });
  const panned = (await state(page)).camera!;
  expect(panned.target).not.toEqual(orbited.target);
  // The point under the pointer keeps its place while zooming, nearly so in perspective.
  const before = await project(page, "wheel", [0, 0, 14e-3]);
  await page.mouse.move(before.x, before.y);
  await page.mouse.wheel(0, -300);
  await expect.poll(async () => (await state(page)).camera!.height).toBeLessThan(panned.height);
  await settle(page);
  const after = await project(page, "wheel", [0, 0, 14e-3]);
  expect(Math.hypot(after.x - before.x, after.y - before.y)).toBeLessThan(12);
});

test("everything works with the keyboard alone", async ({ page }) => {
  await open(page);
  const reached = new Set<string>();
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press("Tab");
    const name = await page.evaluate(() => {
      const element = document.activeElement!;
      if (!element.matches(":focus-visible")) return "";
      return element.getAttribute("aria-label") ?? element.closest("label")?.textContent ?? element.textContent ?? "";
    });
    reached.add(name.slice(0, 40));
  }
  for (const name of ["Fit", "Mesh edges", "Cutting plane", "pinion: visible", "Play", "Loop", "Position", "Dark theme"]) {
    expect([...reached]).toContain(name);
  }
  expect([...reached].some((name) => name.startsWith("Three-dimensional view"))).toBe(true);
  const camera = (await state(page)).camera!;
  await page.getByRole("img", { name: /Three-dimensional/ }).focus();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("+");
  const moved = (await state(page)).camera!;
  expect(moved.azimuth).not.toBe(camera.azimuth);
  expect(moved.height).toBeLessThan(camera.height);
  await page.keyboard.press("1");
  expect((await state(page)).camera).toMatchObject({ azimuth: -90, elevation: 0 });
  await page.keyboard.press("p");
  await page.keyboard.press("m");
  await page.keyboard.press("v");
  await page.keyboard.press("c");
  const all = await state(page);
  expect(all.camera!.projection).toBe("orthographic");
  expect([all.mesh_edges, all.forces.meshes, all.cut.on]).toEqual([true, true, true]);
  await page.keyboard.press("?");
  await expect(page.getByRole("dialog", { name: "Shortcuts" })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog")).toHaveCount(0);
});

test("two viewers with linked cameras", { tag: "@slow" }, async ({ page }) => {
  const problems = await open(page);
  await page.evaluate(async () => {
    const first = window.calyxViewer!;
    const holder = document.createElement("div");
    holder.id = "second";
    holder.style.height = "400px";
    document.body.append(holder);
    const Viewer = first.constructor as new (container: HTMLElement) => NonNullable<typeof window.calyxViewer>;
    const second = new Viewer(holder);
    const data = JSON.parse(document.getElementById("calyx-view")!.textContent!);
    const read = async (text: string) => {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
    };
    await second.show({
      title: "Second run",
      parts: () => read(data.parts),
      positions: async () => data.positions,
      position: (index) => read(data.positions[index].data),
      mesh: (name) => read(data.meshes[name]),
    });
    first.linkCamera(second);
    (window as unknown as { second: typeof second }).second = second;
  });
  const cameras = () =>
    page.evaluate(() => [window.calyxViewer!.state.camera, (window as unknown as { second: Viewer }).second.state.camera]);
  await page.evaluate(() => window.calyxViewer!.restore({ camera: { ...window.calyxViewer!.state.camera!, azimuth: 12 } }));
  await page.getByRole("img", { name: /Three-dimensional/ }).first().focus();
  await page.keyboard.press("ArrowLeft");
  let [first, second] = await cameras();
  expect(second).toEqual(first);
  await page.locator("#second canvas[role=img]").focus();
  await page.keyboard.press("ArrowUp");
  [first, second] = await cameras();
  expect(first).toEqual(second);
  await page.evaluate(() => (window as unknown as { second: Viewer }).second.dispose());
  await page.keyboard.press("f");
  expect(problems).toEqual([]);
});

test("axe-core finds nothing serious", async ({ page }) => {
  await open(page);
  await restore(page, { panels: { settings: true, plots: true, pattern: true }, colours: { field: "contact_pressure" }, cut: { on: true }, forces: { bearings: true, meshes: true } });
  await page.waitForTimeout(500);
  for (const theme of ["light", "dark"]) {
    await restore(page, { theme });
    await settle(page);
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.filter(({ impact }) => impact === "serious" || impact === "critical").map(({ id, nodes }) => [id, nodes.map((n) => n.html)])).toEqual([]);
  }
  await page.keyboard.press("?");
  const serious = async () => (await new AxeBuilder({ page }).analyze()).violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  expect(await serious()).toEqual([]);
  await page.keyboard.press("Escape");
  await page.setViewportSize({ width: 400, height: 700 });
  await page.getByRole("button", { name: "More tools" }).click();
  expect(await serious()).toEqual([]);
});
