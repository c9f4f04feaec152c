//! Positions of bodies at which the contact grid is created: that of unloaded frames, after closing
//! backlash, and after relinearization where the load displaces bodies, until it converges. Gaps
//! are linear in the motions about it, except the rotation of a single body on general axes
//! (`calyx_contact::solid::lines_of_action`).
//!
//! See `docs/theory/equilibrium.md`.

use super::StepResult;
use super::contact_geometry::{Approach, Candidate, ContactGeometry, Search};
use super::contact_state::{ContactState, GridState};
use super::nonlinear_bearings::NonlinearBearings;
use super::relinearization::{ContactReference, farthest};
use crate::modal::ModalElimination;
use crate::restraint_check;
use crate::system::{System, Teeth};
use calyx_contact::problem::ContactError;
use calyx_contact::unloaded_equilibrium::unloaded_equilibrium;
use calyx_model::bearing::Springs;
use calyx_numerics::error::EngineError;

/// Gap below which a grid is created first, relative to the profile's length. Larger gaps that the
/// solution closes are found and added afterwards.
pub(super) const SEARCH_DEPTH: f64 = 0.01;
/// Maximum number of moves of bodies through backlash to contact; involutes converge in one.
const STARTS: usize = 3;
/// Drift relative to half a grid's width at which the contact leaves the middle of its grid. Gaps
/// are linear in motions; the neglected term of a drift d is up to d² / 2 R, here a quarter of the
/// rise of the gap's parabola to the end of the grid.
pub(super) const MOST_SHIFT: f64 = 0.5;
/// Motion, m or rad, below which the rigid-body limit on general axes needs no other position of
/// its contacts: the neglected term is of the order of its square over the radius of a flank.
const TOUCHING_AT: f64 = 1e-8;
/// Difference of successive relinearization positions, relative to half a grid's width, that counts
/// as converged.
const SETTLED: f64 = 1e-3;
/// Largest difference between the motions of a solution and of the estimate of its position, as
/// drift relative to half a grid's width, with which the position is accepted.
const CONFIRMED: f64 = 2e-2;
/// Errors that can be due to the position of the bodies: the previous solution remains, with a
/// warning.
const UNSOLVED: [&str; 5] = ["E0714", "E0715", "E0716", "E0717", "E0719"];
/// Maximum number of relinearizations. Each reduces the error by a factor of a hundred, or ten for
/// motions by a module.
const PLACES: usize = 8;

/// Conditions under which a position is solved.
#[derive(Clone, Copy)]
pub(super) struct Conditions<'a> {
    /// Direction of the load, or of the vanishing load of a limit.
    pub(super) direction: &'a [f64],
    /// Terms of bearings at the position.
    pub(super) springs: &'a Springs,
    /// Bearings with a nonlinear load, whose tangents replace those of `springs` in contact
    /// problems.
    pub(super) nonlinear: Option<&'a NonlinearBearings<'a>>,
    /// Deviations from the prescribed motions at which the contact grid is created, m or rad by
    /// DOF; empty if zero.
    pub(super) start: &'a [f64],
    /// Modal coordinates that take part.
    pub(super) elastic: Option<&'a ModalElimination<'a>>,
    /// Load for the sizes of grids in a transient analysis, independent of the forces of the step.
    pub(super) sizing: Option<&'a [f64]>,
    /// True for a time step, in which teeth may separate.
    pub(super) in_time: bool,
    /// State of contact that is kept, if its patches have the same cells.
    pub(super) state: Option<&'a ContactState>,
    /// True for an estimate of the position under load, on grids with one cell for each slice.
    pub(super) one_cell_per_slice: bool,
}

/// Solver of a position.
pub(super) struct Solver<'a, S> {
    pub(super) system: &'a System<'a>,
    pub(super) space: &'a S,
    pub(super) under: Conditions<'a>,
}

/// Solution with the contact grid created at one position.
pub(super) struct LaidOutContact {
    pub(super) step: StepResult,
    pub(super) references: Vec<ContactReference>,
}

/// Candidates, and which of their approaches are accurate.
type SearchResult<Site> = (Vec<Candidate<Site>>, Search);

impl<S: ContactGeometry> Solver<'_, S> {
    /// Solves with the contact grid at the unloaded position, after closing backlash, and
    /// relinearizes where the load displaces bodies far, until this converges. The first position
    /// under load is estimated, if possible.
    pub(super) fn solve(&self, time: f64, load: &[f64]) -> Result<StepResult, EngineError> {
        let start = self.start(time, load)?;
        let mut grids = Vec::new();
        let mut estimate = self.estimated_position(time, load, &start)?;
        let first = estimate.as_ref().map_or(&start, |estimate| &estimate.position);
        let mut laid = match (self.solve_from(time, load, first, &mut grids), self.under.nonlinear) {
            (Err(_), Some(bearings)) if estimate.is_some() => {
                self.system.interrupt.check()?;
                // The unloaded position may have a solution; otherwise it states the error.
                bearings.forget();
                grids.clear();
                estimate = None;
                self.solve_from(time, load, &start, &mut grids)?
            }
            (laid, _) => laid?,
        };
        if laid.step.problem.gaps.is_empty() && self.on_general_axes() {
            return Ok(self.touching(time, load, laid).step);
        }
        let estimates = estimate.as_ref().map_or(0, |estimate| estimate.count);
        let with_grids = |step: StepResult, grids| StepResult { grids, estimates, ..step };
        let LaidOutContact { step, references } = &laid;
        let (moved, most) = match &estimate {
            Some(estimate) => (difference(&step.motion, &estimate.motion), CONFIRMED),
            None => (difference(&step.motion, &step.start), MOST_SHIFT),
        };
        if farthest(self.system, time, references, &moved).0 <= most {
            return Ok(with_grids(laid.step, grids));
        }
        for _ in 0..PLACES {
            let next = self.carried(time, load, &laid.step)?;
            let moved = difference(&next, &laid.step.start);
            if farthest(self.system, time, &laid.references, &moved).0 <= SETTLED {
                return Ok(with_grids(laid.step, grids));
            }
            laid = match self.solve_from(time, load, &next, &mut grids) {
                Ok(laid) => laid,
                // At the position under load, teeth are out of contact or the problem cannot be
                // solved.
                Err(error) if UNSOLVED.contains(&error.code) => break,
                Err(error) => return Err(error),
            };
        }
        let LaidOutContact { mut step, references } = laid;
        let moved = difference(&self.carried(time, load, &step)?, &step.start);
        if let (relative_shift, Some(reference)) = farthest(self.system, time, &references, &moved)
            && relative_shift > MOST_SHIFT
        {
            step.warnings.push(reference.lost(self.system.scene, relative_shift));
        }
        Ok(with_grids(step, grids))
    }

    /// Solves with the contact grid created at the deviations `start` from the prescribed motions.
    /// Solved grids are added to `grids`.
    pub(super) fn solve_from(
        &self,
        time: f64,
        load: &[f64],
        start: &[f64],
        grids: &mut Vec<GridState>,
    ) -> Result<LaidOutContact, EngineError> {
        let found = match self.under.one_cell_per_slice {
            true => self.near_candidates(time, start)?,
            false => (self.space.candidates(time, start, Search::All)?, Search::All),
        };
        // Motions are relative to this position, at which springs are already strained.
        let (springs, load) = self.under.springs.from(start, load);
        self.under(&springs, start).solve_at_layout(time, &load, found, grids)
    }

    /// Returns candidates whose approach is accurate if they are near, or all are if none is near.
    fn near_candidates(&self, time: f64, moved: &[f64]) -> Result<SearchResult<S::Site>, EngineError> {
        let found = self.space.candidates(time, moved, Search::Near)?;
        match found.iter().any(is_near) {
            true => Ok((found, Search::Near)),
            false => Ok((self.space.candidates(time, moved, Search::All)?, Search::All)),
        }
    }

    /// Solves with contact between these candidates at the solver's start, to which springs and
    /// load refer.
    fn solve_at_layout(
        &self,
        time: f64,
        load: &[f64],
        (mut candidates, mut search): SearchResult<S::Site>,
        grids: &mut Vec<GridState>,
    ) -> Result<LaidOutContact, EngineError> {
        let start = self.under.start;
        let mut chosen: Vec<bool> = candidates.iter().map(is_near).collect();
        if !chosen.contains(&true) && !self.under.in_time {
            // The motions must first close a gap.
            chosen.fill(true);
        }
        loop {
            let used: Vec<&Candidate<S::Site>> =
                candidates.iter().zip(&chosen).filter(|(_, used)| **used).map(|(c, _)| c).collect();
            let LaidOutContact { step, references } = self.solve_candidates(time, load, &used, grids)?;
            // Add teeth that were left out and that the solution would make overlap.
            let mut closed = false;
            for (candidate, used) in candidates.iter().zip(&mut chosen).filter(|(_, used)| !**used) {
                if candidate.approaches().any(|approach| approach.gap_closure(&step.motion)) {
                    *used = true;
                    closed = true;
                }
            }
            if !closed {
                let motion = step.motion.iter().zip(start).map(|(moved, start)| start + moved).collect();
                let step = StepResult { motion, start: start.to_vec(), ..step };
                return Ok(LaidOutContact { step, references });
            }
            if search == Search::Near {
                // The approach of teeth that were left out is not accurate.
                let used: Vec<Teeth> =
                    candidates.iter().zip(&chosen).filter(|(_, used)| **used).map(|(c, _)| c.teeth).collect();
                search = Search::All;
                candidates = self.space.candidates(time, start, search)?;
                chosen = candidates.iter().map(|c| is_near(c) || used.contains(&c.teeth)).collect();
            }
        }
    }

    /// Solves a time step.
    pub(super) fn take(&self, time: f64, load: &[f64]) -> Result<StepResult, EngineError> {
        let found = (self.space.candidates(time, self.under.start, Search::Near)?, Search::Near);
        Ok(self.solve_at_layout(time, load, found, &mut Vec::new())?.step)
    }

    /// Returns the position of the bodies under load: springs and stops with their present
    /// deflection, motions that they leave free at the rigid-body limit, as for other grid
    /// positions. Motions that nothing leaves free are kept, including their elastic part. Teeth
    /// that are not near do not limit the motions, because loaded ones overlap there.
    pub(super) fn carried(
        &self,
        time: f64,
        load: &[f64],
        step: &StepResult,
    ) -> Result<Vec<f64>, EngineError> {
        let (candidates, _) = self.near_candidates(time, &step.motion)?;
        let (mut springs, load) = self.under.springs.from(&step.motion, load);
        springs.gaps.iter_mut().for_each(|gap| *gap = gap.max(0.0));
        let solver = self.under(&springs, self.under.start);
        let (gaps, arms) = solver.rigid_contacts(&candidates);
        let strained = unloaded_equilibrium(&springs.stiffness, &vec![0.0; load.len()]);
        let back = strained.rigid_limit(&gaps, &arms, &self.limit_direction(), &self.system.interrupt);
        let mut carried = step.motion.clone();
        match back {
            Ok(Some(limit)) => carried.iter_mut().zip(&limit.motion).for_each(|(at, more)| *at += more),
            Err(error @ ContactError::Interrupted(_)) => return Err(self.explain(&error)),
            Ok(None) | Err(_) => {}
        }
        Ok(carried)
    }

    fn on_general_axes(&self) -> bool {
        let meshes = self.system.scene.pairs.iter().filter_map(|pair| pair.mesh.as_ref());
        meshes.into_iter().any(|mesh| mesh.first_contact.is_some())
    }

    /// Repeats the limit of a vanishing load at the position that it finds until that is the
    /// position of contact: gaps are linear in the motions, and the unloaded transmission error of
    /// flanks that are not conjugate is a hundred times larger than its required accuracy.
    fn touching(&self, time: f64, load: &[f64], mut laid: LaidOutContact) -> LaidOutContact {
        for _ in 0..STARTS {
            let LaidOutContact { step, .. } = &laid;
            if difference(&step.motion, &step.start).iter().all(|moved| moved.abs() <= TOUCHING_AT) {
                break;
            }
            match self.solve_from(time, load, &step.motion, &mut Vec::new()) {
                Ok(next) if next.step.problem.gaps.is_empty() => laid = next,
                _ => break,
            }
        }
        laid
    }

    /// Returns whether teeth may touch on both flanks.
    pub(super) fn both_sides(&self) -> bool {
        self.system.scene.pairs.iter().any(|pair| pair.front.is_some())
    }

    /// Returns the load direction of the rigid-body limit: with one flank of each tooth it is the
    /// drive direction of the mesh.
    pub(super) fn limit_direction(&self) -> Vec<f64> {
        match (self.both_sides() || self.system.rigid) && self.under.direction.iter().any(|&load| load != 0.0)
        {
            true => self.under.direction.to_vec(),
            false => restraint_check::drive_direction(self.system.scene, &self.system.dofs),
        }
    }

    /// Returns the rigid motion of the bodies until teeth touch under the load: zero unless they
    /// may touch on both flanks. The contact grid is created there, because the geometry is
    /// linearized, and backlash is much larger than elastic deflections.
    fn start(&self, time: f64, load: &[f64]) -> Result<Vec<f64>, EngineError> {
        let dofs = self.system.dofs.len();
        let nowhere = vec![0.0; dofs];
        if dofs == 0 || !self.both_sides() {
            return Ok(nowhere);
        }
        let direction = self.limit_direction();
        let mut start = nowhere.clone();
        for _ in 0..STARTS {
            let candidates = self.space.candidates(time, &start, Search::All)?;
            let (springs, load) = self.under.springs.from(&start, load);
            let solver = self.under(&springs, self.under.start);
            let (gaps, arms) = solver.rigid_contacts(&candidates);
            let unloaded = unloaded_equilibrium(&springs.stiffness, &load);
            match unloaded.rigid_limit(&gaps, &arms, &direction, &self.system.interrupt) {
                Ok(None) => return Ok(nowhere),
                Ok(Some(limit)) => {
                    start.iter_mut().zip(&limit.motion).for_each(|(start, more)| *start += more)
                }
                Err(error @ ContactError::Interrupted(_)) => return Err(self.explain(&error)),
                // A mesh without backlash overlaps in every position. The contact problem reports
                // unconstrained motions.
                Err(_) => return Ok(nowhere),
            }
        }
        Ok(start)
    }

    /// Returns gaps of rigid bodies, of bearing stops and of spline tooth flanks, and their arms.
    pub(super) fn rigid_contacts<'c>(
        &self,
        candidates: impl IntoIterator<Item = &'c Candidate<S::Site>>,
    ) -> (Vec<f64>, Vec<f64>)
    where
        S::Site: 'c,
    {
        let approaches: Vec<&Approach> =
            candidates.into_iter().flat_map(|candidate| candidate.approaches()).collect();
        let gaps =
            approaches.iter().map(|approach| approach.gap).chain(self.under.springs.gaps.iter().copied());
        let arms = approaches.iter().flat_map(|approach| &approach.arms).chain(&self.under.springs.arms);
        (gaps.collect(), arms.copied().collect())
    }

    /// Returns a solver with other springs and another start.
    fn under<'b>(&'b self, springs: &'b Springs, start: &'b [f64]) -> Solver<'b, S> {
        Solver { system: self.system, space: self.space, under: Conditions { springs, start, ..self.under } }
    }
}

/// Returns whether a grid is created first.
fn is_near<S>(candidate: &Candidate<S>) -> bool {
    candidate.nearest.gap < SEARCH_DEPTH * candidate.length
}

pub(super) fn difference(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter().zip(other).map(|(one, other)| one - other).collect()
}
