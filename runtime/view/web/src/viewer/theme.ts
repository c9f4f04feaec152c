// Light and dark theme.

import type { ThemeChoice } from "./state.ts";

export class ThemeWatcher {
  theme: "light" | "dark" = "light";
  #choice: ThemeChoice = "system";
  #query = matchMedia("(prefers-color-scheme: dark)");
  #listener = () => {
    this.set(this.#choice);
    this.changed();
  };

  constructor(
    private readonly element: HTMLElement,
    private readonly changed: () => void,
  ) {
    this.#query.addEventListener("change", this.#listener);
  }

  set(choice: ThemeChoice): void {
    this.#choice = choice;
    this.theme = choice === "system" ? (this.#query.matches ? "dark" : "light") : choice;
    this.element.dataset.theme = this.theme;
  }

  dispose(): void {
    this.#query.removeEventListener("change", this.#listener);
  }
}
