// The list of runs, with the params and analysis settings in which they differ.

import type { JSX } from "preact";
import type { RunSummary } from "./api.ts";
import { colourOf } from "./colours.ts";
import { enteredText, quantity, runName, seconds, settingText, settingWords, solvedPositions, time, words } from "./format.ts";
import type { Studio } from "./store.ts";

/** Largest number of differing params in a row of the list. */
const MOST_SHOWN = 4;

export function RunsList({ studio }: { studio: Studio }): JSX.Element {
  const runs = [...studio.runs].reverse();
  const differing = differingInputs(studio.runs);
  return (
    <section class="panel" aria-labelledby="runs-heading">
      <h2 id="runs-heading">Runs</h2>
      {runs.length === 0 && <p class="muted">No runs yet.</p>}
      <ul class="runs">
        {runs.map((run) => <Row key={run.id} studio={studio} run={run} differing={differing} />)}
      </ul>
      {runs.length > 1 && studio.settings.selected.length < 2 && <p class="muted small-text">Check two or more runs to compare them.</p>}
    </section>
  );
}

function Row({ studio, run, differing }: { studio: Studio; run: RunSummary; differing: Input[] }): JSX.Element {
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
  return run.incomplete && run.status !== "running" ? `${run.status}, ${solvedPositions(run)}` : run.status;
}

/** A param or an analysis setting of runs. */
interface Input {
  kind: "params" | "settings";
  name: string;
}

/** Params and analysis settings whose values differ between runs. */
export function differingInputs(runs: RunSummary[]): Input[] {
  const kinds = ["params", "settings"] as const;
  return kinds.flatMap((kind) => {
    const known = runs.filter((run) => run[kind] !== null);
    const names = new Set(known.flatMap((run) => Object.keys(run[kind] ?? {})));
    const differing = [...names].filter((name) => new Set(known.map((run) => valueOf(run, { kind, name }))).size > 1);
    return differing.map((name) => ({ kind, name }));
  });
}

/** Exact value of an input, in the same unit for all runs. */
function valueOf(run: RunSummary, { kind, name }: Input): string {
  if (kind === "settings") {
    const setting = run.settings?.[name];
    return setting === undefined ? (name === "vtu" ? "no" : "as in the model") : settingText(setting);
  }
  const param = run.params?.[name];
  return param ? quantity(param.text, param.unit) : "default";
}

/** Value of an input for the reader: as it was entered, or with few digits. */
function textOf(run: RunSummary, input: Input): string {
  const param = input.kind === "params" ? run.params?.[input.name] : undefined;
  return param ? enteredText(param) : valueOf(run, input);
}

function labelOf({ kind, name }: Input): string {
  return kind === "settings" ? settingWords(name) : words(name);
}

function differences(run: RunSummary, differing: Input[]): string {
  const params = run.params ?? {};
  const changed: Input[] = [
    ...Object.keys(params).filter((name) => params[name]?.at_default !== true).map((name) => ({ kind: "params" as const, name })),
    ...Object.keys(run.settings ?? {}).map((name) => ({ kind: "settings" as const, name })),
  ];
  // Inputs in which runs differ say more than those that are the same in all runs.
  const isDiffering = (input: Input) => differing.some(({ kind, name }) => kind === input.kind && name === input.name);
  changed.sort((first, second) => Number(isDiffering(second)) - Number(isDiffering(first)));
  const shown = changed.slice(0, MOST_SHOWN).map((input) => `${labelOf(input)} ${textOf(run, input)}`);
  const more = changed.length > MOST_SHOWN ? [`${changed.length - MOST_SHOWN} more`] : [];
  return [...shown, ...more].join(", ") || (run.params ? "defaults" : "");
}

/** Table of the params and settings in which the compared runs differ. */
export function ParamDifferences({ studio }: { studio: Studio }): JSX.Element | null {
  const runs = studio.settings.selected.flatMap((id) => studio.runs.filter((run) => run.id === id));
  if (runs.length < 2) return null;
  const inputs = differingInputs(runs);
  return (
    <section class="panel" aria-labelledby="differences-heading">
      <h2 id="differences-heading">Different params and settings</h2>
      {inputs.length === 0 && <p class="muted">These runs have the same params and settings.</p>}
      {inputs.length > 0 && (
        <div class="scroll inputs" tabIndex={0} role="region" aria-label="Table of different params and settings">
          <table>
            <thead>
              <tr><th scope="col">Param</th>{runs.map((run) => <th key={run.id} scope="col">{runName(run.id)}</th>)}</tr>
            </thead>
            <tbody>
              {inputs.map((input) => (
                <tr key={`${input.kind}.${input.name}`}>
                  <th scope="row">{labelOf(input)}</th>
                  {runs.map((run) => <td key={run.id} title={valueOf(run, input)}>{textOf(run, input)}</td>)}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </section>
  );
}
