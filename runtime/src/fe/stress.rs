//! Smoothed stresses: a polynomial fitted through the stresses at superconvergent points of a patch of elements
//! (Zienkiewicz and Zhu 1992). Linear in the displacements, hence given as rows.

use super::mesh::{EdgeChain, Place};
use super::model::PlaneModel;
use super::quadrature::gauss_legendre;
use super::sparse::SparseVector;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeSet;

/// A fit whose triangular factor has a diagonal smaller than this, relative to its largest, lacks points.
const RANK: f64 = 1e-10;

/// Samples count by exp(-NEARNESS r²), r their distance from the middle of the element relative to the farthest. The
/// element's own points dominate, the others settle the terms these leave open. On the bore of a thick cylinder this
/// divides the error of an unweighted fit, which polynomials in x and y over a curved patch make large, by 2 (order 1)
/// to 20 (order 3).
const NEARNESS: f64 = 12.0;

/// Recovers stresses of a model. The patch of a place is its element and all that touch it.
pub struct StressRecovery<'a> {
    model: &'a PlaneModel,
    /// Elements by displacement node, ascending.
    elements_of: Vec<Vec<usize>>,
}

impl<'a> StressRecovery<'a> {
    /// Prepares the recovery of a model's stresses.
    pub fn new(model: &'a PlaneModel) -> Self {
        let mut elements_of = vec![Vec::new(); model.mesh.nodes.len()];
        for (index, element) in model.mesh.elements.iter().enumerate() {
            for &node in &element.nodes {
                elements_of[node].push(index);
            }
        }
        Self { model, elements_of }
    }

    /// Rows giving the smoothed stresses xx, yy, xy (Pa) at a place.
    pub fn rows(&self, place: Place) -> [SparseVector; 3] {
        let mesh = &self.model.mesh;
        let samples = self.samples(place.element);
        let center = mesh.position(Place { xi: 0.0, eta: 0.0, ..place });
        let points = samples.iter().map(|&sample| mesh.position(sample)).collect::<Vec<_>>();
        let size = points
            .iter()
            .map(|point| (point[0] - center[0]).hypot(point[1] - center[1]))
            .fold(f64::MIN_POSITIVE, f64::max);
        let local = |point: [f64; 2]| [0, 1].map(|axis| (point[axis] - center[axis]) / size);
        let points = points.into_iter().map(local).collect::<Vec<_>>();
        let target = local(mesh.position(place));

        let degree = usize::from(mesh.elements[place.element].order.lowest_side());
        let weights = (0..=degree).rev().find_map(|degree| fit_weights(&points, target, degree));
        let rows = samples.iter().map(|&sample| self.model.stress_rows(sample)).collect::<Vec<_>>();
        // A constant can always be fitted; were there no samples, there would be no element.
        let weights = weights.unwrap_or_default();
        [0, 1, 2].map(|part| {
            SparseVector::combination(weights.iter().zip(&rows).map(|(&weight, row)| (weight, &row[part])))
        })
    }

    /// Smoothed stresses xx, yy, xy (Pa) at a place, from a full displacement vector.
    pub fn stress(&self, place: Place, displacements: &[f64]) -> [f64; 3] {
        self.rows(place).map(|row| row.dot(displacements))
    }

    /// Row giving the stress along the surface (Pa) at arc length `s` of a chain. Where the surface is free it is the
    /// principal stress that is not zero. `None` outside the chain.
    pub fn surface_row(&self, chain: &EdgeChain, s: f64) -> Option<SparseVector> {
        let point = self.model.mesh.chain_point(chain, s)?;
        let [x, y] = point.tangent;
        let [xx, yy, xy] = self.rows(point.place);
        Some(SparseVector::combination([(x * x, &xx), (y * y, &yy), (2.0 * x * y, &xy)]))
    }

    /// Superconvergent points of an element's patch: p by p Gauss points of each element of order p.
    fn samples(&self, element: usize) -> Vec<Place> {
        let mesh = &self.model.mesh;
        let nodes = &mesh.elements[element].nodes;
        let patch = nodes.iter().flat_map(|&node| &self.elements_of[node]).copied().collect::<BTreeSet<_>>();
        let mut samples = Vec::new();
        for element in patch {
            let rule = gauss_legendre(usize::from(mesh.elements[element].order.lowest_side()));
            for (eta, _) in &rule {
                samples.extend(rule.iter().map(|&(xi, _)| Place { element, xi, eta: *eta }));
            }
        }
        samples
    }
}

/// Weights of the samples in the value at `target` of the polynomial of the given total degree that fits them best;
/// the points relative to the middle of the element, the farthest at distance 1. `None` if the points do not determine it.
fn fit_weights(points: &[[f64; 2]], target: [f64; 2], degree: usize) -> Option<Vec<f64>> {
    let terms = |[x, y]: [f64; 2]| {
        let powers = (0..=degree).flat_map(|total| (0..=total).map(move |of_y| (total - of_y, of_y)));
        powers.map(|(of_x, of_y)| x.powi(of_x as i32) * y.powi(of_y as i32)).collect::<Vec<_>>()
    };
    let wanted = DVector::from_vec(terms(target));
    if points.len() < wanted.len() {
        return None;
    }
    let counts = points.iter().map(|[x, y]| (-NEARNESS * (x * x + y * y)).exp()).collect::<Vec<_>>();
    let rows = points
        .iter()
        .zip(&counts)
        .flat_map(|(&point, count)| terms(point).into_iter().map(move |term| term * count))
        .collect::<Vec<_>>();
    let factors = DMatrix::from_row_slice(points.len(), wanted.len(), &rows).qr();
    let triangle = factors.r();
    let diagonal = triangle.diagonal().abs();
    if diagonal.min() <= RANK * diagonal.max() {
        return None;
    }
    // With C A = Q R, C the counts, the value is wanted' R^-1 Q' C samples.
    let in_q = triangle.transpose().solve_lower_triangular(&wanted)?;
    Some((factors.q() * in_q).iter().zip(&counts).map(|(weight, count)| weight * count).collect())
}
