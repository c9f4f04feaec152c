// The viewer: an element of a page that displays a run.

import type { ViewSource } from "./source.ts";
import { completeState, defaultState, type PartialState, type ViewState } from "./state.ts";

export interface ViewerOptions {
  /** State to begin with, for instance one that a session stored. */
  state?: PartialState;
  /** The toolbar has a menu for the theme. False where the page has its own. */
  themeMenu?: boolean;
  /** The toolbar shows the title. */
  showTitle?: boolean;
}

export class Viewer {
  /** Called after the user or the program has changed the state, at most once per frame. */
  onChange: ((state: ViewState) => void) | null = null;

  #state: ViewState;

  constructor(container: HTMLElement, options: ViewerOptions = {}) {
    void container;
    this.#state = completeState(options.state ?? {}, defaultState());
  }

  /** Displays a source. A failure is shown in the container; the promise does not reject. */
  async show(source: ViewSource): Promise<void> {
    void source;
  }

  /** Reads the source again and keeps the state: the geometry or the results have changed. */
  async reload(): Promise<void> {}

  /** Reads the list of positions again: a run has written more of them. */
  async updatePositions(): Promise<void> {}

  /** Copy of the state. */
  get state(): ViewState {
    return structuredClone(this.#state);
  }

  /** Applies a state; missing entries keep their values. */
  restore(state: PartialState): void {
    this.#state = completeState(state, this.#state);
  }

  /** Links the cameras of two viewers in both directions. Returns a function that unlinks them. */
  linkCamera(other: Viewer): () => void {
    void other;
    return () => {};
  }

  dispose(): void {}
}
