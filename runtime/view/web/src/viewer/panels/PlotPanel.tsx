// Plots of the outputs over the positions, with a cursor at the displayed position.

import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { Core } from "../core.ts";
import type { OutputColumn } from "../source.ts";
import { displayUnit, formatNumber } from "../units.ts";
import { Select } from "./ui.tsx";

/** Columns that count or order the positions; they are axes, not outputs. */
const AXES = new Set(["step", "time", "cycle", "roll_angle", "position"]);

function largest(column: OutputColumn): number {
  return column.values.reduce<number>((m, v) => (v !== null && Number.isFinite(v) ? Math.max(m, Math.abs(v)) : m), 0);
}

export function PlotPanel({ core }: { core: Core }) {
  const columns = core.source?.outputs?.columns ?? [];
  const outputs = columns.filter((column) => !AXES.has(column.name) && column.values.some((v) => typeof v === "number" && Number.isFinite(v)));
  const name = outputs.find((column) => core.state.plotted.includes(column.name))?.name ?? outputs[0]?.name ?? "";
  const column = outputs.find((candidate) => candidate.name === name);
  const time = columns.find((candidate) => candidate.name === "time");
  return (
    <section class="cv-plots" aria-label="Plots">
      {column ? (
        <>
          <div class="cv-plots-head">
            <Select
              quiet
              label="Output"
              value={name}
              options={outputs.map((output) => ({ value: output.name, label: output.name.replaceAll("_", " ") }))}
              onChange={(output) => core.update({ plotted: [output] })}
            />
            <CurrentValue core={core} column={column} time={time} />
          </div>
          <Plot core={core} column={column} time={time} />
        </>
      ) : (
        <div class="cv-muted">This run has no outputs over the positions.</div>
      )}
    </section>
  );
}

/** Row of the outputs that belongs to the displayed position. */
function currentRow(core: Core, time: OutputColumn | undefined): number {
  const entry = core.positions?.list[core.state.position];
  if (!entry || !time) return core.state.position;
  let best = 0;
  time.values.forEach((t, i) => {
    if (Math.abs((t ?? Infinity) - entry.time) < Math.abs((time.values[best] ?? Infinity) - entry.time)) best = i;
  });
  return best;
}

function CurrentValue({ core, column, time }: { core: Core; column: OutputColumn; time: OutputColumn | undefined }) {
  const value = column.values[currentRow(core, time)] ?? NaN;
  const unit = displayUnit(column.unit, largest(column));
  return (
    <output class="cv-muted">{Number.isFinite(value) ? `${formatNumber(value * unit.factor, 5)} ${unit.symbol}` : "no value"}</output>
  );
}

function Plot({ core, column, time }: { core: Core; column: OutputColumn; time: OutputColumn | undefined }) {
  const holder = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const row = currentRow(core, time);
  const { theme } = core.theme;

  useEffect(() => {
    const element = holder.current!;
    const style = getComputedStyle(core.element);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    const unit = displayUnit(column.unit, largest(column));
    const timeUnit = displayUnit("s", time ? largest(time) : 0);
    const x = time ? time.values.map((t) => (t ?? NaN) * timeUnit.factor) : column.values.map((_, i) => i);
    const y = column.values.map((v) => (v === null || !Number.isFinite(v) ? null : v * unit.factor));
    const axis = (label: string): uPlot.Axis => ({
      label,
      labelSize: 18,
      size: 44,
      font: "11px system-ui, sans-serif",
      labelFont: "11px system-ui, sans-serif",
      stroke: colour("--cv-muted"),
      grid: { stroke: colour("--cv-line"), width: 1 },
      ticks: { stroke: colour("--cv-line"), width: 1, size: 4 },
    });
    const created = new uPlot(
      {
        width: element.clientWidth,
        height: element.clientHeight,
        scales: { x: { time: false } },
        legend: { show: false },
        cursor: { y: false, points: { size: 7 }, drag: { x: false, y: false } },
        series: [{}, { stroke: colour("--cv-accent"), width: 1.75, points: { show: x.length < 60 } }],
        axes: [
          { ...axis(time ? `time in ${timeUnit.symbol}` : "position"), size: 30 },
          { ...axis(unit.symbol), size: 56 },
        ],
        hooks: { drawAxes: [(u) => drawCursor(u, colour("--cv-mark"))] },
      },
      [x, y],
      element,
    );
    plot.current = created;
    // A click displays the position nearest in time.
    created.over.addEventListener("click", () => {
      const index = created.cursor.idx;
      const list = core.positions?.list ?? [];
      if (index == null || list.length === 0) return;
      const at = time ? (time.values[index] ?? 0) : index;
      let best = 0;
      list.forEach((_, i) => {
        const distance = (k: number) => Math.abs((time ? list[k]!.time : k) - at);
        if (distance(i) < distance(best)) best = i;
      });
      core.animation.stop();
      void core.goTo(best);
    });
    const observer = new ResizeObserver(() => created.setSize({ width: element.clientWidth, height: element.clientHeight }));
    observer.observe(element);
    return () => {
      observer.disconnect();
      created.destroy();
      plot.current = null;
    };
  }, [core, column, time, theme]);

  useEffect(() => {
    rows.set(plot.current!, row);
    plot.current?.redraw(false);
  }, [row, column, time, theme]);

  return <div class="cv-plot" ref={holder} role="img" aria-label={`${column.name.replaceAll("_", " ")} over ${time ? "time" : "positions"}`} />;
}

/** Row of the displayed position for each plot. */
const rows = new WeakMap<uPlot, number>();

function drawCursor(plot: uPlot, colour: string): void {
  const row = rows.get(plot);
  const at = row === undefined ? undefined : plot.data[0][row];
  if (at === undefined) return;
  const x = Math.round(plot.valToPos(at, "x", true)) + 0.5;
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.strokeStyle = colour;
  ctx.lineWidth = 1.5 * (window.devicePixelRatio || 1);
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
}
