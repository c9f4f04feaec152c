// A param in the form: label, control, unit, range and error.

import type { ComponentChildren, JSX } from "preact";
import type { Param, Reason } from "./api.ts";
import { isPlainNumber, paragraphs, words } from "./format.ts";
import type { Studio } from "./store.ts";
import { Text } from "./text.tsx";

/** Largest ratio of the ends of a range for which a slider is useful. */
const WIDEST_RATIO = 200;
/** Largest number of steps of a slider over whole numbers. */
const MOST_STEPS = 1000;
/** Longest range that is shown beside the label. */
const SHORT_RANGE = 24;

interface Props {
  studio: Studio;
  param: Param;
}

export function Field({ studio, param }: Props): JSX.Element {
  const text = studio.value(param);
  const isChanged = studio.isChanged(param.name);
  const error = studio.check?.errors[param.name];
  const id = `param-${param.name}`;
  const isNumeric = param.kind === "number" || param.kind === "integer" || param.kind === "array";
  const range = isNumeric ? param.domain : "";
  const label = words(param.name.split(".").pop() ?? param.name);
  const isBeside = label.length + range.length < SHORT_RANGE + 12 && range.length <= SHORT_RANGE;
  const describedBy = [range && isBeside && `${id}-range`, `${id}-doc`, error && `${id}-error`].filter(Boolean).join(" ");
  return (
    <div class={`field ${isChanged ? "changed" : ""} ${error ? "invalid" : ""}`} data-param={param.name}>
      <FieldHead
        id={id}
        label={label}
        title={param.name}
        range={isBeside && range ? range : undefined}
        reset={isChanged ? `Reset ${words(param.name)} to ${param.default ?? "its default"}` : null}
        onReset={() => studio.reset(param.name)}
      >
        {param.kind === "boolean" && (
          <input
            id={id}
            type="checkbox"
            checked={text.toUpperCase() === "TRUE"}
            aria-describedby={describedBy}
            onChange={(event) => studio.setValue(param.name, event.currentTarget.checked ? "TRUE" : "FALSE")}
          />
        )}
      </FieldHead>
      {param.kind !== "boolean" && (
        <Control studio={studio} param={param} id={id} text={text} describedBy={describedBy} isInvalid={Boolean(error)} />
      )}
      <Slider studio={studio} param={param} text={text} />
      <p class="doc" id={`${id}-doc`}>
        {paragraphs(param.doc)}
        {!param.independent && <span class="note"> Default and range follow other params.</span>}
        {range && !isBeside && <span class="range">{range}</span>}
      </p>
      {error && <FieldError id={`${id}-error`} error={error} />}
    </div>
  );
}

interface HeadProps {
  id: string;
  label: string;
  title: string;
  /** Accepted values, beside the label. */
  range?: string;
  /** Description of the reset; null at the default. */
  reset: string | null;
  onReset: () => void;
  children?: ComponentChildren;
}

/** Label of a field with its reset; of a Boolean, with the check box. */
export function FieldHead({ id, label, title, range, reset, onReset, children }: HeadProps): JSX.Element {
  return (
    <div class="field-head">
      {children}
      <label for={id} title={title}>{label}</label>
      {range && <span class="range" id={`${id}-range`}>{range}</span>}
      {reset !== null && (
        <button type="button" class="quiet small" aria-label={reset} title={reset} onClick={onReset}>
          reset
        </button>
      )}
    </div>
  );
}

export function FieldError({ id, error }: { id: string; error: Reason }): JSX.Element {
  return (
    <p class="field-error" id={id} role="alert">
      <Text text={error.message} />
      {error.help && <span class="help"><Text text={error.help} /></span>}
    </p>
  );
}

interface ControlProps extends Props {
  id: string;
  text: string;
  describedBy: string;
  isInvalid: boolean;
}

function Control({ studio, param, id, text, describedBy, isInvalid }: ControlProps): JSX.Element {
  const set = (value: string) => studio.setValue(param.name, value);
  if (param.kind === "choice") {
    const choices = param.choices.includes(text) ? param.choices : [text, ...param.choices];
    return (
      <div class="control">
        <select
          id={id}
          value={text}
          aria-describedby={describedBy}
          aria-invalid={isInvalid}
          onChange={(event) => set(event.currentTarget.value)}
        >
          {choices.map((choice) => <option key={choice} value={choice}>{choice}</option>)}
        </select>
      </div>
    );
  }
  const hasUnit = param.unit !== "" && (isPlainNumber(text) || text === "" || /^\s*\[[^\]]*\]\s*$/.test(text));
  return (
    <div class="control">
      <input
        id={id}
        type="text"
        inputMode={param.kind === "integer" ? "numeric" : undefined}
        value={text}
        placeholder={param.default ?? ""}
        autocomplete="off"
        spellcheck={false}
        aria-describedby={describedBy}
        aria-invalid={isInvalid}
        onInput={(event) => set(event.currentTarget.value)}
      />
      {param.unit && <span class={`unit ${hasUnit ? "" : "off"}`}>{param.unit}</span>}
    </div>
  );
}

/** Slider over the range of a number; absent if the range is too wide or depends on other params. */
function Slider({ studio, param, text }: Props & { text: string }): JSX.Element | null {
  const { low, high } = param;
  if ((param.kind !== "number" && param.kind !== "integer") || !param.independent) return null;
  if (low === null || high === null || !(high > low) || !isPlainNumber(text)) return null;
  if (low > 0 && high / low > WIDEST_RATIO) return null;
  if (param.kind === "integer" && high - low > MOST_STEPS) return null;
  const step = param.kind === "integer" ? 1 : 10 ** Math.floor(Math.log10((high - low) / 100));
  return (
    <input
      type="range"
      class="slider"
      min={low}
      max={high}
      step={step}
      value={text}
      aria-label={`${words(param.name)}, slider`}
      onInput={(event) => studio.setValue(param.name, String(Number(event.currentTarget.value)))}
    />
  );
}
