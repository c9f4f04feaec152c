// Tables of outputs: of one run with estimated errors, or of compared runs.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { OutputSummary, Results } from "./api.ts";
import { colourOf } from "./colours.ts";
import { number, paragraphs, percent, runName, words } from "./format.ts";
import type { Studio } from "./store.ts";

type Statistic = "max" | "mean" | "min" | "peak_to_peak";
const STATISTICS: [Statistic, string][] = [
  ["max", "Maximum"],
  ["mean", "Mean"],
  ["min", "Minimum"],
  ["peak_to_peak", "Peak to peak"],
];

/** Largest number of outputs whose description is open before the model has run. */
const MOST_OPEN = 6;

export function Outputs({ studio }: { studio: Studio }): JSX.Element | null {
  const selected = studio.settings.selected;
  const shown = selected.flatMap((id) => studio.results[id] ?? []);
  return (
    <section class="panel" aria-labelledby="outputs-heading">
      <h2 id="outputs-heading">Outputs</h2>
      {selected.length <= 1 && (shown[0]?.run?.outputs ? <Single results={shown[0]} /> : <Declared studio={studio} />)}
      {selected.length > 1 && <Compared runs={shown} places={selected} />}
    </section>
  );
}

/** Outputs of the model before it has run. */
function Declared({ studio }: { studio: Studio }): JSX.Element {
  const outputs = studio.model?.outputs ?? [];
  if (studio.model?.broken) return <p class="muted">The model has errors.</p>;
  if (outputs.length === 0) return <p class="muted">The model has no outputs.</p>;
  return (
    <details open={outputs.length <= MOST_OPEN}>
      <summary>{outputs.length === 1 ? "1 output" : `${outputs.length} outputs`} of a run</summary>
      <dl class="declared">
        {outputs.map((output) => (
          <div key={output.name}>
            <dt>{words(output.name)} {output.unit && <span class="unit">{output.unit}</span>}</dt>
            <dd>{paragraphs(output.doc)}</dd>
          </div>
        ))}
      </dl>
    </details>
  );
}

function Single({ results }: { results: Results }): JSX.Element {
  const outputs = Object.entries(results.run?.outputs ?? {});
  const excludesLevel = outputs.some(([, output]) => output.error_estimate?.includes_level === false);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Table of outputs">
      <table class="outputs" data-testid="outputs">
        <thead>
          <tr>
            <th scope="col">Output</th>
            <th scope="col">Min</th>
            <th scope="col">Mean</th>
            <th scope="col">Max</th>
            <th scope="col">Error</th>
          </tr>
        </thead>
        <tbody>
          {outputs.map(([name, output]) => (
            <tr key={name}>
              <th scope="row" title={output.doc}>
                {words(name)} <span class="unit">{output.display.unit}</span>
              </th>
              <td>{number(output.display.min)}</td>
              <td>{number(output.display.mean)}</td>
              <td>{number(output.display.max)}</td>
              <td>{errorOf(output)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="muted small-text">
        Error: estimated, relative to the largest magnitude.
        {excludesLevel && " The error of the fidelity level itself is not included."}
      </p>
    </div>
  );
}

function errorOf(output: OutputSummary): string {
  const estimate = output.error_estimate;
  if (!estimate) return "–";
  if (estimate.is_rounding) return "rounding";
  return estimate.relative == null ? "–" : percent(estimate.relative);
}

function Compared({ runs, places }: { runs: Results[]; places: string[] }): JSX.Element {
  const [statistic, setStatistic] = useState<Statistic>("max");
  const names = [...new Set(runs.flatMap((results) => Object.keys(results.run?.outputs ?? {})))];
  return (
    <>
      <label class="inline">
        Value
        <select value={statistic} onChange={(event) => setStatistic(event.currentTarget.value as Statistic)}>
          {STATISTICS.map(([key, label]) => <option key={key} value={key}>{label}</option>)}
        </select>
      </label>
      <p class="muted small-text">Changes are relative to {runName(runs[0]?.id ?? "")}.</p>
      <div class="scroll" tabIndex={0} role="region" aria-label="Table of compared outputs">
        <table class="outputs" data-testid="compared">
          <thead>
            <tr>
              <th scope="col">Output</th>
              {runs.map((results) => (
                <th key={results.id} scope="col">
                  <span class="swatch" style={{ background: colourOf(places.indexOf(results.id)) }} />
                  {runName(results.id)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {names.map((name) => (
              <tr key={name}>
                <th scope="row">
                  {words(name)} <span class="unit">{runs.find((results) => results.run?.outputs?.[name])?.run?.outputs?.[name]?.display.unit}</span>
                </th>
                {runs.map((results, index) => (
                  <td key={results.id}>
                    {number(valueOf(results, name, statistic))}
                    {index > 0 && <Change from={valueOf(runs[0], name, statistic)} to={valueOf(results, name, statistic)} />}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

function valueOf(results: Results | undefined, name: string, statistic: Statistic): number | null {
  return results?.run?.outputs?.[name]?.display[statistic] ?? null;
}

function Change({ from, to }: { from: number | null; to: number | null }): JSX.Element | null {
  if (from === null || to === null || from === 0) return null;
  const change = (100 * (to - from)) / Math.abs(from);
  const text = Math.abs(change) < 0.005 ? "±0" : `${change > 0 ? "+" : "−"}${Math.abs(change).toFixed(Math.abs(change) < 10 ? 2 : 1)}`;
  return <span class="change">{text} %</span>;
}
