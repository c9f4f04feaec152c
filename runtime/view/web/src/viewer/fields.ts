// Scalar fields of deformed meshes: principal stresses, von Mises stress, displacement.

import type { DeformedMesh, MeshShape } from "./run_data.ts";
import type { Field } from "./state.ts";

/** Principal stresses, largest first. */
export type Principal = [number, number, number];

/**
 * Computes the principal stresses in closed form: σᵢ = σₘ + 2 √(J₂/3) cos(θ − 2πi/3), with
 * tan 3θ = √Δ / (√27 J₃) and Δ = 4 J₂³ − 27 J₃².
 *
 * The usual form, cos 3θ = √27 J₃ / (2 J₂^1.5), loses half of the digits at repeated roots, because
 * Δ vanishes there by cancellation. With the deviator D and the deviatoric part E of D², Lagrange's
 * identity gives Δ = 3 (|D|²|E|² − (D:E)²) = 3 Σ (Dᵢ Eⱼ − Dⱼ Eᵢ)², a sum of squares without
 * cancellation between them.
 */
export function principalStresses(xx: number, yy: number, zz: number, yz: number, zx: number, xy: number): Principal {
  const scale = Math.max(Math.abs(xx), Math.abs(yy), Math.abs(zz), Math.abs(yz), Math.abs(zx), Math.abs(xy));
  if (!Number.isFinite(scale)) return [NaN, NaN, NaN];
  if (scale === 0) return [0, 0, 0];
  const mean = (xx + yy + zz) / 3;
  // The deviator from differences, which are exact for equal normal stresses.
  const ab = (xx - yy) / scale;
  const bc = (yy - zz) / scale;
  const ca = (zz - xx) / scale;
  const a = (ab - ca) / 3;
  const b = (bc - ab) / 3;
  const c = (ca - bc) / 3;
  const p = yz / scale;
  const q = zx / scale;
  const r = xy / scale;
  const j2 = (ab * ab + bc * bc + ca * ca) / 6 + p * p + q * q + r * r;
  if (j2 === 0) return [mean, mean, mean];
  const j3 = a * (b * c - p * p) - r * (r * c - p * q) + q * (r * p - b * q);

  const third = (2 * j2) / 3;
  const root2 = Math.SQRT2;
  const ea = a * a + r * r + q * q - third;
  const eb = b * b + r * r + p * p - third;
  const ec = c * c + p * p + q * q - third;
  const ep = root2 * (q * r - a * p);
  const eq = root2 * (p * r - b * q);
  const er = root2 * (p * q - c * r);
  const dp = root2 * p;
  const dq = root2 * q;
  const dr = root2 * r;
  const squares =
    (a * eb - b * ea) ** 2 + (a * ec - c * ea) ** 2 + (b * ec - c * eb) ** 2 +
    (a * ep - dp * ea) ** 2 + (a * eq - dq * ea) ** 2 + (a * er - dr * ea) ** 2 +
    (b * ep - dp * eb) ** 2 + (b * eq - dq * eb) ** 2 + (b * er - dr * eb) ** 2 +
    (c * ep - dp * ec) ** 2 + (c * eq - dq * ec) ** 2 + (c * er - dr * ec) ** 2 +
    (dp * eq - dq * ep) ** 2 + (dp * er - dr * ep) ** 2 + (dq * er - dr * eq) ** 2;

  const angle = Math.atan2(Math.sqrt(3 * squares), Math.sqrt(27) * j3) / 3;
  const radius = 2 * Math.sqrt(j2 / 3) * scale;
  const step = (2 * Math.PI) / 3;
  return [
    mean + radius * Math.cos(angle),
    mean + radius * Math.cos(angle - step),
    mean + radius * Math.cos(angle + step),
  ];
}

/** Computes the von Mises stress. */
export function vonMises(xx: number, yy: number, zz: number, yz: number, zx: number, xy: number): number {
  const a = xx - yy;
  const b = yy - zz;
  const c = zz - xx;
  return Math.sqrt(0.5 * (a * a + b * b + c * c) + 3 * (yz * yz + zx * zx + xy * xy));
}

/** Fields that are given at the nodes of meshes. */
export type NodalField = Exclude<Field, "plain" | "contact_pressure">;

export function isNodal(field: Field): field is NodalField {
  return field !== "plain" && field !== "contact_pressure";
}

/** Label and dimension of each field. */
export const FIELDS: Record<Field, { label: string; quantity: "stress" | "length" | "none" }> = {
  plain: { label: "Plain", quantity: "none" },
  contact_pressure: { label: "Contact pressure", quantity: "stress" },
  max_principal: { label: "Maximum principal stress", quantity: "stress" },
  min_principal: { label: "Minimum principal stress", quantity: "stress" },
  von_mises: { label: "Von Mises stress", quantity: "stress" },
  stress_error: { label: "Stress error", quantity: "stress" },
  displacement: { label: "Displacement", quantity: "length" },
};

/** Explanation of a field whose name is not enough. */
export const EXPLANATIONS: Partial<Record<Field, string>> = {
  stress_error:
    "Estimated error of the stresses, as von Mises stress: the difference between the averaged stresses at a node " +
    "and those of its elements (Zienkiewicz and Zhu). Where it is large, a finer mesh changes the stresses. It is " +
    "largest at contacts, whose loads are concentrated at nodes: automatic limits leave out the largest " +
    "values, so that the fillets and the body are visible.",
};

/** Reason why the automatic factor shows no deformation. */
export const UNDEFORMED =
  "Contact pressure and plain colours show the undeformed shape, because contact cells and plain parts have no " +
  "elastic displacements. Choose a stress or the displacement to see the deformation, or set a factor.";

/** Share of the nodes with relevant values that is below the upper automatic limit; 1 for fields without outliers. */
export function shareWithin(field: Field): number {
  return field === "stress_error" ? 0.9 : 1;
}

/** Extremes that are worth a mark: the largest magnitude of the field. */
export function markedExtreme(field: Field): "minimum" | "maximum" {
  return field === "min_principal" ? "minimum" : "maximum";
}

/** Value of a field at a node, in SI units; NaN if it is unknown. */
export function nodalValue(mesh: DeformedMesh, field: NodalField, node: number): number {
  if (field === "displacement") {
    const u = mesh.displacements;
    return Math.hypot(u[3 * node]!, u[3 * node + 1]!, u[3 * node + 2]!);
  }
  if (field === "stress_error") return mesh.stressErrors?.[node] ?? NaN;
  const s = mesh.stresses;
  if (!s) return NaN;
  const i = 6 * node;
  const [xx, yy, zz, yz, zx, xy] = [s[i]!, s[i + 1]!, s[i + 2]!, s[i + 3]!, s[i + 4]!, s[i + 5]!];
  if (field === "von_mises") return vonMises(xx, yy, zz, yz, zx, xy);
  const principal = principalStresses(xx, yy, zz, yz, zx, xy);
  return field === "max_principal" ? principal[0] : principal[2];
}

/** Smallest and largest value of a field and their indices. */
export interface Range {
  min: number;
  max: number;
  minIndex: number;
  maxIndex: number;
}

/** Finds the smallest and the largest finite value; null if there is none. */
export function rangeOf(values: ArrayLike<number>): Range | null {
  const range: Range = { min: Infinity, max: -Infinity, minIndex: -1, maxIndex: -1 };
  for (let i = 0; i < values.length; i++) {
    const value = values[i]!;
    if (value < range.min && value !== -Infinity) {
      range.min = value;
      range.minIndex = i;
    }
    if (value > range.max && value !== Infinity) {
      range.max = value;
      range.maxIndex = i;
    }
  }
  return range.minIndex < 0 || range.maxIndex < 0 ? null : range;
}

const masks = new WeakMap<MeshShape, Uint8Array>();

/** Nodes on the outer surface, as a mask: the others are not visible and do not count for limits. */
export function surfaceNodes(shape: MeshShape): Uint8Array {
  let mask = masks.get(shape);
  if (mask) return mask;
  mask = new Uint8Array(shape.points.length / 3);
  for (let i = 0; i < shape.triangles.length; i++) mask[shape.triangles[i]!] = 1;
  masks.set(shape, mask);
  return mask;
}

/** Values of a field at all nodes, in double precision: the same numbers as at the pointer. */
export function nodalValues(mesh: DeformedMesh, field: NodalField): Float64Array {
  const count = mesh.shape.points.length / 3;
  const values = new Float64Array(count);
  for (let node = 0; node < count; node++) values[node] = nodalValue(mesh, field, node);
  return values;
}
