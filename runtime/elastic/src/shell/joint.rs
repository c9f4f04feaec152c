//! Joints of shells with solids: displacement of a point within the thickness of a shell element.

use super::director::DirectorShell;
use super::geometry::ShellElement;
use super::kinematics::{Geometry, Sample, is_positive};
use crate::error::ElementError;
use calyx_numerics::vec3::{length, minus};
use nalgebra::{DMatrix, Matrix3, Vector3};

/// Distance from the element, in local coordinates and relative to its size, at which a point still
/// belongs to it.
const NEAR: f64 = 1e-6;

/// Steps of Newton's method for the local coordinates.
const STEPS: usize = 30;

/// Returns the displacement of a point of the element, or on its boundary, as three rows over the
/// element's components. A node of a solid at that point follows these rows.
///
/// # Errors
/// The element is invalid, or the point is not within its area and thickness.
pub fn coupling(element: &ShellElement<'_>, point: [f64; 3]) -> Result<DMatrix<f64>, ElementError> {
    let prepared = element.prepared()?;
    let sample = |at| prepared.sample(at);
    let (at, zeta) = locate(&prepared.middle, &sample, element.shape.is_triangle(), point)?;
    let rows = prepared.to_degrees_of_freedom(&displacement(&prepared.sample(at), zeta));
    Ok(rows.columns(0, 6 * element.positions.len()).into_owned())
}

impl DirectorShell<'_> {
    /// Returns the displacement of a point of the element, or on its boundary, as three rows over
    /// `u` and `w` of its nodes. A node of a solid at that point follows these rows.
    ///
    /// # Errors
    /// The element is invalid, or the point is not within its area and thickness.
    pub fn coupling(&self, point: [f64; 3]) -> Result<DMatrix<f64>, ElementError> {
        let geometry = self.geometry()?;
        let triangle = matches!(self.shape, super::DirectorShape::Triangle(_));
        let (at, zeta) = locate(&geometry, &|at| self.shape.sample(at), triangle, point)?;
        Ok(self.nodal_columns(displacement(&self.shape.sample(at), zeta)))
    }
}

/// Returns the rows of the displacement. Internal functions vanish on the boundary and take no
/// part.
fn displacement(sample: &Sample, zeta: f64) -> DMatrix<f64> {
    let mut rows = DMatrix::zeros(3, 6 * sample.translation.len());
    for (node, shape) in sample.position.iter().enumerate() {
        for axis in 0..3 {
            rows[(axis, 6 * node + axis)] = shape[0];
            rows[(axis, 6 * node + 3 + axis)] = shape[0] * zeta;
        }
    }
    rows
}

/// Returns the local coordinates of a point.
fn locate(
    geometry: &Geometry,
    sample: &dyn Fn([f64; 2]) -> Sample,
    triangle: bool,
    point: [f64; 3],
) -> Result<([f64; 2], f64), ElementError> {
    let mut at = if triangle { Vector3::new(1.0 / 3.0, 1.0 / 3.0, 0.0) } else { Vector3::zeros() };
    let size =
        geometry.middle.iter().map(|node| length(minus(*node, geometry.middle[0]))).fold(0.0, f64::max);
    for _ in 0..STEPS {
        let shapes = sample([at.x, at.y]);
        let residual = Vector3::from(minus(point, geometry.point(&shapes, at.z)));
        let base = geometry.base(&shapes, at.z);
        let Some(inverse) = Matrix3::from_fn(|row, column| base[column][row]).try_inverse() else { break };
        at += inverse * residual;
        if !is_positive(1e3 - at.norm()) {
            break;
        }
    }
    let residual = minus(point, geometry.point(&sample([at.x, at.y]), at.z));
    let inside = if triangle {
        at.x > -NEAR && at.y > -NEAR && at.x + at.y < 1.0 + NEAR
    } else {
        at.x.abs() < 1.0 + NEAR && at.y.abs() < 1.0 + NEAR
    };
    if length(residual) <= NEAR * size && inside && at.z.abs() < 1.0 + NEAR {
        return Ok(([at.x, at.y], at.z));
    }
    Err(ElementError {
        message: format!(
            "the point ({}, {}, {}) is not within the shell element",
            point[0], point[1], point[2]
        ),
        help: "join only nodes that lie on the edge of the shell, within its thickness".to_owned(),
    })
}
