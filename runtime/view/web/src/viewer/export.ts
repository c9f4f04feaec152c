// Export of the picture as PNG, SVG and PDF, with labels and legend.

import { cssColour, colourAt, banded } from "./colours.ts";
import type { Core } from "./core.ts";
import { legendTicks, legendTitle } from "./legend.ts";
import { pdfOfJpeg } from "./pdf.ts";

export type ImageFormat = "png" | "svg" | "pdf";

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
    if (label.kind === "maximum" || label.kind === "minimum") {
      out.push(`<circle cx="${label.x.toFixed(1)}" cy="${label.y.toFixed(1)}" r="4" fill="none" stroke="${d.text}" stroke-width="1.6"/>`);
    }
    text(label.x + 9, label.y + 4, label.text, 'font-weight="600"');
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

function escapeXml(text: string): string {
  return text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]!);
}

function svgDocument(d: Drawing, content: string): string {
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

/** Draws the annotations onto the picture. */
async function composed(core: Core, d: Drawing): Promise<HTMLCanvasElement> {
  const canvas = raster(core, d);
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgDocument(d, annotations(core, d)))}`;
  await image.decode();
  canvas.getContext("2d")!.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas;
}

function toBlob(canvas: HTMLCanvasElement, type: string, quality?: number): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture cannot be encoded"))), type, quality);
  });
}

export async function exportImage(core: Core, format: ImageFormat): Promise<Blob> {
  if (!core.scene || core.status !== "ready") throw new Error("there is no picture to export");
  const d = drawing(core);
  if (format === "svg") {
    const picture = raster(core, d).toDataURL("image/png");
    const content = `<image width="${d.width}" height="${d.height}" href="${picture}"/>\n${annotations(core, d)}`;
    return new Blob([svgDocument(d, content)], { type: "image/svg+xml" });
  }
  const canvas = await composed(core, d);
  if (format === "png") return toBlob(canvas, "image/png");
  const jpeg = await toBlob(canvas, "image/jpeg", 0.94);
  return pdfOfJpeg(new Uint8Array(await jpeg.arrayBuffer()), canvas.width, canvas.height, core.source?.title ?? "");
}

/** Exports the picture and offers it as a download. */
export async function download(core: Core, format: ImageFormat): Promise<void> {
  const blob = await exportImage(core, format);
  const link = document.createElement("a");
  const name = (core.source?.title ?? "view").replace(/[^\p{L}\p{N}._-]+/gu, "_") || "view";
  link.href = URL.createObjectURL(blob);
  link.download = `${name}.${format}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
