// Layout of the viewer.

import { useEffect, useRef } from "preact/hooks";
import type { Core } from "../core.ts";
import { Help } from "./Help.tsx";
import { Legend } from "./Legend.tsx";
import { PartsPanel } from "./PartsPanel.tsx";
import { PatternPanel } from "./PatternPanel.tsx";
import { PlotPanel } from "./PlotPanel.tsx";
import { SettingsPanel } from "./SettingsPanel.tsx";
import { Timeline } from "./Timeline.tsx";
import { ToolDrawer, Toolbar } from "./Toolbar.tsx";
import { Tooltip } from "./Tooltip.tsx";
import { Triad } from "./Triad.tsx";
import { useCore } from "./ui.tsx";

export interface AppProps {
  core: Core;
  stage: HTMLElement;
  showTitle: boolean;
  showTheme: boolean;
}

export function App({ core, stage, showTitle, showTheme }: AppProps) {
  useCore(core);
  const { status, state } = core;
  const ready = status === "ready";
  return (
    <>
      <Toolbar core={core} showTitle={showTitle} showTheme={showTheme} />
      <div class="cv-body">
        {ready && core.isOpen("parts") ? <PartsPanel core={core} /> : null}
        <div class="cv-centre">
          <div class="cv-view">
            <Stage stage={stage} />
            {ready ? <Triad core={core} /> : null}
            {ready ? <Legend core={core} /> : null}
            {ready ? <Tooltip core={core} /> : null}
            {core.notice ? (
              <div class="cv-notice" role="alert">
                {core.notice}
              </div>
            ) : null}
            {status === "loading" ? <div class="cv-message" role="status">Reading the shapes …</div> : null}
            {ready && core.parts?.parts.length === 0 ? <div class="cv-message">This run has no parts to display.</div> : null}
            {status === "failed" ? (
              <div class="cv-message" role="alert">
                <strong>The view cannot be displayed.</strong>
                <span>{core.failure}</span>
              </div>
            ) : null}
          </div>
          {ready && state.panels.pattern ? <PatternPanel core={core} /> : null}
          {ready && state.panels.plots ? <PlotPanel core={core} /> : null}
          {ready ? <Timeline core={core} /> : null}
        </div>
        {ready && core.isOpen("settings") ? <SettingsPanel core={core} /> : null}
        {core.narrow && core.drawer === "tools" ? <ToolDrawer core={core} showTheme={showTheme} /> : null}
      </div>
      {core.help ? <Help core={core} /> : null}
    </>
  );
}

/** Contains the element that the scene draws into. */
function Stage({ stage }: { stage: HTMLElement }) {
  const holder = useRef<HTMLDivElement>(null);
  useEffect(() => {
    holder.current!.append(stage);
  }, [stage]);
  return <div class="cv-holder" ref={holder} />;
}
