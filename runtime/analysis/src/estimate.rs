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

pub use crate::results::{ErrorEstimate, Part, Statistics};

use crate::observe::Observable;
use crate::results::OutputSummary;
use crate::rows::StepRow;
use crate::summary;
use calyx_model::observed::OutputRequest;
use sampling::Course;
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
