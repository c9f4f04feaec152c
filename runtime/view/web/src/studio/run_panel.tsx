// The plan of the next run, its start, and the progress of the runs of this studio.

import type { JSX } from "preact";
import type { Progress, Results, RunSummary } from "./api.ts";
import { Messages, Rendered } from "./diagnostics.tsx";
import { bytes, runName, seconds, solvedPositions, words } from "./format.ts";
import type { Studio } from "./store.ts";
import { Text } from "./text.tsx";

export function RunPanel({ studio }: { studio: Studio }): JSX.Element | null {
  if (studio.withoutModel) return null;
  const { check, model } = studio;
  const running = studio.runs.filter((run) => run.status === "running");
  return (
    <section class="panel" aria-labelledby="run-heading">
      <h2 id="run-heading">Run</h2>
      <div class="plan-summary"><PlanSummary studio={studio} /></div>
      <div class="run-row">
        <button type="button" class="primary" disabled={!studio.canRun} onClick={() => void studio.run()}>Run</button>
        <label class="switch">
          <input
            type="checkbox"
            checked={studio.settings.automatic}
            onChange={(event) => studio.setAutomatic(event.currentTarget.checked)}
          />
          Run after changes if the predicted time is below 1 s
        </label>
      </div>
      <FieldsWithErrors studio={studio} />
      {check?.refused && (
        <p class="field-error" role="alert">
          <Text text={check.refused.message} />
          <span class="help"><Text text={check.refused.help} /></span>
        </p>
      )}
      {check && !model?.broken && check.rendered && (
        <details open={!check.runnable}>
          <summary>{check.runnable ? "Warnings of the model" : "Errors of the model with these params"}</summary>
          <Rendered text={check.rendered} isError={!check.runnable} />
        </details>
      )}
      {running.map((run) => <Running key={run.id} studio={studio} run={run} />)}
      {studio.settings.selected.slice(0, 1).map((id) => <Ended key={id} studio={studio} id={id} />)}
    </section>
  );
}

/** Names the fields with errors: in a long form, they may be out of sight. */
function FieldsWithErrors({ studio }: { studio: Studio }): JSX.Element | null {
  const { errors = {}, setting_errors = {} } = studio.check ?? {};
  const labelOf = (name: string) => studio.analysisSettings.find((setting) => setting.name === name)?.label ?? name;
  const fields = [
    ...Object.keys(setting_errors).map((name) => ({ id: `setting-${name}`, label: labelOf(name) })),
    ...Object.keys(errors).map((name) => ({ id: `param-${name}`, label: words(name) })),
  ];
  if (fields.length === 0) return null;
  return (
    <p class="fields-with-errors">
      {fields.length === 1 ? "One field has an error:" : `${fields.length} fields have errors:`}
      {fields.map(({ id, label }) => (
        <button key={id} type="button" class="quiet" onClick={() => document.getElementById(id)?.focus()}>{label}</button>
      ))}
    </p>
  );
}

function PlanSummary({ studio }: { studio: Studio }): JSX.Element {
  const { check } = studio;
  const plan = check?.plan;
  if (!plan) {
    const text = check?.runnable ? "The model analyses nothing." : studio.isChecking ? "Checking …" : "No plan: the model or its params have errors.";
    return <p class="muted" aria-busy={studio.isChecking}>{text}</p>;
  }
  return (
    <div aria-busy={studio.isChecking}>
      <dl class="facts">
        <div><dt>Predicted time</dt><dd data-testid="predicted-time">{seconds(plan.time)}</dd></div>
        <div><dt>Memory</dt><dd>{bytes(plan.memory)}</dd></div>
        <div title="Predicted size of the files of the 3-D view, and of the meshes with stresses if they are requested">
          <dt>Disk</dt>
          <dd data-testid="predicted-disk">{bytes(plan.disk)}</dd>
        </div>
        <div><dt>Fidelity</dt><dd data-testid="fidelity">{plan.fidelity}</dd></div>
        <div><dt>Positions</dt><dd>{plan.positions}</dd></div>
      </dl>
      <details>
        <summary>Plan and gear data</summary>
        <pre class="plain" tabIndex={0} aria-label="Plan">{`${plan.cost}\n${plan.text}\n${check.gear_data}`.trim()}</pre>
      </details>
    </div>
  );
}

function Running({ studio, run }: { studio: Studio; run: RunSummary }): JSX.Element {
  const progress = studio.progress[run.id] ?? run.progress;
  return (
    <div class="progress-card">
      <div class="progress-head">
        <span>{runName(run.id)}</span>
        <button type="button" class="quiet" disabled={!studio.isConnected} onClick={() => void studio.cancel(run.id)} aria-label={`Cancel ${runName(run.id)}`}>
          Cancel
        </button>
      </div>
      <ProgressBar name={runName(run.id)} progress={progress} />
    </div>
  );
}

function ProgressBar({ name, progress }: { name: string; progress: Progress | null }): JSX.Element {
  const total = progress?.total ?? null;
  const left = progress?.seconds_left;
  return (
    <>
      <progress aria-label={`Progress of ${name}`} max={total ?? undefined} value={total === null ? undefined : progress?.done} />
      <p class="muted small-text">
        {progress?.stage ?? "starting"}
        {total !== null && ` ${progress?.done} of ${total}`}
        {left != null && left > 0 && `, ${seconds(left)} left`}
      </p>
    </>
  );
}

/** Messages of the displayed run. */
function Ended({ studio, id }: { studio: Studio; id: string }): JSX.Element | null {
  const results = studio.results[id];
  if (!results || results.status === "running") return null;
  const messages = results.messages ?? [];
  const shown = messages.filter((message) => message.severity !== "note");
  const warnings = results.run?.warnings ?? [];
  const texts = new Set(shown.map((message) => message.message));
  const others = warnings.filter((text) => ![...texts].some((known) => text.includes(known)));
  const all = [...shown, ...others.map((message) => ({ severity: "warning" as const, code: null, message, help: null }))];
  if (results.status === "finished" && all.length === 0) return null;
  if (results.status === "cancelled") {
    return (
      <div class="ended">
        <EndedEarly studio={studio} results={results} />
        <Messages messages={all.filter((message) => message.severity === "warning")} />
      </div>
    );
  }
  return (
    <div class="ended">
      <EndedEarly studio={studio} results={results} reason={shown.length === 0 ? results.message : null} />
      <Messages messages={all} />
    </div>
  );
}

/** How a run ended, with the offer to continue it. */
function EndedEarly({ studio, results, reason }: { studio: Studio; results: Results; reason?: string | null }): JSX.Element {
  const { id, status, incomplete, resumable } = results;
  const name = runName(id);
  return (
    <div class="ended-early">
      <p>
        {name}: {status}
        {incomplete && ` after ${solvedPositions(results)}`}
        {reason && `, ${reason}`}
      </p>
      {resumable && (
        <button
          type="button"
          disabled={!studio.isConnected}
          aria-label={`Continue ${name}`}
          title="Solves the remaining positions with the params and settings of this run"
          onClick={() => void studio.continue(id)}
        >
          Continue
        </button>
      )}
      {!resumable && incomplete && status !== "elsewhere" && (results.positions ?? 0) > 0 && (
        <p class="muted small-text">
          This studio did not start the run and does not know its options. To continue it, repeat its command with{" "}
          <code>--resume</code>{" "}
          in a terminal.
        </p>
      )}
    </div>
  );
}
