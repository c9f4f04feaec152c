// The value at the pointer.

import type { Core } from "../core.ts";
import { fieldUnit } from "../legend.ts";
import { FIELDS } from "../fields.ts";
import { displayUnit, formatNumber } from "../units.ts";
import { beside } from "./ui.tsx";

export function Tooltip({ core }: { core: Core }) {
  const { probe, scene } = core;
  if (!probe || !scene) return null;
  const unit = fieldUnit(core);
  const length = displayUnit("m", 1);
  const { x: px, y: py, z: pz } = probe.point;
  const known = probe.value !== null && Number.isFinite(probe.value);
  return (
    <div
      class="cv-tooltip"
      role="status"
      aria-label="Value at the pointer"
      data-value={probe.value === null ? "" : String(probe.value)}
      style={beside(probe.x, probe.y, scene.width, scene.height)}
    >
      {probe.value !== null ? (
        <div class="cv-tooltip-value">
          <span class="cv-muted">{FIELDS[core.state.colours.field].label}</span>
          <strong>{known ? `${formatNumber(probe.value * unit.factor, 6)} ${unit.symbol}` : "no value"}</strong>
        </div>
      ) : null}
      <div>
        {probe.part}
        {probe.tooth !== null ? `, tooth ${probe.tooth}` : ""}
        {probe.node !== null ? `, node ${probe.node}` : ""}
      </div>
      <div class="cv-muted">
        {[px, py, pz].map((v) => formatNumber(Math.round(v * length.factor * 1e3) / 1e3, 6)).join("  ")} {length.symbol}
      </div>
    </div>
  );
}
