//! Tolerance search: finds the cheapest setting whose estimated error satisfies a tolerance.
//!
//! Settings form a sequence from cheap to expensive: the fidelity levels, and meshes of each. From
//! the start, each solves a few positions with estimates of all errors, including the model error.
//! The first that satisfies the tolerance analyses all positions. The dominant part of the error
//! determines the next change: level, mesh or contact grid. Contact grids are refined first if they
//! alone miss the tolerance, because they are cheapest at a low level, and because this shows early
//! that the tolerance is out of reach of any grid. Fidelity levels that do not support the scene
//! are skipped. The whole analysis has its own estimates; if they miss the tolerance, it is
//! repeated with a better setting. The number of positions is doubled if the variation between them
//! is too large. An output without an error estimate fails the tolerance.
//!
//! Decisions depend on estimates and on counted work ([`mod@search_cost`]), never on times, so they
//! are equal on every machine. A search that would take too much work, or that is interrupted, ends
//! with the best results so far and reports this ([`ToleranceOutcome::ended`]).
//!
//! See `docs/theory/fidelity.md`.

mod best_result;
mod search_cost;

pub use crate::results::{Attempt, SearchProgress, Setting, ToleranceOutcome};
pub use search_cost::{CandidateSetting, MOST_WORK, SearchCost, search_cost};

use crate::analysis::{Event, Observer, quasi_static};
use crate::estimate::Estimates;
use crate::options::AnalysisOptions;
use crate::results::{AnalysisResult, EXHAUSTED, LARGER, OutputSummary, Part, Statistics, percent};
use crate::scene::Scene;
use best_result::Best;
use calyx_model::fidelity::{BodyModel, Fidelity, Template};
use calyx_model::observed::OutputRequest;
use calyx_model::pairs::SurfacePair;
use calyx_model::plan::is_three_dimensional;
use calyx_model::position::Position;
use calyx_numerics::error::EngineError;
use calyx_structure::cache::OperatorCache;
use search_cost::SearchWork;
use std::borrow::Cow;
use std::sync::Arc;

/// Number of positions for the comparison of settings, in addition to named ones.
const SPREAD: usize = 4;
/// Maximum number of doublings of contact grids and of positions.
const DOUBLINGS: u32 = 3;
/// Fraction of the contact grid error that remains after doubling the cells; the estimates assume
/// the same order.
const LEFT_OF_GRID: f64 = 0.3;
/// A part of the error above this fraction of the tolerance is reduced on its own.
const SHARE: f64 = 0.5;
/// Size of the structure cache during the comparison of settings, bytes, if there is no other
/// cache.
const KEPT: usize = 1 << 30;

/// Returns the factors on the elements of a level along every direction, from coarse to fine. In
/// three dimensions a finer template is more effective.
fn meshes(fidelity: Fidelity) -> &'static [f64] {
    match fidelity {
        Fidelity::Rigid | Fidelity::Analytic => &[1.0],
        Fidelity::Plane => &[0.5, 1.0, 2.0],
        Fidelity::Solid(Template::Finest) => &[1.0, 1.4],
        Fidelity::Solid(_) => &[1.0],
    }
}

/// Runs a quasi-static analysis that satisfies a tolerance, relative to the largest magnitude of
/// every output. The search starts with the fidelity of the options. If no setting meets the
/// tolerance, the results are those with the least estimated error, and
/// [`ToleranceOutcome::missed`] is the warning about them.
///
/// # Errors
/// E0791: the tolerance is invalid. E0793: the search ended without results. Those of
/// [`quasi_static`].
pub fn quasi_static_within(
    tolerance: f64,
    scene: &Scene,
    positions: &[Position],
    outputs: &[OutputRequest],
    options: &AnalysisOptions,
    observer: &mut dyn Observer,
) -> Result<AnalysisResult, EngineError> {
    check_tolerance(tolerance)?;
    let mut resources = options.resources.clone();
    resources.cache.get_or_insert_with(|| Arc::new(OperatorCache::new(KEPT)));
    // Rows of an earlier run may belong to another setting.
    let options = AnalysisOptions {
        resources,
        solved: Vec::new(),
        error_estimates: Estimates::Full,
        ..options.clone()
    };
    let refinement = meshes(options.fidelity)[0];
    let setting = Setting { fidelity: options.fidelity, refinement, cells: 1, positions: 1 };
    let levels = options.fidelity.all_above().collect();
    let ladder = Ladder { tolerance, setting, levels };
    let mut search = Search {
        ladder,
        scene,
        outputs,
        options,
        missing: None,
        attempts: Vec::new(),
        work: SearchWork::default(),
        best: None,
        observed: None,
    };
    match search.climb(positions, observer) {
        Ok(result) => Ok(search.with_outcome(result, None)),
        Err(Stop::Failed(error)) => Err(error),
        Err(Stop::Ended(reason, error)) => match search.best.take() {
            Some(best) => {
                best.observed(&search, observer)?;
                search.ladder.setting = best.setting;
                Ok(search.with_outcome(best.result, Some((reason, best.attempt))))
            }
            None => Err(error),
        },
    }
}

/// Checks the tolerance.
///
/// # Errors
/// E0791: it is not between 0 and 1.
pub fn check_tolerance(tolerance: f64) -> Result<(), EngineError> {
    if tolerance > 0.0 && tolerance < 1.0 {
        return Ok(());
    }
    let message = format!("a tolerance cannot be {tolerance} of an output's largest magnitude");
    Err(EngineError::new("E0791", message, "give a part above 0 and below 1, like `tolerance = 2 %`")
        .blame("tolerance"))
}

/// State of a search.
#[derive(Clone, Debug)]
struct Ladder {
    tolerance: f64,
    setting: Setting,
    /// Levels above that of the setting that may support the scene.
    levels: Vec<Fidelity>,
}

/// Search for a setting.
struct Search<'a> {
    ladder: Ladder,
    scene: &'a Scene,
    outputs: &'a [OutputRequest],
    options: AnalysisOptions,
    /// First level that does not support the scene, and the reason.
    missing: Option<(Fidelity, EngineError)>,
    attempts: Vec<Attempt>,
    work: SearchWork,
    /// Results with the smallest estimated error.
    best: Option<Best>,
    /// Index of the attempt whose positions the observer received last.
    observed: Option<usize>,
}

/// Reason for which a search ends without a setting that meets the tolerance.
enum Stop {
    /// There are no results.
    Failed(EngineError),
    /// The search is interrupted, has reached its work limit, or has no setting left: the best
    /// results so far are used. Contains the reason, and the error if there are no results.
    Ended(String, EngineError),
}

impl From<EngineError> for Stop {
    fn from(error: EngineError) -> Stop {
        Stop::Failed(error)
    }
}

/// Observer, with a flag that it ended an analysis.
struct ObserverState<'a> {
    observer: &'a mut dyn Observer,
    refused: bool,
}

impl Observer for ObserverState<'_> {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        let outcome = self.observer.observe(event);
        self.refused |= outcome.is_err();
        outcome
    }
}

/// Errors of a setting by cause, each the largest relative to an output's magnitude.
#[derive(Clone, Copy, Debug)]
struct Shortfall {
    /// True if an output has no value.
    values: bool,
    level: f64,
    /// Model error in excess of the mesh error: the comparison with the next level, which has its
    /// own mesh, includes both.
    beyond_mesh: f64,
    grid: f64,
    between: f64,
}

impl Ladder {
    /// Moves to a better setting according to the errors of this one; false if there is none.
    fn better(&mut self, wanting: Shortfall) -> bool {
        let Shortfall { values, level, beyond_mesh, grid, between } = wanting;
        let Setting { fidelity, refinement, cells, positions } = self.setting;
        let finer = meshes(fidelity).iter().copied().find(|&finer| finer > refinement);
        let next = self.levels.first().copied();
        let worth = SHARE * self.tolerance;
        // Remaining doublings of cells and positions.
        let [cells_left, positions_left] =
            [cells, positions].map(|count| DOUBLINGS.saturating_sub(count.ilog2()));
        let least = grid * LEFT_OF_GRID.powi(cells_left as i32);
        match (finer, next) {
            _ if values => return self.rise(),
            _ if between > worth && positions_left > 0 => self.setting.positions *= 2,
            _ if between > self.tolerance => return false,
            _ if grid.is_finite() && least > self.tolerance => return false,
            _ if grid > self.tolerance && cells_left > 0 => self.setting.cells *= 2,
            (_, Some(_)) if beyond_mesh > self.tolerance => return self.rise(),
            (None, Some(_)) if level > self.tolerance => return self.rise(),
            _ if grid > worth && cells_left > 0 => self.setting.cells *= 2,
            (Some(finer), _) => self.setting.refinement = finer,
            (None, _) => return self.rise(),
        }
        true
    }

    /// Moves to the next level, with its coarsest mesh; false if there is none.
    fn rise(&mut self) -> bool {
        if self.levels.is_empty() {
            return false;
        }
        let fidelity = self.levels.remove(0);
        let Setting { cells, positions, .. } = self.setting;
        self.setting = Setting { fidelity, refinement: meshes(fidelity)[0], cells, positions };
        true
    }
}

impl Search<'_> {
    /// Tries settings from cheap to expensive until one meets the tolerance at all positions.
    fn climb(&mut self, positions: &[Position], observer: &mut dyn Observer) -> Result<AnalysisResult, Stop> {
        let few = few_of(positions);
        let few_are_all = few.len() == positions.len();
        // True if the setting has been compared at a few positions, or need not be.
        let mut compared = few_are_all;
        loop {
            observer.observe(Event::Stage("choosing"))?;
            observer.observe(Event::SearchProgress(&self.choosing(compared)))?;
            if !compared && !self.attempt(&few, false, &mut ())? {
                continue;
            }
            let setting = self.ladder.setting;
            let all = (0..setting.positions.ilog2()).fold(positions.to_vec(), |all, _| doubled(&all));
            if self.attempt(&all, true, observer)?
                && let Some(best) = self.best.take()
            {
                return Ok(best.result);
            }
            // More positions do not change the comparison at a few.
            compared =
                few_are_all || Setting { positions: setting.positions, ..self.ladder.setting } == setting;
        }
    }

    /// Returns the progress of the search.
    fn choosing(&self, whole: bool) -> SearchProgress {
        SearchProgress {
            setting: self.ladder.setting,
            whole,
            best: self.best.as_ref().and_then(|best| self.attempts.get(best.attempt)).cloned(),
            part: self.work.part(),
        }
    }

    /// Analyses with the setting, and stores the results if none are better. Returns true if they
    /// meet the tolerance; otherwise the setting is a better one afterwards.
    fn attempt(
        &mut self,
        positions: &[Position],
        whole: bool,
        observer: &mut dyn Observer,
    ) -> Result<bool, Stop> {
        let Setting { fidelity, refinement, cells, .. } = self.ladder.setting;
        let mut scene = self.scene.clone();
        let three_dimensional = is_three_dimensional(&scene, fidelity);
        for SurfacePair { grid, .. } in scene.pairs.iter_mut().filter(|_| cells > 1) {
            let own = match fidelity {
                Fidelity::Solid(_) => grid.solid_half_cells(),
                Fidelity::Rigid | Fidelity::Analytic | Fidelity::Plane => grid.plane_half_cells(),
            };
            grid.half_cells = Some(cells * own);
            if three_dimensional {
                grid.half_slices *= cells;
            }
        }
        let mut options = AnalysisOptions { fidelity, ..self.options.clone() };
        options.structure.refinement *= refinement;
        if !whole {
            options.fields = 0;
        }
        let first = self.best.is_none();
        if self.work.begin(&scene, self.outputs, &options, (refinement, positions.len()), first).is_none() {
            return Err(Stop::Ended(
                "the next setting would take more work than a search may do".into(),
                self.without_results(),
            ));
        }
        if whole {
            self.observed = Some(self.attempts.len());
        }
        let mut state = ObserverState { observer, refused: false };
        let result = match quasi_static(&scene, positions, self.outputs, &options, &mut state) {
            Err(error) if state.refused => return Err(error.into()),
            Err(error) if options.resources.interrupt.check().is_err() => {
                return Err(Stop::Ended(error.message.clone(), error));
            }
            // A level above the requested one does not support the scene.
            Err(error) if fidelity != self.options.fidelity => {
                return self.pass_over(error).map(|()| false);
            }
            result => result?,
        };

        let several = positions.len() > 1;
        let worst_in = |parts: &[Part]| {
            let of = |summary: &OutputSummary| relative(summary, parts, fidelity, several);
            let all = result.summaries.iter().map(of).enumerate();
            all.fold((0, 0.0), |worst, this| if this.1 > worst.1 { this } else { worst })
        };
        // A few positions do not reveal the variation between them.
        let counted: Vec<Part> =
            Part::ALL.into_iter().filter(|&part| whole || part != Part::Positions).collect();
        let (output, error) = worst_in(&counted);
        let name = self.outputs.get(output).map(|request| request.name.clone()).unwrap_or_default();
        self.attempts.push(Attempt { setting: self.ladder.setting, whole, worst: (name, error) });
        let beyond_mesh = |summary: &OutputSummary| {
            let of = |part: Part| relative(summary, &[part], fidelity, several);
            of(Part::Level) - of(Part::Discretization)
        };
        let wanting = Shortfall {
            values: result.summaries.iter().any(|summary| !summary.max.is_finite()),
            level: worst_in(&[Part::Level]).1,
            beyond_mesh: result.summaries.iter().map(beyond_mesh).fold(0.0, f64::max),
            grid: worst_in(&[Part::ContactGrid]).1,
            between: if whole { worst_in(&[Part::Positions]).1 } else { 0.0 },
        };
        let kept = error <= self.ladder.tolerance;
        let (setting, attempt) = (self.ladder.setting, self.attempts.len() - 1);
        let is_better = |best: &Best| {
            kept || error <= self.attempts[best.attempt].worst.1 || (whole && best.setting == setting)
        };
        if self.best.as_ref().is_none_or(is_better) {
            self.best = Some(Best { result, setting, attempt });
        }
        if kept {
            return Ok(true);
        }
        match self.ladder.better(wanting) {
            true => Ok(false),
            false => Err(self.exhausted()),
        }
    }

    /// Skips the setting's level, which does not support the scene: moves to the next level or, if
    /// there is none, to the finest mesh below.
    fn pass_over(&mut self, error: EngineError) -> Result<(), Stop> {
        let Setting { fidelity, cells, positions, .. } = self.ladder.setting;
        self.missing.get_or_insert((fidelity, error));
        if self.ladder.rise() {
            return Ok(());
        }
        let before = self.attempts.last().map(|attempt| attempt.setting);
        let finer = before.and_then(|Setting { fidelity, refinement, .. }| {
            let refinement = meshes(fidelity).iter().copied().find(|&finer| finer > refinement)?;
            Some(Setting { fidelity, refinement, cells, positions })
        });
        self.ladder.setting = finer.ok_or_else(|| self.exhausted())?;
        Ok(())
    }

    /// Returns the end of a search without a better setting.
    fn exhausted(&self) -> Stop {
        let mut reason = EXHAUSTED.to_owned();
        if let Some((fidelity, error)) = &self.missing {
            let name = fidelity.name();
            reason += &format!(" (\"{name}\" cannot analyze this model: {}: {})", error.code, error.message);
        }
        Stop::Ended(reason, self.without_results())
    }

    /// Returns the error of a search that ends before it has results.
    fn without_results(&self) -> EngineError {
        let tolerance = percent(self.ladder.tolerance);
        let message = format!("there are no results that meet the tolerance of {tolerance}");
        EngineError::new("E0793", message, LARGER).blame("tolerance")
    }

    /// Records in results the setting of their analysis: the last one, or another of those tried,
    /// with the reason.
    fn with_outcome(self, mut result: AnalysisResult, ended: Option<(String, usize)>) -> AnalysisResult {
        let unestimated =
            result.summaries.iter().filter_map(|summary| summary.error.as_ref()).find_map(|error| {
                error
                    .not_estimated
                    .iter()
                    .find(|(part, _)| *part == Part::Level)
                    .map(|(_, reason)| reason.clone())
            });
        let last = self.attempts.len().saturating_sub(1);
        let (ended, selected) = ended.map_or((None, last), |(reason, attempt)| (Some(reason), attempt));
        result.tolerance_search = Some(ToleranceOutcome {
            tolerance: self.ladder.tolerance,
            setting: self.ladder.setting,
            attempts: self.attempts,
            selected,
            ended,
            excluded_model_error: unestimated,
        });
        result
    }
}

/// Returns the largest error of extremes and mean in some parts, relative to the largest magnitude;
/// infinite if unknown. `several` is true if there is more than one position.
fn relative(summary: &OutputSummary, parts: &[Part], fidelity: Fidelity, several: bool) -> f64 {
    // An output without a value fails the tolerance.
    let Some(error) = summary.error.as_ref().filter(|_| summary.max.is_finite() && summary.min.is_finite())
    else {
        return f64::INFINITY;
    };
    let is_missing = |(part, _): &(Part, String)| {
        let needed = match part {
            Part::Discretization | Part::ContactGrid | Part::TimeStep => true,
            // A single position has no variation between positions.
            Part::Positions => several,
            // Only finite element models may lack a comparison with another level; closed-form
            // models need one.
            Part::Level => fidelity.body_model() != BodyModel::Elements,
        };
        needed && parts.contains(part)
    };
    if error.not_estimated.iter().any(is_missing) {
        return f64::INFINITY;
    }
    // A value that consists of rounding satisfies any tolerance.
    if error.is_rounding(summary) {
        return 0.0;
    }
    let Statistics { min, max, mean, .. } = error.within(parts);
    let error = min.max(max).max(mean);
    if error == 0.0 { 0.0 } else { error / summary.max.abs().max(summary.min.abs()) }
}

/// Returns the named positions, where loads jump, and some spread over all.
fn few_of(positions: &[Position]) -> Vec<Position> {
    let spread = |index: usize| (0..SPREAD).any(|k| k * positions.len() / SPREAD == index);
    let wanted = positions.iter().enumerate().filter(|(index, at)| !at.name.is_empty() || spread(*index));
    wanted.map(|(_, position)| position.clone()).collect()
}

/// Inserts a position between any two.
fn doubled(positions: &[Position]) -> Vec<Position> {
    let mut all = Vec::with_capacity(2 * positions.len());
    for pair in positions.windows(2) {
        let [one, other] = [&pair[0], &pair[1]];
        all.push(one.clone());
        // Both sides of a jump keep their distance.
        if one.name.is_empty() || other.name.is_empty() {
            let middle = |of: fn(&Position) -> f64| 0.5 * (of(one) + of(other));
            all.push(Position {
                time: middle(|at| at.time),
                cycle: middle(|at| at.cycle),
                roll: middle(|at| at.roll),
                name: Cow::Borrowed(""),
            });
        }
    }
    all.extend(positions.last().cloned());
    all
}

#[cfg(test)]
mod tests;
