// Small controls that the panels share.

import type { ComponentChildren } from "preact";
import { useEffect, useReducer, useState } from "preact/hooks";
import type { Core } from "../core.ts";

/** Renders the component again after each change of the viewer. */
export function useCore(core: Core): void {
  const [, refresh] = useReducer((n: number) => n + 1, 0);
  useEffect(() => {
    // The viewer may have changed between the first rendering and this effect.
    refresh(0);
    return core.subscribe(() => refresh(0));
  }, [core]);
}

/** Paths of the icons on a grid of 16, drawn with lines. */
const ICONS = {
  parts: "M2.5 3.5h4M2.5 8h4M2.5 12.5h4M9 3.5h4.5M9 8h4.5M9 12.5h4.5",
  settings: "M2 4.5h7M12 4.5h2M2 11.5h2M7 11.5h7M10.5 3v3M5.5 10v3",
  fit: "M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",
  cube: "M8 1.8l5.5 3v6.4L8 14.2l-5.5-3V4.8zM2.5 4.8L8 8l5.5-3.2M8 8v6.2",
  perspective: "M2 3.5l12 2v5l-12 2zM8 4.5v7",
  orthographic: "M2.5 3.5h11v9h-11zM8 3.5v9",
  mesh: "M2.5 2.5h11v11h-11zM2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",
  force: "M3 13L12.5 3.5M7.5 3h5.5v5.5",
  cut: "M1.5 10.5l5-7h8l-5 7zM3 13.5h4M9.5 13.5h4",
  plot: "M2.5 2.5v11h11M4.5 10.5l3-4 2.5 2 3.5-5",
  pattern: "M1.8 3.5h12.4v9H1.8zM4 8c0-1.6 1.8-2.4 4-2.4S12 6.4 12 8s-1.8 2.4-4 2.4S4 9.6 4 8",
  more: "M2.6 8h1.2M7.4 8h1.2M12.2 8h1.2",
  download: "M8 2v8M4.8 7L8 10.2 11.2 7M2.5 13.5h11",
  help: "M5.5 6a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M8 12.6v.4",
  sun: "M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M8 1.2v1.6M8 13.2v1.6M1.2 8h1.6M13.2 8h1.6M3.2 3.2l1.1 1.1M11.7 11.7l1.1 1.1M12.8 3.2l-1.1 1.1M4.3 11.7l-1.1 1.1",
  moon: "M13.2 9.6A5.8 5.8 0 0 1 6.4 2.8a5.6 5.6 0 1 0 6.8 6.8",
  play: "M5 3l8 5-8 5z",
  pause: "M5 3v10M11 3v10",
  next: "M4 3.5l6 4.5-6 4.5zM12.2 3.5v9",
  previous: "M12 3.5L6 8l6 4.5zM3.8 3.5v9",
  loop: "M11.5 2l2 2-2 2M13.5 4H5a3 3 0 0 0-3 3M4.5 14l-2-2 2-2M2.5 12H11a3 3 0 0 0 3-3",
  eye: "M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8M8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6",
  half: "M8 2.5a5.5 5.5 0 1 0 0 11zM8 2.5a5.5 5.5 0 0 1 0 11M8 5h4.6M8 8h5.5M8 11h4.6",
  hidden: "M2 2l12 12M6.2 4.1A6 6 0 0 1 8 3.8c4 0 6.5 4.2 6.5 4.2a12 12 0 0 1-1.9 2.3M4 5.2A11 11 0 0 0 1.5 8S4 12.2 8 12.2a6 6 0 0 0 3-.8",
  pin: "M8 9.5V14M5 9.5h6l-1.3-2V3.3h.8M6.3 7.5L5 9.5M6.3 7.5V3.3h-.8M6.3 3.3h3.4",
  chevron: "M5.5 3.5L10 8l-4.5 4.5",
  close: "M3.5 3.5l9 9M12.5 3.5l-9 9",
} as const;

export type IconName = keyof typeof ICONS;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="cv-icon" viewBox="0 0 16 16" aria-hidden="true">
      <path d={ICONS[name]} />
    </svg>
  );
}

export interface ToolProps {
  icon: IconName;
  label: string;
  shortcut?: string;
  pressed?: boolean;
  disabled?: boolean;
  onClick: () => void;
}

/** Place beside a point of a box of the given size, on the side where there is room. */
export function beside(x: number, y: number, width: number, height: number): Record<string, string> {
  const right = x > width - 240 && x > width / 2;
  const bottom = y > height - 120 && y > height / 2;
  return {
    [right ? "right" : "left"]: `${(right ? width - x : x) + 14}px`,
    [bottom ? "bottom" : "top"]: `${(bottom ? height - y : y) + 12}px`,
    "max-width": `${Math.max(120, (right ? x : width - x) - 20)}px`,
  };
}

/** Button with an icon; a toggle if `pressed` is given. */
export function Tool({ icon, label, shortcut, pressed, disabled, onClick }: ToolProps) {
  return (
    <button
      type="button"
      class="cv-tool"
      aria-label={label}
      aria-pressed={pressed}
      disabled={disabled}
      title={shortcut ? `${label} (${shortcut})` : label}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}

export interface SelectProps<T extends string> {
  label: string;
  value: T;
  options: { value: T; label: string; disabled?: boolean }[];
  onChange: (value: T) => void;
  /** The label is for screen readers only. */
  quiet?: boolean;
  title?: string;
}

export function Select<T extends string>({ label, value, options, onChange, quiet, title }: SelectProps<T>) {
  return (
    <label class="cv-field" title={title}>
      <span class={quiet ? "cv-hidden" : ""}>{label}</span>
      <select aria-label={label} value={value} onChange={(event) => onChange(event.currentTarget.value as T)}>
        {options.map((option) => (
          <option key={option.value} value={option.value} disabled={option.disabled} selected={option.value === value}>
            {option.label}
          </option>
        ))}
      </select>
    </label>
  );
}

export function Toggle({ label, value, onChange }: { label: string; value: boolean; onChange: (value: boolean) => void }) {
  return (
    <label class="cv-check">
      <input type="checkbox" checked={value} onChange={(event) => onChange(event.currentTarget.checked)} />
      <span>{label}</span>
    </label>
  );
}

export interface NumberFieldProps {
  label: string;
  value: number;
  unit?: string;
  min?: number;
  max?: number;
  disabled?: boolean;
  onChange: (value: number) => void;
}

/** Text field for a number. A value is accepted when the field is left or Enter is pressed. */
export function NumberField({ label, value, unit, min, max, disabled, onChange }: NumberFieldProps) {
  const shown = Number.isFinite(value) ? String(Number(value.toPrecision(6))) : "";
  const [text, setText] = useState<string | null>(null);
  const commit = () => {
    if (text === null) return;
    const number = Number(text.trim().replace(",", ".").replace("−", "-"));
    setText(null);
    if (text.trim() === "" || !Number.isFinite(number)) return;
    onChange(Math.min(Math.max(number, min ?? -Infinity), max ?? Infinity));
  };
  return (
    <label class="cv-field">
      <span>{label}</span>
      <span class="cv-number">
        <input
          type="text"
          inputMode="decimal"
          value={text ?? shown}
          disabled={disabled}
          onInput={(event) => setText(event.currentTarget.value)}
          onBlur={commit}
          onKeyDown={(event) => {
            if (event.key === "Enter") commit();
            if (event.key === "Escape") setText(null);
          }}
        />
        {unit ? <span class="cv-unit">{unit}</span> : null}
      </span>
    </label>
  );
}

export interface SliderProps {
  label: string;
  value: number;
  min: number;
  max: number;
  step?: number | "any";
  text?: string;
  onInput: (value: number) => void;
  /** Called when a drag ends. */
  onEnd?: () => void;
}

export function Slider({ label, value, min, max, step = "any", text, onInput, onEnd }: SliderProps) {
  return (
    <label class="cv-field cv-slider">
      <span>{label}</span>
      <input
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        aria-valuetext={text}
        onInput={(event) => onInput(Number(event.currentTarget.value))}
        onChange={onEnd}
      />
    </label>
  );
}

export function Section({ title, children }: { title: string; children: ComponentChildren }) {
  return (
    <section class="cv-section">
      <h3>{title}</h3>
      {children}
    </section>
  );
}
