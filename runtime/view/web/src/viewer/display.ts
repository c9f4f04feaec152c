// Objects of a run in the scene: parts, deformed meshes, contacts, forces and the cut.

import * as THREE from "three";
import { fillScaleTexture, partColour } from "./colours.ts";
import { ContactView, isChosen } from "./contacts.ts";
import { CutView } from "./cut.ts";
import { FIELDS, isNodal, markedExtreme, nodalValues, rangeOf, shareWithin, surfaceNodes, type NodalField } from "./fields.ts";
import { ForceView } from "./forces.ts";
import type { Label } from "./labels.ts";
import { MeshViews, type MeshView } from "./mesh_view.ts";
import { PartView } from "./part_view.ts";
import { displacedPoint, type DeformedMesh, type Part, type Position } from "./run_data.ts";
import type { Scene } from "./scene.ts";
import { type ViewState, visibilityOf } from "./state.ts";
import type { Plane } from "./section.ts";
import { displayUnit, formatNumber, roundDown125, stressUnit } from "./units.ts";

/** Share of the scene's size that the largest displacement takes with an automatic factor. */
const AUTOMATIC_DEFORMATION = 0.05;

/** Movement of lines towards the eye in pixels, so that the surface next to them does not hide them. */
const LINE_BIAS = 1.5;

/** Longest computation of sections with which a drag is smooth, ms. 200,000 tetrahedra take a third of it. */
const SLOW_SECTION = 30;

/** Share of the largest value below which values say nothing about the limits, such as those of unloaded teeth. */
const NEGLIGIBLE = 1e-4;

export type Limits = [number, number];

export class Display {
  views: PartView[] = [];
  position: Position | null = null;
  /** Displayed meshes by part. */
  meshes: DeformedMesh[][] = [];
  colours: string[] = [];
  /** Factor of the displayed deformation. */
  factor = 0;
  limits: Limits | null = null;
  /** Values above automatic limits that leave out outliers: their share of the nodes, and the largest one. */
  clipped: { share: number; largest: number } | null = null;
  triangles = 0;
  readonly cut = new CutView();
  readonly contacts: ContactView;
  readonly forces: ForceView;
  readonly centre = new THREE.Vector3();
  radius = 1;

  /** Duration of the last computation of sections, ms. */
  sectionTime = 0;

  #meshViews = new MeshViews();
  /** Views of the displayed position's meshes, in its order. */
  #shownMeshes: MeshView[] = [];
  #values = new WeakMap<DeformedMesh, Map<NodalField, Float64Array>>();
  #largest = new WeakMap<Position, number>();
  #sectionEdges = false;
  #dragging = false;
  #reference: Float64Array | null = null;
  #matrix = new THREE.Matrix4();
  #cutOn = false;

  constructor(private readonly scene: Scene) {
    this.contacts = new ContactView(scene.uniforms);
    this.forces = new ForceView(scene.uniforms);
    scene.root.add(this.contacts.group, this.contacts.markLine, this.forces.group);
    scene.scene.add(this.cut.group);
  }

  /** Replaces the parts. `first` is the position that determines the bounds and the fixed frame. */
  setParts(parts: Part[], first: Position | null): void {
    this.clear();
    const numbers = new Map<string, number>();
    this.#reference = first?.poses ?? null;
    this.colours = parts.map(({ kind }) => {
      const n = numbers.get(kind) ?? 0;
      numbers.set(kind, n + 1);
      return partColour(kind, n);
    });
    this.views = parts.map((part, i) => {
      const view = new PartView(part, this.scene.uniforms, this.cut.capGeometry, this.colours[i]!);
      this.scene.root.add(view.group);
      this.scene.scene.add(view.cap);
      return view;
    });
    this.meshes = parts.map(() => []);
    const sphere = new THREE.Box3().setFromPoints(this.views.flatMap((view) => this.outline(view))).getBoundingSphere(new THREE.Sphere());
    this.centre.copy(sphere.center);
    this.radius = sphere.radius > 0 ? sphere.radius : 1;
    this.contacts.setBias(8e-4 * this.radius);
    this.cut.setBounds(this.centre, this.radius);
    this.updateBounds();
  }

  /** Points around the parts that are not hidden; all parts if there are none. */
  updateBounds(): void {
    const shown = this.views.filter((view) => view.visibility !== "hidden");
    const points = (shown.length > 0 ? shown : this.views).flatMap((view) => this.outline(view));
    this.scene.camera.setBounds(this.centre, this.radius * 1.1, points);
  }

  private outline(view: PartView): THREE.Vector3[] {
    const pose = poseMatrix(this.#reference, view.part.index, new THREE.Matrix4());
    const { min, max } = view.copies.box;
    const points: THREE.Vector3[] = [];
    if (view.part.points.length === 0 || !hasPose(this.#reference, view.part.index)) return points;
    if (view.part.copies > 1) {
      let r = 0;
      const p = view.part.points;
      for (let i = 0; i < p.length; i += 3) r = Math.max(r, Math.hypot(p[i]!, p[i + 1]!));
      for (let k = 0; k < 24; k++) {
        const angle = (2 * Math.PI * k) / 24;
        for (const z of [min.z, max.z]) points.push(new THREE.Vector3(r * Math.cos(angle), r * Math.sin(angle), z));
      }
    } else {
      for (let k = 0; k < 8; k++) {
        points.push(new THREE.Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z));
      }
    }
    return points.map((point) => point.applyMatrix4(pose));
  }

  setPosition(position: Position | null): void {
    this.position = position;
    this.meshes = this.views.map(() => []);
    const views: MeshView[][] = this.views.map(() => []);
    const replaced = this.views.map(() => new Set<number>());
    this.#shownMeshes = this.#meshViews.display(position?.meshes ?? [], (part) => this.views[part]!.meshMaterials);
    position?.meshes.forEach((mesh, i) => {
      this.meshes[mesh.part]!.push(mesh);
      views[mesh.part]!.push(this.#shownMeshes[i]!);
      replaced[mesh.part]!.add(mesh.copy);
    });
    this.views.forEach((view, i) => {
      poseMatrix(position?.poses ?? null, i, view.group.matrix);
      view.setPresent(hasPose(position?.poses ?? null, i));
      view.setMeshes(views[i]!, replaced[i]!);
    });
  }

  /** Values of a field at the nodes of a mesh. */
  values(mesh: DeformedMesh, field: NodalField): Float64Array {
    let fields = this.#values.get(mesh);
    if (!fields) this.#values.set(mesh, (fields = new Map()));
    let values = fields.get(field);
    if (!values) fields.set(field, (values = nodalValues(mesh, field)));
    return values;
  }

  /** Limits of a field in a position, over the parts that are not hidden. */
  limitsOf(position: Position, state: ViewState): Limits | null {
    return this.automaticLimits(position, state, this.extremes(position, state));
  }

  private automaticLimits(position: Position, state: ViewState, extremes: { min: Extreme; max: Extreme } | null): Limits | null {
    if (!extremes) return null;
    const share = shareWithin(state.colours.field);
    if (share === 1) return [extremes.min.value, extremes.max.value];
    const values = this.surfaceValues(position, state).filter((value) => value > NEGLIGIBLE * extremes.max.value).sort();
    return [extremes.min.value, values[Math.floor(share * (values.length - 1))] ?? extremes.max.value];
  }

  /** Known values of a nodal field on the surfaces of the parts that are not hidden. */
  private surfaceValues(position: Position, state: ViewState): Float64Array {
    const field = state.colours.field as NodalField;
    const shown = position.meshes.filter(({ part }) => this.shown(state, part));
    const all = new Float64Array(shown.reduce((sum, mesh) => sum + mesh.shape.points.length / 3, 0));
    let count = 0;
    for (const mesh of shown) {
      const mask = surfaceNodes(mesh.shape);
      this.values(mesh, field).forEach((value, node) => {
        if (mask[node] && Number.isFinite(value)) all[count++] = value;
      });
    }
    return all.subarray(0, count);
  }

  private clippedBy(limits: Limits | null, state: ViewState, extremes: { max: Extreme } | null): Display["clipped"] {
    const { field, limits: mode } = state.colours;
    if (!limits || !extremes || !this.position || mode === "fixed" || shareWithin(field) === 1) return null;
    const values = this.surfaceValues(this.position, state);
    const above = values.reduce((count, value) => count + (value > limits[1] ? 1 : 0), 0);
    return above > 0 ? { share: above / values.length, largest: extremes.max.value } : null;
  }

  private shown(state: ViewState, part: number): boolean {
    const name = this.views[part]?.part.name;
    return name !== undefined && state.parts[name] !== "hidden";
  }

  /** A contact cell is displayed if one of its gears is, and if its kind is chosen. */
  cellShown(state: ViewState, position: Position, cell: number): boolean {
    const contacts = position.contacts!;
    const { parts } = contacts;
    if (!isChosen(contacts, cell, state.colours.cells)) return false;
    return this.shown(state, parts[2 * cell]!) || this.shown(state, parts[2 * cell + 1]!);
  }

  /** Smallest and largest value of the selected field and their locations. */
  extremes(position: Position, state: ViewState): { min: Extreme; max: Extreme } | null {
    const { field } = state.colours;
    let min: Extreme | null = null;
    let max: Extreme | null = null;
    if (isNodal(field)) {
      for (const mesh of position.meshes) {
        if (!this.shown(state, mesh.part)) continue;
        const values = this.values(mesh, field);
        const mask = surfaceNodes(mesh.shape);
        for (let node = 0; node < values.length; node++) {
          const value = values[node]!;
          if (!mask[node] || !Number.isFinite(value)) continue;
          if (!min || value < min.value) min = { value, mesh, index: node };
          if (!max || value > max.value) max = { value, mesh, index: node };
        }
      }
    } else if (field === "contact_pressure" && position.contacts) {
      const shown = Float64Array.from(position.contacts.pressures, (pressure, cell) =>
        pressure > 0 && this.cellShown(state, position, cell) ? pressure : NaN,
      );
      const range = rangeOf(shown);
      if (range) {
        // The scale begins at zero, where contact is lost.
        min = { value: 0, mesh: null, index: range.minIndex };
        max = { value: range.max, mesh: null, index: range.maxIndex };
      }
    }
    return min && max ? { min, max } : null;
  }

  private extremePoint(extreme: Extreme, position: Position): THREE.Vector3 {
    const point = new THREE.Vector3();
    const { mesh, index } = extreme;
    if (mesh) {
      return point.set(...displacedPoint(mesh, index, this.factor)).applyMatrix4(poseMatrix(position.poses, mesh.part, this.#matrix));
    }
    const corners = position.contacts!.corners;
    for (let k = 0; k < 4; k++) {
      point.x += corners[12 * index + 3 * k]! / 4;
      point.y += corners[12 * index + 3 * k + 1]! / 4;
      point.z += corners[12 * index + 3 * k + 2]! / 4;
    }
    return point;
  }

  /** Applies the state to the displayed position. Returns the labels of the scene. */
  apply(state: ViewState, allLimits: Limits | null): Label[] {
    const { uniforms } = this.scene;
    const { colours } = state;
    const position = this.position;
    const nodal = isNodal(colours.field);
    for (const view of this.views) {
      view.setVisibility(visibilityOf(state, view.part));
      view.setFieldMode(nodal);
      view.setEdges(state.mesh_edges);
      view.setSections(this.sectionsShown(state));
    }
    this.applyFrame(state);
    this.factor = this.deformationFactor(state);
    uniforms.deformation.value = this.factor;

    if (nodal) {
      for (const view of this.#shownMeshes) view.setField(this.values(view.mesh!, colours.field as NodalField));
    }
    this.#sectionEdges = state.mesh_edges;
    const withCells = position && colours.field === "contact_pressure" ? position.contacts : null;
    const choice = JSON.stringify([colours.cells, Object.entries(state.parts).filter(([, v]) => v === "hidden")]);
    this.contacts.set(withCells, choice, (cell) => this.cellShown(state, position!, cell));
    this.contacts.setBehind(state.hidden_contacts);
    const extremes = position ? this.extremes(position, state) : null;
    this.limits = this.chooseLimits(state, extremes, allLimits);
    this.clipped = this.clippedBy(this.limits, state, extremes);
    if (this.limits) uniforms.limits.value.set(...this.limits);
    fillScaleTexture(this.scene.scaleTexture, colours.scale, colours.bands);

    const names = this.views.map(({ part }) => part.name);
    this.forces.set(position?.forces ?? [], { ...state.forces, radius: this.radius, names });
    this.applyCut(state);
    const labels = [...this.forces.labels];
    if (position && extremes && state.extremes) {
      // The label has the unit of the legend.
      const size = Math.max(Math.abs(extremes.min.value), Math.abs(extremes.max.value));
      const unit = FIELDS[colours.field].quantity === "length" ? displayUnit("m", size) : stressUnit();
      const mark = (extreme: Extreme, kind: "maximum" | "minimum", word: string) => {
        const value = Math.abs(extreme.value) < 1e-9 * size ? 0 : extreme.value * unit.factor;
        const point = this.extremePoint(extreme, position);
        if (this.isCutAway(point)) return;
        labels.push({ kind, text: `${word} ${formatNumber(value)} ${unit.symbol}`, point });
      };
      if (markedExtreme(colours.field) === "maximum") mark(extremes.max, "maximum", "max");
      else mark(extremes.min, "minimum", "min");
    }
    return labels;
  }

  private chooseLimits(state: ViewState, extremes: { min: Extreme; max: Extreme } | null, all: Limits | null): Limits | null {
    const { colours } = state;
    if (colours.field === "plain") return null;
    if (colours.limits === "fixed") return [Math.min(colours.min, colours.max), Math.max(colours.min, colours.max)];
    if (colours.limits === "all" && all) return all;
    return this.position && this.automaticLimits(this.position, state, extremes);
  }

  private deformationFactor(state: ViewState): number {
    const { mode, factor } = state.deformation;
    if (mode === "factor") return Number.isFinite(factor) ? factor : 0;
    // Contact cells and plain parts have no elastic displacements: those pictures stay undeformed.
    if (!isNodal(state.colours.field)) return 0;
    const largest = this.position ? this.largestDisplacement(this.position) : 0;
    // The size of a scene is its diameter. A round factor is readable and steadier over positions.
    return largest > 0 ? roundDown125((AUTOMATIC_DEFORMATION * 2 * this.radius) / largest) : 1;
  }

  private largestDisplacement(position: Position): number {
    let square = this.#largest.get(position);
    if (square === undefined) {
      square = 0;
      for (const { displacements: u } of position.meshes) {
        for (let i = 0; i < u.length; i += 3) square = Math.max(square, u[i]! ** 2 + u[i + 1]! ** 2 + u[i + 2]! ** 2 || 0);
      }
      this.#largest.set(position, square);
    }
    return Math.sqrt(square);
  }

  private applyFrame(state: ViewState): void {
    const { root } = this.scene;
    root.matrix.identity();
    const index = this.views.findIndex((view) => view.part.name === state.frame);
    const isPlaced = (poses: Float64Array | null | undefined) => poses && hasPose(poses, index);
    if (index >= 0 && this.position && isPlaced(this.#reference) && isPlaced(this.position.poses)) {
      poseMatrix(this.#reference, index, root.matrix);
      root.matrix.multiply(poseMatrix(this.position.poses, index, this.#matrix).invert());
    }
    root.updateMatrixWorld(true);
  }

  applyCut(state: ViewState): void {
    this.cut.apply(state.cut, this.scene.uniforms.cutPlane.value);
    for (const view of this.views) {
      view.cap.matrix.copy(this.cut.capMatrix);
      view.cap.updateMatrixWorld(true);
    }
    if (this.#cutOn === state.cut.on) return;
    this.#cutOn = state.cut.on;
    for (const view of this.views) view.setCut(this.#cutOn);
    for (const material of this.contacts.materials) material.cut = this.#cutOn;
  }

  private isCutAway(point: THREE.Vector3): boolean {
    const plane = this.cutPlane;
    const p = toCentre.copy(point).applyMatrix4(this.scene.root.matrix);
    return plane !== null && plane.x * p.x + plane.y * p.y + plane.z * p.z + plane.w > 0;
  }

  get cutPlane(): THREE.Vector4 | null {
    return this.#cutOn ? this.scene.uniforms.cutPlane.value : null;
  }

  /** While a plane is dragged, sections that take too long are replaced by hatched caps. */
  setDragging(on: boolean, state: ViewState): void {
    if (on === this.#dragging) return;
    this.#dragging = on;
    for (const view of this.views) view.setSections(this.sectionsShown(state));
    this.scene.invalidate();
  }

  private sectionsShown(state: ViewState): boolean {
    const wanted = isNodal(state.colours.field) || state.mesh_edges;
    return wanted && !(this.#dragging && this.sectionTime > SLOW_SECTION);
  }

  /** Computes the sections through the cells of meshes that have changed. */
  private updateSections(): void {
    const start = performance.now();
    let changed = false;
    for (const view of this.views) {
      const plane = view.showsSections ? this.planeOf(view) : null;
      for (const mesh of view.meshes) {
        if (!mesh.section) continue;
        if (plane && mesh.mesh) {
          const values = view.showsField ? mesh.values : null;
          changed = mesh.section.update(mesh.mesh, values, plane, this.factor, this.#sectionEdges) || changed;
        } else {
          mesh.section.hide();
        }
      }
    }
    if (changed) this.sectionTime = performance.now() - start;
  }

  /** The cutting plane in coordinates of a part. */
  private planeOf(view: PartView): Plane {
    const { x, y, z, w } = this.scene.uniforms.cutPlane.value;
    const e = view.group.matrixWorld.elements;
    return [
      e[0]! * x + e[1]! * y + e[2]! * z,
      e[4]! * x + e[5]! * y + e[6]! * z,
      e[8]! * x + e[9]! * y + e[10]! * z,
      e[12]! * x + e[13]! * y + e[14]! * z + w,
    ];
  }

  /** Prepares a frame: sections, and the choice of the copies to draw. */
  prepareFrame(): void {
    this.updateSections();
    const frustum = this.scene.frustum();
    const { active, state, direction } = this.scene.camera;
    const scale = this.scene.height / state.height;
    this.scene.uniforms.lineBias.value = LINE_BIAS / scale;
    const distance = active.position.distanceTo(target.fromArray(state.target));
    const orthographic = state.projection === "orthographic";
    const pixels = (centre: THREE.Vector3): number => {
      if (orthographic) return scale;
      const depth = toCentre.copy(active.position).sub(centre).dot(direction);
      return depth > 0 ? (scale * distance) / depth : scale;
    };
    this.triangles = 0;
    for (const view of this.views) this.triangles += view.prepare(frustum, pixels);
  }

  clear(): void {
    for (const view of this.views) {
      view.group.removeFromParent();
      view.cap.removeFromParent();
      view.dispose();
    }
    this.#meshViews.dispose();
    this.#shownMeshes = [];
    this.views = [];
    this.position = null;
    this.#cutOn = false;
    for (const material of this.contacts.materials) material.cut = false;
  }

  dispose(): void {
    this.clear();
    this.contacts.dispose();
    this.forces.dispose();
  }
}

/** An extreme value: at a node of a mesh, or in a contact cell if there is no mesh. */
interface Extreme {
  value: number;
  mesh: DeformedMesh | null;
  index: number;
}

const target = new THREE.Vector3();
const toCentre = new THREE.Vector3();

/** Returns whether a part has a position; all have one if there are no poses. */
function hasPose(poses: Float64Array | null, part: number): boolean {
  return !poses || poses.subarray(12 * part, 12 * part + 12).every(Number.isFinite);
}

/** Writes the pose of a part into a matrix; the identity if there is none. */
export function poseMatrix(poses: Float64Array | null, part: number, matrix: THREE.Matrix4): THREE.Matrix4 {
  if (!poses || !hasPose(poses, part)) return matrix.identity();
  const [a, b, c, d, e, f, g, h, i, x, y, z] = poses.subarray(12 * part, 12 * part + 12);
  return matrix.set(a!, b!, c!, x!, d!, e!, f!, y!, g!, h!, i!, z!, 0, 0, 0, 1);
}
