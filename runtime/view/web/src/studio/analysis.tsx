// Analysis settings in the form: they override those of the model for the next runs.

import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { Setting } from "./api.ts";
import { FieldError, FieldHead } from "./field.tsx";
import type { Studio } from "./store.ts";
import { Text } from "./text.tsx";

export function AnalysisSettings({ studio }: { studio: Studio }): JSX.Element | null {
  const { analysisSettings: all, analysis } = studio;
  const details = all.filter((setting) => setting.detail);
  const errors = studio.check?.setting_errors ?? {};
  const changed = Object.keys(analysis).length;
  const isOpen = studio.settings.analysisOpen || Object.keys(errors).length > 0;
  const [detailsOpen, setDetailsOpen] = useState(false);
  const hasDetails = details.some(({ name }) => name in analysis || name in errors);
  // They stay open if a field is cleared.
  useEffect(() => {
    if (hasDetails) setDetailsOpen(true);
  }, [hasDetails]);
  if (all.length === 0) return null;
  return (
    <details
      class="analysis"
      open={isOpen}
      onToggle={(event) => {
        if (event.target === event.currentTarget) studio.setAnalysisOpen(event.currentTarget.open);
      }}
    >
      <summary>
        Analysis settings
        {changed > 0 && <span class="summary-value">{changed} changed</span>}
      </summary>
      <fieldset>
        <legend class="hidden-text">Analysis settings</legend>
        {all.filter((setting) => !setting.detail).map((setting) => <SettingField key={setting.name} studio={studio} setting={setting} />)}
        <details open={detailsOpen} onToggle={(event) => setDetailsOpen(event.currentTarget.open)}>
          <summary>Positions, mesh and contact grid</summary>
          {details.map((setting) => <SettingField key={setting.name} studio={studio} setting={setting} />)}
        </details>
      </fieldset>
    </details>
  );
}

function SettingField({ studio, setting }: { studio: Studio; setting: Setting }): JSX.Element {
  const { name, label, doc, domain } = setting;
  const text = studio.analysis[name] ?? "";
  const error = studio.check?.setting_errors[name];
  const id = `setting-${name}`;
  const effect = withoutEffect(studio, name);
  const describedBy = [`${id}-doc`, error && `${id}-error`, !error && effect && `${id}-effect`].filter(Boolean).join(" ");
  const isChanged = name in studio.analysis;
  return (
    <div class={`field ${isChanged ? "changed" : ""} ${error ? "invalid" : ""}`} data-setting={name}>
      <FieldHead
        id={id}
        label={label}
        title={name}
        reset={isChanged ? `Reset ${label} to the model's own` : null}
        onReset={() => studio.setAnalysis(name, "")}
      >
        {setting.kind === "boolean" && (
          <input
            id={id}
            type="checkbox"
            checked={text === "TRUE"}
            aria-describedby={describedBy}
            onChange={(event) => studio.setAnalysis(name, event.currentTarget.checked ? "TRUE" : "")}
          />
        )}
      </FieldHead>
      {setting.kind !== "boolean" && (
        <div class="control">
          <Control studio={studio} setting={setting} id={id} text={text} describedBy={describedBy} isInvalid={Boolean(error)} />
        </div>
      )}
      <p class="doc" id={`${id}-doc`}>
        {doc}
        {domain && <span class="range">{domain}</span>}
      </p>
      {error && <FieldError id={`${id}-error`} error={error} />}
      {!error && effect && <p class="field-note" id={`${id}-effect`} role="status"><Text text={effect} /></p>}
    </div>
  );
}

/** Settings of the finite-element meshes of gears. */
const OF_MESHES = new Set(["vtu", "refinement", "element_order", "face_elements", "displacement_order"]);
/** Settings of the direction along the face. */
const ALONG_FACE = new Set(["face_elements", "displacement_order", "contact_slices"]);

/** Returns why a setting has no effect with the fidelity of the form; null if it has one, or if this is unknown. */
function withoutEffect(studio: Studio, name: string): string | null {
  const plan = studio.check?.plan;
  if (!plan || !(name in studio.analysis)) return null;
  const reason = plan.ignored_inputs[name];
  if (reason) return `This setting has no effect: ${reason}.`;
  if (OF_MESHES.has(name) && (plan.fidelity === "rigid" || plan.fidelity === "analytic")) {
    return `This setting has no effect on gears: at the fidelity "${plan.fidelity}" they have no finite-element meshes.`;
  }
  if (ALONG_FACE.has(name) && plan.fidelity === "plane") return "This setting has no effect: a two-dimensional model has no face-width direction.";
  return null;
}

interface ControlProps {
  studio: Studio;
  setting: Setting;
  id: string;
  text: string;
  describedBy: string;
  isInvalid: boolean;
}

function Control({ studio, setting, id, text, describedBy, isInvalid }: ControlProps): JSX.Element {
  const { name, choices } = setting;
  if (setting.kind === "choice") {
    const own = name === "fidelity" && text === "" ? studio.check?.plan?.fidelity : undefined;
    return (
      <select
        id={id}
        value={text}
        aria-describedby={describedBy}
        aria-invalid={isInvalid}
        onChange={(event) => studio.setAnalysis(name, event.currentTarget.value)}
      >
        <option value="">As in the model{own && `: ${own}`}</option>
        {choices.map((choice) => <option key={choice.name} value={choice.name}>{choice.name}: {choice.doc}</option>)}
      </select>
    );
  }
  return (
    <input
      id={id}
      type="text"
      value={text}
      placeholder="as in the model"
      autocomplete="off"
      spellcheck={false}
      aria-describedby={describedBy}
      aria-invalid={isInvalid}
      onInput={(event) => studio.setAnalysis(name, event.currentTarget.value)}
    />
  );
}
