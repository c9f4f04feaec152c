//! External loads on bodies: constants, functions of time, and impulses.

use std::f64::consts::PI;
use std::ops::{Add, Mul};

/// Force on a body's axis of rotation ([`crate::motion::axle`]: the origin of its frame, unless the
/// body is eccentric, like a gear with runout) and moment about it, along ground axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force, N.
    pub force: [f64; 3],
    /// Moment, N m.
    pub moment: [f64; 3],
}

impl Wrench {
    /// No load.
    pub const NONE: Wrench = Wrench { force: [0.0; 3], moment: [0.0; 3] };

    /// Creates a force on the axis, N.
    pub const fn of_force(force: [f64; 3]) -> Wrench {
        Wrench { force, ..Wrench::NONE }
    }

    /// Creates a moment, N m.
    pub const fn of_moment(moment: [f64; 3]) -> Wrench {
        Wrench { moment, ..Wrench::NONE }
    }

    /// Returns the generalized forces on a body's DOFs, in the order of [`crate::dof::DOF_NAMES`],
    /// with their directions `axes`; N and N m.
    pub fn along(&self, axes: &[[f64; 3]; 3]) -> [f64; 6] {
        let of = |[x, y, z]: [f64; 3]| axes.map(|axis| x * axis[0] + y * axis[1] + z * axis[2]);
        let ([a, b, c], [d, e, f]) = (of(self.force), of(self.moment));
        [a, b, c, d, e, f]
    }
}

impl Add for Wrench {
    type Output = Wrench;

    fn add(self, other: Wrench) -> Wrench {
        let sum = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        Wrench { force: sum(self.force, other.force), moment: sum(self.moment, other.moment) }
    }
}

/// Scales a load.
impl Mul<Wrench> for f64 {
    type Output = Wrench;

    fn mul(self, Wrench { force, moment }: Wrench) -> Wrench {
        Wrench { force: force.map(|part| self * part), moment: moment.map(|part| self * part) }
    }
}

/// Impulse: the square of a sine half-wave over its duration with a given total momentum. Time
/// steps integrate it exactly if the duration is an integer number of at least two steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impulse {
    /// Start, s.
    pub at: f64,
    /// Duration, s.
    pub duration: f64,
    /// Momentum, N s and N m s.
    pub momentum: Wrench,
}

impl Load for Impulse {
    fn at(&self, time: f64) -> Wrench {
        let passed = (time - self.at) / self.duration;
        if !(0.0..=1.0).contains(&passed) {
            return Wrench::NONE;
        }
        2.0 / self.duration * (PI * passed).sin().powi(2) * self.momentum
    }
}

/// External load on a body at any time.
///
/// A [`Wrench`] is a constant load; a closure from time (s) to a wrench is a varying one. It is
/// evaluated once for each analysed position, on the thread that solves it. It must return the same
/// value for the same time, because results are stored and resumed. A load may be zero and may
/// change its sign. A NaN load ends the analysis with `E0723`.
///
/// ```
/// use calyx_model::load::{Load, Wrench};
/// let shaking = |time: f64| Wrench::of_moment([0.0, 0.0, 100.0 + 20.0 * (50.0 * time).sin()]);
/// assert_eq!(shaking.at(0.0), Wrench::of_moment([0.0, 0.0, 100.0]));
/// ```
pub trait Load: Send + Sync {
    /// Returns the load at `time`, s.
    fn at(&self, time: f64) -> Wrench;

    /// Returns whether the load is constant, for descriptions of a scene.
    fn is_constant(&self) -> bool {
        false
    }
}

impl Load for Wrench {
    fn at(&self, _: f64) -> Wrench {
        *self
    }

    fn is_constant(&self) -> bool {
        true
    }
}

impl<F: Fn(f64) -> Wrench + Send + Sync> Load for F {
    fn at(&self, time: f64) -> Wrench {
        self(time)
    }
}
