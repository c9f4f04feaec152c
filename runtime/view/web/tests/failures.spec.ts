// Damaged and incomplete runs.

import { expect, test } from "@playwright/test";
import { createFixture, embeddedData, writePage } from "./fixture.ts";
import { button, open, openWith, pageAddress, state } from "./page.ts";

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

test("files of an older version say what to do", async ({ page }) => {
  const old = createFixture();
  old.parts = old.parts.slice();
  old.parts[8] = 1;
  await page.goto(writePage("old_parts", embeddedData(old)));
  await expect(page.getByRole("alert")).toContainText("parts.bin: written by an older version of Calyx: run the model again");
});

test("a mesh that is missing or damaged is named; the rest is displayed", async ({ page }) => {
  const fixture = createFixture();
  const [first, second] = Object.keys(fixture.meshes) as [string, string];
  fixture.meshes[second] = fixture.meshes[second]!.slice(0, 3000);
  const data = embeddedData(fixture);
  await open(page, writePage("damaged_mesh", data));
  await expect(page.getByRole("alert")).toContainText(new RegExp(`${second}: .*truncated`));
  await expect(page.getByRole("button", { name: /Legend: Von Mises stress/ })).toBeVisible();
  delete data.meshes[first];
  await open(page, writePage("missing_mesh", data));
  await expect(page.getByRole("alert")).toContainText(/mesh-[0-9a-f]{16}\.bin: /);
  await expect(page.getByRole("button", { name: /Legend: Contact pressure/ })).toBeVisible();
});

test("a browser without WebGL gives a message", async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(pageAddress);
  await expect(page.getByRole("alert")).toContainText("WebGL 2 is not available");
});

test("a part without a position is not displayed", async ({ page }) => {
  const triangles = () => page.evaluate(() => window.calyxViewer!.triangles);
  await openWith(page, "all_parts", { meshes: false });
  const all = await triangles();
  const problems = await openWith(page, "lost_part", { meshes: false, lost: "wheel" });
  expect(await triangles()).toBeLessThan(0.8 * all);
  await page.getByLabel("Fixed frame").selectOption("wheel");
  await button(page, "Next position").click();
  expect(problems).toEqual([]);
});

test("runs without meshes, without contacts, with one position, without positions", { tag: "@slow" }, async ({ page }) => {
  const problems = await openWith(page, "no_meshes", { meshes: false });
  await expect(page.getByRole("button", { name: /Legend: Contact pressure/ })).toBeVisible();
  await page.getByLabel("Colours").selectOption("von_mises");
  await expect(page.getByText("No values: the run stored no meshes with stresses")).toBeVisible();
  problems.push(...(await openWith(page, "no_contacts", { contacts: false, meshes: false, positions: 1 })));
  expect((await state(page)).colours.field).toBe("plain");
  await page.getByLabel("Colours").selectOption("contact_pressure");
  await page.keyboard.press("v");
  await expect(button(page, "Play")).toBeDisabled();
  problems.push(...(await openWith(page, "no_positions", { positions: 0 })));
  await expect(page.getByText("No positions yet")).toBeVisible();
  expect(problems).toEqual([]);
});
