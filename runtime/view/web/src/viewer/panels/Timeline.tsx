// Animation: play, step, slider over the positions.

import type { Core } from "../core.ts";
import { displayUnit, formatNumber } from "../units.ts";
import { Select, Tool } from "./ui.tsx";

/** Explanation of the number of a position. */
export const NUMBERS = "Positions count from 0, like the column step of steps.csv";
const SPEEDS = [1, 2, 5, 10, 20, 30, 60];

export function Timeline({ core }: { core: Core }) {
  const list = core.positions?.list ?? [];
  const { state, animation } = core;
  if (list.length === 0) return <div class="cv-timeline cv-muted">No positions yet</div>;
  const entry = list[Math.min(state.position, list.length - 1)]!;
  const last = list[list.length - 1]!;
  const unit = displayUnit("s", Math.max(Math.abs(last.time), Math.abs(list[0]!.time)));
  const time = `${formatNumber(entry.time * unit.factor)} ${unit.symbol}`;
  const several = list.length > 1;
  return (
    <div class="cv-timeline" role="group" aria-label="Animation">
      <Tool icon="previous" label="Previous position" shortcut="," disabled={!several} onClick={() => animation.step(-1)} />
      <Tool
        icon={animation.playing ? "pause" : "play"}
        label={animation.playing ? "Pause" : "Play"}
        shortcut="K"
        disabled={!several}
        onClick={() => animation.toggle()}
      />
      <Tool icon="next" label="Next position" shortcut="." disabled={!several} onClick={() => animation.step(1)} />
      <input
        class="cv-time"
        type="range"
        min={0}
        max={list.length - 1}
        step={1}
        value={state.position}
        disabled={!several}
        aria-label="Position"
        aria-valuetext={`position ${entry.position}, ${time}`}
        onInput={(event) => {
          animation.stop();
          void core.goTo(Number(event.currentTarget.value));
        }}
      />
      <output class="cv-clock">
        <span title={NUMBERS}>
          {core.narrow ? "" : "Position "}
          {entry.position}
          {several ? <span class="cv-muted"> ({list[0]!.position} to {last.position})</span> : null}
        </span>
        <span class="cv-clock-time">{time}</span>
      </output>
      {core.narrow ? null : <SpeedControls core={core} />}
    </div>
  );
}

/** Speed and repetition of the animation. */
export function SpeedControls({ core }: { core: Core }) {
  const { state } = core;
  return (
    <>
      <Select
        quiet
        label="Speed, positions per second"
        value={String(state.animation.speed)}
        options={[...new Set([...SPEEDS, state.animation.speed])].sort((a, b) => a - b).map((speed) => ({ value: String(speed), label: `${speed} / s` }))}
        onChange={(speed) => core.update({ animation: { speed: Number(speed) } })}
      />
      <Tool
        icon="loop"
        label="Loop"
        pressed={state.animation.loop}
        onClick={() => core.update({ animation: { loop: !state.animation.loop } })}
      />
    </>
  );
}
