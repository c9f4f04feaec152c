import type { Viewer } from "./viewer/index.ts";

declare global {
  interface Window {
    /** The viewer of the page, for scripts. */
    calyxViewer?: Viewer;
  }
}
