// The page of `calyx studio`.

import { render } from "preact";
import { App } from "./studio/app.tsx";
import "./studio/studio.css";
import { Studio } from "./studio/store.ts";
import { applyTheme, storedTheme } from "./studio/theme.ts";

const container = document.getElementById("studio");
if (container) {
  applyTheme(storedTheme());
  const studio = new Studio();
  render(<App studio={studio} />, container);
  void studio.load();
}
