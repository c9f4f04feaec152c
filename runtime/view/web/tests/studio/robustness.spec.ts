// The studio with files that disappear, servers and pages that end, and several of them at a time.

import { existsSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { expect, test, type StudioServer } from "./server.ts";

const row = (page: Page, id: string) => page.locator(`[data-run="${id}"]`);
const runButton = (page: Page) => page.getByRole("button", { name: "Run", exact: true });

async function openWithoutAutomatic(page: Page, url: string): Promise<void> {
  await page.goto(url);
  await page.getByLabel("Run after changes if the predicted time is below 1 s").uncheck();
  await expect(runButton(page)).toBeEnabled();
}

async function startLongRun(page: Page): Promise<void> {
  await page.getByLabel("steps", { exact: true }).fill("10000");
  await expect(runButton(page)).toBeEnabled();
  await runButton(page).click();
  await expect(row(page, "run-0001")).toContainText("running");
}

/** Number of lines in the table of a run. */
function stored(server: StudioServer): number {
  const path = join(server.folder, "pair.cx.studio/run-0001/steps.csv");
  return existsSync(path) ? readFileSync(path, "utf8").split("\n").length : 0;
}

/** Makes a page believe that it is in the background, or in front. */
async function setVisibility(page: Page, visibility: "hidden" | "visible"): Promise<void> {
  await page.evaluate((value) => {
    Object.defineProperty(document, "visibilityState", { get: () => value, configurable: true });
    document.dispatchEvent(new Event("visibilitychange"));
  }, visibility);
}

test("files of a displayed run that are truncated or deleted are named", { tag: "@slow" }, async ({ page, server }) => {
  await openWithoutAutomatic(page, server.url);
  await runButton(page).click();
  await expect(row(page, "run-0001")).toContainText("finished");
  server.addView("run-0001");
  const view = join(server.folder, "pair.cx.studio/run-0001/view");
  const position = (number: number) => join(view, `position-000${number}.bin`);
  writeFileSync(position(1), readFileSync(position(1)).subarray(0, 3000));
  rmSync(position(2));
  await page.reload();
  await row(page, "run-0001").getByRole("button").click();
  const scene = page.locator(".viewer");
  const slider = scene.getByLabel("Position", { exact: true });
  await slider.fill("1");
  await expect(scene.getByRole("alert")).toContainText(/position-0001\.bin: .*truncated/);
  await slider.fill("0");
  await expect(scene.getByRole("alert")).toHaveCount(0);
  // The list of positions was read before.
  rmSync(view, { recursive: true });
  await slider.fill("3");
  await expect(scene.getByRole("alert")).toContainText("no such file");
  rmSync(join(server.folder, "pair.cx.studio"), { recursive: true });
  await expect(row(page, "run-0001")).toHaveCount(0);
  await expect(page.getByText("Run 1: the directory was deleted")).toBeVisible();
  await runButton(page).click();
  await expect(row(page, "run-0001")).toContainText("finished");
});

test("a page whose studio is killed says so, and its run is listed by the next studio", { tag: "@slow" }, async ({ page, server }) => {
  await openWithoutAutomatic(page, server.url);
  await startLongRun(page);
  await expect.poll(() => stored(server)).toBeGreaterThan(2);
  await server.end("SIGKILL");
  // Requests that were under way may have failed, with alerts of their own.
  await expect(page.getByRole("alert").filter({ hasText: "start calyx studio pair.cx --port" })).toBeVisible();
  await expect(runButton(page)).toBeDisabled();
  // The form stays usable: its values can be read and copied.
  await page.getByLabel("torque", { exact: true }).fill("150");
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("150");
  await page.goto(await server.open("pair.cx"));
  // The run ends with its studio and keeps the positions that it stored.
  await expect(row(page, "run-0001")).toContainText(/written by another process|interrupted|cancelled|finished/);
  await expect(page.getByLabel("steps", { exact: true })).toHaveValue("10000");
});

test("a run continues without a page", { tag: "@slow" }, async ({ page, server }) => {
  await openWithoutAutomatic(page, server.url);
  await startLongRun(page);
  const context = page.context();
  await page.close();
  const before = stored(server);
  await expect.poll(() => stored(server)).toBeGreaterThan(before);
  const later = await context.newPage();
  await later.goto(server.url);
  await expect(row(later, "run-0001")).toContainText("running");
  await later.getByRole("button", { name: "Cancel Run 1" }).click();
  await expect(row(later, "run-0001")).toContainText("cancelled");
});

test("two studios of a model list the runs of each other", { tag: "@slow" }, async ({ page, server }) => {
  const other = await page.context().newPage();
  await openWithoutAutomatic(page, server.url);
  await openWithoutAutomatic(other, await server.open("pair.cx"));
  await Promise.all([runButton(page).click(), runButton(other).click()]);
  for (const each of [page, other]) {
    for (const id of ["run-0001", "run-0002"]) await expect(row(each, id)).toContainText("finished", { timeout: 60_000 });
  }
  const folders = readdirSync(join(server.folder, "pair.cx.studio")).filter((name) => /^run-\d+$/.test(name));
  expect(folders).toEqual(["run-0001", "run-0002"]);
});

test("a studio with many pages responds", { tag: "@slow" }, async ({ page, server }) => {
  await openWithoutAutomatic(page, server.url);
  // More pages than a browser opens connections to a server.
  for (let i = 0; i < 7; i++) {
    const more = await page.context().newPage();
    await more.goto(server.url);
    await expect(more.getByLabel("torque", { exact: true })).toHaveValue("100");
    await setVisibility(more, "hidden");
  }
  const [, ...others] = page.context().pages();
  await runButton(page).click();
  await expect(row(page, "run-0001")).toContainText("finished");
  await expect(row(others[0]!, "run-0001")).toHaveCount(0);
  await setVisibility(others[0]!, "visible");
  await expect(row(others[0]!, "run-0001")).toContainText("finished");
});
