// Origin of the displayed results: model, versions, residuals of the solution.

import type { JSX } from "preact";
import type { Results } from "./api.ts";
import { ofRun } from "./api.ts";
import { dateAndTime, enteredText, number, runName, settingText, settingWords, solvedOf, words } from "./format.ts";
import type { Studio } from "./store.ts";

/** Labels and values of a run. */
export function provenanceOf(results: Results): [string, string][] {
  const run = results.run;
  const entries: [string, string | null | undefined][] = [
    ["Directory", results.directory],
    ["Started", dateAndTime(results.started)],
    ["Model", run?.model],
    ["Hash of the source", run?.source?.sha256?.slice(0, 16)],
    ["Calyx", run?.calyx],
    ["Fidelity", run?.fidelity],
    ["Positions", solvedOf(results)],
    ...Object.entries(results.params ?? {})
      .filter(([, param]) => param.at_default !== true)
      .map(([name, param]): [string, string] => [`Param: ${words(name)}`, enteredText(param)]),
    ...Object.entries(results.settings ?? {}).map(([name, text]): [string, string] => [`Set: ${settingWords(name)}`, settingText(text)]),
    ...Object.entries(run?.certificate ?? {}).map(([name, value]): [string, string] => [`Residual: ${words(name)}`, number(value)]),
  ];
  return entries.filter((entry): entry is [string, string] => Boolean(entry[1]));
}

export function Provenance({ studio }: { studio: Studio }): JSX.Element | null {
  const shown = studio.settings.selected.flatMap((id) => studio.results[id] ?? []);
  if (shown.length === 0) return null;
  return (
    <section class="panel" aria-labelledby="provenance-heading">
      <h2 id="provenance-heading">Provenance</h2>
      {shown.map((results) => (
        <details key={results.id} open={shown.length === 1}>
          <summary>{runName(results.id)}</summary>
          <dl class="provenance">
            {provenanceOf(results).map(([label, value]) => (
              <div key={label}><dt>{label}</dt><dd>{value}</dd></div>
            ))}
          </dl>
          <Ignored results={results} />
          {results.printed && <pre class="plain" tabIndex={0} aria-label="Text that the model prints">{results.printed}</pre>}
          <p class="links">
            {results.has_report && <a href={ofRun(results.id, "/files/report.html")} target="_blank" rel="noreferrer">Report</a>}
            {results.steps && <a href={ofRun(results.id, "/files/steps.csv")} download={`${results.id}-steps.csv`}>steps.csv</a>}
            {results.run && <a href={ofRun(results.id, "/files/run.json")} download={`${results.id}.json`}>run.json</a>}
            {!studio.withoutModel && results.params && (
              <button type="button" class="quiet" onClick={() => studio.useForm(results)}>Use these params and settings</button>
            )}
          </p>
        </details>
      ))}
    </section>
  );
}

function Ignored({ results }: { results: Results }): JSX.Element | null {
  const ignored = Object.entries(results.run?.ignored_inputs ?? {});
  const refused = Object.entries(results.run?.refused_outputs ?? {});
  if (ignored.length + refused.length === 0) return null;
  return (
    <ul class="messages">
      {ignored.map(([name, reason]) => <li key={name} class="warning"><code>{name}</code> is not used as given: {reason}</li>)}
      {refused.map(([name, reason]) => <li key={name} class="warning"><code>{name}</code> has no value: {reason}</li>)}
    </ul>
  );
}
