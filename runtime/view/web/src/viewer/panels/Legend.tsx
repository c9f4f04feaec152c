// Legend of the colours.

import { banded, colourAt, cssColour } from "../colours.ts";
import { largestPressure } from "../contacts.ts";
import type { Core } from "../core.ts";
import { EXPLANATIONS } from "../fields.ts";
import { legendTicks, legendTitle } from "../legend.ts";
import type { CellChoice, Field } from "../state.ts";
import { formatNumber, stressUnit } from "../units.ts";

const CELLS: Record<CellChoice, string> = { all: "of cells, edges included", flanks: "flanks only", edges: "edges only" };
const SHORT: Partial<Record<Field, string>> = { stress_error: "estimated, as von Mises stress" };

/** CSS gradient from the bottom upwards. */
function gradient(core: Core): string {
  const { scale, bands } = core.state.colours;
  const stops: string[] = [];
  if (bands > 0) {
    for (let i = 0; i < bands; i++) {
      const colour = cssColour(colourAt(scale, banded((i + 0.5) / bands, bands)));
      stops.push(`${colour} ${(100 * i) / bands}% ${(100 * (i + 1)) / bands}%`);
    }
  } else {
    for (let i = 0; i <= 20; i++) stops.push(`${cssColour(colourAt(scale, i / 20))} ${5 * i}%`);
  }
  return `linear-gradient(to top, ${stops.join(", ")})`;
}

/** States which values the upper limit leaves out. */
function clippedText({ share, largest }: { share: number; largest: number }, unit: string): string {
  return `${formatNumber(100 * share, 2)} % of the nodes are above, up to ${formatNumber(largest * stressUnit().factor, 3)} ${unit}`;
}

/** States the pressures that "flanks only" leaves out, if they are larger. */
function edgesText(core: Core, unit: string): string | null {
  const { field, cells } = core.state.colours;
  const contacts = core.display?.position?.contacts;
  if (field !== "contact_pressure" || cells !== "flanks" || !contacts) return null;
  const largest = largestPressure(contacts, "all");
  if (!(largest > largestPressure(contacts, "flanks"))) return null;
  return `edges, not shown: up to ${formatNumber(largest * stressUnit().factor, 4)} ${unit}`;
}

/** Reason why a field has no values. */
function reasonWithoutValues(core: Core): string {
  const position = core.display?.position;
  if (!position) return "No values: the run has no positions.";
  if (core.state.colours.field !== "contact_pressure") {
    return position.meshes.length === 0
      ? "No values: the run stored no meshes with stresses (--vtu), or its fidelity level has no finite elements."
      : "No values: the parts with meshes are hidden.";
  }
  if (!position.contacts) return "No values: no contact is loaded in this position, or the fidelity level is \"rigid\".";
  return core.state.colours.cells === "all" ? "No values: the gears in contact are hidden." : `No values: no visible loaded cells, ${CELLS[core.state.colours.cells]}.`;
}

export function Legend({ core }: { core: Core }) {
  const { field } = core.state.colours;
  if (field === "plain") return null;
  const { ticks, unit } = legendTicks(core);
  if (core.missingField || ticks.length === 0) {
    return (
      <div class="cv-legend cv-legend-empty" role="note">
        <strong>{legendTitle(core)}</strong>
        <span>{reasonWithoutValues(core)}</span>
      </div>
    );
  }
  // With many bands, a short bar has no room for all numbers.
  const step = core.narrow ? Math.ceil(ticks.length / 6) : 1;
  const { limits } = core.state.colours;
  const clipped = core.display?.clipped;
  const edges = edgesText(core, unit);
  const range = limits === "all" ? "all positions" : limits === "fixed" ? "fixed limits" : "this position";
  return (
    <button
      type="button"
      class="cv-legend"
      aria-label={`Legend: ${legendTitle(core)} from ${ticks[0]!.text} to ${ticks[ticks.length - 1]!.text} ${unit}. Opens the settings.`}
      title={EXPLANATIONS[field] ?? "Settings of the colours"}
      onClick={() => core.toggle("settings")}
    >
      <span class="cv-legend-title">
        <strong>{legendTitle(core)}</strong>
        {unit ? <span class="cv-legend-unit">{unit}</span> : null}
      </span>
      <span class="cv-scale">
        <span class="cv-bar" style={{ background: gradient(core) }} />
        <span class="cv-ticks">
          {ticks.filter((_, i) => i % step === 0).map((tick, i) => (
            <span key={i} style={{ bottom: `${100 * tick.fraction}%` }}>
              {tick.text}
            </span>
          ))}
        </span>
      </span>
      {EXPLANATIONS[field] ? <span class="cv-range">{SHORT[field]}</span> : null}
      {edges ? <span class="cv-range">{edges}</span> : null}
      {clipped ? <span class="cv-range">{clippedText(clipped, unit)}</span> : null}
      <span class="cv-range">
        {field === "contact_pressure" ? `${CELLS[core.state.colours.cells]}; ` : ""}
        {core.progress !== null ? `reading … ${Math.round(100 * core.progress)} %` : range}
      </span>
    </button>
  );
}
