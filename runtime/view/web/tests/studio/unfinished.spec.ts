// Analysis settings, runs that end early, comparison of many runs, and the end and restart of the
// studio.

import { cpSync, existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { picture, row, run, serious, switchAutomaticOff } from "./page.ts";
import { PAIR, expect, test } from "./server.ts";

test("analysis settings override the model, and belong to the run", async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  const level = page.getByLabel("Fidelity level", { exact: true });
  await expect(level.locator("option").first()).toHaveText("As in the model: analytic");
  const planned = page.getByTestId("fidelity");
  await expect(planned).toHaveText("analytic");
  const time = await page.getByTestId("predicted-time").textContent();
  await level.selectOption("plane");
  await page.getByLabel("Error estimates", { exact: true }).selectOption("none");
  await expect(planned).toHaveText("plane");
  await expect(page.getByTestId("predicted-time")).not.toHaveText(time ?? "");
  await expect(page.getByText("2 changed", { exact: true }).first()).toBeVisible();
  await picture(page, "settings");
  // An invalid setting is an error at its field.
  await page.getByText("Positions, mesh and contact grid").click();
  await page.getByLabel("Contact cells M", { exact: true }).fill("0");
  await expect(page.locator('[data-setting="contact_cells"]').getByRole("alert")).toContainText("from 1 to 400");
  await expect(page.getByRole("button", { name: "Run", exact: true })).toBeDisabled();
  expect(await serious(page)).toEqual([]);
  await page.getByLabel("Contact cells M", { exact: true }).fill("");
  await expect(page.getByLabel("Contact cells M", { exact: true })).toBeFocused();
  await expect(page.getByLabel("Contact cells M", { exact: true })).toBeVisible();
  await level.selectOption("rigid");
  await run(page, "run-0001");
  await expect(row(page, "run-0001")).toContainText("fidelity rigid, error estimates none");
  await expect(page.getByText("Set: fidelity")).toBeVisible();
  const record = JSON.parse(readFileSync(join(server.folder, "pair.cx.studio/run-0001.json"), "utf8"));
  expect(record.settings).toEqual({ fidelity: "rigid", error_estimates: "none" });
  await page.getByRole("button", { name: "Reset Fidelity level to the model's own" }).click();
  await run(page, "run-0002");
  await page.getByLabel("Compare Run 1").check();
  await expect(page.getByRole("region", { name: "Table of different params and settings" })).toContainText("as in the model");
  // The session keeps settings; resetting all resets them.
  await page.waitForTimeout(500);
  await page.reload();
  await expect(page.getByLabel("Error estimates", { exact: true })).toHaveValue("none");
  await page.getByRole("button", { name: "Reset all" }).click();
  await expect(page.getByLabel("Error estimates", { exact: true })).toHaveValue("");
});

test("a cancelled run shows the positions that it solved, and continues", { tag: "@slow" }, async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await page.getByLabel("steps", { exact: true }).fill("400");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.getByText(/positions \d+ of \d+, .* left/)).toBeVisible();
  await page.getByRole("button", { name: "Cancel Run 1" }).click();
  await expect(row(page, "run-0001")).toContainText(/cancelled, \d+ of \d+ positions/);
  await expect(page.getByTestId("so-far")).toContainText("contact pressure");
  await expect(page.getByTestId("outputs")).toHaveCount(0);
  await expect(page.getByText(/^Incomplete: \d+ of \d+ positions$/).first()).toBeVisible();
  // The studio does not know the options of a run that was started elsewhere.
  cpSync(join(server.folder, "pair.cx.studio/run-0001"), join(server.folder, "pair.cx.run"), { recursive: true });
  await row(page, "model").getByRole("button").click();
  await expect(page.getByText("repeat its command with --resume in a terminal")).toBeVisible();
  await expect(page.getByRole("button", { name: /^Continue/ })).toHaveCount(0);
  await row(page, "run-0001").getByRole("button").click();
  await expect(page.getByRole("img", { name: /Plot of/ }).first()).toBeVisible();
  await picture(page, "cancelled");
  await page.getByRole("button", { name: "Continue Run 1" }).click();
  await expect(row(page, "run-0001")).toContainText("finished", { timeout: 60_000 });
  await expect(page.getByTestId("outputs")).toContainText("contact pressure");
  await expect(page.getByText(/Incomplete/)).toHaveCount(0);
  expect(existsSync(join(server.folder, "pair.cx.studio/run-0002"))).toBe(false);
});

test("many runs are compared in tables and plots, and as many scenes as fit are drawn", { tag: "@slow" }, async ({ page, server }) => {
  // The software renderer draws many scenes.
  test.slow();
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await run(page, "run-0001");
  const folder = join(server.folder, "pair.cx.studio");
  for (let number = 2; number <= 10; number++) {
    for (const end of ["", ".json"]) cpSync(join(folder, `run-0001${end}`), join(folder, `run-${String(number).padStart(4, "0")}${end}`), { recursive: true });
  }
  await expect(row(page, "run-0010")).toBeVisible();
  await page.evaluate(() => {
    // Without the automatic run, which may have started before it was switched off.
    for (const box of document.querySelectorAll<HTMLInputElement>('[data-run^="run-"] input:not(:checked)')) box.click();
  });
  await expect(page.getByTestId("compared").getByRole("columnheader")).toHaveCount(11);
  await expect(page.getByRole("img", { name: /Plot of transmission error .* Run 10 / })).toBeVisible();
  const viewers = page.locator(".viewer canvas");
  const notDrawn = page.getByText(/^Not drawn: .*Run \d+ \(no space\)$/);
  await expect(notDrawn).toBeVisible();
  expect(await viewers.count()).toBeGreaterThanOrEqual(4);
  await picture(page, "many");
  // Without plots there is space for more, and for not more than nine.
  await page.locator("summary", { hasText: "Plots" }).click();
  await expect(page.locator("figure.scene")).toHaveCount(9);
  await expect(notDrawn).toHaveText("Not drawn: Run 2 (no space)");
  await expect(page.getByLabel("Link cameras")).toBeChecked();
  // Narrow scenes have common controls, and each is drawn.
  await expect(page.locator(".cv-toolbar:visible")).toHaveCount(0);
  await page.getByLabel("Displayed field").selectOption("contact_pressure");
  await page.getByRole("group", { name: "All scenes" }).getByRole("slider").fill("3");
  await expect(page.locator("figure.scene .cv-legend")).toHaveCount(9, { timeout: 60_000 });
  await picture(page, "many-scenes");
});

test("the page reconnects to a new studio of the same model", { tag: "@slow" }, async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await page.getByLabel("torque", { exact: true }).fill("150");
  await run(page, "run-0001");
  await server.end("SIGKILL");
  // A scene may have an alert of its own, about a request that was not answered.
  const alert = page.locator(".notice");
  await expect(alert).toContainText("The studio has ended");
  await expect(alert).toContainText(`calyx studio pair.cx --port ${new URL(server.url).port}`);
  await expect(page.getByRole("button", { name: "Run", exact: true })).toBeDisabled();
  // The form can be edited meanwhile.
  await page.getByLabel("torque", { exact: true }).fill("160");
  await picture(page, "ended");
  const address = await server.restart();
  await expect(alert).toContainText("Open the address that it printed");
  const second = await page.context().newPage();
  await second.goto(address);
  // The first page stores what was entered meanwhile, and the second one follows.
  await expect(second.getByLabel("torque", { exact: true })).toHaveValue("160");
  await second.close();
  await expect(alert).toHaveCount(0);
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("160");
  await expect(row(page, "run-0001")).toHaveClass(/selected/);
  await run(page, "run-0002");
  await expect(row(page, "run-0002")).toContainText("torque 160 N*m");
  // A studio of another model at the same address gets no session of this one.
  await server.end("SIGKILL");
  await expect(alert).toContainText("The studio has ended");
  writeFileSync(join(server.folder, "other.cx"), PAIR);
  const third = await page.context().newPage();
  await third.goto(await server.restart("other.cx"));
  await expect(alert).toContainText("is another one");
  await page.getByLabel("torque", { exact: true }).fill("170");
  await expect(third.getByLabel("torque", { exact: true })).toHaveValue("100");
  await page.waitForTimeout(1500);
  await third.reload();
  await expect(third.getByLabel("torque", { exact: true })).toHaveValue("100");
});
