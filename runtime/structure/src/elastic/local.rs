//! Points of a surface in the coordinates of the tables of an elastic structure.

use super::Surface;
use crate::bspline::BSplineWeights;

/// Point of a surface in the coordinates of its tables.
#[derive(Clone, Copy)]
pub(crate) struct Local {
    pub turned: NormalAngle,
    /// Direction in which the point is loaded and observed: share into the body, share along the
    /// surface. Their squares add up to one.
    pub direction: [f64; 2],
    pub weights: BSplineWeights,
    /// Weights over the stretched coordinate.
    pub stretched: BSplineWeights,
    /// Distance of the stretched coordinate beyond the samples.
    pub beyond: f64,
}

/// Point of a surface and the rotation of its normal there.
#[derive(Clone, Copy)]
pub(crate) struct NormalAngle {
    /// Arc length, clamped to the surface's range, m.
    pub s: f64,
    /// Rotation, rad, positive where convex.
    pub angle: f64,
}

impl Local {
    /// Returns true if the point comes first in a table of its own surface; points clamped to an
    /// end of the range are compared by direction.
    pub fn is_before(&self, other: &Local) -> bool {
        (self.turned.s, self.direction[1]) >= (other.turned.s, other.direction[1])
    }
}

impl Surface {
    /// Returns the data of a point that is loaded along the normal of the surface, into the body.
    pub fn local(&self, s: f64) -> Local {
        let s = s.clamp(self.range[0], self.range[1]);
        let (t, weights) = (self.stretch.at(s), self.spline.weights(s));
        let (stretched, beyond) = (self.stretched.weights(t), self.stretched.beyond(t));
        let turned = NormalAngle { s, angle: weights.sum(|i| self.turned[i]) };
        Local { turned, direction: [1.0, 0.0], weights, stretched, beyond }
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        self.spline.bytes()
            + self.stretched.bytes()
            + size_of_val(self.turned.as_slice())
            + size_of_val(self.stress_points.as_slice())
    }

    /// Returns only the data of a point that the curvature terms use.
    pub fn normal_angle_at(&self, s: f64) -> NormalAngle {
        let s = s.clamp(self.range[0], self.range[1]);
        NormalAngle { s, angle: self.spline.weights(s).sum(|i| self.turned[i]) }
    }
}
