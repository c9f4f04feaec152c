// Differences between the form and the displayed run: the results are then those of an older form.

import type { JSX } from "preact";
import type { Param, RunSummary } from "./api.ts";
import { isSame, runName, words } from "./format.ts";
import type { Studio } from "./store.ts";

/** Largest number of names in a sentence. */
const MOST_NAMED = 4;

/** Labels of the params and analysis settings that differ between the form and a run; empty if the run's are unknown. */
export function formChanges(studio: Studio, run: RunSummary): string[] {
  const { model, check } = studio;
  if (!model || model.broken || !run.params) return [];
  const params = model.params.filter((param) => isChanged(studio, param, run)).map(({ name }) => words(name));
  const settings = studio.analysisSettings.filter(({ name }) => {
    const [own, of] = [studio.analysis[name], run.settings?.[name]].map((text) => (text === "FALSE" ? "" : (text ?? "")));
    return run.settings !== null && !isSame(own!, of!);
  });
  const isEdited = check?.source != null && run.source !== null && check.source !== run.source;
  return [...(isEdited ? ["the text of the model"] : []), ...settings.map(({ label }) => label.toLowerCase()), ...params];
}

function isChanged(studio: Studio, param: Param, run: RunSummary): boolean {
  const of = run.params?.[param.name];
  const typed = studio.values[param.name];
  if (typed === undefined) {
    // A default that follows other params changes with them, which are named.
    if (!of || of.at_default === true) return false;
    return param.default === null || !isSame(param.default, of.text);
  }
  const own = studio.check?.values[param.name] ?? typed;
  const before = of?.text ?? param.default;
  return before === null || !(isSame(own, before) || isSame(typed, before));
}

/** States that the displayed results belong to an older form, with the remedy. */
export function FormChanged({ studio }: { studio: Studio }): JSX.Element | null {
  const { selected, automatic } = studio.settings;
  const run = studio.runs.find(({ id }) => id === selected[0]);
  // Several runs differ from the form on purpose. The next automatic run replaces the last one.
  if (!run || selected.length !== 1 || studio.isChecking) return null;
  if (run.id === "preview" && automatic && studio.isQuick && studio.check?.runnable) return null;
  const changes = formChanges(studio, run);
  if (changes.length === 0) return null;
  const named = changes.slice(0, MOST_NAMED).join(", ");
  const more = changes.length > MOST_NAMED ? ` and ${changes.length - MOST_NAMED} more` : "";
  return (
    <div class="form-changed" role="status" data-testid="form-changed">
      <span>
        <strong>Form changed since {runName(run.id)}:</strong> {named}{more}. Results are those of the run.
      </span>
      <span class="form-changed-actions">
        <button type="button" disabled={!studio.canRun} onClick={() => void studio.run()}>Run with this form</button>
        <button type="button" class="quiet" onClick={() => studio.useForm(run)}>Back to the values of the run</button>
      </span>
    </div>
  );
}
