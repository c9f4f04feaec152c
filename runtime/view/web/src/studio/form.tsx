// The form: params by group, with reset, and load and save of params files.

import type { JSX } from "preact";
import { useRef, useState } from "preact/hooks";
import type { Param } from "./api.ts";
import { AnalysisSettings } from "./analysis.tsx";
import { Field } from "./field.tsx";
import { fileName, words } from "./format.ts";
import { readParamsFile, saveParamsFile } from "./params_file.ts";
import type { Studio } from "./store.ts";

/** Number of params above which the form has a search field. */
const MANY = 20;

export function Form({ studio }: { studio: Studio }): JSX.Element {
  const [search, setSearch] = useState("");
  const model = studio.model;
  if (!model) return <p class="empty">{studio.withoutModel ? "The model of this run is not known." : "Loading …"}</p>;
  const hasSearch = model.params.length > MANY;
  const found = hasSearch ? model.params.filter((param) => isFound(studio, param, search)) : model.params;
  return (
    <form class="params" aria-label="Params" onSubmit={(event) => event.preventDefault()}>
      <Toolbar studio={studio} />
      <AnalysisSettings studio={studio} />
      {model.params.length === 0 && <p class="empty">The model has no params.</p>}
      {hasSearch && (
        <input
          type="search"
          class="search"
          placeholder={`Find one of ${model.params.length} params`}
          aria-label="Find a param"
          value={search}
          onInput={(event) => setSearch(event.currentTarget.value)}
        />
      )}
      {model.params.length > 0 && found.length === 0 && <p class="empty" role="status">No param contains these words.</p>}
      {groupsOf(found).map(([group, params]) => (
        <fieldset key={group}>
          <legend class={group ? "" : "hidden-text"}>{group || "Params"}</legend>
          {params.map((param) => <Field key={param.name} studio={studio} param={param} />)}
        </fieldset>
      ))}
    </form>
  );
}

/** True if a param contains all words of the search in name, group or documentation, or has an error. */
function isFound(studio: Studio, param: Param, search: string): boolean {
  const text = `${param.name} ${words(param.name)} ${param.group} ${param.doc}`.toLowerCase();
  const all = search.toLowerCase().split(/\s+/).every((word) => text.includes(word));
  return all || studio.check?.errors[param.name] !== undefined;
}

/** Groups params by heading, in the order of the model. */
function groupsOf(params: Param[]): [string, Param[]][] {
  const groups = new Map<string, Param[]>();
  for (const param of params) {
    const group = groups.get(param.group);
    if (group) group.push(param);
    else groups.set(param.group, [param]);
  }
  return [...groups];
}

function Toolbar({ studio }: { studio: Studio }): JSX.Element {
  const changed = studio.changes;
  const input = useRef<HTMLInputElement>(null);
  const load = async (file: File | undefined) => {
    if (!file) return;
    try {
      studio.setValues(await readParamsFile(file));
    } catch (error) {
      studio.fail(error);
    }
  };
  return (
    <div class="toolbar">
      <span class="count" role="status">{changed === 0 ? "Defaults" : `${changed} changed`}</span>
      <button type="button" class="quiet" disabled={changed === 0} onClick={() => studio.resetAll()}>Reset all</button>
      <button type="button" class="quiet" onClick={() => input.current?.click()}>Load …</button>
      <button type="button" class="quiet" onClick={() => saveParamsFile(studio, `${fileName(studio.model?.model ?? "model")}.json`)}>
        Save
      </button>
      <input
        ref={input}
        type="file"
        accept=".json,.toml"
        class="hidden-text"
        tabIndex={-1}
        aria-label="Params file"
        onChange={(event) => {
          const field = event.currentTarget;
          void load(field.files?.[0]).finally(() => (field.value = ""));
        }}
      />
    </div>
  );
}
