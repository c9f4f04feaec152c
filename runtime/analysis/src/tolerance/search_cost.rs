//! Work limit of a tolerance search, known before the search begins.
//!
//! Costs are counted as in [`crate::cost`], but for a machine of fixed rates, so that a search ends
//! at the same setting on every machine.

use super::{Setting, meshes};
use crate::cost::{AnalysisCost, Meshes, Rates, Task};
use crate::estimate::Estimates;
use crate::options::AnalysisOptions;
use crate::scene::Scene;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::observed::OutputRequest;
use std::iter;

/// Rates of the nominal machine, that of `docs/accuracy.md`.
const NOMINAL: Rates = Rates { products: 1e10, logarithms: 2.8e8, threads: 2 };

/// Largest work of a search, in seconds of the nominal machine. A setting that would exceed it is
/// not started, unless it is the first.
pub const MOST_WORK: f64 = 600.0;

/// The work that a search has done, in seconds of the nominal machine.
#[derive(Default)]
pub(super) struct SearchWork {
    done: f64,
    /// Meshes whose structures are in the cache.
    condensed: Vec<(Fidelity, f64)>,
    meshes: Meshes,
}

impl SearchWork {
    /// Returns the fraction of the permitted work that is done.
    pub(super) fn part(&self) -> f64 {
        self.done / MOST_WORK
    }

    /// Adds the work of a setting; returns `None`, and adds nothing, if it would exceed the limit.
    ///
    /// The scene and the options are those of the setting. The tuple contains its refinement, a
    /// factor on that of the model, and the number of positions. The `first` setting has no limit.
    pub(super) fn begin(
        &mut self,
        scene: &Scene,
        outputs: &[OutputRequest],
        options: &AnalysisOptions,
        (refinement, positions): (f64, usize),
        first: bool,
    ) -> Option<()> {
        let AnalysisOptions { fidelity, structure, error_estimates: estimates, highest_frequency, .. } =
            *options;
        let task = Task {
            scene,
            outputs,
            fidelity,
            structure,
            positions,
            in_time: false,
            estimates,
            highest_frequency,
            differentiated: 0,
        };
        // A setting that cannot be planned fails immediately.
        let cost = task.cost_with(&mut self.meshes, &NOMINAL).unwrap_or_default();
        let known = self.condensed.contains(&(fidelity, refinement));
        let work = work_of(&cost, known);
        if !first && self.done + work > MOST_WORK {
            return None;
        }
        self.done += work;
        if !known {
            self.condensed.push((fidelity, refinement));
        }
        Some(())
    }
}

/// Returns the time of an analysis with or without its structures in the cache, s.
fn work_of(cost: &AnalysisCost, kept: bool) -> f64 {
    let structures: f64 = cost.structures.iter().map(|(_, cost)| cost.time).sum();
    cost.time() - if kept { structures } else { 0.0 }
}

/// Setting that a search may try, with its cost.
#[derive(Clone, Debug, PartialEq)]
pub struct CandidateSetting {
    /// Setting with the contact cells and the positions of the model.
    pub setting: Setting,
    /// Time for the comparison at a few positions, s.
    pub few: f64,
    /// Time for all positions, with structures from the comparison, s.
    pub all: f64,
    /// Peak memory, bytes.
    pub memory: f64,
}

/// Returns the settings that a search tries, from cheap to expensive, without refinement of contact
/// grids and positions, with the time of each on a machine of given rates. Fidelities that do not
/// support the scene are skipped.
fn candidates(task: &Task<'_>, few: usize, counted: &mut Meshes, rates: &Rates) -> Vec<CandidateSetting> {
    let levels = iter::once(task.fidelity).chain(task.fidelity.all_above());
    let settings = levels.flat_map(|fidelity| meshes(fidelity).iter().map(move |&mesh| (fidelity, mesh)));
    let mut candidate = |(fidelity, refinement): (Fidelity, f64)| {
        let structure =
            StructureOptions { refinement: refinement * task.structure.refinement, ..task.structure };
        let mut of = |positions: usize| {
            let estimates = Estimates::Full;
            Task { fidelity, structure, positions, estimates, ..*task }.cost_with(counted, rates).ok()
        };
        let [compared, whole] = [of(few.min(task.positions))?, of(task.positions)?];
        let setting = Setting { fidelity, refinement, cells: 1, positions: 1 };
        // The next level is condensed once and cached.
        let [few, all] = [work_of(&compared, false), work_of(&whole, true)];
        Some(CandidateSetting { setting, few, all, memory: whole.memory() })
    };
    settings.filter_map(&mut candidate).collect()
}

/// Cost of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchCost {
    /// Settings from cheap to expensive.
    pub candidates: Vec<CandidateSetting>,
    /// Largest time of the search, s: that of [`MOST_WORK`], or of the first setting if that is
    /// more.
    pub most: f64,
}

/// Predicts the cost of a search on a machine of given rates. The analysis is that of the model,
/// and settings are compared at `few` of its positions.
pub fn search_cost(task: &Task<'_>, few: usize, rates: &Rates) -> SearchCost {
    let mut meshes = Meshes::default();
    let total = |candidates: &[CandidateSetting]| {
        candidates.iter().map(|candidate| candidate.few + candidate.all).sum::<f64>()
    };
    let [here, nominal] = [rates, &NOMINAL].map(|rates| candidates(task, few, &mut meshes, rates));
    let ratio = if total(&nominal) > 0.0 { total(&here) / total(&nominal) } else { 1.0 };
    let first = here.first().map_or(0.0, |candidate| candidate.few + candidate.all);
    SearchCost { most: (MOST_WORK * ratio).max(first), candidates: here }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_does_not_begin_what_is_too_much() {
        let scene = Scene::default();
        let options = AnalysisOptions { error_estimates: Estimates::Full, ..AnalysisOptions::default() };
        let mut work = SearchWork::default();
        assert_eq!(work.begin(&scene, &[], &options, (1.0, 10), false), Some(()));
        let once = work.part();
        assert!(once > 0.0 && once < 1e-3, "{once}");
        // The first setting is always tried, because there is no other way to results.
        work.done = MOST_WORK;
        assert_eq!(work.begin(&scene, &[], &options, (1.0, 10), true), Some(()));
        let done = work.part();
        assert!(done > 1.0);
        assert_eq!(work.begin(&scene, &[], &options, (1.0, 10), false), None);
        assert_eq!(work.part(), done);
    }
}
