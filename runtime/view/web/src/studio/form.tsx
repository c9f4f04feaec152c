// The form: params by group, with reset, and load and save of params files.

import type { JSX } from "preact";
import { useRef } from "preact/hooks";
import type { Param } from "./api.ts";
import { Field } from "./field.tsx";
import { fileName } from "./format.ts";
import { readParamsFile, saveParamsFile } from "./params_file.ts";
import type { Studio } from "./store.ts";

export function Form({ studio }: { studio: Studio }): JSX.Element {
  const model = studio.model;
  if (!model) return <p class="empty">{studio.withoutModel ? "The model of this run is not known." : "Loading …"}</p>;
  const changed = Object.keys(studio.values).length;
  return (
    <form class="params" aria-label="Params" onSubmit={(event) => event.preventDefault()}>
      <Toolbar studio={studio} changed={changed} />
      {model.params.length === 0 && <p class="empty">The model has no params.</p>}
      {groupsOf(model.params).map(([group, params]) => (
        <fieldset key={group}>
          <legend class={group ? "" : "hidden-text"}>{group || "Params"}</legend>
          {params.map((param) => <Field key={param.name} studio={studio} param={param} />)}
        </fieldset>
      ))}
    </form>
  );
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

function Toolbar({ studio, changed }: { studio: Studio; changed: number }): JSX.Element {
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
      <button type="button" class="quiet" disabled={changed === 0} onClick={() => studio.setValues({})}>Reset all</button>
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
