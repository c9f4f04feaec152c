// Starts `calyx studio` with a model in a temporary folder, and opens its page.

import { type ChildProcess, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { test as base } from "@playwright/test";
import { createFixture } from "../fixture.ts";

const HERE = dirname(fileURLToPath(import.meta.url));
const WEB = join(HERE, "../..");
/** Path of the command. */
export const CALYX = process.env.CALYX ?? join(WEB, "../../../target/release/calyx");

/** A pair in closed form, which is solved in a moment. */
export const PAIR = `/// A spur pair in closed form.
import gears;
units mm_N_s;

/// # Load
/// Torque on the pinion.
param torque = 100 N*m in 0 N*m .. 500 N*m;
/// # Teeth
/// Amount of tip relief at the tip circle, for a smooth start of contact.
param tip_relief = 10 um in 0 um .. 60 um;
/// Relieves the gear as well as the pinion.
param relieve_gear = TRUE;
/// # Analysis
/// Number of positions over the mesh cycle.
param steps = 8 in 2 .. 10000;
/// Fidelity level.
param fidelity = "analytic" in ["rigid", "analytic", "plane"];

var relief = [gears.tip_relief(tip_relief, length = 4 mm)];
var pinion = gears.external(24, module = 2.5 mm, face_width = 20 mm, modifications = relief);
var gear = gears.external(40, module = 2.5 mm, face_width = 20 mm, modifications = if (relieve_gear) relief else []);
var pair = gears.pair(pinion, gear, center_distance = 80.1 mm, torque = torque, speed = 1500 rpm);

/// Transmission error along the line of action.
output transmission_error := gears.transmission_error(pair.mesh) * gears.base_radius(gear) in um;
/// Fraction of the load that the tooth pair carries that enters contact at the start of the cycle.
output load_share := gears.load_share(pair.mesh);
/// Largest contact pressure on the flanks.
output contact_pressure := gears.max_contact_pressure(pair.mesh);
analyze("quasi_static", over = gears.mesh_cycle(pair.mesh, steps), fidelity = fidelity);
`;

export interface StudioServer {
  /** Address with the token. */
  url: string;
  folder: string;
  /** Replaces the model. */
  write(text: string): void;
  /** Starts another studio and returns its address. */
  open(subject: string): Promise<string>;
  /** Ends the studio that started last with a signal. */
  end(signal: NodeJS.Signals): Promise<void>;
  /** Starts a studio, of another subject if one is given, at the port of the first one, and returns its address. */
  restart(subject?: string): Promise<string>;
  /** Adds files of the viewer to a run. */
  addView(id: string): void;
}

/** Starts a studio and returns its address with the token. */
export async function start(folder: string, subject: string, port = "0"): Promise<[ChildProcess, string]> {
  const child = spawn(CALYX, ["studio", subject, "--no-browser", "--port", port], {
    cwd: folder,
    env: { ...process.env, CALYX_CACHE: "off" },
    stdio: ["ignore", "pipe", "inherit"],
  });
  const [url] = await new Promise<string[]>((resolve, reject) => {
    createInterface({ input: child.stdout! }).once("line", (line) => resolve([line]));
    child.once("error", reject);
    child.once("exit", (code) => reject(new Error(`calyx studio ended with status ${code}`)));
  });
  return [child, url ?? ""];
}

/** Ends a studio and waits for it. */
export async function end(child: ChildProcess, signal: NodeJS.Signals): Promise<void> {
  if (child.exitCode !== null || child.signalCode !== null) return;
  const ended = new Promise((resolve) => child.once("exit", resolve));
  child.kill(signal);
  await ended;
}

/** A test with a server, and a page that shows it. */
export const test = base.extend<{ server: StudioServer }>({
  server: async ({ page }, use) => {
    const folder = mkdtempSync(join(tmpdir(), "calyx-studio-"));
    writeFileSync(join(folder, "pair.cx"), PAIR);
    const [child, url] = await start(folder, "pair.cx");
    const children = [child];
    // The bundles of this folder, so that a change of the page needs no new build of the command.
    for (const [name, contentType] of [["studio.js", "text/javascript"], ["studio.css", "text/css"]] as const) {
      await page.context().route(`**/${name}`, (route) => route.fulfill({ contentType, body: readFileSync(join(WEB, "dist", name)) }));
    }
    const problems: string[] = [];
    page.on("pageerror", (error) => problems.push(String(error)));
    await use({
      url,
      folder,
      write: (text) => writeFileSync(join(folder, "pair.cx"), text),
      open: async (subject) => {
        const [other, address] = await start(folder, subject);
        children.push(other);
        return address;
      },
      end: (signal) => end(children.at(-1) ?? child, signal),
      restart: async (subject = "pair.cx") => {
        const [other, address] = await start(folder, subject, new URL(url).port);
        children.push(other);
        return address;
      },
      addView: (id) => {
        const fixture = createFixture({ positions: 3 });
        const view = join(folder, "pair.cx.studio", id, "view");
        mkdirSync(view, { recursive: true });
        writeFileSync(join(view, "parts.bin"), fixture.parts);
        for (const { position, data } of fixture.positions) {
          writeFileSync(join(view, `position-${String(position).padStart(4, "0")}.bin`), data);
        }
        for (const [name, data] of Object.entries(fixture.meshes)) writeFileSync(join(view, name), data);
      },
    });
    for (const each of children) await end(each, "SIGINT");
    rmSync(folder, { recursive: true, force: true });
    if (problems.length > 0) throw new Error(`errors in the page: ${problems.join("; ")}`);
  },
});

export { expect } from "@playwright/test";
