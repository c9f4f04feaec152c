// Actions on the page of the studio that several tests share.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { expect } from "./server.ts";

/** Folder for pictures to look at; none by default. */
const PICTURES = process.env.CALYX_PICTURES;

export async function picture(page: Page, name: string): Promise<void> {
  if (!PICTURES) return;
  mkdirSync(PICTURES, { recursive: true });
  await page.screenshot({ path: join(PICTURES, `${name}.png`) });
}

export async function serious(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  const found = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  return found.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" | ")}`);
}

export const row = (page: Page, id: string) => page.locator(`[data-run="${id}"]`);

export async function switchAutomaticOff(page: Page): Promise<void> {
  await page.getByLabel("Run after changes if the predicted time is below 1 s").uncheck();
}

/** Starts a run and waits until the list shows its end. */
export async function run(page: Page, id: string): Promise<void> {
  await expect(page.getByRole("button", { name: "Run", exact: true })).toBeEnabled();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(row(page, id)).toContainText("finished", { timeout: 60_000 });
}
