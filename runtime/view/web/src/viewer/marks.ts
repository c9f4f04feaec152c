// Marks that surfaces hide.

import * as THREE from "three";
import type { Display } from "./display.ts";
import { pick } from "./picking.ts";
import type { Scene } from "./scene.ts";

const ray = new THREE.Ray();
const world = new THREE.Vector3();
const projected = new THREE.Vector3();

/** Returns whether a surface, or the section through a body, is in front of a point in ground coordinates. */
export function isHidden(scene: Scene, display: Display, point: THREE.Vector3): boolean {
  world.copy(point).applyMatrix4(scene.root.matrixWorld);
  projected.copy(world).project(scene.camera.active);
  scene.ray((0.5 + 0.5 * projected.x) * scene.width, (0.5 - 0.5 * projected.y) * scene.height, ray);
  const hit = pick(ray, display.views, display.meshes, display.factor, display.cutPlane);
  if (!hit) return false;
  const distance = projected.copy(world).sub(ray.origin).dot(ray.direction);
  // The point itself is on a surface.
  const margin = 1e-3 * display.radius;
  return hit.distance < distance - margin;
}
