//! Where contact is laid out: where frames are without load, behind backlash, and anew where the load carries bodies, until that is
//! one place. Gaps are linear in motions about it.

use super::StepResult;
use super::drift::{Foothold, farthest};
use super::space::{Approach, Candidate, Space};
use crate::holding;
use crate::modal::Elastic;
use crate::system::System;
use calyx_contact::problem::ContactError;
use calyx_contact::rest::rest;
use calyx_model::bearing::Springs;
use calyx_numerics::error::EngineError;

/// A grid is first laid where the gap is below this part of the profile's length; gaps that the solution closes beyond
/// are found and added afterwards.
pub(super) const SEARCH_DEPTH: f64 = 0.01;
/// How often bodies that go through backlash are moved to where their teeth touch: involutes are there at once.
const STARTS: usize = 3;
/// Contact that moves along a surface by this part of half a grid's width has left the middle of its grid. Gaps are linear in motions; what
/// moving by d does to them besides is up to d² / 2 R, here a quarter of what the parabola of the gap rises up to the end of the grid.
pub(super) const DRIFT: f64 = 0.5;
/// Places at which contact was laid out anew that differ by less than this part of half a grid's width are one.
const SETTLED: f64 = 1e-3;
/// What solving a position may end in for where its bodies are: what was solved before stands, with a warning.
const UNSOLVED: [&str; 5] = ["E0714", "E0715", "E0716", "E0717", "E0719"];
/// How often contact is laid out anew where the load carries bodies. Each time brings the place a hundred times nearer, or ten times
/// if the load carries them by a module.
const PLACES: usize = 8;

/// Under which a position is solved.
#[derive(Clone, Copy)]
pub(super) struct Conditions<'a> {
    /// A load that the load is, or is the limit of.
    pub(super) direction: &'a [f64],
    /// What bearings do at the position.
    pub(super) springs: &'a Springs,
    /// How far bodies are off their prescribed motions where contact is laid out, m or rad by freedom; empty if they are not.
    pub(super) start: &'a [f64],
    /// Modal coordinates that take part.
    pub(super) elastic: Option<&'a Elastic<'a>>,
    /// Of motion in time: the load that grids are sized for, whatever the forces of the step are.
    pub(super) sizing: Option<&'a [f64]>,
    /// It is a step in time, in which teeth may part.
    pub(super) in_time: bool,
}

/// A position being solved.
pub(super) struct Solver<'a, S> {
    pub(super) system: &'a System<'a>,
    pub(super) space: &'a S,
    pub(super) under: Conditions<'a>,
}

/// A position solved with contact laid out at one place.
pub(super) struct Laid {
    pub(super) step: StepResult,
    pub(super) footholds: Vec<Foothold>,
}
impl<S: Space> Solver<'_, S> {
    /// Contact is laid out where frames are without load, behind backlash, and anew where the load carries bodies that it carries far, until
    /// that is one place.
    pub(super) fn solve(&self, time: f64, load: &[f64]) -> Result<StepResult, EngineError> {
        let start = self.start(time, load)?;
        let mut laid = self.solve_from(time, load, &start)?;
        let Laid { step, footholds } = &laid;
        if farthest(self.system, time, footholds, &difference(&step.motion, &step.start)).0 <= DRIFT {
            return Ok(laid.step);
        }
        for _ in 0..PLACES {
            let next = self.carried(time, load, &laid.step)?;
            let moved = difference(&next, &laid.step.start);
            if farthest(self.system, time, &laid.footholds, &moved).0 <= SETTLED {
                return Ok(laid.step);
            }
            laid = match self.solve_from(time, load, &next) {
                Ok(laid) => laid,
                // Where the load takes them teeth do not meet, or not so that it can be solved.
                Err(error) if UNSOLVED.contains(&error.code) => break,
                Err(error) => return Err(error),
            };
        }
        let Laid { mut step, footholds } = laid;
        let moved = difference(&self.carried(time, load, &step)?, &step.start);
        if let (drift, Some(foothold)) = farthest(self.system, time, &footholds, &moved)
            && drift > DRIFT
        {
            step.warnings.push(foothold.lost(self.system.scene, drift));
        }
        Ok(step)
    }

    /// With contact laid out where bodies are off their prescribed motions by `start`.
    fn solve_from(&self, time: f64, load: &[f64], start: &[f64]) -> Result<Laid, EngineError> {
        let candidates = self.space.candidates(time, start)?;
        // Motions are counted from there, and springs are strained already.
        let (springs, load) = self.under.springs.from(start, load);
        self.under(&springs, start).solve_laid(time, &load, candidates)
    }

    /// With contact between these laid out at the solver's start, from where springs and load are counted.
    fn solve_laid(
        &self,
        time: f64,
        load: &[f64],
        candidates: Vec<Candidate<S::Site>>,
    ) -> Result<Laid, EngineError> {
        let start = self.under.start;
        let near = |candidate: &Candidate<S::Site>| candidate.nearest.gap < SEARCH_DEPTH * candidate.length;
        let mut chosen: Vec<bool> = candidates.iter().map(near).collect();
        if !chosen.contains(&true) && !self.under.in_time {
            // Frames leave a gap that motions have to close first.
            chosen.fill(true);
        }
        loop {
            let used: Vec<&Candidate<S::Site>> =
                candidates.iter().zip(&chosen).filter(|(_, used)| **used).map(|(c, _)| c).collect();
            let Laid { step, footholds } = self.solve_candidates(time, load, &used)?;
            // Teeth that were left out and that the solution would push into each other.
            let mut closed = false;
            for (candidate, used) in candidates.iter().zip(&mut chosen).filter(|(_, used)| !**used) {
                if candidate.approaches().any(|approach| approach.closed_by(&step.motion)) {
                    *used = true;
                    closed = true;
                }
            }
            if !closed {
                let motion = step.motion.iter().zip(start).map(|(moved, start)| start + moved).collect();
                let step = StepResult { motion, start: start.to_vec(), ..step };
                return Ok(Laid { step, footholds });
            }
        }
    }

    /// A step in time.
    pub(super) fn take(&self, time: f64, load: &[f64]) -> Result<StepResult, EngineError> {
        let candidates = self.space.candidates(time, self.under.start)?;
        Ok(self.solve_laid(time, load, candidates)?.step)
    }

    /// Where the load has carried bodies: springs are strained as they are, stops pressed in as far, and what they leave free is where
    /// rigid teeth touch, as where contact is laid out elsewhere. What nothing leaves free stays as it is, elastic.
    fn carried(&self, time: f64, load: &[f64], step: &StepResult) -> Result<Vec<f64>, EngineError> {
        let candidates = self.space.candidates(time, &step.motion)?;
        let (mut springs, load) = self.under.springs.from(&step.motion, load);
        springs.gaps.iter_mut().for_each(|gap| *gap = gap.max(0.0));
        let solver = self.under(&springs, self.under.start);
        let (gaps, arms) = solver.rigid_contacts(&candidates);
        let strained = rest(&springs.stiffness, &vec![0.0; load.len()]);
        let back = strained.rigid_limit(&gaps, &arms, &self.limit_direction(), &self.system.interrupt);
        let mut carried = step.motion.clone();
        match back {
            Ok(Some(limit)) => carried.iter_mut().zip(&limit.motion).for_each(|(at, more)| *at += more),
            Err(error @ ContactError::Interrupted(_)) => return Err(self.explain(&error)),
            Ok(None) | Err(_) => {}
        }
        Ok(carried)
    }

    /// Whether teeth may touch on both sides.
    pub(super) fn both_sides(&self) -> bool {
        self.system.scene.pairs.iter().any(|pair| pair.front.is_some())
    }

    /// The load whose limit bodies come to rest under: with one flank of each tooth it is the one that the mesh is made for.
    pub(super) fn limit_direction(&self) -> Vec<f64> {
        match (self.both_sides() || self.system.rigid) && self.under.direction.iter().any(|&load| load != 0.0)
        {
            true => self.under.direction.to_vec(),
            false => holding::drive_direction(self.system.scene, &self.system.freedoms),
        }
    }

    /// How far bodies go, rigid, before teeth touch where the load presses them: nothing, unless they may touch on both sides. Contact
    /// is laid out there, for it is geometry of the first order only, and backlash is much wider than what teeth give.
    fn start(&self, time: f64, load: &[f64]) -> Result<Vec<f64>, EngineError> {
        let freedoms = self.system.freedoms.len();
        let nowhere = vec![0.0; freedoms];
        if freedoms == 0 || !self.both_sides() {
            return Ok(nowhere);
        }
        let direction = self.limit_direction();
        let mut start = nowhere.clone();
        for _ in 0..STARTS {
            let candidates = self.space.candidates(time, &start)?;
            let (springs, load) = self.under.springs.from(&start, load);
            let solver = self.under(&springs, self.under.start);
            let (gaps, arms) = solver.rigid_contacts(&candidates);
            let rest = rest(&springs.stiffness, &load);
            match rest.rigid_limit(&gaps, &arms, &direction, &self.system.interrupt) {
                Ok(None) => return Ok(nowhere),
                Ok(Some(limit)) => {
                    start.iter_mut().zip(&limit.motion).for_each(|(start, more)| *start += more)
                }
                Err(error @ ContactError::Interrupted(_)) => return Err(self.explain(&error)),
                // A tight mesh overlaps in every position. What nothing holds, the contact problem says.
                Err(_) => return Ok(nowhere),
            }
        }
        Ok(start)
    }

    /// Gaps of rigid bodies, of the stops of bearings and of the flanks of lugs, and their arms.
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

    /// The same with what is counted from elsewhere.
    fn under<'b>(&'b self, springs: &'b Springs, start: &'b [f64]) -> Solver<'b, S> {
        Solver { system: self.system, space: self.space, under: Conditions { springs, start, ..self.under } }
    }
}

fn difference(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter().zip(other).map(|(one, other)| one - other).collect()
}
