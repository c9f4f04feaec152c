// Names and labels of scenes with many parts.

import { expect, test } from "@playwright/test";
import { shortNames, splitName } from "../src/viewer/names.ts";
import { open, restore } from "./page.ts";

test("names are shortened to the words in which they differ", () => {
  const short = (...names: string[]) => [...shortNames(names).values()];
  expect(short("gearbox.first.sun bearing", "gearbox.first.pin 1", "gearbox.rest[0].pin 1")).toEqual(["first.sun bearing", "first.pin 1", "rest[0].pin 1"]);
  expect(short("stage.low bearing", "stage.high bearing")).toEqual(["low", "high"]);
  expect(short("A", "B", "A")).toEqual(["A", "B"]);
  expect(short("bearing", "bearing A")).toEqual(["bearing", "bearing A"]);
  expect(short("only.one")).toEqual(["only.one"]);
  expect(splitName("gearbox.rest[0].planet 2")).toEqual(["gearbox.rest", "[0].planet 2"]);
  expect(splitName("pinion")).toEqual(["", "pinion"]);
});

test("labels do not overlap each other; those without room are not displayed", async ({ page }) => {
  await open(page);
  await restore(page, { forces: { bearings: true, meshes: true, labels: true } });
  const boxes = () =>
    page.evaluate(() =>
      [...document.querySelectorAll<HTMLElement>(".cv-label span")]
        .filter((label) => getComputedStyle(label).visibility === "visible" && label.parentElement!.style.display !== "none")
        .map((label) => label.getBoundingClientRect().toJSON() as DOMRect),
    );
  // From far away, all labels are at the same place.
  for (const height of [0.3, 1.5, 8]) {
    const { camera } = await page.evaluate(() => window.calyxViewer!.state);
    await restore(page, { camera: { ...camera, height, fitted: false } });
    // Labels are placed once the scene is at rest.
    await expect(async () => {
      const placed = await boxes();
      expect(placed.length).toBeGreaterThan(0);
      if (height === 8) expect(placed.length).toBeLessThan(await page.locator(".cv-label").count());
      placed.forEach((a, i) =>
        placed.slice(i + 1).forEach((b) => {
          const apart = a.left >= b.right - 1 || b.left >= a.right - 1 || a.top >= b.bottom - 1 || b.top >= a.bottom - 1;
          expect(apart, JSON.stringify([height, a, b])).toBe(true);
        }),
      );
    }).toPass({ timeout: 8000 });
  }
});
