// Writes array files as the program does, for fixtures.

import { createHash } from "node:crypto";

/** Version of the format. */
const VERSION = 5;

interface Block {
  bytes: Uint8Array;
  offset: number;
}

export class ArrayWriter {
  #blocks: Block[] = [];
  #size = 0;

  add(type: "f32" | "f64" | "u32", components: number, values: ArrayLike<number>) {
    const array =
      type === "f32" ? Float32Array.from(values) : type === "f64" ? Float64Array.from(values) : Uint32Array.from(values);
    const offset = this.#size;
    this.#blocks.push({ bytes: new Uint8Array(array.buffer), offset });
    this.#size += Math.ceil(array.byteLength / 8) * 8;
    return { type, components, count: values.length / components, offset };
  }

  finish(header: object): Uint8Array {
    let text = new TextEncoder().encode(JSON.stringify(header));
    const length = Math.ceil(text.length / 8) * 8;
    const padded = new Uint8Array(length).fill(32);
    padded.set(text);
    text = padded;
    const file = new Uint8Array(16 + length + this.#size);
    file.set(new TextEncoder().encode("CALYXARR"));
    const view = new DataView(file.buffer);
    view.setUint32(8, VERSION, true);
    view.setUint32(12, length, true);
    file.set(text, 16);
    for (const { bytes, offset } of this.#blocks) file.set(bytes, 16 + length + offset);
    return file;
  }
}

export interface MeshContent {
  points: ArrayLike<number>;
  triangles?: ArrayLike<number>;
  edges?: ArrayLike<number>;
  tetrahedra?: ArrayLike<number>;
  wedges?: ArrayLike<number>;
  hexahedra?: ArrayLike<number>;
}

/** A file of a mesh and its name, which contains a checksum of the content. */
export function meshFile(mesh: MeshContent): { name: string; data: Uint8Array } {
  const writer = new ArrayWriter();
  const data = writer.finish({
    open: false,
    points: writer.add("f32", 3, mesh.points),
    triangles: writer.add("u32", 3, mesh.triangles ?? []),
    edges: writer.add("u32", 2, mesh.edges ?? []),
    tetrahedra: writer.add("u32", 4, mesh.tetrahedra ?? []),
    wedges: writer.add("u32", 6, mesh.wedges ?? []),
    hexahedra: writer.add("u32", 8, mesh.hexahedra ?? []),
  });
  return { name: `mesh-${createHash("sha256").update(data).digest("hex").slice(0, 16)}.bin`, data };
}
