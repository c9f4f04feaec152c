//! Integrals of the kernels over a triangle for a point in the fluid.

use crate::operators::Operators;
use crate::pair::quartered;
use crate::panel::Panel;
use crate::quadrature::{Barycentric, TriangleRule, triangle_rule};
use calyx_numerics::vec3::{Vector, dot, length, minus, plus, scaled};
use faer::c64;
use wide::f64x4;

/// Four points of a triangle: barycentric coordinates and weights.
type PointGroup = ([f64x4; 3], f64x4);

/// Quadrature rules by the distance of the point.
#[derive(Debug)]
pub(crate) struct PointQuadrature {
    rules: [Vec<PointGroup>; 3],
}

/// Index of the rule for the far field, which has 6 points.
const FAR: usize = 1;

/// Least distances of the centroid for the rules of 3 and 6 points, relative to the radius.
const LIMITS: [f64; 2] = [6.0, 3.5];
/// Least distance for the rule of 12 points relative to the longest edge; closer triangles are
/// subdivided.
const NEAR: f64 = 0.5;
/// Largest number of subdivisions.
const DEPTH: usize = 16;

/// Integrals over a triangle: ∫ G, and ∫ φ_j ∂G/∂n of its shape functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointMoments {
    pub single: c64,
    pub double: [c64; 3],
}

impl PointQuadrature {
    pub fn new() -> Self {
        Self { rules: [3, 6, 12].map(|points| packed(&triangle_rule(points))) }
    }

    /// Integrates over a triangle.
    pub fn moments(&self, wavenumber: f64, at: Vector, panel: &Panel) -> PointMoments {
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let zero = c64::new(0.0, 0.0);
        let mut sum = PointMoments { single: zero, double: [zero; 3] };
        let distance = length(minus(at, panel.centroid)) / panel.radius;
        match LIMITS.iter().position(|limit| distance >= *limit) {
            Some(rule) => add(&self.rules[rule], wavenumber, at, panel, unit, 1.0, &mut sum),
            None => self.subdivided(wavenumber, at, panel, unit, (DEPTH, 1.0), &mut sum),
        }
        sum
    }

    fn subdivided(
        &self,
        wavenumber: f64,
        at: Vector,
        panel: &Panel,
        part: [Barycentric; 3],
        (depth, weight): (usize, f64),
        sum: &mut PointMoments,
    ) {
        let corners = part.map(|point| position(panel, point));
        let [a, b, c] = corners;
        let edge = [minus(a, b), minus(b, c), minus(c, a)].map(length).into_iter().fold(0.0, f64::max);
        if depth == 0 || distance(at, corners) >= NEAR * edge {
            add(&self.rules[2], wavenumber, at, panel, part, weight, sum);
            return;
        }
        for quarter in quartered(part) {
            self.subdivided(wavenumber, at, panel, quarter, (depth - 1, 0.25 * weight), sum);
        }
    }

    /// Returns the row of the far field in a direction (a unit vector): the limit of the pressure
    /// at the distance r, times r exp(ikr). Parts as for [`PointQuadrature::row`].
    pub fn far_row(&self, operators: &Operators, direction: Vector) -> (Vec<c64>, Vec<c64>) {
        let mut pressure = vec![c64::new(0.0, 0.0); operators.nodes];
        let mut derivative = vec![c64::new(0.0, 0.0); operators.panels.len()];
        let wavenumber = operators.wavenumber;
        for panels in [&operators.panels, &operators.images] {
            for (triangle, panel) in panels.iter().enumerate() {
                let phases = panel.corners.map(|at| f64x4::splat(wavenumber * dot(direction, at)));
                // Integrals of the plane wave by shape function, and its own.
                let mut sums = [[f64x4::splat(0.0); 2]; 4];
                for (coordinates, weights) in &self.rules[FAR] {
                    let [a, b, c] = [0, 1, 2].map(|k: usize| phases[k] * coordinates[k]);
                    let (sine, cosine) = (a + b + c).sin_cos();
                    let parts = [cosine * *weights, sine * *weights];
                    for (sum, part) in sums[3].iter_mut().zip(parts) {
                        *sum += part;
                    }
                    for (own, coordinate) in sums.iter_mut().zip(coordinates) {
                        own.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part * *coordinate);
                    }
                }
                let scale = panel.area / (4.0 * std::f64::consts::PI);
                let [a, b, c, whole] =
                    sums.map(|[re, im]| c64::new(re.reduce_add(), im.reduce_add()) * scale);
                derivative[triangle] -= whole;
                let slope = c64::new(0.0, wavenumber * dot(direction, panel.normal));
                for (node, value) in panel.nodes.iter().zip([a, b, c]) {
                    pressure[*node] += slope * value;
                }
            }
        }
        (pressure, derivative)
    }

    /// Returns the row of the representation formula for a point: the pressure there is the sum of
    /// the first part times the pressures of the vertices and the second part times the normal
    /// derivatives of the triangles.
    pub fn row(&self, operators: &Operators, at: Vector) -> (Vec<c64>, Vec<c64>) {
        let mut pressure = vec![c64::new(0.0, 0.0); operators.nodes];
        let mut derivative = vec![c64::new(0.0, 0.0); operators.panels.len()];
        for panels in [&operators.panels, &operators.images] {
            for (triangle, panel) in panels.iter().enumerate() {
                let PointMoments { single, double } = self.moments(operators.wavenumber, at, panel);
                derivative[triangle] -= single;
                for (node, value) in panel.nodes.iter().zip(double) {
                    pressure[*node] += value;
                }
            }
        }
        (pressure, derivative)
    }
}

fn packed(rule: &TriangleRule) -> Vec<PointGroup> {
    rule.chunks(4)
        .map(|chunk| {
            let at = |lane: usize| chunk[lane.min(chunk.len() - 1)];
            let lanes = |value: &dyn Fn(usize) -> f64| f64x4::from([0, 1, 2, 3].map(value));
            let coordinates = [0, 1, 2].map(|axis| lanes(&|lane| at(lane).0[axis]));
            (coordinates, lanes(&|lane| if lane < chunk.len() { at(lane).1 } else { 0.0 }))
        })
        .collect()
}

fn position(panel: &Panel, [a, b, c]: Barycentric) -> Vector {
    let [p, q, r] = panel.corners;
    plus(plus(scaled(p, a), scaled(q, b)), scaled(r, c))
}

/// Returns the distance of a point from a triangle (Ericson 2005, section 5.1.5).
pub(crate) fn distance(at: Vector, [a, b, c]: [Vector; 3]) -> f64 {
    let (ab, ac, ap) = (minus(b, a), minus(c, a), minus(at, a));
    let (d1, d2) = (dot(ab, ap), dot(ac, ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return length(ap);
    }
    let bp = minus(at, b);
    let (d3, d4) = (dot(ab, bp), dot(ac, bp));
    if d3 >= 0.0 && d4 <= d3 {
        return length(bp);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return length(minus(ap, scaled(ab, d1 / (d1 - d3))));
    }
    let cp = minus(at, c);
    let (d5, d6) = (dot(ab, cp), dot(ac, cp));
    if d6 >= 0.0 && d5 <= d6 {
        return length(cp);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return length(minus(ap, scaled(ac, d2 / (d2 - d6))));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return length(minus(bp, scaled(minus(c, b), share)));
    }
    let scale = 1.0 / (va + vb + vc);
    length(minus(ap, plus(scaled(ab, vb * scale), scaled(ac, vc * scale))))
}

/// Adds the integrals over a part of a triangle. `weight` is its area relative to the triangle.
fn add(
    rule: &[PointGroup],
    wavenumber: f64,
    at: Vector,
    panel: &Panel,
    part: [Barycentric; 3],
    weight: f64,
    sum: &mut PointMoments,
) {
    let splat = f64x4::splat;
    let corners = part.map(|point| position(panel, point).map(splat));
    let (at, normal) = (at.map(splat), panel.normal.map(splat));
    let mut sums = [[splat(0.0); 2]; 4];
    for (coordinates, weights) in rule {
        let r = [0, 1, 2].map(|axis| {
            let [a, b, c] = corners.map(|corner| corner[axis]);
            at[axis] - (a * coordinates[0] + b * coordinates[1] + c * coordinates[2])
        });
        let distance = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
        let inverse = splat(1.0) / distance;
        let phase = splat(wavenumber) * distance;
        let (sine, cosine) = phase.sin_cos();
        let scale = *weights * inverse;
        let (re, im) = (cosine * scale, -sine * scale);
        let along = -(r[0] * normal[0] + r[1] * normal[1] + r[2] * normal[2]) * inverse * inverse;
        let slope = [(phase * im - re) * along, -(phase * re + im) * along];
        sums[3][0] += re;
        sums[3][1] += im;
        for j in 0..3 {
            sums[j][0] += slope[0] * coordinates[j];
            sums[j][1] += slope[1] * coordinates[j];
        }
    }
    let scale = weight * panel.area / (4.0 * std::f64::consts::PI);
    let [a, b, c, single] = sums.map(|[re, im]| c64::new(re.reduce_add(), im.reduce_add()) * scale);
    sum.single += single;
    for (corner, value) in part.iter().zip([a, b, c]) {
        for j in 0..3 {
            sum.double[j] += value * corner[j];
        }
    }
}
