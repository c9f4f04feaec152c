// Tables of outputs: of one run with estimated errors, or of compared runs.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { OutputSummary, Results } from "./api.ts";
import { colourOf } from "./colours.ts";
import { number, paragraphs, percent, runName, solvedOf, solvedPositions, words } from "./format.ts";
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
      {selected.length <= 1 && <One studio={studio} results={shown[0]} />}
      {selected.length > 1 && <Compared runs={shown} places={selected} />}
    </section>
  );
}

function One({ studio, results }: { studio: Studio; results: Results | undefined }): JSX.Element {
  if (results?.run?.outputs) return <Single results={results} />;
  if (results?.so_far && (results.positions ?? 0) > 0) return <SoFar results={results} />;
  return <Declared studio={studio} />;
}

/** Values at the solved positions of an incomplete run. */
function SoFar({ results }: { results: Results }): JSX.Element {
  return (
    <>
      <p class="incomplete">Incomplete: {solvedPositions(results)}</p>
      <div class="scroll" tabIndex={0} role="region" aria-label="Table of outputs at the solved positions">
        <table class="outputs" data-testid="so-far">
          <thead>
            <tr>
              <th scope="col">Output</th>
              <th scope="col">Min so far</th>
              <th scope="col">Max so far</th>
              <th scope="col">Last</th>
            </tr>
          </thead>
          <tbody>
            {Object.entries(results.so_far ?? {}).map(([name, output]) => (
              <tr key={name}>
                <th scope="row" title={output.doc}>{words(name)} <span class="unit">{output.unit}</span></th>
                <td>{number(output.min)}</td>
                <td>{number(output.max)}</td>
                <td>{number(output.last)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="muted small-text">The remaining positions may have smaller and larger values. Means and errors need all positions.</p>
    </>
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
  const names = [...new Set(runs.flatMap(namesOf))];
  const reference = runs[0];
  const hasIncomplete = runs.some(isIncomplete);
  return (
    <>
      <label class="inline">
        Value
        <select value={statistic} onChange={(event) => setStatistic(event.currentTarget.value as Statistic)}>
          {STATISTICS.map(([key, label]) => <option key={key} value={key}>{label}</option>)}
        </select>
      </label>
      <p class="muted small-text">
        Changes are relative to {runName(reference?.id ?? "")}.
        {hasIncomplete && " Values of incomplete runs are those of their solved positions, without mean and change."}
      </p>
      <div class="scroll" tabIndex={0} role="region" aria-label="Table of compared outputs">
        <table class="outputs" data-testid="compared">
          <thead>
            <tr>
              <th scope="col">Output</th>
              {runs.map((results) => (
                <th key={results.id} scope="col">
                  <span class="swatch" style={{ background: colourOf(places.indexOf(results.id)) }} />
                  {runName(results.id)}
                  {isIncomplete(results) && <span class="incomplete">{solvedOf(results)} solved</span>}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {names.map((name) => (
              <tr key={name}>
                <th scope="row">{words(name)} <span class="unit">{unitOf(runs, name)}</span></th>
                {runs.map((results) => {
                  const isCompared = results !== reference && reference && !isIncomplete(results) && !isIncomplete(reference);
                  return (
                    <td key={results.id} class={isIncomplete(results) ? "so-far" : ""}>
                      {number(valueOf(results, name, statistic))}
                      {isCompared && <Change from={valueOf(reference, name, statistic)} to={valueOf(results, name, statistic)} />}
                    </td>
                  );
                })}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

function isIncomplete(results: Results): boolean {
  return !results.run?.outputs;
}

function namesOf(results: Results): string[] {
  return Object.keys(results.run?.outputs ?? results.so_far ?? {});
}

function unitOf(runs: Results[], name: string): string {
  const units = runs.map((results) => results.run?.outputs?.[name]?.display.unit ?? results.so_far?.[name]?.unit);
  return units.find((unit) => unit !== undefined) ?? "";
}

/** Value of an output; of an incomplete run only those that its solved positions have. */
function valueOf(results: Results, name: string, statistic: Statistic): number | null {
  const finished = results.run?.outputs?.[name]?.display;
  if (finished) return finished[statistic];
  const soFar = results.so_far?.[name];
  return soFar && (statistic === "min" || statistic === "max") ? soFar[statistic] : null;
}

function Change({ from, to }: { from: number | null; to: number | null }): JSX.Element | null {
  if (from === null || to === null || from === 0) return null;
  const change = (100 * (to - from)) / Math.abs(from);
  const text = Math.abs(change) < 0.005 ? "±0" : `${change > 0 ? "+" : "−"}${Math.abs(change).toFixed(Math.abs(change) < 10 ? 2 : 1)}`;
  return <span class="change">{text} %</span>;
}
