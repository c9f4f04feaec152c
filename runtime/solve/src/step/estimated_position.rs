//! Estimate of the position of bodies under load, by contact problems with one cell for each slice.
//!
//! Far from the equilibrium, nonlinear bearings take many rounds, each with a contact problem, and
//! the load may displace bodies so far that contact leaves grids of their unloaded position. The
//! loads of bearings and the displacements hardly depend on the deflection of teeth, so these
//! problems need few cells.
//!
//! See `docs/theory/equilibrium.md`.

use super::contact_geometry::{Candidate, ContactGeometry};
use super::contact_layout::{Conditions, LaidOutContact, MOST_SHIFT, Solver, difference};
use super::nonlinear_bearings::NonlinearIteration;
use super::relinearization::farthest;
use calyx_contact::friction::ActiveSet;
use calyx_numerics::error::EngineError;

/// Largest number of estimates of a position.
const ESTIMATES: usize = 8;
/// Change of the estimated position, relative to half a grid's width, after which no other estimate
/// follows: each reduces the change by a factor of about a hundred.
const SETTLED: f64 = 1.0;

/// Estimate of the bodies under load, as deviations from the prescribed motions, m or rad by DOF.
pub(super) struct Estimate {
    /// Position at which the contact grid is created, see [`Solver::carried`].
    pub(super) position: Vec<f64>,
    /// Motion with the deflection of the teeth.
    pub(super) motion: Vec<f64>,
    /// Number of estimates that led to it.
    pub(super) count: usize,
}

impl<S: ContactGeometry> Solver<'_, S> {
    /// Estimates the position of the bodies under load, if nonlinear bearings displace them so far
    /// that contact would leave its grid: `None` otherwise. Afterwards the bearings start near
    /// their equilibrium. A given state of contact has a given number of estimates.
    ///
    /// # Errors
    /// Those of the interrupt. The problem of all cells reports other errors.
    pub(super) fn estimated_position(
        &self,
        time: f64,
        load: &[f64],
        start: &[f64],
    ) -> Result<Option<Estimate>, EngineError> {
        let has_slices = !self.under.in_time && self.space.has_slices();
        let Some(bearings) = self.under.nonlinear.filter(|_| has_slices) else {
            return Ok(None);
        };
        let given = self.under.state.map(|state| state.estimates);
        let solver = Solver { under: Conditions { one_cell_per_slice: true, ..self.under }, ..*self };
        let mut found: Option<Estimate> = None;
        for count in 1..=ESTIMATES {
            let at = found.as_ref().map_or(start, |found| &found.position);
            let Ok(LaidOutContact { step, references }) = solver.solve_from(time, load, at, &mut Vec::new())
            else {
                break;
            };
            let shift = |to: &[f64]| farthest(self.system, time, &references, &difference(to, at)).0;
            let is_far = || found.is_some() || shift(&step.motion) > MOST_SHIFT;
            // In the limit without load there are no cells.
            let is_displaced = !step.problem.gaps.is_empty() && given.map_or_else(is_far, |all| count <= all);
            if !is_displaced {
                break;
            }
            let position = self.carried(time, load, &step)?;
            let is_last = given.map_or_else(|| shift(&position) <= SETTLED, |all| count == all);
            found = Some(Estimate { position, motion: step.motion, count });
            if is_last {
                break;
            }
        }
        bearings.await_solution();
        self.system.interrupt.check()?;
        Ok(found)
    }

    /// Solves with one cell for each slice of the grids. Sizes of grids are not corrected.
    pub(super) fn solved_by_slices(
        &self,
        time: f64,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        (whole, mut iteration): (Vec<S::Grid>, Option<NonlinearIteration>),
        largest_forces: &[f64],
    ) -> Result<LaidOutContact, EngineError> {
        let slices = self.slices(&whole).unwrap_or(whole);
        let (problem, modal, _) = self.problem(load, candidates, &slices, (None, None))?;
        let (drags, mut works) = self.friction(time, candidates, &slices);
        works.resize(problem.arms.len(), 0.0);
        let every: Vec<usize> = (0..problem.cells()).collect();
        let laid = (candidates, &slices[..]);
        let (problem, solution) =
            self.solve_problem(problem, &works, ActiveSet::Estimate(&every), laid, &mut iteration)?;
        Ok(self.laid_out(time, candidates, slices, (drags, problem, modal, solution), largest_forces))
    }

    /// Returns the grids with one cell for each slice; `None` if problems contain all cells.
    pub(super) fn slices(&self, whole: &[S::Grid]) -> Option<Vec<S::Grid>> {
        whole.iter().map(|grid| self.space.with_a_cell_for_each_slice(grid)).collect()
    }
}
