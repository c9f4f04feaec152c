// Export of the picture as PNG, SVG and PDF, with labels and legend.

import { cssColour, colourAt, banded } from "./colours.ts";
import type { Core } from "./core.ts";
import { legendTicks, legendTitle } from "./legend.ts";
import { drawPattern, escapeXml, PatternLayout, SvgPen, type PatternTheme } from "./pattern_drawing.ts";
import type { Pattern } from "./pattern_model.ts";
import { pdfOfJpeg } from "./pdf.ts";

export type ImageFormat = "png" | "svg" | "pdf";

/** Offset of the text of a label from its point, px, and its anchor. */
const ANCHORS = {
  right: [9, 4, "start"],
  left: [-9, 4, "end"],
  above: [0, -14, "middle"],
  below: [0, 22, "middle"],
} as const;

/** Pixels of the export per CSS pixel. */
const RATIO = 2;
const FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, sans-serif";
const LEGEND = { width: 16, height: 200, right: 92, top: 56 };

interface Drawing {
  width: number;
  height: number;
  text: string;
  muted: string;
  background: string;
  halo: string;
}

function drawing(core: Core): Drawing {
  const { width, height } = core.scene!;
  const style = getComputedStyle(core.element);
  const get = (name: string) => style.getPropertyValue(name).trim();
  return {
    width,
    height,
    text: get("--cv-text"),
    muted: get("--cv-muted"),
    background: get("--cv-stage"),
    halo: get("--cv-stage"),
  };
}

/** The vector part of the picture: labels, legend and title, as SVG elements. */
function annotations(core: Core, d: Drawing): string {
  const { scene, labels, state, display } = core;
  const out: string[] = [];
  const text = (x: number, y: number, content: string, options = "") =>
    out.push(
      `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" fill="${d.text}" stroke="${d.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke" ${options}>${escapeXml(content)}</text>`,
    );
  for (const label of labels.placed(scene!.camera.active, scene!.root.matrix, d.width, d.height)) {
    const hidden = label.hidden ? 'stroke-dasharray="3 2" opacity="0.6"' : "";
    if (label.kind === "maximum" || label.kind === "minimum") {
      out.push(`<circle cx="${label.x.toFixed(1)}" cy="${label.y.toFixed(1)}" r="4" fill="none" stroke="${d.text}" stroke-width="1.6" ${hidden}/>`);
    }
    const [dx, dy, anchor] = ANCHORS[label.side];
    text(label.x + dx, label.y + dy, label.text, `font-weight="600" text-anchor="${anchor}"${label.hidden ? ' opacity="0.7"' : ""}`);
  }
  const { limits } = display!;
  const { colours } = state;
  if (limits && colours.field !== "plain") {
    const x = d.width - LEGEND.right;
    const steps = colours.bands > 0 ? colours.bands : 64;
    for (let i = 0; i < steps; i++) {
      const colour = cssColour(colourAt(colours.scale, colours.bands > 0 ? banded((i + 0.5) / steps, steps) : i / (steps - 1)));
      const h = LEGEND.height / steps;
      const y = LEGEND.top + LEGEND.height - (i + 1) * h;
      out.push(`<rect x="${x}" y="${y.toFixed(2)}" width="${LEGEND.width}" height="${(h + 0.4).toFixed(2)}" fill="${colour}"/>`);
    }
    const { ticks, unit } = legendTicks(core);
    for (const tick of ticks) {
      text(x + LEGEND.width + 7, LEGEND.top + LEGEND.height * (1 - tick.fraction) + 4, tick.text);
    }
    text(d.width - 16, LEGEND.top - 18, `${legendTitle(core)}${unit ? ` in ${unit}` : ""}`, 'text-anchor="end" font-weight="600"');
  }
  const entry = core.positions?.list[state.position];
  const caption = [core.source?.title, entry ? `position ${entry.position}` : ""].filter(Boolean).join(", ");
  if (caption) text(16, d.height - 16, caption);
  if (core.hasMeshes) text(16, d.height - 36, `deformation × ${display!.factor}`);
  return out.join("\n");
}

function svgDocument(d: { width: number; height: number }, content: string): string {
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${d.width}" height="${d.height}" viewBox="0 0 ${d.width} ${d.height}" ` +
    `font-family="${FONT}" font-size="12">\n${content}\n</svg>\n`
  );
}

/** Scene with its background, without the annotations. */
function raster(core: Core, d: Drawing): HTMLCanvasElement {
  // The outline and the handle of the cut are controls, not part of the picture.
  const controls = core.display!.cut.group;
  const shown = controls.visible;
  controls.visible = false;
  const picture = core.scene!.snapshot(RATIO);
  controls.visible = shown;
  core.scene!.invalidate();
  const canvas = document.createElement("canvas");
  canvas.width = picture.width;
  canvas.height = picture.height;
  const context = canvas.getContext("2d")!;
  context.fillStyle = d.background;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(picture, 0, 0);
  return canvas;
}

/** Draws an SVG document onto a canvas. */
async function drawSvg(canvas: HTMLCanvasElement, svg: string): Promise<HTMLCanvasElement> {
  const image = new Image();
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    image.src = address;
    await image.decode();
    canvas.getContext("2d")!.drawImage(image, 0, 0, canvas.width, canvas.height);
  } finally {
    URL.revokeObjectURL(address);
  }
  return canvas;
}

function toBlob(canvas: HTMLCanvasElement, type: string, quality?: number): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture cannot be encoded"))), type, quality);
  });
}

export async function exportImage(core: Core, format: ImageFormat): Promise<Blob> {
  if (!core.scene || core.status !== "ready") throw new Error("there is no picture to export");
  core.updateMarks();
  const d = drawing(core);
  if (format === "svg") {
    const picture = raster(core, d).toDataURL("image/png");
    const content = `<image width="${d.width}" height="${d.height}" href="${picture}"/>\n${annotations(core, d)}`;
    return new Blob([svgDocument(d, content)], { type: "image/svg+xml" });
  }
  const canvas = await drawSvg(raster(core, d), svgDocument(d, annotations(core, d)));
  return encoded(canvas, format, core.source?.title ?? "");
}

async function encoded(canvas: HTMLCanvasElement, format: "png" | "pdf", title: string): Promise<Blob> {
  if (format === "png") return toBlob(canvas, "image/png");
  const jpeg = await toBlob(canvas, "image/jpeg", 0.94);
  return pdfOfJpeg(new Uint8Array(await jpeg.arrayBuffer()), canvas.width, canvas.height, title);
}

/** Colours of the page for a contact pattern. */
export function patternTheme(core: Core): PatternTheme {
  const style = getComputedStyle(core.element);
  const get = (name: string) => style.getPropertyValue(name).trim();
  return { text: get("--cv-text"), muted: get("--cv-muted"), line: get("--cv-line"), flank: get("--cv-flank"), mark: get("--cv-mark") };
}

/** Description of a contact pattern. */
export function patternTitle(core: Core, { part, tooth, side, envelope }: Pattern): string {
  const entry = core.positions?.list[core.state.position];
  const total = core.positions?.list.length ?? 0;
  const positions = envelope
    ? `maximum over ${envelope.included.size < total ? `${envelope.included.size} of ` : ""}${total} positions`
    : `position ${entry?.position ?? 0}`;
  const cells = { all: "", flanks: ", without edges", edges: ", edges only" }[core.state.colours.cells];
  return `Contact pattern of ${part.name}, ${tooth === null ? "all teeth" : `tooth ${tooth}`}, ${side} flank, ${positions}${cells}`;
}

/** Size of an exported pattern, CSS pixels. */
const PATTERN = { width: 960, height: 420, title: 34 };

/** Contact pattern as a picture; the SVG file consists of vectors. */
export async function exportPattern(core: Core, format: ImageFormat): Promise<Blob> {
  const pattern = core.pattern.pattern();
  if (!pattern) throw new Error("there is no contact pattern to export");
  const { width, height, title } = PATTERN;
  const pen = new SvgPen();
  const theme = patternTheme(core);
  drawPattern(pen, new PatternLayout(width, height - title, pattern), pattern, core.state.colours, theme);
  const background = getComputedStyle(core.element).getPropertyValue("--cv-bg").trim();
  const text = [core.source?.title, patternTitle(core, pattern)].filter(Boolean).join(": ");
  const svg = svgDocument(
    PATTERN,
    `<rect width="${width}" height="${height}" fill="${background}"/>\n` +
      `<text x="16" y="22" fill="${theme.text}" font-weight="600">${escapeXml(text)}</text>\n` +
      `<g transform="translate(0 ${title})">\n${pen.elements.join("\n")}\n</g>`,
  );
  if (format === "svg") return new Blob([svg], { type: "image/svg+xml" });
  const canvas = document.createElement("canvas");
  canvas.width = RATIO * width;
  canvas.height = RATIO * height;
  return encoded(await drawSvg(canvas, svg), format, text);
}

/** Exports the picture and offers it as a download. */
export async function download(core: Core, format: ImageFormat): Promise<void> {
  offer(core, await exportImage(core, format), format);
}

/** Exports the contact pattern and offers it as a download. */
export async function downloadPattern(core: Core, format: ImageFormat): Promise<void> {
  offer(core, await exportPattern(core, format), `pattern.${format}`);
}

function offer(core: Core, blob: Blob, ending: string): void {
  const link = document.createElement("a");
  const name = (core.source?.title ?? "view").replace(/[^\p{L}\p{N}._-]+/gu, "_") || "view";
  link.href = URL.createObjectURL(blob);
  link.download = `${name}.${ending}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
