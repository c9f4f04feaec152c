// Contact pattern: loaded cells on an unrolled flank of a gear.

import { isChosen } from "./contacts.ts";
import type { Part, Position } from "./run_data.ts";
import type { CellChoice } from "./state.ts";
import { evaluate, toothOf, type Side } from "./tooth.ts";

/** A loaded cell in coordinates of the gear. */
export interface PatternCell {
  /** Index among the contacts of the position. */
  cell: number;
  tooth: number;
  side: Side;
  pressure: number;
  /** z and radius of the four corners alternate. */
  corners: number[];
}

export interface PatternChoice {
  /** Number of a tooth, or null for all of them. */
  tooth: number | null;
  side: Side;
}

/** Loaded cells of a gear in a position, by ascending pressure: drawn in this order, the largest one is on top. */
export function patternCells(position: Position, part: Part, choice: CellChoice): PatternCell[] {
  const { contacts, poses } = position;
  if (!contacts) return [];
  const pose = poses.subarray(12 * part.index, 12 * part.index + 12);
  const tooth = toothOf(part);
  const cells: (PatternCell & { surface: number; offset: number })[] = [];
  for (let c = 0; c < contacts.count; c++) {
    const pressure = contacts.pressures[c]!;
    if (!(pressure > 0) || !isChosen(contacts, c, choice)) continue;
    for (let end = 0; end < 2; end++) {
      if (contacts.parts[2 * c + end] !== part.index) continue;
      const corners: number[] = [];
      let [mx, my] = [0, 0];
      for (let k = 0; k < 4; k++) {
        const p = inPart(pose, contacts.corners.subarray(12 * c + 3 * k, 12 * c + 3 * k + 3));
        corners.push(p[2], Math.hypot(p[0], p[1]));
        mx += p[0] / 4;
        my += p[1] / 4;
      }
      const [z, r] = middle(corners);
      const number = contacts.teeth[2 * c + end]!;
      const centre = tooth ? (evaluate(tooth.flanks.left.angle, z, r) + evaluate(tooth.flanks.right.angle, z, r)) / 2 : 0;
      const angle = Math.atan2(my, mx) - (2 * Math.PI * number) / part.copies - centre;
      const offset = Math.atan2(Math.sin(angle), Math.cos(angle));
      cells.push({ cell: c, tooth: number, side: "left", pressure, corners, surface: contacts.surfaces[2 * c + end]!, offset });
    }
  }
  // All cells of a surface are on one side of the tooth, also cells at the tip edge close to its middle.
  const sums = new Map<string, number>();
  const keyOf = (cell: { tooth: number; surface: number }) => `${cell.tooth} ${cell.surface}`;
  for (const cell of cells) sums.set(keyOf(cell), (sums.get(keyOf(cell)) ?? 0) + cell.pressure * cell.offset);
  return cells
    .map(({ surface, offset: _, ...cell }) => ({ ...cell, side: (sums.get(keyOf({ ...cell, surface }))! >= 0 ? "left" : "right") as Side }))
    .sort((a, b) => a.pressure - b.pressure);
}

/** Coordinates of the part of a point in ground coordinates. */
function inPart(pose: Float64Array, p: Float32Array): [number, number, number] {
  const [x, y, z] = [p[0]! - pose[9]!, p[1]! - pose[10]!, p[2]! - pose[11]!];
  return [
    pose[0]! * x + pose[3]! * y + pose[6]! * z,
    pose[1]! * x + pose[4]! * y + pose[7]! * z,
    pose[2]! * x + pose[5]! * y + pose[8]! * z,
  ];
}

function middle(corners: number[]): [number, number] {
  return [(corners[0]! + corners[2]! + corners[4]! + corners[6]!) / 4, (corners[1]! + corners[3]! + corners[5]! + corners[7]!) / 4];
}

/** The flank with the larger sum of pressure times area in the axial section. */
export function loadedSide(cells: PatternCell[]): Side {
  let difference = 0;
  for (const { side, pressure, corners: c } of cells) {
    const area = Math.abs((c[4]! - c[0]!) * (c[7]! - c[3]!) - (c[5]! - c[1]!) * (c[6]! - c[2]!)) / 2;
    difference += (side === "left" ? 1 : -1) * pressure * area;
  }
  return difference >= 0 ? "left" : "right";
}

export function isIncluded(cell: PatternCell, { tooth, side }: PatternChoice): boolean {
  return cell.side === side && (tooth === null || cell.tooth === tooth);
}

/**
 * Axes of the picture: along the face and across it. Those of conical gears, whose direction is not 0,
 * point from the toe to the heel and from the root to the tip.
 */
export class PatternAxes {
  readonly cos: number;
  readonly sin: number;
  readonly #along: 1 | -1;
  readonly #across: 1 | -1;

  /** The tip is at larger coordinates across the face, or at smaller ones if `tip` is -1. */
  constructor(readonly direction: number, readonly tip: 1 | -1 = 1) {
    this.cos = Math.cos(direction);
    this.sin = Math.sin(direction);
    this.#along = this.sin < 0 ? -1 : 1;
    this.#across = direction === 0 ? 1 : tip;
  }

  along(z: number, r: number): number {
    return this.#along * (this.cos * z + this.sin * r);
  }

  across(z: number, r: number): number {
    return this.#across * (this.cos * r - this.sin * z);
  }

  /** z and radius of a point of the picture. */
  inverse(u: number, v: number): [number, number] {
    const [a, b] = [this.#along * u, this.#across * v];
    return [this.cos * a - this.sin * b, this.sin * a + this.cos * b];
  }

  /** Names of the ends of the picture: left, right, bottom and top. */
  get ends(): [string, string, string, string] {
    if (this.direction !== 0) return ["toe", "heel", "root", "tip"];
    return this.tip > 0 ? ["−z end", "+z end", "root", "tip"] : ["−z end", "+z end", "tip", "root"];
  }
}

export interface Bounds {
  u0: number;
  u1: number;
  v0: number;
  v1: number;
}

/** Bounds of a flank, or of the part's points if it has no teeth. */
export function flankBounds(part: Part, side: Side, axes: PatternAxes): Bounds {
  const bounds = { u0: Infinity, u1: -Infinity, v0: Infinity, v1: -Infinity };
  const include = (z: number, r: number) => {
    const [u, v] = [axes.along(z, r), axes.across(z, r)];
    bounds.u0 = Math.min(bounds.u0, u);
    bounds.u1 = Math.max(bounds.u1, u);
    bounds.v0 = Math.min(bounds.v0, v);
    bounds.v1 = Math.max(bounds.v1, v);
  };
  const outline = toothOf(part)?.flanks[side].outline ?? [];
  for (const loop of outline) for (let i = 0; i < loop.length; i += 2) include(loop[i]!, loop[i + 1]!);
  if (outline.length === 0) {
    const p = part.points;
    for (let i = 0; i < p.length; i += 3) include(p[i + 2]!, Math.hypot(p[i]!, p[i + 1]!));
  }
  if (!(bounds.u1 > bounds.u0) || !(bounds.v1 > bounds.v0)) return { u0: -1e-3, u1: 1e-3, v0: 0, v1: 1e-3 };
  return bounds;
}

/** Bounds of the picture of a flank. */
export function boundsOf(part: Part, side: Side, axes: PatternAxes): Bounds {
  const bounds = flankBounds(part, side, axes);
  // Cells reach beyond the flank at rounded edges.
  const margin = 0.03 * Math.max(bounds.u1 - bounds.u0, bounds.v1 - bounds.v0);
  return { u0: bounds.u0 - margin, u1: bounds.u1 + margin, v0: bounds.v0 - margin, v1: bounds.v1 + margin };
}

/** Returns whether a point is in a cell. */
export function contains(corners: number[], z: number, r: number): boolean {
  let [positive, negative] = [false, false];
  for (let k = 0; k < 8; k += 2) {
    const [x0, y0, x1, y1] = [corners[k]!, corners[k + 1]!, corners[(k + 2) % 8]!, corners[(k + 3) % 8]!];
    const side = (x1 - x0) * (r - y0) - (y1 - y0) * (z - x0);
    if (side > 0) positive = true;
    if (side < 0) negative = true;
  }
  return !(positive && negative);
}

/** The cell with the largest pressure at a point; null if there is none. */
export function cellAt(cells: PatternCell[], z: number, r: number): PatternCell | null {
  for (let i = cells.length - 1; i >= 0; i--) if (contains(cells[i]!.corners, z, r)) return cells[i]!;
  return null;
}

/** Largest pressure over positions, on a grid over the flank. */
export class Envelope {
  readonly columns: number;
  readonly rows: number;
  readonly values: Float32Array;
  /** Positions that are included. */
  readonly included = new Set<number>();
  largest = 0;

  constructor(
    readonly bounds: Bounds,
    private readonly axes: PatternAxes,
    columns = 320,
  ) {
    this.columns = columns;
    this.rows = Math.min(Math.max(Math.round((columns * (bounds.v1 - bounds.v0)) / (bounds.u1 - bounds.u0)), 40), 640);
    this.values = new Float32Array(this.columns * this.rows);
  }

  private column(u: number): number {
    return ((u - this.bounds.u0) / (this.bounds.u1 - this.bounds.u0)) * this.columns;
  }

  private row(v: number): number {
    return ((v - this.bounds.v0) / (this.bounds.v1 - this.bounds.v0)) * this.rows;
  }

  add(cells: readonly PatternCell[]): void {
    const { columns, rows, values } = this;
    for (const { corners, pressure } of cells) {
      this.largest = Math.max(this.largest, pressure);
      const grid: number[] = [];
      for (let k = 0; k < 8; k += 2) {
        const [z, r] = [corners[k]!, corners[k + 1]!];
        grid.push(this.column(this.axes.along(z, r)), this.row(this.axes.across(z, r)));
      }
      const us = [grid[0]!, grid[2]!, grid[4]!, grid[6]!];
      const vs = [grid[1]!, grid[3]!, grid[5]!, grid[7]!];
      let found = false;
      const set = (i: number, j: number) => {
        found = true;
        if (i < 0 || j < 0 || i >= columns || j >= rows) return;
        const at = j * columns + i;
        if (pressure > values[at]!) values[at] = pressure;
      };
      for (let j = Math.max(0, Math.floor(Math.min(...vs))); j <= Math.min(rows - 1, Math.floor(Math.max(...vs))); j++) {
        for (let i = Math.max(0, Math.floor(Math.min(...us))); i <= Math.min(columns - 1, Math.floor(Math.max(...us))); i++) {
          if (contains(grid, i + 0.5, j + 0.5)) set(i, j);
        }
      }
      // A cell between the middles of the squares colours the square that contains its own middle.
      if (!found) set(Math.floor(us.reduce((a, b) => a + b) / 4), Math.floor(vs.reduce((a, b) => a + b) / 4));
    }
  }

  /** Value at a point of the picture; 0 where no contact was loaded. */
  at(u: number, v: number): number {
    const [i, j] = [Math.floor(this.column(u)), Math.floor(this.row(v))];
    if (i < 0 || j < 0 || i >= this.columns || j >= this.rows) return 0;
    return this.values[j * this.columns + i]!;
  }
}
