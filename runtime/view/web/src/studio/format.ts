// Numbers, times and names as text.

import type { RunParam, RunSummary } from "./api.ts";

/** Formats a number with about five digits. */
export function number(value: number | null | undefined): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const magnitude = Math.abs(value);
  if (magnitude >= 1e6 || magnitude < 1e-4) return value.toExponential(3).replace("e+", "e");
  return String(Number(value.toPrecision(5)));
}

/** Formats a duration in s with the precision of a prediction. */
export function seconds(time: number): string {
  if (time < 0.095) return `${Math.ceil(1e3 * time)} ms`;
  if (time < 9.5) return `${time.toFixed(1)} s`;
  if (time < 600) return `${Math.round(time)} s`;
  if (time < 7200) return `${Math.round(time / 60)} min`;
  return `${(time / 3600).toFixed(1)} h`;
}

/** Formats a number of bytes with the precision of a prediction. */
export function bytes(count: number): string {
  if (count < 1e6) return "below 1 MB";
  if (count < 1e9) return `${Math.ceil(1e-6 * count)} MB`;
  return `${(1e-9 * count).toFixed(1)} GB`;
}

/** Formats a relative error as a percentage. */
export function percent(relative: number): string {
  const value = 100 * relative;
  return value >= 1 ? `${value.toFixed(1)} %` : `${Number(value.toPrecision(1))} %`;
}

/** Formats a time, s since 1970, with its date, in the time zone of the browser. */
export function dateAndTime(started: number | null): string {
  if (started === null) return "";
  const date = new Date(1000 * started);
  return `${date.toLocaleDateString(undefined, { year: "numeric", month: "short", day: "numeric" })} ${date.toLocaleTimeString()}`;
}

/** Formats a time, s since 1970, in the time zone of the browser. */
export function time(started: number | null): string {
  if (started === null) return "";
  const date = new Date(1000 * started);
  const isToday = date.toDateString() === new Date().toDateString();
  const clock = date.toLocaleTimeString(undefined, { hour: "2-digit", minute: "2-digit" });
  return isToday ? clock : `${date.toLocaleDateString()} ${clock}`;
}

/** Title of a run. */
export function runName(id: string): string {
  if (id === "preview") return "Automatic run";
  if (id === "model") return "Run from the command line";
  if (id === "opened") return "Opened run";
  return `Run ${Number(id.replace("run-", ""))}`;
}

/** Replaces underscores by spaces. */
export function words(name: string): string {
  return name.replaceAll("_", " ");
}

/** Joins the lines of each paragraph of a doc comment. */
export function paragraphs(doc: string): string {
  return doc.replace(/([^\n])\n(?!\n)/g, "$1 ");
}

/** Last part of a path. */
export function fileName(path: string): string {
  return path.split("/").pop() ?? path;
}

/** Text and unit of a param. */
export function quantity(text: string, unit: string | undefined): string {
  return unit ? `${text} ${unit}` : text;
}

/** Value of a param of a run as it was entered; without an entered text, with few digits. */
export function enteredText({ entered, text, unit }: RunParam): string {
  if (entered !== undefined) return isPlainNumber(entered) ? quantity(entered.trim(), unit) : entered.trim();
  return quantity(isPlainNumber(text) && text.length > 8 ? number(Number(text)) : text, unit);
}

/** True for a number without a unit. */
export function isPlainNumber(text: string): boolean {
  return /^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*$/.test(text);
}

/** Number of positions of a run, "7 of 16" if it is incomplete. */
export function solvedOf(run: RunSummary): string {
  const solved = run.positions ?? 0;
  if (!run.incomplete) return run.positions === null ? "" : String(solved);
  return run.total !== null && run.total >= solved ? `${solved} of ${run.total}` : String(solved);
}

/** Number of positions of an incomplete run, with the noun. */
export function solvedPositions(run: RunSummary): string {
  const one = run.total === null ? run.positions === 1 : run.total === 1;
  return `${solvedOf(run)} ${one ? "position" : "positions"}`;
}

/** Name of an analysis setting in tables and lists. */
export function settingWords(name: string): string {
  return name === "vtu" ? "meshes with stresses" : words(name);
}

/** Value of an analysis setting in tables and lists. */
export function settingText(text: string): string {
  return text === "TRUE" ? "yes" : text === "FALSE" ? "no" : text;
}

/** True for equal texts, and for equal numbers without units. */
export function isSame(first: string, second: string): boolean {
  const [a, b] = [first.trim(), second.trim()];
  return a === b || (isPlainNumber(a) && isPlainNumber(b) && Number(a) === Number(b));
}
