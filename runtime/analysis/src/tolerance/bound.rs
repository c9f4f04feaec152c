//! How much a search for a setting may cost, known before it begins.
//!
//! Costs are counted as in [`crate::cost`], but for a machine of fixed rates, so that a search ends at
//! the same setting on every machine.

use super::{Setting, meshes};
use crate::cost::{AnalysisCost, Meshes, Rates, Task};
use crate::estimate::Estimates;
use crate::options::AnalysisOptions;
use crate::scene::Scene;
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::observed::OutputRequest;
use std::iter;

/// The machine whose seconds bound a search: that of `docs/accuracy.md`.
const NOMINAL: Rates = Rates { products: 1e10, logarithms: 2.8e8, threads: 2 };

/// The most work of a search, in seconds of the nominal machine. A setting that would exceed it is
/// not begun, unless it is the first.
pub const MOST_WORK: f64 = 600.0;

/// The work that a search has done, in seconds of the nominal machine.
#[derive(Default)]
pub(super) struct Work {
    done: f64,
    /// Meshes whose structures are kept.
    condensed: Vec<(Fidelity, f64)>,
    meshes: Meshes,
}

impl Work {
    /// The part of the work that a search may do which is done.
    pub(super) fn part(&self) -> f64 {
        self.done / MOST_WORK
    }

    /// Adds the work of a setting; `None`, and nothing is added, if it would be too much.
    ///
    /// The scene and the options are those of the setting; the refinement is a factor on that of the
    /// model, and there are so many positions.
    pub(super) fn begin(
        &mut self,
        scene: &Scene,
        outputs: &[OutputRequest],
        options: &AnalysisOptions,
        (refinement, positions): (f64, usize),
        first: bool,
    ) -> Option<()> {
        let AnalysisOptions { fidelity, structure, error_estimates: estimates, .. } = *options;
        let task = Task { scene, outputs, fidelity, structure, positions, in_time: false, estimates };
        // What cannot be planned fails at once.
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

/// The time of an analysis whose own structures are kept, or are not, s.
fn work_of(cost: &AnalysisCost, kept: bool) -> f64 {
    let structures: f64 = cost.structures.iter().map(|(_, cost)| cost.time).sum();
    cost.time() - if kept { structures } else { 0.0 }
}

/// A setting that a search may try, and what it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// With the contact cells and the positions that the model asks for.
    pub setting: Setting,
    /// Time to compare it at a few positions, s.
    pub few: f64,
    /// Time to analyse all positions with it, structures kept from the comparison, s.
    pub all: f64,
    /// Most memory, bytes.
    pub memory: f64,
}

/// The settings that a search tries, from cheap to dear, while finer contact grids and more
/// positions are not needed; with the time of each on a machine of known rates. Of a fidelity that
/// the scene cannot be modelled with there is none.
fn rungs(task: &Task<'_>, few: usize, counted: &mut Meshes, rates: &Rates) -> Vec<Rung> {
    let levels = iter::once(task.fidelity).chain(task.fidelity.all_above());
    let settings = levels.flat_map(|fidelity| meshes(fidelity).iter().map(move |&mesh| (fidelity, mesh)));
    let mut rung = |(fidelity, refinement): (Fidelity, f64)| {
        let structure =
            StructureOptions { refinement: refinement * task.structure.refinement, ..task.structure };
        let mut of = |positions: usize| {
            let estimates = Estimates::Full;
            Task { fidelity, structure, positions, estimates, ..*task }.cost_with(counted, rates).ok()
        };
        let [compared, whole] = [of(few.min(task.positions))?, of(task.positions)?];
        let setting = Setting { fidelity, refinement, cells: 1, positions: 1 };
        // The level above is condensed once, and kept.
        let [few, all] = [work_of(&compared, false), work_of(&whole, true)];
        Some(Rung { setting, few, all, memory: whole.memory() })
    };
    settings.filter_map(&mut rung).collect()
}

/// What a search may cost.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchCost {
    /// From cheap to dear.
    pub rungs: Vec<Rung>,
    /// The most time that the search takes, s: that of [`MOST_WORK`], or of the first setting if that
    /// is more.
    pub most: f64,
}

/// The cost of a search on a machine of known rates. The analysis is that of the model, and settings
/// are compared at `few` of its positions.
pub fn search_cost(task: &Task<'_>, few: usize, rates: &Rates) -> SearchCost {
    let mut meshes = Meshes::default();
    let total = |rungs: &[Rung]| rungs.iter().map(|rung| rung.few + rung.all).sum::<f64>();
    let [here, nominal] = [rates, &NOMINAL].map(|rates| rungs(task, few, &mut meshes, rates));
    let ratio = if total(&nominal) > 0.0 { total(&here) / total(&nominal) } else { 1.0 };
    let first = here.first().map_or(0.0, |rung| rung.few + rung.all);
    SearchCost { most: (MOST_WORK * ratio).max(first), rungs: here }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_does_not_begin_what_is_too_much() {
        let scene = Scene::default();
        let options = AnalysisOptions { error_estimates: Estimates::Full, ..AnalysisOptions::default() };
        let mut work = Work::default();
        assert_eq!(work.begin(&scene, &[], &options, (1.0, 10), false), Some(()));
        let once = work.part();
        assert!(once > 0.0 && once < 1e-3, "{once}");
        // Whatever the first one takes, there is no other way to results.
        work.done = MOST_WORK;
        assert_eq!(work.begin(&scene, &[], &options, (1.0, 10), true), Some(()));
        let done = work.part();
        assert!(done > 1.0);
        assert_eq!(work.begin(&scene, &[], &options, (1.0, 10), false), None);
        assert_eq!(work.part(), done);
    }
}
