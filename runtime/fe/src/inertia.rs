//! Inertia of bodies: mass, centre of mass and moments of inertia.

use std::ops::{Add, Mul};

/// Mass and moments of a body in its frame. The inertias of the parts of a body add up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inertia {
    /// Mass, kg.
    pub mass: f64,
    /// First moment of mass: the mass times the position of its centre, kg m.
    pub moment: [f64; 3],
    /// Inertia tensor about the origin of the frame, kg m². Off-diagonal entries are negative
    /// products of inertia, as in the relation of angular momentum to angular velocity.
    pub about: [[f64; 3]; 3],
}

impl Inertia {
    /// Creates the inertia of a body with its centre of mass at the origin: mass (kg), polar moment
    /// about the z axis and moment about transverse axes (kg m²).
    pub fn axial(mass: f64, polar: f64, across: f64) -> Self {
        Self { mass, moment: [0.0; 3], about: [[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, polar]] }
    }

    /// Shifts a body with its centre of mass at the origin by `offset` along z, m.
    pub fn shifted_along(self, offset: f64) -> Self {
        let mut shifted = self;
        shifted.moment[2] += self.mass * offset;
        for axis in 0..2 {
            shifted.about[axis][axis] += self.mass * offset * offset;
        }
        shifted
    }

    /// Returns the centre of mass, m; the origin for a body without mass.
    pub fn centre(&self) -> [f64; 3] {
        if self.mass == 0.0 { [0.0; 3] } else { self.moment.map(|moment| moment / self.mass) }
    }

    /// Returns the inertia about a point of the body, m, by the parallel axis theorem.
    pub fn from(&self, [x, y, z]: [f64; 3]) -> Self {
        let Inertia { mass, moment, mut about } = *self;
        let at = [x, y, z];
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        // |r - p|² = r² - 2 r p + p² for each particle, and similarly for the products.
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

    /// Returns the moment of inertia about the z axis, kg m².
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

/// Scales the density.
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
