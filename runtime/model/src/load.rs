//! External loads on bodies: constant, any function of time, or blows.

use std::f64::consts::PI;
use std::ops::{Add, Mul};

/// A force on a body's axle ([`crate::motion::axle`]: the origin of its frame, unless the body sits off its shaft, as a gear with runout does)
/// and a moment about it, along ground axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// N
    pub force: [f64; 3],
    /// N m
    pub moment: [f64; 3],
}

impl Wrench {
    /// No load at all.
    pub const NONE: Wrench = Wrench { force: [0.0; 3], moment: [0.0; 3] };

    /// A force on the axle, N.
    pub const fn of_force(force: [f64; 3]) -> Wrench {
        Wrench { force, ..Wrench::NONE }
    }

    /// A moment, N m.
    pub const fn of_moment(moment: [f64; 3]) -> Wrench {
        Wrench { moment, ..Wrench::NONE }
    }

    /// What does work on a body's freedoms, in the order of [`crate::freedom::FREEDOMS`], where they count along `axes`; N and N m.
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

/// So many times as large.
impl Mul<Wrench> for f64 {
    type Output = Wrench;

    fn mul(self, Wrench { force, moment }: Wrench) -> Wrench {
        Wrench { force: force.map(|part| self * part), moment: moment.map(|part| self * part) }
    }
}

/// The square of a half wave of a sine over its duration, which in the end has passed on a momentum: to steps of which a whole number of at
/// least two fill the duration, exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blow {
    /// When it begins, s.
    pub at: f64,
    /// How long it takes, s.
    pub duration: f64,
    /// What it passes on: N s and N m s.
    pub momentum: Wrench,
}

impl Load for Blow {
    fn at(&self, time: f64) -> Wrench {
        let passed = (time - self.at) / self.duration;
        if !(0.0..=1.0).contains(&passed) {
            return Wrench::NONE;
        }
        2.0 / self.duration * (PI * passed).sin().powi(2) * self.momentum
    }
}

/// What acts on a body from outside, at any time.
///
/// A [`Wrench`] is a constant load; a closure from time (s) to a wrench is one that changes. It is asked once for each
/// position that is analysed, on the thread that solves it, and should give the same for the same time: results are kept and
/// resumed on that understanding. A load may be zero and may change its sign. One that is not a number ends the analysis with
/// `E0723`.
///
/// ```
/// use calyx_runtime::load::{Load, Wrench};
/// let shaking = |time: f64| Wrench::of_moment([0.0, 0.0, 100.0 + 20.0 * (50.0 * time).sin()]);
/// assert_eq!(shaking.at(0.0), Wrench::of_moment([0.0, 0.0, 100.0]));
/// ```
pub trait Load: Send + Sync {
    /// The load at `time`, s.
    fn at(&self, time: f64) -> Wrench;

    /// Whether it is the same at all times, for those who describe a scene.
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
