// Labels in the scene: HTML elements above the canvas.

import * as THREE from "three";

export interface Label {
  text: string;
  /** Ground coordinates. */
  point: THREE.Vector3;
  kind: "bearing" | "mesh" | "maximum" | "minimum";
  /** A surface is in front of the point. */
  hidden?: boolean;
}

export interface PlacedLabel extends Label {
  /** Pixels from the upper left corner of the canvas. */
  x: number;
  y: number;
}

export class Labels {
  readonly element = document.createElement("div");
  #labels: Label[] = [];
  #elements: HTMLElement[] = [];
  #projected = new THREE.Vector3();

  constructor() {
    this.element.className = "cv-labels";
  }

  set(labels: Label[]): void {
    // Until it is known again, a mark is drawn as before.
    for (const label of labels) label.hidden ??= this.#labels.find(({ kind }) => kind === label.kind)?.hidden;
    this.#labels = labels;
    while (this.#elements.length > labels.length) this.#elements.pop()!.remove();
    labels.forEach((label, i) => {
      let element = this.#elements[i];
      if (!element) {
        element = document.createElement("div");
        element.append(document.createElement("i"), document.createElement("span"));
        this.#elements.push(element);
        this.element.append(element);
      }
      element.className = `cv-label cv-label-${label.kind}${label.hidden ? " cv-label-hidden" : ""}`;
      element.lastElementChild!.textContent = label.text;
    });
  }

  /** Marks the labels of extremes whose points `isHidden` finds behind a surface. */
  hide(isHidden: (point: THREE.Vector3) => boolean): void {
    this.#labels.forEach((label, i) => {
      if (label.kind !== "maximum" && label.kind !== "minimum") return;
      label.hidden = isHidden(label.point);
      this.#elements[i]!.classList.toggle("cv-label-hidden", label.hidden);
    });
  }

  /** Puts a label to the left of its point if there is no room on the right, where the legend may be. */
  arrange(width: number, legend: DOMRect | null): void {
    const origin = this.element.getBoundingClientRect();
    for (const element of this.#elements) {
      const { x, y } = element.getBoundingClientRect();
      const right = x + 12 + (element.lastElementChild as HTMLElement).offsetWidth;
      const covered = legend !== null && right > legend.left && x < legend.right && y + 10 > legend.top && y - 10 < legend.bottom;
      element.classList.toggle("cv-label-left", covered || right > origin.left + width);
    }
  }

  /** Moves the labels to the projections of their points. */
  update(camera: THREE.Camera, root: THREE.Matrix4, width: number, height: number): void {
    this.#labels.forEach((label, i) => {
      const p = this.#projected.copy(label.point).applyMatrix4(root).project(camera);
      const inside = p.z > -1 && p.z < 1 && Math.abs(p.x) < 1.02 && Math.abs(p.y) < 1.02;
      const { style } = this.#elements[i]!;
      style.display = inside ? "" : "none";
      if (inside) style.transform = `translate(${(0.5 + 0.5 * p.x) * width}px, ${(0.5 - 0.5 * p.y) * height}px)`;
    });
  }

  /** Labels in the picture with their locations, for an export. */
  placed(camera: THREE.Camera, root: THREE.Matrix4, width: number, height: number): PlacedLabel[] {
    return this.#labels
      .map((label) => {
        const p = label.point.clone().applyMatrix4(root).project(camera);
        return { ...label, x: (0.5 + 0.5 * p.x) * width, y: (0.5 - 0.5 * p.y) * height, depth: p.z };
      })
      .filter((p) => p.depth > -1 && p.depth < 1 && p.x > 0 && p.x < width && p.y > 0 && p.y < height);
  }
}
