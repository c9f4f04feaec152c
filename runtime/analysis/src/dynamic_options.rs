//! Options of a transient analysis.

use calyx_numerics::error::EngineError;
use calyx_solve::integration::{Scheme, TimeRange, check_resolved};

/// Initial state of a transient analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Start {
    /// Equilibrium under the loads at the start, at rest relative to the prescribed motion. The
    /// inertia terms due to the deflections set in with the first step; they are of the order of
    /// `(omega / omega_n)²` of them.
    #[default]
    Equilibrium,
    /// Prescribed position of the frames, at rest relative to the prescribed motion.
    Frames,
}

/// Options of a transient analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct DynamicOptions {
    /// Start time, s.
    pub from: f64,
    /// Time ranges, one after the other.
    pub ranges: Vec<TimeRange>,
    /// Time integration scheme.
    pub scheme: Scheme,
    /// Rayleigh damping: factors on mass, 1/s, and on stiffness, s. The latter applies to bearings
    /// and modes.
    pub rayleigh: [f64; 2],
    /// Initial state.
    pub start: Start,
}

impl DynamicOptions {
    /// Checks the options for consistency.
    ///
    /// # Errors
    /// E0763: a time range cannot be integrated, or its steps are lost in the digits of their
    /// times. E0764: there is no range, or damping is negative.
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
