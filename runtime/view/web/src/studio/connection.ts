// Connection to the server: its event stream, and the search for a new studio at the same address
// after the studio has ended.

import { type About, RequestError, get } from "./api.ts";

/**
 * - ended: nothing responds at the address.
 * - refused: a new studio responds. It accepts the page once its printed address was opened.
 * - other: a studio of another model, or of another version, responds.
 */
export type ConnectionState = "connected" | "ended" | "refused" | "other";

const RETRY = 1000;

export class Connection {
  state: ConnectionState = "connected";
  #events: EventSource | null = null;
  #retryTimer = 0;
  #isPaused = false;

  constructor(
    readonly about: About,
    /** Adds the listeners of an event stream. */
    readonly listen: (events: EventSource) => void,
    readonly onChange: () => void,
  ) {
    this.#open();
  }

  /** Closes the stream: a browser opens six connections to a server, for all of its pages. */
  pause(): void {
    this.#isPaused = true;
    window.clearTimeout(this.#retryTimer);
    this.#events?.close();
  }

  /** Opens the stream again, which reloads everything. */
  resume(): void {
    if (!this.#isPaused) return;
    this.#isPaused = false;
    void this.#search();
  }

  #open(): void {
    const events = new EventSource("/api/events");
    this.#events = events;
    this.listen(events);
    events.onopen = () => this.#become("connected");
    // The browser repeats a stream that ends, but not one that is refused.
    events.onerror = () => {
      events.close();
      void this.#search();
    };
  }

  #become(state: ConnectionState): void {
    this.state = state;
    this.onChange();
  }

  /** Opens the stream again as soon as a studio of the same subject responds. */
  async #search(): Promise<void> {
    window.clearTimeout(this.#retryTimer);
    const state = await this.#probe();
    if (this.#isPaused) return;
    if (state === "connected") {
      this.#open();
      return;
    }
    if (state !== this.state) this.#become(state);
    this.#retryTimer = window.setTimeout(() => void this.#search(), RETRY);
  }

  async #probe(): Promise<ConnectionState> {
    try {
      const { subject, calyx } = await get<About>("/api/studio");
      return subject === this.about.subject && calyx === this.about.calyx ? "connected" : "other";
    } catch (error) {
      return error instanceof RequestError && error.status === 401 ? "refused" : "ended";
    }
  }
}
