// Measures the frame rate with five million triangles, and its ratio to a bare three.js page.
//
// Run with `npm run measure`. The numbers depend on the machine and the renderer; the ratio does not
// depend much on them.

import { chromium } from "@playwright/test";
import { build } from "esbuild";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { ArrayWriter } from "./array_writer.ts";
import { embeddedData, writePage } from "./fixture.ts";
import { gearSector } from "./gear_shapes.ts";

const FRAMES = Number(process.env.CALYX_FRAMES ?? 12);
const RING = { teeth: 1000, module: 1e-3, width: 40e-3, bore: 0.45 };
const PLANET = { teeth: 60, module: 1e-3, width: 40e-3, bore: 10e-3 };
const PLANETS = 12;

const ring = gearSector(RING, 6, 14, 4);
const planet = gearSector(PLANET, 6, 14, 4);
const radius = 0.5e-3 * (RING.teeth + PLANET.teeth);
const poses = Array.from({ length: PLANETS + 1 }, (_, i) => {
  const a = (2 * Math.PI * (i - 1)) / PLANETS;
  return [1, 0, 0, 0, 1, 0, 0, 0, 1, i ? radius * Math.cos(a) : 0, i ? radius * Math.sin(a) : 0, 0];
});

function fixture() {
  const parts = new ArrayWriter();
  const list = poses.map((_, i) => {
    const shape = i ? planet : ring;
    return {
      name: i ? `planet ${i}` : "ring",
      kind: "gear",
      copies: i ? PLANET.teeth : RING.teeth,
      points: parts.add("f32", 3, shape.points),
      triangles: parts.add("u32", 3, shape.triangles),
      edges: parts.add("u32", 2, shape.edges),
    };
  });
  const position = new ArrayWriter();
  const header = { position: 0, time: 0, poses: position.add("f64", 12, poses.flat()), forces: [], meshes: [] };
  return {
    parts: parts.finish({ model: "ring.cx", parts: list }),
    positions: [{ position: 0, time: 0, data: position.finish(header) }],
    meshPoints: [],
  };
}

/** The same triangles as instances, with a simple material. */
const BARE = `
import * as THREE from "three";
const { shapes, poses, width, height } = window.input;
const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(width, height);
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(24, width / height, 0.1, 10);
scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 2));
const light = new THREE.DirectionalLight(0xffffff, 2);
scene.add(light);
poses.forEach((pose, i) => {
  const { points, triangles, copies } = shapes[i ? 1 : 0];
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  geometry.setIndex(triangles);
  geometry.computeVertexNormals();
  const mesh = new THREE.InstancedMesh(geometry, new THREE.MeshLambertMaterial({ color: 0x7f9db9 }), copies);
  for (let k = 0; k < copies; k++) {
    const matrix = new THREE.Matrix4().makeRotationZ((2 * Math.PI * k) / copies);
    mesh.setMatrixAt(k, matrix);
  }
  mesh.frustumCulled = false;
  mesh.position.set(pose[9], pose[10], pose[11]);
  scene.add(mesh);
});
window.frame = (azimuth) => {
  const a = (azimuth * Math.PI) / 180;
  camera.up.set(0, 0, 1);
  camera.position.set(2.9 * Math.cos(a) * 0.87, 2.9 * Math.sin(a) * 0.87, 1.45);
  camera.lookAt(0, 0, 0);
  renderer.render(scene, camera);
};
`;

const address = writePage("measure", embeddedData(fixture(), "Ring with planets"));
const result = await build({
  stdin: { contents: BARE, resolveDir: process.cwd(), loader: "js" },
  bundle: true, format: "iife", minify: true, write: false,
});
const shapes = [
  { points: ring.points, triangles: ring.triangles, copies: RING.teeth },
  { points: planet.points, triangles: planet.triangles, copies: PLANET.teeth },
];
const barePage = join("test-results", "pages", "bare.html");

const browser = await chromium.launch({
  executablePath: process.env.CALYX_CHROMIUM || "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce" });

/** Draws frames from different directions and returns the mean time, ms. Reading a pixel waits for the renderer. */
async function measure(): Promise<number> {
  return page.evaluate(async (frames) => {
    const viewer = window.calyxViewer;
    const context = document.querySelector("canvas")!.getContext("webgl2")!;
    const draw = (i: number) => {
      if (viewer) {
        viewer.restore({ camera: { ...viewer.state.camera!, azimuth: 7 * i } });
        viewer.draw();
      } else {
        (window as unknown as { frame(azimuth: number): void }).frame(7 * i);
      }
      context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
    };
    for (let i = 0; i < 3; i++) draw(i);
    const start = performance.now();
    for (let i = 0; i < frames; i++) draw(i);
    return (performance.now() - start) / frames;
  }, FRAMES);
}

const start = performance.now();
await page.goto(address);
await page.waitForFunction(() => (window.calyxViewer?.frames ?? 0) > 2 && window.calyxViewer!.triangles > 0, null, { timeout: 120_000 });
const opened = performance.now() - start;
const size = await page.evaluate(() => {
  const canvas = document.querySelector("canvas")!;
  return { width: canvas.clientWidth, height: canvas.clientHeight, triangles: window.calyxViewer!.triangles };
});
const viewer = await measure();
await page.screenshot({ path: join("test-results", "measure.png") });
// Zoomed into one mesh: copies outside of the picture are left out.
await page.evaluate(() => window.calyxViewer!.restore({ camera: { ...window.calyxViewer!.state.camera!, target: [0.5, 0, 0], height: 0.06 } }));
const close = await measure();

writeFileSync(
  barePage,
  `<!doctype html><meta charset="utf-8"><body><script>window.input=${JSON.stringify({ shapes, poses, width: size.width, height: size.height })}</script>` +
    `<script>${result.outputFiles[0]!.text.replaceAll("</script", "<\\/script")}</script>`,
);
await page.goto(`file://${process.cwd()}/${barePage}`);
await page.waitForFunction(() => "frame" in window);
const bare = await measure();
await browser.close();

const row = (name: string, ms: number) => console.log(`${name.padEnd(34)} ${ms.toFixed(0).padStart(6)} ms  ${(1000 / ms).toFixed(2).padStart(7)} frames/s`);
const total = (RING.teeth * ring.triangles.length + PLANETS * PLANET.teeth * planet.triangles.length) / 3;
console.log(
  `${(total / 1e6).toFixed(2)} million triangles, of which the levels of detail draw ${(size.triangles / 1e6).toFixed(2)} million; ` +
    `${size.width} x ${size.height} pixels`,
);
console.log(`${"opened after".padEnd(34)} ${opened.toFixed(0).padStart(6)} ms`);
row("viewer, whole scene", viewer);
row("viewer, zoomed into one mesh", close);
row("bare three.js page, whole scene", bare);
console.log(`frame rate of the viewer / bare page: ${(bare / viewer).toFixed(2)}`);
