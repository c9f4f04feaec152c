//! Estimated errors of the statistics of an output, in parts by their cause.

use super::OutputSummary;
use serde::{Deserialize, Serialize};

/// Cause of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// Finite element discretization of bodies.
    Discretization,
    /// Contact grid.
    ContactGrid,
    /// Variation between the solved positions.
    Positions,
    /// Model error of the fidelity level, as far as the next level includes the effect.
    Level,
    /// Time steps.
    TimeStep,
}

impl Part {
    /// All parts.
    pub const ALL: [Part; 5] =
        [Part::Discretization, Part::ContactGrid, Part::Positions, Part::Level, Part::TimeStep];

    /// Returns the name in results.
    pub fn name(self) -> &'static str {
        match self {
            Part::Discretization => "discretization",
            Part::ContactGrid => "contact_grid",
            Part::Positions => "positions",
            Part::Level => "level",
            Part::TimeStep => "time_step",
        }
    }

    /// Returns the title for readers.
    pub fn title(self) -> &'static str {
        match self {
            Part::Discretization => "mesh",
            Part::ContactGrid => "contact grid",
            Part::Positions => "positions",
            Part::Level => "fidelity level",
            Part::TimeStep => "time step",
        }
    }
}

/// Magnitudes of the errors of an output's statistics, SI.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Error of the smallest value.
    pub min: f64,
    /// Error of the largest value.
    pub max: f64,
    /// Error of the mean.
    pub mean: f64,
    /// Error of the difference between the largest and the smallest value.
    pub peak_to_peak: f64,
}

impl Statistics {
    /// Errors of NaN values.
    pub(crate) const NONE: Statistics =
        Statistics { min: f64::NAN, max: f64::NAN, mean: f64::NAN, peak_to_peak: f64::NAN };

    pub(crate) fn is_finite(&self) -> bool {
        [self.min, self.max, self.mean, self.peak_to_peak].iter().all(|error| error.is_finite())
    }

    fn with(self, other: Statistics, combine: impl Fn(f64, f64) -> f64) -> Statistics {
        Statistics {
            min: combine(self.min, other.min),
            max: combine(self.max, other.max),
            mean: combine(self.mean, other.mean),
            peak_to_peak: combine(self.peak_to_peak, other.peak_to_peak),
        }
    }

    pub(crate) fn times(self, factor: f64) -> Statistics {
        Statistics {
            min: factor * self.min,
            max: factor * self.max,
            mean: factor * self.mean,
            peak_to_peak: factor * self.peak_to_peak,
        }
    }
}

/// Estimated error of an output.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorEstimate {
    /// Estimated parts, in the order of [`Part::ALL`].
    pub parts: Vec<(Part, Statistics)>,
    /// Total: the sum of the parts, with the larger of mesh error and model error, because the next
    /// fidelity level includes both.
    pub total: Statistics,
    /// Parts that exist but were not estimated, with the reason.
    pub not_estimated: Vec<(Part, String)>,
    /// Magnitude up to which a value may consist of rounding, SI.
    pub rounding: f64,
}

impl ErrorEstimate {
    pub(crate) fn new(
        parts: Vec<(Part, Statistics)>,
        not_estimated: Vec<(Part, String)>,
        rounding: f64,
    ) -> ErrorEstimate {
        let mut estimate = ErrorEstimate { parts, total: Statistics::default(), not_estimated, rounding };
        estimate.total = estimate.within(&Part::ALL);
        estimate
    }

    /// Returns the total of some parts, as in [`ErrorEstimate::total`].
    pub fn within(&self, wanted: &[Part]) -> Statistics {
        let part = |one: Part| {
            let own = self.parts.iter().find(|(part, _)| *part == one && wanted.contains(part));
            own.map_or(Statistics::default(), |(_, error)| *error)
        };
        let model = part(Part::Discretization).with(part(Part::Level), f64::max);
        let others = [Part::ContactGrid, Part::Positions, Part::TimeStep].map(part);
        others.into_iter().fold(model, |sum, error| sum.with(error, |a, b| a + b))
    }

    /// Returns whether the model error of the fidelity level is included. Without it the estimate
    /// is the numerical error alone: the difference from the result of the same level with finer
    /// meshes and contact grids, more positions and shorter steps.
    pub fn includes_level(&self) -> bool {
        self.parts.iter().any(|(part, _)| *part == Part::Level)
    }

    /// Returns whether an output consists of rounding: both its values and their errors.
    pub fn is_rounding(&self, summary: &OutputSummary) -> bool {
        let Statistics { min, max, mean, .. } = self.total;
        let all = [summary.max, summary.min, max, min, mean];
        all.iter().all(|value| value.abs() <= self.rounding) && all.iter().any(|&value| value != 0.0)
    }

    /// Returns the error of the value of largest magnitude.
    pub fn of_largest(&self, summary: &OutputSummary) -> f64 {
        if summary.max.abs() >= summary.min.abs() { self.total.max } else { self.total.min }
    }

    /// Returns the relative error of that value; `None` if the value consists of rounding, unless
    /// it is exactly zero, or if no error is known.
    pub fn relative(&self, summary: &OutputSummary) -> Option<f64> {
        let (magnitude, error) = (summary.max.abs().max(summary.min.abs()), self.of_largest(summary));
        if self.parts.is_empty() || !(summary.max.is_finite() && summary.min.is_finite()) {
            return None;
        }
        match magnitude > self.rounding {
            true => Some(error / magnitude).filter(|part| part.is_finite()),
            false => (magnitude == 0.0 && error == 0.0).then_some(0.0),
        }
    }
}
