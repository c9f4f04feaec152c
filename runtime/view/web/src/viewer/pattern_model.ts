// Content of the panel of the contact pattern, and the envelope over the positions.

import type { Core } from "./core.ts";
import { boundsOf, Envelope, isIncluded, loadedSide, PatternAxes, patternCells, type Bounds, type PatternCell, type PatternChoice } from "./pattern.ts";
import type { Position, Part } from "./run_data.ts";
import { toothOf, type Side } from "./tooth.ts";

/** Time after which the envelope lets the page respond, ms. */
const SLICE = 25;

export interface Pattern {
  part: Part;
  axes: PatternAxes;
  bounds: Bounds;
  /** Tooth whose cells are displayed, or null for all. */
  tooth: number | null;
  side: Side;
  cells: PatternCell[];
  envelope: Envelope | null;
  largest: number;
  /** Limits of the colours, Pa. */
  limits: [number, number];
}

export class PatternModel {
  /** Tooth of each part that the pointer was at last. */
  readonly pointed = new Map<number, number>();
  /** Cell under the pointer, in the scene or in the pattern; -1 for none. */
  hovered = -1;

  #cells: { position: Position; part: Part; choice: string; cells: PatternCell[] } | null = null;
  #envelope: Envelope | null = null;
  #key = "";
  #source: object | null = null;
  #run = 0;
  #filling = false;

  constructor(private readonly core: Core) {}

  /** Gears with contacts in the displayed position. */
  gears(): Part[] {
    const contacts = this.core.display?.position?.contacts;
    const parts = this.core.parts?.parts ?? [];
    const present = new Set(contacts?.parts);
    const chosen = this.core.state.pattern.gear;
    return parts.filter((part) => part.kind === "gear" && (present.has(part.index) || part.name === chosen));
  }

  /** Teeth with loaded cells in the displayed position. */
  teeth(part: Part): number[] {
    return [...new Set(this.cellsOf(part).map(({ tooth }) => tooth))].sort((a, b) => a - b);
  }

  /** The displayed pattern; null if no gear has contacts. */
  pattern(): Pattern | null {
    const { core } = this;
    const { display, state } = core;
    const gears = this.gears();
    const part = gears.find(({ name }) => name === state.pattern.gear) ?? gears[0];
    if (!part || !display) return null;
    const axes = new PatternAxes(toothOf(part)?.direction ?? 0, toothOf(part)?.tip);
    const all = this.cellsOf(part);
    const tooth = this.tooth(part);
    const side = state.pattern.flank === "automatic" ? loadedSide(all.filter((cell) => tooth === null || cell.tooth === tooth)) : state.pattern.flank;
    const bounds = boundsOf(part, side, axes);
    const envelope = state.pattern.envelope ? this.envelope(part, axes, bounds, { tooth, side }) : null;
    const cells = envelope ? [] : all.filter((cell) => isIncluded(cell, { tooth, side }));
    const largest = envelope?.largest ?? cells[cells.length - 1]?.pressure ?? 0;
    const limits = state.colours.field === "contact_pressure" ? display.limits : null;
    return { part, axes, bounds, tooth, side, cells, envelope, largest, limits: limits ?? [0, largest > 0 ? largest : 1] };
  }

  private tooth(part: Part): number | null {
    const { tooth } = this.core.state.pattern;
    if (tooth === "pointer") return this.pointed.get(part.index) ?? null;
    return tooth !== "all" && /^\d+$/.test(tooth) ? Number(tooth) : null;
  }

  private cellsOf(part: Part): PatternCell[] {
    const position = this.core.display?.position;
    if (!position) return [];
    const choice = this.core.state.colours.cells;
    const known = this.#cells;
    if (known?.position === position && known.part === part && known.choice === choice) return known.cells;
    const cells = patternCells(position, part, choice);
    this.#cells = { position, part, choice, cells };
    return cells;
  }

  private envelope(part: Part, axes: PatternAxes, bounds: Bounds, choice: PatternChoice): Envelope {
    const { positions, state } = this.core;
    const key = JSON.stringify([part.name, choice, state.colours.cells]);
    if (!this.#envelope || key !== this.#key || positions !== this.#source) {
      this.#envelope = new Envelope(bounds, axes);
      this.#key = key;
      this.#source = positions;
      this.#run++;
      void this.fill(this.#envelope, part, choice, this.#run);
    } else if (this.#envelope.included.size < (positions?.list.length ?? 0) && !this.#filling) {
      // The run has written more positions.
      this.#run++;
      void this.fill(this.#envelope, part, choice, this.#run);
    }
    return this.#envelope;
  }

  /** Reads the positions one after the other. */
  private async fill(envelope: Envelope, part: Part, choice: PatternChoice, run: number): Promise<void> {
    const { core } = this;
    const { positions } = core;
    const current = () => run === this.#run && positions === core.positions && core.state.panels.pattern && core.state.pattern.envelope;
    this.#filling = true;
    let slice = performance.now();
    for (let i = 0; positions && i < positions.list.length && current(); i++) {
      if (envelope.included.has(i)) continue;
      // A damaged file is reported when it is displayed.
      const position = await positions.load(i).catch(() => null);
      if (!current()) break;
      envelope.included.add(i);
      if (position) envelope.add(patternCells(position, part, core.state.colours.cells).filter((cell) => isIncluded(cell, choice)));
      if (performance.now() - slice < SLICE) continue;
      core.changed(false);
      await new Promise((resolve) => setTimeout(resolve));
      slice = performance.now();
    }
    if (run === this.#run) this.#filling = false;
    core.changed(false);
  }
}
