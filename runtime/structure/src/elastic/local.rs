//! Points of a surface in the coordinates of the tables of an elastic structure.

use super::Surface;
use crate::spline::Weights;

/// Point of a surface in the coordinates of its tables.
#[derive(Clone, Copy)]
pub(crate) struct Local {
    pub turned: Turned,
    /// Direction in which the point is loaded and observed: share into the body, share along the
    /// surface. Their squares add up to one.
    pub direction: [f64; 2],
    pub weights: Weights,
    /// Weights over the stretched coordinate.
    pub stretched: Weights,
    /// Distance of the stretched coordinate beyond the samples.
    pub beyond: f64,
}

/// Point of a surface and the rotation of its normal there.
#[derive(Clone, Copy)]
pub(crate) struct Turned {
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
        let turned = Turned { s, angle: weights.sum(|i| self.turned[i]) };
        Local { turned, direction: [1.0, 0.0], weights, stretched, beyond }
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        self.spline.bytes()
            + self.stretched.bytes()
            + size_of_val(self.turned.as_slice())
            + size_of_val(self.stress_places.as_slice())
    }

    /// Returns only the data of a point that the curvature terms use.
    pub fn turned_at(&self, s: f64) -> Turned {
        let s = s.clamp(self.range[0], self.range[1]);
        Turned { s, angle: self.spline.weights(s).sum(|i| self.turned[i]) }
    }
}
