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

    /// Evaluates a function of each statistic.
    pub(crate) fn of_each(value: impl Fn(fn(&Statistics) -> f64) -> f64) -> Statistics {
        Statistics {
            min: value(|of| of.min),
            max: value(|of| of.max),
            mean: value(|of| of.mean),
            peak_to_peak: value(|of| of.peak_to_peak),
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

/// Magnitudes and directions of the errors of an output's statistics.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct DirectedErrors {
    /// Magnitudes.
    pub size: Statistics,
    /// 1 if the value is too large, -1 if it is too small, 0 if the direction is unknown.
    pub direction: Statistics,
}

impl DirectedErrors {
    /// Errors of NaN values.
    pub const NONE: DirectedErrors = DirectedErrors { size: Statistics::NONE, direction: Statistics::NONE };

    /// Creates errors from magnitudes and the parts of them that have a direction. The direction
    /// counts as known if that part is no smaller than the rest, in quadrature.
    pub fn new(size: Statistics, directed: Statistics) -> DirectedErrors {
        let direction = Statistics::of_each(|of| {
            let (size, directed) = (of(&size), of(&directed));
            let rest = size * size - directed * directed;
            if directed != 0.0 && directed * directed >= rest { directed.signum() } else { 0.0 }
        });
        DirectedErrors { size, direction }
    }

    /// Replaces the errors that are smaller than these signed ones.
    pub fn at_least(self, signed: Statistics) -> DirectedErrors {
        let choose = |old: fn(&DirectedErrors) -> &Statistics, new: fn(f64) -> f64| {
            Statistics::of_each(|of| {
                let is_larger = of(&signed).abs() > of(&self.size);
                if is_larger { new(of(&signed)) } else { of(old(&self)) }
            })
        };
        DirectedErrors {
            size: choose(|own| &own.size, f64::abs),
            direction: choose(|own| &own.direction, f64::signum),
        }
    }

    /// Multiplies the magnitudes by one factor and the directions by another one, which is 1, -1 or
    /// 0.
    pub fn times(self, factor: f64, direction: f64) -> DirectedErrors {
        let directions = Statistics::of_each(|of| direction * of(&self.direction));
        DirectedErrors { size: self.size.times(factor), direction: directions }
    }
}

impl From<Statistics> for DirectedErrors {
    /// Errors of unknown direction.
    fn from(size: Statistics) -> DirectedErrors {
        DirectedErrors { size, direction: Statistics::default() }
    }
}

/// Standard deviation of the error of a part relative to its mean: 0.50 over the 229 statistics of
/// the effectivity suite and its hold-out in which one part exceeds four times the others.
const UNCERTAINTY: f64 = 0.5;

/// Returns the root mean square of the sum of two signed errors. Each is given by its own root mean
/// square, and has the relative standard uncertainty [`UNCERTAINTY`].
fn resultant(one: f64, other: f64) -> f64 {
    let square = UNCERTAINTY * UNCERTAINTY;
    let sum = (one + other).powi(2) + square * (one * one + other * other);
    (sum / (1.0 + square)).sqrt()
}

/// Estimated error of an output.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorEstimate {
    /// Estimated parts, in the order of [`Part::ALL`].
    pub parts: Vec<(Part, Statistics)>,
    /// Total. Mesh, grid, level and time step change the same solution: those of known direction
    /// span an interval, to whose ends the error between positions is added with its sign, and the
    /// larger end counts. Parts of unknown direction are added in quadrature. The errors of the
    /// solution may have a common cause, so the total is no less than the larger end of the
    /// interval that they span alone, those of unknown direction at both ends. Of mesh error and
    /// model error the larger one counts, because the next fidelity level includes both.
    pub total: Statistics,
    /// Parts that exist but were not estimated, with the reason.
    pub not_estimated: Vec<(Part, String)>,
    /// Magnitude up to which a value may consist of rounding, SI.
    pub rounding: f64,
    /// Directions of the parts, in their order; those that are missing are unknown.
    pub(crate) directions: Vec<Statistics>,
}

impl ErrorEstimate {
    pub(crate) fn new(
        parts: Vec<(Part, DirectedErrors)>,
        not_estimated: Vec<(Part, String)>,
        rounding: f64,
    ) -> ErrorEstimate {
        let directions = parts.iter().map(|(_, errors)| errors.direction).collect();
        let parts = parts.into_iter().map(|(part, errors)| (part, errors.size)).collect();
        let total = Statistics::default();
        let mut estimate = ErrorEstimate { parts, total, not_estimated, rounding, directions };
        estimate.total = estimate.within(&Part::ALL);
        estimate
    }

    /// Returns the total of some parts, as in [`ErrorEstimate::total`].
    pub fn within(&self, wanted: &[Part]) -> Statistics {
        let part = |one: Part| {
            let own = self.parts.iter().position(|(part, _)| *part == one && wanted.contains(part));
            own.map_or(DirectedErrors::default(), |own| DirectedErrors {
                size: self.parts[own].1,
                direction: self.directions.get(own).copied().unwrap_or_default(),
            })
        };
        let all = Part::ALL.map(part);
        Statistics::of_each(|of| {
            let [mesh, grid, positions, level, step] =
                all.map(|errors| (of(&errors.size), of(&errors.direction)));
            let model = if level.0 > mesh.0 { level } else { mesh };
            let solution = [model, grid, step];
            // Larger end of the interval that the parts of the solution span, with positions.
            let interval = |unknown_too: bool| {
                let end = |sign: f64| -> f64 {
                    let extends =
                        |direction: f64| sign * direction > 0.0 || (unknown_too && direction == 0.0);
                    solution.iter().filter(|part| extends(part.1)).map(|part| part.0).sum()
                };
                let beside = |sign: f64| sign * positions.0 * positions.1;
                let with_positions = |sign: f64| match (end(sign), beside(sign)) {
                    // The other end counts if all parts of the solution have its direction.
                    (0.0, _) if end(-sign) > 0.0 => 0.0,
                    // Positions are independent of the solution: they only compensate a part of it.
                    (size, beside) if unknown_too && beside > 0.0 => size,
                    (size, beside) => resultant(size, beside),
                };
                with_positions(1.0).max(with_positions(-1.0))
            };
            let unknown = [model, grid, step, positions].into_iter().filter(|part| part.1 == 0.0);
            let independent = unknown.map(|part| part.0).fold(interval(false), f64::hypot);
            independent.max(interval(true))
        })
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
