// A synthetic run with cells of the volume: unit cubes of tetrahedra, wedges and hexahedra with linear
// fields, for which sections have a closed form.

import { ArrayWriter, meshFile, type MeshContent } from "./array_writer.ts";
import type { Fixture } from "./fixture.ts";

/** Corners of a grid cell, around the lower face before the upper one. */
const CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] as const;
/** Tetrahedra about the diagonal from corner 0 to corner 6, which fit those of the neighbours. */
const TETRAHEDRA = [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]] as const;
const WEDGES = [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]] as const;

export type CellKind = "tetrahedra" | "wedges" | "hexahedra";

/** A box of n³ grid cells from the origin, and its outer surface. */
export function box(kind: CellKind, n: number, size: [number, number, number] = [1, 1, 1]): MeshContent & { points: number[] } {
  const m = n + 1;
  const node = (i: number, j: number, k: number) => (k * m + j) * m + i;
  const points: number[] = [];
  for (let k = 0; k < m; k++) for (let j = 0; j < m; j++) for (let i = 0; i < m; i++) points.push((size[0] * i) / n, (size[1] * j) / n, (size[2] * k) / n);
  const cells: number[] = [];
  for (let k = 0; k < n; k++) {
    for (let j = 0; j < n; j++) {
      for (let i = 0; i < n; i++) {
        const at = CORNERS.map(([a, b, c]) => node(i + a, j + b, k + c));
        if (kind === "hexahedra") cells.push(...at);
        else for (const cell of kind === "wedges" ? WEDGES : TETRAHEDRA) cells.push(...cell.map((corner) => at[corner]!));
      }
    }
  }
  const triangles: number[] = [];
  const quad = (a: number, b: number, c: number, d: number) => triangles.push(a, b, c, a, c, d);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      quad(node(i, j, 0), node(i, j + 1, 0), node(i + 1, j + 1, 0), node(i + 1, j, 0));
      quad(node(i, j, n), node(i + 1, j, n), node(i + 1, j + 1, n), node(i, j + 1, n));
      quad(node(i, 0, j), node(i + 1, 0, j), node(i + 1, 0, j + 1), node(i, 0, j + 1));
      quad(node(i, n, j), node(i, n, j + 1), node(i + 1, n, j + 1), node(i + 1, n, j));
      quad(node(0, i, j), node(0, i, j + 1), node(0, i + 1, j + 1), node(0, i + 1, j));
      quad(node(n, i, j), node(n, i + 1, j), node(n, i + 1, j + 1), node(n, i, j + 1));
    }
  }
  return { points, triangles, [kind]: cells };
}

/** Uniaxial stress of the cubes, and their stress error. */
export const linearStress = (x: number, y: number, z: number): number => 1e8 * (1 + x + 2 * y + 3 * z);
export const linearError = (x: number, y: number, z: number): number => 1e6 * (1 + 2 * x + y + z);
/** Displacement of the cubes: a uniform strain along z. */
export const STRAIN = 0.01;

/** Three cubes side by side along x, of each kind of cell. */
export function cubes(n = 3): Fixture {
  const kinds: CellKind[] = ["tetrahedra", "wedges", "hexahedra"];
  const parts = new ArrayWriter();
  const position = new ArrayWriter();
  const meshes: Record<string, Uint8Array> = {};
  const list: object[] = [];
  const displayed = kinds.map((kind, part) => {
    const content = box(kind, n);
    const { points } = content;
    list.push({
      name: kind, kind: "shaft", copies: 1, open: false,
      points: parts.add("f32", 3, points),
      triangles: parts.add("u32", 3, content.triangles!),
      edges: parts.add("u32", 2, []),
    });
    const { name, data } = meshFile(content);
    meshes[name] = data;
    const rows = Array.from({ length: points.length / 3 }, (_, i) => points.slice(3 * i, 3 * i + 3) as [number, number, number]);
    return {
      mesh: name, part, copy: 0,
      displacements: position.add("f32", 3, rows.flatMap(([, , z]) => [0, 0, STRAIN * z])),
      stresses: position.add("f32", 6, rows.flatMap((p) => [linearStress(...p), 0, 0, 0, 0, 0])),
      stress_errors: position.add("f32", 1, rows.map((p) => linearError(...p))),
    };
  });
  const header = {
    position: 0, time: 0, forces: [], meshes: displayed,
    poses: position.add("f64", 12, kinds.flatMap((_, i) => [1, 0, 0, 0, 1, 0, 0, 0, 1, 1.5 * i, 0, 0])),
  };
  return {
    parts: parts.finish({ model: "cubes.cx", units: "mm_N_s", parts: list }),
    positions: [{ position: 0, time: 0, data: position.finish(header) }],
    meshes,
    meshPoints: box("hexahedra", n).points,
  };
}
