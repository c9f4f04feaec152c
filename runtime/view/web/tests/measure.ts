// Measures how long a large scene takes to appear, its frame rate, and the ratio to a bare three.js
// page: five million triangles of gears, without and with a housing of 200,000 tetrahedra.
//
// Run with `npm run measure`, or `npm run measure firefox`. The numbers depend on the machine and the
// renderer; the ratio does not depend much on them.

import { chromium, firefox } from "@playwright/test";
import { build } from "esbuild";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { CHROMIUM, FIREFOX } from "./browsers.ts";
import { embeddedData, writePage } from "./fixture.ts";
import { PLANET, PLANETS, RING, housingMesh, largeScene, planet, poses, ring, type SolidMesh } from "./large_scene.ts";

const FRAMES = Number(process.env.CALYX_FRAMES ?? 12);
/** Longest time in which a picture appears, ms. */
const TARGET = 5000;

/** The same triangles as instances, with a simple material. */
const BARE = `
import * as THREE from "three";
const { shapes, parts, width, height } = window.input;
const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(width, height);
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(24, width / height, 0.1, 10);
scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 2));
const light = new THREE.DirectionalLight(0xffffff, 2);
scene.add(light);
for (const [shape, pose] of parts) {
  const { points, triangles, copies } = shapes[shape];
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
}
window.frame = (azimuth) => {
  const a = (azimuth * Math.PI) / 180;
  camera.up.set(0, 0, 1);
  camera.position.set(2.9 * Math.cos(a) * 0.87, 2.9 * Math.sin(a) * 0.87, 1.45);
  camera.lookAt(0, 0, 0);
  renderer.render(scene, camera);
};
`;
const bareScript = await build({
  stdin: { contents: BARE, resolveDir: process.cwd(), loader: "js" },
  bundle: true, format: "iife", minify: true, write: false,
});

const isFirefox = process.argv.includes("firefox");
if (isFirefox && !FIREFOX) throw new Error("Firefox is missing: install it, or set CALYX_FIREFOX to its path");
const browser = isFirefox ? await firefox.launch(FIREFOX!) : await chromium.launch(CHROMIUM);
const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce" });

/** Draws frames from different directions and returns the mean time, ms. Reading a pixel waits for the renderer. */
async function measureFrames(): Promise<number> {
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

/** Waits for the first picture and returns the time since the navigation, ms. */
async function firstPicture(): Promise<number> {
  await page.waitForFunction(() => {
    const viewer = window.calyxViewer;
    return viewer !== undefined && viewer.frames > 0 && viewer.triangles > 0;
  }, null, { polling: "raf", timeout: 120_000 });
  return page.evaluate(() => {
    const context = document.querySelector("canvas")!.getContext("webgl2")!;
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now();
  });
}

/** Time until the scene is drawn with another field, ms. */
async function recolour(field: string): Promise<number> {
  return page.evaluate(async (name) => {
    const viewer = window.calyxViewer!;
    const context = document.querySelector("canvas")!.getContext("webgl2")!;
    const wait = () => context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
    // Frames of the change before.
    for (let i = 0; i < 2; i++) await new Promise(requestAnimationFrame);
    wait();
    const start = performance.now();
    viewer.restore({ colours: { field: name as never } });
    viewer.draw();
    wait();
    return performance.now() - start;
  }, field);
}

/** Opens the bare page with the same triangles and returns the time of a frame, ms. */
async function measureBare(housing: SolidMesh | null, width: number, height: number): Promise<number> {
  const shapes = [
    { points: ring.points, triangles: ring.triangles, copies: RING.teeth },
    { points: planet.points, triangles: planet.triangles, copies: PLANET.teeth },
    ...(housing ? [{ points: [...housing.points], triangles: [...housing.triangles], copies: 1 }] : []),
  ];
  const parts = poses().map((pose, i) => [i === 0 ? 0 : i <= PLANETS ? 1 : 2, pose] as const).filter(([shape]) => shape < shapes.length);
  const input = JSON.stringify({ shapes, parts, width, height });
  const script = bareScript.outputFiles[0]!.text.replaceAll("</script", "<\\/script");
  const path = join("test-results", "pages", "bare.html");
  writeFileSync(path, `<!doctype html><meta charset="utf-8"><body><script>window.input=${input}</script><script>${script}</script>`);
  await page.goto(`file://${process.cwd()}/${path}`);
  await page.waitForFunction(() => "frame" in window);
  return measureFrames();
}

const line = (name: string, ms: number, more: string) => console.log(`${name.padEnd(40)} ${ms.toFixed(0).padStart(6)} ms  ${more}`);
const rate = (name: string, ms: number) => line(name, ms, `${(1000 / ms).toFixed(2).padStart(7)} frames/s`);
const limited = (name: string, ms: number) => line(name, ms, ms <= TARGET ? "" : `misses the target of ${TARGET} ms`);

async function measureScene(name: string, housing: SolidMesh | null): Promise<void> {
  await page.goto(writePage(`measure-${name}`, embeddedData(largeScene(housing), `Large scene, ${name}`)));
  const opened = await firstPicture();
  const size = await page.evaluate(() => {
    const canvas = document.querySelector("canvas")!;
    const { triangles, state } = window.calyxViewer!;
    return { width: canvas.clientWidth, height: canvas.clientHeight, triangles, field: state.colours.field };
  });
  const gears = RING.teeth * ring.triangles.length + PLANETS * PLANET.teeth * planet.triangles.length;
  const total = (gears + (housing?.triangles.length ?? 0)) / 3;
  console.log(
    `\n${name}: ${(total / 1e6).toFixed(2)} million triangles, of which the levels of detail draw ` +
      `${(size.triangles / 1e6).toFixed(2)} million; ${size.width} x ${size.height} pixels`,
  );
  if (housing) console.log(`housing: ${housing.tetrahedra.length / 4} tetrahedra, ${housing.triangles.length / 3} triangles`);
  limited(`first picture, field "${size.field}"`, opened);
  if (housing) for (const field of ["max_principal", "displacement", "von_mises"]) limited(`change of the field to "${field}"`, await recolour(field));
  const whole = await measureFrames();
  await page.screenshot({ path: join("test-results", `measure-${name}.png`) });
  // Zoomed into one mesh: copies outside of the picture are left out.
  await page.evaluate(() => window.calyxViewer!.restore({ camera: { ...window.calyxViewer!.state.camera!, target: [0.5, 0, 0], height: 0.06 } }));
  const close = await measureFrames();
  const bare = await measureBare(housing, size.width, size.height);
  rate("viewer, whole scene", whole);
  rate("viewer, zoomed into one mesh", close);
  rate("bare three.js page, whole scene", bare);
  console.log(`frame rate of the viewer / bare page: ${(bare / whole).toFixed(2)}`);
}

console.log(`${isFirefox ? "Firefox" : "Chromium"} ${browser.version()}`);
await measureScene("gears", null);
await measureScene("gears and housing", housingMesh());
await browser.close();
