//! Rigid plane: ground or baffle.

use crate::error::AcousticError;
use calyx_numerics::vec3::{Vector, dot, length, minus, plus, scaled, unit};

/// Rigid plane of infinite extent. The fluid is on the side to which the normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidPlane {
    point: Vector,
    normal: Vector,
}

impl RigidPlane {
    /// Creates a plane from one of its points, m, and its normal of any length.
    ///
    /// # Errors
    /// A component is not finite, or the normal vanishes.
    pub fn new(point: Vector, normal: Vector) -> Result<Self, AcousticError> {
        let size = length(normal);
        if !(size > 0.0 && size.is_finite() && point.iter().all(|x| x.is_finite())) {
            return Err(AcousticError::input(
                format!("the rigid plane has the point {point:?} and the normal {normal:?}"),
                "state a finite point and a normal that is not zero",
            ));
        }
        Ok(Self { point, normal: unit(normal) })
    }

    /// Returns the point that defines the plane, m.
    pub fn point(&self) -> Vector {
        self.point
    }

    /// Returns the unit normal.
    pub fn normal(&self) -> Vector {
        self.normal
    }

    /// Returns the distance of a point, m; negative behind the plane.
    pub fn distance(&self, at: Vector) -> f64 {
        dot(minus(at, self.point), self.normal)
    }

    /// Returns the mirror image of a point.
    pub fn mirror(&self, at: Vector) -> Vector {
        plus(at, scaled(self.normal, -2.0 * self.distance(at)))
    }
}
