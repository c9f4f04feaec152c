//! How wrong outputs are: an estimate of the error of every statistic of an output, in parts by what causes it.
//!
//! One mechanism serves all parts that come from solving: *siblings*. A sample of the positions (the extremes of every output among them) is
//! solved once more with one knob turned, everything else equal, and with the order at which outputs converge in that knob the
//! difference tells the error (Richardson's extrapolation; Roache's grid convergence index has a factor of safety besides, as here).
//! Siblings are coarser than the run they judge, so they cost a part of it: a mesh of half as many elements along every direction, a
//! contact grid of half as many cells. Only the level above, which tells what the model itself leaves out, costs more than the run.
//! A motion in time is gone through once more in steps twice as long ([`in_time`]).
//! What lies between positions is told by the positions and by a few more between them ([`sampling`]). Values that are nothing but rounding are
//! known by the sizes of the scene ([`rounding`]).
//!
//! Orders and factors are measured (`cargo bench -p calyx-gears --bench convergence`), and what comes of them is tested: estimate over true
//! error, the effectivity (`stdlib-gears/tests/estimates.rs`).

mod besides;
mod continuation;
mod in_time;
mod rounding;
mod sampling;
mod siblings;

pub(crate) use besides::{Sibling, siblings_of};
pub(crate) use in_time::Moved;
pub(crate) use rounding::of_outputs as rounding_of;
pub(crate) use siblings::{Judged, quasi_static_siblings};

use crate::observe::Observable;
use crate::results::{OutputRequest, OutputSummary, StepRow};
use crate::summary;
use sampling::Course;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Which errors an analysis estimates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Estimates {
    /// None.
    #[default]
    None,
    /// Those that cost less than the run: all but what the level leaves out.
    Cheap,
    /// That too, by the level above, which costs more than the run.
    Full,
}

impl Estimates {
    /// With their names, as models give them.
    pub const ALL: [(&'static str, Estimates); 3] =
        [("none", Estimates::None), ("cheap", Estimates::Cheap), ("full", Estimates::Full)];

    /// As models call it.
    pub fn name(self) -> &'static str {
        Estimates::ALL.into_iter().find(|(_, known)| *known == self).map_or("", |(name, _)| name)
    }

    /// By its name.
    pub fn named(name: &str) -> Option<Estimates> {
        Estimates::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, estimates)| estimates)
    }
}

/// Of fewer positions nothing is known between them.
const FEWEST: usize = 3;

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
    const NONE: Statistics =
        Statistics { min: f64::NAN, max: f64::NAN, mean: f64::NAN, peak_to_peak: f64::NAN };

    fn is_finite(&self) -> bool {
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

    fn times(self, factor: f64) -> Statistics {
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
    fn new(
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

/// A part of the error that siblings told, or why they did not.
pub(crate) struct Found {
    pub part: Part,
    /// One per output.
    pub errors: Result<Vec<Statistics>, String>,
}

/// What errors are estimated by.
#[derive(Default)]
pub(crate) struct Evidence {
    /// What siblings told.
    pub found: Vec<Found>,
    /// The rows of the analysis, and others between them; or none.
    pub rows: Vec<StepRow>,
    /// By output: magnitude up to which it may be nothing but rounding. Empty where that is not known.
    pub rounding: Vec<f64>,
}

/// Puts estimates into the summaries: what siblings found, and what lies between the rows.
pub(crate) fn attach(
    summaries: &mut [OutputSummary],
    rows: &[StepRow],
    outputs: &[OutputRequest],
    observables: &[Arc<dyn Observable>],
    evidence: &Evidence,
) {
    let Evidence { found, rows: more, rounding } = evidence;
    // What is closed, and what is not, goes on behind the last row or does not.
    let known = [false, true].map(|closed| within(if more.is_empty() { rows } else { more }, rows, closed));
    for (index, (summary, request)) in summaries.iter_mut().zip(outputs).enumerate() {
        let closed = summary::is_closed(rows, request, observables);
        let known = known[usize::from(closed)];
        let between = match (Course::of(rows, Some(index)), Course::of(known, Some(index))) {
            (Some(_), Some(_)) if known.len() < FEWEST => {
                Err("between two positions none could be solved to see what lies there".to_owned())
            }
            (Some(course), Some(finer)) => {
                Ok(course.errors(&ends(rows, index), (&finer, &ends(known, index)), closed))
            }
            _ => Err("the positions do not go anywhere".to_owned()),
        };
        let own = |Found { part, errors }: &Found| {
            let error = errors.as_ref().map(|errors| errors.get(index).copied().unwrap_or(Statistics::NONE));
            (*part, error.map_err(String::clone))
        };
        let mut all: Vec<(Part, Result<Statistics, String>)> = found.iter().map(own).collect();
        all.push((Part::Positions, between));
        all.sort_by_key(|(part, _)| *part);
        let mut parts = Vec::new();
        let mut not_estimated = Vec::new();
        for (part, error) in all {
            match error {
                Ok(error) if error.is_finite() => parts.push((part, error)),
                Ok(_) => not_estimated.push((part, "not all values are finite".to_owned())),
                Err(reason) => not_estimated.push((part, reason)),
            }
        }
        let rounding = rounding.get(index).copied().unwrap_or(0.0);
        summary.error = Some(ErrorEstimate::new(parts, not_estimated, rounding));
    }
}

/// Of rows and others between them those that belong to a course which ends where the rows end, unless it is closed.
fn within<'r>(all: &'r [StepRow], rows: &[StepRow], closed: bool) -> &'r [StepRow] {
    let Some(last) = rows.last().filter(|_| !closed) else { return all };
    let behind = all.iter().rev().take_while(|row| row.position != last.position).count();
    &all[..all.len() - behind]
}

/// A value of an output with the ends of its range, where it has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ends {
    pub value: f64,
    pub low: f64,
    pub high: f64,
}

/// Of an output, by row.
pub(crate) fn ends(rows: &[StepRow], output: usize) -> Vec<Ends> {
    let of = |row: &StepRow| {
        let seen = &row.outputs[output];
        let least = seen.least.unwrap_or(seen.value);
        Ends { value: seen.value, low: seen.value.min(least), high: seen.value.max(least) }
    };
    rows.iter().map(of).collect()
}

/// Whether stresses go into an output: they converge more slowly than deflections and forces do.
pub(crate) fn is_stress(request: &OutputRequest, observables: &[Arc<dyn Observable>]) -> bool {
    let stressed = |index: usize| observables.get(index).is_some_and(|seen| seen.stresses_of().is_some());
    request.value.observes().into_iter().any(stressed)
}

#[cfg(test)]
mod tests;
