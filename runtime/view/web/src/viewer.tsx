// Entry point of the self-contained page that `calyx view --html` writes.

import { embeddedSource, Viewer, type EmbeddedData } from "./viewer/index.ts";

function start(): void {
  const container = document.getElementById("calyx-viewer") ?? document.body;
  const viewer = new Viewer(container, { pageKeys: true });
  window.calyxViewer = viewer;
  const element = document.getElementById("calyx-view");
  let data: EmbeddedData;
  try {
    data = JSON.parse(element?.textContent ?? "") as EmbeddedData;
  } catch {
    viewer.fail("The data embedded in this page are missing or damaged.");
    return;
  }
  if (data.title) document.title = data.title;
  void viewer.show(embeddedSource(data));
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
