// Camera that orbits about a target, with the z axis upwards in the picture.

import * as THREE from "three";
import type { CameraState, Projection, StandardView, Vector } from "./state.ts";

const FIELD_OF_VIEW = 24;
const DURATION = 260;

/** Azimuth and elevation of the eye, degrees. */
export const STANDARD_VIEWS: Record<StandardView, [number, number]> = {
  front: [-90, 0],
  back: [90, 0],
  left: [180, 0],
  right: [0, 0],
  top: [-90, 90],
  bottom: [-90, -90],
  isometric: [-50, 30],
};

export class OrbitCamera {
  readonly perspective = new THREE.PerspectiveCamera(FIELD_OF_VIEW);
  readonly orthographic = new THREE.OrthographicCamera();
  /** Called after every change; `user` is false for changes that a linked camera made. */
  onChange: ((user: boolean) => void) | null = null;

  #state: CameraState = { projection: "perspective", target: [0, 0, 0], azimuth: -50, elevation: 30, height: 1 };
  #aspect = 1;
  #centre = new THREE.Vector3();
  #radius = 1;
  #points: THREE.Vector3[] = [];
  /** The picture is fitted, and is fitted again when its shape changes. */
  #fit = false;
  #wantsFit = false;
  #transition = 0;
  #x = new THREE.Vector3();
  #y = new THREE.Vector3();
  #z = new THREE.Vector3();

  get active(): THREE.PerspectiveCamera | THREE.OrthographicCamera {
    return this.#state.projection === "perspective" ? this.perspective : this.orthographic;
  }

  get state(): CameraState {
    const state: CameraState = { ...this.#state, target: [...this.#state.target] };
    if (this.#fit) state.fitted = true;
    else delete state.fitted;
    return state;
  }

  /** Sphere around the scene for the clipping distances, and points whose picture `fit` shows. */
  setBounds(centre: THREE.Vector3, radius: number, points: THREE.Vector3[]): void {
    this.#centre.copy(centre);
    this.#radius = radius > 0 ? radius : 1;
    this.#points = points;
    this.update();
  }

  setFitPoints(points: THREE.Vector3[]): void {
    this.#points = points;
  }

  /** Sets the ratio of width to height. A fitted picture stays fitted until the user moves the camera. */
  setAspect(aspect: number): void {
    this.#aspect = aspect > 0 ? aspect : 1;
    if (this.#fit) Object.assign(this.#state, this.fitted(this.#state.azimuth, this.#state.elevation));
    this.update();
  }

  set(state: CameraState, user = false): void {
    this.interrupt();
    this.#state = { ...state, target: [...state.target] };
    // A fitted picture is fitted to the shape and the parts of this one.
    if (state.fitted) {
      Object.assign(this.#state, this.fitted(state.azimuth, state.elevation));
      this.#fit = true;
    }
    this.changed(user);
  }

  setProjection(projection: Projection): void {
    this.#state.projection = projection;
    this.changed(true);
  }

  orbit(azimuth: number, elevation: number): void {
    this.interrupt();
    this.#state.azimuth = wrap(this.#state.azimuth + azimuth);
    this.#state.elevation = clamp(this.#state.elevation + elevation, -90, 90);
    this.changed(true);
  }

  /** Moves the picture by fractions of its height. */
  pan(right: number, up: number): void {
    this.interrupt();
    this.shift(right, up);
    this.changed(true);
  }

  /** Zooms by a factor; the point at `x`, `y` (fractions of the height from the centre) keeps its place. */
  zoom(factor: number, x = 0, y = 0): void {
    this.interrupt();
    const height = clamp(this.#state.height * factor, this.#radius * 1e-4, this.#radius * 40);
    const real = height / this.#state.height;
    this.shift(-x * (1 - real), -y * (1 - real));
    this.#state.height = height;
    this.changed(true);
  }

  /** Turns to a standard view; the movement is short and can be switched off in the system. */
  view(name: StandardView, fit = true): void {
    const [azimuth, elevation] = STANDARD_VIEWS[name];
    const goal = { ...this.#state, azimuth, elevation };
    this.#wantsFit = fit;
    if (fit) Object.assign(goal, this.fitted(azimuth, elevation));
    this.animateTo(goal);
  }

  fit(animate = true): void {
    const goal = { ...this.#state, ...this.fitted(this.#state.azimuth, this.#state.elevation) };
    this.#wantsFit = true;
    if (animate) this.animateTo(goal);
    else this.set({ ...goal, fitted: true }, true);
  }

  /** Stops a movement and the automatic fit. */
  private interrupt(): void {
    cancelAnimationFrame(this.#transition);
    this.#fit = false;
  }

  /** Target and height at which the points fill the picture, seen along the given direction. */
  private fitted(azimuth: number, elevation: number): { target: Vector; height: number } {
    if (this.#points.length === 0) {
      const height = (2.1 * this.#radius) / Math.min(1, this.#aspect);
      return { target: [this.#centre.x, this.#centre.y, this.#centre.z], height };
    }
    const [x, y, z] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
    directions(azimuth, elevation, x, y, z);
    const box = new THREE.Box3();
    const p = new THREE.Vector3();
    const projected = this.#points.map((point) => new THREE.Vector3(point.dot(x), point.dot(y), point.dot(z)));
    for (const point of projected) box.expandByPoint(point);
    const centre = box.getCenter(p);
    // At distance d = height / (2 tan) the half height in the plane of a point is height / 2 − z tan.
    const slope = this.#state.projection === "perspective" ? Math.tan((FIELD_OF_VIEW * Math.PI) / 360) : 0;
    let height = 1e-3 * this.#radius;
    for (const point of projected) {
      const forward = (point.z - centre.z) * slope;
      height = Math.max(height, 2 * (Math.abs(point.y - centre.y) + forward), 2 * (Math.abs(point.x - centre.x) / this.#aspect + forward));
    }
    height *= 1.1;
    const target = x.multiplyScalar(centre.x).addScaledVector(y, centre.y).addScaledVector(z, centre.z);
    return { target: [target.x, target.y, target.z], height };
  }

  private animateTo(goal: CameraState): void {
    cancelAnimationFrame(this.#transition);
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      // A stored state must say that it is fitted.
      this.set({ ...goal, fitted: this.#wantsFit }, true);
      return;
    }
    const from = this.state;
    const turn = wrap(goal.azimuth - from.azimuth);
    const start = performance.now();
    const step = (now: number) => {
      const t = clamp((now - start) / DURATION, 0, 1);
      const s = t * t * (3 - 2 * t);
      this.#state.azimuth = wrap(from.azimuth + s * turn);
      this.#state.elevation = from.elevation + s * (goal.elevation - from.elevation);
      this.#state.height = from.height * (goal.height / from.height) ** s;
      for (let k = 0; k < 3; k++) this.#state.target[k] = from.target[k]! + s * (goal.target[k]! - from.target[k]!);
      if (t === 1) {
        this.#state = { ...goal, target: [...goal.target] };
        this.#fit = this.#wantsFit;
      }
      this.changed(true);
      if (t < 1) this.#transition = requestAnimationFrame(step);
    };
    this.#transition = requestAnimationFrame(step);
  }

  private shift(right: number, up: number): void {
    const { height, target } = this.#state;
    for (let k = 0; k < 3; k++) {
      const x = this.#x.getComponent(k);
      const y = this.#y.getComponent(k);
      target[k]! -= height * (right * x + up * y);
    }
  }

  private changed(user: boolean): void {
    this.update();
    this.onChange?.(user);
  }

  /** Direction from the target to the eye. */
  get direction(): THREE.Vector3 {
    return this.#z;
  }

  private update(): void {
    const { azimuth, elevation, height, target } = this.#state;
    directions(azimuth, elevation, this.#x, this.#y, this.#z);
    const distance = height / (2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360));
    const tx = target[0];
    const ty = target[1];
    const tz = target[2];
    // Depth of the scene's sphere along the direction of the view.
    const depth =
      distance -
      (this.#centre.x - tx) * this.#z.x -
      (this.#centre.y - ty) * this.#z.y -
      (this.#centre.z - tz) * this.#z.z;
    const reach = 1.3 * this.#radius + 0.02 * height;
    for (const camera of [this.perspective, this.orthographic]) {
      camera.position.set(tx + distance * this.#z.x, ty + distance * this.#z.y, tz + distance * this.#z.z);
      camera.matrix.makeBasis(this.#x, this.#y, this.#z);
      camera.quaternion.setFromRotationMatrix(camera.matrix);
      camera.updateMatrixWorld();
    }
    this.perspective.near = Math.max(depth - reach, distance * 0.02);
    this.perspective.far = Math.max(depth + reach, this.perspective.near * 1.1);
    this.perspective.aspect = this.#aspect;
    this.perspective.updateProjectionMatrix();
    const o = this.orthographic;
    o.near = depth - reach;
    o.far = depth + reach;
    o.top = height / 2;
    o.bottom = -height / 2;
    o.right = (height / 2) * this.#aspect;
    o.left = -o.right;
    o.updateProjectionMatrix();
  }
}

/** Axes of the picture: to the right, upwards, and from the target to the eye. */
function directions(azimuth: number, elevation: number, x: THREE.Vector3, y: THREE.Vector3, z: THREE.Vector3): void {
  const a = (azimuth * Math.PI) / 180;
  const e = (elevation * Math.PI) / 180;
  x.set(-Math.sin(a), Math.cos(a), 0);
  z.set(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
  y.crossVectors(z, x);
}

function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}

function wrap(degrees: number): number {
  return ((((degrees + 180) % 360) + 360) % 360) - 180;
}
