//! Error estimates of the statistics of outputs, in parts by their cause.
//!
//! One mechanism serves all parts that concern the solution: *perturbed solves*. A sample of the
//! positions, which includes the extremes of every output, is solved again with one setting
//! changed. With the order of convergence in that setting, the difference determines the error
//! (Richardson extrapolation; Roache's grid convergence index has a factor of safety in addition,
//! as here). Perturbed solves are coarser than the analysis and cost a part of it: a mesh of half
//! as many elements along every direction, a contact grid of half as many cells. Only the next
//! fidelity level, which estimates the model error, costs more than the analysis. A transient
//! analysis is repeated with steps of twice the length ([`time_integration`]). The error between
//! positions is estimated from the positions and from a few more between them ([`sampling`]).
//! Values that consist of rounding are identified from the scales of the scene ([`rounding`]).
//!
//! Orders and factors are measured (`cargo bench -p calyx-gears --bench convergence`). Tests check
//! the effectivity, the ratio of estimated to true error (`stdlib-gears/tests/estimates.rs`). See
//! `docs/theory/error-estimates.md`.

mod bounds;
mod continuation;
mod mesh_variants;
mod perturbed_solve_count;
mod perturbed_solves;
mod rounding;
mod sampling;
mod time_integration;

pub(crate) use perturbed_solve_count::{PerturbedSolve, perturbed_solves_of};
pub(crate) use perturbed_solves::{BaseAnalysis, quasi_static_perturbed_solves};
pub(crate) use rounding::of_outputs as rounding_of;
pub(crate) use time_integration::BaseMotion;

pub use crate::results::{ErrorEstimate, Part, Statistics};

use crate::observables::Observable;
use crate::results::{DirectedErrors, OutputSummary};
use crate::rows::StepRow;
use crate::scene::Scene;
use crate::summary;
use calyx_model::observed::OutputRequest;
use sampling::SamplingContext;
use std::sync::Arc;

/// Selection of the errors that an analysis estimates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Estimates {
    /// None.
    #[default]
    None,
    /// Those that cost less than the analysis: all except the model error.
    Cheap,
    /// All, including the model error from the next fidelity level, which costs more than the
    /// analysis.
    Full,
}

impl Estimates {
    /// All with their names in the language.
    pub const ALL: [(&'static str, Estimates); 3] =
        [("none", Estimates::None), ("cheap", Estimates::Cheap), ("full", Estimates::Full)];

    /// Returns the name in the language.
    pub fn name(self) -> &'static str {
        Estimates::ALL.into_iter().find(|(_, known)| *known == self).map_or("", |(name, _)| name)
    }

    /// Returns the selection of a name.
    pub fn named(name: &str) -> Option<Estimates> {
        Estimates::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, estimates)| estimates)
    }
}

/// Number of positions below which the error between them is unknown.
const FEWEST: usize = 3;

/// Part of the error from perturbed solves, or the reason why it is missing.
pub(crate) struct ErrorPart {
    pub part: Part,
    /// Errors by output.
    pub errors: Result<Vec<DirectedErrors>, String>,
}

/// Data for the error estimates.
#[derive(Default)]
pub(crate) struct Evidence {
    /// Parts from perturbed solves.
    pub found: Vec<ErrorPart>,
    /// Rows of the analysis with others between them; may be empty.
    pub rows: Vec<StepRow>,
    /// Magnitude up to which an output may consist of rounding, by output. Empty if unknown.
    pub rounding: Vec<f64>,
}

/// Writes estimates into the summaries: those of perturbed solves, and those of the variation
/// between rows.
pub(crate) fn attach(
    summaries: &mut [OutputSummary],
    rows: &[StepRow],
    outputs: &[OutputRequest],
    scene: &Scene,
    evidence: &Evidence,
) {
    let Evidence { found, rows: more, rounding } = evidence;
    // A closed curve continues after the last row, an open one does not.
    let known = [false, true].map(|closed| within(if more.is_empty() { rows } else { more }, rows, closed));
    for (index, (summary, request)) in summaries.iter_mut().zip(outputs).enumerate() {
        let closed = summary::is_closed(rows, request, scene);
        let known = known[usize::from(closed)];
        let between = match (SamplingContext::of(rows, Some(index)), SamplingContext::of(known, Some(index)))
        {
            (Some(_), Some(_)) if known.len() < FEWEST => {
                Err("between two positions none could be solved to see what lies there".to_owned())
            }
            (Some(course), Some(finer)) => {
                let own = ends(rows, index);
                let errors = course.errors(&own, (&finer, &ends(known, index)), closed);
                let size = bounds::within(errors.size, &own, bounds::of(request, &scene.observables));
                Ok(DirectedErrors { size, ..errors })
            }
            _ => Err("the positions do not go anywhere".to_owned()),
        };
        let own = |ErrorPart { part, errors }: &ErrorPart| {
            let error =
                errors.as_ref().map(|errors| errors.get(index).copied().unwrap_or(DirectedErrors::NONE));
            (*part, error.map_err(String::clone))
        };
        let mut all: Vec<(Part, Result<DirectedErrors, String>)> = found.iter().map(own).collect();
        all.push((Part::Positions, between));
        all.sort_by_key(|(part, _)| *part);
        let mut parts = Vec::new();
        let mut not_estimated = Vec::new();
        for (part, error) in all {
            match error {
                Ok(error) if error.size.is_finite() => parts.push((part, error)),
                Ok(_) => not_estimated.push((part, "not all values are finite".to_owned())),
                Err(reason) => not_estimated.push((part, reason)),
            }
        }
        let rounding = rounding.get(index).copied().unwrap_or(0.0);
        summary.error = Some(ErrorEstimate::new(parts, not_estimated, rounding));
    }
}

/// Returns the rows within the range of the analysis, from all rows including those between; all if
/// the curve is closed.
fn within<'r>(all: &'r [StepRow], rows: &[StepRow], closed: bool) -> &'r [StepRow] {
    let Some(last) = rows.last().filter(|_| !closed) else { return all };
    let behind = all.iter().rev().take_while(|row| row.position != last.position).count();
    &all[..all.len() - behind]
}

/// Value of an output with the ends of its range, if it has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ends {
    pub value: f64,
    pub low: f64,
    pub high: f64,
}

/// Returns the values of an output by row.
pub(crate) fn ends(rows: &[StepRow], output: usize) -> Vec<Ends> {
    let of = |row: &StepRow| {
        let seen = &row.outputs[output];
        let least = seen.least.unwrap_or(seen.value);
        Ends { value: seen.value, low: seen.value.min(least), high: seen.value.max(least) }
    };
    rows.iter().map(of).collect()
}

/// Returns whether an output depends on stresses, which converge more slowly than deflections and
/// forces.
pub(crate) fn is_stress(request: &OutputRequest, observables: &[Arc<dyn Observable>]) -> bool {
    let stressed = |index: usize| observables.get(index).is_some_and(|seen| seen.stresses_of().is_some());
    request.value.observes().into_iter().any(stressed)
}

/// Returns whether an output depends on pressures on flanks, and neither on stresses nor on forces.
pub(crate) fn is_flank_pressure(request: &OutputRequest, observables: &[Arc<dyn Observable>]) -> bool {
    let observed = request.value.observes();
    let is_pressure = |index: usize| observables.get(index).is_some_and(|seen| seen.is_flank_pressure());
    !observed.is_empty() && observed.into_iter().all(is_pressure)
}

#[cfg(test)]
mod tests;
