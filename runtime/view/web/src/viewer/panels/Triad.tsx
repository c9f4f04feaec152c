// Axes of the ground, in the lower left corner.

import { useEffect, useRef } from "preact/hooks";
import type { Core } from "../core.ts";

const AXES = [
  { name: "x", azimuth: 0, elevation: 0, v: [1, 0, 0] },
  { name: "y", azimuth: 90, elevation: 0, v: [0, 1, 0] },
  { name: "z", azimuth: -90, elevation: 90, v: [0, 0, 1] },
] as const;

export function Triad({ core }: { core: Core }) {
  const svg = useRef<SVGSVGElement>(null);
  useEffect(() => update(core, svg.current!));
  return (
    <svg class="cv-triad" viewBox="-34 -34 68 68" ref={svg} aria-hidden="true">
      {AXES.map(({ name }) => (
        <g key={name} class={`cv-axis-${name}`}>
          <line />
          <text text-anchor="middle" dominant-baseline="central">
            {name}
          </text>
        </g>
      ))}
    </svg>
  );
}

function update(core: Core, svg: SVGSVGElement): void {
  const camera = core.state.camera ?? core.scene?.camera.state;
  if (!camera) return;
  const a = (camera.azimuth * Math.PI) / 180;
  const e = (camera.elevation * Math.PI) / 180;
  const right = [-Math.sin(a), Math.cos(a), 0];
  const up = [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)];
  AXES.forEach(({ v }, i) => {
    const x = v[0] * right[0]! + v[1] * right[1]! + v[2] * right[2]!;
    const y = -(v[0] * up[0]! + v[1] * up[1]! + v[2] * up[2]!);
    const group = svg.children[i]!;
    const [line, text] = [group.children[0]!, group.children[1]!];
    line.setAttribute("x2", String(20 * x));
    line.setAttribute("y2", String(20 * y));
    text.setAttribute("x", String(28 * x));
    text.setAttribute("y", String(28 * y));
    // An axis towards the eye has no direction in the picture.
    group.setAttribute("opacity", Math.hypot(x, y) < 0.12 ? "0.15" : "1");
  });
}
