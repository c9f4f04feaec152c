// The three.js scene and its renderer. A frame is drawn only when something has changed.

import * as THREE from "three";
import { OrbitCamera } from "./camera.ts";
import { createScaleTexture } from "./colours.ts";
import { createSharedUniforms, type SharedUniforms } from "./materials.ts";

/** The browser cannot draw: WebGL is off or not supported. */
export class NoWebGlError extends Error {
  constructor() {
    super(
      "This browser cannot draw three-dimensional pictures: WebGL 2 is not available. " +
        "Turn on hardware acceleration in the browser's settings, or use another browser.",
    );
    this.name = "NoWebGlError";
  }
}

export class Scene {
  readonly canvas = document.createElement("canvas");
  readonly camera = new OrbitCamera();
  readonly scene = new THREE.Scene();
  /** Everything in ground coordinates. Its matrix keeps a part still if the user asks for that. */
  readonly root = new THREE.Group();
  readonly uniforms: SharedUniforms;
  readonly scaleTexture = createScaleTexture();
  /** Called before each frame. */
  onPrepare: (() => void) | null = null;
  /** Called after each frame. */
  onFrame: (() => void) | null = null;
  /** Number of frames since the start. */
  frames = 0;
  width = 1;
  height = 1;

  #renderer: THREE.WebGLRenderer;
  #observer: ResizeObserver;
  #request = 0;
  #frustum = new THREE.Frustum();
  #matrix = new THREE.Matrix4();

  constructor(private readonly container: HTMLElement) {
    this.uniforms = createSharedUniforms(this.scaleTexture);
    const context = this.canvas.getContext("webgl2", {
      antialias: true,
      alpha: true,
      stencil: true,
      depth: true,
      powerPreference: "high-performance",
    });
    if (!context) throw new NoWebGlError();
    this.#renderer = new THREE.WebGLRenderer({ canvas: this.canvas, context, stencil: true, alpha: true });
    this.#renderer.setClearColor(0x000000, 0);
    this.root.matrixAutoUpdate = false;
    this.scene.add(this.root);
    container.append(this.canvas);
    this.#observer = new ResizeObserver(() => this.resize());
    this.#observer.observe(container);
    this.canvas.addEventListener("webglcontextrestored", () => this.invalidate());
    this.resize();
  }

  private resize(): void {
    this.width = Math.max(this.container.clientWidth, 1);
    this.height = Math.max(this.container.clientHeight, 1);
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    this.uniforms.pixelRatio.value = ratio;
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(this.width, this.height);
    this.camera.setAspect(this.width / this.height);
    // Without a frame immediately after it, the canvas would flicker while the window is resized.
    this.draw();
  }

  /** Requests a frame. */
  invalidate(): void {
    if (this.#request) return;
    this.#request = requestAnimationFrame(() => {
      this.#request = 0;
      this.draw();
    });
  }

  /** Frustum of the camera, valid until the next call. */
  frustum(): THREE.Frustum {
    const { active } = this.camera;
    this.#matrix.multiplyMatrices(active.projectionMatrix, active.matrixWorldInverse);
    return this.#frustum.setFromProjectionMatrix(this.#matrix);
  }

  draw(): void {
    this.scene.updateMatrixWorld();
    this.onPrepare?.();
    this.#renderer.render(this.scene, this.camera.active);
    this.frames++;
    this.onFrame?.();
  }

  /** Draws a frame at `ratio` pixels per CSS pixel into a canvas of its own. */
  snapshot(ratio: number): HTMLCanvasElement {
    const before = this.#renderer.getPixelRatio();
    const copy = document.createElement("canvas");
    try {
      this.uniforms.pixelRatio.value = ratio;
      this.#renderer.setPixelRatio(ratio);
      this.#renderer.setSize(this.width, this.height, false);
      this.draw();
      copy.width = this.canvas.width;
      copy.height = this.canvas.height;
      // The drawing buffer is valid until control returns to the browser.
      copy.getContext("2d")!.drawImage(this.canvas, 0, 0);
    } finally {
      this.uniforms.pixelRatio.value = before;
      this.#renderer.setPixelRatio(before);
      this.#renderer.setSize(this.width, this.height);
      this.draw();
    }
    return copy;
  }

  /** Ray through a pixel of the canvas, in world coordinates. */
  ray(x: number, y: number, ray: THREE.Ray): THREE.Ray {
    const { active } = this.camera;
    const nx = (2 * x) / this.width - 1;
    const ny = 1 - (2 * y) / this.height;
    ray.origin.set(nx, ny, -1).unproject(active);
    ray.direction.set(nx, ny, 1).unproject(active).sub(ray.origin).normalize();
    return ray;
  }

  dispose(): void {
    cancelAnimationFrame(this.#request);
    this.#observer.disconnect();
    this.scaleTexture.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
    this.canvas.remove();
  }
}
