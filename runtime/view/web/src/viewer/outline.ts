// Outlines in small views: lines with fewer points.
//
// The depth of a line that is shorter than a pixel is extrapolated over that pixel. Such a line may appear
// in front of the surface that hides it, as a dark pixel. Consecutive short lines therefore become one.

import * as THREE from "three";

/** Shortest line of an outline in pixels, except for lines between corners. */
const SHORTEST = 2;

/** Removes points of lines that are closer to each other than `shortest`. Ends, corners and crossings remain. */
export function simplified(lines: Uint32Array, points: ArrayLike<number>, shortest: number): Uint32Array {
  const place = (n: number) => [points[3 * n]!, points[3 * n + 1]!, points[3 * n + 2]!] as const;
  const distance = (a: number, b: number) => Math.hypot(...place(a).map((v, k) => v - place(b)[k]!));
  const neighbours = new Map<number, number[]>();
  const join = (a: number, b: number) => neighbours.get(a)?.push(b) ?? neighbours.set(a, [b]);
  for (let i = 0; i < lines.length; i += 2) {
    join(lines[i]!, lines[i + 1]!);
    join(lines[i + 1]!, lines[i]!);
  }
  const isFixed = (n: number) => {
    const [a, b, ...more] = neighbours.get(n)!;
    if (a === undefined || b === undefined || more.length > 0) return true;
    const [p, q, r] = [place(a), place(n), place(b)];
    const dot = [0, 1, 2].reduce((sum, k) => sum + (q[k]! - p[k]!) * (r[k]! - q[k]!), 0);
    return dot < CORNER * distance(a, n) * distance(n, b);
  };
  const done = new Set<string>();
  const key = (a: number, b: number) => (a < b ? `${a} ${b}` : `${b} ${a}`);
  const result: number[] = [];
  /** Follows a line from a point to the next fixed point, or around a closed line. */
  const follow = (start: number, second: number) => {
    let [kept, previous, at] = [start, start, second];
    for (;;) {
      if (done.has(key(previous, at))) return;
      done.add(key(previous, at));
      const isEnd = at === start || isFixed(at);
      if (isEnd || distance(kept, at) >= shortest) {
        result.push(kept, at);
        kept = at;
      }
      if (isEnd) return;
      const next = neighbours.get(at)!.find((other) => other !== previous);
      if (next === undefined) return;
      [previous, at] = [at, next];
    }
  };
  const nodes = [...neighbours.keys()];
  for (const n of [...nodes.filter(isFixed), ...nodes]) for (const other of neighbours.get(n)!) follow(n, other);
  return Uint32Array.from(result);
}

/** Cosine of the angle from which a line has a corner: 40°. */
const CORNER = Math.cos((40 * Math.PI) / 180);

/** Exponent of two of the shortest line of the finest level: a nanometre. */
const FINEST = -30;

/** Outline of a surface for views of any size. */
export class Outline {
  #levels = new Map<number, THREE.BufferAttribute>();

  constructor(
    private readonly lines: Uint32Array,
    private readonly points: ArrayLike<number>,
  ) {}

  /** Index of the lines in a view with `scale` pixels per metre. */
  index(scale: number): THREE.BufferAttribute {
    // Levels differ by factors of two, so that a zoom computes few of them.
    const level = Math.max(FINEST, Math.ceil(Math.log2(SHORTEST / scale)));
    let index = this.#levels.get(level);
    if (!index) this.#levels.set(level, (index = new THREE.BufferAttribute(simplified(this.lines, this.points, 2 ** level), 1)));
    return index;
  }
}
