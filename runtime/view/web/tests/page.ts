// Helpers of the tests in a browser.

import { expect, type Page } from "@playwright/test";
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
