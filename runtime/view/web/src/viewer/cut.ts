// Cutting plane: its equation, its outline in the scene and the handle that moves it.

import * as THREE from "three";
import type { CutState } from "./state.ts";

const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;

export class CutView {
  /** Outline and handle, in world coordinates. */
  readonly group = new THREE.Group();
  /** Square that covers the scene; each cap draws it through its stencil. */
  readonly capGeometry = new THREE.PlaneGeometry(2, 2);
  readonly capMatrix = new THREE.Matrix4();
  readonly normal = new THREE.Vector3(0, 0, 1);
  /** Range of the offset over the scene, m. */
  range: [number, number] = [-1, 1];
  offset = 0;

  #outline: THREE.LineLoop;
  #handle = new THREE.Group();
  #centre = new THREE.Vector3();
  #radius = 1;
  #direction = new THREE.Vector3();

  constructor() {
    const corners = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0];
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
    this.#outline = new THREE.LineLoop(
      geometry,
      new THREE.LineBasicMaterial({ color: "#e07b1f", transparent: true, opacity: 0.8 }),
    );
    const material = new THREE.MeshBasicMaterial({ color: "#e07b1f", transparent: true, depthTest: false });
    const cone = new THREE.ConeGeometry(0.022, 0.05, 20).rotateX(Math.PI / 2);
    const forward = new THREE.Mesh(cone.clone().translate(0, 0, 0.062), material);
    const backward = new THREE.Mesh(cone.clone().rotateY(Math.PI).translate(0, 0, -0.062), material);
    const ball = new THREE.Mesh(new THREE.SphereGeometry(0.021, 20, 14), material);
    this.#handle.add(forward, backward, ball);
    for (const object of this.#handle.children) object.renderOrder = 300000;
    this.group.add(this.#outline, this.#handle);
    this.group.visible = false;
  }

  setBounds(centre: THREE.Vector3, radius: number): void {
    this.#centre.copy(centre);
    this.#radius = radius;
  }

  /** Applies the state and writes the equation of the plane. */
  apply(state: CutState, plane: THREE.Vector4): void {
    const normal = typeof state.normal === "string" ? (AXES[state.normal] ?? AXES.z) : state.normal;
    this.normal.set(normal[0], normal[1], normal[2]);
    if (!(this.normal.lengthSq() > 0)) this.normal.set(0, 0, 1);
    this.normal.normalize();
    const middle = this.normal.dot(this.#centre);
    this.range = [middle - this.#radius, middle + this.#radius];
    this.offset = state.offset ?? middle;
    const sign = state.flipped ? -1 : 1;
    plane.set(sign * this.normal.x, sign * this.normal.y, sign * this.normal.z, -sign * this.offset);
    this.group.visible = state.on;

    const position = this.#centre.clone().addScaledVector(this.normal, this.offset - middle);
    const rotation = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.normal);
    const size = 1.02 * this.#radius;
    this.capMatrix.compose(position, rotation, new THREE.Vector3(1.5 * size, 1.5 * size, 1));
    this.#outline.position.copy(position);
    this.#outline.quaternion.copy(rotation);
    this.#outline.scale.set(0.86 * size, 0.86 * size, 1);
    this.#handle.quaternion.copy(rotation);
    this.#handle.position.set(0.86 * size, 0.86 * size, 0).applyQuaternion(rotation).add(position);
    this.#handle.scale.setScalar(size);
  }

  /** Location of the handle, world coordinates. */
  get handle(): THREE.Vector3 {
    return this.#handle.position;
  }

  setHighlight(on: boolean): void {
    for (const object of this.#handle.children) {
      ((object as THREE.Mesh).material as THREE.MeshBasicMaterial).color.set(on ? "#ffa648" : "#e07b1f");
    }
  }

  /**
   * Converts a movement of the pointer in pixels into a movement along the normal, m.
   * Returns 0 if the normal points at the eye: a movement along it is not visible then.
   */
  drag(dx: number, dy: number, camera: THREE.Camera, width: number, height: number): number {
    const step = 0.01 * this.#radius;
    const from = this.#direction.copy(this.handle).project(camera);
    const x0 = from.x;
    const y0 = from.y;
    const to = this.#direction.copy(this.handle).addScaledVector(this.normal, step).project(camera);
    const px = ((to.x - x0) * width) / 2;
    const py = (-(to.y - y0) * height) / 2;
    const square = px * px + py * py;
    if (square < 0.02) return (-dy * step) / 2;
    return ((dx * px + dy * py) / square) * step;
  }
}
