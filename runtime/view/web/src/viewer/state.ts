// State of a view: everything that a user can set, as a small readable JSON object.

export type Visibility = "visible" | "translucent" | "hidden";
export type Field =
  | "plain"
  | "contact_pressure"
  | "max_principal"
  | "min_principal"
  | "von_mises"
  | "stress_error"
  | "displacement";
export type Projection = "perspective" | "orthographic";
export type StandardView = "front" | "back" | "left" | "right" | "top" | "bottom" | "isometric";
export type ThemeChoice = "system" | "light" | "dark";
export type Axis = "x" | "y" | "z";
export type Vector = [number, number, number];
/** Contact cells that are displayed: all, those of the flank zone, or those of the edge zone. */
export type CellChoice = "all" | "flanks" | "edges";

export interface CameraState {
  projection: Projection;
  /** Point at the centre of the picture, m. */
  target: Vector;
  /** Direction of the eye about the z axis, degrees. */
  azimuth: number;
  /** Elevation of the eye above the xy plane, degrees. */
  elevation: number;
  /** Height of the picture in the plane of the target, m. */
  height: number;
  /** The picture is fitted: target and height follow its shape. */
  fitted?: boolean;
}

export interface ColourState {
  field: Field;
  scale: "viridis" | "cividis" | "turbo" | "grey";
  /** Number of bands; 0 for a continuous scale. */
  bands: number;
  limits: "position" | "all" | "fixed";
  /** Fixed limits in SI units. */
  min: number;
  max: number;
  /** Contact cells of which the pressure is displayed. */
  cells: CellChoice;
}

export interface DeformationState {
  /** Automatic: a round factor that makes displacements visible while a field of the meshes is displayed. */
  mode: "automatic" | "factor";
  factor: number;
}

export interface ForceState {
  bearings: boolean;
  meshes: boolean;
  labels: boolean;
  /** Factor on the automatic length of the arrows. */
  scale: number;
}

export interface CutState {
  on: boolean;
  /** Normal of the plane: an axis, or the direction of the view when the plane was set. */
  normal: Axis | Vector;
  /** Distance of the plane from the origin along the normal, m. Null for the middle of the scene. */
  offset: number | null;
  flipped: boolean;
}

export interface AnimationState {
  /** Positions per second. */
  speed: number;
  loop: boolean;
}

export interface PanelState {
  parts: boolean;
  settings: boolean;
  plots: boolean;
  /** Contact pattern on an unrolled flank. */
  pattern: boolean;
}

export interface PatternState {
  /** Name of the gear; empty for the first one with contacts. */
  gear: string;
  /** `all` superimposes all teeth, `pointer` follows the pointer; otherwise the number of a tooth. */
  tooth: string;
  /** Flank, as seen from the positive z axis with the tooth upright. Automatic is the one with more load. */
  flank: "automatic" | "left" | "right";
  /** Maximum over all positions instead of the displayed position. */
  envelope: boolean;
}

export interface ViewState {
  version: 1;
  /** Null before the first scene is fitted. */
  camera: CameraState | null;
  /** Parts that are not fully visible, by name. */
  parts: Record<string, Visibility>;
  colours: ColourState;
  deformation: DeformationState;
  /** Edges of the finite elements. */
  mesh_edges: boolean;
  /** Contact cells behind other surfaces are drawn faintly. */
  hidden_contacts: boolean;
  /** The largest and the smallest value are marked. */
  extremes: boolean;
  forces: ForceState;
  cut: CutState;
  /** Name of the part that stands still, or null for the ground. */
  frame: string | null;
  /** Place in the list of positions. */
  position: number;
  animation: AnimationState;
  theme: ThemeChoice;
  panels: PanelState;
  pattern: PatternState;
  /** Names of the plotted outputs; empty for the first one. */
  plotted: string[];
}

export function defaultState(): ViewState {
  return {
    version: 1,
    camera: null,
    parts: {},
    colours: { field: "plain", scale: "viridis", bands: 0, limits: "position", min: 0, max: 1, cells: "all" },
    deformation: { mode: "automatic", factor: 1 },
    mesh_edges: false,
    hidden_contacts: true,
    extremes: true,
    forces: { bearings: false, meshes: false, labels: true, scale: 1 },
    cut: { on: false, normal: "z", offset: null, flipped: false },
    frame: null,
    position: 0,
    animation: { speed: 10, loop: true },
    theme: "system",
    panels: { parts: true, settings: false, plots: false, pattern: false },
    pattern: { gear: "", tooth: "all", flank: "automatic", envelope: false },
    plotted: [],
  };
}

/** A state of which any part may be missing, as read from a file. */
export type PartialState = {
  [K in keyof ViewState]?: ViewState[K] extends unknown[]
    ? ViewState[K]
    : ViewState[K] extends object
      ? Partial<ViewState[K]>
      : ViewState[K] | null;
};

/** Completes a state from a file with defaults; ignores entries of the wrong type. */
export function completeState(partial: PartialState, base = defaultState()): ViewState {
  const result = structuredClone(base) as unknown as Record<string, unknown>;
  const given = (partial ?? {}) as Record<string, unknown>;
  for (const [key, fallback] of Object.entries(result)) {
    const value = given[key];
    if (value === undefined || key === "version") continue;
    const mergeable = isRecord(fallback) && key !== "parts" && key !== "camera";
    if (mergeable) {
      if (isRecord(value)) result[key] = mergeRecord(fallback, value);
    } else if (key === "camera") {
      if (isCamera(value)) result[key] = value;
    } else if (key === "frame") {
      if (value === null || typeof value === "string") result[key] = value;
    } else if (typeof value === typeof fallback && value !== null) {
      result[key] = value;
    }
  }
  return structuredClone(result) as unknown as ViewState;
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function mergeRecord(base: Record<string, unknown>, given: Record<string, unknown>): Record<string, unknown> {
  const result = { ...base };
  for (const key of Object.keys(base)) {
    const value = given[key];
    const free = key === "normal" || key === "offset";
    if (value !== undefined && (free || typeof value === typeof base[key])) result[key] = value;
  }
  return result;
}

function isCamera(value: unknown): value is CameraState {
  if (!isRecord(value) || !Array.isArray(value.target) || value.target.length !== 3) return false;
  const numbers = [...value.target, value.azimuth, value.elevation, value.height];
  return (
    numbers.every((n) => typeof n === "number" && Number.isFinite(n)) &&
    (value.projection === "perspective" || value.projection === "orthographic")
  );
}

/** Visibility of a part: housings and carriers are translucent at first, because they surround the gears. */
export function visibilityOf(state: ViewState, part: { name: string; kind: string }): Visibility {
  return state.parts[part.name] ?? (part.kind === "body" ? "translucent" : "visible");
}
