// Labels in the scene: HTML elements above the canvas.

import * as THREE from "three";

export interface Label {
  text: string;
  /** Ground coordinates. */
  point: THREE.Vector3;
  kind: "bearing" | "mesh" | "maximum" | "minimum";
  /** A surface is in front of the point. */
  hidden?: boolean;
  /** Labels with larger weights are placed first. */
  weight?: number;
}

/** Side of its point on which a label is; null if there is no room on any. */
type Side = "right" | "left" | "above" | "below" | null;

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const overlap = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** Distance of a label from its point, and half its height, px. */
const [OFFSET, HALF] = [9, 9];

function boxAt(side: Side, x: number, y: number, width: number): Box {
  const left = side === "right" ? x + OFFSET : side === "left" ? x - OFFSET - width : x - width / 2;
  const top = side === "above" ? y - OFFSET - 2 * HALF : side === "below" ? y + OFFSET : y - HALF;
  return { left, top, right: left + width, bottom: top + 2 * HALF };
}

export interface PlacedLabel extends Label {
  /** Pixels from the upper left corner of the canvas. */
  x: number;
  y: number;
  side: Exclude<Side, null>;
}

export class Labels {
  readonly element = document.createElement("div");
  #labels: Label[] = [];
  #elements: HTMLElement[] = [];
  #sides: Side[] = [];
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
      element.className = `cv-label cv-label-${label.kind}${label.hidden ? " cv-label-hidden" : ""} ${sideClass(this.#sides[i])}`;
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

  /** Places the labels beside their points without overlap with each other, the legend and the border; those without room are not displayed. */
  arrange(width: number, height: number, legend: DOMRect | null): void {
    const { left, top } = this.element.getBoundingClientRect();
    const taken: Box[] = legend ? [{ left: legend.left - left, top: legend.top - top, right: legend.right - left, bottom: legend.bottom - top }] : [];
    const isExtreme = ({ kind }: Label) => kind === "maximum" || kind === "minimum";
    const weight = (label: Label) => (isExtreme(label) ? Infinity : (label.weight ?? 0));
    const order = this.#labels.map((_, i) => i).sort((a, b) => weight(this.#labels[b]!) - weight(this.#labels[a]!) || a - b);
    // All sizes are read before the first class changes, so that the layout is computed once.
    const widths = this.#elements.map((element) => (element.lastElementChild as HTMLElement).offsetWidth);
    const points = this.#elements.map((element) => element.getBoundingClientRect());
    for (const i of order) {
      if (this.#elements[i]!.style.display === "none") continue;
      const [x, y] = [points[i]!.x - left, points[i]!.y - top];
      const isFree = (box: Box) => box.left >= 0 && box.right <= width && box.top >= 0 && box.bottom <= height && !taken.some((other) => overlap(box, other));
      const sides = (["right", "left", "above", "below"] as const).filter((side) => isFree(boxAt(side, x, y, widths[i]!)));
      // The marks of extremes are never without their values.
      const side: Side = sides[0] ?? (isExtreme(this.#labels[i]!) ? "right" : null);
      if (side) taken.push(boxAt(side, x, y, widths[i]!));
      this.#elements[i]!.classList.remove(...SIDES);
      this.#elements[i]!.classList.add(sideClass(side));
      this.#sides[i] = side;
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
      .map((label, i) => {
        const p = label.point.clone().applyMatrix4(root).project(camera);
        return { ...label, x: (0.5 + 0.5 * p.x) * width, y: (0.5 - 0.5 * p.y) * height, depth: p.z, side: this.#sides[i] === undefined ? ("right" as const) : this.#sides[i] };
      })
      .filter((p): p is typeof p & { side: Exclude<Side, null> } => p.side !== null && p.depth > -1 && p.depth < 1 && p.x > 0 && p.x < width && p.y > 0 && p.y < height);
  }
}

const SIDES = ["right", "left", "above", "below", "unplaced"].map((side) => `cv-label-${side}`);

function sideClass(side: Side | undefined): string {
  return `cv-label-${side === undefined ? "right" : (side ?? "unplaced")}`;
}
