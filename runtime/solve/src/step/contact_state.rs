//! State of contact of a solved position: which cells of which patches carry force. Within one
//! state, the solution depends smoothly on all data, so that derivatives exist; they have kinks
//! where the state changes.

use super::StepResult;
use std::ops::Range;

/// Force, relative to the largest, or gap, relative to the terms of the gap equations, below which
/// a cell is at the boundary between contact and separation.
const DEGENERATE: f64 = 1e-9;

/// Patch of a state of contact, with the size of its grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PatchCells {
    /// Index of the surface pair in the scene.
    pub pair: usize,
    /// Tooth of each body.
    pub teeth: [u32; 2],
    /// Number of cells.
    pub cells: usize,
}

/// State of contact on the grids of a position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridState {
    /// Patches, in order.
    pub patches: Vec<PatchCells>,
    /// Cells of all patches, followed by stops of bearings and spline teeth, that carry force.
    pub active: Vec<usize>,
}

impl GridState {
    /// Returns by patch the cells whose influence coefficients matter: those that carry force,
    /// their neighbours, which take part in the tangent stiffness, and `observed` ones.
    pub(super) fn wanted(&self, observed: impl Fn(usize) -> Vec<Range<usize>>) -> Vec<Vec<bool>> {
        let mut first = 0;
        let mut of_patch = |(index, patch): (usize, &PatchCells)| {
            let mut wanted = vec![false; patch.cells];
            let own = self.active.iter().filter_map(|cell| cell.checked_sub(first));
            for cell in own.filter(|&cell| cell < patch.cells) {
                wanted[cell.saturating_sub(1)..(cell + 2).min(patch.cells)].fill(true);
            }
            observed(index).into_iter().for_each(|cells| wanted[cells].fill(true));
            first += patch.cells;
            wanted
        };
        self.patches.iter().enumerate().map(&mut of_patch).collect()
    }
}

/// State of contact of a solved position.
#[derive(Clone, Debug)]
pub struct ContactState {
    /// Grids that were solved one after the other until their sizes and places were suitable.
    pub grids: Vec<GridState>,
    /// Number of estimates of the position that preceded them.
    pub estimates: usize,
    /// Patches of the solution, in order.
    pub patches: Vec<PatchCells>,
    /// Its cells, followed by stops of bearings and spline teeth, that carry force.
    pub active: Vec<usize>,
}

/// The grids before the last ones do not matter.
impl PartialEq for ContactState {
    fn eq(&self, other: &ContactState) -> bool {
        self.patches == other.patches && self.active == other.active
    }
}

impl StepResult {
    /// Returns the state of contact.
    pub fn contact_state(&self) -> ContactState {
        let patch = |patch: &super::ContactPatch| PatchCells {
            pair: patch.pair,
            teeth: patch.teeth,
            cells: patch.forces.len(),
        };
        let patches = self.patches.iter().map(patch).collect();
        ContactState {
            grids: self.grids.clone(),
            estimates: self.estimates,
            patches,
            active: self.active.clone(),
        }
    }

    /// Returns whether a cell is at the boundary between contact and separation: it touches without
    /// force, so that a small change of the data in one direction loads it, and in the other opens
    /// its gap. Derivatives of the two sides may differ.
    pub fn is_at_change_of_state(&self) -> bool {
        let patches = self.patches.iter().flat_map(|patch| &patch.forces);
        let forces: Vec<f64> = patches.chain(&self.stops).copied().collect();
        if self.problem.gaps.len() != forces.len() {
            return false;
        }
        let relative: Vec<f64> =
            self.motion.iter().enumerate().map(|(k, at)| at - self.start.get(k).unwrap_or(&0.0)).collect();
        let gaps = self.problem.gaps_at(&forces, &relative);
        let largest = |values: &[f64]| values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let (force, gap) = (DEGENERATE * largest(&forces), DEGENERATE * largest(&self.problem.gaps));
        let mut active = vec![false; forces.len()];
        self.active.iter().for_each(|&cell| active[cell] = true);
        let degenerate = |((force_here, gap_here), active): ((&f64, &f64), &bool)| match active {
            true => *force_here <= force,
            false => *gap_here <= gap,
        };
        forces.iter().zip(&gaps).zip(&active).any(degenerate)
    }
}
