//! Grids of a time step without the cells that stay open.
//!
//! Grids are wide enough for the whole load on one patch, so most of their cells are open while
//! several patches share it. The number of cells determines the time of a step.
//!
//! See [`calyx_contact::solid::LoadedZone`].

use super::contact_geometry::{Candidate, ContactGeometry, LoadedCells};
use super::contact_layout::Solver;
use super::nonlinear_bearings::NonlinearIteration;
use calyx_contact::active_set::solve_until;
use calyx_contact::problem::{ContactError, Solution};
use calyx_contact::solid::LoadedZone;
use calyx_numerics::error::EngineError;

/// Grids of the patches of a contact problem.
pub(super) struct ZoneGrids<G> {
    /// Whole grids with the zones of the problem; `None` if it contains all cells.
    whole: Option<(Vec<G>, Vec<LoadedZone>)>,
    /// Grids of the problem.
    pub(super) grids: Vec<G>,
    /// Estimate of its active set, if there is one.
    pub(super) estimate: Option<Vec<usize>>,
}

impl<G> ZoneGrids<G> {
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
    pub(super) fn zone_grids(
        &self,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        whole: Vec<S::Grid>,
        iteration: Option<&NonlinearIteration>,
    ) -> Result<ZoneGrids<S::Grid>, EngineError> {
        let all = |grids| ZoneGrids { whole: None, grids, estimate: None };
        let coarse = |grid| self.space.with_a_cell_for_each_slice(grid);
        let Some(slices) =
            whole.iter().map(coarse).collect::<Option<Vec<_>>>().filter(|_| self.under.in_time)
        else {
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
        let (mut zones, mut estimate) = (Vec::with_capacity(whole.len()), Vec::new());
        let (mut left, mut first) = (&solution.forces[..], 0);
        for (grid, slices) in whole.iter().zip(&slices) {
            let (forces, others) = left.split_at(self.space.count(slices));
            left = others;
            let (zone, loaded) = self.space.estimated_zone(grid, forces);
            estimate.extend(loaded.into_iter().map(|cell| first + cell));
            first += zone.iter().map(|own| own.len()).sum::<usize>();
            zones.push(zone);
        }
        // Stops of bearings and flanks of splines follow the cells.
        estimate.extend(left.iter().enumerate().filter(|(_, force)| **force > 0.0).map(|(at, _)| first + at));
        Ok(self.of_zones(whole, zones, Some(estimate)))
    }

    /// Extends the grids by cells that may carry load after all; returns whether there are any.
    pub(super) fn extend(
        &self,
        candidates: &[&Candidate<S::Site>],
        grids: &mut ZoneGrids<S::Grid>,
        solution: &Solution,
    ) -> bool {
        let Some((whole, zones)) = &mut grids.whole else { return false };
        let (mut end, mut is_extended) = (0, false);
        let (mut estimate, mut first) = (Vec::new(), 0);
        let mut active = solution.active.iter().copied().peekable();
        for (patch, zone) in zones.iter_mut().enumerate() {
            let own = end..end + self.space.count(&grids.grids[patch]);
            let loaded = LoadedCells {
                forces: &solution.forces[own.clone()],
                gaps: &solution.gaps[own.clone()],
                motion: &solution.motion,
            };
            let extended = self.space.extended_zone(candidates[patch], &whole[patch], zone, &loaded);
            is_extended |= extended.is_some();
            let former = std::mem::replace(zone, extended.unwrap_or_else(|| zone.clone()));
            // Number the active cells as in the extended zone.
            let mut before = own.start;
            for (former, own) in former.iter().zip(zone.iter()) {
                while let Some(cell) = active.next_if(|&cell| cell < before + former.len()) {
                    estimate.push(first + (former.start - own.start) + (cell - before));
                }
                (before, first) = (before + former.len(), first + own.len());
            }
            end = own.end;
        }
        estimate.extend(active.map(|stop| stop - end + first));
        let within = whole.iter().zip(zones.iter()).map(|(grid, zone)| self.space.within_zone(grid, zone));
        if is_extended && let Some(extended) = within.collect::<Option<Vec<_>>>() {
            (grids.grids, grids.estimate) = (extended, Some(estimate));
            return true;
        }
        false
    }

    fn of_zones(
        &self,
        whole: Vec<S::Grid>,
        zones: Vec<LoadedZone>,
        estimate: Option<Vec<usize>>,
    ) -> ZoneGrids<S::Grid> {
        let within = whole.iter().zip(&zones).map(|(grid, zone)| self.space.within_zone(grid, zone));
        match within.collect::<Option<Vec<_>>>() {
            Some(grids) => ZoneGrids { whole: Some((whole, zones)), grids, estimate },
            None => ZoneGrids { whole: None, grids: whole, estimate: None },
        }
    }
}
