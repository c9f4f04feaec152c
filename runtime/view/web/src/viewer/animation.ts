// Animation over the positions.

import type { Core } from "./core.ts";

export class Animation {
  playing = false;
  #run = 0;

  constructor(private readonly core: Core) {}

  toggle(): void {
    if (this.playing) this.stop();
    else this.start();
  }

  start(): void {
    const count = this.core.positions?.list.length ?? 0;
    if (this.playing || count < 2) return;
    this.playing = true;
    void this.play(++this.#run);
    this.core.changed(false);
  }

  stop(): void {
    if (!this.playing) return;
    this.playing = false;
    this.#run++;
    this.core.changed(false);
  }

  /** Displays the next position (1) or the previous one (-1). */
  step(direction: 1 | -1): void {
    this.stop();
    const next = this.next(direction, true);
    if (next !== null) void this.core.goTo(next);
  }

  private next(direction: number, loop: boolean): number | null {
    const count = this.core.positions?.list.length ?? 0;
    if (count === 0) return null;
    const next = this.core.state.position + direction;
    if (next >= 0 && next < count) return next;
    return loop ? (next + count) % count : null;
  }

  private async play(run: number): Promise<void> {
    const { core } = this;
    const count = core.positions?.list.length ?? 0;
    if (!core.state.animation.loop && core.state.position === count - 1) await core.goTo(0);
    while (run === this.#run) {
      const due = performance.now() + 1000 / Math.max(0.1, core.state.animation.speed);
      const next = this.next(1, core.state.animation.loop);
      if (next === null) break;
      // Loads the next position during the pause before it.
      await core.positions?.load(next).catch(() => null);
      await new Promise((resolve) => setTimeout(resolve, Math.max(0, due - performance.now())));
      if (run !== this.#run) return;
      await core.goTo(next);
      // A slow renderer determines the speed; the page stays responsive.
      await new Promise(requestAnimationFrame);
    }
    if (run === this.#run) this.stop();
  }
}
