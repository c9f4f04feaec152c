//! Options of a motion in time.

use calyx_numerics::error::EngineError;
use calyx_solve::integration::{Scheme, TimeRange, check_resolved};

/// What a history begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Start {
    /// The equilibrium under the loads of the first time, at rest against the prescribed motion. What the deflections there do to inertia sets
    /// in with the first step: it is of the order of `(omega / omega_n)²` of them.
    #[default]
    Equilibrium,
    /// Where frames are meant to be, at rest against the prescribed motion.
    Frames,
}

/// How motion in time is analysed.
#[derive(Clone, Debug, PartialEq)]
pub struct DynamicOptions {
    /// When it begins, s.
    pub from: f64,
    /// One after the other.
    pub ranges: Vec<TimeRange>,
    /// The integrator.
    pub scheme: Scheme,
    /// Rayleigh's damping: of mass, 1/s, and of stiffness, s. The latter is of bearings and modes.
    pub rayleigh: [f64; 2],
    /// What it begins with.
    pub start: Start,
}

impl DynamicOptions {
    /// That its numbers make sense together.
    ///
    /// # Errors
    /// E0763: a range of time cannot be integrated, or its steps are lost in the digits of their times. E0764: there is no range, or
    /// damping is negative.
    pub fn check(&self) -> Result<(), EngineError> {
        let refuse = |argument: &'static str, message: &str, help: &str| {
            Err(EngineError::new("E0764", message, help).blame(argument))
        };
        if self.ranges.is_empty() {
            return refuse(
                "over",
                "a dynamic analysis needs a range of time",
                "give one: `gears.time_ranges([gears.time_range(...)])`",
            );
        }
        self.ranges.iter().try_for_each(TimeRange::check)?;
        let positive = |number: f64| number.is_finite() && number >= 0.0;
        for (argument, part) in ["rayleigh_mass", "rayleigh_stiffness"].into_iter().zip(self.rayleigh) {
            if !positive(part) {
                let message = format!("damping cannot be negative, and `{argument}` is {part}");
                return refuse(argument, &message, "give a positive number, or 0 for none");
            }
        }
        check_resolved(self.from, &self.ranges)
    }
}
