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

/** Chooses the unit in which values up to `magnitude` are displayed. */
export function displayUnit(unit: string, magnitude: number): DisplayUnit {
  const steps = PREFIXED[unit.replace("·", " ")];
  if (!steps) return { symbol: unit === "1" ? "" : unit, factor: 1 };
  const size = Math.abs(magnitude);
  // Zero and NaN say nothing about the magnitude; the largest unit is the usual one.
  if (!(size > 0)) return { symbol: steps[0]![1], factor: steps[0]![2] };
  const step = steps.find(([threshold]) => size >= threshold) ?? steps[steps.length - 1]!;
  return { symbol: step[1], factor: step[2] };
}

export const STRESS: DisplayUnit = { symbol: "MPa", factor: 1e-6 };
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
