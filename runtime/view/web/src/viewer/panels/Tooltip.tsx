// The value at the pointer.

import type { Core } from "../core.ts";
import { fieldUnit } from "../legend.ts";
import { FIELDS } from "../fields.ts";
import { formatNumber } from "../units.ts";

export function Tooltip({ core }: { core: Core }) {
  const { probe, scene } = core;
  if (!probe || !scene) return null;
  const unit = fieldUnit(core);
  const { x: px, y: py, z: pz } = probe.point;
  // On the side of the pointer where there is room.
  const horizontal = probe.x > scene.width - 240 ? { right: scene.width - probe.x + 16 } : { left: probe.x + 16 };
  const vertical = probe.y > scene.height - 120 ? { bottom: scene.height - probe.y + 12 } : { top: probe.y + 16 };
  const known = probe.value !== null && Number.isFinite(probe.value);
  return (
    <div
      class="cv-tooltip"
      role="status"
      aria-label="Value at the pointer"
      data-value={probe.value === null ? "" : String(probe.value)}
      style={{ ...horizontal, ...vertical }}
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
        {[px, py, pz].map((v) => formatNumber(Math.round(v * 1e6) / 1e3, 6)).join("  ")} mm
      </div>
    </div>
  );
}
