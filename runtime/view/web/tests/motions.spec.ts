// Displacements of bearings and rigid shafts, from the motions of their bodies.

import { expect, test } from "@playwright/test";
import { hasStresses, readPosition, type Part } from "../src/viewer/run_data.ts";
import { ArrayWriter } from "./array_writer.ts";

const none = new Uint32Array();
/** A point on the inner ring, one on an element and one on the outer ring. */
const bearing: Part = {
  index: 0, name: "bearing", kind: "bearing", copies: 1, withoutMesh: 0, open: false,
  points: Float32Array.from([0, 2, 1, 0, 3, 1, 0, 4, 1]),
  triangles: Uint32Array.from([0, 1, 2]), edges: none,
  withOuter: Float32Array.from([0, 0.5, 1]),
};

function position(parts: number[], at: number[], motions: number[]) {
  const writer = new ArrayWriter();
  const file = writer.finish({
    poses: writer.add("f64", 12, Array(12).fill(0)),
    meshes: [],
    motions: { parts: writer.add("u32", 1, parts), at: writer.add("f32", 3, at), motions: writer.add("f32", 12, motions) },
  });
  return readPosition("position-0000.bin", file.buffer as ArrayBuffer, [bearing], async () => Promise.reject(new Error("no meshes")));
}

test("the rings of a bearing move with their bodies, and its elements by the mean", async () => {
  // The inner ring is translated and rotated about x at z = 1, the outer ring is translated along z.
  const read = await position([0], [0, 0, 1], [1, 2, 3, 10, 0, 0, 0, 0, 8, 0, 0, 0]);
  expect(read.meshes.length).toBe(1);
  expect(hasStresses(read)).toBe(false);
  const inner = (y: number) => [1, 2, 3 + 10 * y];
  const mean = inner(3).map((v, k) => 0.5 * (v + [0, 0, 8][k]!));
  expect([...read.meshes[0]!.displacements]).toEqual([...inner(2), ...mean, 0, 0, 8]);
});

test("motions of parts that do not exist are refused", async () => {
  await expect(position([1], [0, 0, 0], Array(12).fill(0))).rejects.toThrow("motions: the part does not exist");
  await expect(position([0], [0, 0, 0, 0, 0, 0], Array(12).fill(0))).rejects.toThrow("motions: the arrays have different lengths");
});
