// Requests that store a session, and the page that restores it.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { sendSession } from "../../src/studio/api.ts";
import { test as studioTest } from "./server.ts";

test("only a short session outlives its page, a long one is stored too", async () => {
  const sent: RequestInit[] = [];
  const original = globalThis.fetch;
  globalThis.fetch = async (_path, init) => {
    sent.push(init ?? {});
    return new Response(null, { status: 204 });
  };
  try {
    for (const length of [10, 100_000]) {
      await sendSession({ version: 1, params: { name: "x".repeat(length) }, view: {} });
    }
  } finally {
    globalThis.fetch = original;
  }
  expect(sent.map(({ keepalive }) => keepalive)).toEqual([true, false]);
  expect(sent.every(({ body }) => typeof body === "string" && JSON.parse(body).version === 1)).toBe(true);
});

studioTest("controls appear with the values of the session", async ({ page, server }) => {
  const automatic = page.getByLabel("Run after changes if the predicted time is below 1 s");
  await page.goto(server.url);
  await automatic.uncheck();
  const stored = join(server.folder, "pair.cx.studio/session.json");
  await expect.poll(() => (existsSync(stored) ? JSON.parse(readFileSync(stored, "utf8")).view.automatic : null)).toBe(false);
  // A control that appeared earlier would be reset by the session, and a change of the user lost.
  await page.route("**/api/session", async (route) => {
    if (route.request().method() === "GET") await new Promise((resolve) => setTimeout(resolve, 1500));
    await route.continue();
  });
  await page.reload();
  await automatic.waitFor();
  expect(await automatic.isChecked()).toBe(false);
});
