// Controls of narrow viewers side by side: their own toolbars would leave no space for the scenes.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { PartialState, Viewer } from "../viewer/index.ts";
import { FIELDS } from "../viewer/fields.ts";
import { NUMBERS } from "../viewer/panels/Timeline.tsx";
import type { Field } from "../viewer/state.ts";

interface Props {
  viewers: () => Viewer[];
  /** State with which the viewers began. */
  state: PartialState;
  /** Largest number of positions of a run. */
  positions: number;
}

export function SharedControls({ viewers, state, positions }: Props): JSX.Element {
  const [field, setField] = useState<Field>(state.colours?.field ?? "plain");
  const [position, setPosition] = useState(state.position ?? 0);
  const last = Math.max(positions - 1, 0);
  const shown = Math.min(position, last);
  const apply = (patch: PartialState) => viewers().forEach((viewer) => viewer.restore(patch));
  const goTo = (next: number) => {
    setPosition(next);
    apply({ position: next });
  };
  return (
    <div class="scene-bar" role="group" aria-label="All scenes">
      <select
        aria-label="Displayed field"
        value={field}
        onChange={(event) => {
          const chosen = event.currentTarget.value as Field;
          setField(chosen);
          apply({ colours: { field: chosen } });
        }}
      >
        {Object.entries(FIELDS).map(([name, { label }]) => <option key={name} value={name}>{label}</option>)}
      </select>
      <label class="inline position">
        Position
        <input
          type="range"
          min={0}
          max={last}
          value={shown}
          disabled={positions < 2}
          onInput={(event) => goTo(Number(event.currentTarget.value))}
        />
        <output title={NUMBERS}>{shown} (0 to {last})</output>
      </label>
    </div>
  );
}
