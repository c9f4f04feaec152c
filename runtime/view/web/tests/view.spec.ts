// The view in a browser.

import AxeBuilder from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import type { Viewer } from "../src/viewer/index.ts";
import { contactLoad, createFixture, displacement, embeddedData, uniaxialStress, writePage, type FixtureOptions } from "./fixture.ts";


const fixture = createFixture();
const pageAddress = writePage("spur_pair", embeddedData(fixture));

async function open(page: Page, address = pageAddress): Promise<string[]> {
  const problems: string[] = [];
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" || (message.type() === "warning" && !/GPU stall|GL Driver/.test(message.text()))) problems.push(message.text());
  });
  await page.goto(address);
  await page.getByRole("img", { name: /Three-dimensional view/ }).waitFor();
  await expect(page.getByRole("group", { name: "Animation" }).or(page.getByText("No positions yet"))).toBeVisible();
  return problems;
}

const openWith = (page: Page, name: string, options: FixtureOptions) => open(page, writePage(name, embeddedData(createFixture(options))));
const state = (page: Page) => page.evaluate(() => window.calyxViewer!.state);
const restore = (page: Page, patch: object) => page.evaluate((s) => window.calyxViewer!.restore(s), patch);
const button = (page: Page, name: string | RegExp) => page.getByRole("button", { name, exact: typeof name === "string" });

/** Waits until two frames have passed, so that changes are displayed. */
const settle = (page: Page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Colour of the scene at a pixel of the page, from a screenshot without labels. */
async function pixel(page: Page, x: number, y: number): Promise<number[]> {
  const png = await page.screenshot({ clip: { x: Math.round(x) - 1, y: Math.round(y) - 1, width: 3, height: 3 } });
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 3;
    const context = canvas.getContext("2d")!;
    context.drawImage(image, 0, 0);
    return [...context.getImageData(1, 1, 1, 1).data].slice(0, 3);
  }, png.toString("base64"));
}

/** Middle of the pixels of a colour. */
async function centreOfColour(page: Page, colour: [number, number, number]): Promise<{ x: number; y: number }> {
  const png = await page.screenshot();
  return page.evaluate(
    async ([data, [r, g, b]]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${data}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext("2d")!;
      context.drawImage(image, 0, 0);
      const pixels = context.getImageData(0, 0, image.width, image.height).data;
      let [x, y, n] = [0, 0, 0];
      for (let i = 0; i < pixels.length; i += 4) {
        if (Math.hypot(pixels[i]! - r, pixels[i + 1]! - g, pixels[i + 2]! - b) > 3) continue;
        x += (i / 4) % image.width;
        y += Math.floor(i / 4 / image.width);
        n++;
      }
      return { x: x / n, y: y / n };
    },
    [png.toString("base64"), colour] as const,
  );
}

const project = async (page: Page, part: string, point: [number, number, number]) =>
  (await page.evaluate(([p, q]) => window.calyxViewer!.project(p, q), [part, point] as const))!;

test("opens from a file and shows the parts", async ({ page }) => {
  const problems = await open(page);
  await expect(page.getByRole("heading", { name: "Spur pair" })).toBeVisible();
  for (const name of ["pinion", "wheel", "input shaft", "bearing D"]) {
    await expect(page.getByRole("complementary", { name: "Parts" }).getByTitle(name, { exact: true })).toBeVisible();
  }
  await expect(page).toHaveScreenshot("opened.png");
  expect(problems).toEqual([]);
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
  await button(page, "Gears: translucent").click();
  expect((await state(page)).parts).toMatchObject({ pinion: "hidden", wheel: "hidden" });
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

test("limits over all positions, fixed limits and bands", async ({ page }) => {
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
  // The handle moves the plane.
  const before = (await state(page)).cut.offset!;
  await page.keyboard.press("]");
  expect((await state(page)).cut.offset!).toBeGreaterThan(before);
});

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

test("orbit, pan and zoom with the pointer", async ({ page }) => {
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

test("a part stands still in its own frame", async ({ page }) => {
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
  const factor = page.getByLabel("Factor of the deformation");
  await expect(factor).toHaveText(/× \d+/);
  await page.getByLabel("Deformation", { exact: true }).selectOption("1");
  await expect(factor).toHaveText("× 1");
  await page.getByLabel("Deformation", { exact: true }).selectOption("0");
  await expect(factor).toHaveText("× 0");
});

test("light and dark theme", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await open(page);
  await expect(page.locator(".calyx-viewer")).toHaveAttribute("data-theme", "dark");
  await page.waitForTimeout(300);
  await expect(page).toHaveScreenshot("dark.png");
  await button(page, "Light theme").click();
  await expect(page.locator(".calyx-viewer")).toHaveAttribute("data-theme", "light");
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

test("plots an output with a cursor at the position", async ({ page }) => {
  const problems = await open(page);
  await button(page, "Plots").click();
  const plots = page.getByRole("region", { name: "Plots" });
  await expect(plots.getByRole("img", { name: /transmission error over time/ })).toBeVisible();
  await plots.getByLabel("Output").selectOption("max_contact_pressure");
  await expect(plots).toContainText("900 MPa");
  expect(problems).toEqual([]);
});

test("exports PNG, SVG and PDF", async ({ page }) => {
  await open(page);
  const heads: Record<string, string> = { png: "\x89PNG", svg: "<svg xmlns", pdf: "%PDF-1.4" };
  for (const [format, head] of Object.entries(heads)) {
    const download = page.waitForEvent("download");
    await page.getByLabel("Export the picture").selectOption(format);
    const file = await download;
    expect(file.suggestedFilename()).toBe(`Spur_pair.${format}`);
    const chunks: Buffer[] = [];
    for await (const chunk of await file.createReadStream()) chunks.push(chunk as Buffer);
    const bytes = Buffer.concat(chunks);
    expect(bytes.subarray(0, head.length).toString("latin1")).toBe(head);
    expect(bytes.length).toBeGreaterThan(20_000);
    if (format === "svg") expect(bytes.toString()).toContain("Von Mises stress");
  }
});

test("a truncated file of a position is named; the rest works", async ({ page }) => {
  const data = embeddedData(createFixture());
  const damaged = createFixture();
  damaged.positions[1]!.data = damaged.positions[1]!.data.slice(0, 2000);
  data.positions[1] = embeddedData(damaged).positions[1]!;
  await open(page, writePage("truncated_position", data));
  await button(page, "Next position").click();
  await expect(page.getByRole("alert")).toContainText(/position-0001\.bin: .*truncated/);
  await button(page, "Next position").click();
  await expect(page.getByRole("alert")).toHaveCount(0);
});

test("damaged parts give a message instead of a blank page", async ({ page }) => {
  const damaged = createFixture();
  damaged.parts = damaged.parts.slice(0, 900);
  await page.goto(writePage("truncated_parts", embeddedData(damaged)));
  await expect(page.getByRole("alert")).toContainText(/parts\.bin: .*truncated/);
  const data = embeddedData(createFixture());
  data.parts = data.parts.slice(0, 2000);
  await page.goto(writePage("damaged_parts", data));
  await expect(page.getByRole("alert")).toContainText(/parts\.bin: the compressed data are damaged/);
  await page.goto(writePage("no_data", {}));
  await expect(page.getByRole("alert")).toContainText("parts.bin");
});

test("a browser without WebGL gives a message", async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(pageAddress);
  await expect(page.getByRole("alert")).toContainText("WebGL 2 is not available");
});

test("runs without meshes, without contacts, with one position, without positions", async ({ page }) => {
  const problems = await openWith(page, "no_meshes", { meshes: false });
  await expect(page.getByRole("button", { name: /Legend: Contact pressure/ })).toBeVisible();
  await page.getByLabel("Colours").selectOption("von_mises");
  await expect(page.getByText("No values in this position")).toBeVisible();
  problems.push(...(await openWith(page, "no_contacts", { contacts: false, meshes: false, positions: 1 })));
  expect((await state(page)).colours.field).toBe("plain");
  await page.getByLabel("Colours").selectOption("contact_pressure");
  await page.keyboard.press("v");
  await expect(button(page, "Play")).toBeDisabled();
  problems.push(...(await openWith(page, "no_positions", { positions: 0 })));
  await expect(page.getByText("No positions yet")).toBeVisible();
  expect(problems).toEqual([]);
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

test("two viewers with linked cameras", async ({ page }) => {
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
  await restore(page, { panels: { settings: true, plots: true }, cut: { on: true }, forces: { bearings: true, meshes: true } });
  await page.waitForTimeout(500);
  for (const theme of ["light", "dark"]) {
    await restore(page, { theme });
    await settle(page);
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.filter(({ impact }) => impact === "serious" || impact === "critical").map(({ id, nodes }) => [id, nodes.map((n) => n.html)])).toEqual([]);
  }
  await page.keyboard.press("?");
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.filter(({ impact }) => impact === "serious" || impact === "critical")).toEqual([]);
});
