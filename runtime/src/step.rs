//! One position in equilibrium: teeth that may touch are found, grids laid, the contact problem solved.
//!
//! All of this is the same in the plane and in space, and stands here; what has a dimension (where bodies are, how surfaces approach,
//! what grids and compliances are made of) is behind [`Space`], once in [`plane`] and once in [`solid`].

mod drag;
mod drift;
mod patch;
mod plane;
mod solid;

pub use patch::{Patch, PatchGrid};

use crate::bearing::Springs;
use crate::contact::friction::solve_with_friction;
use crate::contact::problem::{Certificate, ContactError, ContactProblem};
use crate::contact::rest::{Rest, rest};
use crate::dynamics::{Elastic, Modes};
use crate::error::EngineError;
use crate::holding;
use crate::observe::Vibrations;
use crate::scene::{Scene, SurfacePair};
use crate::system::{Bodies, System, Teeth};
use drag::Action;
use drift::{Foothold, farthest};
use faer::Mat;
use std::sync::{Arc, OnceLock};

/// A solved position. Keeps the contact problem and its active cells, from which sensitivities follow.
#[derive(Clone, Debug)]
pub struct StepResult {
    /// s
    pub time: f64,
    /// Pairs of teeth that touch or may.
    pub patches: Vec<Patch>,
    /// Deviation of every freedom from its prescribed motion, m or rad.
    pub motion: Vec<f64>,
    /// The part of it after which contact was laid out: nothing, unless teeth may touch on both sides with backlash between, or the
    /// load carries bodies off the grids that would lie where their frames are without load.
    pub start: Vec<f64>,
    /// What was solved; with modal coordinates the problem that statics has of the same cells.
    pub problem: ContactProblem,
    /// Cells that carry load, by index in the problem.
    pub active: Vec<usize>,
    /// Modal coordinates of the bodies, body after body; empty where no modes are asked for.
    pub modal: Vec<f64>,
    /// Rates of the freedoms and of the modal coordinates, per second; empty in equilibrium.
    pub velocity: Vec<f64>,
    /// What acts on the frame of each body beside contact, bearings and its whole load, in the order of [`crate::scene::FREEDOMS`]: inertia, and
    /// the part of the load that a step leaves out; N and N m. Empty in equilibrium.
    pub beside: Vec<[f64; 6]>,
    /// The free vibrations about it once somebody has asked for them, see [`crate::observe::Equilibrium::vibrations`].
    pub(crate) vibrations: OnceLock<Option<Arc<Vibrations>>>,
    /// Forces on the stops of bearings, whose gaps stand behind those of the patches, and behind them on the flanks of lugs: N, of a plane
    /// model N per metre of face width.
    pub stops: Vec<f64>,
    /// How well it is solved.
    pub certificate: Certificate,
    /// What should be known about the position, in sentences.
    pub warnings: Vec<String>,
}

/// A grid is first laid where the gap is below this part of the profile's length; gaps that the solution closes beyond
/// are found and added afterwards.
const SEARCH_DEPTH: f64 = 0.01;
/// A patch whose arm on a freedom is below this part of the longest there is leaves the load on it to others.
const WORTH_LOADING: f64 = 0.1;
/// Matrices of all cells by all cells that a position has at once, at most: what its compliance is put together from, itself, and the
/// factor of its loaded cells.
const MATRICES: u64 = 4;
/// How often the sizes of grids may be mended at a position.
const REGRIDS: usize = 3;
/// How often bodies that go through backlash are moved to where their teeth touch: involutes are there at once.
const STARTS: usize = 3;
/// Contact that moves along a surface by this part of half a grid's width has left the middle of its grid. Gaps are linear in motions; what
/// moving by d does to them besides is up to d² / 2 R, here a quarter of what the parabola of the gap rises up to the end of the grid.
const DRIFT: f64 = 0.5;
/// Places at which contact was laid out anew that differ by less than this part of half a grid's width are one.
const SETTLED: f64 = 1e-3;
/// What solving a position may end in for where its bodies are: what was solved before stands, with a warning.
const UNSOLVED: [&str; 5] = ["E0714", "E0715", "E0716", "E0717", "E0719"];
/// How often contact is laid out anew where the load carries bodies. Each time brings the place a hundred times nearer, or ten times
/// if the load carries them by a module.
const PLACES: usize = 8;

/// A pair of teeth that could touch: what is known before anything is solved.
struct Candidate<S> {
    teeth: Teeth,
    /// Of the profiles, m: what gaps are small or large against.
    length: f64,
    /// Where the surfaces come closest.
    nearest: Approach,
    /// Further places at which the gap may close; none in the plane.
    others: Vec<Approach>,
    /// Where it is, and on what.
    site: S,
}

/// A gap that rigid motions open and close.
struct Approach {
    /// m; negative where the bodies overlap.
    gap: f64,
    /// Growth of the gap by each freedom.
    arms: Vec<f64>,
}

impl Approach {
    fn closed_by(&self, motion: &[f64]) -> bool {
        let rigid: f64 = self.arms.iter().zip(motion).map(|(arm, motion)| arm * motion).sum();
        self.gap + rigid < 0.0
    }
}

impl<S> Candidate<S> {
    fn approaches(&self) -> impl Iterator<Item = &Approach> {
        std::iter::once(&self.nearest).chain(&self.others)
    }
}

/// What of a position has a dimension.
trait Space {
    /// Where a pair of teeth approach each other.
    type Site;
    /// The cells of a patch.
    type Grid;
    /// How large a grid is.
    type Size: Copy;

    /// Every pair of teeth near enough to face each other, in a fixed order, where bodies are off their prescribed motions by
    /// `moved`, m or rad by freedom.
    fn candidates(&self, time: f64, moved: &[f64]) -> Result<Vec<Candidate<Self::Site>>, EngineError>;

    /// The order of the force that presses surfaces flat that overlap by so much (m), in the unit of loads.
    fn force_of_overlap(&self, candidate: &Candidate<Self::Site>, overlap: f64) -> f64;

    /// Lays the grid of a patch: of the size that is given, else of the model's, else of one that suits the force.
    fn lay(&self, candidate: &Candidate<Self::Site>, force: f64, size: Option<Self::Size>) -> Self::Grid;

    /// How many cells a grid has.
    fn count(&self, grid: &Self::Grid) -> usize;

    /// Its width across, m.
    fn width(&self, grid: &Self::Grid) -> f64;

    /// The gap of each cell, m.
    fn gaps(&self, grid: &Self::Grid) -> Vec<f64>;

    /// Growth of the gap of each cell by each freedom, row by row.
    fn arms(&self, candidate: &Candidate<Self::Site>, grid: &Self::Grid) -> Vec<f64>;

    /// Where cells act, and along which normal: what friction is made of.
    fn action(&self, candidate: &Candidate<Self::Site>, grid: &Self::Grid) -> Action;

    /// The same of the closest approach, where no grid is laid.
    fn approaching(&self, candidate: &Candidate<Self::Site>) -> Action;

    /// Growth of gaps by the forces on cells, see [`ContactProblem::compliance`].
    fn compliance(&self, laid: &[(&Candidate<Self::Site>, &Self::Grid)]) -> Result<Vec<f64>, EngineError>;

    /// Growth of the gap of each cell by the forces on the flanks of all lugs; none in space.
    fn by_lugs(&self, _laid: &[(&Candidate<Self::Site>, &Self::Grid)]) -> Mat<f64> {
        Mat::zeros(0, 0)
    }

    /// Cells that probably carry force, by index in the problem, to begin the search with: no more than time depends on it.
    fn guess(&self, _problem: &ContactProblem, _grids: &[Self::Grid]) -> Vec<usize> {
        Vec::new()
    }

    /// A better size for a grid whose size was left open and turns out to be unsuitable; where `wide` ones are as they should be, a wider one.
    fn better_size(
        &self,
        candidate: &Candidate<Self::Site>,
        grid: &Self::Grid,
        forces: &[f64],
        wide: bool,
    ) -> Option<Self::Size>;

    /// What the solution says against its grid (report figures 3.40 to 3.42).
    /// Where loads come and go, `wide` grids are as they should be.
    fn judge(
        &self,
        candidate: &Candidate<Self::Site>,
        grid: &Self::Grid,
        forces: &[f64],
        wide: bool,
    ) -> Option<String>;

    /// Growth of the gap of each cell by each modal coordinate of the bodies; none in space.
    fn modal_arms(&self, _laid: &[(&Candidate<Self::Site>, &Self::Grid)], _modes: &Modes) -> Mat<f64> {
        Mat::zeros(0, 0)
    }

    /// The patch as results show it, without a grid where nothing is pressed.
    fn patch(&self, candidate: &Candidate<Self::Site>, laid: Option<(Self::Grid, Vec<f64>)>) -> Patch;
}

impl System<'_> {
    /// Brings the scene into equilibrium at a time (s).
    ///
    /// What was solved before makes no difference, not in a bit.
    ///
    /// # Errors
    /// A load is not a number, nothing holds it, the problem is degenerate, or the interrupt's.
    pub fn solve(&self, time: f64) -> Result<StepResult, EngineError> {
        let load = self.load_at(time)?;
        self.solve_under(time, &load, &load, None)
    }

    /// The scene at a time (s) where its surfaces touch as the load vanishes.
    ///
    /// # Errors
    /// As [`System::solve`].
    pub(crate) fn touch(&self, time: f64) -> Result<StepResult, EngineError> {
        self.solve_under(time, &vec![0.0; self.freedoms.len()], &self.load_at(time)?, None)
    }

    /// Under a load, which may be the limit of one in a direction.
    pub(crate) fn solve_under(
        &self,
        time: f64,
        load: &[f64],
        direction: &[f64],
        elastic: Option<&Elastic<'_>>,
    ) -> Result<StepResult, EngineError> {
        self.equilibrium(time, load, direction, elastic, None)
    }

    /// The equilibrium in which a motion in time begins: `sizing` is the load that grids are sized for, as those of its steps, for `load` has inertia in it,
    /// and may have nothing else.
    pub(crate) fn begin(
        &self,
        time: f64,
        load: &[f64],
        elastic: Option<&Elastic<'_>>,
        sizing: &[f64],
    ) -> Result<StepResult, EngineError> {
        self.equilibrium(time, load, load, elastic, Some(sizing))
    }

    fn equilibrium(
        &self,
        time: f64,
        load: &[f64],
        direction: &[f64],
        elastic: Option<&Elastic<'_>>,
        sizing: Option<&[f64]>,
    ) -> Result<StepResult, EngineError> {
        let springs = &self.springs_at(time)?;
        let load: Vec<f64> = load.iter().zip(&springs.load).map(|(load, own)| load + own).collect();
        match &self.bodies {
            Bodies::Plane(bodies) => {
                let space = &plane::Plane { system: self, bodies };
                Solver {
                    system: self,
                    space,
                    direction,
                    springs,
                    start: &[],
                    elastic,
                    sizing,
                    in_time: false,
                }
                .solve(time, &load)
            }
            Bodies::Solid(bodies) => {
                let space = &solid::Solid { system: self, bodies };
                Solver {
                    system: self,
                    space,
                    direction,
                    springs,
                    start: &[],
                    elastic,
                    sizing,
                    in_time: false,
                }
                .solve(time, &load)
            }
        }
    }
}

impl System<'_> {
    /// The end of a step in time (s) that begins where bodies are off their prescribed motions by `start`: `springs` holds the step's matrix and the stops
    /// as seen from there, `load` what moves the freedoms from there. Its motion is counted from the prescribed one.
    pub(crate) fn step(
        &self,
        time: f64,
        springs: &Springs,
        load: &[f64],
        start: &[f64],
        elastic: Option<&Elastic<'_>>,
        sizing: &[f64],
    ) -> Result<StepResult, EngineError> {
        match &self.bodies {
            Bodies::Plane(bodies) => {
                let space = &plane::Plane { system: self, bodies };
                Solver {
                    system: self,
                    space,
                    direction: sizing,
                    springs,
                    start,
                    elastic,
                    sizing: Some(sizing),
                    in_time: true,
                }
                .take(time, load)
            }
            Bodies::Solid(bodies) => {
                let space = &solid::Solid { system: self, bodies };
                Solver {
                    system: self,
                    space,
                    direction: sizing,
                    springs,
                    start,
                    elastic,
                    sizing: Some(sizing),
                    in_time: true,
                }
                .take(time, load)
            }
        }
    }
}

/// A position being solved.
struct Solver<'a, S> {
    system: &'a System<'a>,
    space: &'a S,
    /// A load that the load is, or is the limit of.
    direction: &'a [f64],
    /// What bearings do at the position.
    springs: &'a Springs,
    /// How far bodies are off their prescribed motions where contact is laid out, m or rad by freedom; empty if they are not.
    start: &'a [f64],
    /// Modal coordinates that take part.
    elastic: Option<&'a Elastic<'a>>,
    /// Of motion in time: the load that grids are sized for, whatever the forces of the step are.
    sizing: Option<&'a [f64]>,
    /// It is a step in time, in which teeth may part.
    in_time: bool,
}

/// What modal coordinates are to the cells of a problem from which they are eliminated.
struct Modal {
    /// Growth of gaps, cells by coordinates.
    arms: Mat<f64>,
    /// Compliance and arms of the problem before.
    statics: Option<[Vec<f64>; 2]>,
}

/// A position solved with contact laid out at one place.
struct Laid {
    step: StepResult,
    footholds: Vec<Foothold>,
}

impl<S: Space> Solver<'_, S> {
    /// Contact is laid out where frames are without load, behind backlash, and anew where the load carries bodies that it carries far, until
    /// that is one place.
    fn solve(&self, time: f64, load: &[f64]) -> Result<StepResult, EngineError> {
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
        let (springs, load) = self.springs.from(start, load);
        Solver { springs: &springs, start, ..*self }.solve_laid(time, &load, candidates)
    }

    /// With contact between these laid out at the solver's start, from where springs and load are counted.
    fn solve_laid(
        &self,
        time: f64,
        load: &[f64],
        candidates: Vec<Candidate<S::Site>>,
    ) -> Result<Laid, EngineError> {
        let start = self.start;
        let near = |candidate: &Candidate<S::Site>| candidate.nearest.gap < SEARCH_DEPTH * candidate.length;
        let mut chosen: Vec<bool> = candidates.iter().map(near).collect();
        if !chosen.contains(&true) && !self.in_time {
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
    fn take(&self, time: f64, load: &[f64]) -> Result<StepResult, EngineError> {
        let candidates = self.space.candidates(time, self.start)?;
        Ok(self.solve_laid(time, load, candidates)?.step)
    }

    /// Where the load has carried bodies: springs are strained as they are, stops pressed in as far, and what they leave free is where
    /// rigid teeth touch, as where contact is laid out elsewhere. What nothing leaves free stays as it is, elastic.
    fn carried(&self, time: f64, load: &[f64], step: &StepResult) -> Result<Vec<f64>, EngineError> {
        let candidates = self.space.candidates(time, &step.motion)?;
        let (mut springs, load) = self.springs.from(&step.motion, load);
        springs.gaps.iter_mut().for_each(|gap| *gap = gap.max(0.0));
        let solver = Solver { springs: &springs, ..*self };
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
    fn both_sides(&self) -> bool {
        self.system.scene.pairs.iter().any(|pair| pair.front.is_some())
    }

    /// The load whose limit bodies come to rest under: with one flank of each tooth it is the one that the mesh is made for.
    fn limit_direction(&self) -> Vec<f64> {
        match self.both_sides() && self.direction.iter().any(|&load| load != 0.0) {
            true => self.direction.to_vec(),
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
            let (springs, load) = self.springs.from(&start, load);
            let solver = Solver { springs: &springs, ..*self };
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
    fn rigid_contacts<'c>(
        &self,
        candidates: impl IntoIterator<Item = &'c Candidate<S::Site>>,
    ) -> (Vec<f64>, Vec<f64>)
    where
        S::Site: 'c,
    {
        let approaches: Vec<&Approach> =
            candidates.into_iter().flat_map(|candidate| candidate.approaches()).collect();
        let gaps = approaches.iter().map(|approach| approach.gap).chain(self.springs.gaps.iter().copied());
        let arms = approaches.iter().flat_map(|approach| &approach.arms).chain(&self.springs.arms);
        (gaps.collect(), arms.copied().collect())
    }

    fn solve_candidates(
        &self,
        time: f64,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
    ) -> Result<Laid, EngineError> {
        // Bodies that are all held, or sprung, where they overlap press on each other without any load.
        // A step in time has inertia to balance them.
        if !self.in_time {
            let rest = rest(&self.springs.stiffness, load);
            if rest.balanced
                && let Some(laid) = self.touch_without_load(time, load, candidates, &rest)?
            {
                return Ok(laid);
            }
        }
        let mut sizes = vec![None; candidates.len()];
        let largest_forces = self.largest_forces(self.sizing.unwrap_or(load), candidates);
        let mut rounds = REGRIDS;
        let (grids, drags, mut problem, modal, solution) = loop {
            let grids: Vec<S::Grid> = candidates
                .iter()
                .zip(&largest_forces)
                .zip(&sizes)
                .map(|((candidate, &force), &size)| self.space.lay(candidate, force, size))
                .collect();
            let (problem, modal) = self.problem(load, candidates, &grids)?;
            let (drags, mut works) = self.friction(time, candidates, &grids);
            works.resize(problem.arms.len(), 0.0);
            let guess = self.guess(load, candidates, &problem, &grids);
            let solved = solve_with_friction(problem, &works, Some(&guess), &self.system.interrupt);
            let (problem, solution) = solved.map_err(|error| self.explain(&error))?;
            // Sizes nobody asked for follow what the patches turn out to carry.
            let better = self.better_sizes(candidates, &grids, &solution.forces);
            if rounds == 0 || better.iter().all(Option::is_none) {
                break (grids, drags, problem, modal, solution);
            }
            for (size, better) in sizes.iter_mut().zip(better) {
                *size = better.or(*size);
            }
            rounds -= 1;
        };

        let (mut warnings, mut footholds) = (Vec::new(), Vec::new());
        let mut patches = Vec::with_capacity(grids.len());
        let mut left = &solution.forces[..];
        for ((candidate, grid), drag) in candidates.iter().zip(grids).zip(drags) {
            let (forces, others) = left.split_at(self.space.count(&grid));
            left = others;
            warnings.extend(self.space.judge(candidate, &grid, forces, self.in_time));
            if forces.iter().any(|&force| force > 0.0) {
                footholds.push(Foothold {
                    pair: candidate.teeth.0,
                    action: self.space.action(candidate, &grid),
                    reach: 0.5 * self.space.width(&grid),
                });
            }
            patches.push(Patch { drag, ..self.space.patch(candidate, Some((grid, forces.to_vec()))) });
        }
        let stops = left.to_vec();
        let Modal { arms, statics } = modal;
        let modal = self.elastic.map(|elastic| elastic.recover(&arms, &solution.forces, &solution.motion));
        // What looks at stiffness sees that of the bodies, not what inertia leaves of it in a step.
        if let Some([compliance, arms]) = statics {
            (problem.compliance, problem.arms) = (compliance, arms);
        }
        let step = StepResult {
            time,
            patches,
            modal: modal.unwrap_or_default(),
            velocity: Vec::new(),
            beside: Vec::new(),
            vibrations: OnceLock::new(),
            motion: solution.motion,
            start: Vec::new(),
            problem,
            active: solution.active,
            stops,
            certificate: solution.certificate,
            warnings,
        };
        Ok(Laid { step, footholds })
    }

    /// Where bodies come to rest as the load that springs do not bear vanishes: rigid contact at the closest approaches. `None` if they
    /// press on each other even then, as the teeth of a tight mesh do on both sides.
    fn touch_without_load(
        &self,
        time: f64,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        rest: &Rest,
    ) -> Result<Option<Laid>, EngineError> {
        let (gaps, arms) = self.rigid_contacts(candidates.iter().copied());
        let motion = match rest.rigid_limit(&gaps, &arms, &self.limit_direction(), &self.system.interrupt) {
            Ok(Some(limit)) => limit.motion,
            Ok(None) => return Ok(None),
            Err(ContactError::Jammed) if self.both_sides() => return Ok(None),
            Err(error) => return Err(self.explain(&error)),
        };
        let patches = candidates.iter().map(|candidate| self.space.patch(candidate, None)).collect();
        let footholds = candidates.iter().map(|candidate| Foothold {
            pair: candidate.teeth.0,
            action: self.space.approaching(candidate),
            // No grid; but teeth are looked for as near as this.
            reach: SEARCH_DEPTH * candidate.length / DRIFT,
        });
        let problem = ContactProblem {
            compliance: Vec::new(),
            arms: Vec::new(),
            gaps: Vec::new(),
            stiffness: self.springs.stiffness.clone(),
            load: load.to_vec(),
        };
        let certificate = problem.certify(&[], &motion);
        let (active, stops, warnings) = (Vec::new(), Vec::new(), Vec::new());
        let start = Vec::new();
        let footholds = footholds.collect();
        let (modal, velocity, beside) = (Vec::new(), Vec::new(), Vec::new());
        let step = StepResult {
            time,
            patches,
            motion,
            modal,
            velocity,
            beside,
            vibrations: OnceLock::new(),
            start,
            problem,
            active,
            stops,
            certificate,
            warnings,
        };
        Ok(Some(Laid { step, footholds }))
    }

    /// For each patch whose size was left open and turns out to be unsuitable, a better one.
    fn better_sizes(
        &self,
        candidates: &[&Candidate<S::Site>],
        grids: &[S::Grid],
        forces: &[f64],
    ) -> Vec<Option<S::Size>> {
        let mut rest = forces;
        let laid = candidates.iter().zip(grids);
        laid.map(|(candidate, grid)| {
            let (own, others) = rest.split_at(self.space.count(grid));
            rest = others;
            self.space.better_size(candidate, grid, own, self.in_time)
        })
        .collect()
    }

    /// For each patch the force that would balance the whole load alone, or its part where several meshes bear one load, as planets do. A
    /// patch that no load acts on directly passes on what others carry.
    fn largest_forces(&self, load: &[f64], candidates: &[&Candidate<S::Site>]) -> Vec<f64> {
        let largest_arm = |freedom: usize| {
            candidates.iter().map(|candidate| candidate.nearest.arms[freedom].abs()).fold(0.0, f64::max)
        };
        let worth: Vec<f64> = (0..load.len()).map(|freedom| WORTH_LOADING * largest_arm(freedom)).collect();
        // Meshes, with both sides of their teeth, that bear on a freedom.
        let mesh = |candidate: &&Candidate<S::Site>| {
            let pair = candidate.teeth.0;
            self.system.scene.pairs[pair].front.map_or(pair, |front| front.0)
        };
        let meshes: Vec<f64> = (0..load.len())
            .map(|freedom| {
                let bears = |candidate: &&&Candidate<S::Site>| {
                    let arm = candidate.nearest.arms[freedom];
                    arm != 0.0 && arm.abs() >= worth[freedom]
                };
                let mut bearing: Vec<usize> = candidates.iter().filter(bears).map(mesh).collect();
                bearing.sort_unstable();
                bearing.dedup();
                bearing.len() as f64
            })
            .collect();
        let alone = |candidate: &&Candidate<S::Site>| {
            let all = candidate.nearest.arms.iter().zip(load).zip(worth.iter().zip(&meshes));
            let balancing = all.filter(|((arm, _), (worth, _))| **arm != 0.0 && arm.abs() >= **worth);
            balancing.map(|((arm, load), (_, meshes))| (load / arm).abs() / meshes).fold(0.0, f64::max)
        };
        let mut forces: Vec<f64> = candidates.iter().map(alone).collect();
        // Where there is no load, the overlaps tell the size of the forces.
        let pressed = |candidate: &&Candidate<S::Site>| {
            self.space.force_of_overlap(candidate, (-candidate.nearest.gap).max(0.0))
        };
        let largest = match forces.iter().copied().fold(0.0, f64::max) {
            0.0 => candidates.iter().map(pressed).fold(0.0, f64::max),
            loaded => loaded,
        };
        for force in forces.iter_mut().filter(|force| **force == 0.0) {
            *force = largest;
        }
        forces
    }

    fn problem(
        &self,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        grids: &[S::Grid],
    ) -> Result<(ContactProblem, Modal), EngineError> {
        let laid: Vec<(&Candidate<S::Site>, &S::Grid)> = candidates.iter().copied().zip(grids).collect();
        let count: usize = grids.iter().map(|grid| self.space.count(grid)).sum();
        self.system.interrupt.room_for(MATRICES * (count * count * size_of::<f64>()) as u64)?;
        let cells = ContactProblem {
            compliance: self.space.compliance(&laid)?,
            arms: laid.iter().flat_map(|(candidate, grid)| self.space.arms(candidate, grid)).collect(),
            gaps: grids.iter().flat_map(|grid| self.space.gaps(grid)).collect(),
            stiffness: self.springs.stiffness.clone(),
            load: load.to_vec(),
        };
        let mut problem = self.springs.behind(cells, self.space.by_lugs(&laid).as_ref());
        let Some(elastic) = self.elastic else {
            return Ok((problem, Modal { arms: Mat::zeros(0, 0), statics: None }));
        };
        let modal = Modal {
            arms: self.space.modal_arms(&laid, elastic.modes),
            statics: Some([problem.compliance.clone(), problem.arms.clone()]),
        };
        elastic.eliminate(&mut problem, &modal.arms);
        Ok((problem, modal))
    }

    /// Cells to begin the search with. Of a lug one flank bears at most; to begin with both is to begin with none. In equilibrium those
    /// bear that stop rigid bodies, in a step in time what bears follows with the step.
    fn guess(
        &self,
        load: &[f64],
        candidates: &[&Candidate<S::Site>],
        problem: &ContactProblem,
        grids: &[S::Grid],
    ) -> Vec<usize> {
        let flanks = self.system.flanks();
        if flanks == 0 {
            return self.space.guess(problem, grids);
        }
        let first = problem.cells() - flanks;
        let mut guess: Vec<usize> = (0..first).collect();
        if self.sizing.is_none() {
            let (gaps, arms) = self.rigid_contacts(candidates.iter().copied());
            let rest = rest(&self.springs.stiffness, load);
            if let Ok(Some(limit)) = rest.rigid_limit(&gaps, &arms, load, &self.system.interrupt) {
                let of_flanks = limit.touching.iter().filter_map(|at| at.checked_sub(gaps.len() - flanks));
                guess.extend(of_flanks.map(|flank| first + flank));
            }
        }
        guess
    }

    /// Friction of each patch's cells, see [`Patch::drag`], and what of it is on the freedoms, see [`solve_with_friction`].
    fn friction(
        &self,
        time: f64,
        candidates: &[&Candidate<S::Site>],
        grids: &[S::Grid],
    ) -> (Vec<Vec<[f64; 3]>>, Vec<f64>) {
        let scene = self.system.scene;
        let (mut drags, mut works) = (Vec::with_capacity(grids.len()), Vec::new());
        for (candidate, grid) in candidates.iter().zip(grids) {
            let pair = &scene.pairs[candidate.teeth.0];
            let action = self.space.action(candidate, grid);
            let drag = action.drag(self.system, pair, time, self.start);
            works.extend(action.works(self.system, pair, time, &drag, self.start));
            drags.push(drag);
        }
        (drags, works)
    }

    /// A failure of the contact solver in the words of the model.
    fn explain(&self, error: &ContactError) -> EngineError {
        holding::explain(self.system.scene, &self.system.freedoms, error)
    }
}

fn difference(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter().zip(other).map(|(one, other)| one - other).collect()
}

/// That a grid does not suit its patch, and which width (m) would.
fn unsuitable(scene: &Scene, pair: &SurfacePair, too_wide: bool, better: f64) -> String {
    let bodies = pair.bodies.map(|body| scene.bodies[body.0].name.as_str());
    let trouble = if too_wide {
        "is too wide: only a few of its cells carry load"
    } else {
        "is too narrow: the pressure does not fall to zero inside it"
    };
    // To two digits, so that the positions of a cycle say the same.
    let better: f64 = format!("{:.1e}", better * 1e3).parse().unwrap_or(better * 1e3);
    format!(
        "the contact grid of \"{}\" and \"{}\" {trouble}; `grid_width = {better} mm` suits it",
        bodies[0], bodies[1]
    )
}
