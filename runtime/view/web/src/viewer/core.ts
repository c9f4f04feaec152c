// State of a viewer and the operations that the panels and the keyboard use.

import { Vector3 } from "three";
import { Animation } from "./animation.ts";
import { FileError } from "./array_file.ts";
import { Display, type Limits } from "./display.ts";
import { isNodal } from "./fields.ts";
import { Labels } from "./labels.ts";
import { edgesDominate } from "./contacts.ts";
import { isHidden } from "./marks.ts";
import { PatternModel } from "./pattern_model.ts";
import { probeAt, type Probe } from "./probe.ts";
import { Positions } from "./positions.ts";
import { hasStresses, readParts, type Parts, type Position } from "./run_data.ts";
import { NoWebGlError, Scene } from "./scene.ts";
import type { ViewSource } from "./source.ts";
import { completeState, defaultState, type PartialState, type ViewState, type Visibility } from "./state.ts";
import { ThemeWatcher } from "./theme.ts";
import { useUnitsOf } from "./units.ts";

/** What is above the scene of a viewer without room for panels. */
export type Drawer = "parts" | "settings" | "tools";

/** Width below which a viewer is narrow, CSS pixels. */
const NARROW = 640;
/** Width below which panels are drawers above the scene: beside it, they would leave less than half of the width. */
const DRAWERS = 900;

/** Time between a frame and the update of the marks, ms. */
const MARKS_DELAY = 100;

export type Status = "empty" | "loading" | "ready" | "failed";

export class Core {
  state: ViewState;
  status: Status = "empty";
  /** Reason of a failure that leaves nothing to display. */
  failure = "";
  /** Problem with a single file; the rest is displayed. */
  notice = "";
  source: ViewSource | null = null;
  parts: Parts | null = null;
  positions: Positions | null = null;
  probe: Probe | null = null;
  help = false;
  /** There is no room for all tools in the toolbar. */
  narrow = false;
  /** There is no room for panels beside the scene: they are drawers above it. */
  drawers = false;
  drawer: Drawer | null = null;
  /** Share of the positions that the search for limits has read, or null. */
  progress: number | null = null;
  readonly scene: Scene | null = null;
  readonly display: Display | null = null;
  readonly labels = new Labels();
  readonly animation = new Animation(this);
  readonly pattern = new PatternModel(this);
  readonly theme: ThemeWatcher;
  onChange: ((state: ViewState) => void) | null = null;

  #listeners = new Set<() => void>();
  #notified = 0;
  #generation = 0;
  #fieldChosen: boolean;
  #cellsChosen: boolean;
  #allLimits = new Map<string, Limits>();
  #scan = "";
  #marks = 0;
  #size = new ResizeObserver(() => this.resize());

  constructor(
    readonly element: HTMLElement,
    stage: HTMLElement,
    initial: PartialState,
  ) {
    this.state = completeState(initial, defaultState());
    this.#fieldChosen = initial.colours?.field !== undefined;
    this.#cellsChosen = initial.colours?.cells !== undefined;
    this.theme = new ThemeWatcher(element, () => this.changed());
    this.theme.set(this.state.theme);
    this.#size.observe(element);
    try {
      this.scene = new Scene(stage);
      this.display = new Display(this.scene);
    } catch (error) {
      this.fail(error instanceof NoWebGlError ? error : new NoWebGlError());
      return;
    }
    const { scene, display } = this;
    stage.append(this.labels.element);
    scene.onPrepare = () => display.prepareFrame();
    scene.onFrame = () => {
      this.labels.update(scene.camera.active, scene.root.matrix, scene.width, scene.height);
      // The search for what hides a mark would make each frame slower.
      this.#marks ||= window.setTimeout(() => this.updateMarks(), MARKS_DELAY);
    };
    scene.camera.onChange = (user) => {
      this.state.camera = scene.camera.state;
      this.probe = null;
      scene.invalidate();
      this.changed(user);
    };
  }

  private resize(): void {
    const width = this.element.clientWidth;
    // An element that is not displayed has no width.
    const narrow = width > 0 && width < NARROW;
    const drawers = width > 0 && width < DRAWERS;
    if (narrow === this.narrow && drawers === this.drawers) return;
    this.narrow = narrow;
    this.drawers = drawers;
    this.drawer = null;
    this.element.toggleAttribute("data-narrow", narrow);
    this.element.toggleAttribute("data-drawers", drawers);
    this.changed(false);
  }

  /** Returns whether a panel is displayed. */
  isOpen(panel: "parts" | "settings"): boolean {
    return this.drawers ? this.drawer === panel : this.state.panels[panel];
  }

  /** Opens or closes a panel. */
  toggle(panel: "parts" | "settings", open = !this.isOpen(panel)): void {
    if (this.drawers) this.setDrawer(open ? panel : null);
    else this.update({ panels: { [panel]: open } });
  }

  setDrawer(drawer: Drawer | null): void {
    this.drawer = drawer;
    this.changed(false);
  }

  /** Registers a function that is called after changes, at most once per frame. */
  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Reports a change to the panels and, for changes of the state, to the owner of the viewer. */
  changed(ofState = true): void {
    if (ofState) this.#report = true;
    if (this.#notified) return;
    this.#notified = requestAnimationFrame(() => {
      this.#notified = 0;
      for (const listener of this.#listeners) listener();
      if (this.#report) this.onChange?.(structuredClone(this.state));
      this.#report = false;
    });
  }
  #report = false;

  /** Shows a message instead of the scene. */
  fail(error: unknown): void {
    this.status = "failed";
    this.failure = error instanceof Error ? error.message : String(error);
    this.changed(false);
  }

  async show(source: ViewSource): Promise<void> {
    if (!this.scene) return;
    this.source = source;
    // A displayed scene stays until the new one is complete: geometry may change while the user types.
    if (this.status !== "ready") this.status = "loading";
    this.notice = "";
    this.changed(false);
    await this.load(true);
  }

  async reload(): Promise<void> {
    if (this.source && this.scene) await this.load(false);
  }

  private async load(initial: boolean): Promise<void> {
    const { source, display, scene } = this;
    if (!source || !display || !scene) return;
    const generation = ++this.#generation;
    const stale = () => generation !== this.#generation;
    if (initial) this.animation.stop();
    try {
      const parts = readParts(await source.parts());
      const positions = new Positions(source, parts.parts);
      let notice = "";
      try {
        await positions.update();
      } catch (error) {
        notice = `The list of positions cannot be read: ${reason(error)}`;
      }
      const first = positions.list.length > 0 ? await positions.load(0).catch((error) => ((notice = reason(error)), null)) : null;
      if (stale()) {
        positions.dispose();
        return;
      }
      if (first?.problem) notice = withoutMesh(first);
      this.positions?.dispose();
      this.parts = parts;
      useUnitsOf(parts.units);
      this.positions = positions;
      this.#allLimits.clear();
      this.notice = notice;
      display.setParts(parts.parts, first);
      display.setPosition(first);
      // Before the first results there is nothing to choose from.
      if (!this.#fieldChosen && first && (hasStresses(first) || first.contacts)) {
        this.#fieldChosen = true;
        this.state.colours.field = hasStresses(first) ? "von_mises" : "contact_pressure";
      }
      if (!this.#cellsChosen && first?.contacts) {
        this.#cellsChosen = true;
        if (edgesDominate(first.contacts)) this.state.colours.cells = "flanks";
      }
      this.state.position = Math.min(Math.max(0, Math.trunc(this.state.position)), Math.max(0, positions.list.length - 1));
      this.status = "ready";
      this.apply();
      display.updateBounds();
      if (this.state.camera) scene.camera.set(this.state.camera);
      else if (parts.parts.length > 0) scene.camera.fit(false);
      if (this.state.position > 0) await this.goTo(this.state.position);
      this.changed();
    } catch (error) {
      if (!stale()) this.fail(error);
    }
  }

  async updatePositions(): Promise<void> {
    const { positions } = this;
    if (!positions) return;
    const empty = positions.list.length === 0;
    try {
      await positions.update();
    } catch (error) {
      this.notice = `The list of positions cannot be read: ${reason(error)}`;
    }
    this.#allLimits.clear();
    // Poses are known only now.
    if (empty && positions.list.length > 0) await this.load(true);
    else this.update({});
  }

  /** Changes parts of the state and displays them. */
  update(patch: PartialState): void {
    const before = this.state;
    this.state = completeState(patch, before);
    if (patch.colours?.field) this.#fieldChosen = true;
    if (patch.colours?.cells) this.#cellsChosen = true;
    this.probe = null;
    this.theme.set(this.state.theme);
    if (patch.camera && this.scene) this.scene.camera.set(this.state.camera!);
    this.apply();
    if (patch.parts) this.display?.updateBounds();
    if (patch.position !== undefined) void this.goTo(this.state.position);
    this.changed();
  }

  private apply(): void {
    const { display, scene } = this;
    if (!display || !scene || this.status !== "ready") return;
    const labels = display.apply(this.state, this.#allLimits.get(this.limitsKey()) ?? null);
    this.labels.set(labels);
    scene.invalidate();
    if (this.state.colours.limits === "all") void this.findAllLimits();
  }

  setVisibility(names: string[], visibility: Visibility): void {
    const parts = { ...this.state.parts };
    for (const name of names) parts[name] = visibility;
    this.update({ parts });
  }

  /** Displays a position of the list. Resolves when it is displayed. */
  async goTo(index: number): Promise<void> {
    const { positions, display } = this;
    if (!positions || !display || positions.list.length === 0) return;
    const wanted = Math.min(Math.max(0, index), positions.list.length - 1);
    this.state.position = wanted;
    this.changed();
    try {
      const position = await positions.load(wanted);
      if (positions !== this.positions || this.state.position !== wanted) return;
      this.notice = withoutMesh(position);
      if (display.position !== position) display.setPosition(position);
      this.probe = null;
      this.apply();
    } catch (error) {
      if (positions !== this.positions || this.state.position !== wanted) return;
      this.animation.stop();
      this.notice = `${reason(error)}. The picture shows another position.`;
    }
    this.changed();
  }

  private limitsKey(): string {
    const hidden = Object.entries(this.state.parts).filter(([, v]) => v === "hidden");
    return JSON.stringify([this.state.colours.field, this.state.colours.cells, hidden.map(([name]) => name).sort()]);
  }

  /** Searches all positions for the limits of the selected field. */
  private async findAllLimits(): Promise<void> {
    const { positions, display, state } = this;
    const key = this.limitsKey();
    if (!positions || !display || state.colours.field === "plain" || this.#allLimits.has(key) || this.#scan === key) return;
    this.#scan = key;
    const current = () => this.#scan === key && positions === this.positions && this.state.colours.limits === "all";
    let limits: Limits | null = null;
    for (let i = 0; i < positions.list.length && current(); i++) {
      this.progress = i / positions.list.length;
      this.changed(false);
      // A damaged file is reported when it is displayed.
      const position = await positions.load(i).catch(() => null);
      const found: Limits | null = position && current() ? display.limitsOf(position, this.state) : null;
      if (found) limits = limits ? [Math.min(limits[0], found[0]), Math.max(limits[1], found[1])] : found;
    }
    if (this.#scan !== key) return;
    const finished = current();
    this.#scan = "";
    this.progress = null;
    if (finished) {
      if (limits) this.#allLimits.set(key, limits);
      else this.#allLimits.set(key, [0, 1]);
      this.apply();
    }
    this.changed(false);
  }

  /** Updates the value at the pointer; coordinates in pixels of the canvas. */
  probePointer(x: number, y: number): void {
    this.probe = this.status === "ready" ? probeAt(this, x, y) : null;
    if (this.state.panels.pattern) this.followPointer();
    this.changed(false);
  }

  /** The contact pattern follows the pointer in the scene. */
  private followPointer(): void {
    const { probe, pattern } = this;
    const cell = probe?.cell ?? -1;
    const contacts = this.display?.position?.contacts;
    for (let end = 0; contacts && cell >= 0 && end < 2; end++) {
      pattern.pointed.set(contacts.parts[2 * cell + end]!, contacts.teeth[2 * cell + end]!);
    }
    const part = this.parts?.parts.find(({ name }) => name === probe?.part);
    if (probe && cell < 0 && part && probe.tooth !== null) pattern.pointed.set(part.index, probe.tooth);
    this.hover(cell);
  }

  /** Marks a contact cell in the scene and in the contact pattern; -1 for none. */
  hover(cell: number): void {
    const { display, scene, pattern } = this;
    pattern.hovered = cell;
    if (display?.contacts.mark(display.position?.contacts ?? null, cell)) scene?.invalidate();
    this.changed(false);
  }

  /** Finds out which marks are hidden. */
  updateMarks(): void {
    clearTimeout(this.#marks);
    this.#marks = 0;
    const { scene, display } = this;
    if (!scene || !display || this.status !== "ready") return;
    this.labels.hide((point) => isHidden(scene, display, point));
    this.labels.arrange(scene.width, scene.height, this.element.querySelector(".cv-legend")?.getBoundingClientRect() ?? null);
  }

  clearProbe(): void {
    if (this.pattern.hovered >= 0) this.hover(-1);
    if (!this.probe) return;
    this.probe = null;
    this.changed(false);
  }

  get hasMeshes(): boolean {
    return (this.display?.position?.meshes.length ?? 0) > 0;
  }

  /** The selected field needs data that the position does not have. */
  get missingField(): boolean {
    const { field } = this.state.colours;
    const position = this.display?.position;
    if (field === "plain" || this.status !== "ready") return false;
    if (field === "displacement") return !this.hasMeshes;
    return isNodal(field) ? !position || !hasStresses(position) : !position?.contacts;
  }

  /** Pixel of the page at which a point of a part appears. */
  project(part: string, point: [number, number, number]): { x: number; y: number } | null {
    const { scene, display } = this;
    const view = display?.views.find((candidate) => candidate.part.name === part);
    if (!scene || !view) return null;
    const p = new Vector3(...point).applyMatrix4(view.group.matrixWorld).project(scene.camera.active);
    const box = scene.canvas.getBoundingClientRect();
    return { x: box.left + (0.5 + 0.5 * p.x) * scene.width, y: box.top + (0.5 - 0.5 * p.y) * scene.height };
  }

  /** Value of the selected field at a node of a part's first mesh. */
  nodalValue(part: string, node: number): number {
    const { display, parts } = this;
    const index = parts?.parts.findIndex((candidate) => candidate.name === part) ?? -1;
    const mesh = display?.meshes[index]?.[0];
    const { field } = this.state.colours;
    return mesh && display && isNodal(field) ? (display.values(mesh, field)[node] ?? NaN) : NaN;
  }

  dispose(): void {
    this.#generation++;
    cancelAnimationFrame(this.#notified);
    clearTimeout(this.#marks);
    this.#size.disconnect();
    this.animation.stop();
    this.positions?.dispose();
    this.display?.dispose();
    this.scene?.dispose();
    this.theme.dispose();
    this.#listeners.clear();
  }
}

/** Notice about a mesh of a position that cannot be displayed; empty if there is none. */
function withoutMesh({ problem }: Position): string {
  return problem && `${problem}. The mesh is not displayed.`;
}

function reason(error: unknown): string {
  if (error instanceof FileError) return error.message;
  return error instanceof Error ? error.message : String(error);
}
