// Colour scales and the colours of parts.

import * as THREE from "three";
import type { ColourState } from "./state.ts";

export type Rgb = [number, number, number];

/** Number of samples of a scale in its texture. */
const SAMPLES = 256;

// Samples at equal distances. Viridis (van der Walt and Smith 2015) and cividis (Nuñez et al. 2018)
// are perceptually uniform and readable with deficient colour vision. Turbo (Mikhailov 2019) shows
// more detail, but is not safe for deficient colour vision.
const SCALES: Record<ColourState["scale"], { label: string; colours: string[] }> = {
  viridis: {
    label: "Viridis",
    colours: ["#440154", "#482475", "#414487", "#355f8d", "#2a788e", "#21918c", "#22a884", "#44bf70", "#7ad151", "#bddf26", "#fde725"],
  },
  cividis: {
    label: "Cividis",
    colours: ["#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838"],
  },
  turbo: {
    label: "Turbo",
    colours: ["#30123b", "#4145ab", "#4675ed", "#39a2fc", "#1bcfd4", "#24eca6", "#61fc6c", "#a4fc3b", "#d1e834", "#f3c63a", "#fe9b2d", "#f36315", "#d93806", "#b11901", "#7a0402"],
  },
  grey: { label: "Grey", colours: ["#1a1a1a", "#f2f2f2"] },
};

export const SCALE_NAMES = Object.entries(SCALES).map(([name, { label }]) => ({
  name: name as ColourState["scale"],
  label,
}));

export function parseHex(text: string): Rgb {
  const n = parseInt(text.slice(1), 16);
  return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
}

/** Colour of a scale at a fraction from 0 to 1, as sRGB bytes. */
export function colourAt(scale: ColourState["scale"], fraction: number): Rgb {
  const { colours } = SCALES[scale] ?? SCALES.viridis;
  const x = Math.min(Math.max(fraction, 0), 1) * (colours.length - 1);
  const i = Math.min(Math.floor(x), colours.length - 2);
  const from = parseHex(colours[i]!);
  const to = parseHex(colours[i + 1]!);
  const t = x - i;
  return from.map((value, k) => Math.round(value + t * (to[k]! - value))) as Rgb;
}

/** Fraction of the middle of the band in which a fraction lies; the fraction itself without bands. */
export function banded(fraction: number, bands: number): number {
  if (bands < 1) return fraction;
  const band = Math.min(Math.max(Math.floor(fraction * bands), 0), bands - 1);
  return bands === 1 ? 0.5 : band / (bands - 1);
}

export function cssColour([r, g, b]: Rgb): string {
  return `rgb(${r} ${g} ${b})`;
}

/** Fills the texture in which the shaders look up colours. Bands are steps of the texture. */
export function fillScaleTexture(texture: THREE.DataTexture, scale: ColourState["scale"], bands: number): void {
  const data = texture.image.data as Uint8Array;
  for (let i = 0; i < SAMPLES; i++) {
    const [r, g, b] = colourAt(scale, banded(i / (SAMPLES - 1), bands));
    data.set([r, g, b, 255], 4 * i);
  }
  const filter = bands > 0 ? THREE.NearestFilter : THREE.LinearFilter;
  texture.minFilter = filter;
  texture.magFilter = filter;
  texture.needsUpdate = true;
}

export function createScaleTexture(): THREE.DataTexture {
  const texture = new THREE.DataTexture(new Uint8Array(4 * SAMPLES), SAMPLES, 1, THREE.RGBAFormat);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

// Muted colours of nearly equal lightness, which also differ with deficient colour vision. Shafts and
// bearings are neutral, so that the gears stand out.
const GEAR_COLOURS = ["#7f9db9", "#c9a66b", "#8fb09a", "#b58a9b", "#9a95bd", "#b9b08a", "#76a9ae", "#c08f76"];
const KIND_COLOURS: Record<string, string[]> = {
  gear: GEAR_COLOURS,
  shaft: ["#a9adb3", "#b7b2aa", "#9ea6ac"],
  bearing: ["#8a8f98", "#969089"],
  body: ["#b4bcc4", "#c0b9ae", "#aab7b0"],
};

/** Colour of the n-th part of a kind. */
export function partColour(kind: string, n: number): string {
  const colours = KIND_COLOURS[kind] ?? GEAR_COLOURS;
  return colours[n % colours.length]!;
}
