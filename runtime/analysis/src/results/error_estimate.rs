//! Estimated errors of the statistics of an output, in parts by their cause.

use super::OutputSummary;
use serde::{Deserialize, Serialize};

/// What causes an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// Finite elements of bodies.
    Discretization,
    /// Cells of contact.
    ContactGrid,
    /// What lies between the positions that were solved.
    Positions,
    /// What the level of the model leaves out, as far as the level above has it.
    Level,
    /// Steps in time.
    TimeStep,
}

impl Part {
    /// All of them.
    pub const ALL: [Part; 5] =
        [Part::Discretization, Part::ContactGrid, Part::Positions, Part::Level, Part::TimeStep];

    /// As results call it.
    pub fn name(self) -> &'static str {
        match self {
            Part::Discretization => "discretization",
            Part::ContactGrid => "contact_grid",
            Part::Positions => "positions",
            Part::Level => "level",
            Part::TimeStep => "time_step",
        }
    }

    /// As people read it.
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
    /// Of the least value.
    pub min: f64,
    /// Of the largest value.
    pub max: f64,
    /// Of the mean.
    pub mean: f64,
    /// Of the largest less the least.
    pub peak_to_peak: f64,
}

impl Statistics {
    /// Of values that are no numbers.
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

/// How wrong an output probably is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorEstimate {
    /// Each part that was estimated, in the order of [`Part::ALL`].
    pub parts: Vec<(Part, Statistics)>,
    /// All parts together: their sum, of the mesh and the level above, which sees both, the larger.
    pub total: Statistics,
    /// Parts that exist and were not estimated, with the reason.
    pub not_estimated: Vec<(Part, String)>,
    /// Magnitude up to which a value may be nothing but rounding, SI.
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

    /// What some parts come to together, as in [`ErrorEstimate::total`].
    pub fn within(&self, wanted: &[Part]) -> Statistics {
        let part = |one: Part| {
            let own = self.parts.iter().find(|(part, _)| *part == one && wanted.contains(part));
            own.map_or(Statistics::default(), |(_, error)| *error)
        };
        let model = part(Part::Discretization).with(part(Part::Level), f64::max);
        let others = [Part::ContactGrid, Part::Positions, Part::TimeStep].map(part);
        others.into_iter().fold(model, |sum, error| sum.with(error, |a, b| a + b))
    }

    /// Whether the error of the fidelity level itself is part of it. Without it the estimate is of the numerical error alone: how far the
    /// result is from what the same level gives with finer meshes and contact grids, more positions and shorter steps.
    pub fn includes_level(&self) -> bool {
        self.parts.iter().any(|(part, _)| *part == Part::Level)
    }

    /// Whether an output is nothing but rounding: its values, and all that they may be off by.
    pub fn is_rounding(&self, summary: &OutputSummary) -> bool {
        let Statistics { min, max, mean, .. } = self.total;
        let all = [summary.max, summary.min, max, min, mean];
        all.iter().all(|value| value.abs() <= self.rounding) && all.iter().any(|&value| value != 0.0)
    }

    /// The error of the value of largest magnitude.
    pub fn of_largest(&self, summary: &OutputSummary) -> f64 {
        if summary.max.abs() >= summary.min.abs() { self.total.max } else { self.total.min }
    }

    /// The same as a part of that value; `None` where the value is no more than rounding, unless it is exactly nothing, and where nothing is known.
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
