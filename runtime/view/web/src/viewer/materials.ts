// Materials of surfaces, lines, caps and contact cells.
//
// One set of shaders serves all of them. Displacements and field values are attributes; the factor of
// the deformation, the limits and the colours are uniforms. A change of those costs one frame and
// does not touch the geometry.

import * as THREE from "three";

/** Field value of a node without a value. Interpolation makes a whole triangle exceed `NO_VALUE_TEST`. */
export const NO_VALUE = 1e30;
const NO_VALUE_TEST = "1e20";
/** Field value of all nodes of a copy without a field: it has the colour of its part. */
export const NO_FIELD = 1e34;
const NO_FIELD_TEST = "1e32";

/** Uniforms that all materials of a viewer share. */
export interface SharedUniforms {
  /** Plane of the cut in world coordinates: points with a positive distance are removed. */
  cutPlane: { value: THREE.Vector4 };
  deformation: { value: number };
  limits: { value: THREE.Vector2 };
  scale: { value: THREE.DataTexture };
  noValue: { value: THREE.Color };
  lineColour: { value: THREE.Color };
  edgeColour: { value: THREE.Color };
  pixelRatio: { value: number };
  /** Movement of lines towards the eye, m. */
  lineBias: { value: number };
}

// Centroid: at a pixel that a triangle covers in part, the values at its middle are extrapolated. A
// triangle seen from its edge would reach across the cut there, and leave stray pixels.
const VERTEX = /* glsl */ `
#ifdef COPIES
// Rotations of the copy and of the next one.
attribute vec4 copyRotation;
// 1 for a point of the next copy.
attribute float seam;
#endif
#ifdef DEFORMED
attribute vec3 displacement;
uniform float deformation;
#endif
#ifdef FIELD
attribute float field;
centroid varying float vField;
#endif
#ifdef LIT
centroid varying vec3 vNormal;
centroid varying vec3 vEye;
#endif
#ifdef CUT
uniform vec4 cutPlane;
centroid varying float vCut;
#endif
uniform float bias;

void main() {
  vec3 p = position;
  #ifdef COPIES
  vec2 turn = seam > 0.5 ? copyRotation.zw : copyRotation.xy;
  p = vec3(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y, p.z);
  #endif
  #ifdef DEFORMED
  // Displacements are in coordinates of the part, not of copy 0.
  p += deformation * displacement;
  #endif
  vec4 world = modelMatrix * vec4(p, 1.0);
  #ifdef CUT
  vCut = dot(cutPlane.xyz, world.xyz) + cutPlane.w;
  #endif
  vec4 eye = viewMatrix * world;
  #ifdef LIT
  vec3 n = normal;
  #ifdef COPIES
  n = vec3(copyRotation.x * n.x - copyRotation.y * n.y, copyRotation.y * n.x + copyRotation.x * n.y, n.z);
  #endif
  vNormal = normalMatrix * n;
  vEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -eye.xyz;
  #endif
  #ifdef FIELD
  vField = field;
  #endif
  // Moves the point towards the eye, so that it appears in front of the surface below it.
  eye.xyz += bias * (isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-eye.xyz));
  gl_Position = projectionMatrix * eye;
}
`;

const FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform float opacity;
#ifdef FIELD
uniform bool useField;
uniform sampler2D scale;
uniform vec2 limits;
uniform vec3 noValue;
centroid varying float vField;
#endif
#ifdef LIT
centroid varying vec3 vNormal;
centroid varying vec3 vEye;
#endif
#ifdef CUT
centroid varying float vCut;
#endif
#ifdef CAP
uniform float pixelRatio;
#endif

void main() {
  #ifdef CUT
  if (vCut > 0.0) discard;
  #endif
  vec3 base = colour;
  float gloss = 1.0;
  #ifdef FIELD
  if (useField) {
    gloss = 0.0;
    float fraction = (vField - limits.x) / max(limits.y - limits.x, 1e-30);
    if (vField < ${NO_FIELD_TEST}) base = vField > ${NO_VALUE_TEST} ? noValue : texture2D(scale, vec2(clamp(fraction, 0.0, 1.0) * 0.99609375 + 0.001953125, 0.5)).rgb;
  }
  #endif
  #ifdef LIT
  vec3 n = normalize(vNormal);
  if (!gl_FrontFacing) n = -n;
  vec3 toEye = normalize(vEye);
  // The lights are fixed to the camera: a soft sky, a key light from the upper left, and a fill light.
  float sky = 0.5 + 0.5 * n.y;
  float key = max(dot(n, vec3(-0.387, 0.560, 0.733)), 0.0);
  float fill = max(dot(n, vec3(0.707, -0.141, 0.693)), 0.0);
  vec3 ambient = mix(vec3(0.36, 0.36, 0.38), vec3(0.58, 0.60, 0.63), sky);
  vec3 light = ambient + vec3(0.62, 0.61, 0.59) * key + vec3(0.13, 0.14, 0.16) * fill;
  // Colours of a field must match the legend: less contrast, and no gloss.
  light = mix(vec3(0.55) + 0.45 * light, light, gloss);
  vec3 halfway = normalize(toEye + vec3(-0.387, 0.560, 0.733));
  float gleam = pow(max(dot(n, halfway), 0.0), 38.0);
  float rim = pow(1.0 - max(dot(n, toEye), 0.0), 3.0);
  base = base * light * (1.0 - 0.22 * rim) + gloss * 0.13 * gleam;
  #endif
  #ifdef CAP
  // Hatching at 45 degrees, as in a sectional drawing.
  float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * pixelRatio)) - 0.5) * 9.0;
  float hatch = mix(0.80, 1.0, smoothstep(0.35, 1.1, stripe));
  #ifdef FIELD
  if (useField && vField < ${NO_FIELD_TEST}) hatch = 1.0;
  #endif
  base *= hatch;
  #endif
  gl_FragColor = vec4(base, opacity);
  #include <colorspace_fragment>
}
`;

/** `ON_PLANE` marks what lies in the plane of the cut. */
export type Feature = "COPIES" | "DEFORMED" | "FIELD" | "LIT" | "CAP" | "ON_PLANE";

/** A material of the shared shaders. */
export class ViewMaterial extends THREE.ShaderMaterial {
  /** Materials that the cut does not apply to, such as caps. */
  readonly cuttable: boolean;

  constructor(
    shared: SharedUniforms,
    features: Feature[],
    parameters: THREE.ShaderMaterialParameters = {},
    colour?: { value: THREE.Color },
  ) {
    super({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      defines: Object.fromEntries(features.map((feature) => [feature, ""])),
      ...parameters,
    });
    this.uniforms = {
      cutPlane: shared.cutPlane,
      deformation: shared.deformation,
      limits: shared.limits,
      scale: shared.scale,
      noValue: shared.noValue,
      pixelRatio: shared.pixelRatio,
      colour: colour ?? { value: new THREE.Color() },
      opacity: { value: 1 },
      useField: { value: false },
      bias: { value: 0 },
    };
    this.cuttable = !features.includes("CAP") && !features.includes("ON_PLANE");
  }

  get colour(): THREE.Color {
    return this.uniforms.colour!.value as THREE.Color;
  }

  set alpha(value: number) {
    this.uniforms.opacity!.value = value;
    this.transparent = value < 1;
  }

  set useField(value: boolean) {
    this.uniforms.useField!.value = value;
  }

  set bias(value: number) {
    this.uniforms.bias!.value = value;
  }

  set cut(on: boolean) {
    if (!this.cuttable || on === ("CUT" in this.defines)) return;
    if (on) this.defines.CUT = "";
    else delete this.defines.CUT;
    this.needsUpdate = true;
  }
}

export function createSharedUniforms(scale: THREE.DataTexture): SharedUniforms {
  return {
    cutPlane: { value: new THREE.Vector4(0, 0, 1, 0) },
    deformation: { value: 0 },
    limits: { value: new THREE.Vector2(0, 1) },
    scale: { value: scale },
    noValue: { value: new THREE.Color("#9a9a9a") },
    lineColour: { value: new THREE.Color("#1c2733") },
    edgeColour: { value: new THREE.Color("#1c2733") },
    pixelRatio: { value: 1 },
    lineBias: { value: 0 },
  };
}

/** Materials of one part, for its copies or for its deformed meshes. */
export interface MaterialSet {
  surface: ViewMaterial;
  features: ViewMaterial;
  edges: ViewMaterial;
  stencilBack: ViewMaterial;
  stencilFront: ViewMaterial;
  /** Section through the cells of a mesh: coloured, or hatched without a field. */
  section: ViewMaterial;
  sectionEdges: ViewMaterial;
}

export function createMaterialSet(shared: SharedUniforms, deformed: boolean): MaterialSet {
  const geometry: Feature[] = deformed ? ["COPIES", "DEFORMED"] : ["COPIES"];
  const stencil = (side: THREE.Side, operation: THREE.StencilOp) =>
    new ViewMaterial(shared, geometry, {
      side,
      colorWrite: false,
      depthWrite: false,
      depthTest: false,
      stencilWrite: true,
      stencilFunc: THREE.AlwaysStencilFunc,
      stencilFail: operation,
      stencilZFail: operation,
      stencilZPass: operation,
    });
  const lines = (colour: { value: THREE.Color }, alpha: number, features = geometry) => {
    const material = new ViewMaterial(shared, features, { depthWrite: false }, colour);
    material.alpha = alpha;
    // An offset of the polygons by their slope would push back triangles thinner than a pixel, whose slope
    // is not defined, so that what is behind them would be visible.
    material.uniforms.bias = shared.lineBias;
    return material;
  };
  return {
    surface: new ViewMaterial(shared, deformed ? ["COPIES", "DEFORMED", "FIELD", "LIT"] : ["COPIES", "LIT"]),
    features: lines(shared.lineColour, 0.55),
    edges: lines(shared.edgeColour, 0.3),
    stencilBack: stencil(THREE.BackSide, THREE.IncrementWrapStencilOp),
    stencilFront: stencil(THREE.FrontSide, THREE.DecrementWrapStencilOp),
    section: new ViewMaterial(shared, ["FIELD", "CAP"], {
      side: THREE.DoubleSide,
      // Caps of other parts are in front of the section in the same plane.
      polygonOffset: true,
      polygonOffsetFactor: 1,
    }),
    sectionEdges: lines(shared.edgeColour, 0.34, ["ON_PLANE"]),
  };
}

export function createCapMaterial(shared: SharedUniforms): ViewMaterial {
  return new ViewMaterial(shared, ["CAP"], {
    side: THREE.DoubleSide,
    stencilWrite: true,
    stencilRef: 0,
    stencilFunc: THREE.NotEqualStencilFunc,
    stencilFail: THREE.ReplaceStencilOp,
    stencilZFail: THREE.ReplaceStencilOp,
    stencilZPass: THREE.ReplaceStencilOp,
  });
}
