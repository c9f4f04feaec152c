//! Assumed strains: covariant strains interpolated from tying points, so that they do not lock
//! (mixed interpolation of tensorial components, MITC).
//!
//! | Shape | Transverse shear | Strains in the lamina |
//! |---|---|---|
//! | quadrilateral, 4 nodes | Dvorkin and Bathe 1984 | by displacements |
//! | triangle, 3 nodes and a bubble of the rotations | Lee, Lee and Bathe 2014 | by displacements |
//! | quadrilateral, 9 nodes, or 8 and a bubble | Bathe, Brezzi and Fortin 1989 | Bucalem and Bathe 1993 |
//! | triangle, 6 nodes and a bubble of the rotations | Bathe, Brezzi and Cho 1989 | along the sides, after Lee and Bathe 2004 |

use super::interpolation::{Weighted, square_rule, triangle_rule};
use super::kinematics::STRAINS;
use crate::model::ShellShape;
use calyx_numerics::interpolation::lagrange;
use nalgebra::{SMatrix, SVector};
use std::sync::OnceLock;

/// Strain at a tying point: index of the point, covariant strain, coefficient.
pub(super) type Tie = (usize, usize, f64);

/// Ties of the five covariant strains at a point; `None` if a strain is that of the displacements.
pub(super) type Ties = [Option<Vec<Tie>>; STRAINS];

/// Distance of the points of Lee, Lee and Bathe's linear shear terms from the centre.
const CENTRAL: f64 = 1e-4;

/// Returns the tying points.
pub(super) fn points(shape: ShellShape) -> Vec<[f64; 2]> {
    match shape {
        ShellShape::Quadrilateral4 => vec![[0.0, -1.0], [0.0, 1.0], [-1.0, 0.0], [1.0, 0.0]],
        ShellShape::Triangle3 => {
            let (third, sixth) = (1.0 / 3.0, 1.0 / 6.0);
            let (near, far) = (third + CENTRAL, third - 2.0 * CENTRAL);
            vec![
                [sixth, 4.0 * sixth],
                [4.0 * sixth, sixth],
                [sixth, sixth],
                [near, far],
                [far, near],
                [near, near],
            ]
        }
        ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9 => {
            let (two, three) = (two(), three());
            let mut points = Vec::new();
            points.extend(three.iter().flat_map(|&b| two.map(|a| [a, b])));
            points.extend(three.iter().flat_map(|&b| two.map(|a| [b, a])));
            points.extend(two.iter().flat_map(|&b| two.map(|a| [a, b])));
            points.extend([-1.0, 1.0].iter().flat_map(|&b| two.map(|a| [a, b])));
            points.extend([-1.0, 1.0].iter().flat_map(|&b| two.map(|a| [b, a])));
            points.extend(square_rule(3).into_iter().map(|(point, _)| point));
            points
        }
        ShellShape::Triangle6 => {
            let mut points = Vec::new();
            for [a, b, c] in SIDES {
                let at = |from: f64, to: f64, top: f64| {
                    let mut shares = [0.0; 3];
                    (shares[a], shares[b], shares[c]) = (from, to, top);
                    [shares[1], shares[2]]
                };
                let [p, q] = side_points();
                points.extend([p, q, 0.25, 0.75].map(|t| at(1.0 - t, t, 0.0)));
                points.push(at(0.25, 0.25, 0.5));
            }
            points.extend(shear_rule().into_iter().map(|(point, _)| point));
            points
        }
    }
}

/// Returns the ties of the strains at a point.
pub(super) fn ties(shape: ShellShape, [xi, eta]: [f64; 2]) -> Ties {
    match shape {
        ShellShape::Quadrilateral4 => {
            let line = |at: f64, first: usize, strain: usize| {
                Some(vec![(first, strain, 0.5 * (1.0 - at)), (first + 1, strain, 0.5 * (1.0 + at))])
            };
            [None, None, None, line(eta, 0, 3), line(xi, 2, 4)]
        }
        ShellShape::Triangle3 => {
            let (third, two) = (1.0 / 3.0, 2.0 / 3.0);
            // Rotation of the shear strain, from points near the centre.
            let rotation = |factor: f64| {
                let factor = factor * third;
                [(5, 3, factor), (3, 3, -factor), (5, 4, -factor), (4, 4, factor)]
            };
            let constant = [(2, 3, third), (2, 4, third)];
            let first = [&[(1, 3, two), (1, 4, -third)][..], &constant, &rotation(3.0 * eta - 1.0)].concat();
            let second = [&[(0, 4, two), (0, 3, -third)][..], &constant, &rotation(1.0 - 3.0 * xi)].concat();
            [None, None, None, Some(first), Some(second)]
        }
        ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9 => {
            // Fields of the first coordinate that are linear in it and quadratic in the second one.
            let product = |f: Vec<f64>, g: Vec<f64>, first: usize, strain: usize| {
                let values = g.iter().flat_map(|&g| f.iter().map(move |&f| f * g)).collect::<Vec<_>>();
                Some(values.iter().enumerate().map(|(k, &value)| (first + k, strain, value)).collect())
            };
            let along_xi = |strain| product(lagrange(&two(), xi), lagrange(&three(), eta), 0, strain);
            let along_eta = |strain| product(lagrange(&two(), eta), lagrange(&three(), xi), 6, strain);
            let both = product(lagrange(&two(), xi), lagrange(&two(), eta), 12, 2);
            [along_xi(0), along_eta(1), both, Some(square_shear(3, xi, eta)), Some(square_shear(4, eta, xi))]
        }
        ShellShape::Triangle6 => triangle_ties(xi, eta),
    }
}

/// Number of tying points of quadratic quadrilaterals in the lamina.
const IN_LAMINA: usize = 16;

/// Returns the ties of a transverse shear strain of quadratic quadrilaterals, with the fields 1,
/// along, across, along across, across^2: from two points on each side and the mean over the
/// square.
fn square_shear(strain: usize, along: f64, across: f64) -> Vec<Tie> {
    let first = IN_LAMINA + if strain == 3 { 0 } else { 4 };
    let lines = lagrange(&two(), along);
    let sides = [0.5 * (1.0 - across), 0.5 * (1.0 + across)];
    // Factor of the difference between the averages over the sides and over the square.
    let curved = 1.5 * (across * across - 1.0);
    let mut ties = Vec::new();
    for (side, share) in sides.into_iter().enumerate() {
        for (k, value) in lines.iter().enumerate() {
            ties.push((first + 2 * side + k, strain, share * value + 0.25 * curved));
        }
    }
    for (k, (_, weight)) in square_rule(3).into_iter().enumerate() {
        ties.push((IN_LAMINA + 8 + k, strain, -0.25 * curved * weight));
    }
    ties
}

fn two() -> [f64; 2] {
    let a = 3.0_f64.sqrt().recip();
    [-a, a]
}

fn three() -> [f64; 3] {
    let b = 0.6_f64.sqrt();
    [-b, 0.0, b]
}

/// Corners of the sides of a triangle along xi and eta and of the third side: first, second,
/// opposite.
const SIDES: [[usize; 3]; 3] = [[0, 1, 2], [0, 2, 1], [1, 2, 0]];

/// Number of tying points in the lamina for each side of a triangle.
const SIDE_POINTS: usize = 5;

/// Returns the Gauss points of 0 ..= 1.
fn side_points() -> [f64; 2] {
    let r = 3.0_f64.sqrt().recip();
    [0.5 - 0.5 * r, 0.5 + 0.5 * r]
}

/// Returns the ties of the quadratic triangle. The linear field of the strain along a side vanishes
/// for all inextensional bending of a shallow quadratic surface (`docs/theory/shells.md`).
fn triangle_ties(xi: f64, eta: f64) -> Ties {
    let [p, q] = side_points();
    let shares = [1.0 - xi - eta, xi, eta];
    let along = |side: usize| {
        let [_, b, c] = SIDES[side];
        let second = (shares[b] + 0.5 * shares[c] - p) / (q - p);
        let slope = 2.0 * shares[c];
        [1.0 - second, second, -0.5 * slope, -0.5 * slope, slope]
    };
    let normal = |side: usize| {
        let tie = |(k, weight): (usize, f64)| (SIDE_POINTS * side + k, side, weight);
        along(side).into_iter().enumerate().map(tie).collect::<Vec<_>>()
    };
    let (first, second) = (normal(0), normal(1));
    // Strain along the third side: e11 + e22 - 2 e12.
    let mut shear = [first.clone(), second.clone()].concat();
    for (k, weight) in along(2).into_iter().enumerate() {
        let point = 2 * SIDE_POINTS + k;
        shear.extend([(point, 0, -weight), (point, 1, -weight), (point, 2, weight)]);
    }
    let coefficients = shear_coefficients();
    let fields = shear_fields([xi, eta]);
    let transverse = |component: usize| {
        let mut ties = Vec::new();
        for k in 0..shear_rule().len() {
            for (strain, functionals) in functionals(k).into_iter().enumerate() {
                let value = (fields.row(component) * coefficients * functionals)[0];
                ties.push((3 * SIDE_POINTS + k, 3 + strain, value));
            }
        }
        Some(ties)
    };
    [Some(first), Some(second), Some(shear), transverse(0), transverse(1)]
}

/// Returns the eight shear fields of the quadratic triangle: complete linear ones and two whose
/// tangential components along the sides are linear.
fn shear_fields([xi, eta]: [f64; 2]) -> SMatrix<f64, 2, 8> {
    let mut fields = SMatrix::zeros();
    for (k, value) in [1.0, xi, eta].into_iter().enumerate() {
        fields[(0, k)] = value;
        fields[(1, 3 + k)] = value;
    }
    for (k, value) in [xi, eta].into_iter().enumerate() {
        fields[(0, 6 + k)] = eta * value;
        fields[(1, 6 + k)] = -xi * value;
    }
    fields
}

/// Returns the points of the shear strain: two on each side, then those of an integral.
fn shear_rule() -> Vec<Weighted> {
    let [p, q] = side_points();
    let sides = [[p, 0.0], [q, 0.0], [q, p], [p, q], [0.0, q], [0.0, p]];
    let mut rule = sides.map(|point| (point, 0.0)).to_vec();
    rule.extend(triangle_rule(4));
    rule
}

/// Returns the contribution of each strain component at a point of the rule to the eight
/// functionals: tangential components on the sides, and integrals of both components.
fn functionals(index: usize) -> [SVector<f64, 8>; 2] {
    let mut parts = [SVector::zeros(), SVector::zeros()];
    if index < 6 {
        let tangent = [[1.0, 0.0], [-1.0, 1.0], [0.0, -1.0]][index / 2];
        for (part, component) in parts.iter_mut().zip(tangent) {
            part[index] = component;
        }
    } else {
        let weight = triangle_rule(4)[index - 6].1;
        parts[0][6] = weight;
        parts[1][7] = weight;
    }
    parts
}

/// Returns the coefficients of the shear fields for each functional.
fn shear_coefficients() -> &'static SMatrix<f64, 8, 8> {
    static COEFFICIENTS: OnceLock<SMatrix<f64, 8, 8>> = OnceLock::new();
    COEFFICIENTS.get_or_init(|| {
        let mut values = SMatrix::<f64, 8, 8>::zeros();
        for (index, (point, _)) in shear_rule().into_iter().enumerate() {
            let fields = shear_fields(point);
            let [first, second] = functionals(index);
            values += first * fields.row(0) + second * fields.row(1);
        }
        // The functionals determine the fields.
        values.try_inverse().unwrap_or_else(SMatrix::zeros)
    })
}
