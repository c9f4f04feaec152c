// The page: form, scene and results.

import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { Rendered } from "./diagnostics.tsx";
import { Form } from "./form.tsx";
import { FormChanged } from "./form_changes.tsx";
import { fileName, paragraphs } from "./format.ts";
import { Outputs } from "./outputs.tsx";
import { Plots } from "./plots.tsx";
import { Provenance } from "./provenance.tsx";
import { RunPanel } from "./run_panel.tsx";
import { ParamDifferences, RunsList } from "./runs_list.tsx";
import { Scene } from "./scene.tsx";
import type { Studio } from "./store.ts";
import { Text } from "./text.tsx";
import { type Theme, applyTheme, storedTheme } from "./theme.ts";

export function App({ studio }: { studio: Studio }): JSX.Element {
  const [, render] = useState(0);
  useEffect(() => studio.subscribe(() => render((count) => count + 1)), []);
  useKeys(studio);
  return (
    <>
      <Header studio={studio} />
      <NoticeBar studio={studio} />
      <main class="columns">{studio.isLoaded ? <Columns studio={studio} /> : <p class="empty" role="status">Loading …</p>}</main>
    </>
  );
}

function Columns({ studio }: { studio: Studio }): JSX.Element {
  const { model } = studio;
  return (
    <>
      <aside class="left" aria-label="Params">
        {model?.broken && <Rendered text={model.rendered} isError />}
        {(!model?.broken || model.params.length > 0) && <Form studio={studio} />}
      </aside>
      <div class="centre">
        <FormChanged studio={studio} />
        <Scene studio={studio} />
        <Plots studio={studio} />
      </div>
      <aside class="right" aria-label="Runs and results">
        <RunPanel studio={studio} />
        <Outputs studio={studio} />
        <ParamDifferences studio={studio} />
        <RunsList studio={studio} />
        <Provenance studio={studio} />
      </aside>
    </>
  );
}

/** Ctrl+Enter starts a run from anywhere. */
function useKeys(studio: Studio): void {
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey) && studio.canRun) void studio.run();
    };
    window.addEventListener("keydown", onKey);
    return () => window.removeEventListener("keydown", onKey);
  }, []);
}

function Header({ studio }: { studio: Studio }): JSX.Element {
  const path = studio.model?.model ?? "";
  const title = fileName(path) || "Calyx studio";
  useEffect(() => {
    document.title = path ? `${title} – Calyx studio` : "Calyx studio";
  }, [title]);
  return (
    <header class="top">
      <h1 title={path}>{title}</h1>
      <p class="about">{paragraphs(studio.model?.doc ?? "").split("\n")[0]}</p>
      <ThemeMenu />
    </header>
  );
}

function ThemeMenu(): JSX.Element {
  const [theme, setTheme] = useState<Theme>(storedTheme());
  return (
    <label class="inline theme">
      Theme
      <select
        value={theme}
        onChange={(event) => {
          const chosen = event.currentTarget.value as Theme;
          setTheme(chosen);
          applyTheme(chosen);
        }}
      >
        <option value="system">System</option>
        <option value="light">Light</option>
        <option value="dark">Dark</option>
      </select>
    </label>
  );
}

function NoticeBar({ studio }: { studio: Studio }): JSX.Element | null {
  if (!studio.isConnected) return <ConnectionLost studio={studio} />;
  // Before other notices: a run that was requested at the same moment is refused for the same reason.
  if (studio.model?.broken) return <ModelBroken studio={studio} />;
  if (!studio.notice) return null;
  return (
    <div class="notice" role="alert">
      <span>
        <Text text={studio.notice.message} />
        {studio.notice.help && <span class="help"> <Text text={studio.notice.help} /></span>}
      </span>
      <button type="button" class="quiet" onClick={() => studio.dismiss()}>Dismiss</button>
    </div>
  );
}

/** The diagnostics may be outside of the window. */
function ModelBroken({ studio }: { studio: Studio }): JSX.Element {
  const show = () => document.querySelector("pre.rendered.error")?.scrollIntoView({ block: "start" });
  return (
    <div class="notice error" role="status" data-testid="model-broken">
      <span>The model has errors: it cannot run, and the form keeps its values. Correct {fileName(studio.model?.model ?? "the file")} in the editor.</span>
      <button type="button" class="quiet" onClick={show}>Show the errors</button>
    </div>
  );
}

function ConnectionLost({ studio }: { studio: Studio }): JSX.Element {
  const command = <code>{studio.command}</code>;
  return (
    <div class="notice error" role="alert">
      {studio.connection === "ended" && (
        <span>
          The studio has ended; this page keeps the form. To go on, start {command} and open the address that it prints. This page
          then reconnects.
        </span>
      )}
      {studio.connection === "refused" && (
        <span>
          A new studio runs at this address. Open the address that it printed, in this browser: this page then reconnects, with its
          form.
        </span>
      )}
      {studio.connection === "other" && (
        <span>
          The studio at this address is another one: of another model, or of another version of Calyx. This page reconnects to{" "}
          {command} of its own version; <a href="/">reload</a> it for the other studio.
        </span>
      )}
    </div>
  );
}
