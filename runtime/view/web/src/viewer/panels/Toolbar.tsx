// Toolbar: camera, colours, deformation, what is displayed, export.

import { useState } from "preact/hooks";
import type { Core } from "../core.ts";
import { setCut } from "../controls.ts";
import { download, type ImageFormat } from "../export.ts";
import { FIELDS } from "../fields.ts";
import type { Field, StandardView } from "../state.ts";
import { formatNumber } from "../units.ts";
import { Select, Tool } from "./ui.tsx";

const VIEWS: { value: StandardView | ""; label: string }[] = [
  { value: "", label: "View" },
  { value: "isometric", label: "Isometric" },
  { value: "front", label: "Front" },
  { value: "back", label: "Back" },
  { value: "left", label: "Left" },
  { value: "right", label: "Right" },
  { value: "top", label: "Top" },
  { value: "bottom", label: "Bottom" },
];

const FIELD_NAMES = Object.keys(FIELDS) as Field[];

export function Toolbar({ core, showTitle, showTheme }: { core: Core; showTitle: boolean; showTheme: boolean }) {
  const { state, scene, status } = core;
  const ready = status === "ready" && scene !== null;
  const orthographic = state.camera?.projection === "orthographic";
  const forces = state.forces.bearings || state.forces.meshes;
  const dark = core.theme.theme === "dark";
  return (
    <div class="cv-toolbar" role="toolbar" aria-label="View">
      <Tool
        icon="parts"
        label="Parts"
        shortcut="B"
        pressed={state.panels.parts}
        onClick={() => core.update({ panels: { parts: !state.panels.parts } })}
      />
      {showTitle ? <h1 class="cv-title" title={core.source?.title}>{core.source?.title ?? "Calyx"}</h1> : null}
      {ready ? (
        <>
          <span class="cv-rule" />
          <Tool icon="fit" label="Fit" shortcut="F" onClick={() => scene.camera.fit()} />
          <Select
            quiet
            label="Standard view"
            value={"" as StandardView | ""}
            options={VIEWS}
            onChange={(view) => {
              if (view) scene.camera.view(view);
              // The list is a menu: it shows its name again.
              core.changed(false);
            }}
          />
          <Tool
            icon={orthographic ? "orthographic" : "perspective"}
            label="Orthographic projection"
            shortcut="P"
            pressed={orthographic}
            onClick={() => scene.camera.setProjection(orthographic ? "perspective" : "orthographic")}
          />
          <span class="cv-rule" />
          <Select
            quiet
            label="Colours"
            value={state.colours.field}
            options={FIELD_NAMES.map((field) => ({ value: field, label: FIELDS[field].label }))}
            onChange={(field) => core.update({ colours: { field, limits: state.colours.limits === "fixed" ? "position" : state.colours.limits } })}
          />
          {core.hasMeshes ? <Deformation core={core} /> : null}
          <span class="cv-rule" />
          <Tool
            icon="mesh"
            label="Mesh edges"
            shortcut="M"
            pressed={state.mesh_edges}
            onClick={() => core.update({ mesh_edges: !state.mesh_edges })}
          />
          <Tool
            icon="force"
            label="Force vectors"
            shortcut="V"
            pressed={forces}
            onClick={() => core.update({ forces: { bearings: !forces, meshes: !forces } })}
          />
          <Tool
            icon="cut"
            label="Cutting plane"
            shortcut="C"
            pressed={state.cut.on}
            onClick={() => {
              const on = !state.cut.on;
              setCut(core, { on });
              if (on) core.update({ panels: { settings: true } });
            }}
          />
        </>
      ) : null}
      <span class="cv-space" />
      {ready ? (
        <>
          <Tool
            icon="plot"
            label="Plots"
            shortcut="G"
            pressed={state.panels.plots}
            onClick={() => core.update({ panels: { plots: !state.panels.plots } })}
          />
          <ExportMenu core={core} />
          <Tool
            icon="settings"
            label="Settings"
            shortcut="S"
            pressed={state.panels.settings}
            onClick={() => core.update({ panels: { settings: !state.panels.settings } })}
          />
        </>
      ) : null}
      {showTheme ? (
        <Tool
          icon={dark ? "sun" : "moon"}
          label={dark ? "Light theme" : "Dark theme"}
          onClick={() => core.update({ theme: dark ? "light" : "dark" })}
        />
      ) : null}
      <Tool
        icon="help"
        label="Help"
        shortcut="?"
        pressed={core.help}
        onClick={() => {
          core.help = !core.help;
          core.changed(false);
        }}
      />
    </div>
  );
}

function Deformation({ core }: { core: Core }) {
  const { mode, factor } = core.state.deformation;
  const value = mode === "automatic" ? "automatic" : factor === 0 || factor === 1 ? String(factor) : "other";
  return (
    <>
      <Select
        quiet
        label="Deformation"
        value={value}
        options={[
          { value: "automatic", label: "Deformation: automatic" },
          { value: "0", label: "Undeformed" },
          { value: "1", label: "True deformation" },
          { value: "other", label: "Other factor …" },
        ]}
        onChange={(choice) => {
          if (choice === "automatic") core.update({ deformation: { mode: "automatic" } });
          else if (choice === "other") core.update({ deformation: { mode: "factor", factor: core.display!.factor || 10 }, panels: { settings: true } });
          else core.update({ deformation: { mode: "factor", factor: Number(choice) } });
        }}
      />
      <output class="cv-factor" aria-label="Factor of the deformation" title="Factor of the displayed deformation">
        × {formatNumber(core.display!.factor, 3)}
      </output>
    </>
  );
}

function ExportMenu({ core }: { core: Core }) {
  const [error, setError] = useState("");
  return (
    <span class="cv-export">
      <Select
        quiet
        label={error ? `Export. ${error}` : "Export the picture"}
        value={"" as ImageFormat | ""}
        options={[
          { value: "", label: "Export" },
          { value: "png", label: "PNG" },
          { value: "svg", label: "SVG" },
          { value: "pdf", label: "PDF" },
        ]}
        onChange={(format) => {
          if (format) download(core, format).catch((reason: unknown) => setError(String(reason)));
          core.changed(false);
        }}
      />
    </span>
  );
}
