// Helpers of the tests in a browser.

import { existsSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { join } from "node:path";
import { expect, type Page } from "@playwright/test";
import { DOWNLOADS } from "./browsers.ts";
import { createFixture, embeddedData, writePage, type FixtureOptions } from "./fixture.ts";

export const fixture = createFixture();
export const pageAddress = writePage("spur_pair", embeddedData(fixture));

export async function open(page: Page, address = pageAddress): Promise<string[]> {
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

export const openWith = (page: Page, name: string, options: FixtureOptions) => open(page, writePage(name, embeddedData(createFixture(options))));
export const state = (page: Page) => page.evaluate(() => window.calyxViewer!.state);
export const restore = (page: Page, patch: object) => page.evaluate((s) => window.calyxViewer!.restore(s), patch);
export const button = (page: Page, name: string | RegExp) => page.getByRole("button", { name, exact: typeof name === "string" });

/** Waits until two frames have passed, so that changes are displayed. */
export const settle = (page: Page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Colour of the scene at a pixel of the page, from a screenshot without labels. */
export async function pixel(page: Page, x: number, y: number): Promise<number[]> {
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
export async function centreOfColour(page: Page, colour: [number, number, number]): Promise<{ x: number; y: number }> {
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

export const project = async (page: Page, part: string, point: [number, number, number]) =>
  (await page.evaluate(([p, q]) => window.calyxViewer!.project(p, q), [part, point] as const))!;

/** Name and content of the file that a page saves. */
export async function savedFile(page: Page, save: () => Promise<unknown>): Promise<{ name: string; bytes: Buffer }> {
  if (page.context().browser()?.browserType().name() === "chromium") {
    const [download] = await Promise.all([page.waitForEvent("download"), save()]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  }
  // Playwright reports no download in Firefox if a page saves what it has made itself, but Firefox saves it.
  const files = () => (existsSync(DOWNLOADS) ? readdirSync(DOWNLOADS) : []);
  for (const name of files()) rmSync(join(DOWNLOADS, name), { recursive: true });
  await save();
  const isComplete = () => files().length === 1 && statSync(join(DOWNLOADS, files()[0]!)).size > 0;
  await expect.poll(isComplete).toBe(true);
  const name = files()[0]!;
  return { name, bytes: readFileSync(join(DOWNLOADS, name)) };
}
