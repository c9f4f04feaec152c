// Numbers of the legend.

import type { Core } from "./core.ts";
import { FIELDS } from "./fields.ts";
import { scaleTicks } from "./ticks.ts";
import { displayUnit, formatNumber, stressUnit, type DisplayUnit } from "./units.ts";

export interface Tick {
  /** Location on the scale, 0 at the lower end. */
  fraction: number;
  text: string;
}

/** Unit of the selected field. Stresses have one unit; displacements have a suitable prefix. */
export function fieldUnit(core: Core): DisplayUnit {
  const { field } = core.state.colours;
  if (FIELDS[field].quantity === "stress") return stressUnit();
  if (FIELDS[field].quantity === "none") return { symbol: "", factor: 1 };
  const limits = core.display?.limits;
  return displayUnit("m", limits ? Math.max(Math.abs(limits[0]), Math.abs(limits[1])) : 0);
}

export function legendTitle(core: Core): string {
  return FIELDS[core.state.colours.field].label;
}

/** Ticks at the ends and at round numbers, or at the borders of the bands if there are few. */
export function legendTicks(core: Core): { ticks: Tick[]; unit: string } {
  const unit = fieldUnit(core);
  const limits = core.display?.limits;
  if (!limits) return { ticks: [], unit: unit.symbol };
  const { bands } = core.state.colours;
  const low = limits[0] * unit.factor;
  const high = limits[1] * unit.factor;
  if (low === high) return { ticks: [{ fraction: 0.5, text: formatNumber(low) }], unit: unit.symbol };
  const values = bands > 0 && bands <= 12
    ? Array.from({ length: bands + 1 }, (_, i) => low + (i / bands) * (high - low))
    : scaleTicks(low, high, 5);
  const ticks = values.map((value) => ({
    fraction: (value - low) / (high - low),
    // Cancellation must not turn zero into a tiny number.
    text: formatNumber(Math.abs(value) < 1e-9 * Math.abs(high - low) ? 0 : value, 4),
  }));
  return { ticks, unit: unit.symbol };
}
