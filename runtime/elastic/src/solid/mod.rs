//! Solid elements: isoparametric hexahedra, wedges and tetrahedra with full integration, and the
//! hexahedron with incompatible modes.
//!
//! See `docs/theory/elastic-bodies.md`.

pub mod quadrature;
pub mod shape_functions;
mod stress;

pub use stress::nodal_stresses;

use crate::error::ElementError;
use crate::model::{Material, SolidShape};
use nalgebra::{DMatrix, Matrix3, Vector3};
use quadrature::{Integrand, rule};

/// Solid element with the positions of its nodes.
#[derive(Clone, Copy, Debug)]
pub struct SolidElement<'a> {
    /// Shape.
    pub shape: SolidShape,
    /// Positions of the nodes, m.
    pub positions: &'a [[f64; 3]],
    /// Material.
    pub material: &'a Material,
}

/// Values at a quadrature point.
struct AtPoint {
    values: Vec<f64>,
    /// Gradients by the position: of the shape functions, then of the incompatible modes.
    gradients: Vec<Vector3<f64>>,
    /// Volume of the point: weight times Jacobian determinant.
    volume: f64,
}

impl SolidElement<'_> {
    fn at_points(&self, integrand: Integrand) -> Result<Vec<AtPoint>, ElementError> {
        if self.positions.len() != self.shape.node_count() {
            return Err(ElementError::new(
                format!("{} nodes are given instead of {}", self.positions.len(), self.shape.node_count()),
                "state all nodes of the element",
            ));
        }
        rule(self.shape, integrand).iter().map(|(point, weight)| self.at(*point, *weight)).collect()
    }

    /// Returns the values at a point, with its weight.
    fn at(&self, point: [f64; 3], weight: f64) -> Result<AtPoint, ElementError> {
        let functions = self.shape.shape_functions(point);
        let jacobian = self.jacobian(point);
        let determinant = jacobian.determinant();
        let inverse = jacobian.try_inverse().filter(|_| determinant > 0.0);
        let inverse = inverse.ok_or_else(|| {
            ElementError::new(
                format!(
                    "the element is inverted or degenerate: its Jacobian determinant is {determinant:.3e}"
                ),
                "check the order of the nodes and the shape of the element",
            )
        })?;
        let gradient = |function: &[f64; 4]| inverse * Vector3::new(function[1], function[2], function[3]);
        let mut gradients: Vec<_> = functions.iter().map(gradient).collect();
        if self.shape == SolidShape::IncompatibleHexahedron8 {
            gradients.extend(self.incompatible_gradients(point, determinant));
        }
        let values = functions.iter().map(|function| function[0]).collect();
        Ok(AtPoint { values, gradients, volume: weight * determinant })
    }

    /// Returns the derivatives of the position by the reference coordinates, by row.
    fn jacobian(&self, point: [f64; 3]) -> Matrix3<f64> {
        let mut jacobian = Matrix3::zeros();
        for (function, position) in self.shape.shape_functions(point).iter().zip(self.positions) {
            for i in 0..3 {
                for j in 0..3 {
                    jacobian[(i, j)] += function[i + 1] * position[j];
                }
            }
        }
        jacobian
    }

    /// Returns the gradients of the incompatible modes `1 - xi_i^2` at a point with a determinant
    /// of the Jacobian. With the Jacobian of the centre and the ratio of the determinants their
    /// integrals vanish, so that distorted elements pass the patch test (Taylor, Beresford and
    /// Wilson 1976).
    fn incompatible_gradients(&self, point: [f64; 3], determinant: f64) -> [Vector3<f64>; 3] {
        let center = self.jacobian([0.0; 3]);
        let ratio = center.determinant() / determinant;
        let inverse = center.try_inverse().unwrap_or_else(Matrix3::zeros);
        [0, 1, 2].map(|axis| inverse.column(axis) * (-2.0 * point[axis] * ratio))
    }
}

/// Returns the stiffness over three translations per node along the basic axes.
///
/// # Errors
/// The element is degenerate, or its material is not stable.
pub fn stiffness(element: &SolidElement<'_>) -> Result<DMatrix<f64>, ElementError> {
    let (modulus, ratio) = (element.material.youngs_modulus, element.material.poissons_ratio);
    let stable = modulus.is_finite() && modulus > 0.0 && ratio > -1.0 && ratio < 0.5;
    if !stable {
        return Err(ElementError::new(
            format!("Young's modulus {modulus:.6e} and Poisson's ratio {ratio:.6e} are no stable material"),
            "state a positive Young's modulus and a Poisson's ratio between -1 and 0.5",
        ));
    }
    let matrix = with_incompatible_modes(element)?;
    let size = 3 * element.positions.len();
    if matrix.ncols() == size {
        return Ok(matrix);
    }
    let coefficients = mode_coefficients(&matrix, size)?;
    let coupling = matrix.view((0, size), (size, matrix.ncols() - size)).into_owned();
    let mut stiffness = matrix.view((0, 0), (size, size)) + coupling * coefficients;
    stiffness.fill_upper_triangle_with_lower_triangle();
    Ok(stiffness)
}

/// Returns the amplitudes of the incompatible modes per displacement of the nodes, by static
/// condensation: the modes carry no load. The first `size` rows are displacements of nodes.
fn mode_coefficients(matrix: &DMatrix<f64>, size: usize) -> Result<DMatrix<f64>, ElementError> {
    let modes = matrix.ncols() - size;
    let own = matrix.view((size, size), (modes, modes)).into_owned();
    let factor = own.cholesky().ok_or_else(|| {
        ElementError::new(
            "the element has no stiffness against its incompatible modes",
            "check the order of the nodes and the shape of the element",
        )
    })?;
    Ok(-factor.solve(&matrix.view((size, 0), (modes, size)).into_owned()))
}

/// Returns the stiffness over three translations per node, and per incompatible mode if the element
/// has them.
fn with_incompatible_modes(element: &SolidElement<'_>) -> Result<DMatrix<f64>, ElementError> {
    let (modulus, ratio) = (element.material.youngs_modulus, element.material.poissons_ratio);
    let shear = 0.5 * modulus / (1.0 + ratio);
    let lame = modulus * ratio / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
    let points = element.at_points(Integrand::Stiffness)?;
    let size = 3 * points.first().map_or(0, |point| point.gradients.len());
    let mut matrix = DMatrix::zeros(size, size);
    for point in points {
        for (b, of_column) in point.gradients.iter().enumerate() {
            for (a, of_row) in point.gradients.iter().enumerate().take(b + 1) {
                let isotropic = shear * of_row.dot(of_column);
                for j in 0..3 {
                    for i in 0..3 {
                        let mut value = lame * of_row[i] * of_column[j] + shear * of_row[j] * of_column[i];
                        if i == j {
                            value += isotropic;
                        }
                        matrix[(3 * a + i, 3 * b + j)] += point.volume * value;
                    }
                }
            }
        }
    }
    for column in 0..size {
        for row in 0..column {
            matrix[(column, row)] = matrix[(row, column)];
        }
    }
    Ok(matrix)
}

/// Returns the consistent mass over three translations per node.
///
/// # Errors
/// The element is degenerate.
pub fn mass(element: &SolidElement<'_>) -> Result<DMatrix<f64>, ElementError> {
    let size = element.positions.len();
    let mut matrix = DMatrix::zeros(3 * size, 3 * size);
    for point in element.at_points(Integrand::Mass)? {
        let density = element.material.density * point.volume;
        for b in 0..size {
            for a in 0..size {
                let value = density * (point.values[a] * point.values[b]);
                for axis in 0..3 {
                    matrix[(3 * a + axis, 3 * b + axis)] += value;
                }
            }
        }
    }
    Ok(matrix)
}
