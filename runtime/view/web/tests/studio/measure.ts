// Measures the studio with a run that has large view files: time of requests, memory of the server,
// and the time until a page shows the scene.
//
// Run with `npm run measure:studio`; CALYX is the path of the command.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "@playwright/test";
import { CHROMIUM } from "../browsers.ts";
import { housingMesh, largeScene } from "../large_scene.ts";
import { CALYX, PAIR, end, start } from "./server.ts";

const POSITIONS = 32;
/** Longest time in which a picture appears, ms. */
const TARGET = 5000;

/** Writes a run directory whose view is the large scene at many positions. */
function writeRun(folder: string): number {
  writeFileSync(join(folder, "pair.cx"), PAIR);
  execFileSync(CALYX, ["run", "pair.cx", "--quiet", "--no-cache", "--out", "results", "--set", `steps=${POSITIONS}`], { cwd: folder });
  const view = join(folder, "results/view");
  const { parts, positions, meshes } = largeScene(housingMesh());
  writeFileSync(join(view, "parts.bin"), parts);
  for (const [name, data] of Object.entries(meshes)) writeFileSync(join(view, name), data);
  for (let i = 0; i < POSITIONS; i++) writeFileSync(join(view, `position-${String(i).padStart(4, "0")}.bin`), positions[0]!.data);
  return positions[0]!.data.length;
}

/** A line of /proc/PID/status, MB. */
function memory(pid: number, field: "VmRSS" | "VmHWM"): number {
  const status = readFileSync(`/proc/${pid}/status`, "utf8");
  return Number(new RegExp(`${field}:\\s*(\\d+) kB`).exec(status)?.[1]) / 1024;
}

const row = (name: string, value: string) => console.log(`${name.padEnd(44)} ${value}`);

const folder = mkdtempSync(join(tmpdir(), "calyx-measure-"));
const size = writeRun(folder);
row("size of a position", `${(size / 1e6).toFixed(1)} MB`);
const [server, url] = await start(folder, "results");
const address = new URL(url);
const headers = { Authorization: `Bearer ${address.searchParams.get("token")}` };
row("memory after the start", `${memory(server.pid!, "VmRSS").toFixed(0)} MB`);

/** Requests a file and returns the times until its first and its last byte, ms. */
async function request(path: string): Promise<[number, number]> {
  const begin = performance.now();
  const response = await fetch(new URL(path, address), { headers });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  const reader = response.body!.getReader();
  await reader.read();
  const first = performance.now() - begin;
  while (!(await reader.read()).done);
  return [first, performance.now() - begin];
}

const position = (i: number) => `/api/runs/opened/files/view/position-${String(i).padStart(4, "0")}.bin`;
for (const path of ["/api/runs", "/api/runs/opened", "/api/runs/opened/view", "/api/runs/opened/files/view/parts.bin", position(0), position(1)]) {
  const [first, last] = await request(path);
  row(path, `first byte ${first.toFixed(1).padStart(6)} ms, last byte ${last.toFixed(1).padStart(6)} ms`);
}
const all = performance.now();
await Promise.all(Array.from({ length: POSITIONS }, (_, i) => request(position(i))));
const seconds = (performance.now() - all) / 1000;
row(`${POSITIONS} positions at the same time`, `${((POSITIONS * size) / 1e6 / seconds).toFixed(0)} MB/s`);
row("memory of the server, largest", `${memory(server.pid!, "VmHWM").toFixed(0)} MB`);

// An automatic run would take the place of the opened run.
const session = JSON.stringify({ version: 1, params: {}, view: { automatic: false } });
await fetch(new URL("/api/session", address), { method: "PUT", headers: { ...headers, "Content-Type": "application/json" }, body: session });
const browser = await chromium.launch(CHROMIUM);
const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce" });
const script = readFileSync("dist/studio.js");
await page.route("**/studio.js", (route) => route.fulfill({ contentType: "text/javascript", body: script }));
const begin = performance.now();
await page.goto(url);
await page.getByRole("button", { name: /Legend: Von Mises stress/ }).waitFor({ timeout: 120_000 });
const shown = performance.now() - begin;
row("page, legend of the von Mises stress", `${shown.toFixed(0)} ms${shown <= TARGET ? "" : `, misses the target of ${TARGET} ms`}`);
await page.waitForTimeout(2000);
await page.screenshot({ path: join("test-results", "measure-studio.png") });
await browser.close();
await end(server, "SIGINT");
rmSync(folder, { recursive: true, force: true });
