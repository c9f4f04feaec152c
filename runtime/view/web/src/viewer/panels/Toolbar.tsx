// Toolbar: camera, colours, deformation, what is displayed, export.

import { useState } from "preact/hooks";
import type { Core } from "../core.ts";
import { setCut } from "../controls.ts";
import { download, type ImageFormat } from "../export.ts";
import { FIELDS, isNodal, UNDEFORMED } from "../fields.ts";
import type { Field, StandardView } from "../state.ts";
import { formatNumber } from "../units.ts";
import { CELL_CHOICES } from "./SettingsPanel.tsx";
import { SpeedControls } from "./Timeline.tsx";
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

interface ToolbarProps {
  core: Core;
  showTitle: boolean;
  showTheme: boolean;
}

export function Toolbar({ core, showTitle, showTheme }: ToolbarProps) {
  const { scene, status, narrow } = core;
  const ready = status === "ready" && scene !== null;
  return (
    <div class="cv-toolbar" role="toolbar" aria-label="View">
      <Tool icon="parts" label="Parts" shortcut="B" pressed={core.isOpen("parts")} onClick={() => core.toggle("parts")} />
      {showTitle && !narrow ? <h1 class="cv-title" title={core.source?.title}>{core.source?.title ?? "Calyx"}</h1> : null}
      {ready && !narrow ? (
        <>
          <span class="cv-rule" />
          <CameraTools core={core} />
          <span class="cv-rule" />
          <FieldSelect core={core} />
          <FieldTools core={core} />
          <span class="cv-rule" />
          <DisplayTools core={core} />
        </>
      ) : null}
      {ready && narrow ? <span class="cv-grow"><FieldSelect core={core} /></span> : <span class="cv-space" />}
      <span class="cv-tool-group">
        {ready && !narrow ? <PanelTools core={core} /> : null}
        {ready ? (
          <Tool icon="settings" label="Settings" shortcut="S" pressed={core.isOpen("settings")} onClick={() => core.toggle("settings")} />
        ) : null}
        {narrow ? (
          <Tool icon="more" label="More tools" pressed={core.drawer === "tools"} onClick={() => core.setDrawer(core.drawer === "tools" ? null : "tools")} />
        ) : (
          <PageTools core={core} showTheme={showTheme} />
        )}
      </span>
    </div>
  );
}

/** Tools for which the toolbar of a narrow viewer has no room. */
export function ToolDrawer({ core, showTheme }: { core: Core; showTheme: boolean }) {
  const ready = core.status === "ready" && core.scene !== null;
  return (
    <div class="cv-tools" role="group" aria-label="More tools">
      {ready ? (
        <>
          <CameraTools core={core} />
          <DisplayTools core={core} />
          <FieldTools core={core} />
          <PanelTools core={core} />
          <SpeedControls core={core} />
        </>
      ) : null}
      <PageTools core={core} showTheme={showTheme} />
    </div>
  );
}

function CameraTools({ core }: { core: Core }) {
  const { camera } = core.scene!;
  const orthographic = core.state.camera?.projection === "orthographic";
  return (
    <>
      <Tool icon="fit" label="Fit" shortcut="F" onClick={() => camera.fit()} />
      <Select
        quiet
        label="Standard view"
        value={"" as StandardView | ""}
        options={VIEWS}
        onChange={(view) => {
          if (view) camera.view(view);
          // The list is a menu: it shows its name again.
          core.changed(false);
        }}
      />
      <Tool
        icon={orthographic ? "orthographic" : "perspective"}
        label="Orthographic projection"
        shortcut="P"
        pressed={orthographic}
        onClick={() => camera.setProjection(orthographic ? "perspective" : "orthographic")}
      />
    </>
  );
}

function FieldSelect({ core }: { core: Core }) {
  const { colours } = core.state;
  return (
    <Select
      quiet
      label="Colours"
      value={colours.field}
      options={FIELD_NAMES.map((field) => ({ value: field, label: FIELDS[field].label }))}
      onChange={(field) => core.update({ colours: { field, limits: colours.limits === "fixed" ? "position" : colours.limits } })}
    />
  );
}

/** Choices that depend on the field. */
function FieldTools({ core }: { core: Core }) {
  const { colours } = core.state;
  return (
    <>
      {colours.field === "contact_pressure" ? (
        <Select quiet label="Contact cells" value={colours.cells} options={CELL_CHOICES} onChange={(cells) => core.update({ colours: { cells } })} />
      ) : null}
      {core.hasMeshes ? <Deformation core={core} /> : null}
    </>
  );
}

function DisplayTools({ core }: { core: Core }) {
  const { state } = core;
  const forces = state.forces.bearings || state.forces.meshes;
  return (
    <>
      <Tool icon="mesh" label="Mesh edges" shortcut="M" pressed={state.mesh_edges} onClick={() => core.update({ mesh_edges: !state.mesh_edges })} />
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
          if (on && !core.drawers) core.toggle("settings", true);
        }}
      />
    </>
  );
}

function PanelTools({ core }: { core: Core }) {
  const { panels } = core.state;
  return (
    <>
      <Tool icon="plot" label="Plots" shortcut="G" pressed={panels.plots} onClick={() => core.update({ panels: { plots: !panels.plots } })} />
      <Tool
        icon="pattern"
        label="Contact pattern"
        shortcut="U"
        pressed={panels.pattern}
        onClick={() => core.update({ panels: { pattern: !panels.pattern } })}
      />
      <ExportMenu core={core} />
    </>
  );
}

function PageTools({ core, showTheme }: { core: Core; showTheme: boolean }) {
  const dark = core.theme.theme === "dark";
  return (
    <>
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
    </>
  );
}

function Deformation({ core }: { core: Core }) {
  const { mode, factor } = core.state.deformation;
  const isUndeformed = mode === "automatic" && !isNodal(core.state.colours.field);
  const value = mode === "automatic" ? "automatic" : factor === 0 || factor === 1 ? String(factor) : "other";
  return (
    <>
      <Select
        quiet
        label="Deformation"
        title={isUndeformed ? UNDEFORMED : undefined}
        value={value}
        options={[
          { value: "automatic", label: isUndeformed ? "No deformation here" : "Deformation: automatic" },
          { value: "0", label: "Undeformed" },
          { value: "1", label: "True deformation" },
          { value: "other", label: "Other factor …" },
        ]}
        onChange={(choice) => {
          if (choice === "automatic") core.update({ deformation: { mode: "automatic" } });
          else if (choice === "other") {
            core.update({ deformation: { mode: "factor", factor: core.display!.factor || 10 } });
            core.toggle("settings", true);
          }
          else core.update({ deformation: { mode: "factor", factor: Number(choice) } });
        }}
      />
      {isUndeformed ? null : (
        <output class="cv-factor" aria-label="Factor of the deformation" title="Factor of the displayed deformation">
          × {formatNumber(core.display!.factor, 3)}
        </output>
      )}
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
