// Positions of a run: loaded when needed, kept in bounded memory.

import type { Part, Position } from "./run_data.ts";
import { readPosition } from "./run_data.ts";
import { positionFileName, type PositionEntry, type ViewSource } from "./source.ts";

/** Bytes of position files that are kept. */
const BUDGET = 384e6;

export class Positions {
  list: PositionEntry[] = [];
  /** Called when a position leaves the memory. */
  onEvict: ((position: Position) => void) | null = null;

  #cache = new Map<number, Position>();
  #pending = new Map<number, Promise<Position>>();
  #bytes = 0;

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
    const position = readPosition(name, await this.source.position(index), this.parts);
    this.#cache.set(index, position);
    this.#bytes += position.bytes;
    for (const [key, old] of this.#cache) {
      if (this.#bytes <= BUDGET || key === index) break;
      this.#cache.delete(key);
      this.#bytes -= old.bytes;
      this.onEvict?.(old);
    }
    return position;
  }

  dispose(): void {
    for (const position of this.#cache.values()) this.onEvict?.(position);
    this.#cache.clear();
    this.#bytes = 0;
  }
}
