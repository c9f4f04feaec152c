//! Durations of load cases: times, or shares of the time.

use serde::{Deserialize, Serialize};

/// Durations of the cases of a duty cycle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Durations {
    /// Durations by case, not negative, with a positive sum: s, or shares in any unit.
    pub values: Vec<f64>,
    /// True if the durations are times in s, false if they are shares.
    pub are_times: bool,
}

impl Durations {
    /// Returns the total time, s; `None` if the durations are shares.
    pub fn total(&self) -> Option<f64> {
        self.are_times.then(|| self.values.iter().sum())
    }

    /// Returns the shares of the time, which add up to 1.
    pub fn shares(&self) -> Vec<f64> {
        let sum: f64 = self.values.iter().sum();
        self.values.iter().map(|value| value / sum).collect()
    }
}
