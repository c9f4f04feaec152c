// Tree of the parts, and the provenance of the run.

import { useState } from "preact/hooks";
import type { Core } from "../core.ts";
import type { Part, PartKind } from "../run_data.ts";
import { splitName } from "../names.ts";
import { type Visibility, visibilityOf } from "../state.ts";
import { Icon, Select, type IconName } from "./ui.tsx";

const GROUPS: { kind: PartKind; label: string }[] = [
  { kind: "gear", label: "Gears" },
  { kind: "shaft", label: "Shafts" },
  { kind: "bearing", label: "Bearings" },
  { kind: "body", label: "Bodies" },
];

const NEXT: Record<Visibility | "mixed", Visibility> = { mixed: "visible", visible: "translucent", translucent: "hidden", hidden: "visible" };
const ICONS: Record<Visibility | "mixed", IconName> = { mixed: "half", visible: "eye", translucent: "half", hidden: "hidden" };

export function PartsPanel({ core }: { core: Core }) {
  const parts = core.parts?.parts ?? [];
  return (
    <aside class="cv-panel cv-parts" aria-label="Parts">
      <div class="cv-scroll">
        {GROUPS.map(({ kind, label }) => {
          const members = parts.filter((part) => part.kind === kind);
          return members.length > 0 ? <Group key={kind} core={core} label={label} parts={members} /> : null;
        })}
      </div>
      <div class="cv-foot">
        <Select
          label="Fixed frame"
          value={core.state.frame ?? ""}
          options={[{ value: "", label: "Ground" }, ...parts.map(({ name }) => ({ value: name, label: name }))]}
          onChange={(name) => core.update({ frame: name || null })}
        />
      </div>
      {core.source?.provenance?.length ? (
        <details class="cv-provenance">
          <summary>Provenance</summary>
          <dl>
            {core.source.provenance.map(([label, value]) => (
              <div key={label}>
                <dt>{label}</dt>
                <dd title={value}>{value}</dd>
              </div>
            ))}
          </dl>
        </details>
      ) : null}
    </aside>
  );
}

function Group({ core, label, parts }: { core: Core; label: string; parts: Part[] }) {
  const [open, setOpen] = useState(true);
  const names = parts.map(({ name }) => name);
  const states = new Set(parts.map((part) => visibilityOf(core.state, part)));
  const common = states.size === 1 ? [...states][0]! : "mixed";
  return (
    <div class="cv-group" role="group" aria-label={label}>
      <div class="cv-row cv-row-group">
        <button type="button" class="cv-fold" aria-expanded={open} onClick={() => setOpen(!open)}>
          <Icon name="chevron" />
          <span>{label}</span>
          <span class="cv-count">{parts.length}</span>
        </button>
        <VisibilityButton name={label} value={common} onChange={(value) => core.setVisibility(names, value)} />
      </div>
      {open ? parts.map((part) => <PartRow key={part.name} core={core} part={part} />) : null}
    </div>
  );
}

function PartRow({ core, part }: { core: Core; part: Part }) {
  const visibility = visibilityOf(core.state, part);
  return (
    <div class={`cv-row cv-row-${visibility}`}>
      <span class="cv-swatch" style={{ background: core.display?.colours[part.index] }} />
      <span class="cv-name" title={part.name}>
        <Name name={part.name} />
      </span>
      {part.copies > 1 ? <span class="cv-count" title={`${part.copies} teeth`}>z {part.copies}</span> : null}
      {core.state.frame === part.name ? <span class="cv-pin" title="Fixed frame"><Icon name="pin" /></span> : null}
      <VisibilityButton
        name={part.name}
        value={visibility}
        onChange={(value) => core.setVisibility([part.name], value)}
      />
    </div>
  );
}

/** A name that is shortened in its middle: names of one assembly differ at their ends. */
function Name({ name }: { name: string }) {
  const [start, end] = splitName(name);
  return start ? (
    <>
      <span class="cv-name-start">{start}</span>
      <span class="cv-name-end">{end}</span>
    </>
  ) : (
    <>{end}</>
  );
}

function VisibilityButton({ name, value, onChange }: { name: string; value: Visibility | "mixed"; onChange: (value: Visibility) => void }) {
  return (
    <button
      type="button"
      class="cv-eye"
      aria-label={`${name}: ${value}`}
      title={`${value}; click for ${NEXT[value]}, Alt and click for hidden`}
      onClick={(event) => onChange(event.altKey ? (value === "hidden" ? "visible" : "hidden") : NEXT[value])}
    >
      <Icon name={ICONS[value]} />
    </button>
  );
}
