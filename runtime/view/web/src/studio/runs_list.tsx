// The list of runs, with the params in which they differ.

import type { JSX } from "preact";
import type { RunSummary } from "./api.ts";
import { colourOf } from "./colours.ts";
import { quantity, runName, seconds, time, words } from "./format.ts";
import type { Studio } from "./store.ts";

/** Largest number of differing params in a row of the list. */
const MOST_SHOWN = 4;

export function RunsList({ studio }: { studio: Studio }): JSX.Element {
  const runs = [...studio.runs].reverse();
  const differing = differingParams(studio.runs);
  return (
    <section class="panel" aria-labelledby="runs-heading">
      <h2 id="runs-heading">Runs</h2>
      {runs.length === 0 && <p class="muted">No runs yet.</p>}
      <ul class="runs">
        {runs.map((run) => <Row key={run.id} studio={studio} run={run} differing={differing} />)}
      </ul>
      {runs.length > 1 && <p class="muted small-text">Check two or more runs to compare them.</p>}
    </section>
  );
}

function Row({ studio, run, differing }: { studio: Studio; run: RunSummary; differing: string[] }): JSX.Element {
  const place = studio.settings.selected.indexOf(run.id);
  const name = runName(run.id);
  return (
    <li class={place >= 0 ? "selected" : ""} data-run={run.id}>
      <input
        type="checkbox"
        aria-label={`Compare ${name}`}
        checked={place >= 0}
        style={place >= 0 ? { accentColor: colourOf(place) } : undefined}
        onChange={() => studio.toggle(run.id)}
      />
      <button type="button" class="run-name" aria-pressed={place >= 0} title={run.directory} onClick={() => studio.select([run.id])}>
        <span class="run-title">
          {name}
          <span class={`status ${run.status}`}>{statusText(studio, run)}</span>
          <span class="when">{time(run.started)}</span>
        </span>
        <span class="differences">{differences(run, differing)}</span>
      </button>
    </li>
  );
}

function statusText(studio: Studio, run: RunSummary): string {
  if (run.status === "elsewhere") return "written by another process";
  const left = studio.progress[run.id]?.seconds_left;
  if (run.status === "running" && left) return `running, ${seconds(left)} left`;
  return run.status;
}

/** Names of the params whose values differ between runs. */
export function differingParams(runs: RunSummary[]): string[] {
  const known = runs.filter((run) => run.params !== null);
  const names = new Set(known.flatMap((run) => Object.keys(run.params ?? {})));
  return [...names].filter((name) => {
    const texts = new Set(known.map((run) => textOf(run, name)));
    return texts.size > 1;
  });
}

function textOf(run: RunSummary, name: string): string {
  const param = run.params?.[name];
  return param ? quantity(param.text, param.unit) : "default";
}

function differences(run: RunSummary, differing: string[]): string {
  const params = run.params ?? {};
  const changed = Object.keys(params).filter((name) => params[name]?.at_default !== true);
  // Params in which runs differ say more than those that are the same in all runs.
  changed.sort((first, second) => Number(differing.includes(second)) - Number(differing.includes(first)));
  const shown = changed.slice(0, MOST_SHOWN).map((name) => `${words(name)} ${textOf(run, name)}`);
  const more = changed.length > MOST_SHOWN ? [`${changed.length - MOST_SHOWN} more`] : [];
  return [...shown, ...more].join(", ") || (run.params ? "defaults" : "");
}

/** Table of the params in which the compared runs differ. */
export function ParamDifferences({ studio }: { studio: Studio }): JSX.Element | null {
  const runs = studio.settings.selected.flatMap((id) => studio.runs.filter((run) => run.id === id));
  if (runs.length < 2) return null;
  const names = differingParams(runs);
  return (
    <section class="panel" aria-labelledby="differences-heading">
      <h2 id="differences-heading">Different params</h2>
      {names.length === 0 && <p class="muted">These runs have the same params.</p>}
      {names.length > 0 && (
        <div class="scroll" tabIndex={0} role="region" aria-label="Table of different params">
          <table>
            <thead>
              <tr><th scope="col">Param</th>{runs.map((run) => <th key={run.id} scope="col">{runName(run.id)}</th>)}</tr>
            </thead>
            <tbody>
              {names.map((name) => (
                <tr key={name}>
                  <th scope="row">{words(name)}</th>
                  {runs.map((run) => <td key={run.id}>{textOf(run, name)}</td>)}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </section>
  );
}
