// Pointer and keyboard control of the scene.

import * as THREE from "three";
import type { Core } from "./core.ts";
import type { CutState, StandardView } from "./state.ts";

/** Degrees per pixel of a drag. */
const ORBIT = 0.35;
/** Pixels around the handle of the cut that react. */
const HANDLE = 18;

type Drag = "orbit" | "pan" | "cut";

/** Installs the pointer control of the canvas. */
export function controlPointer(core: Core, canvas: HTMLCanvasElement): void {
  const scene = core.scene!;
  const pointers = new Map<number, { x: number; y: number }>();
  let drag: Drag | null = null;
  let probeRequest = 0;
  let probeX = 0;
  let probeY = 0;
  const projected = new THREE.Vector3();

  const location = (event: PointerEvent | WheelEvent) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const onHandle = (x: number, y: number): boolean => {
    if (!core.state.cut.on) return false;
    const p = projected.copy(core.display!.cut.handle).project(scene.camera.active);
    return Math.hypot((0.5 + 0.5 * p.x) * scene.width - x, (0.5 - 0.5 * p.y) * scene.height - y) < HANDLE;
  };

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    if (core.drawer) core.setDrawer(null);
    const { x, y } = location(event);
    pointers.set(event.pointerId, { x, y });
    if (pointers.size > 1) drag = "pan";
    else if (event.button === 0 && onHandle(x, y)) drag = "cut";
    else drag = event.button === 0 && !event.shiftKey ? "orbit" : "pan";
    core.clearProbe();
    core.display?.setDragging(drag === "cut", core.state);
    canvas.dataset.drag = drag;
  });

  canvas.addEventListener("pointermove", (event) => {
    const { x, y } = location(event);
    const last = pointers.get(event.pointerId);
    if (!last || !drag) {
      const handle = onHandle(x, y);
      canvas.dataset.handle = String(handle);
      core.display?.cut.setHighlight(handle);
      probeX = x;
      probeY = y;
      probeRequest ||= requestAnimationFrame(() => {
        probeRequest = 0;
        core.probePointer(probeX, probeY);
      });
      return;
    }
    const dx = x - last.x;
    const dy = y - last.y;
    if (pointers.size === 2) {
      const other = [...pointers].find(([id]) => id !== event.pointerId)![1];
      const before = Math.hypot(last.x - other.x, last.y - other.y);
      const after = Math.hypot(x - other.x, y - other.y);
      scene.camera.pan(dx / 2 / scene.height, -dy / 2 / scene.height);
      if (before > 0 && after > 0) scene.camera.zoom(before / after, ...fractions((x + other.x) / 2, (y + other.y) / 2));
    } else if (drag === "orbit") {
      scene.camera.orbit(-dx * ORBIT, dy * ORBIT);
    } else if (drag === "pan") {
      scene.camera.pan(dx / scene.height, -dy / scene.height);
    } else {
      const { cut } = core.display!;
      moveCut(core, cut.drag(dx, dy, scene.camera.active, scene.width, scene.height));
    }
    last.x = x;
    last.y = y;
  });

  const release = (event: PointerEvent) => {
    pointers.delete(event.pointerId);
    if (pointers.size === 0) {
      drag = null;
      core.display?.setDragging(false, core.state);
      delete canvas.dataset.drag;
    }
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", () => {
    cancelAnimationFrame(probeRequest);
    probeRequest = 0;
    core.clearProbe();
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("dblclick", () => scene.camera.fit());

  const fractions = (x: number, y: number): [number, number] => [
    (x - scene.width / 2) / scene.height,
    (scene.height / 2 - y) / scene.height,
  ];
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const { x, y } = location(event);
      // Wheels report lines, trackpads pixels.
      const amount = event.deltaY * (event.deltaMode === 1 ? 16 : 1);
      scene.camera.zoom(Math.exp(Math.min(Math.max(amount, -240), 240) * 0.0016), ...fractions(x, y));
    },
    { passive: false },
  );
}

/** Moves the cutting plane along its normal, m. */
export function moveCut(core: Core, distance: number): void {
  const { cut } = core.display!;
  const offset = Math.min(Math.max(cut.offset + distance, cut.range[0]), cut.range[1]);
  core.update({ cut: { offset } });
}

/** Switches the cut, or changes its normal. The side towards the eye is removed, so that the section is visible. */
export function setCut(core: Core, change: { on?: boolean; normal?: CutState["normal"] }): void {
  const normal = change.normal ?? core.state.cut.normal;
  const eye = core.scene!.camera.direction;
  const along = typeof normal === "string" ? eye[normal] : eye.x * normal[0] + eye.y * normal[1] + eye.z * normal[2];
  core.update({ cut: { ...change, ...(change.normal ? { offset: null } : {}), ...(change.on === false ? {} : { flipped: along < 0 }) } });
}

export interface Shortcut {
  keys: string;
  label: string;
}

/** Shortcuts, as the help lists them. */
export const SHORTCUTS: [string, Shortcut[]][] = [
  [
    "View",
    [
      { keys: "F", label: "Fit the parts into the picture" },
      { keys: "1 … 6", label: "Front, back, left, right, top, bottom" },
      { keys: "7", label: "Isometric" },
      { keys: "P", label: "Perspective or orthographic" },
      { keys: "Arrow keys", label: "Orbit (picture focused)" },
      { keys: "Shift + arrow keys", label: "Pan (picture focused)" },
      { keys: "+ −", label: "Zoom" },
    ],
  ],
  [
    "Display",
    [
      { keys: "M", label: "Edges of the finite elements" },
      { keys: "V", label: "Force vectors" },
      { keys: "C", label: "Cutting plane" },
      { keys: "[ ]", label: "Move the cutting plane" },
      { keys: "D", label: "Undeformed, true or automatic deformation" },
    ],
  ],
  [
    "Animation",
    [
      { keys: "K", label: "Play or pause" },
      { keys: ", .", label: "Previous or next position" },
    ],
  ],
  [
    "Panels",
    [
      { keys: "B", label: "Parts" },
      { keys: "S", label: "Settings" },
      { keys: "G", label: "Plots" },
      { keys: "U", label: "Contact pattern on the unrolled flank" },
      { keys: "?", label: "This help" },
      { keys: "Esc", label: "Close" },
    ],
  ],
  [
    "Pointer",
    [
      { keys: "Drag", label: "Orbit" },
      { keys: "Right or Shift + drag", label: "Pan" },
      { keys: "Wheel", label: "Zoom at the pointer" },
      { keys: "Double click", label: "Fit" },
    ],
  ],
];

const VIEW_KEYS: Record<string, StandardView> = {
  "1": "front",
  "2": "back",
  "3": "left",
  "4": "right",
  "5": "top",
  "6": "bottom",
  "7": "isometric",
};

/** Handles a key. Returns false if it is not a shortcut. */
export function handleKey(core: Core, event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const target = event.target as HTMLElement;
  // Letters in text fields and lists belong to those.
  if (target.closest("input:not([type=checkbox]):not([type=range]), select, textarea")) return false;
  const { scene, state, animation } = core;
  if (event.key === "?") {
    core.help = !core.help;
    core.changed(false);
    return true;
  }
  if (event.key === "Escape" && core.help) {
    core.help = false;
    core.changed(false);
    return true;
  }
  if (event.key === "Escape" && core.drawer) {
    core.setDrawer(null);
    return true;
  }
  if (!scene || core.status !== "ready") return false;
  const { camera } = scene;
  if (target === scene.canvas && event.key.startsWith("Arrow")) {
    const right = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    const up = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (event.shiftKey) camera.pan(0.05 * right, 0.05 * up);
    else camera.orbit(-6 * right, -6 * up);
    return true;
  }
  const view = VIEW_KEYS[event.key];
  if (view) {
    camera.view(view);
    return true;
  }
  const { panels, forces } = state;
  switch (event.key.toLowerCase()) {
    case "f": camera.fit(); break;
    case "p": camera.setProjection(state.camera?.projection === "orthographic" ? "perspective" : "orthographic"); break;
    case "+": case "=": camera.zoom(0.85); break;
    case "-": case "_": camera.zoom(1 / 0.85); break;
    case "m": core.update({ mesh_edges: !state.mesh_edges }); break;
    case "v": {
      const on = !(forces.bearings || forces.meshes);
      core.update({ forces: { bearings: on, meshes: on } });
      break;
    }
    case "c": setCut(core, { on: !state.cut.on }); break;
    case "[": case "]":
      if (state.cut.on) moveCut(core, (event.key === "[" ? -0.04 : 0.04) * core.display!.radius);
      break;
    case "d": core.update({ deformation: nextDeformation(core) }); break;
    case "k": animation.toggle(); break;
    case ",": animation.step(-1); break;
    case ".": animation.step(1); break;
    case "b": core.toggle("parts"); break;
    case "s": core.toggle("settings"); break;
    case "g": core.update({ panels: { plots: !panels.plots } }); break;
    case "u": core.update({ panels: { pattern: !panels.pattern } }); break;
    default: return false;
  }
  return true;
}

function nextDeformation(core: Core): { mode: "automatic" | "factor"; factor: number } {
  const { mode, factor } = core.state.deformation;
  if (mode === "automatic") return { mode: "factor", factor: 0 };
  return factor === 0 ? { mode: "factor", factor: 1 } : { mode: "automatic", factor: 1 };
}
