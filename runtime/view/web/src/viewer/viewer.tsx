// The viewer: an element of a page that displays a run.

import { render } from "preact";
import { contactLoads } from "./contacts.ts";
import { Core } from "./core.ts";
import { controlPointer, handleKey } from "./controls.ts";
import { exportImage, exportPattern, type ImageFormat } from "./export.ts";
import { App } from "./panels/App.tsx";
import type { ViewSource } from "./source.ts";
import type { PartialState, ViewState } from "./state.ts";
import "./viewer.css";
import "./scene.css";

export interface ViewerOptions {
  /** State to begin with, for instance one that a session stored. */
  state?: PartialState;
  /** The toolbar shows the title. */
  showTitle?: boolean;
  /** The toolbar has a button for the theme. False where the page has its own. */
  showTheme?: boolean;
  /** Shortcuts also work while no element has the focus. For pages that the viewer has for itself. */
  pageKeys?: boolean;
}

export class Viewer {
  /** Called after the user or the program has changed the state, at most once per frame. */
  onChange: ((state: ViewState) => void) | null = null;

  readonly #core: Core;
  readonly #element: HTMLElement;
  readonly #disposed = new AbortController();
  readonly #links = new Set<Viewer>();

  constructor(container: HTMLElement, options: ViewerOptions = {}) {
    const element = document.createElement("div");
    element.className = "calyx-viewer";
    const stage = document.createElement("div");
    stage.className = "cv-stage";
    container.append(element);
    this.#element = element;
    // Preact renders around the stage; the scene is drawn outside of its control.
    const core = new Core(element, stage, options.state ?? {});
    this.#core = core;
    core.onChange = (state) => this.onChange?.(state);
    render(
      <App core={core} stage={stage} showTitle={options.showTitle ?? true} showTheme={options.showTheme ?? true} />,
      element,
    );
    if (core.scene) {
      const { canvas, camera } = core.scene;
      canvas.tabIndex = 0;
      canvas.setAttribute("role", "img");
      canvas.setAttribute("aria-label", "Three-dimensional view. Arrow keys orbit, plus and minus zoom, question mark shows all shortcuts.");
      controlPointer(core, canvas);
      const changed = camera.onChange;
      camera.onChange = (user) => {
        changed?.(user);
        // A linked camera follows without reporting back.
        if (user) for (const other of this.#links) other.#core.scene?.camera.set(camera.state);
      };
    }
    const onKey = (event: KeyboardEvent) => {
      if (handleKey(core, event)) event.preventDefault();
    };
    element.addEventListener("keydown", onKey);
    if (options.pageKeys) {
      document.addEventListener("keydown", (event) => event.target === document.body && onKey(event), {
        signal: this.#disposed.signal,
      });
    }
  }

  /** Shows a message instead of the scene. */
  fail(message: string): void {
    this.#core.fail(new Error(message));
  }

  /** Displays a source. A failure is shown in the container; the promise does not reject. */
  show(source: ViewSource): Promise<void> {
    return this.#core.show(source);
  }

  /** Reads the source again and keeps the state: the geometry or the results have changed. */
  reload(): Promise<void> {
    return this.#core.reload();
  }

  /** Reads the list of positions again: a run has written more of them. */
  updatePositions(): Promise<void> {
    return this.#core.updatePositions();
  }

  /** Copy of the state. */
  get state(): ViewState {
    return structuredClone(this.#core.state);
  }

  /** Applies a state; missing entries keep their values. */
  restore(state: PartialState): void {
    this.#core.update(state);
  }

  /** Links the cameras of two viewers in both directions. Returns a function that unlinks them. */
  linkCamera(other: Viewer): () => void {
    this.#links.add(other);
    other.#links.add(this);
    const { camera } = this.#core.state;
    if (camera) other.#core.scene?.camera.set(camera);
    return () => {
      this.#links.delete(other);
      other.#links.delete(this);
    };
  }

  /** Picture of the scene with labels and legend. */
  image(format: ImageFormat): Promise<Blob> {
    return exportImage(this.#core, format);
  }

  /** Contact pattern with the choices of the state. */
  patternImage(format: ImageFormat): Promise<Blob> {
    return exportPattern(this.#core, format);
  }

  /** Number of frames drawn so far. */
  get frames(): number {
    return this.#core.scene?.frames ?? 0;
  }

  /** Number of triangles in the last frame. */
  get triangles(): number {
    return this.#core.display?.triangles ?? 0;
  }

  /** Draws a frame at once; for measurements. */
  draw(): void {
    this.#core.scene?.draw();
  }

  /** Pixel of the page at which a point appears, given in coordinates of a part. */
  project(part: string, point: [number, number, number]): { x: number; y: number } | null {
    return this.#core.project(part, point);
  }

  /** Value of the selected field at a node of a part's mesh, SI; NaN if it is unknown. */
  nodalValue(part: string, node: number): number {
    return this.#core.nodalValue(part, node);
  }

  /** Sums of pressure times area over the contact cells of each pair of gears in the displayed position, N. */
  contactLoads(): { parts: [string, string]; load: number }[] {
    const contacts = this.#core.display?.position?.contacts;
    const names = this.#core.parts?.parts.map(({ name }) => name) ?? [];
    if (!contacts) return [];
    return [...contactLoads(contacts)].map(([key, load]) => {
      const [first, second] = key.split(" ").map(Number) as [number, number];
      return { parts: [names[first] ?? "", names[second] ?? ""], load };
    });
  }

  dispose(): void {
    for (const other of this.#links) other.#links.delete(this);
    this.#links.clear();
    this.#disposed.abort();
    render(null, this.#element);
    this.#core.dispose();
    this.#element.remove();
  }
}
