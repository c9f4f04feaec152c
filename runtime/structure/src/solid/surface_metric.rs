//! Metric of a surface that is no extruded profile, as far as its compliance uses it.

use super::axial_modes::AxialModes;
use super::side_faces::SideFaces;
use crate::surface::Surface;
use calyx_numerics::vec3::{dot, length, minus, scaled, unit};
use faer::Mat;
use serde::{Deserialize, Serialize};

/// Degree of the length along the face per unit of `v` that the integrals resolve.
const DEGREE: usize = 24;

/// Metric of a surface: side faces, and lengths along the face.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct SurfaceMetric {
    pub sides: SideFaces,
    /// Integrals over `v` of the products of two polynomials, divided by the length along the face
    /// per unit of `v` in the middle of the profile: row by row. A force at one `v` is this
    /// distribution of force per length.
    per_length: Vec<f64>,
    modes: usize,
}

impl SurfaceMetric {
    pub fn new(surface: &dyn Surface, sides: SideFaces, modes: &AxialModes) -> Self {
        let [[start, end], _] = surface.range();
        let middle = 0.5 * (start + end);
        let count = modes.count();
        let mut per_length = vec![0.0; count * count];
        for (v, weight) in modes.quadrature(modes.range(), DEGREE) {
            let weight = weight / length(surface.at(middle, v).tangents[1]);
            let values = modes.values(v);
            for n in 0..count {
                for m in 0..count {
                    per_length[n * count + m] += weight * values[n] * values[m];
                }
            }
        }
        Self { sides, per_length, modes: count }
    }

    /// Returns the integrals of products over length, by polynomial and polynomial.
    pub fn per_length(&self) -> Mat<f64> {
        Mat::from_fn(self.modes, self.modes, |n, m| self.per_length[n * self.modes + m])
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(self.per_length.as_slice()) + self.sides.bytes()
    }

    /// Returns whether a restored metric is complete.
    pub fn is_sound(&self, modes: &AxialModes) -> bool {
        self.modes == modes.count()
            && self.per_length.len() == self.modes * self.modes
            && self.sides.is_sound()
    }
}

/// Returns the angles by which the normal has rotated about the direction of the face since the
/// first of some `u`, at `v`: rad, positive where convex.
pub(super) fn normal_angles(surface: &dyn Surface, u: &[f64], v: f64) -> Vec<f64> {
    let points: Vec<_> = u.iter().map(|&u| surface.at(u, v)).collect();
    let mut angles = vec![0.0; points.len().min(1)];
    let mut angle = 0.0;
    for pair in points.windows(2) {
        let along = unit(pair[0].tangents[1]);
        let flat = |direction| minus(direction, scaled(along, dot(direction, along)));
        let across = unit(flat(pair[0].tangents[0]));
        let own = pair[0].normal;
        let next = flat(pair[1].normal);
        angle += dot(next, across).atan2(dot(next, own));
        angles.push(angle);
    }
    angles
}
