//! Grids of a time step without the cells that stay open.
//!
//! Grids are wide enough for the whole load on one patch, so most of their cells are open while
//! several patches share it. The number of cells determines the time of a step.
//!
//! See [`calyx_contact::solid::LoadedRanges`].

use super::contact_geometry::{Candidate, ContactGeometry, LoadedCells};
use super::contact_layout::Solver;
use super::nonlinear_bearings::NonlinearIteration;
use calyx_contact::active_set::solve_until;
use calyx_contact::problem::{ContactError, Solution};
use calyx_contact::solid::{LoadedRanges, renumbered};
use calyx_numerics::error::EngineError;

/// Grids of the patches of a contact problem.
pub(super) struct ReducedGrids<G> {
    /// Whole grids with the ranges of the problem; `None` if it contains all cells.
    whole: Option<(Vec<G>, Vec<LoadedRanges>)>,
    /// Grids of the problem.
    pub(super) grids: Vec<G>,
    /// Estimate of its active set, if there is one.
    pub(super) estimate: Option<Vec<usize>>,
}

impl<G> ReducedGrids<G> {
    /// Returns the whole grids.
    pub(super) fn into_whole(self) -> Vec<G> {
        self.whole.map_or(self.grids, |(whole, _)| whole)
    }

    /// Returns whether the problem contains all cells.
    pub(super) fn is_whole(&self) -> bool {
        self.whole.is_none()
    }
}

impl<S: ContactGeometry> Solver<'_, S> {
    /// Leaves out the cells that presumably stay open in a time step. The estimate is a contact
    /// problem with one cell for each slice.
    pub(super) fn reduced_grids(
        &self,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        whole: Vec<S::Grid>,
        iteration: Option<&NonlinearIteration>,
    ) -> Result<ReducedGrids<S::Grid>, EngineError> {
        let all = |grids| ReducedGrids { whole: None, grids, estimate: None };
        if !self.under.in_time || whole.is_empty() {
            return Ok(all(whole));
        }
        let Some(slices) = self.slices(&whole) else {
            return Ok(all(whole));
        };
        let (mut problem, ..) = self.problem(load, candidates, &slices, (None, None))?;
        if let (Some(bearings), Some(iteration)) = (self.under.nonlinear, iteration) {
            bearings.put_tangents(&mut problem, iteration, self.under.start);
        }
        let solution = match solve_until(&problem, None, &self.system.interrupt) {
            Ok(solution) => solution,
            Err(error @ ContactError::Interrupted(_)) => return Err(self.explain(&error)),
            // The problem of all cells reports the error.
            Err(_) => return Ok(all(whole)),
        };
        let (mut ranges, mut estimate) = (Vec::with_capacity(whole.len()), Vec::new());
        let (mut left, mut first) = (&solution.forces[..], 0);
        for (grid, slices) in whole.iter().zip(&slices) {
            let (forces, others) = left.split_at(self.space.count(slices));
            left = others;
            let (own, loaded) = self.space.estimated_ranges(grid, forces);
            estimate.extend(loaded.into_iter().map(|cell| first + cell));
            first += own.iter().map(|own| own.len()).sum::<usize>();
            ranges.push(own);
        }
        // Stops of bearings and flanks of splines follow the cells.
        estimate.extend(left.iter().enumerate().filter(|(_, force)| **force > 0.0).map(|(at, _)| first + at));
        Ok(self.of_ranges(whole, ranges, Some(estimate)))
    }

    /// Extends the grids by cells that may carry load after all; returns whether there are any.
    pub(super) fn extend(
        &self,
        candidates: &[&Candidate<S::Site>],
        grids: &mut ReducedGrids<S::Grid>,
        solution: &Solution,
    ) -> bool {
        let Some((whole, ranges)) = &mut grids.whole else { return false };
        let (mut numbers, mut count, mut is_extended) = (Vec::new(), 0, false);
        for (patch, own) in ranges.iter_mut().enumerate() {
            let cells = numbers.len()..numbers.len() + self.space.count(&grids.grids[patch]);
            let loaded = LoadedCells {
                forces: &solution.forces[cells.clone()],
                gaps: &solution.gaps[cells],
                motion: &solution.motion,
            };
            let extended = self.space.extended_ranges(candidates[patch], &whole[patch], own, &loaded);
            is_extended |= extended.is_some();
            let former = std::mem::replace(own, extended.unwrap_or_else(|| own.clone()));
            numbers.extend(renumbered(&former, own).into_iter().map(|cell| count + cell));
            count += own.iter().map(ExactSizeIterator::len).sum::<usize>();
        }
        // Stops of bearings and flanks of splines follow the cells.
        let number =
            |&cell: &usize| numbers.get(cell).copied().unwrap_or_else(|| count + cell - numbers.len());
        let estimate = solution.active.iter().map(number).collect();
        let within = whole.iter().zip(ranges.iter()).map(|(grid, own)| self.space.within_ranges(grid, own));
        if is_extended && let Some(extended) = within.collect::<Option<Vec<_>>>() {
            (grids.grids, grids.estimate) = (extended, Some(estimate));
            return true;
        }
        false
    }

    fn of_ranges(
        &self,
        whole: Vec<S::Grid>,
        ranges: Vec<LoadedRanges>,
        estimate: Option<Vec<usize>>,
    ) -> ReducedGrids<S::Grid> {
        let within = whole.iter().zip(&ranges).map(|(grid, own)| self.space.within_ranges(grid, own));
        match within.collect::<Option<Vec<_>>>() {
            Some(grids) => ReducedGrids { whole: Some((whole, ranges)), grids, estimate },
            None => ReducedGrids { whole: None, grids: whole, estimate: None },
        }
    }
}
