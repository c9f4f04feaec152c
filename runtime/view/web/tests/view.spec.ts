// Display of a run in a browser.

import { expect, test } from "@playwright/test";
import { contactLoad, displacement, uniaxialStress } from "./fixture.ts";
import { button, fixture, open, pixel, project, restore, savedFile, settle, state } from "./page.ts";

test("opens from a file and shows the parts", async ({ page }) => {
  const problems = await open(page);
  await expect(page.getByRole("heading", { name: "Spur pair" })).toBeVisible();
  for (const name of ["pinion", "wheel", "input shaft", "bearing D"]) {
    await expect(page.getByRole("complementary", { name: "Parts" }).getByTitle(name, { exact: true })).toBeVisible();
  }
  await expect(page).toHaveScreenshot("opened.png");
  expect(problems).toEqual([]);
});

test("a camera that nobody has moved is stored as fitted, and fits a window of another shape", async ({ page }) => {
  await open(page);
  const stored = (await state(page)).camera!;
  expect(stored.fitted).toBe(true);
  await page.setViewportSize({ width: 500, height: 900 });
  await settle(page);
  await restore(page, { camera: { ...stored, height: 0.01, fitted: false } });
  await restore(page, { camera: stored });
  const restored = (await state(page)).camera!;
  expect(restored.fitted).toBe(true);
  expect(restored.height).not.toBeCloseTo(stored.height, 3);
  // The same picture as a new fit.
  await page.keyboard.press("f");
  await page.waitForTimeout(600);
  expect((await state(page)).camera!.height).toBeCloseTo(restored.height, 6);
});

test("draws no frames while nothing changes", async ({ page }) => {
  await open(page);
  await page.waitForTimeout(500);
  const before = await page.evaluate(() => window.calyxViewer!.frames);
  await page.waitForTimeout(1000);
  expect(await page.evaluate(() => window.calyxViewer!.frames)).toBe(before);
});

test("hides a body", async ({ page }) => {
  await open(page);
  await restore(page, { extremes: false, colours: { field: "plain" } });
  await settle(page);
  const point = await project(page, "output shaft", [0, 0, 65e-3]);
  const before = await pixel(page, point.x, point.y);
  await button(page, "output shaft: visible").click();
  await button(page, "output shaft: translucent").click();
  expect((await state(page)).parts).toEqual({ "output shaft": "hidden" });
  await button(page, "bearing D: visible").click({ modifiers: ["Alt"] });
  await button(page, "wheel: visible").click({ modifiers: ["Alt"] });
  await settle(page);
  const after = await pixel(page, point.x, point.y);
  expect(Math.hypot(...before.map((v, i) => v - after[i]!))).toBeGreaterThan(20);
  await button(page, "Gears: mixed").click();
  expect((await state(page)).parts).toMatchObject({ wheel: "visible" });
  await button(page, "Gears: visible").click();
  expect((await state(page)).parts).toMatchObject({ pinion: "translucent", wheel: "translucent" });
});

test("colours by each field with a legend", async ({ page }) => {
  const problems = await open(page);
  const colours = page.getByLabel("Colours");
  for (const [field, label, unit] of [
    ["contact_pressure", "Contact pressure", "MPa"],
    ["max_principal", "Maximum principal stress", "MPa"],
    ["min_principal", "Minimum principal stress", "MPa"],
    ["von_mises", "Von Mises stress", "MPa"],
    ["displacement", "Displacement", "µm"],
  ] as const) {
    await colours.selectOption(field);
    await expect(page.getByRole("button", { name: new RegExp(`Legend: ${label} .* ${unit}`) })).toBeVisible();
  }
  await colours.selectOption("plain");
  await expect(page.getByRole("button", { name: /Legend/ })).toHaveCount(0);
  expect(problems).toEqual([]);
});

test("limits over all positions, fixed limits and bands", { tag: "@slow" }, async ({ page }) => {
  await open(page);
  await button(page, "Settings").click();
  const settings = page.getByRole("complementary", { name: "Settings" });
  await settings.getByLabel("Limits").selectOption("all");
  await expect(page.getByRole("button", { name: /Legend/ })).toContainText("all positions");
  await settings.getByLabel("Maximum").fill("200");
  await settings.getByLabel("Maximum").press("Enter");
  await expect(page.getByRole("button", { name: /Legend: .* to 200 MPa/ })).toBeVisible();
  expect((await state(page)).colours).toMatchObject({ limits: "fixed", max: 2e8 });
  await settings.getByLabel("Bands").selectOption("8");
  await settle(page);
  await expect(page.getByRole("button", { name: /Legend/ })).toContainText("175");
});

test("the value at the pointer is the file's value", async ({ page }) => {
  await open(page);
  await restore(page, { parts: { wheel: "hidden", "bearing B": "hidden", "input shaft": "hidden" }, deformation: { mode: "factor", factor: 0 } });
  await page.evaluate(() => window.calyxViewer!.restore({ camera: { ...window.calyxViewer!.state.camera!, target: [0.03, 0, 0.015], azimuth: -40, elevation: 50, height: 0.04 } }));
  await settle(page);
  const points = fixture.meshPoints;
  let checked = 0;
  // Nodes inside of the upper face; those at its border may be a pixel outside.
  for (let node = 0; node < points.length / 3 && checked < 6; node++) {
    const p = [points[3 * node]!, points[3 * node + 1]!, points[3 * node + 2]!] as [number, number, number];
    if (p[2] < 14.9e-3 || p[0] < 22e-3 || p[0] > 32e-3 || Math.abs(p[1]) > 0.09 * p[0]) continue;
    const { x, y } = await project(page, "pinion", p);
    await page.mouse.move(x, y);
    const tooltip = page.getByRole("status", { name: "Value at the pointer" });
    await expect(tooltip).toContainText(`node ${node}`);
    await expect(tooltip).toContainText("pinion, tooth 0");
    const expected = Math.abs(Math.fround(uniaxialStress(...p)));
    const shown = Number(await tooltip.getAttribute("data-value"));
    expect(Math.abs(shown - expected)).toBeLessThanOrEqual(1e-15 * expected);
    expect(await page.evaluate((n) => window.calyxViewer!.nodalValue("pinion", n), node)).toBe(shown);
    checked++;
  }
  expect(checked).toBeGreaterThan(3);
  await page.getByLabel("Colours").selectOption("displacement");
  const u = displacement(points[0]!, points[1]!, points[2]!).map(Math.fround) as [number, number, number];
  expect(await page.evaluate(() => window.calyxViewer!.nodalValue("pinion", 0))).toBe(Math.hypot(...u));
});

test("the cutting plane removes and caps", async ({ page }) => {
  await open(page);
  await restore(page, { colours: { field: "plain" }, parts: { "bearing A": "hidden", "bearing B": "hidden" } });
  await button(page, "Cutting plane").click();
  const settings = page.getByRole("complementary", { name: "Settings" });
  await expect(settings.getByLabel("Cut", { exact: true })).toBeChecked();
  await settings.getByLabel("Coordinate").fill("0");
  await settings.getByLabel("Coordinate").press("Enter");
  await restore(page, { panels: { settings: false } });
  await page.mouse.move(0, 0);
  await settle(page);
  await expect(page).toHaveScreenshot("cut.png");
  // The shaft is solid: its section has a colour like the shaft's, not the background's.
  const centre = await project(page, "input shaft", [0, 0, 0]);
  const [r, g, b] = await pixel(page, centre.x, centre.y) as [number, number, number];
  expect(Math.max(r, g, b)).toBeLessThan(200);
  // The pointer reads the point of the section, not one of the surface behind it.
  await page.mouse.move(centre.x, centre.y);
  const reading = page.getByRole("status", { name: "Value at the pointer" });
  await expect(reading).toContainText("input shaft");
  await expect(reading).toContainText(/ -?0(\.0+)? mm$/);
  await page.mouse.move(0, 0);
  // The handle moves the plane.
  const before = (await state(page)).cut.offset!;
  await page.keyboard.press("]");
  expect((await state(page)).cut.offset!).toBeGreaterThan(before);
});

test("the animation plays, pauses, steps and displays the time", async ({ page }) => {
  const problems = await open(page);
  await button(page, "Next position").click();
  await expect.poll(async () => (await state(page)).position).toBe(1);
  await expect(page.getByRole("group", { name: "Animation" })).toContainText("0.5 ms");
  await button(page, "Play").click();
  await expect(button(page, "Pause")).toBeVisible();
  const seen = new Set<number>();
  await expect.poll(async () => seen.add((await state(page)).position).size).toBe(3);
  await button(page, "Pause").click();
  await page.getByLabel("Position", { exact: true }).fill("2");
  await expect.poll(async () => (await state(page)).position).toBe(2);
  expect(problems).toEqual([]);
});

test("a part stands still in its own frame", { tag: "@slow" }, async ({ page }) => {
  await open(page);
  const tooth: [number, number, number] = [34e-3, 0, 15e-3];
  const move = async () => {
    await restore(page, { position: 0 });
    await settle(page);
    const first = await project(page, "pinion", tooth);
    await restore(page, { position: 2 });
    await expect.poll(async () => (await state(page)).position).toBe(2);
    await settle(page);
    await page.waitForTimeout(300);
    const last = await project(page, "pinion", tooth);
    return Math.hypot(first.x - last.x, first.y - last.y);
  };
  expect(await move()).toBeGreaterThan(5);
  await page.getByLabel("Fixed frame").selectOption("pinion");
  expect(await move()).toBeLessThan(0.01);
});

test("the factor of the deformation is displayed", async ({ page }) => {
  await open(page);
  await restore(page, { panels: { settings: true }, deformation: { mode: "factor", factor: 100 } });
  await expect(page.getByText(/These parts move: .*pinion.*The other parts stay in place/)).toBeVisible();
  await restore(page, { panels: { settings: false }, deformation: { mode: "automatic" } });
  const factor = page.getByLabel("Factor of the deformation");
  await expect(factor).toHaveText(/× \d+/);
  await page.getByLabel("Deformation", { exact: true }).selectOption("1");
  await expect(factor).toHaveText("× 1");
  await page.getByLabel("Deformation", { exact: true }).selectOption("0");
  await expect(factor).toHaveText("× 0");
});

test("light and dark theme", async ({ page, browserName }) => {
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await open(page);
  // Playwright cannot emulate the scheme of the system in Firefox.
  if (browserName === "firefox") await button(page, "Dark theme").click();
  await expect(page.locator(".calyx-viewer")).toHaveAttribute("data-theme", "dark");
  await page.waitForTimeout(300);
  await expect(page).toHaveScreenshot("dark.png");
  await button(page, "Light theme").click();
  await expect(page.locator(".calyx-viewer")).toHaveAttribute("data-theme", "light");
});

test("plots an output with a cursor at the position", async ({ page }) => {
  const problems = await open(page);
  await button(page, "Plots").click();
  const plots = page.getByRole("region", { name: "Plots" });
  await expect(plots.getByRole("img", { name: /transmission error over time/ })).toBeVisible();
  await plots.getByLabel("Output").selectOption("max_contact_pressure");
  await expect(plots).toContainText("900 MPa");
  expect(problems).toEqual([]);
});

test("exports PNG, SVG and PDF", { tag: "@slow" }, async ({ page }) => {
  await open(page);
  const heads: Record<string, string> = { png: "\x89PNG", svg: "<svg xmlns", pdf: "%PDF-1.4" };
  for (const [format, head] of Object.entries(heads)) {
    const { name, bytes } = await savedFile(page, () => page.getByLabel("Export the picture").selectOption(format));
    expect(name).toBe(`Spur_pair.${format}`);
    expect(bytes.subarray(0, head.length).toString("latin1")).toBe(head);
    expect(bytes.length).toBeGreaterThan(20_000);
    if (format === "svg") expect(bytes.toString()).toContain("Von Mises stress");
  }
});

test("the pressure of the displayed cells integrates to the load", async ({ page }) => {
  await open(page);
  const loads = await page.evaluate(() => window.calyxViewer!.contactLoads());
  expect(loads.map(({ parts }) => parts)).toEqual([["pinion", "wheel"]]);
  // The fixture's cells are known: the sum over their centres is the exact integral of constant pressures.
  expect(loads[0]!.load).toBeGreaterThan(1000);
  expect(loads[0]!.load / contactLoad(0)).toBeGreaterThan(0.99);
  expect(loads[0]!.load / contactLoad(0)).toBeLessThan(1.01);
});

test("a run that is still being written grows, and a reload keeps the state", async ({ page }) => {
  const problems = await open(page);
  await restore(page, { parts: { wheel: "hidden" }, theme: "dark" });
  await page.evaluate(async () => {
    const data = JSON.parse(document.getElementById("calyx-view")!.textContent!);
    const read = async (text: string) => {
      const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
      return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
    };
    const run = { written: 0 };
    (window as unknown as { run: typeof run }).run = run;
    await window.calyxViewer!.show({
      title: "Growing run",
      parts: () => read(data.parts),
      positions: async () => data.positions.slice(0, run.written),
      position: (index) => read(data.positions[index].data),
      mesh: (name) => read(data.meshes[name]),
    });
  });
  await expect(page.getByText("No positions yet")).toBeVisible();
  const write = (count: number) =>
    page.evaluate(async (n) => {
      (window as unknown as { run: { written: number } }).run.written = n;
      await window.calyxViewer!.updatePositions();
    }, count);
  await write(1);
  const slider = page.getByLabel("Position", { exact: true });
  await expect(slider).toHaveAttribute("max", "0");
  await write(3);
  await expect(slider).toHaveAttribute("max", "2");
  await slider.fill("2");
  await page.evaluate(() => window.calyxViewer!.reload());
  const { parts, theme, position } = await state(page);
  expect([parts, theme, position]).toEqual([{ wheel: "hidden" }, "dark", 2]);
  expect(problems).toEqual([]);
});
