//! The perturbed solves of error estimates, counted before an analysis begins: their cost is
//! predicted from the counts.

use super::Estimates;
use super::mesh_variants::MeshVariant;
use super::perturbed_solves::{PART_OF_POSITIONS, SAMPLES, SPREAD, added_positions, refinement_above};
use calyx_model::fidelity::{BodyModel, Fidelity, StructureOptions};

/// Positions of an analysis solved once more, with one setting changed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PerturbedSolve {
    /// Fidelity and mesh; the first that the scene can be modelled with.
    pub models: Vec<(Fidelity, StructureOptions)>,
    /// Positions that are solved, at most.
    pub positions: usize,
    /// True if contact grids have half the cells in every direction.
    pub coarse_grid: bool,
    /// True if the structures are of another mesh than those of the analysis.
    pub condensed: bool,
}

/// The perturbed solves of a quasi-static analysis in two or three dimensions with these numbers of
/// positions and outputs.
pub(crate) fn perturbed_solves_of(
    estimates: Estimates,
    (fidelity, three_dimensional): (Fidelity, bool),
    structure: StructureOptions,
    positions: usize,
    outputs: usize,
) -> Vec<PerturbedSolve> {
    if estimates == Estimates::None || positions == 0 {
        return Vec::new();
    }
    let samples = SAMPLES.max(positions.div_ceil(PART_OF_POSITIONS)).min(positions).min(SPREAD + 2 * outputs);
    let own = vec![(fidelity, structure)];
    let perturbed_solve = |models, positions, coarse_grid, condensed| PerturbedSolve {
        models,
        positions,
        coarse_grid,
        condensed,
    };
    // In three dimensions the extremes at added positions are solved on the coarse grid as well.
    let added = added_positions(positions, fidelity, three_dimensional);
    let extremes = if three_dimensional { added.min(2 * outputs) } else { 0 };
    let mut all = vec![
        perturbed_solve(own.clone(), samples + extremes, true, false),
        perturbed_solve(own, added, false, false),
    ];
    if fidelity.body_model() == BodyModel::Elements {
        let others = MeshVariant::of(fidelity, structure).map(|other| (fidelity, other.structure));
        all.push(perturbed_solve(others.to_vec(), samples, true, true));
    }
    if estimates == Estimates::Full {
        let above = fidelity.all_above().map(|above| {
            let refinement = refinement_above(fidelity, above, structure.refinement);
            (above, StructureOptions { refinement, ..structure })
        });
        all.push(perturbed_solve(above.collect(), samples, false, true));
    }
    all
}
