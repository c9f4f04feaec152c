// Settings of the colours, the deformation, the cut, the forces and the display.

import { SCALE_NAMES } from "../colours.ts";
import { setCut } from "../controls.ts";
import type { Core } from "../core.ts";
import { EXPLANATIONS, isNodal, UNDEFORMED } from "../fields.ts";
import { fieldUnit } from "../legend.ts";
import type { Part } from "../run_data.ts";
import type { Axis, CellChoice, Vector } from "../state.ts";
import { displayUnit, formatNumber } from "../units.ts";
import { NumberField, Section, Select, Slider, Toggle } from "./ui.tsx";

export const CELL_CHOICES: { value: CellChoice; label: string }[] = [
  { value: "all", label: "All cells" },
  { value: "flanks", label: "Flanks only" },
  { value: "edges", label: "Edges only" },
];

export function SettingsPanel({ core }: { core: Core }) {
  return (
    <aside class="cv-panel cv-settings" aria-label="Settings">
      <div class="cv-scroll">
        {core.state.colours.field !== "plain" ? <Colours core={core} /> : null}
        {core.hasMeshes ? <Deformation core={core} /> : null}
        <Cut core={core} />
        <Forces core={core} />
        <Section title="Display">
          <Toggle label="Mesh edges" value={core.state.mesh_edges} onChange={(mesh_edges) => core.update({ mesh_edges })} />
          <Select
            label="Theme"
            value={core.state.theme}
            options={[
              { value: "system", label: "As the system" },
              { value: "light", label: "Light" },
              { value: "dark", label: "Dark" },
            ]}
            onChange={(theme) => core.update({ theme })}
          />
        </Section>
      </div>
    </aside>
  );
}

function Colours({ core }: { core: Core }) {
  const { colours } = core.state;
  const unit = fieldUnit(core);
  const [low, high] = core.display?.limits ?? [0, 1];
  // Rounding errors of zero stresses must not fill the field with digits.
  const tiny = 1e-9 * Math.max(Math.abs(low), Math.abs(high));
  const limits = [Math.abs(low) < tiny ? 0 : low, Math.abs(high) < tiny ? 0 : high] as const;
  const fix = (min: number, max: number) => core.update({ colours: { limits: "fixed", min, max } });
  return (
    <Section title="Colours">
      <Select
        label="Limits"
        value={colours.limits}
        options={[
          { value: "position", label: "This position" },
          { value: "all", label: "All positions" },
          { value: "fixed", label: "Fixed" },
        ]}
        onChange={(mode) => (mode === "fixed" ? fix(limits[0], limits[1]) : core.update({ colours: { limits: mode } }))}
      />
      <NumberField label="Maximum" unit={unit.symbol} value={limits[1] * unit.factor} onChange={(value) => fix(limits[0], value / unit.factor)} />
      <NumberField label="Minimum" unit={unit.symbol} value={limits[0] * unit.factor} onChange={(value) => fix(value / unit.factor, limits[1])} />
      <Select
        label="Scale"
        value={colours.scale}
        options={SCALE_NAMES.map(({ name, label }) => ({ value: name, label }))}
        onChange={(scale) => core.update({ colours: { scale } })}
      />
      <Select
        label="Bands"
        value={String(colours.bands)}
        options={["0", "6", "8", "10", "12", "16", "24"].map((value) => ({ value, label: value === "0" ? "Continuous" : value }))}
        onChange={(bands) => core.update({ colours: { bands: Number(bands) } })}
      />
      {isNodal(colours.field) ? null : (
        <Select label="Contact cells" value={colours.cells} options={CELL_CHOICES} onChange={(cells) => core.update({ colours: { cells } })} />
      )}
      {EXPLANATIONS[colours.field] ? <p class="cv-note">{EXPLANATIONS[colours.field]}</p> : null}
      <Toggle label="Mark the extreme values" value={core.state.extremes} onChange={(extremes) => core.update({ extremes })} />
      {isNodal(colours.field) ? null : (
        <Toggle
          label="Show contacts behind surfaces"
          value={core.state.hidden_contacts}
          onChange={(hidden_contacts) => core.update({ hidden_contacts })}
        />
      )}
    </Section>
  );
}

function Deformation({ core }: { core: Core }) {
  const { mode } = core.state.deformation;
  const has = ({ index }: Part) => (core.display!.meshes[index]?.length ?? 0) > 0;
  const all = core.parts?.parts ?? [];
  const [moving, rest] = [all.filter(has), all.filter((part) => !has(part))];
  return (
    <Section title="Deformation">
      <Toggle
        label="Automatic factor"
        value={mode === "automatic"}
        onChange={(on) => core.update({ deformation: { mode: on ? "automatic" : "factor", factor: core.display!.factor } })}
      />
      <NumberField
        label="Factor"
        unit="×"
        value={core.display!.factor}
        onChange={(factor) => core.update({ deformation: { mode: "factor", factor } })}
      />
      {mode === "automatic" && !isNodal(core.state.colours.field) ? <p class="cv-note">{UNDEFORMED}</p> : null}
      {rest.length > 0 && core.display!.factor > 0 ? (
        <p class="cv-note" title={rest.map(({ name }) => name).join(", ")}>
          These parts move: {listed(moving)}. The other parts stay in place.
        </p>
      ) : null}
    </Section>
  );
}

/** Largest number of parts in a note. */
const MOST_NAMED = 5;

function listed(parts: Part[]): string {
  const names = parts.slice(0, MOST_NAMED).map(({ name }) => name).join(", ");
  return parts.length > MOST_NAMED ? `${names} and ${parts.length - MOST_NAMED} more` : names;
}

function Cut({ core }: { core: Core }) {
  const { cut } = core.state;
  const view = core.display!.cut;
  const direction = (): Vector => {
    const d = core.scene!.camera.direction;
    return [d.x, d.y, d.z];
  };
  const unit = displayUnit("m", 1);
  const axis = typeof cut.normal === "string" ? cut.normal : "view";
  return (
    <Section title="Cutting plane">
      <Toggle label="Cut" value={cut.on} onChange={(on) => setCut(core, { on })} />
      {cut.on ? (
        <>
          <Select
            label="Normal"
            value={axis}
            options={[
              { value: "x", label: "x" },
              { value: "y", label: "y" },
              { value: "z", label: "z" },
              { value: "view", label: "View direction" },
            ]}
            onChange={(value) => setCut(core, { normal: value === "view" ? direction() : (value as Axis) })}
          />
          <Slider
            label="Location"
            min={view.range[0]}
            max={view.range[1]}
            value={view.offset}
            text={`${formatNumber(view.offset * unit.factor, 4)} ${unit.symbol}`}
            onInput={(offset) => {
              core.display!.setDragging(true, core.state);
              core.update({ cut: { offset } });
            }}
            onEnd={() => core.display!.setDragging(false, core.state)}
          />
          <NumberField
            label="Coordinate"
            unit={unit.symbol}
            value={view.offset * unit.factor}
            onChange={(value) => core.update({ cut: { offset: value / unit.factor } })}
          />
          <Toggle label="Flip" value={cut.flipped} onChange={(flipped) => core.update({ cut: { flipped } })} />
        </>
      ) : null}
    </Section>
  );
}

function Forces({ core }: { core: Core }) {
  const { forces } = core.state;
  const any = forces.bearings || forces.meshes;
  return (
    <Section title="Forces">
      <Toggle label="At bearings" value={forces.bearings} onChange={(bearings) => core.update({ forces: { bearings } })} />
      <Toggle label="At meshes" value={forces.meshes} onChange={(meshes) => core.update({ forces: { meshes } })} />
      {any ? (
        <>
          <Toggle label="Labels" value={forces.labels} onChange={(labels) => core.update({ forces: { labels } })} />
          <Slider label="Length" min={0.2} max={4} value={forces.scale} onInput={(scale) => core.update({ forces: { scale } })} />
        </>
      ) : null}
    </Section>
  );
}
