// Colours of compared runs. They differ in lightness as well, for readers who distinguish few hues.

const COLOURS = ["#2f6fb3", "#c8641b", "#2c8a57", "#8c4fa8", "#b3324b", "#6b7280", "#0f8b8d", "#a8861b"];

/** Number of colours. Those of later runs repeat. */
export const COLOUR_COUNT = COLOURS.length;

/** Colour of the run at a place of the selection. */
export function colourOf(place: number): string {
  return COLOURS[place % COLOURS.length] ?? "#2f6fb3";
}
