// Requests to the server of the studio, and the JSON of their responses.

export interface Param {
  name: string;
  /** Heading of the group; empty for the first params without a heading. */
  group: string;
  doc: string;
  kind: "number" | "integer" | "boolean" | "choice" | "text" | "array";
  unit: string;
  /** Default as it is typed, in `unit`; null if it is not known. */
  default: string | null;
  low: number | null;
  high: number | null;
  /** Accepted values as text. */
  domain: string;
  /** False if default and range follow other params. */
  independent: boolean;
  choices: string[];
}

/** An analysis setting of the form, which overrides that of the model. */
export interface Setting {
  name: string;
  label: string;
  doc: string;
  kind: "choice" | "number" | "boolean";
  choices: { name: string; doc: string }[];
  /** Accepted numbers as text. */
  domain: string;
  /** True for settings of mesh and contact grid, which few users change. */
  detail: boolean;
}

/** The studio that serves the page. */
export interface About {
  calyx: string;
  /** Path of the model as after `calyx studio`; null if only the directory of a run is known. */
  model: string | null;
  /** Absolute path of the model, or of the run without a model. */
  subject: string | null;
  opened: string | null;
  settings: Setting[];
}

export interface Output {
  name: string;
  doc: string;
  unit: string;
  /** SI value of the unit. */
  factor: number;
  choices: string[];
}

export interface Place {
  file: string;
  line: number;
  column: number;
}

export interface Message {
  severity: "error" | "warning" | "note";
  code: string | null;
  message: string;
  help: string | null;
  primary?: Place | null;
}

export interface Model {
  version: string;
  model: string;
  doc: string;
  units: string;
  calyx: string;
  /** True if the language rejects the model, so that it has no form. */
  broken: boolean;
  params: Param[];
  outputs: Output[];
  diagnostics: Message[];
  /** Diagnostics with excerpts of the source. */
  rendered: string;
}

export interface Reason {
  message: string;
  help: string;
}

export interface Plan {
  fidelity: string;
  three_dimensional: boolean;
  positions: number;
  /** Predicted time, s. */
  time: number;
  /** Predicted memory, bytes. */
  memory: number;
  /** Predicted disk space of the view, with the requested meshes, bytes. */
  disk: number;
  text: string;
  cost: string;
  ignored_inputs: Record<string, string>;
  refused_outputs: Record<string, string>;
}

export interface Check {
  version: string;
  runnable: boolean;
  /** Hash of the text of the model. */
  source: string | null;
  /** Valid values of the form, converted to the units of the params. */
  values: Record<string, string>;
  errors: Record<string, Reason>;
  /** Errors by analysis setting. */
  setting_errors: Record<string, Reason>;
  refused: Reason | null;
  diagnostics: Message[];
  rendered: string;
  plan: Plan | null;
  gear_data: string;
}

export interface Progress {
  stage: string;
  done: number;
  total: number | null;
  seconds_left: number | null;
}

export type Status = "running" | "elsewhere" | "finished" | "failed" | "cancelled" | "interrupted";

export interface RunParam {
  text: string;
  /** Text that was entered in the form, perhaps with another unit. */
  entered?: string;
  unit?: string;
  at_default?: boolean;
}

export interface RunSummary {
  id: string;
  directory: string;
  status: Status;
  message: string | null;
  /** Time of the start, s since 1970. */
  started: number | null;
  params: Record<string, RunParam> | null;
  /** Analysis settings that override those of the model. */
  settings: Record<string, string> | null;
  progress: Progress | null;
  /** Number of solved positions. */
  positions: number | null;
  /** Planned number of positions. */
  total: number | null;
  /** True until all positions are solved. */
  incomplete: boolean;
  /** True if the run can be continued. */
  resumable: boolean;
  fidelity: string | null;
  calyx: string | null;
  source: string | null;
  warnings: number | null;
  has_view: boolean;
  has_report: boolean;
}

export interface OutputSummary {
  doc: string;
  display: {
    unit: string;
    factor: number;
    min: number | null;
    max: number | null;
    mean: number | null;
    peak_to_peak: number | null;
    positions?: Record<string, number>;
  };
  error_estimate?: {
    min?: number | null;
    max?: number | null;
    mean?: number | null;
    peak_to_peak?: number | null;
    relative?: number | null;
    includes_level?: boolean;
    is_rounding?: boolean;
  } | null;
}

export interface RunFile {
  calyx: string;
  model: string;
  fidelity?: string;
  positions?: number;
  source: { sha256: string };
  outputs?: Record<string, OutputSummary>;
  /** Outputs of a run that has not finished. */
  columns?: Record<string, { display: { unit: string; factor: number } }>;
  warnings?: string[];
  ignored_inputs?: Record<string, string>;
  refused_outputs?: Record<string, string>;
  certificate?: Record<string, number>;
  overrides?: Record<string, unknown>;
  incomplete?: { code: string | null; message: string | null };
}

export type Column = (number | string | null)[];

/** Values of an output at the solved positions of an incomplete run, in `unit`. */
export interface OutputSoFar {
  doc: string;
  unit: string;
  min: number | null;
  max: number | null;
  last: number | null;
}

export interface Results extends RunSummary {
  messages: Message[] | null;
  printed: string | null;
  run: RunFile | null;
  /** Outputs of an incomplete run. */
  so_far?: Record<string, OutputSoFar>;
  /** Columns of `steps.csv`, SI. */
  steps: Record<string, Column> | null;
  /** Number of positions from one row of `steps` to the next. */
  stride: number;
}

export interface Session {
  version: 1;
  params: Record<string, string>;
  /** Absent in sessions of older versions. */
  settings?: Record<string, string>;
  view: Record<string, unknown> | null;
}

/** Form of a session as it is stored. */
export interface StoredForm {
  params: Record<string, string>;
  settings: Record<string, string>;
}

/** Error of a request, with a remedy. */
export class RequestError extends Error {
  constructor(
    message: string,
    readonly status: number,
    readonly help: string,
    readonly body: unknown,
  ) {
    super(message);
  }
}

async function request(path: string, options: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, options);
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw error;
    throw new RequestError("the studio does not respond", 0, "start `calyx studio` again", null);
  }
  if (response.ok) return response;
  const body = await response.json().catch(() => null);
  const { message, help } = (body ?? {}) as { message?: string; help?: string };
  throw new RequestError(message ?? response.statusText, response.status, help ?? "", body);
}

export async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await request(path, { signal })).json();
}

export async function binary(path: string): Promise<ArrayBuffer> {
  return (await request(path)).arrayBuffer();
}

/** The scene of the model at time 0, before anything is solved: files of the viewer. */
export interface ModelScene {
  parts: ArrayBuffer;
  position: ArrayBuffer;
}

/** What a form assigns: values of params and analysis settings, as typed. */
export interface FormValues {
  params: Record<string, string>;
  settings: Record<string, string>;
}

/** Returns the scene of the model with the values of a form. */
export async function modelScene(form: FormValues, signal?: AbortSignal): Promise<ModelScene> {
  const scene = await send<{ parts: string; position: string }>("POST", "/api/scene", form, signal);
  const decoded = (text: string): ArrayBuffer => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  return { parts: decoded(scene.parts), position: decoded(scene.position) };
}

/** Largest body of a request that outlives its page, bytes; browsers refuse more than 64 kB. */
const LONGEST_KEPT = 60_000;

/**
 * Sends a session. `before` is the stored form that the page knows: another one is not overwritten. The request
 * outlives the page if the session is short enough.
 */
export async function sendSession(session: Session & { before?: StoredForm }): Promise<void> {
  const text = JSON.stringify(session);
  await request("/api/session", {
    method: "PUT",
    keepalive: new Blob([text]).size < LONGEST_KEPT,
    headers: { "Content-Type": "application/json" },
    body: text,
  });
}

export async function send<T>(method: "POST" | "PUT", path: string, body: unknown, signal?: AbortSignal): Promise<T> {
  const response = await request(path, {
    method,
    signal,
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body ?? {}),
  });
  const text = await response.text();
  return (text ? JSON.parse(text) : null) as T;
}

/** Path of a request about a run. */
export function ofRun(id: string, rest = ""): string {
  return `/api/runs/${encodeURIComponent(id)}${rest}`;
}
