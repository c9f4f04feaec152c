// The scene: one viewer for each displayed run, with linked cameras.

import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { type PartialState, type PositionEntry, type ViewSource, Viewer, positionFileName } from "../viewer/index.ts";
import { type ModelScene, type Results, type RunSummary, binary, get, ofRun } from "./api.ts";
import { runName, solvedPositions } from "./format.ts";
import { bestGrid, useSize } from "./grid.ts";
import { provenanceOf } from "./provenance.tsx";
import type { Studio } from "./store.ts";
import { SharedControls } from "./shared_controls.tsx";
import { scheme, useColourScheme } from "./theme.ts";

/** Largest number of viewers side by side. Browsers have at most 16 contexts of WebGL. */
const MOST_VIEWERS = 9;
/** Smallest legible viewer, px. */
const SMALLEST = { width: 200, height: 150 };
/** Width below which a viewer starts without its panels, px. */
const NARROW = 620;
/** Width below which viewers side by side have common controls, px. */
const COMPACT = 480;
const STATE_DELAY = 500;

export function Scene({ studio }: { studio: Studio }): JSX.Element {
  const area = useRef<HTMLDivElement>(null);
  const size = useSize(area);
  const runs = studio.settings.selected.flatMap((id) => studio.runs.filter((run) => run.id === id));
  const withView = runs.filter((run) => run.has_view);
  const { modelScene } = studio;
  const showsModel = modelScene !== null && (studio.scene === "model" || withView.length === 0);
  const grid = bestGrid(Math.min(withView.length, MOST_VIEWERS), size, SMALLEST);
  // Before the first layout, only a single scene has a known place.
  const isMeasured = size.width > 0 || withView.length === 1;
  const drawn = isMeasured ? withView.slice(0, Math.min(grid.columns * grid.rows, MOST_VIEWERS)) : [];
  return (
    <div class="scene-area">
      <div class="scene-bar">
        {modelScene && withView.length > 0 && (
          <div class="chips" role="group" aria-label="Displayed scene">
            <button type="button" class="chip" aria-pressed={showsModel} onClick={() => studio.showScene("model")}>Model</button>
            <button type="button" class="chip" aria-pressed={!showsModel} onClick={() => studio.showScene("runs")}>Results</button>
          </div>
        )}
        {!showsModel && drawn.length > 1 && (
          <label class="switch">
            <input
              type="checkbox"
              checked={studio.settings.linked}
              onChange={(event) => studio.setLinked(event.currentTarget.checked)}
            />
            Link cameras
          </label>
        )}
        {!showsModel && drawn.length === 1 && drawn[0]?.incomplete && <IncompleteMark run={drawn[0]} />}
        {!showsModel && <NotDrawn runs={runs} drawn={drawn} />}
      </div>
      <div class="scene-space" ref={area}>
        {showsModel && <ModelView studio={studio} scene={modelScene} />}
        {!showsModel && drawn.length > 0 && <RunScenes studio={studio} runs={drawn} columns={grid.columns} isCompact={drawn.length > 1 && size.width / grid.columns < COMPACT} />}
        {!showsModel && withView.length === 0 && <NoScene studio={studio} runs={runs} />}
      </div>
    </div>
  );
}

function IncompleteMark({ run }: { run: RunSummary }): JSX.Element {
  return <span class="incomplete">Incomplete: {solvedPositions(run)}</span>;
}

/** Names the compared runs that are not drawn, with the reason. */
function NotDrawn({ runs, drawn }: { runs: RunSummary[]; drawn: RunSummary[] }): JSX.Element | null {
  if (drawn.length === 0) return null;
  const rest = runs.filter((run) => !drawn.includes(run));
  const listed = (reason: string, found: RunSummary[]) =>
    found.length > 0 ? [`${found.map((run) => runName(run.id)).join(", ")} (${reason})`] : [];
  const texts = [
    ...listed("no space", rest.filter((run) => run.has_view)),
    ...listed("no view files", rest.filter((run) => !run.has_view)),
  ];
  if (texts.length === 0) return null;
  return <span class="not-drawn" role="status">Not drawn: {texts.join(", ")}</span>;
}

interface RunScenesProps {
  studio: Studio;
  runs: RunSummary[];
  columns: number;
  /** The viewers have common controls in place of their own. */
  isCompact: boolean;
}

function RunScenes({ studio, runs, columns, isCompact }: RunScenesProps): JSX.Element {
  const viewers = useRef(new Map<string, Viewer>());
  const [count, setCount] = useState(0);
  const { linked } = studio.settings;
  useEffect(() => {
    if (!linked) return;
    const all = [...viewers.current.values()];
    const unlink = all.slice(1).map((viewer) => all[0]?.linkCamera(viewer));
    return () => unlink.forEach((end) => end?.());
  }, [count, linked, runs.map((run) => run.id).join()]);
  return (
    <>
      {isCompact && (
        <SharedControls
          viewers={() => [...viewers.current.values()]}
          state={(studio.settings.scene ?? {}) as PartialState}
          positions={Math.max(...runs.map((run) => run.positions ?? 0))}
        />
      )}
      <div class={`scenes ${isCompact ? "compact" : ""}`} style={{ gridTemplateColumns: `repeat(${columns}, minmax(0, 1fr))` }}>
        {runs.map((run) => (
          <RunScene
            key={run.id}
            studio={studio}
            run={run}
            hasTitle={runs.length > 1}
            onViewer={(viewer) => {
              if (viewer) viewers.current.set(run.id, viewer);
              else viewers.current.delete(run.id);
              setCount((before) => before + 1);
            }}
          />
        ))}
      </div>
    </>
  );
}

interface RunSceneProps {
  studio: Studio;
  run: RunSummary;
  hasTitle: boolean;
  onViewer: (viewer: Viewer | null) => void;
}

function RunScene({ studio, run, hasTitle, onViewer }: RunSceneProps): JSX.Element {
  const container = useRef<HTMLDivElement>(null);
  const viewer = useRef<Viewer | null>(null);
  useEffect(() => {
    if (!container.current) return;
    const created = createViewer(container.current, studio, !hasTitle);
    viewer.current = created;
    onViewer(created);
    void created.show(sourceOf(studio, run.id));
    return () => {
      viewer.current = null;
      onViewer(null);
      created.dispose();
    };
  }, [run.id, hasTitle]);
  useTheme(viewer);
  // An automatic run replaces its files; other runs only add positions.
  const isFirst = useRef(true);
  useEffect(() => {
    if (isFirst.current) isFirst.current = false;
    else if (run.id === "preview") void viewer.current?.reload();
    else void viewer.current?.updatePositions();
  }, [run.status, run.positions, run.id === "preview" ? studio.results[run.id] : null]);
  return (
    <figure class="scene">
      {hasTitle && (
        <figcaption>
          {runName(run.id)}
          {run.incomplete && <IncompleteMark run={run} />}
        </figcaption>
      )}
      <div ref={container} class="viewer" />
    </figure>
  );
}

/** Creates a viewer. A narrow one has no space for its panels, and starts without them. */
function createViewer(container: HTMLElement, studio: Studio, isAlone: boolean): Viewer {
  const state = (studio.settings.scene ?? {}) as PartialState;
  const isWide = isAlone && container.clientWidth >= NARROW;
  const panels = isWide ? state.panels : { parts: false, settings: false, plots: false };
  const created = new Viewer(container, {
    state: { ...state, theme: scheme(), ...(panels && { panels }) },
    showTheme: false,
    showTitle: false,
  });
  let timer = 0;
  created.onChange = (changed) => {
    window.clearTimeout(timer);
    timer = window.setTimeout(() => studio.setScene(isWide ? changed : { ...changed, panels: state.panels }), STATE_DELAY);
  };
  return created;
}

function useTheme(viewer: { current: Viewer | null }): void {
  const theme = useColourScheme();
  useEffect(() => viewer.current?.restore({ theme }), [theme]);
}

/** Source of the files in `view/` of a run. */
function sourceOf(studio: Studio, id: string): ViewSource {
  let listed: PositionEntry[] = [];
  const results: Results | undefined = studio.results[id];
  return {
    title: runName(id),
    provenance: results ? provenanceOf(results) : [],
    outputs: null,
    parts: () => binary(ofRun(id, "/files/view/parts.bin")),
    positions: async () => {
      const view = await get<{ positions: { position: number; time: number | null }[] }>(ofRun(id, "/view"));
      listed = view.positions.map(({ position, time }) => ({ position, time: time ?? position }));
      return listed;
    },
    position: (index) => {
      const entry = listed[index];
      if (!entry) return Promise.reject(new Error(`position ${index} does not exist`));
      return binary(ofRun(id, `/files/view/${positionFileName(entry.position)}`));
    },
    mesh: (name) => binary(ofRun(id, `/files/view/${name}`)),
  };
}

/** The scene of the model with the values of the form. */
function ModelView({ studio, scene }: { studio: Studio; scene: ModelScene }): JSX.Element {
  const container = useRef<HTMLDivElement>(null);
  const viewer = useRef<Viewer | null>(null);
  const current = useRef(scene);
  current.current = scene;
  useTheme(viewer);
  useEffect(() => {
    if (!container.current) return;
    const created = createViewer(container.current, studio, true);
    viewer.current = created;
    void created.show({
      title: "Model",
      parts: async () => current.current.parts,
      positions: async () => [{ position: 0, time: 0 }],
      position: async () => current.current.position,
    });
    return () => {
      viewer.current = null;
      created.dispose();
    };
  }, []);
  const shown = useRef(scene);
  useEffect(() => {
    if (shown.current !== scene) void viewer.current?.reload();
    shown.current = scene;
  }, [scene]);
  return <div ref={container} class="viewer" />;
}

/** The reason why there is no picture. */
function NoScene({ studio, runs }: { studio: Studio; runs: RunSummary[] }): JSX.Element {
  const status = runs[0]?.status;
  return (
    <div class="no-scene">
      <p>{reasonOf(studio, status)}</p>
      {status === "finished" && <p class="muted">Runs without positions, and runs of older versions, have none.</p>}
    </div>
  );
}

function reasonOf(studio: Studio, status: RunSummary["status"] | undefined): string {
  if (status === "running" || status === "elsewhere") return "This run has not written view files yet.";
  if (status === "finished") return "This run has no view files.";
  if (status) return "This run ended before its first position.";
  if (studio.model?.broken) return "The model has errors.";
  if (studio.check && !studio.check.runnable) return "The params in the form have errors.";
  return "Run the model to see its parts.";
}
