//! Centrifugal force and gyroscopic moment of a ball.

use super::geometry::BallRow;
use libm::{cos, sin};
use std::ops::{Add, Div, Mul, Sub};

/// Model of the orbital speed of the balls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CageSpeed {
    /// Rolling at the contact angle of the unloaded bearing.
    #[default]
    Nominal,
    /// Rolling without spin at the inner race, for the operating contact angles.
    InnerRaceControl,
    /// Rolling without spin at the outer race, for the operating contact angles.
    OuterRaceControl,
}

/// Motion of the rings and model of the inertia of the rolling elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Angular speed of the inner ring, rad/s.
    pub inner_speed: f64,
    /// Angular speed of the outer ring, rad/s.
    pub outer_speed: f64,
    /// Model of the orbital speed of balls.
    pub cage: CageSpeed,
    /// Balls have a gyroscopic moment. Friction at the outer race balances it.
    pub gyroscopic: bool,
    /// Centrifugal force of each roller, N, in place of the one for rolling without sliding.
    pub roller_force: Option<f64>,
    /// Azimuth of the first element of each row from +x to +y, rad.
    pub azimuth: f64,
}

impl Motion {
    /// The bearing at rest with the first element at azimuth zero.
    pub const REST: Self = Self {
        inner_speed: 0.0,
        outer_speed: 0.0,
        cage: CageSpeed::Nominal,
        gyroscopic: false,
        roller_force: None,
        azimuth: 0.0,
    };

    /// Returns whether the elements orbit.
    pub(crate) fn has_inertia(&self) -> bool {
        self.inner_speed != 0.0 || self.outer_speed != 0.0
    }

    /// Returns the orbital speed, rad/s, from its ratio to the speed of the inner ring at a fixed
    /// outer ring.
    pub(crate) fn orbital_speed(&self, ratio: f64) -> f64 {
        self.outer_speed + ratio * (self.inner_speed - self.outer_speed)
    }
}

/// Number with its derivatives with respect to the inner and the outer contact angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct ByAngles {
    pub value: f64,
    pub by: [f64; 2],
}

impl ByAngles {
    fn constant(value: f64) -> Self {
        Self { value, by: [0.0; 2] }
    }

    fn cos(self) -> Self {
        let slope = -sin(self.value);
        Self { value: cos(self.value), by: self.by.map(|d| slope * d) }
    }

    fn sin(self) -> Self {
        let slope = cos(self.value);
        Self { value: sin(self.value), by: self.by.map(|d| slope * d) }
    }

    /// Returns a function of two numbers from its value and its derivatives.
    fn chain(&self, other: &Self, value: f64, [first, second]: [f64; 2]) -> Self {
        let by = |k: usize| first * self.by[k] + second * other.by[k];
        Self { value, by: [by(0), by(1)] }
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self { value: root, by: self.by.map(|d| 0.5 * d / root) }
    }
}

impl Add for ByAngles {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, by: [self.by[0] + other.by[0], self.by[1] + other.by[1]] }
    }
}

impl Sub for ByAngles {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, by: [self.by[0] - other.by[0], self.by[1] - other.by[1]] }
    }
}

impl Mul for ByAngles {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.chain(&other, self.value * other.value, [other.value, self.value])
    }
}

impl Div for ByAngles {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.chain(&other, value, [other.value.recip(), -value / other.value])
    }
}

impl BallRow {
    /// Computes the radial and axial force of inertia and of the friction that balances the
    /// gyroscopic moment, N, from the contact angles, rad.
    ///
    /// The orbital radius is that of the pitch circle. Source: Harris and Kotzalas, Advanced
    /// Concepts of Bearing Technology (2007), chapter 3. The pitch angle of the ball's axis is that
    /// of outer race control.
    pub(super) fn inertia(&self, motion: &Motion, inner: f64, outer: f64) -> [ByAngles; 2] {
        let zero = ByAngles::constant(0.0);
        if !motion.has_inertia() {
            return [zero; 2];
        }
        let constant = ByAngles::constant;
        let one = constant(1.0);
        let inner = ByAngles { value: inner, by: [1.0, 0.0] };
        let outer = ByAngles { value: outer, by: [0.0, 1.0] };
        let g = constant(self.geometry.ball_diameter / self.geometry.pitch_diameter);
        let ratio = match motion.cage {
            CageSpeed::Nominal => constant(self.cage_ratio()),
            CageSpeed::InnerRaceControl => {
                let between = (inner - outer).cos();
                (between - g * outer.cos()) / (one + between)
            }
            CageSpeed::OuterRaceControl => (one - g * inner.cos()) / (one + (inner - outer).cos()),
        };
        let relative = constant(motion.inner_speed - motion.outer_speed);
        let orbital = constant(motion.outer_speed) + ratio * relative;
        let mass = self.ball_mass();
        let centrifugal = constant(0.5 * mass * self.geometry.pitch_diameter) * orbital * orbital;
        if !motion.gyroscopic {
            return [centrifugal, zero];
        }
        // Pitch angle β: tan β = sin αₒ / (cos αₒ + D/dₘ).
        let length = (one + constant(2.0) * g * outer.cos() + g * g).sqrt();
        let (sine, cosine) = (outer.sin() / length, (outer.cos() + g) / length);
        let toward = |angle: ByAngles| cosine * angle.cos() + sine * angle.sin();
        let rolling = toward(outer) / (one + g * outer.cos()) + toward(inner) / (one - g * inner.cos());
        let spin = relative / (g * rolling);
        // Twice the moment m D²/10 · ω_R ω_m sin β divided by the ball diameter.
        let friction = constant(0.2 * mass * self.geometry.ball_diameter) * spin * orbital * sine;
        [centrifugal - friction * outer.sin(), friction * outer.cos()]
    }
}
