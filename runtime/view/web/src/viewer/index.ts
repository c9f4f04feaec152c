// Interface of the viewer for the pages that use it.

export { Viewer } from "./viewer.tsx";
export type { ViewerOptions } from "./viewer.tsx";
export { embeddedSource, positionFileName } from "./source.ts";
export type { EmbeddedData, OutputColumn, OutputTable, PositionEntry, ViewSource } from "./source.ts";
export { completeState, defaultState } from "./state.ts";
export type * from "./state.ts";
