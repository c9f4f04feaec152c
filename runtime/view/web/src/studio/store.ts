// State of the page and its actions.

import {
  type About,
  type Check,
  type FormValues,
  type Model,
  type ModelScene,
  type Param,
  type Progress,
  RequestError,
  type Results,
  type RunSummary,
  type Session,
  type Setting,
  type StoredForm,
  get,
  modelScene,
  ofRun,
  send,
  sendSession,
} from "./api.ts";
import { Connection, type ConnectionState } from "./connection.ts";
import { isSame, runName } from "./format.ts";

/** Values that differ from the defaults, as typed. */
export type Values = Record<string, string>;

export interface Notice {
  message: string;
  help: string;
}

/** Settings of the page that a session stores. */
export interface ViewSettings {
  /** Runs the model after each change if the predicted time is short. */
  automatic: boolean;
  linked: boolean;
  /** The analysis settings of the form are open. */
  analysisOpen: boolean;
  selected: string[];
  /** State of the viewer. */
  scene: unknown;
}

/** Longest predicted time of an automatic run, s. */
export const AUTOMATIC_LIMIT = 1;
const CHECK_DELAY = 180;
const RESULTS_DELAY = 700;
const SESSION_DELAY = 300;

export class Studio {
  model: Model | null = null;
  /** True if the model of the opened run is not known. */
  withoutModel = false;
  values: Values = {};
  /** Analysis settings that override those of the model, as typed. */
  analysis: Values = {};
  /** Analysis settings that the form offers. */
  analysisSettings: Setting[] = [];
  check: Check | null = null;
  isChecking = false;
  runs: RunSummary[] = [];
  progress: Record<string, Progress> = {};
  results: Record<string, Results> = {};
  settings: ViewSettings = { automatic: true, linked: true, analysisOpen: true, selected: [], scene: null };
  /** Geometry of the model with the values of the form, if the server provides it. */
  modelScene: ModelScene | null = null;
  /** Displayed scene. */
  scene: "model" | "runs" = "runs";
  notice: Notice | null = null;
  isStarting = false;

  #listeners = new Set<() => void>();
  #checkTimer = 0;
  #sessionTimer = 0;
  #isUnsaved = false;
  /** Another page has stored a form that this one does not take. */
  #isForeign = false;
  /** The stored form that this page knows. */
  #stored: StoredForm = { params: {}, settings: {} };
  #isSaving = false;
  /** Another form was stored while this page was saving. */
  #isBehind = false;
  /** True until the values of the session are compared with the model. */
  #isRestored = false;
  #about: About | null = null;
  #connection: Connection | null = null;
  #resultsTimers = new Map<string, number>();
  #checkAbort: AbortController | null = null;
  #isLoaded = false;
  #previewed = "";
  #keepsOpened = false;
  /** Runs that were started after the last list. */
  #started = new Set<string>();

  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #changed(): void {
    for (const listener of this.#listeners) listener();
  }

  /** Loads everything and follows the events of the server. */
  async load(): Promise<void> {
    await this.#try(async () => {
      const about = await get<About>("/api/studio");
      this.#about = about;
      this.withoutModel = about.model === null;
      this.analysisSettings = about.settings;
      if (!this.withoutModel) await this.#restoreSession();
      if (about.opened) this.settings.selected = [about.opened];
      this.#keepsOpened = about.opened !== null;
    });
    this.#isLoaded = true;
    this.#changed();
    // A page that is closed or hidden may not run again.
    window.addEventListener("pagehide", () => this.#saveNow(true));
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") {
        this.#saveNow(true);
        this.#connection?.pause();
      } else {
        this.#connection?.resume();
      }
    });
    this.#follow();
  }

  async #restoreSession(): Promise<void> {
    const session = await get<Session>("/api/session");
    this.#takeForm(session);
    this.#isRestored = true;
    const view = (session.view ?? {}) as Partial<ViewSettings>;
    if (typeof view.automatic === "boolean") this.settings.automatic = view.automatic;
    if (typeof view.linked === "boolean") this.settings.linked = view.linked;
    if (typeof view.analysisOpen === "boolean") this.settings.analysisOpen = view.analysisOpen;
    if (Array.isArray(view.selected)) {
      this.settings.selected = view.selected.filter((id) => typeof id === "string" && id !== "preview");
    }
    this.settings.scene = view.scene ?? null;
  }

  #takeForm({ params, settings = {} }: Session): void {
    this.#stored = { params, settings };
    this.values = { ...params };
    const known = new Set(this.analysisSettings.map((setting) => setting.name));
    this.analysis = Object.fromEntries(Object.entries(settings).filter(([name]) => known.has(name)));
  }

  /** Takes the form that another page has stored, unless this page has changed its own. */
  async #followForm(): Promise<void> {
    if (this.#isForeign || !this.#isLoaded) return;
    await this.#try(async () => {
      const session = await get<Session>("/api/session");
      const { params, settings = {} } = session;
      if (this.#isSaving) {
        // The stored form that this page knows is not certain until the response.
        this.#isBehind = true;
        return;
      }
      const isKnown = isSameForm({ params, settings }, this.#stored);
      if (isKnown || !isSameForm(this.#storedForm(), this.#stored)) return;
      this.#takeForm(session);
      this.#checkSoon(0);
    });
  }

  #follow(): void {
    if (!this.#about) return;
    let wasConnected = true;
    this.#connection = new Connection(this.#about, (events) => this.#listen(events), () => {
      if (this.isConnected && !wasConnected) {
        // Errors of requests that the ended studio did not answer.
        this.notice = null;
        // A new studio has no automatic run.
        this.#previewed = "";
      }
      wasConnected = this.isConnected;
      this.#saveNow();
      this.#changed();
    });
  }

  /** True when the form has the values of the session: an earlier change would be lost. */
  get isLoaded(): boolean {
    return this.#isLoaded;
  }

  get connection(): ConnectionState {
    return this.#connection?.state ?? "connected";
  }

  get isConnected(): boolean {
    return this.connection === "connected";
  }

  /** The stream begins with both kinds of event, so that it also loads the page. */
  #listen(events: EventSource): void {
    events.addEventListener("model", () => void this.#loadModel());
    events.addEventListener("runs", () => void this.#loadRuns());
    events.addEventListener("session", () => void this.#followForm());
    events.addEventListener("progress", (event) => {
      const { id, ...progress } = JSON.parse((event as MessageEvent<string>).data) as Progress & { id: string };
      this.progress[id] = progress;
      if (this.settings.selected.includes(id)) this.#loadResultsSoon(id);
      this.#changed();
    });
  }

  async #loadModel(): Promise<void> {
    if (this.withoutModel) return;
    await this.#try(async () => {
      const model = await get<Model>("/api/model");
      if (model.broken) {
        // The form and the units remain those of the last model without errors.
        const { params, outputs, doc } = this.model ?? model;
        this.model = { ...model, params, outputs, doc };
        this.#checkAbort?.abort();
        this.check = null;
        this.isChecking = false;
        return;
      }
      this.model = model;
      // A session of another version may have empty values.
      if (this.#isRestored) this.values = this.#storedValues();
      this.#isRestored = false;
      const known = new Set(model.params.map((param) => param.name));
      const dropped = Object.keys(this.values).filter((name) => !known.has(name));
      for (const name of dropped) delete this.values[name];
      if (dropped.length > 0) {
        const message = `the model has no param ${dropped.map((name) => `\`${name}\``).join(", ")} any more`;
        this.notice = { message, help: "its value in the form was dropped" };
      }
      this.#checkSoon(0);
    });
  }

  async #loadRuns(): Promise<void> {
    await this.#try(async () => {
      const { runs } = await get<{ runs: RunSummary[] }>("/api/runs");
      const before = new Map(this.runs.map((run) => [run.id, JSON.stringify(run)]));
      this.runs = runs;
      const known = new Set(runs.map((run) => run.id));
      for (const id of [...this.#started]) {
        if (known.has(id)) this.#started.delete(id);
        else known.add(id);
      }
      const gone = this.settings.selected.filter((id) => !known.has(id) && before.has(id) && id !== "preview");
      if (gone.length > 0) {
        this.notice = { message: `${gone.map(runName).join(", ")}: the directory was deleted`, help: "" };
      }
      this.settings.selected = this.settings.selected.filter((id) => known.has(id));
      for (const id of Object.keys(this.results)) if (!known.has(id)) delete this.results[id];
      for (const run of runs) {
        if (run.progress) this.progress[run.id] = run.progress;
        const isStale = before.get(run.id) !== JSON.stringify(run) || run.id === "preview";
        if (this.settings.selected.includes(run.id) && (isStale || !this.results[run.id])) void this.#loadResults(run.id);
      }
      if (this.settings.selected.length === 0) {
        const last = runs.findLast((run) => run.status === "finished");
        if (last) this.select([last.id]);
      }
    });
  }

  #loadResultsSoon(id: string): void {
    if (this.#resultsTimers.has(id)) return;
    const timer = window.setTimeout(() => {
      this.#resultsTimers.delete(id);
      void this.#loadResults(id);
    }, RESULTS_DELAY);
    this.#resultsTimers.set(id, timer);
  }

  async #loadResults(id: string): Promise<void> {
    try {
      this.results[id] = await get<Results>(ofRun(id));
    } catch (error) {
      // The directory was deleted: the next list of runs no longer has it.
      if (!(error instanceof RequestError && error.status === 404)) this.#fail(error);
      delete this.results[id];
    }
    this.#changed();
  }

  param(name: string): Param | undefined {
    return this.model?.params.find((param) => param.name === name);
  }

  /** Value of a param as typed. */
  value(param: Param): string {
    return this.values[param.name] ?? param.default ?? "";
  }

  setValue(name: string, text: string): void {
    const param = this.param(name);
    if (param?.independent && param.default === text) delete this.values[name];
    else this.values[name] = text;
    this.#checkSoon(CHECK_DELAY);
    this.#changed();
  }

  reset(name: string): void {
    delete this.values[name];
    this.#checkSoon(0);
    this.#changed();
  }

  /** Values and settings of the form. */
  get form(): FormValues {
    return { params: { ...this.values }, settings: { ...this.analysis } };
  }

  /** True if a param is not at its default; another spelling of the same number is. */
  isChanged(name: string): boolean {
    const typed = this.values[name];
    const param = this.param(name);
    if (typed === undefined) return false;
    return !param?.independent || param.default === null || !isSame(param.default, typed);
  }

  /** Number of params and settings that are not at their defaults. */
  get changes(): number {
    return Object.keys(this.values).filter((name) => this.isChanged(name)).length + Object.keys(this.analysis).length;
  }

  /** Assigns an analysis setting; an empty text leaves it to the model. */
  setAnalysis(name: string, text: string): void {
    if (text === "") delete this.analysis[name];
    else this.analysis[name] = text;
    this.#checkSoon(CHECK_DELAY);
    this.#changed();
  }

  resetAll(): void {
    this.analysis = {};
    this.setValues({});
  }

  /** Replaces all values of params. */
  setValues(values: Values): void {
    this.values = {};
    for (const [name, text] of Object.entries(values)) {
      const param = this.param(name);
      if (!param?.independent || param.default === null || !isSame(param.default, text)) this.values[name] = text;
    }
    this.#checkSoon(0);
    this.#changed();
  }

  #checkSoon(delay: number): void {
    if (this.modelScene) this.scene = "model";
    window.clearTimeout(this.#checkTimer);
    this.isChecking = true;
    this.#checkTimer = window.setTimeout(() => void this.#check(), delay);
    this.#saveSession();
  }

  async #check(): Promise<void> {
    if (!this.model || this.model.broken) {
      this.isChecking = false;
      return;
    }
    this.#checkAbort?.abort();
    const abort = new AbortController();
    this.#checkAbort = abort;
    const { form } = this;
    await this.#try(async () => {
      const check = await send<Check>("POST", "/api/check", form, abort.signal);
      if (abort.signal.aborted) return;
      this.check = check;
      this.isChecking = false;
      if (check.version !== this.model?.version) await this.#loadModel();
      await Promise.all([this.#preview(form), this.#loadScene(form, abort.signal)]);
    });
    if (this.#checkAbort === abort) this.isChecking = false;
    this.#changed();
  }

  /** True if a run can start. */
  get canRun(): boolean {
    return this.isConnected && !this.isStarting && Boolean(this.check?.runnable);
  }

  /** Command that starts this studio. */
  get command(): string {
    const subject = this.#about?.model || (this.runs.find((run) => run.id === "opened")?.directory ?? "");
    const quoted = /^[\w./@%+,:=-]*$/.test(subject) ? subject : `'${subject.replaceAll("'", "'\\''")}'`;
    return `calyx studio ${quoted}`.trim() + (location.port && ` --port ${location.port}`);
  }

  /** True if the check predicts a time in which the model may run after each change. */
  get isQuick(): boolean {
    return this.check?.plan != null && this.check.plan.time < AUTOMATIC_LIMIT;
  }

  /** Loads the scene of the model with values that were checked. */
  async #loadScene(form: FormValues, signal: AbortSignal): Promise<void> {
    const { errors, setting_errors } = this.check ?? {};
    if (Object.keys({ ...errors, ...setting_errors }).length > 0) return;
    try {
      this.modelScene = await modelScene(form, signal);
    } catch (error) {
      if (!(error instanceof RequestError)) throw error;
      this.modelScene = null;
    }
  }

  showScene(scene: "model" | "runs"): void {
    this.scene = scene;
    this.#changed();
  }

  /** Starts the automatic run with values that were checked. */
  async #preview(form: FormValues): Promise<void> {
    const key = JSON.stringify([this.check?.version, form]);
    if (!this.settings.automatic || !this.check?.runnable || !this.isQuick || this.#previewed === key) return;
    this.#previewed = key;
    if (this.#keepsOpened) {
      // The run that the studio was opened with stays until a param changes.
      this.#keepsOpened = false;
      return;
    }
    await send("POST", "/api/preview", form);
    this.#started.add("preview");
    const selected = this.settings.selected;
    if (selected.length <= 1) this.select(["preview"]);
  }

  setAutomatic(automatic: boolean): void {
    this.settings.automatic = automatic;
    this.#saveSession();
    this.#changed();
    if (automatic) this.#checkSoon(0);
  }

  setAnalysisOpen(open: boolean): void {
    if (open === this.settings.analysisOpen) return;
    this.settings.analysisOpen = open;
    this.#saveSession();
  }

  setLinked(linked: boolean): void {
    this.settings.linked = linked;
    this.#saveSession();
    this.#changed();
  }

  setScene(scene: unknown): void {
    this.settings.scene = scene;
    this.#saveSession();
  }

  async run(): Promise<void> {
    this.isStarting = true;
    this.#changed();
    await this.#try(async () => {
      const { id } = await send<{ id: string }>("POST", "/api/runs", this.form);
      this.#started.add(id);
      this.select([id]);
    });
    this.isStarting = false;
    this.#changed();
  }

  async cancel(id: string): Promise<void> {
    await this.#try(() => send("POST", ofRun(id, "/cancel"), {}));
  }

  /** Resumes a run that ended early. */
  async continue(id: string): Promise<void> {
    await this.#try(async () => {
      await send("POST", ofRun(id, "/continue"), {});
      delete this.progress[id];
    });
  }

  /** Shows runs; the first one is the reference of comparisons. */
  select(ids: string[]): void {
    this.settings.selected = ids;
    this.scene = "runs";
    for (const id of ids) if (!this.results[id]) void this.#loadResults(id);
    this.#saveSession();
    this.#changed();
  }

  /** Adds a run to the comparison, or removes it. */
  toggle(id: string): void {
    const { selected } = this.settings;
    this.select(selected.includes(id) ? selected.filter((other) => other !== id) : [...selected, id]);
  }

  /** Takes the values and settings of a run into the form. */
  useForm(run: RunSummary): void {
    const values: Values = {};
    for (const [name, param] of Object.entries(run.params ?? {})) {
      if (this.param(name) && param.at_default !== true) values[name] = param.entered ?? param.text;
    }
    this.analysis = { ...run.settings };
    this.setValues(values);
  }

  dismiss(): void {
    this.notice = null;
    this.#changed();
  }

  fail(error: unknown): void {
    this.#fail(error);
    this.#changed();
  }

  #fail(error: unknown): void {
    if (error instanceof DOMException && error.name === "AbortError") return;
    const help = error instanceof RequestError ? error.help : "";
    this.notice = { message: error instanceof Error ? error.message : String(error), help };
  }

  async #try(action: () => Promise<unknown>): Promise<void> {
    try {
      await action();
    } catch (error) {
      this.#fail(error);
    }
    this.#changed();
  }

  #saveSession(): void {
    if (!this.#isLoaded || this.withoutModel || this.#isForeign) return;
    this.#isUnsaved = true;
    window.clearTimeout(this.#sessionTimer);
    this.#sessionTimer = window.setTimeout(() => this.#saveNow(), SESSION_DELAY);
  }

  /**
   * Saves the session if it has changed. A save that failed is repeated with the next change or connection.
   * Saves follow each other, except for the last one of a page that is closed.
   */
  #saveNow(closing = false): void {
    window.clearTimeout(this.#sessionTimer);
    // Another studio may respond at the address.
    if (!this.#isUnsaved || !this.isConnected || (this.#isSaving && !closing)) return;
    this.#isUnsaved = false;
    this.#isSaving = true;
    const before = this.#stored;
    const form = this.#storedForm();
    this.#stored = form;
    void this.#try(async () => {
      try {
        await sendSession({ version: 1, ...form, view: { ...this.settings }, before });
      } catch (error) {
        this.#stored = before;
        const isConflict = error instanceof RequestError && error.status === 409;
        if (isConflict && isSameForm(form, before)) {
          // Only the view of this page has changed: it takes the form of the other page.
          this.#isUnsaved = true;
          this.#isBehind = true;
          return;
        }
        // The form of another page is not overwritten; that of this page remains in it.
        if (isConflict) this.#isForeign = true;
        else this.#isUnsaved = true;
        throw error;
      } finally {
        this.#isSaving = false;
        if (this.#isBehind) {
          this.#isBehind = false;
          await this.#followForm();
        }
      }
      this.#saveNow();
    });
  }

  #storedForm(): StoredForm {
    return { params: this.#storedValues(), settings: { ...this.analysis } };
  }

  /** Values that a session keeps: an empty field has none, unless its param is a text. */
  #storedValues(): Values {
    const isStored = ([name, text]: [string, string]) => text.trim() !== "" || this.param(name)?.kind === "text";
    return Object.fromEntries(Object.entries(this.values).filter(isStored));
  }
}

function isSameForm(one: StoredForm, other: StoredForm): boolean {
  const entries = ({ params, settings }: StoredForm) => JSON.stringify([params, settings].map((values) => Object.entries(values).sort(([a], [b]) => (a < b ? -1 : 1))));
  return entries(one) === entries(other);
}
