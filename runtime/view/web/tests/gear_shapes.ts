// Shapes of the fixtures: spur gears with involute teeth, cylinders and rings.

export interface Shape {
  points: number[];
  triangles: number[];
  edges: number[];
}

const ALPHA = (20 * Math.PI) / 180;
export const involute = (angle: number) => Math.tan(angle) - angle;

export interface GearData {
  teeth: number;
  module: number;
  width: number;
  bore: number;
}

export const baseRadius = ({ teeth, module }: GearData) => 0.5 * module * teeth * Math.cos(ALPHA);

/** Half of the angle of a tooth at a radius. */
export function halfAngle(gear: GearData, radius: number): number {
  const ratio = Math.min(1, baseRadius(gear) / radius);
  return Math.PI / (2 * gear.teeth) + involute(ALPHA) - involute(Math.acos(ratio));
}

/** Profile of one tooth between the middles of two gaps, as polar coordinates. */
function profile(gear: GearData, detail: number): [number, number][] {
  const { teeth, module } = gear;
  const pitch = 0.5 * module * teeth;
  const tip = pitch + module;
  const root = pitch - 1.25 * module;
  const start = Math.max(baseRadius(gear), root + 0.3 * module);
  const half: [number, number][] = [];
  const seam = Math.PI / teeth;
  const foot = halfAngle(gear, start);
  // A fillet between the root circle and the flank.
  const width = Math.min(0.35 * module, (seam - foot) * root * 0.9);
  const filletAngle = foot + width / root;
  for (let i = 0; i < 2; i++) half.push([root, seam + (i / 2) * (filletAngle - seam)]);
  for (let i = 0; i <= detail; i++) {
    const t = (0.5 * Math.PI * i) / detail;
    half.push([root + (start - root) * (1 - Math.cos(t)), filletAngle + (foot - filletAngle) * Math.sin(t)]);
  }
  for (let i = 1; i <= 2 * detail; i++) {
    const radius = start + ((tip - start) * i) / (2 * detail);
    half.push([radius, halfAngle(gear, radius)]);
  }
  half.push([tip, 0]);
  const mirrored = half.slice(0, -1).map(([r, a]): [number, number] => [r, -a]);
  return [...mirrored, ...half.reverse()];
}

/** One sector of a gear. `layers` and `radial` are numbers of elements along the face and radially. */
export function gearSector(gear: GearData, detail = 4, layers = 6, radial = 4): Shape {
  const outer = profile(gear, detail);
  const columns = outer.length;
  const points: number[] = [];
  const triangles: number[] = [];
  const edges: number[] = [];
  const seam = Math.PI / gear.teeth;
  const add = (radius: number, angle: number, z: number) => {
    points.push(radius * Math.cos(angle), radius * Math.sin(angle), z);
    return points.length / 3 - 1;
  };
  const quad = (a: number, b: number, c: number, d: number) => {
    triangles.push(a, b, c, a, c, d);
    edges.push(a, b, b, c);
  };
  // Rings of nodes: flank nodes for each layer, bore nodes for each layer, faces in between.
  const flank: number[][] = [];
  const bore: number[][] = [];
  for (let k = 0; k <= layers; k++) {
    const z = gear.width * (k / layers - 0.5);
    flank.push(outer.map(([r, a]) => add(r, a, z)));
    bore.push(outer.map((_, i) => add(gear.bore, -seam + (2 * seam * i) / (columns - 1), z)));
  }
  for (let k = 0; k < layers; k++) {
    for (let i = 0; i + 1 < columns; i++) {
      quad(flank[k]![i]!, flank[k]![i + 1]!, flank[k + 1]![i + 1]!, flank[k + 1]![i]!);
      quad(bore[k]![i + 1]!, bore[k]![i]!, bore[k + 1]![i]!, bore[k + 1]![i + 1]!);
    }
  }
  for (const [k, side] of [[0, -1], [layers, 1]] as const) {
    const z = gear.width * (k / layers - 0.5);
    let previous = bore[k]!;
    for (let j = 1; j <= radial; j++) {
      const t = j / radial;
      const row =
        j === radial
          ? flank[k]!
          : outer.map(([r, a], i) => {
              const inner = -seam + (2 * seam * i) / (columns - 1);
              return add(gear.bore + t * (r - gear.bore), inner + t * (a - inner), z);
            });
      for (let i = 0; i + 1 < columns; i++) {
        if (side > 0) quad(previous[i]!, row[i]!, row[i + 1]!, previous[i + 1]!);
        else quad(previous[i + 1]!, row[i + 1]!, row[i]!, previous[i]!);
      }
      previous = row;
    }
  }
  return { points, triangles, edges };
}

/** A solid of revolution about the z axis from a closed outline of radius and z, counter-clockwise. */
export function revolve(outline: [number, number][], segments = 48): Shape {
  const points: number[] = [];
  const triangles: number[] = [];
  const edges: number[] = [];
  const n = outline.length;
  for (let s = 0; s < segments; s++) {
    const angle = (2 * Math.PI * s) / segments;
    for (const [r, z] of outline) points.push(r * Math.cos(angle), r * Math.sin(angle), z);
  }
  for (let s = 0; s < segments; s++) {
    const next = ((s + 1) % segments) * n;
    for (let i = 0; i < n; i++) {
      const j = (i + 1) % n;
      const [a, b, c, d] = [s * n + i, next + i, next + j, s * n + j];
      if (outline[i]![0] > 0) triangles.push(a, b, c);
      if (outline[j]![0] > 0) triangles.push(a, c, d);
      edges.push(a, b, a, d);
    }
  }
  return { points, triangles, edges };
}

export const cylinder = (radius: number, z0: number, z1: number) =>
  revolve([[0, z0], [radius, z0], [radius, z1], [0, z1]]);

export const ring = (inner: number, outer: number, z0: number, z1: number) =>
  revolve([[inner, z0], [outer, z0], [outer, z1], [inner, z1]]);
