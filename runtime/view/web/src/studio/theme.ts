// Light and dark theme: that of the system, or the choice of the user.

import { useEffect, useState } from "preact/hooks";

export type Theme = "system" | "light" | "dark";
const KEY = "calyx-theme";
const DARK = "(prefers-color-scheme: dark)";

export function storedTheme(): Theme {
  const stored = localStorage.getItem(KEY);
  return stored === "light" || stored === "dark" ? stored : "system";
}

/** Applies a theme and stores it in the browser. */
export function applyTheme(theme: Theme): void {
  if (theme === "system") localStorage.removeItem(KEY);
  else localStorage.setItem(KEY, theme);
  if (theme === "system") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
  window.dispatchEvent(new Event("calyx-theme"));
}

/** The scheme in effect. */
export function scheme(): "light" | "dark" {
  const chosen = document.documentElement.dataset.theme;
  if (chosen === "light" || chosen === "dark") return chosen;
  return matchMedia(DARK).matches ? "dark" : "light";
}

/** Returns the scheme in effect, and renders again when it changes. */
export function useColourScheme(): "light" | "dark" {
  const [current, set] = useState(scheme());
  useEffect(() => {
    const update = () => set(scheme());
    const query = matchMedia(DARK);
    query.addEventListener("change", update);
    window.addEventListener("calyx-theme", update);
    return () => {
      query.removeEventListener("change", update);
      window.removeEventListener("calyx-theme", update);
    };
  }, []);
  return current;
}
