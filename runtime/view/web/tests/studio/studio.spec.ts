// The studio in a browser: form, errors, runs, results, comparison, cancellation, a model with
// errors, the keyboard, and accessibility.

import { existsSync, readFileSync, renameSync, rmSync } from "node:fs";
import { join } from "node:path";
import type { Locator } from "@playwright/test";
import { savedFile } from "../page.ts";
import { picture, row, run, serious, switchAutomaticOff } from "./page.ts";
import { PAIR, expect, test } from "./server.ts";

test("a form has groups, units, ranges and errors at the fields", async ({ page, server }) => {
  await page.goto(server.url);
  await expect(page).toHaveURL(/\/$/);
  await expect(page).toHaveTitle("pair.cx – Calyx studio");
  for (const group of ["Load", "Teeth", "Analysis"]) await expect(page.getByRole("group", { name: group, exact: true })).toBeVisible();
  const torque = page.getByLabel("torque", { exact: true });
  await expect(torque).toHaveValue("100");
  await expect(page.locator('[data-param="torque"]')).toContainText("0 N*m .. 500 N*m");
  await torque.fill("600");
  await expect(page.getByRole("alert")).toContainText("outside its range");
  await expect(torque).toHaveAttribute("aria-invalid", "true");
  await expect(page.getByRole("button", { name: "Run", exact: true })).toBeDisabled();
  await picture(page, "error");
  await torque.fill("0.2 kN*m");
  await expect(page.getByRole("alert")).toHaveCount(0);
  await expect(page.locator('[data-param="torque"]')).toHaveClass(/changed/);
  await expect(page.getByText("1 changed")).toBeVisible();
  await page.getByLabel("relieve gear", { exact: true }).uncheck();
  await page.getByLabel("fidelity", { exact: true }).selectOption("rigid");
  await expect(page.getByText("3 changed")).toBeVisible();
  await page.getByRole("button", { name: /Reset torque/ }).click();
  await expect(torque).toHaveValue("100");
  await page.getByLabel("torque, slider").fill("250");
  await expect(torque).toHaveValue("250");
  await page.getByRole("button", { name: "Reset all" }).click();
  await expect(page.getByText("Defaults", { exact: true })).toBeVisible();
});

test("a change runs the model if that is quick", async ({ page, server }) => {
  await page.goto(server.url);
  // A fraction of a second; whether it is given in ms depends on the machine.
  await expect(page.getByTestId("predicted-time")).toHaveText(/^(\d+ ms|0\.\d s)$/);
  await expect(row(page, "preview")).toContainText("finished");
  const maximum = page.getByTestId("outputs").getByRole("row", { name: /contact pressure/ }).getByRole("cell").nth(2);
  await expect(maximum).toHaveText(/\d/);
  const before = await maximum.textContent();
  await page.getByLabel("torque", { exact: true }).fill("200");
  await expect(maximum).not.toHaveText(before ?? "");
  await expect(row(page, "preview")).toContainText("torque 200 N*m");
});

test("runs are stored, listed with their differences and compared", async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await run(page, "run-0001");
  await page.getByLabel("torque", { exact: true }).fill("200");
  await run(page, "run-0002");
  await expect(row(page, "run-0001")).toContainText("defaults");
  await expect(row(page, "run-0002")).toContainText("torque 200 N*m");
  await picture(page, "results");
  // The displayed numbers are those of the run's file.
  const file = JSON.parse(readFileSync(join(server.folder, "pair.cx.studio/run-0002/run.json"), "utf8"));
  const shown = await page.getByTestId("outputs").getByRole("row", { name: /contact pressure/ }).getByRole("cell").nth(2).textContent();
  expect(Number(shown)).toBeCloseTo(file.outputs.contact_pressure.display.max, 1);
  await page.getByLabel("Compare Run 1").check();
  await expect(page.getByTestId("compared").getByRole("columnheader", { name: "Run 1" })).toBeVisible();
  await expect(page.getByRole("region", { name: "Different params and settings", exact: true })).toContainText("200 N*m");
  await expect(page.getByRole("img", { name: /Plot of transmission error in um: Run 2 .* Run 1/ })).toBeVisible();
  await picture(page, "comparison");
  await page.getByLabel("Theme").selectOption("dark");
  await picture(page, "comparison-dark");
  // A deleted directory disappears from the list.
  rmSync(join(server.folder, "pair.cx.studio/run-0001"), { recursive: true });
  await expect(row(page, "run-0001")).toHaveCount(0);
  await expect(row(page, "run-0002")).toBeVisible();
});

test("a form that differs from the displayed run is marked, with the names of the params", async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  const mark = page.getByTestId("form-changed");
  await run(page, "run-0001");
  await expect(mark).toHaveCount(0);
  await page.getByLabel("torque", { exact: true }).fill("150");
  await page.getByLabel("Error estimates", { exact: true }).selectOption("none");
  await expect(mark).toContainText("Form changed since Run 1: error estimates, torque");
  await expect(page.getByTestId("predicted-disk")).toHaveText(/MB/);
  await picture(page, "form-changed");
  // The same value in another unit is no change.
  await page.getByLabel("torque", { exact: true }).fill("0.1 kN*m");
  await expect(mark).toContainText("Form changed since Run 1: error estimates.");
  await page.getByRole("button", { name: "Back to the values of the run" }).click();
  await expect(mark).toHaveCount(0);
  await page.getByLabel("torque", { exact: true }).fill("150");
  await page.getByRole("button", { name: "Run with this form" }).click();
  await expect(row(page, "run-0002")).toContainText("finished");
  await expect(mark).toHaveCount(0);
  server.write(`${PAIR}print("edited");`);
  await expect(mark).toContainText("the text of the model");
});

test("errors of settings name their field, and a decimal comma its remedy", async ({ page, server }) => {
  await page.goto(server.url);
  await page.getByText("Positions, mesh and contact grid").click();
  await page.getByLabel("Contact cells M", { exact: true }).fill("abc");
  await expect(page.locator('[data-setting="contact_cells"]')).toContainText("Contact cells M cannot be abc");
  await page.getByLabel("Mesh refinement", { exact: true }).fill("1,5");
  await expect(page.locator('[data-setting="refinement"]')).toContainText("write a decimal point in place of the comma, 1.5");
  await page.getByLabel("torque", { exact: true }).fill("1,5");
  await expect(page.locator('[data-param="torque"]')).toContainText("write a decimal point in place of the comma, 1.5");
});

test("a long run shows its progress and is cancelled", async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await page.getByLabel("steps", { exact: true }).fill("10000");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.getByRole("progressbar")).toBeVisible();
  await expect(page.getByText(/positions \d+ of \d+, .* left/)).toBeVisible();
  await expect(page.getByRole("img", { name: /Plot of/ }).first()).toBeVisible();
  await picture(page, "progress");
  // A second page of the same studio shows the run, and closing it changes nothing.
  const second = await page.context().newPage();
  await second.goto(server.url);
  await expect(row(second, "run-0001")).toContainText("running");
  await second.close();
  await page.getByRole("button", { name: "Cancel Run 1" }).click();
  await expect(row(page, "run-0001")).toContainText("cancelled");
  await expect(page.getByRole("progressbar")).toHaveCount(0);
  // Its positions are shown, and not as results of the whole run.
  await expect(row(page, "run-0001")).toContainText(/cancelled, \d+ of \d+ positions/);
  await expect(page.getByTestId("so-far")).toContainText("contact pressure");
  await expect(page.getByTestId("outputs")).toHaveCount(0);
  await expect(page.getByRole("button", { name: "Continue Run 1" })).toBeEnabled();
  expect(await serious(page)).toEqual([]);
});

test("a model with errors shows the diagnostic, and the page follows the editor", async ({ page, server }) => {
  await page.goto(server.url);
  await page.getByLabel("torque", { exact: true }).fill("150");
  await expect(page.getByRole("button", { name: "Run", exact: true })).toBeEnabled();
  server.write(PAIR.replace("torque = torque", "torque = torqe"));
  await expect(page.getByLabel("Diagnostics of the model")).toContainText("torqe");
  await expect(page.getByLabel("Diagnostics of the model")).toContainText("pair.cx:");
  // The diagnostics may be outside of the window; the bar at its top is not.
  await expect(page.getByTestId("model-broken")).toContainText("Correct pair.cx in the editor");
  // The form and its values remain.
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("150");
  await expect(page.getByRole("button", { name: "Run", exact: true })).toBeDisabled();
  await picture(page, "broken");
  expect(await serious(page)).toEqual([]);
  server.write(PAIR.replace("param torque = 100 N*m", "param torque = 120 N*m"));
  await page.getByRole("button", { name: /^Reset torque/ }).click();
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("120");
  await expect(page.getByTestId("model-broken")).toHaveCount(0);
});

test("values keep the unit in which they were entered, and settings without effect say so", async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  const torque = page.getByLabel("torque", { exact: true });
  // Another spelling of the default is not a change.
  await page.getByLabel("steps", { exact: true }).fill("8.0");
  await expect(page.getByText("Defaults", { exact: true })).toBeVisible();
  await page.getByLabel("steps", { exact: true }).fill("8");
  await torque.fill("200 Nm");
  await expect(page.getByRole("alert")).toContainText("200 N*m");
  await torque.fill("1234.5 lbf*inch");
  await run(page, "run-0001");
  await expect(row(page, "run-0001")).toContainText("torque 1234.5 lbf*inch");
  const provenance = page.getByRole("region", { name: "Provenance" });
  await expect(provenance).toContainText("Param: torque");
  await expect(provenance).toContainText(String(new Date().getFullYear()));
  await torque.fill("90");
  await page.getByRole("button", { name: "Use these params and settings" }).click();
  await expect(torque).toHaveValue("1234.5 lbf*inch");
  await expect(page.getByTestId("form-changed")).toHaveCount(0);
  const meshes = page.locator('[data-setting="vtu"]');
  await meshes.getByRole("checkbox").check();
  await expect(meshes).toContainText("no effect on gears");
  await meshes.getByRole("checkbox").uncheck();
  await expect(meshes).not.toContainText("no effect");
  await run(page, "run-0002");
  await expect(page.getByText("Check two or more runs")).toBeVisible();
  await page.getByLabel("Compare Run 1").check();
  await expect(page.getByText("Check two or more runs")).toHaveCount(0);
});

test("a studio does not overwrite the session of another one", async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  const file = join(server.folder, "pair.cx.studio/session.json");
  const stored = () => existsSync(file) && (JSON.parse(readFileSync(file, "utf8")) as { params: Record<string, string> }).params.torque;
  await page.getByLabel("torque", { exact: true }).fill("150");
  await expect.poll(stored).toBe("150");
  // A page that is displayed again takes the form of the other studio; this one does not learn of it.
  await page.route("**/api/session", (route) => (route.request().method() === "GET" ? route.abort() : route.continue()));
  const other = await page.context().newPage();
  await other.goto(await server.open("pair.cx"));
  await other.getByLabel("torque", { exact: true }).fill("160");
  await expect.poll(stored).toBe("160");
  await page.getByLabel("torque", { exact: true }).fill("170");
  await expect(page.getByRole("alert")).toContainText("another page or studio of this model has stored its form");
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("170");
  expect(stored()).toBe("160");
  await page.unroute("**/api/session");
  await page.reload();
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("160");
});

test("a change in one page of a studio appears in the other, unless that one has changed too", async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  const other = await page.context().newPage();
  await other.goto(server.url);
  const [here, there] = [page, other].map((each) => each.getByLabel("torque", { exact: true })) as [Locator, Locator];
  await here.fill("150");
  await expect(there).toHaveValue("150");
  await there.fill("160");
  await expect(here).toHaveValue("160");
  // A field that is changed in both pages: the second change is refused, and remains in its page. That page
  // receives the former session, as if its user had been faster.
  const file = join(server.folder, "pair.cx.studio/session.json");
  const stored = () => JSON.parse(readFileSync(file, "utf8")) as { params: Record<string, string> };
  await expect.poll(() => stored().params.torque).toBe("160");
  const former = stored();
  await other.route("**/api/session", (route) => (route.request().method() === "GET" ? route.fulfill({ json: former }) : route.continue()));
  await here.fill("170");
  await expect.poll(() => stored().params.torque).toBe("170");
  await there.fill("180");
  await expect(other.getByRole("alert")).toContainText("another page or studio of this model has stored its form");
  await expect(here).toHaveValue("170");
  await expect(there).toHaveValue("180");
  expect(stored().params.torque).toBe("170");
});

test("the session and params files keep the values of the form", { tag: "@slow" }, async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await page.getByLabel("torque", { exact: true }).fill("321");
  await page.waitForResponse((response) => response.url().endsWith("/api/session") && response.request().method() === "PUT");
  await page.reload();
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("321");
  const { bytes } = await savedFile(page, () => page.getByRole("button", { name: "Save" }).click());
  expect(JSON.parse(bytes.toString())).toEqual({ torque: 321, tip_relief: 10, relieve_gear: true, steps: 8, fidelity: "analytic" });
  await page.getByLabel("Params file").setInputFiles({
    name: "case.toml",
    mimeType: "text/plain",
    buffer: Buffer.from('torque = 50\ntip_relief = "0.02 mm"\n'),
  });
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("50");
  await expect(page.getByLabel("tip relief", { exact: true })).toHaveValue("0.02 mm");
  await page.getByLabel("Params file").setInputFiles({ name: "case.json", mimeType: "text/plain", buffer: Buffer.from("[1") });
  await expect(page.getByRole("alert")).toContainText("params are one object");
});

test("runs with view files are shown side by side with linked cameras", { tag: "@slow" }, async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await run(page, "run-0001");
  await run(page, "run-0002");
  server.addView("run-0001");
  server.addView("run-0002");
  await page.reload();
  await row(page, "run-0001").getByRole("button").click();
  await page.getByLabel("Compare Run 2").check();
  await expect(page.locator(".viewer canvas")).toHaveCount(2);
  await expect(page.getByLabel("Link cameras")).toBeChecked();
  await page.waitForTimeout(3000);
  await picture(page, "side-by-side");
});

test("a change of a param updates the geometry of the model", async ({ page, server }) => {
  // Playwright does not read the bodies of requests in Firefox.
  await page.addInitScript(() => {
    const original = window.fetch;
    const bodies: unknown[] = [];
    Object.assign(window, { bodies });
    window.fetch = (path, options) => {
      if (path === "/api/scene") bodies.push(JSON.parse(String(options?.body)));
      return original(path, options);
    };
  });
  const requested = () => page.evaluate(() => (window as unknown as { bodies: unknown[] }).bodies.at(-1));
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await expect(page.locator(".viewer canvas")).toHaveCount(1);
  await page.getByLabel("torque", { exact: true }).fill("150");
  await expect.poll(requested).toEqual({ params: { torque: "150" }, settings: {} });
  await run(page, "run-0001");
  await page.getByLabel("torque", { exact: true }).fill("160");
  await expect.poll(requested).toEqual({ params: { torque: "160" }, settings: {} });
  await picture(page, "model");
});

test("a run directory is shown, with or without its model", { tag: "@slow" }, async ({ page, server }) => {
  await page.goto(server.url);
  await switchAutomaticOff(page);
  await run(page, "run-0001");
  await page.goto(await server.open("pair.cx.studio/run-0001"));
  await expect(page.getByTestId("outputs")).toContainText("contact pressure");
  await expect(page.getByLabel("torque", { exact: true })).toHaveValue("100");
  renameSync(join(server.folder, "pair.cx.studio/run-0001"), join(server.folder, "results"));
  rmSync(join(server.folder, "pair.cx"));
  await page.goto(await server.open("results"));
  await expect(page.getByTestId("outputs")).toContainText("contact pressure");
  await expect(page.getByText("The model of this run is not known.")).toBeVisible();
  await expect(page.getByRole("button", { name: "Run", exact: true })).toHaveCount(0);
  expect(await serious(page)).toEqual([]);
});

test("everything works by the keyboard, and axe finds nothing serious", async ({ page, server }) => {
  await page.goto(server.url);
  await expect(row(page, "preview")).toContainText("finished");
  await page.keyboard.press("Tab");
  const reached = new Set<string>();
  for (let i = 0; i < 60; i++) {
    reached.add(await page.evaluate(() => {
      const element = document.activeElement as HTMLElement | null;
      return element?.id || element?.getAttribute("aria-label") || element?.textContent || "";
    }));
    await page.keyboard.press("Tab");
  }
  for (const name of ["param-torque", "param-relieve_gear", "param-fidelity", "Run", "Reset all", "Load …", "Save"]) {
    if (name === "Reset all") continue;
    expect([...reached]).toContain(name);
  }
  await page.getByLabel("torque", { exact: true }).focus();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type("150");
  await expect(page.locator('[data-param="torque"]')).toHaveClass(/changed/);
  await expect(page.getByRole("button", { name: "Run", exact: true })).toBeEnabled();
  await expect(row(page, "preview")).toContainText("torque 150 N*m");
  await page.keyboard.press("ControlOrMeta+Enter");
  await expect(row(page, "run-0001")).toContainText("finished");
  for (const theme of ["light", "dark"]) {
    await page.getByLabel("Theme").selectOption(theme);
    await page.waitForTimeout(300);
    expect(await serious(page), theme).toEqual([]);
    await picture(page, theme);
  }
});
