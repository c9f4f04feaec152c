//! Interface of an analysis method for validation: the properties that decide whether a scene and a
//! fidelity level support it. [`crate::analyses::Analysis`] adds the driver.

use crate::dynamic_options::{DynamicOptions, Start};
use calyx_model::fidelity::Fidelity;
use calyx_model::position::Position;
use calyx_numerics::error::EngineError;
use calyx_solve::integration::check_elastic;
use std::borrow::Cow;

/// Properties of an analysis method with its own options.
pub trait Method: Send + Sync {
    /// Checks the options of the method, and whether it supports a fidelity level.
    ///
    /// # Errors
    /// Those of the method.
    fn check_options(&self, _fidelity: Fidelity) -> Result<(), EngineError> {
        Ok(())
    }

    /// Returns whether the analysis includes inertia and damping. Then it requires free bodies with
    /// mass, on axes that keep their directions.
    fn has_inertia(&self) -> bool {
        false
    }

    /// Returns times at which the prescribed motions of a method with inertia are checked before
    /// the run, s.
    fn checked_times(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the time of the first equilibrium, s; `None` if the analysis starts without one. The
    /// contacts and supports must restrain all free components at this time.
    fn first_equilibrium(&self) -> Option<f64>;
}

/// Quasi-static analysis: the equilibrium at every position, without inertia.
#[derive(Clone, Debug, PartialEq)]
pub struct QuasiStatic<'p> {
    /// Positions, in order.
    pub positions: Cow<'p, [Position]>,
}

impl Method for QuasiStatic<'_> {
    fn first_equilibrium(&self) -> Option<f64> {
        Some(self.positions.first().map_or(0.0, |position| position.time))
    }
}

impl Method for DynamicOptions {
    fn check_options(&self, fidelity: Fidelity) -> Result<(), EngineError> {
        check_elastic(fidelity)?;
        self.check()
    }

    fn has_inertia(&self) -> bool {
        true
    }

    fn checked_times(&self) -> Vec<f64> {
        // The start, and the middle and the end of each range.
        let mut times = vec![self.from];
        let mut begin = self.from;
        for range in &self.ranges {
            times.extend([0.5, 1.0].map(|part| begin + part * range.duration));
            begin += range.duration;
        }
        times
    }

    fn first_equilibrium(&self) -> Option<f64> {
        // A motion that starts at the prescribed position needs no equilibrium.
        (self.start == Start::Equilibrium).then_some(self.from)
    }
}
