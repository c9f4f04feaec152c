// Contact pattern on an unrolled flank.

import { useEffect, useRef, useState } from "preact/hooks";
import type { Core } from "../core.ts";
import { downloadPattern, patternTheme, patternTitle, type ImageFormat } from "../export.ts";
import { cellAt, type PatternCell } from "../pattern.ts";
import { CanvasPen, drawPattern, originOf, PatternLayout } from "../pattern_drawing.ts";
import type { Pattern } from "../pattern_model.ts";
import { displayUnit, formatNumber, stressUnit } from "../units.ts";
import { beside, Select } from "./ui.tsx";

export function PatternPanel({ core }: { core: Core }) {
  const pattern = core.pattern.pattern();
  return (
    <section class="cv-pattern" aria-label="Contact pattern">
      {pattern ? (
        <>
          <Choices core={core} pattern={pattern} />
          <Picture core={core} pattern={pattern} />
        </>
      ) : (
        <div class="cv-muted">No gear has contacts in this position.</div>
      )}
    </section>
  );
}

function Choices({ core, pattern }: { core: Core; pattern: Pattern }) {
  const { state } = core;
  const { part } = pattern;
  const [error, setError] = useState("");
  const chosen = state.pattern.tooth;
  const teeth = core.pattern.teeth(part).map(String);
  if (/^\d+$/.test(chosen) && !teeth.includes(chosen)) teeth.push(chosen);
  const pointed = core.pattern.pointed.get(part.index);
  return (
    <div class="cv-pattern-head">
      <Select
        quiet
        label="Gear"
        value={part.name}
        options={core.pattern.gears().map(({ name }) => ({ value: name, label: name }))}
        onChange={(gear) => core.update({ pattern: { gear } })}
      />
      <Select
        quiet
        label="Tooth"
        value={chosen}
        options={[
          { value: "all", label: "All teeth" },
          { value: "pointer", label: pointed === undefined ? "At the pointer" : `At the pointer: ${pointed}` },
          ...teeth.map((tooth) => ({ value: tooth, label: `Tooth ${tooth}` })),
        ]}
        onChange={(tooth) => core.update({ pattern: { tooth } })}
      />
      <Select
        quiet
        label="Flank"
        value={state.pattern.flank}
        options={[
          { value: "automatic", label: `Loaded: ${pattern.side}` },
          { value: "left", label: "Left flank" },
          { value: "right", label: "Right flank" },
        ]}
        onChange={(flank) => core.update({ pattern: { flank } })}
      />
      <Select
        quiet
        label="Positions of the pattern"
        value={state.pattern.envelope ? "all" : "current"}
        options={[
          { value: "current", label: "This position" },
          { value: "all", label: "All positions" },
        ]}
        onChange={(value) => core.update({ pattern: { envelope: value === "all" } })}
      />
      <Select
        quiet
        label={error ? `Export the pattern. ${error}` : "Export the pattern"}
        value={"" as ImageFormat | ""}
        options={[
          { value: "", label: "Export" },
          { value: "png", label: "PNG" },
          { value: "svg", label: "SVG" },
          { value: "pdf", label: "PDF" },
        ]}
        onChange={(format) => {
          if (format) downloadPattern(core, format).catch((reason: unknown) => setError(String(reason)));
          core.changed(false);
        }}
      />
      <Note core={core} pattern={pattern} />
    </div>
  );
}

/** What a reader must know about the picture. */
function Note({ core, pattern }: { core: Core; pattern: Pattern }) {
  const total = core.positions?.list.length ?? 0;
  const { envelope, limits, largest } = pattern;
  const notes: string[] = [];
  if (envelope && envelope.included.size < total) notes.push(`read ${envelope.included.size} of ${total} positions …`);
  if (largest === 0 && !(envelope && envelope.included.size < total)) notes.push("no loaded cells");
  const unit = stressUnit();
  if (largest > limits[1] * (1 + 1e-9)) notes.push(`up to ${formatNumber(largest * unit.factor)} ${unit.symbol}, above the scale`);
  return notes.length > 0 ? <span class="cv-muted" role="note">{notes.join("; ")}</span> : null;
}

interface Reading {
  /** Pressure, Pa; NaN where there is none. */
  value: number;
  z: number;
  r: number;
  cell: PatternCell | null;
}

function readingAt(pattern: Pattern, layout: PatternLayout, x: number, y: number): Reading | null {
  if (x < layout.left || x > layout.right || y < layout.top || y > layout.bottom) return null;
  const [u, v] = layout.inverse(x, y);
  const [z, r] = pattern.axes.inverse(u, v);
  if (pattern.envelope) return { value: pattern.envelope.at(u, v) || NaN, z, r, cell: null };
  const cell = cellAt(pattern.cells, z, r);
  return { value: cell?.pressure ?? NaN, z, r, cell };
}

function Picture({ core, pattern }: { core: Core; pattern: Pattern }) {
  const holder = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [size, setSize] = useState<[number, number]>([0, 0]);
  const [pointer, setPointer] = useState<[number, number] | null>(null);
  const { hovered } = core.pattern;
  // With little room, the legend of the scene serves both pictures.
  const bar = !(core.drawers && core.state.colours.field === "contact_pressure");
  const layout = new PatternLayout(size[0], size[1], pattern, bar);
  useEffect(() => {
    const element = holder.current!;
    const observer = new ResizeObserver(() => setSize([element.clientWidth, element.clientHeight]));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  const key = JSON.stringify([
    core.state.colours, pattern.limits, pattern.part.name, pattern.side, pattern.tooth, hovered, size, bar, core.theme.theme, pattern.envelope?.included.size,
  ]);
  useEffect(() => {
    const element = canvas.current!;
    if (size[0] < 1 || size[1] < 1) return;
    const ratio = window.devicePixelRatio || 1;
    element.width = Math.round(size[0] * ratio);
    element.height = Math.round(size[1] * ratio);
    const context = element.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    context.font = "11px system-ui, sans-serif";
    drawPattern(new CanvasPen(context), layout, pattern, core.state.colours, patternTheme(core), hovered);
  }, [key, core.display?.position]);
  const reading = pointer ? readingAt(pattern, layout, ...pointer) : null;
  return (
    <div class="cv-pattern-picture" ref={holder}>
      <canvas
        ref={canvas}
        role="img"
        aria-label={patternTitle(core, pattern)}
        onPointerMove={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          const at: [number, number] = [event.clientX - box.left, event.clientY - box.top];
          setPointer(at);
          core.hover(readingAt(pattern, layout, ...at)?.cell?.cell ?? -1);
        }}
        onPointerLeave={() => {
          setPointer(null);
          core.hover(-1);
        }}
      />
      {reading ? <ReadingView pattern={pattern} reading={reading} layout={layout} pointer={pointer!} /> : null}
    </div>
  );
}

function ReadingView({ pattern, reading, layout, pointer }: { pattern: Pattern; reading: Reading; layout: PatternLayout; pointer: [number, number] }) {
  const { value, z, r, cell } = reading;
  const stress = stressUnit();
  const unit = displayUnit("m", 1);
  const [u0, v0] = originOf(pattern);
  const { axes } = pattern;
  const number = (length: number) => `${formatNumber(length * unit.factor, 5)} ${unit.symbol}`;
  return (
    <div class="cv-tooltip" role="status" aria-label="Value in the pattern" data-value={Number.isFinite(value) ? String(value) : ""} style={beside(...pointer, layout.width, layout.height)}>
      <div class="cv-tooltip-value">
        <strong>{Number.isFinite(value) ? `${formatNumber(value * stress.factor, 6)} ${stress.symbol}` : "no contact"}</strong>
      </div>
      {cell ? <div>tooth {cell.tooth}</div> : null}
      <div class="cv-muted">z {number(z)}, radius {number(r)}</div>
      {axes.direction !== 0 ? (
        <div class="cv-muted">from the toe {number(axes.along(z, r) - u0)}, from the root {number(axes.across(z, r) - v0)}</div>
      ) : null}
    </div>
  );
}
