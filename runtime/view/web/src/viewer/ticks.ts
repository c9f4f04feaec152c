// Round numbers at scales.

/** Multiples of 1, 2 or 5 times a power of ten in a range, about `wanted` of them. */
export function roundTicks(low: number, high: number, wanted: number): number[] {
  const raw = (high - low) / Math.max(wanted, 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw) ?? 10 * power;
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) ticks.push(i * step);
  return ticks;
}

/** Share of a scale within which a round number would touch the number at the end. */
const CROWDED = 0.09;

/** Both ends of a scale and round numbers between them. */
export function scaleTicks(low: number, high: number, wanted: number): number[] {
  const margin = CROWDED * (high - low);
  return [low, ...roundTicks(low, high, wanted).filter((tick) => tick > low + margin && tick < high - margin), high];
}
