// Plots of outputs over the positions, with one curve per displayed run.
//
// uPlot draws them: it is small (50 kB), draws a hundred thousand points without a delay, and its
// plots can share one cursor.

import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { Results } from "./api.ts";
import { COLOUR_COUNT, colourOf } from "./colours.ts";
import { number, runName, solvedPositions, words } from "./format.ts";
import type { Studio } from "./store.ts";
import { useColourScheme } from "./theme.ts";

type Abscissa = "cycle" | "roll_angle" | "time" | "step";
const ABSCISSAE: [Abscissa, string][] = [
  ["cycle", "Mesh cycle"],
  ["roll_angle", "Roll angle in deg"],
  ["time", "Time in s"],
  ["step", "Position"],
];
const HEIGHT = 190;
const DASHES: (number[] | undefined)[] = [undefined, [7, 4], [2, 3], [12, 3, 2, 3]];
/** Number of outputs that are plotted before the user selects some. */
const FIRST = 2;

interface Curve {
  run: string;
  colour: string;
  x: number[];
  y: (number | null)[];
}

export function Plots({ studio }: { studio: Studio }): JSX.Element | null {
  const [abscissa, setAbscissa] = useState<Abscissa>("cycle");
  const [chosen, setChosen] = useState<string[] | null>(null);
  const selected = studio.settings.selected;
  const shown = selected.flatMap((id) => studio.results[id] ?? []).filter((results) => results.steps);
  const names = outputNames(shown);
  if (names.length === 0) return null;
  const plotted = (chosen ?? names.slice(0, FIRST)).filter((name) => names.includes(name));
  const toggle = (name: string) =>
    setChosen(plotted.includes(name) ? plotted.filter((other) => other !== name) : [...plotted, name]);
  return (
    <details class="plots" open>
      <summary>
        Plots
        {shown.filter((results) => results.incomplete).map((results) => (
          <span key={results.id} class="incomplete">{runName(results.id)}: {solvedPositions(results)}</span>
        ))}
      </summary>
      <div class="plot-settings">
        <div class="chips" role="group" aria-label="Plotted outputs">
          {names.map((name) => (
            <button key={name} type="button" class="chip" aria-pressed={plotted.includes(name)} onClick={() => toggle(name)}>
              {words(name)}
            </button>
          ))}
        </div>
        {shown.some((results) => results.stride > 1) && (
          <span class="muted small-text">one of {Math.max(...shown.map((results) => results.stride))} positions</span>
        )}
        <label class="inline">
          over
          <select value={abscissa} onChange={(event) => setAbscissa(event.currentTarget.value as Abscissa)}>
            {ABSCISSAE.map(([key, label]) => <option key={key} value={key}>{label}</option>)}
          </select>
        </label>
      </div>
      <div class="plot-grid">
        {plotted.map((name) => (
          <Plot
            key={name}
            title={words(name)}
            unit={unitOf(studio, shown, name)}
            label={ABSCISSAE.find(([key]) => key === abscissa)?.[1] ?? ""}
            curves={shown.flatMap((results) => curveOf(studio, results, name, abscissa, selected.indexOf(results.id)))}
          />
        ))}
      </div>
    </details>
  );
}

const NOT_OUTPUTS = new Set(["step", "time", "cycle", "roll_angle", "point"]);

function outputNames(shown: Results[]): string[] {
  return [...new Set(shown.flatMap((results) => Object.keys(results.steps ?? {})))].filter((name) => !NOT_OUTPUTS.has(name));
}

/** Unit of display and its SI value. */
function displayOf(studio: Studio, results: Results, name: string): { unit: string; factor: number } {
  // An unfinished run describes its columns only.
  const display = results.run?.outputs?.[name]?.display ?? results.run?.columns?.[name]?.display;
  const declared = studio.model?.outputs.find((output) => output.name === name);
  return { unit: display?.unit ?? declared?.unit ?? "SI", factor: display?.factor ?? declared?.factor ?? 1 };
}

function unitOf(studio: Studio, shown: Results[], name: string): string {
  const first = shown.find((results) => results.steps?.[name]);
  return first ? displayOf(studio, first, name).unit : "";
}

function curveOf(studio: Studio, results: Results, name: string, abscissa: Abscissa, place: number): Curve[] {
  const [x, y] = [results.steps?.[abscissa], results.steps?.[name]];
  if (!x || !y) return [];
  const { factor } = displayOf(studio, results, name);
  const scale = abscissa === "roll_angle" ? 180 / Math.PI : 1;
  const order = x.map((_, index) => index).filter((index) => typeof x[index] === "number");
  order.sort((first, second) => Number(x[first]) - Number(x[second]));
  const value = (cell: unknown) => (typeof cell === "number" ? cell / factor : null);
  return [
    {
      run: runName(results.id),
      colour: colourOf(place),
      x: order.map((index) => scale * Number(x[index])),
      y: order.map((index) => value(y[index])),
    },
  ];
}

interface PlotProps {
  title: string;
  unit: string;
  label: string;
  curves: Curve[];
}

function Plot({ title, unit, label, curves }: PlotProps): JSX.Element {
  const container = useRef<HTMLDivElement>(null);
  const scheme = useColourScheme();
  const key = JSON.stringify([title, unit, label, curves, scheme]);
  useEffect(() => {
    const element = container.current;
    if (!element) return;
    const plot = new uPlot(optionsOf(element, title, unit, label, curves), dataOf(curves), element);
    const observer = new ResizeObserver(() => {
      if (element.clientWidth > 0) plot.setSize({ width: element.clientWidth, height: HEIGHT });
    });
    observer.observe(element);
    return () => {
      observer.disconnect();
      plot.destroy();
    };
  }, [key]);
  return (
    <figure class="plot">
      <figcaption>
        {title} {unit && <span class="unit">{unit}</span>}
      </figcaption>
      <div ref={container} class="canvas" role="img" aria-label={descriptionOf(title, unit, curves)} />
    </figure>
  );
}

function descriptionOf(title: string, unit: string, curves: Curve[]): string {
  const ranges = curves.map(({ run, y }) => {
    const values = y.filter((value) => value !== null);
    return `${run} from ${number(Math.min(...values))} to ${number(Math.max(...values))}`;
  });
  return `Plot of ${title}${unit && ` in ${unit}`}: ${ranges.join(", ")}`;
}

/** Curves with different abscissae are joined to one table with gaps. */
function dataOf(curves: Curve[]): uPlot.AlignedData {
  if (curves.length === 0) return [[]];
  return uPlot.join(curves.map(({ x, y }): uPlot.AlignedData => [x, y]));
}

function optionsOf(element: HTMLElement, title: string, unit: string, label: string, curves: Curve[]): uPlot.Options {
  const style = getComputedStyle(element);
  // Computed colours: a canvas does not resolve variables.
  const [text, grid] = [style.color, style.borderTopColor];
  const font = "12px system-ui, sans-serif";
  const values = (_: uPlot, splits: number[]) => splits.map((split) => String(Number(split.toPrecision(6))));
  const axis = { values, stroke: text, font, labelFont: font, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1, size: 4 } };
  return {
    width: Math.max(element.clientWidth, 100),
    height: HEIGHT,
    cursor: { sync: { key: "positions" }, points: { size: 6 } },
    legend: { live: true },
    scales: { x: { time: false } },
    axes: [{ ...axis, label, labelSize: 18, size: 34 }, { ...axis, size: 58 }],
    series: [
      { label },
      ...curves.map(({ run, colour }, index) => ({
        label: curves.length > 1 ? run : title,
        stroke: colour,
        width: 1.6,
        // Equal curves remain visible below each other, and colours that repeat differ.
        dash: DASHES[(index % 2) + 2 * (Math.floor(index / COLOUR_COUNT) % 2)],
        spanGaps: true,
        points: { show: (curves[0]?.x.length ?? 0) < 60, size: 4, fill: colour },
        value: (_: uPlot, value: number | null) => (value === null ? "–" : `${number(value)} ${unit}`),
      })),
    ],
  };
}
