// Positions of a run: loaded when needed, kept in bounded memory.

import { acquireMesh, releaseMeshes } from "./mesh_cache.ts";
import type { Part, Position } from "./run_data.ts";
import { readPosition } from "./run_data.ts";
import { positionFileName, type PositionEntry, type ViewSource } from "./source.ts";

/** Bytes of position files that are kept. */
const BUDGET = 384e6;

export class Positions {
  list: PositionEntry[] = [];

  #cache = new Map<number, Position>();
  #pending = new Map<number, Promise<Position>>();
  #bytes = 0;
  #disposed = false;

  constructor(
    private readonly source: ViewSource,
    private readonly parts: Part[],
  ) {}

  async update(): Promise<void> {
    this.list = await this.source.positions();
  }

  /** Position that is in memory. */
  cached(index: number): Position | undefined {
    return this.#cache.get(index);
  }

  load(index: number): Promise<Position> {
    const known = this.#cache.get(index);
    if (known) {
      // The order of the map is the order of use.
      this.#cache.delete(index);
      this.#cache.set(index, known);
      return Promise.resolve(known);
    }
    const pending = this.#pending.get(index);
    if (pending) return pending;
    const promise = this.read(index).finally(() => this.#pending.delete(index));
    this.#pending.set(index, promise);
    return promise;
  }

  private async read(index: number): Promise<Position> {
    const entry = this.list[index];
    const name = positionFileName(entry?.position ?? index);
    const position = await readPosition(name, await this.source.position(index), this.parts, (mesh) =>
      acquireMesh(mesh, this, async (file) => {
        if (!this.source.mesh) throw new Error(`${file}: this source contains no meshes`);
        return this.source.mesh(file);
      }),
    );
    if (this.#disposed) releaseMeshes(this);
    // A mesh that cannot be read now may be readable later: the position is not kept.
    if (this.#disposed || position.problem) return position;
    this.#cache.set(index, position);
    this.#bytes += position.bytes;
    for (const [key, old] of this.#cache) {
      if (this.#bytes <= BUDGET || key === index) break;
      this.#cache.delete(key);
      this.#bytes -= old.bytes;
    }
    return position;
  }

  dispose(): void {
    this.#disposed = true;
    releaseMeshes(this);
    this.#cache.clear();
    this.#bytes = 0;
  }
}
