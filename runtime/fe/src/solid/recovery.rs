//! Smoothed stresses of a solution and its error estimate after Zienkiewicz and Zhu (1992): the
//! difference between smoothed and element stresses. The smoothed stresses are polynomials fitted
//! through the stresses at superconvergent points.
//!
//! A polynomial is fitted around every corner of the mesh, to the points of the elements that meet
//! there and, on the boundary, of adjacent elements, with weights that decrease with the distance.
//! Its degree is the element order for linear displacements, and one more for higher orders. With
//! the element order itself, the polynomial over a patch of two elements across would be less
//! accurate than the solution in one element. A node takes the mean of the fits around the corners
//! that all of its elements share; nodes of linear elements on the boundary use interior corners.
//! If a patch is too wide for its polynomial (six cubic elements or fewer to a quarter of a
//! circle), the estimate is too large, considerably so on the coarsest meshes. The smoothed stress
//! is interpolated between the nodes like displacements.

use super::interpolation::{Cell, Interpolation};
use super::mesh::{SolidElement, SolidElementPoint, SolidMesh};
use super::model::{Inverse, SolidModel};
use crate::stress::{fit, nearness};
use calyx_numerics::quadrature::gauss_legendre;
use nalgebra::{DMatrix, Matrix3, Vector3};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Smoothed stresses of a solution.
#[derive(Debug)]
pub struct RecoveredStress<'a> {
    model: &'a SolidModel,
    displacements: &'a [f64],
    /// Stresses at each displacement node: xx, yy, zz, yz, zx, xy, Pa.
    pub nodal: Vec<[f64; 6]>,
}

/// Estimated errors of a solution, in energy.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorEstimate {
    /// Energy of the difference between smoothed and element stress, for each element, J.
    pub elements: Vec<f64>,
    /// Energy of the solution, J.
    pub energy: f64,
}

impl ErrorEstimate {
    /// Returns the estimated norm of the error relative to that of the exact solution: 0.01 means
    /// that the error of the stresses is one percent, in a mean over the body.
    pub fn relative(&self) -> f64 {
        let error = self.elements.iter().sum::<f64>();
        if error == 0.0 { 0.0 } else { (error / (self.energy + error)).sqrt() }
    }
}

impl Cell {
    /// Returns the points at which stresses of displacements of the orders (across, along `zeta`)
    /// are most accurate. In hexahedra these are Gauss points (Barlow 1976). Triangles and
    /// tetrahedra have no comparably accurate points; the method uses as many points as a
    /// polynomial one order lower has coefficients, close to those of the quadratures of that size.
    pub fn superconvergent(self, [across, along]: [u8; 2]) -> Vec<[f64; 3]> {
        let points =
            |order: u8| gauss_legendre(usize::from(order)).into_iter().map(|(x, _)| x).collect::<Vec<_>>();
        // Nodes of the order below, contracted towards the middle.
        let drawn = |kind: Interpolation, factors: [f64; 3]| {
            let middle = self.middle();
            let factor = factors[usize::from(across.clamp(1, 3)) - 1];
            let place = move |place: [f64; 3]| {
                [0, 1, 2].map(|axis| middle[axis] + factor * (place[axis] - middle[axis]))
            };
            let places = if across == 1 { vec![middle] } else { kind.node_coordinates() };
            places.into_iter().map(place).collect::<Vec<_>>()
        };
        match self {
            Self::Hexahedron => {
                let section = points(across);
                let mut places = Vec::new();
                for &zeta in &points(along) {
                    for &eta in &section {
                        places.extend(section.iter().map(|&xi| [xi, eta, zeta]));
                    }
                }
                places
            }
            Self::Pentahedron => {
                let layer = drawn(Interpolation::Tetrahedron(across.max(2) - 1), [0.0, 0.5, 0.7]);
                // The lowest layer of the tetrahedron's nodes is the triangle's.
                let count = usize::from(across) * usize::from(across + 1) / 2;
                let layer = &layer[..count];
                points(along)
                    .iter()
                    .flat_map(|&zeta| layer.iter().map(move |&[xi, eta, _]| [xi, eta, zeta]))
                    .collect()
            }
            Self::Tetrahedron => {
                drawn(Interpolation::Tetrahedron(across.max(2) - 1), [0.0, 0.2_f64.sqrt(), 0.65])
            }
        }
    }
}

impl SolidModel {
    /// Smooths the stresses of a solution, a full vector of displacements.
    pub fn recover_stress<'a>(&'a self, displacements: &'a [f64]) -> RecoveredStress<'a> {
        let patches = RecoveryPatches::new(&self.mesh);
        let indices = (0..self.mesh.elements.len()).collect::<Vec<_>>();
        let samples = indices.par_iter().map(|&index| self.samples(index, displacements)).collect::<Vec<_>>();
        let around = (0..self.mesh.nodes.len()).map(|node| patches.corners_for(node)).collect::<Vec<_>>();
        let mut corners = around.iter().flatten().copied().collect::<Vec<_>>();
        corners.sort_unstable();
        corners.dedup();
        let fits = corners
            .par_iter()
            .map(|&corner| {
                let patch = patches.elements_around(corner);
                let samples = patch.iter().flat_map(|&element| &samples[element]).collect();
                Fit::new(self, corner, patch[0], patches.on_boundary[corner], samples)
            })
            .collect::<Vec<_>>();
        let value = |(corners_of, position): (&Vec<usize>, &[f64; 3])| {
            let mut mean = [0.0; 6];
            for corner in corners_of {
                // Each corner has a fit.
                if let Ok(at) = corners.binary_search(corner) {
                    let value = fits[at].at(*position);
                    for part in 0..6 {
                        mean[part] += value[part] / corners_of.len() as f64;
                    }
                }
            }
            mean
        };
        let nodal = around.iter().zip(&self.mesh.nodes).map(value).collect();
        RecoveredStress { model: self, displacements, nodal }
    }

    /// Returns positions and stresses at an element's superconvergent points.
    fn samples(&self, index: usize, displacements: &[f64]) -> Vec<([f64; 3], [f64; 6])> {
        let kind = &self.mesh.elements[index].interpolation;
        let places = kind.cell().superconvergent(kind.lowest());
        let sample = |local| {
            let place = SolidElementPoint { element: index, local };
            (self.mesh.position(place), self.stress(place, displacements))
        };
        places.into_iter().map(sample).collect()
    }
}

/// Elements and corners around nodes.
struct RecoveryPatches {
    elements_of: Vec<Vec<usize>>,
    /// Corners of each element, as nodes.
    corners: Vec<Vec<usize>>,
    on_boundary: Vec<bool>,
    /// True if boundary nodes take their values from interior corners.
    from_inside: bool,
}

impl RecoveryPatches {
    fn new(mesh: &SolidMesh) -> Self {
        let mut elements_of = vec![Vec::new(); mesh.nodes.len()];
        for (index, element) in mesh.elements.iter().enumerate() {
            for &node in &element.nodes {
                elements_of[node].push(index);
            }
        }
        let mut on_boundary = vec![false; mesh.nodes.len()];
        for face in mesh.boundary() {
            let element = &mesh.elements[face.element];
            for local in element.interpolation.face_nodes(face.face) {
                on_boundary[element.nodes[local]] = true;
            }
        }
        let corners = |element: &SolidElement| {
            element.interpolation.corners().into_iter().map(|local| element.nodes[local]).collect()
        };
        let linear = |element: &SolidElement| element.interpolation.lowest().contains(&1);
        Self {
            elements_of,
            corners: mesh.elements.iter().map(corners).collect(),
            on_boundary,
            from_inside: mesh.elements.iter().any(linear),
        }
    }

    /// Returns the corners whose fits determine the value at a node.
    fn corners_for(&self, node: usize) -> Vec<usize> {
        let Some((first, others)) = self.elements_of[node].split_first() else { return Vec::new() };
        let common = self.corners[*first].iter().copied();
        let common = common
            .filter(|corner| others.iter().all(|&element| self.corners[element].contains(corner)))
            .collect::<Vec<_>>();
        if !self.from_inside {
            return common;
        }
        let inner = |corners: &mut dyn Iterator<Item = usize>| {
            corners.filter(|&corner| !self.on_boundary[corner]).collect::<BTreeSet<_>>()
        };
        let mut found = inner(&mut common.iter().copied());
        if found.is_empty() {
            found = inner(
                &mut self.elements_of[node].iter().flat_map(|&element| &self.corners[element]).copied(),
            );
        }
        // In meshes one element thick all corners are on the boundary.
        if found.is_empty() { common } else { found.into_iter().collect() }
    }

    /// Returns the elements that meet at a corner; for a boundary corner, also those adjacent to
    /// them.
    fn elements_around(&self, corner: usize) -> Vec<usize> {
        let own = &self.elements_of[corner];
        if !self.on_boundary[corner] {
            return own.clone();
        }
        let corners = own.iter().flat_map(|&element| &self.corners[element]);
        corners
            .flat_map(|&corner| &self.elements_of[corner])
            .copied()
            .collect::<BTreeSet<_>>()
            .into_iter()
            .collect()
    }
}

/// Polynomials through the samples around a corner.
struct Fit {
    center: [f64; 3],
    /// Map from positions relative to the centre to coordinates along the axes of an element, of
    /// size 1 over the patch.
    local: Matrix3<f64>,
    powers: Vec<[i32; 3]>,
    /// Coefficients, one row for each monomial, one column for each component.
    coefficients: DMatrix<f64>,
}

impl Fit {
    fn new(
        model: &SolidModel,
        corner: usize,
        element: usize,
        weighted: bool,
        samples: Vec<&([f64; 3], [f64; 6])>,
    ) -> Self {
        let mesh = &model.mesh;
        let center = mesh.nodes[corner];
        let kind = &mesh.elements[element].interpolation;
        // Along the element's own axes, so that its orders are those of the polynomial.
        let jacobian = mesh.jacobian(SolidElementPoint { element, local: kind.cell().middle() });
        let inverse = Matrix3::from_fn(|axis, local| jacobian[axis][local]).try_inverse();
        let inverse = inverse.unwrap_or_else(Matrix3::identity);
        let off = |at: [f64; 3]| inverse * Vector3::from_fn(|axis, _| at[axis] - center[axis]);
        let size = samples.iter().map(|sample| off(sample.0).amax()).fold(f64::MIN_POSITIVE, f64::max);
        let mut fitted =
            Self { center, local: inverse / size, powers: Vec::new(), coefficients: DMatrix::zeros(0, 6) };
        let right = DMatrix::from_fn(samples.len(), 6, |row, part| samples[row].1[part]);
        let farthest = samples.iter().map(|sample| off(sample.0).norm()).fold(f64::MIN_POSITIVE, f64::max);
        let count = |at: [f64; 3]| if weighted { nearness((off(at) / farthest).norm_squared()) } else { 1.0 };
        let [p, q] = kind.lowest().map(|order| i32::from(order) + i32::from(order > 1));
        for less in 0..=p.max(q) {
            fitted.powers = powers((p - less).max(0), (q - less).max(0));
            // A fit has at most half as many unknowns as samples; a constant is always possible.
            if fitted.powers.len() > 1 && 2 * fitted.powers.len() > samples.len() {
                continue;
            }
            let rows =
                samples.iter().map(|sample| (fitted.terms(sample.0), count(sample.0))).collect::<Vec<_>>();
            if let Some(coefficients) = fit(&rows, &right) {
                fitted.coefficients = coefficients;
                break;
            }
        }
        fitted
    }

    fn terms(&self, at: [f64; 3]) -> Vec<f64> {
        let place = self.local * Vector3::from_fn(|axis, _| at[axis] - self.center[axis]);
        self.powers.iter().map(|&[i, j, k]| place[0].powi(i) * place[1].powi(j) * place[2].powi(k)).collect()
    }

    fn at(&self, position: [f64; 3]) -> [f64; 6] {
        let terms = self.terms(position);
        std::array::from_fn(|part| {
            self.coefficients.column(part).iter().zip(&terms).map(|(a, b)| a * b).sum()
        })
    }
}

/// Returns the exponents of the monomials with `(i + j) / p + k / q <= 1`: the complete polynomial
/// if both degrees are equal.
fn powers(p: i32, q: i32) -> Vec<[i32; 3]> {
    let mut powers = Vec::new();
    for k in 0..=q {
        // Without an order along the axis, all monomials are in the layer k = 0.
        let across = if q == 0 { p } else { p * (q - k) / q };
        for j in 0..=across {
            powers.extend((0..=across - j).map(|i| [i, j, k]));
        }
    }
    powers
}

impl RecoveredStress<'_> {
    /// Returns the smoothed stress at a point, Pa.
    pub fn at(&self, place: SolidElementPoint) -> [f64; 6] {
        let element = &self.model.mesh.elements[place.element];
        let shapes =
            element.interpolation.shapes(place.local).into_iter().map(|shape| shape[0]).collect::<Vec<_>>();
        self.interpolated(element, &shapes)
    }

    fn interpolated(&self, element: &SolidElement, shapes: &[f64]) -> [f64; 6] {
        std::array::from_fn(|part| {
            shapes.iter().zip(&element.nodes).map(|(shape, &node)| shape * self.nodal[node][part]).sum()
        })
    }

    /// Returns the estimated error of the solution.
    pub fn error_estimate(&self) -> ErrorEstimate {
        let model = self.model;
        let indices = (0..model.mesh.elements.len()).collect::<Vec<_>>();
        let of_element = |&index: &usize| {
            let element = &model.mesh.elements[index];
            let (displacement, coordinate) = element.kinds();
            let points = displacement.highest().map(|order| usize::from(order) + 1);
            let (mut error, mut energy) = (0.0, 0.0);
            for (local, weight) in displacement.cell().quadrature(points) {
                let place = SolidElementPoint { element: index, local };
                let volume =
                    Inverse::new(model.mesh.jacobian_of(element, &coordinate.shapes(local))).determinant;
                let own = model.stress(place, self.displacements);
                let smoothed = self.at(place);
                let off = std::array::from_fn(|part| smoothed[part] - own[part]);
                error += weight * volume * model.energy_density(off);
                energy += weight * volume * model.energy_density(own);
            }
            (error, energy)
        };
        let parts = indices.par_iter().map(of_element).collect::<Vec<_>>();
        ErrorEstimate {
            energy: parts.iter().map(|part| part.1).sum(),
            elements: parts.into_iter().map(|part| part.0).collect(),
        }
    }
}

impl SolidModel {
    /// Returns the elastic energy per volume of a stress (xx, yy, zz, yz, zx, xy), J/m³.
    pub fn energy_density(&self, [xx, yy, zz, yz, zx, xy]: [f64; 6]) -> f64 {
        let (e, nu) = (self.material.youngs_modulus, self.material.poissons_ratio);
        let direct = xx * xx + yy * yy + zz * zz - 2.0 * nu * (xx * yy + yy * zz + zz * xx);
        (0.5 * direct + (1.0 + nu) * (yz * yz + zx * zx + xy * xy)) / e
    }
}
