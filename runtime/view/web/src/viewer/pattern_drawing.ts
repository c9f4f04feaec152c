// Drawing of a contact pattern, on a canvas or as SVG.

import { banded, colourAt, cssColour } from "./colours.ts";
import { flankBounds } from "./pattern.ts";
import type { Pattern } from "./pattern_model.ts";
import type { ColourState } from "./state.ts";
import { roundTicks, scaleTicks } from "./ticks.ts";
import { toothOf } from "./tooth.ts";
import { displayUnit, formatNumber, stressUnit } from "./units.ts";

/** Colours of the page. */
export interface PatternTheme {
  text: string;
  muted: string;
  line: string;
  flank: string;
  mark: string;
}

type Anchor = "start" | "middle" | "end";

/** What the drawing needs of a canvas or an SVG document. */
export interface Pen {
  /** Fills areas. `seamless` covers the gaps that antialiasing leaves between neighbours. */
  fill(loops: number[][], colour: string, seamless?: boolean): void;
  stroke(points: number[], colour: string, width: number, closed?: boolean): void;
  text(x: number, y: number, text: string, colour: string, anchor: Anchor, upright?: boolean): void;
}

const MARGIN = { left: 58, right: 92, top: 20, bottom: 36 };
const BAR = 14;
/** Width of the line that covers the seam between areas of equal colours, pixels. */
const SEAM = 0.6;

/** Map from the picture of a flank to pixels, with equal scales in both directions. */
export class PatternLayout {
  readonly scale: number;
  readonly #x: number;
  readonly #y: number;
  readonly right: number;
  readonly top: number;
  readonly left: number;
  readonly bottom: number;

  constructor(
    readonly width: number,
    readonly height: number,
    { bounds }: Pattern,
    /** The picture has a legend of the colours. */
    readonly bar = true,
  ) {
    const w = Math.max(width - MARGIN.left - (bar ? MARGIN.right : 12), 40);
    const h = Math.max(height - MARGIN.top - MARGIN.bottom, 30);
    this.scale = Math.min(w / (bounds.u1 - bounds.u0), h / (bounds.v1 - bounds.v0));
    this.left = MARGIN.left + (w - this.scale * (bounds.u1 - bounds.u0)) / 2;
    this.bottom = MARGIN.top + (h + this.scale * (bounds.v1 - bounds.v0)) / 2;
    this.right = this.left + this.scale * (bounds.u1 - bounds.u0);
    this.top = this.bottom - this.scale * (bounds.v1 - bounds.v0);
    this.#x = this.left - this.scale * bounds.u0;
    this.#y = this.bottom + this.scale * bounds.v0;
  }

  x(u: number): number {
    return this.#x + this.scale * u;
  }

  y(v: number): number {
    return this.#y - this.scale * v;
  }

  /** Point of the flank's picture at a pixel. */
  inverse(x: number, y: number): [number, number] {
    return [(x - this.#x) / this.scale, (this.#y - y) / this.scale];
  }
}

/** Colour of a pressure. */
export function pressureColour(pressure: number, [low, high]: readonly [number, number], colours: ColourState): string {
  const fraction = Math.min(Math.max((pressure - low) / (high - low || 1), 0), 1);
  return cssColour(colourAt(colours.scale, banded(fraction, colours.bands)));
}

/** Draws a pattern: flank, cells, axes and legend. `hovered` is the index of a marked cell. */
export function drawPattern(pen: Pen, layout: PatternLayout, pattern: Pattern, colours: ColourState, theme: PatternTheme, hovered = -1): void {
  const { axes, side, part, limits } = pattern;
  const pixels = (corners: number[]) => {
    const result: number[] = [];
    for (let k = 0; k < corners.length; k += 2) {
      const [z, r] = [corners[k]!, corners[k + 1]!];
      result.push(layout.x(axes.along(z, r)), layout.y(axes.across(z, r)));
    }
    return result;
  };
  const outline = (toothOf(part)?.flanks[side].outline ?? []).map(pixels);
  pen.fill(outline, theme.flank);
  if (pattern.envelope) drawEnvelope(pen, layout, pattern, colours);
  for (const { corners, pressure } of pattern.cells) pen.fill([pixels(corners)], pressureColour(pressure, limits, colours), true);
  for (const loop of outline) pen.stroke(loop, theme.muted, 1, true);
  const marked = pattern.cells.find(({ cell }) => cell === hovered);
  if (marked) pen.stroke(pixels(marked.corners), theme.mark, 2, true);
  drawAxes(pen, layout, pattern, theme);
  if (layout.bar) drawBar(pen, layout, limits, colours, theme);
}

/** Squares of equal colour side by side are one rectangle. */
function drawEnvelope(pen: Pen, layout: PatternLayout, { envelope, limits }: Pattern, colours: ColourState): void {
  const { bounds, columns, rows, values } = envelope!;
  const width = (bounds.u1 - bounds.u0) / columns;
  const height = (bounds.v1 - bounds.v0) / rows;
  for (let j = 0; j < rows; j++) {
    const top = layout.y(bounds.v0 + (j + 1) * height);
    const bottom = layout.y(bounds.v0 + j * height);
    for (let i = 0; i < columns; ) {
      const value = values[j * columns + i]!;
      const start = i++;
      if (!(value > 0)) continue;
      const colour = pressureColour(value, limits, colours);
      while (i < columns && values[j * columns + i]! > 0 && pressureColour(values[j * columns + i]!, limits, colours) === colour) i++;
      const [x0, x1] = [layout.x(bounds.u0 + start * width), layout.x(bounds.u0 + i * width)];
      pen.fill([[x0, top, x1, top, x1, bottom, x0, bottom]], colour, true);
    }
  }
}

/** Origins of the axes: z and radius themselves, or on conical gears the toe and the root. */
export function originOf({ part, side, axes }: Pattern): [number, number] {
  if (axes.direction === 0) return [0, 0];
  const { u0, v0 } = flankBounds(part, side, axes);
  return [u0, v0];
}

function drawAxes(pen: Pen, layout: PatternLayout, pattern: Pattern, theme: PatternTheme): void {
  const { left, right, top, bottom } = layout;
  const { factor, symbol } = displayUnit("m", 1);
  const { bounds, axes } = pattern;
  const [u0, v0] = originOf(pattern);
  const cylindrical = axes.direction === 0;
  pen.stroke([left, top, left, bottom, right, bottom], theme.muted, 1);
  for (const tick of roundTicks((bounds.u0 - u0) * factor, (bounds.u1 - u0) * factor, Math.min((right - left) / 60, 10))) {
    const x = layout.x(tick / factor + u0);
    pen.stroke([x, bottom, x, bottom + 4], theme.muted, 1);
    pen.text(x, bottom + 15, formatNumber(tick), theme.muted, "middle");
  }
  for (const tick of roundTicks((bounds.v0 - v0) * factor, (bounds.v1 - v0) * factor, Math.min((bottom - top) / 26, 8))) {
    const y = layout.y(tick / factor + v0);
    pen.stroke([left - 4, y, left, y], theme.muted, 1);
    pen.text(left - 7, y + 4, formatNumber(tick), theme.muted, "end");
  }
  const [low, high, lower, upper] = axes.ends;
  pen.text(left, bottom + 30, low, theme.muted, "start");
  pen.text(right, bottom + 30, high, theme.muted, "end");
  pen.text(left - 16, bottom + 16, lower, theme.muted, "end");
  pen.text(left - 16, top - 8, upper, theme.muted, "end");
  pen.text((left + right) / 2, bottom + 30, `${cylindrical ? "z" : "along the face"} in ${symbol}`, theme.text, "middle");
  pen.text(left - 44, (top + bottom) / 2, `${cylindrical ? "radius" : "across the face"} in ${symbol}`, theme.text, "middle", true);
}

function drawBar(pen: Pen, layout: PatternLayout, limits: readonly [number, number], colours: ColourState, theme: PatternTheme): void {
  const x = layout.width - MARGIN.right + 22;
  const [top, bottom] = [MARGIN.top + 16, layout.height - MARGIN.bottom];
  const unit = stressUnit();
  const steps = colours.bands > 0 ? colours.bands : 48;
  for (let i = 0; i < steps; i++) {
    const value = limits[0] + ((i + 0.5) / steps) * (limits[1] - limits[0]);
    const [y0, y1] = [bottom - (i * (bottom - top)) / steps, bottom - ((i + 1) * (bottom - top)) / steps];
    pen.fill([[x, y0, x + BAR, y0, x + BAR, y1, x, y1]], pressureColour(value, limits, colours), true);
  }
  pen.text(x, top - 7, unit.symbol, theme.text, "start");
  const [low, high] = [limits[0] * unit.factor, limits[1] * unit.factor];
  for (const value of scaleTicks(low, high, bottom - top < 90 ? 2 : 4)) {
    const y = bottom - ((value - low) / (high - low || 1)) * (bottom - top);
    pen.text(x + BAR + 6, y + 4, formatNumber(value), theme.muted, "start");
  }
}

/** Draws on a canvas. */
export class CanvasPen implements Pen {
  constructor(private readonly context: CanvasRenderingContext2D) {}

  fill(loops: number[][], colour: string, seamless = false): void {
    const { context } = this;
    context.fillStyle = colour;
    context.beginPath();
    for (const loop of loops) this.path(loop, true);
    context.fill("evenodd");
    if (!seamless) return;
    context.strokeStyle = colour;
    context.lineWidth = SEAM;
    context.stroke();
  }

  stroke(points: number[], colour: string, width: number, closed = false): void {
    const { context } = this;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    this.path(points, closed);
    context.stroke();
  }

  private path(points: number[], closed: boolean): void {
    const { context } = this;
    for (let i = 0; i < points.length; i += 2) {
      if (i === 0) context.moveTo(points[0]!, points[1]!);
      else context.lineTo(points[i]!, points[i + 1]!);
    }
    if (closed) context.closePath();
  }

  text(x: number, y: number, text: string, colour: string, anchor: Anchor, upright = false): void {
    const { context } = this;
    context.fillStyle = colour;
    context.textAlign = anchor === "middle" ? "center" : anchor;
    context.save();
    context.translate(x, y);
    if (upright) context.rotate(-Math.PI / 2);
    context.fillText(text, 0, 0);
    context.restore();
  }
}

/** Collects SVG elements. */
export class SvgPen implements Pen {
  readonly elements: string[] = [];

  fill(loops: number[][], colour: string, seamless = false): void {
    if (loops.length === 0) return;
    this.elements.push(`<path d="${loops.map((loop) => path(loop, true)).join("")}" fill="${colour}"${seamless ? ` stroke="${colour}" stroke-width="${SEAM}"` : ' fill-rule="evenodd"'}/>`);
  }

  stroke(points: number[], colour: string, width: number, closed = false): void {
    this.elements.push(`<path d="${path(points, closed)}" fill="none" stroke="${colour}" stroke-width="${width}"/>`);
  }

  text(x: number, y: number, text: string, colour: string, anchor: Anchor, upright = false): void {
    const turn = upright ? ` transform="rotate(-90 ${x.toFixed(1)} ${y.toFixed(1)})"` : "";
    this.elements.push(`<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" fill="${colour}" text-anchor="${anchor}"${turn}>${escapeXml(text)}</text>`);
  }
}

function path(points: number[], closed: boolean): string {
  let text = "";
  for (let i = 0; i < points.length; i += 2) text += `${i === 0 ? "M" : "L"}${points[i]!.toFixed(2)} ${points[i + 1]!.toFixed(2)}`;
  return closed ? `${text}Z` : text;
}

export function escapeXml(text: string): string {
  return text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]!);
}
