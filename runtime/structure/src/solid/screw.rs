//! Helical surfaces, invariant under a screw motion about the z axis: flanks of spur and helical
//! gears.
//!
//! The distance of two of their points depends on the axial coordinates only through their
//! difference, which makes the half-space's responses to loads on a whole flank inexpensive.

use crate::surface::Surface;

/// Number of intervals of the table of the profile: its error is of the order of 1e-12 of the
/// length.
const INTERVALS: usize = 512;
/// Largest deviation of points of a surface from the screw motion, relative to the size of the
/// surface.
const TOLERANCE: f64 = 1e-3;

/// Transverse profile that is extruded along the z axis with a rotation.
#[derive(Clone, Debug)]
pub(crate) struct Screw {
    /// Rotation per axial length, rad/m; 0 for a spur gear.
    pub rate: f64,
    start: f64,
    step: f64,
    /// Position in the transverse plane and its derivative by `u`, at the ends of equal intervals.
    points: Vec<[f64; 4]>,
}

impl Screw {
    /// Extracts the profile of a surface at the middle of its axial range, for `u` between two
    /// coordinates. `None` if the surface is not helical.
    pub fn of(surface: &dyn Surface, [from, to]: [f64; 2]) -> Option<Self> {
        let [u_range, [v_start, v_end]] = surface.range();
        let middle = 0.5 * (v_start + v_end);
        let at = surface.at(0.5 * (u_range[0] + u_range[1]), middle);
        let [x, y, _] = at.position;
        let [vx, vy, _] = at.tangents[1];
        let square = x * x + y * y;
        let rate = if square > 0.0 { (x * vy - y * vx) / square } else { 0.0 };

        let size = (u_range[1] - u_range[0]).max(v_end - v_start);
        for share in [0.0, 0.5, 1.0] {
            let u = u_range[0] + share * (u_range[1] - u_range[0]);
            let [x, y, z] = surface.at(u, middle).position;
            for v in [v_start, v_end] {
                let (sin, cos) = (rate * (v - middle)).sin_cos();
                let expected = [cos * x - sin * y, sin * x + cos * y, z + v - middle];
                let found = surface.at(u, v).position;
                let off = (0..3).map(|axis| (found[axis] - expected[axis]).abs()).fold(0.0, f64::max);
                // The comparison is negated so that NaN fails it.
                let near = off <= TOLERANCE * size;
                if !near {
                    return None;
                }
            }
        }
        let step = (to - from) / INTERVALS as f64;
        let point = |index: usize| {
            let at = surface.at(from + step * index as f64, middle);
            [at.position[0], at.position[1], at.tangents[0][0], at.tangents[0][1]]
        };
        Some(Self { rate, start: from, step, points: (0..=INTERVALS).map(point).collect() })
    }

    /// Returns the position in the transverse plane, m.
    pub fn profile(&self, u: f64) -> [f64; 2] {
        let at = (u - self.start) / self.step;
        let index = (at.max(0.0) as usize).min(INTERVALS - 1);
        let x = at - index as f64;
        let [a, b] = [&self.points[index], &self.points[index + 1]];
        let (y, bulge) = (1.0 - x, x * (1.0 - x));
        [0, 1].map(|axis| {
            // Cubic Hermite interpolation.
            let (linear, difference) = (y * a[axis] + x * b[axis], b[axis] - a[axis]);
            let slopes = [a[2 + axis] * self.step - difference, difference - b[2 + axis] * self.step];
            linear + bulge * (y * slopes[0] + x * slopes[1])
        })
    }
}
