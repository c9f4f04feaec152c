//! Smoothed stresses: a polynomial fitted through the stresses at superconvergent points of a patch
//! of elements (superconvergent patch recovery, Zienkiewicz and Zhu 1992). The result is linear in
//! the displacements, hence given as rows.

use super::mesh::{EdgeChain, ElementPoint, PlaneMesh};
use super::model::PlaneModel;
use super::sparse::SparseVector;
use calyx_numerics::quadrature::gauss_legendre;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeSet;

/// A fit whose triangular factor has a smaller diagonal than this, relative to its largest, has too
/// few points.
const RANK: f64 = 1e-10;

/// Samples have the weight exp(-NEARNESS r²), with r their distance from the middle of the element
/// relative to the farthest. The element's own points dominate, the others determine the remaining
/// terms. On the bore of a thick cylinder this divides the error of an unweighted fit, which
/// polynomials in x and y over a curved patch make large, by 2 (order 1) to 20 (order 3).
const NEARNESS: f64 = 12.0;

/// Stress recovery of a model. The patch of a point is its element and all adjacent ones.
pub struct StressRecovery<'a> {
    model: &'a PlaneModel,
    /// Elements by displacement node, ascending.
    elements_of: Vec<Vec<usize>>,
}

impl<'a> StressRecovery<'a> {
    /// Prepares the recovery of a model's stresses.
    pub fn new(model: &'a PlaneModel) -> Self {
        Self { model, elements_of: elements_of(&model.mesh) }
    }

    /// Returns the rows for the smoothed stresses xx, yy, xy (Pa) at a point.
    pub fn rows(&self, place: ElementPoint) -> [SparseVector; 3] {
        let samples = sample_weights(&self.model.mesh, &self.elements_of, place);
        let rows = samples.iter().map(|&(sample, _)| self.model.stress_rows(sample)).collect::<Vec<_>>();
        [0, 1, 2].map(|part| {
            SparseVector::combination(
                samples.iter().zip(&rows).map(|((_, weight), row)| (*weight, &row[part])),
            )
        })
    }

    /// Returns the smoothed stresses xx, yy, xy (Pa) at a point, from a full displacement vector.
    pub fn stress(&self, place: ElementPoint, displacements: &[f64]) -> [f64; 3] {
        self.rows(place).map(|row| row.dot(displacements))
    }

    /// Returns the row for the stress along the surface (Pa) at arc length `s` of a chain. On a
    /// free surface it is the principal stress that is not zero. `None` outside the chain.
    pub fn surface_row(&self, chain: &EdgeChain, s: f64) -> Option<SparseVector> {
        let point = self.model.mesh.chain_point(chain, s)?;
        let [x, y] = point.tangent;
        let [xx, yy, xy] = self.rows(point.place);
        Some(SparseVector::combination([(x * x, &xx), (y * y, &yy), (2.0 * x * y, &xy)]))
    }
}

/// Returns the elements by displacement node, ascending.
pub(super) fn elements_of(mesh: &PlaneMesh) -> Vec<Vec<usize>> {
    let mut elements_of = vec![Vec::new(); mesh.nodes.len()];
    for (index, element) in mesh.elements.iter().enumerate() {
        for &node in &element.nodes {
            elements_of[node].push(index);
        }
    }
    elements_of
}

/// Returns the superconvergent points of the patch of a point, and their weights in the smoothed
/// value there.
pub(super) fn sample_weights(
    mesh: &PlaneMesh,
    elements_of: &[Vec<usize>],
    place: ElementPoint,
) -> Vec<(ElementPoint, f64)> {
    let samples = samples(mesh, elements_of, place.element);
    let center = mesh.position(ElementPoint { xi: 0.0, eta: 0.0, ..place });
    let points = samples.iter().map(|&sample| mesh.position(sample)).collect::<Vec<_>>();
    let size = points
        .iter()
        .map(|point| (point[0] - center[0]).hypot(point[1] - center[1]))
        .fold(f64::MIN_POSITIVE, f64::max);
    let local = |point: [f64; 2]| [0, 1].map(|axis| (point[axis] - center[axis]) / size);
    let points = points.into_iter().map(local).collect::<Vec<_>>();
    let target = local(mesh.position(place));

    let degree = usize::from(mesh.elements[place.element].order.lowest_side());
    let weights = (0..=degree).rev().find_map(|degree| plane_weights(&points, target, degree));
    // A constant can always be fitted; without samples there would be no element.
    samples.into_iter().zip(weights.unwrap_or_default()).collect()
}

/// Returns the superconvergent points of an element's patch: p by p Gauss points of each element of
/// order p, `xi` running fastest.
fn samples(mesh: &PlaneMesh, elements_of: &[Vec<usize>], element: usize) -> Vec<ElementPoint> {
    let nodes = &mesh.elements[element].nodes;
    let patch = nodes.iter().flat_map(|&node| &elements_of[node]).copied().collect::<BTreeSet<_>>();
    let mut samples = Vec::new();
    for element in patch {
        let rule = gauss_legendre(usize::from(mesh.elements[element].order.lowest_side()));
        for (eta, _) in &rule {
            samples.extend(rule.iter().map(|&(xi, _)| ElementPoint { element, xi, eta: *eta }));
        }
    }
    samples
}

/// Returns the weights of the samples in the value at `target` of the best-fit polynomial of the
/// given total degree. Points are relative to the middle of the element, with the farthest at
/// distance 1. `None` if the points do not determine the polynomial.
fn plane_weights(points: &[[f64; 2]], target: [f64; 2], degree: usize) -> Option<Vec<f64>> {
    let terms = |[x, y]: [f64; 2]| {
        let powers = (0..=degree).flat_map(|total| (0..=total).map(move |of_y| (total - of_y, of_y)));
        powers.map(|(of_x, of_y)| x.powi(of_x as i32) * y.powi(of_y as i32)).collect::<Vec<_>>()
    };
    let samples = points.iter().map(|&[x, y]| (terms([x, y]), nearness(x * x + y * y))).collect::<Vec<_>>();
    fit_weights(&samples, terms(target))
}

/// Returns the weight of a sample at a squared distance, relative to that of the farthest.
pub(super) fn nearness(square: f64) -> f64 {
    (-NEARNESS * square).exp()
}

/// Returns the weights of samples in the value of a least-squares combination of terms; `wanted`
/// are the terms at the target. Each sample is given by its terms and its weight. `None` if the
/// samples do not determine the combination.
pub(super) fn fit_weights(samples: &[(Vec<f64>, f64)], wanted: Vec<f64>) -> Option<Vec<f64>> {
    let (orthogonal, triangle) = decomposed(samples)?;
    // With C A = Q R, C the weights, the value is wanted' R^-1 Q' C samples.
    let in_q = triangle.transpose().solve_lower_triangular(&DVector::from_vec(wanted))?;
    Some((orthogonal * in_q).iter().zip(samples).map(|(weight, (_, count))| weight * count).collect())
}

/// Returns the coefficients of the least-squares combinations of terms, one column for each
/// quantity; samples as for [`fit_weights`].
pub(super) fn fit(samples: &[(Vec<f64>, f64)], values: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let (orthogonal, triangle) = decomposed(samples)?;
    let counted = DMatrix::from_fn(values.nrows(), values.ncols(), |row, column| {
        samples[row].1 * values[(row, column)]
    });
    triangle.solve_upper_triangular(&(orthogonal.transpose() * counted))
}

/// Returns the QR factors of the samples' terms, each row times its weight.
fn decomposed(samples: &[(Vec<f64>, f64)]) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
    let terms = samples.first()?.0.len();
    if samples.len() < terms {
        return None;
    }
    let rows = samples
        .iter()
        .flat_map(|(terms, count)| terms.iter().map(move |term| term * count))
        .collect::<Vec<_>>();
    let factors = DMatrix::from_row_slice(samples.len(), terms, &rows).qr();
    let triangle = factors.r();
    let diagonal = triangle.diagonal().abs();
    (diagonal.min() > RANK * diagonal.max()).then(|| (factors.q(), triangle))
}
