// Display of SI values with units and prefixes that an engineer expects.

export interface DisplayUnit {
  /** Symbol. */
  symbol: string;
  /** Factor from the SI value to the displayed value. */
  factor: number;
}

const PREFIXED: Record<string, [number, string, number][]> = {
  // Thresholds of the absolute SI value, symbols, factors; largest first.
  Pa: [[1e6, "MPa", 1e-6], [1e3, "kPa", 1e-3], [0, "Pa", 1]],
  m: [[0.1e-3, "mm", 1e3], [0.1e-6, "µm", 1e6], [0, "nm", 1e9]],
  N: [[1e3, "kN", 1e-3], [0, "N", 1]],
  "N m": [[1e3, "kN m", 1e-3], [0, "N m", 1]],
  W: [[1e3, "kW", 1e-3], [0, "W", 1]],
  s: [[1, "s", 1], [1e-3, "ms", 1e3], [0, "µs", 1e6]],
  rad: [[0.1, "rad", 1], [1e-4, "mrad", 1e3], [0, "µrad", 1e6]],
};

const IMPERIAL: Record<string, [number, string, number][]> = {
  Pa: [[0, "psi", 1 / 6894.757293168361]],
  m: [[0, "inch", 1 / 0.0254]],
  N: [[0, "lbf", 1 / 4.4482216152605]],
  "N m": [[0, "lbf inch", 1 / 0.1129848290276167]],
};

let imperial = false;

/** Selects the units of a model: `units` of the file of parts, such as `mm_N_s` or `inch_lbf_s`. */
export function useUnitsOf(units: string): void {
  imperial = /^(inch|ft|foot)_/.test(units);
}

/** Chooses the unit in which values up to `magnitude` are displayed. */
export function displayUnit(unit: string, magnitude: number): DisplayUnit {
  const key = unit.replace("·", " ");
  const steps = (imperial ? IMPERIAL[key] : undefined) ?? PREFIXED[key];
  if (!steps) return { symbol: unit === "1" ? "" : unit, factor: 1 };
  const size = Math.abs(magnitude);
  // Zero and NaN say nothing about the magnitude; the largest unit is the usual one.
  if (!(size > 0)) return { symbol: steps[0]![1], factor: steps[0]![2] };
  const step = steps.find(([threshold]) => size >= threshold) ?? steps[steps.length - 1]!;
  return { symbol: step[1], factor: step[2] };
}

/** Unit of stresses, which is the same for all magnitudes. */
export function stressUnit(): DisplayUnit {
  return displayUnit("Pa", 0);
}

export const MINUS = "−";

/** Formats a number with significant digits, without an exponent where that stays readable. */
export function formatNumber(value: number, digits = 4): string {
  if (Number.isNaN(value)) return "no value";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text: string;
  if (size >= 1e6 || size < 1e-4) {
    text = value.toExponential(digits - 1).replace("e+", "e");
  } else {
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    text = value.toFixed(Math.min(decimals, 12));
    if (text.includes(".")) text = text.replace(/\.?0+$/, "");
  }
  return text.replaceAll("-", MINUS);
}

/** Formats an SI value with the unit that suits its magnitude. */
export function formatValue(value: number, unit: string, digits = 4): string {
  if (!Number.isFinite(value)) return "no value";
  const display = displayUnit(unit, value);
  return `${formatNumber(value * display.factor, digits)} ${display.symbol}`.trim();
}

/** Largest of 1, 2 and 5 times a power of ten that does not exceed the value. */
export function roundDown125(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return value;
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  const step = lead >= 5 ? 5 : lead >= 2 ? 2 : 1;
  return Number((step * power).toPrecision(3));
}
