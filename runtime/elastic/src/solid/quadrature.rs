//! Quadrature rules over the reference cells of solid elements.

use crate::model::SolidShape;
use calyx_numerics::quadrature::gauss_legendre;

/// Point and weight.
pub type QuadraturePoint = ([f64; 3], f64);

/// Purpose of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrand {
    /// Products of gradients of the shape functions.
    Stiffness,
    /// Products of the shape functions.
    Mass,
}

/// Returns the rule of full integration: exact for elements with straight edges that are affine
/// (tetrahedra), for stiffness in the sense that a distorted element passes the patch test.
pub fn rule(shape: SolidShape, integrand: Integrand) -> Vec<QuadraturePoint> {
    let mass = integrand == Integrand::Mass;
    match shape {
        SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8 => hexahedron(if mass { 3 } else { 2 }),
        SolidShape::Hexahedron20 => hexahedron(if mass { 4 } else { 3 }),
        SolidShape::Wedge6 if mass => wedge(&triangle5(), 3),
        SolidShape::Wedge6 => wedge(&triangle2(), 2),
        SolidShape::Wedge15 => wedge(&triangle5(), if mass { 4 } else { 3 }),
        SolidShape::Tetrahedron4 if mass => tetrahedron2(),
        SolidShape::Tetrahedron4 => vec![([0.25; 3], 1.0 / 6.0)],
        SolidShape::Tetrahedron10 => tetrahedron5(),
    }
}

fn hexahedron(count: usize) -> Vec<QuadraturePoint> {
    let line = gauss_legendre(count);
    let mut points = Vec::with_capacity(count.pow(3));
    for &(z, along) in &line {
        for &(y, across) in &line {
            points.extend(line.iter().map(|&(x, weight)| ([x, y, z], weight * across * along)));
        }
    }
    points
}

fn wedge(triangle: &[([f64; 2], f64)], count: usize) -> Vec<QuadraturePoint> {
    let mut points = Vec::with_capacity(count * triangle.len());
    for (z, along) in gauss_legendre(count) {
        points.extend(triangle.iter().map(|&([x, y], weight)| ([x, y, z], weight * along)));
    }
    points
}

/// Returns the rule of degree 2 over the triangle, with inner points.
fn triangle2() -> Vec<([f64; 2], f64)> {
    let (near, far) = (1.0 / 6.0, 2.0 / 3.0);
    [[near, near], [far, near], [near, far]].map(|point| (point, 1.0 / 6.0)).to_vec()
}

/// Returns Radon's rule of degree 5 over the triangle.
fn triangle5() -> Vec<([f64; 2], f64)> {
    let root = 15.0_f64.sqrt();
    let mut points = vec![([1.0 / 3.0; 2], 9.0 / 80.0)];
    for sign in [-1.0, 1.0] {
        let near = (6.0 + sign * root) / 21.0;
        let far = 1.0 - 2.0 * near;
        let weight = (155.0 + sign * root) / 2400.0;
        points.extend([[near, near], [far, near], [near, far]].map(|point| (point, weight)));
    }
    points
}

/// Returns the rule of degree 2 over the tetrahedron.
fn tetrahedron2() -> Vec<QuadraturePoint> {
    let near = (5.0 - 5.0_f64.sqrt()) / 20.0;
    orbit(near, 1.0 / 24.0).to_vec()
}

/// Returns the four points with three barycentric coordinates `near`.
fn orbit(near: f64, weight: f64) -> [QuadraturePoint; 4] {
    let far = 1.0 - 3.0 * near;
    [[near, near, near], [far, near, near], [near, far, near], [near, near, far]].map(|point| (point, weight))
}

/// Returns the rule of 15 points and degree 5 over the tetrahedron (Stroud, T3:5-1).
fn tetrahedron5() -> Vec<QuadraturePoint> {
    let root = 15.0_f64.sqrt();
    let mut points = vec![([0.25; 3], 16.0 / 135.0 / 6.0)];
    for sign in [-1.0, 1.0] {
        let near = (7.0 + sign * root) / 34.0;
        let weight = (2665.0 - sign * 14.0 * root) / 37800.0 / 6.0;
        points.extend(orbit(near, weight));
    }
    let near = (10.0 - 2.0 * root) / 40.0;
    let far = 0.5 - near;
    let weight = 10.0 / 189.0 / 6.0;
    let pairs = [
        [near, near, far],
        [near, far, near],
        [far, near, near],
        [far, far, near],
        [far, near, far],
        [near, far, far],
    ];
    points.extend(pairs.map(|point| (point, weight)));
    points
}
