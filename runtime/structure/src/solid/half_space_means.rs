//! Means of the half-space's response over pairs of loads, on screw surfaces and on others.

use super::half_space::ReciprocalMeans;
use super::surface_means::SurfaceMeans;
use crate::kernel::Mollifier;
use faer::Mat;

/// Means of `1/r`, with images, over pairs of loads on a surface.
pub(super) enum HalfSpaceMeans {
    /// On the flank of a spur or helical gear.
    Screw(ReciprocalMeans),
    /// On any smooth surface.
    Surface(SurfaceMeans),
}

impl HalfSpaceMeans {
    /// Returns the means over an observer `a` times a polynomial and a load `b` times another: rows
    /// by the observer's polynomial, 1/m.
    pub fn between(&self, a: &Mollifier, b: &Mollifier) -> Mat<f64> {
        match self {
            Self::Screw(means) => means.between(a, b),
            Self::Surface(means) => means.between(a, b),
        }
    }
}
