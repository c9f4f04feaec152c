//! What bodies weigh: mass, where it is, and its moments.

use std::ops::{Add, Mul};

/// Mass and moments of a body in its frame. Those of bodies that make one add up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inertia {
    /// kg.
    pub mass: f64,
    /// Of the mass by the place in the body, kg m: the mass times where its centre is.
    pub moment: [f64; 3],
    /// About the frame's origin, kg m²: products of inertia are negative off the diagonal, as in the relation of angular momentum to
    /// angular velocity.
    pub about: [[f64; 3]; 3],
}

impl Inertia {
    /// Of a point, or of a body as a whole: mass (kg), polar moment about the z axis and moment about axes across it (kg m²), both through the
    /// origin, where the centre is.
    pub fn axial(mass: f64, polar: f64, across: f64) -> Self {
        Self { mass, moment: [0.0; 3], about: [[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, polar]] }
    }

    /// The same body `offset` further along z, if its centre was in the origin, m.
    pub fn shifted_along(self, offset: f64) -> Self {
        let mut shifted = self;
        shifted.moment[2] += self.mass * offset;
        for axis in 0..2 {
            shifted.about[axis][axis] += self.mass * offset * offset;
        }
        shifted
    }

    /// Where its centre is, m; the origin of a body without mass.
    pub fn centre(&self) -> [f64; 3] {
        if self.mass == 0.0 { [0.0; 3] } else { self.moment.map(|moment| moment / self.mass) }
    }

    /// About a point of the body, m: the moments by the theorem of parallel axes.
    pub fn from(&self, [x, y, z]: [f64; 3]) -> Self {
        let Inertia { mass, moment, mut about } = *self;
        let at = [x, y, z];
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        // Of each particle |r - p|² = r² - 2 r p + p², and so the products.
        let spread = mass * dot(at, at) - 2.0 * dot(moment, at);
        for (i, row) in about.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let product = mass * at[i] * at[j] - moment[i] * at[j] - moment[j] * at[i];
                *entry += if i == j { spread - product } else { -product };
            }
        }
        let moment = [0, 1, 2].map(|k: usize| moment[k] - mass * at[k]);
        Self { mass, moment, about }
    }

    /// About the z axis, kg m².
    pub fn polar(&self) -> f64 {
        self.about[2][2]
    }
}

impl Add for Inertia {
    type Output = Inertia;

    fn add(self, other: Inertia) -> Inertia {
        let mut sum = self;
        sum.mass += other.mass;
        for axis in 0..3 {
            sum.moment[axis] += other.moment[axis];
            for along in 0..3 {
                sum.about[axis][along] += other.about[axis][along];
            }
        }
        sum
    }
}

/// So many times as dense.
impl Mul<Inertia> for f64 {
    type Output = Inertia;

    fn mul(self, other: Inertia) -> Inertia {
        Inertia {
            mass: self * other.mass,
            moment: other.moment.map(|moment| self * moment),
            about: other.about.map(|row| row.map(|moment| self * moment)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_halves_make_a_whole() {
        // A rod of 2 kg and 0.6 m along z by its halves: m l²/12 across, nothing about itself.
        let half = Inertia::axial(1.0, 0.0, 0.3 * 0.3 / 12.0);
        let whole = half.shifted_along(0.15) + half.shifted_along(-0.15);
        assert_eq!([whole.mass, whole.polar()], [2.0, 0.0]);
        assert_eq!(whole.centre(), [0.0; 3]);
        assert!((whole.about[0][0] - 2.0 * 0.6 * 0.6 / 12.0).abs() < 1e-15);
        assert_eq!(half.shifted_along(0.15).centre(), [0.0, 0.0, 0.15]);
        let seen = half.from([0.0, 0.0, -0.15]);
        assert!((seen.about[0][0] - half.shifted_along(0.15).about[0][0]).abs() < 1e-15);
        let off = half.from([-0.5, 0.2, 0.0]);
        assert!((off.polar() - 0.29).abs() < 1e-15 && (off.about[0][1] - 0.1).abs() < 1e-15);
        let back = off.from([0.5, -0.2, 0.0]);
        assert!((back.about[0][0] - half.about[0][0]).abs() < 1e-15 && back.about[0][1].abs() < 1e-15);
        assert_eq!(2.0 * half, half + half);
        assert_eq!(Inertia::default().centre(), [0.0; 3]);
    }
}
