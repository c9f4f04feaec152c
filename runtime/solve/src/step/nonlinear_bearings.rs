//! Bearings with a nonlinear load in equilibrium with contact: rolling bearings and load curves.
//!
//! The load is a function of the deflection. Each contact problem has the tangents of all bearings,
//! and its solution gives their next deflections: a proximal Newton method on the total potential
//! energy, which is exact for contact and quadratic for bearings. The grids of contact do not
//! change in this iteration, so the energy is one convex function (nearly so with balls). A step
//! ends where the work of the bearings attains that of their linearization, which decreases an
//! upper bound of the energy without another contact problem. A multiple of the typical stiffness
//! restrains bearings within their clearances; it vanishes with the convergence.
//!
//! Raceways may belong to elastic bodies, which add their displacements at each element to the
//! deflections. The bore of a gear is eliminated from the contact problem
//! ([`calyx_model::bearing::ElasticRaceways`]), and so are seats of elastic bodies ([`seats`]).
//!
//! If springs carry the load without contact, there are no cells, and the same iteration repeats
//! the rigid-body limit.
//!
//! In a time step the same iteration has the inertia and damping of the step in addition, and
//! starts from the deflections at the start of the step.
//!
//! See `docs/theory/rolling-bearings.md`.

mod linearization;
mod raceways;
mod seats;
mod unbalanced;

pub(super) use seats::SeatResponse;

use super::{RacewayResult, StepResult};
use crate::system::System;
use calyx_contact::problem::{ContactProblem, Solution};
use calyx_model::bearing::{
    BearingState, ElasticRaceways, NonlinearLoad, NonlinearState, PlacedRaceway, SeatTerms, Springs, Tangent,
    by_element,
};
use calyx_model::dof::Dof;
use calyx_numerics::error::EngineError;
use nalgebra::DMatrix;
use seats::{SeatedBodies, seated_bodies};
use std::cell::{Cell, RefCell};

/// Largest number of contact problems with the same grids.
const ROUNDS: usize = 100;
/// Difference between the load of a bearing and its linearization, relative to the largest load of
/// a bearing and to the external load.
const TOLERANCE: f64 = 1e-11;
/// Difference below which rounding may end the iteration.
const ROUNDING: f64 = 1e-9;
/// First and least multiple of the typical stiffness.
const ADDITIONS: [f64; 2] = [1e-2, 1e-12];
/// Multiple of the typical stiffness with which a solution is accepted.
const NEGLIGIBLE: f64 = 1e-9;
/// Excess of the work of the bearings over that of their linearization, relative to the work of
/// the step, that a step may have.
const MOST_EXCESS: f64 = 0.25;
/// Longest step, in multiples of the reach of a bearing
/// ([`NonlinearLoad::reach`]).
const LONGEST_STEP: f64 = 5.0;
/// Largest number of evaluations in the search for the length of a step.
const SEARCHES: usize = 30;

/// A bearing of the scene with a nonlinear load.
struct Member {
    /// Index in the scene.
    bearing: usize,
    nonlinear: NonlinearLoad,
    /// Elastic raceways, if there are any.
    raceways: Option<ElasticRaceways>,
    /// Deflection by DOF.
    arms: Vec<[f64; 6]>,
    /// Length that makes moments comparable with forces, m.
    radius: f64,
    /// Width to which forces of a plane model refer, m.
    width: f64,
}

/// Nonlinear bearings of a system at a time, with the springs and loads besides them.
pub(super) struct NonlinearBearings<'a> {
    system: &'a System<'a>,
    members: Vec<Member>,
    /// Elastic bodies with members in their seats.
    seated: Vec<SeatedBodies>,
    /// Springs without the nonlinear load.
    base: Springs,
    /// External load.
    load: Vec<f64>,
    /// Largest external force, N; moments count by the radius of the largest bearing.
    scale: f64,
    /// True once a contact problem had the tangents.
    is_solved: Cell<bool>,
    /// Equilibrium of the last grids: the first estimate for others.
    last: RefCell<Option<NonlinearIteration>>,
    /// True for a time step, whose contact problems contain the springs and loads besides the
    /// bearings, relative to its start.
    in_time: bool,
}

/// State of the iteration.
#[derive(Clone)]
pub(super) struct NonlinearIteration {
    states: Vec<NonlinearState>,
    /// Multiple of the typical stiffness in the tangents.
    addition: f64,
    /// Last residual.
    residual: f64,
    /// Index of the scene of the bearing with the largest residual.
    worst: usize,
}

impl System<'_> {
    /// Returns the tangents of nonlinear bearings at deviations from the prescribed motions at a
    /// time (s), by bearing of the scene.
    ///
    /// # Errors
    /// Those of [`NonlinearLoad::state`].
    pub fn tangents_at(&self, time: f64, motion: &[f64]) -> Result<Vec<Option<Tangent>>, EngineError> {
        let mut by_scene = vec![None; self.scene.bearings.len()];
        for member in members(self, time, false)? {
            let state = member.nonlinear.state(None, member.deflection(motion))?;
            by_scene[member.bearing] = Some(member.nonlinear.tangent(&state, 0.0));
        }
        Ok(by_scene)
    }

    /// Returns the springs at a time (s) without the nonlinear bearings.
    ///
    /// # Errors
    /// Those of [`System::springs_with`].
    pub fn linear_springs(&self, time: f64) -> Result<Springs, EngineError> {
        self.springs_with(time, &vec![Some(Tangent::default()); self.scene.bearings.len()])
    }

    /// Returns whether bearings with a nonlinear load are modelled.
    pub fn has_nonlinear_bearings(&self) -> bool {
        self.bearings.iter().any(|&bearing| self.scene.bearings[bearing].nonlinear.is_some())
    }

    /// Solves the equilibrium with nonlinear bearings under a load at a time (s). `solve` solves
    /// the position with given tangents, by bearing of the scene, and elastic bodies with rollers
    /// in their seats; without tangents, bearings have their typical stiffness. Raceways in elastic
    /// bodies are rigid on request.
    ///
    /// # Errors
    /// E0726: the bearings do not balance their loads. Those of `solve`.
    pub(super) fn with_nonlinear_bearings(
        &self,
        time: f64,
        load: &[f64],
        solve: impl Fn(
            &[Option<Tangent>],
            Option<&NonlinearBearings<'_>>,
            &[SeatResponse],
        ) -> Result<StepResult, EngineError>,
        has_elastic_raceways: bool,
    ) -> Result<StepResult, EngineError> {
        let bearings = NonlinearBearings::new(self, time, load, has_elastic_raceways)?;
        let mut iteration = bearings.initial(&[])?;
        let is_preloaded = iteration.states.iter().any(|state| state.evaluation.scale > 0.0);
        // In the limit without load, bearings keep the middle of their clearance.
        if !is_preloaded && load.iter().all(|&load| load == 0.0) {
            let mut by_scene = vec![None; self.scene.bearings.len()];
            let mut known = true;
            for member in &bearings.members {
                by_scene[member.bearing] = member.nonlinear.unloaded_tangent();
                known &= by_scene[member.bearing].is_some();
            }
            let mut step = solve(&by_scene, None, &[])?;
            if !known {
                step.warnings.push(
                    "bearings with rolling elements or clearance have neither load nor preload: stiffness and natural frequencies are those of bearings with a typical stiffness".to_owned(),
                );
            }
            return Ok(step);
        }
        let mut step = solve(&[], Some(&bearings), &[])?;
        if bearings.is_solved.get() {
            bearings.warn(&mut step)?;
            return Ok(step);
        }
        for _ in 0..ROUNDS {
            let tangents = bearings.tangents(&iteration);
            let mut by_scene = vec![None; self.scene.bearings.len()];
            for (member, tangent) in bearings.members.iter().zip(&tangents) {
                by_scene[member.bearing] = Some(tangent.clone());
            }
            let responses = bearings.seat_responses(&tangents);
            let mut step = solve(&by_scene, Some(&bearings), &responses)?;
            let is_solved = bearings.is_solved.get();
            let mut moved = bearings.unmoved();
            bearings.move_seats(&mut moved, (&tangents, &responses), &step.motion);
            if is_solved || bearings.advance(&mut iteration, &tangents, &step.motion, &moved)? {
                if !is_solved {
                    step.raceways = bearings.raceways(&iteration);
                    step.bearings = bearings.states(&iteration);
                    step.certificate.equilibrium = step.certificate.equilibrium.max(iteration.residual);
                }
                bearings.warn(&mut step)?;
                return Ok(step);
            }
        }
        Err(bearings.unbalanced(&iteration))
    }
}

/// Returns the modelled bearings with a nonlinear load at a time (s).
fn members(system: &System<'_>, time: f64, has_elastic_raceways: bool) -> Result<Vec<Member>, EngineError> {
    let mut members = Vec::new();
    for &bearing in &system.bearings {
        let own = &system.scene.bearings[bearing];
        let Some(nonlinear) = system.nonlinear_load(bearing, time) else { continue };
        let placed = BearingState::at(&system.scene.bodies, own, time)?;
        let arms = system.dofs.iter().map(|dof: &Dof| placed.deflection(dof)).collect();
        let (radius, width) = (nonlinear.radius(), system.width(own.body.0));
        let raceways = match has_elastic_raceways {
            true => system.elastic_raceways(bearing, time)?,
            false => None,
        };
        members.push(Member { bearing, nonlinear, raceways, arms, radius, width });
    }
    Ok(members)
}

impl<'a> NonlinearBearings<'a> {
    /// Creates the bearings of an equilibrium under an external load.
    fn new(
        system: &'a System<'a>,
        time: f64,
        load: &[f64],
        has_elastic_raceways: bool,
    ) -> Result<Self, EngineError> {
        let members = members(system, time, has_elastic_raceways)?;
        let seated = seated_bodies(system, &members, time)?;
        Ok(Self::with(system, (members, seated), load, system.linear_springs(time)?, false))
    }

    /// Creates the bearings of a time step with these forces, for the scale of residuals.
    pub(super) fn in_time(system: &'a System<'a>, time: f64, load: &[f64]) -> Result<Self, EngineError> {
        let members = members(system, time, false)?;
        Ok(Self::with(system, (members, Vec::new()), load, Springs::none(system.dofs.len()), true))
    }

    fn with(
        system: &'a System<'a>,
        (members, seated): (Vec<Member>, Vec<SeatedBodies>),
        load: &[f64],
        base: Springs,
        in_time: bool,
    ) -> Self {
        let radius = members.iter().map(|own: &Member| own.radius).fold(0.0, f64::max);
        let force = |(load, dof): (&f64, &Dof)| {
            let unit = if dof.component < 3 { 1.0 } else { radius };
            system.width(dof.body) * load.abs() / unit
        };
        let scale = load.iter().zip(&system.dofs).map(force).fold(0.0, f64::max);
        let (load, is_solved, last) = (load.to_vec(), Cell::new(false), RefCell::new(None));
        Self { system, members, seated, base, load, scale, is_solved, last, in_time }
    }

    /// Returns the iteration at the equilibrium of the last grids, at bearings without deflection
    /// if there were none, or in a time step at its start.
    pub(super) fn initial(&self, start: &[f64]) -> Result<NonlinearIteration, EngineError> {
        if let Some(last) = &*self.last.borrow() {
            return Ok(last.clone());
        }
        let at = |own: &Member| if self.in_time { own.deflection(start) } else { [0.0; 5] };
        let initial = |own: &Member| {
            let state = own.nonlinear.state(None, at(own))?;
            match own.elements() {
                0 => Ok(state),
                elements => own.nonlinear.state_on(&state, at(own), &vec![[0.0; 3]; elements]),
            }
        };
        let states = self.members.iter().map(initial);
        Ok(NonlinearIteration {
            states: states.collect::<Result<_, _>>()?,
            // In a time step inertia restrains bearings within their clearances.
            addition: if self.in_time { ADDITIONS[1] } else { ADDITIONS[0] },
            residual: f64::INFINITY,
            worst: self.members.first().map_or(0, |own| own.bearing),
        })
    }

    /// Starts other grids from bearings without deflection.
    pub(super) fn forget(&self) {
        self.last.replace(None);
        self.await_solution();
    }

    /// Takes solutions so far as estimates.
    pub(super) fn await_solution(&self) {
        self.is_solved.set(false);
    }

    /// Solves a contact problem, whose motions are relative to `start`, with the bearings in
    /// equilibrium. `solve` solves a problem from an active set. The iteration starts from the
    /// given one and replaces it. `growths` are those of the gaps of cells by unit loads on elastic
    /// raceways, by bearing: none for rigid ones.
    ///
    /// # Errors
    /// E0726: the bearings do not balance their loads. Those of `solve`.
    pub(super) fn equilibrium(
        &self,
        iteration: &mut NonlinearIteration,
        mut problem: ContactProblem,
        (growths, start): (&[Option<DMatrix<f64>>], &[f64]),
        mut guess: Vec<usize>,
        solve: impl Fn(ContactProblem, &[usize]) -> Result<(ContactProblem, Solution), EngineError>,
    ) -> Result<(ContactProblem, Solution), EngineError> {
        iteration.residual = f64::INFINITY;
        let step = self.in_time.then(|| [problem.stiffness.clone(), problem.load.clone()]);
        let yields = growths.iter().any(Option::is_some);
        let rigid = yields.then(|| [&problem.compliance, &problem.arms, &problem.gaps].map(Vec::clone));
        for _ in 0..ROUNDS {
            let tangents = self.tangents(iteration);
            let responses = self.seat_responses(&tangents);
            match &step {
                Some(step) => self.put_in_step(&mut problem, step, &tangents, start),
                None => self.put(&mut problem, (&tangents, &responses), start),
            }
            if let Some([compliance, arms, gaps]) = &rigid {
                problem.compliance.clone_from(compliance);
                problem.arms.clone_from(arms);
                problem.gaps.clone_from(gaps);
                self.put_raceways(&mut problem, &tangents, growths, start);
                self.put_seats(&mut problem, (&tangents, &responses), growths, start);
            }
            let (solved, mut solution) = solve(problem, &guess)?;
            let motion = self.absolute(&solution.motion, start);
            let mut moved = self.moved_by(growths, &solution.forces);
            self.move_seats(&mut moved, (&tangents, &responses), &motion);
            if self.advance(iteration, &tangents, &motion, &moved)? {
                self.is_solved.set(true);
                self.last.replace(Some(iteration.clone()));
                let certificate = &mut solution.certificate;
                certificate.equilibrium = certificate.equilibrium.max(iteration.residual);
                return Ok((solved, solution));
            }
            (problem, guess) = (solved, solution.active);
        }
        Err(self.unbalanced(iteration))
    }

    fn absolute(&self, motion: &[f64], start: &[f64]) -> Vec<f64> {
        let start = start.iter().copied().chain(std::iter::repeat(0.0));
        motion.iter().zip(start).map(|(moved, start)| start + moved).collect()
    }

    fn tangents(&self, iteration: &NonlinearIteration) -> Vec<Tangent> {
        let members = self.members.iter().zip(&iteration.states);
        let tangent = |(own, state): (&Member, &NonlinearState)| {
            own.nonlinear.tangent_with(state, iteration.addition, own.raceways.as_ref())
        };
        members.map(tangent).collect()
    }

    /// Moves the iteration toward the motions of a solution with these tangents; returns whether it
    /// has converged.
    fn advance(
        &self,
        iteration: &mut NonlinearIteration,
        tangents: &[Tangent],
        motion: &[f64],
        moved: &[Vec<f64>],
    ) -> Result<bool, EngineError> {
        let members = self.members.iter().zip(tangents).zip(moved);
        let (nexts, linear): (Vec<Vec<f64>>, Vec<Vec<f64>>) =
            members.map(|((own, tangent), moved)| own.linearized(tangent, motion, moved)).unzip();
        let difference = |one: &[f64], other: &[f64]| -> Vec<f64> {
            one.iter().zip(other).map(|(one, other)| one - other).collect()
        };
        let states = || iteration.states.iter();
        let steps: Vec<Vec<f64>> =
            nexts.iter().zip(states()).map(|(next, state)| difference(next, &deflections(state))).collect();
        let excess_loads =
            linear.iter().zip(states()).map(|(linear, state)| difference(linear, &loads(state)));
        let work = inner(&steps, excess_loads);
        let limit = self.members.iter().zip(&steps).map(|(own, step)| own.longest(step)).fold(1.0, f64::min);
        let target = inner(&steps, linear.iter().cloned());
        let of = |states: &[NonlinearState]| inner(&steps, states.iter().map(loads)) - target;
        let mut length = limit;
        let mut next = self.moved(iteration, &steps, length)?;
        let mut excess = of(&next);
        if length == 1.0 {
            let last = iteration.residual;
            (iteration.residual, iteration.worst) = self.residual(&iteration.states, &next, &linear);
            // Rounding of the contact problem may leave a residual that the certificate states.
            let is_stalled = iteration.residual <= ROUNDING && iteration.residual >= 0.5 * last;
            if iteration.addition <= NEGLIGIBLE && (iteration.residual <= TOLERANCE || is_stalled) {
                iteration.states = next;
                return Ok(true);
            }
        }
        // Near the solution, rounding decides the sign of both.
        let is_near = length == 1.0 && iteration.residual <= ROUNDING;
        let (mut low, mut high) = ([0.0, -work], [length, excess]);
        for _ in 0..SEARCHES {
            if is_near || excess <= MOST_EXCESS * work && (length == limit || excess >= -MOST_EXCESS * work) {
                break;
            }
            if excess > 0.0 || excess.is_nan() {
                high = [length, excess];
                low[1] *= 0.5;
            } else {
                low = [length, excess];
                high[1] *= 0.5;
            }
            let part = low[1] / (low[1] - high[1]);
            let part = if part.is_finite() { part.clamp(0.02, 0.98) } else { 0.5 };
            length = low[0] + part * (high[0] - low[0]);
            next = self.moved(iteration, &steps, length)?;
            excess = of(&next);
        }
        iteration.addition = match length {
            1.0 => (1e-2 * iteration.addition).max(ADDITIONS[1]),
            length if length < 0.5 => (10.0 * iteration.addition).clamp(1e-6, ADDITIONS[0]),
            _ => iteration.addition,
        };
        iteration.states = next;
        Ok(false)
    }

    /// Returns the states after a part of the steps.
    fn moved(
        &self,
        iteration: &NonlinearIteration,
        steps: &[Vec<f64>],
        part: f64,
    ) -> Result<Vec<NonlinearState>, EngineError> {
        let members = self.members.iter().zip(&iteration.states).zip(steps);
        let moved = members.map(|((own, state), step)| {
            let at: Vec<f64> =
                deflections(state).iter().zip(step).map(|(at, step)| at + part * step).collect();
            let deflection = std::array::from_fn(|i| at[i]);
            match own.elements() {
                0 => own.nonlinear.state(Some(state), deflection),
                _ => own.nonlinear.state_on(state, deflection, &by_element(&at[5..])),
            }
        });
        moved.collect()
    }

    /// Returns the largest difference between the loads of states and their linearization, relative
    /// to the largest load, and its bearing. A bearing without load in its clearance has a
    /// difference of rounding only, so its own load is no scale.
    fn residual(
        &self,
        states: &[NonlinearState],
        next: &[NonlinearState],
        linear: &[Vec<f64>],
    ) -> (f64, usize) {
        let mut largest = (0.0f64, self.members.first().map_or(0, |own| own.bearing));
        let mut scale = self.scale;
        for (k, own) in self.members.iter().enumerate() {
            scale = scale.max(next[k].evaluation.scale + states[k].evaluation.scale);
            for (i, (next, linear)) in loads(&next[k]).into_iter().zip(&linear[k]).enumerate() {
                // Elements on raceways have two forces and a moment each.
                let is_force = if i < 5 { i < 3 } else { (i - 5) % 3 < 2 };
                let unit = if is_force { 1.0 } else { own.radius };
                scale = scale.max(linear.abs() / unit);
                let difference = (next - linear).abs() / unit;
                if difference.is_nan() {
                    return (f64::INFINITY, own.bearing);
                }
                if difference > largest.0 {
                    largest = (difference, own.bearing);
                }
            }
        }
        if scale > 0.0 { (largest.0 / scale, largest.1) } else { (0.0, largest.1) }
    }

    /// Returns the states of the bearings by their index in the scene.
    pub(super) fn states(&self, iteration: &NonlinearIteration) -> Vec<(usize, NonlinearState)> {
        let members = self.members.iter().zip(&iteration.states);
        members.map(|(own, state)| (own.bearing, state.clone())).collect()
    }

    /// Adds the warnings about the bearings at a solution.
    pub(super) fn warn(&self, step: &mut StepResult) -> Result<(), EngineError> {
        for own in &self.members {
            let [x, y, z, about_x, about_y] = own.deflection(&step.motion);
            let name = &self.system.scene.bearings[own.bearing].name;
            let raceway = step.raceways.iter().find(|raceway| raceway.bearing == own.bearing);
            let displaced = raceway.map(|raceway| own.nonlinear.on_raceway(&raceway.displacement));
            let nonlinear = displaced.as_ref().unwrap_or(&own.nonlinear);
            let deflection = [x, y, z, about_x, about_y, 0.0];
            let warnings = nonlinear.warnings(&deflection, step.bearing_state(own.bearing, &deflection))?;
            step.warnings.extend(warnings.iter().map(|warning| format!("bearing \"{name}\" {warning}")));
        }
        Ok(())
    }
}

impl Member {
    fn deflection(&self, motion: &[f64]) -> [f64; 5] {
        let mut deflection = [0.0; 5];
        for (arm, motion) in self.arms.iter().zip(motion) {
            for (sum, part) in deflection.iter_mut().zip(arm) {
                *sum += part * motion;
            }
        }
        deflection
    }

    /// Returns the number of elements on elastic raceways; 0 between rigid ones.
    fn elements(&self) -> usize {
        self.raceways.as_ref().map_or(0, ElasticRaceways::elements)
    }

    /// Returns the raceways in seats of elastic bodies.
    fn seats(&self) -> impl Iterator<Item = (&PlacedRaceway, SeatTerms)> + Clone {
        let raceways = self.raceways.iter().flat_map(|own| &own.raceways);
        raceways.filter_map(|raceway| Some((raceway, raceway.seat?)))
    }

    /// Returns the deflections of the solution of a contact problem with this tangent, and the
    /// linearized loads, as [`deflections`] and [`loads`]. `moved` is the displacement of
    /// elastic raceways by the forces of cells and of seats.
    fn linearized(&self, tangent: &Tangent, motion: &[f64], moved: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let deflection = self.deflection(motion);
        let (mut next, mut load) = (deflection.to_vec(), tangent.load_at(&deflection).to_vec());
        if let (Some(raceway), Some(own)) = (&self.raceways, &tangent.raceway) {
            load.iter_mut().zip(own.push_of(moved)).for_each(|(load, push)| *load += push);
            next.extend(raceway.displaced(own, &deflection, moved));
            load.extend(own.load_at(&deflection, moved).iter().map(|load| -load));
        }
        (next, load)
    }

    /// Returns the part of a step that is as long as a step may be.
    fn longest(&self, step: &[f64]) -> f64 {
        let [x, y, z, about_x, about_y] = std::array::from_fn(|i| step[i]);
        let length = x.hypot(y).hypot(z).hypot(self.radius * about_x.hypot(about_y));
        LONGEST_STEP * self.nonlinear.reach() / length
    }
}

/// Returns the work of loads on the steps of all bearings.
fn inner(steps: &[Vec<f64>], loads: impl Iterator<Item = Vec<f64>>) -> f64 {
    let work = |(step, load): (&Vec<f64>, Vec<f64>)| -> f64 {
        step.iter().zip(load).map(|(step, load)| step * load).sum()
    };
    steps.iter().zip(loads).map(work).sum()
}

/// Returns the deflections of a bearing, followed by the displacements of its elastic raceways at
/// the elements, if there are any.
fn deflections(state: &NonlinearState) -> Vec<f64> {
    state.deflection.iter().chain(state.raceway.as_flattened()).copied().collect()
}

/// Returns the loads conjugate to [`deflections`]: those of elements act on the raceways.
fn loads(state: &NonlinearState) -> Vec<f64> {
    let on_raceway = state.raceway_loads.iter().flat_map(|own| own.force.map(|force| -force));
    state.evaluation.load.iter().copied().chain(on_raceway).collect()
}

fn dot(one: &[f64; 6], other: &[f64; 6]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}
