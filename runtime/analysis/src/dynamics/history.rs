//! Transient analysis from its start through all time steps, row by row.

mod error_evidence;

use crate::analysis::{ERRORS, Event, Observer, check_solved, refuse_nan, requests_fields};
use crate::component_recorder::ComponentRecorder;
use crate::dynamic_options::{DynamicOptions, Start};
use crate::estimate::{self, Estimates};
use crate::observables::Observe;
use crate::observables::{CampbellDiagram, Equilibrium, ModesTable};
use crate::options::AnalysisOptions;
use crate::results::{AnalysisResult, Timing};
use crate::rows::{Solved, StepRow};
use crate::scene::Scene;
use crate::summary::summarize;
use crate::validate::Request;
use calyx_contact::problem::Certificate;
use calyx_model::load::Wrench;
use calyx_model::observed::OutputRequest;
use calyx_model::plan::Plan;
use calyx_model::position::Position;
use calyx_model::resources::Resources;
use calyx_model::target::Examined;
use calyx_numerics::error::EngineError;
use calyx_solve::integration::{EffectiveMatrix, Forces, Matrices, State, Step, kept_positions, steps};
use calyx_solve::modal::{ModalElimination, Modes};
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use calyx_solve::vibration::check_vibrations;
use calyx_structure::cache::OperatorCache;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Size of the structure cache for perturbed solves, bytes, if there is no other cache.
const KEPT: usize = 1 << 30;

/// Transient analysis in progress: an iterator over the recorded rows, in order. After an error it
/// ends.
pub struct History<'s> {
    scene: &'s Scene,
    outputs: &'s [OutputRequest],
    options: DynamicOptions,
    resources: Resources,
    plan: Plan,
    timing: Timing,
    system: System<'s>,
    recorder: Option<ComponentRecorder>,
    /// Modes of gears, or in three dimensions of elastic connections.
    modes: Modes,
    positions: Vec<Position>,
    steps: Vec<Step>,
    /// Number of steps taken.
    taken: usize,
    state: State,
    /// Contact forces on all coordinates in this state, per width of the model.
    contact: Vec<f64>,
    /// Load for the sizes of contact grids.
    sizing: Vec<f64>,
    solved: Vec<Solved>,
    current: Option<StepResult>,
    failed: bool,
    /// Requested options, without rows of earlier runs.
    analysis: AnalysisOptions,
    /// For a perturbed solve: magnitude up to which an output may consist of rounding, by output.
    rounding: Option<Vec<f64>>,
    /// Time spent on steps.
    solving: Duration,
}

impl<'s> History<'s> {
    /// Plans the analysis, builds the structures and computes the modes.
    ///
    /// # Errors
    /// E0762 to E0764, E0767: transient analysis does not support the scene or the options; those
    /// of [`crate::analysis::PlannedAnalysis`]; those of the interrupt.
    pub fn new(
        scene: &'s Scene,
        outputs: &'s [OutputRequest],
        options: &AnalysisOptions,
        dynamics: &DynamicOptions,
        observer: &mut dyn Observer,
    ) -> Result<Self, EngineError> {
        let mut timing = Timing::default();
        let mut analysis = AnalysisOptions { solved: Vec::new(), ..options.clone() };
        if analysis.error_estimates == Estimates::Full {
            analysis.resources.cache.get_or_insert_with(|| Arc::new(OperatorCache::new(KEPT)));
        }
        let highest = options.highest_frequency;
        let request = Request::new(scene, outputs, dynamics, options);
        let plan = timing.stage("plan", || request.plan(&options.resources.interrupt))?;
        let positions = kept_positions(dynamics.from, &dynamics.ranges);
        check_solved(&options.solved, &positions, outputs)?;
        observer.observe(Event::Planned(&plan))?;
        observer.observe(Event::Stage("structures"))?;
        let mut system = timing.stage("structures", || System::with(scene, &plan, &analysis.resources))?;
        timing.structures = system.structure_counts();
        system.modes = timing.stage("modes", || Modes::find(scene, &plan, &options.resources, highest))?;
        check_vibrations(&system, scene)?;
        let modes = system.all_modes();
        let count = system.dofs.len() + modes.count();
        let sizing = system.load_at(dynamics.from)?;
        let all: Vec<Step> = steps(dynamics.from, &dynamics.ranges).collect();
        let records = options.component_loads && options.solved.is_empty();
        let mut history = History {
            scene,
            outputs,
            options: dynamics.clone(),
            resources: options.resources.clone(),
            plan,
            timing,
            system,
            recorder: records.then(|| ComponentRecorder::new(scene)),
            modes,
            positions,
            solving: Duration::ZERO,
            steps: all,
            taken: 0,
            state: State::at_rest(vec![0.0; count]),
            contact: vec![0.0; count],
            sizing,
            solved: Vec::new(),
            current: None,
            failed: false,
            analysis,
            rounding: None,
        };
        history.resume_after(options.solved.clone())?;
        observer.observe(Event::Stage("positions"))?;
        Ok(history)
    }

    /// Resumes after the rows of an earlier run, in the state of the last one.
    fn resume_after(&mut self, solved: Vec<Solved>) -> Result<(), EngineError> {
        let Some(last) = solved.last() else { return Ok(()) };
        let count = self.state.displacement.len();
        let (state, contact) = last.state.split_at(3 * count.min(last.state.len() / 3));
        let state = State::of_row(state, count).filter(|_| contact.len() == count).ok_or_else(|| {
            EngineError::new("E0724", "the stored rows belong to another analysis", "start a new run")
        })?;
        self.contact = contact.to_vec();
        let kept = solved.len() - 1;
        let ends = self.steps.iter().enumerate().filter(|(_, step)| step.kept).map(|(index, _)| index + 1);
        self.taken = std::iter::once(0).chain(ends).nth(kept).unwrap_or(self.steps.len());
        (self.state, self.solved) = (state, solved);
        Ok(())
    }

    /// Returns the plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Returns the number of modal coordinates.
    pub fn modal_coordinates(&self) -> usize {
        self.modes.count()
    }

    /// Returns the state at the end of the last step.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Returns the number of all rows.
    pub fn rows(&self) -> usize {
        self.positions.len()
    }

    /// Returns the rows so far.
    pub fn solved(&self) -> &[Solved] {
        &self.solved
    }

    /// Returns the end of the last recorded step in the form that observables use.
    pub fn equilibrium(&self) -> Option<Equilibrium<'_>> {
        Some(Equilibrium::new(&self.system, self.current.as_ref()?))
    }

    /// Computes the next row.
    fn advance(&mut self) -> Result<(), EngineError> {
        let (mut passed, mut warnings) = (Certificate::default(), Vec::new());
        let step = match self.solved.len() {
            0 => self.begin()?,
            _ => loop {
                self.resources.interrupt.check()?;
                let Some(next) = self.steps.get(self.taken).copied() else { return Ok(()) };
                let CompletedStep { mut result, state, contact } = self.step(&next, &self.state)?;
                // Residuals of steps without a row are reported with the next row.
                passed = passed.worst(&result.certificate);
                for warning in std::mem::take(&mut result.warnings) {
                    if !warnings.contains(&warning) {
                        warnings.push(warning);
                    }
                }
                (self.state, self.contact) = (state, contact);
                self.taken += 1;
                if next.kept {
                    result.certificate = passed;
                    result.warnings = std::mem::take(&mut warnings);
                    break result;
                }
            },
        };
        let position = self.positions[self.solved.len()].clone();
        let observed = self.system.values(&step, self.plan.fidelity, &self.scene.observables);
        if let Some(recorder) = &mut self.recorder {
            let of_position = (self.scene, &observed[..]);
            recorder.push(recorder.evaluate(&self.system, &step, self.plan.fidelity, of_position));
        }
        self.resources.interrupt.check()?;
        self.note_rounding(&observed, position.time);
        let row = StepRow::new(position, self.outputs, &observed, step.warnings.clone());
        refuse_nan(&row, self.outputs, &self.plan)?;
        let state = [self.state.to_row().as_slice(), &self.contact].concat();
        self.solved.push(Solved { row, certificate: step.certificate, state });
        self.current = Some(step);
        Ok(())
    }

    /// Computes the start and its state.
    fn begin(&mut self) -> Result<StepResult, EngineError> {
        let (time, system) = (self.options.from, &self.system);
        let part = self.options.ranges.first().map_or(1.0, |range| range.load_at(0.0));
        match self.options.start {
            Start::Equilibrium => {
                let matrices = Matrices::at(system, time)?;
                let mut load = system.scaled_load(time, part)?;
                load.iter_mut().zip(&matrices.load).for_each(|(load, own)| *load += own);
                let squares = self.modes.squares.clone();
                let (m, count) = (load.len(), squares.len());
                let elastic = ModalElimination {
                    modes: &self.modes,
                    coupling: vec![0.0; m * count],
                    load: matrices.modal_load.clone(),
                    start: vec![0.0; count],
                    stiffness: squares,
                };
                let with = Some(&elastic).filter(|_| count > 0);
                let mut step = system.begin(time, &load, with, &self.sizing)?;
                if step.modal.len() != count {
                    step.modal = elastic.load.iter().zip(&elastic.stiffness).map(|(g, d)| g / d).collect();
                }
                let at = Step { time, length: 0.0, load: part, kept: true };
                let state = State::at_rest([step.motion.as_slice(), &step.modal].concat());
                step.velocity = state.velocity.clone();
                // The static solution has no velocity relative to the prescribed motion.
                let nothing = matrices.following(system, &state.velocity, &state.velocity);
                step.other_loads = self.other_loads(&matrices, &at, &nothing, &state);
                let springs = system.springs_with(time, &system.tangents_at(time, &step.motion)?)?;
                let rest = EffectiveMatrix {
                    matrix: &springs.stiffness,
                    coupling: &elastic.coupling,
                    stiffness: &elastic.stiffness,
                };
                load.iter_mut().zip(&springs.load).for_each(|(load, own)| *load += own);
                load.extend(&elastic.load);
                self.contact = difference(&rest.times(&state.displacement), &load);
                self.state = state;
                Ok(step)
            }
            Start::Frames => {
                // The initial accelerations are those of a step of negligible length.
                let at_once = 1e-6 * self.steps.first().map_or(1.0, |step| step.length);
                let step = Step { time, length: at_once, load: part, kept: true };
                let CompletedStep { mut result, state, contact } = self.step(&step, &self.state)?;
                self.state.acceleration = state.acceleration;
                self.contact = contact;
                result.motion = self.state.displacement[..result.motion.len()].to_vec();
                result.velocity = self.state.velocity.clone();
                Ok(result)
            }
        }
    }

    /// Takes a step from a state; returns the result and the new state.
    fn step(&self, step: &Step, state: &State) -> Result<CompletedStep, EngineError> {
        let (h, scheme, system) = (step.length, self.options.scheme, &self.system);
        let (m, count) = (system.dofs.len(), self.modes.count());
        let matrices = Matrices::at(system, step.time)?;
        let warnings = matrices.warnings(system, h)?;
        let predicted = scheme.predicted(state, h);
        let tangents = system.tangents_at(step.time, &predicted.displacement[..m])?;
        let springs = system.springs_with(step.time, &tangents)?;
        let [of_mass, of_damping, _] = scheme.weights(h);
        let [by_mass, by_stiffness] = self.options.rayleigh;
        let (x, v) = (&predicted.displacement, &predicted.velocity);

        // DOFs: M y'' + (C + a M + b K) y' + K y.
        let mut matrix = vec![0.0; m * m];
        let mut load = system.scaled_load(step.time, step.load)?;
        for i in 0..m {
            load[i] += springs.load[i] + matrices.load[i];
            for j in 0..m {
                let (mass, spring) = (matrices.mass[i * m + j], springs.stiffness[i * m + j]);
                let damping = matrices.damping[i * m + j] + by_mass * mass + by_stiffness * spring;
                matrix[i * m + j] = of_mass * mass + of_damping * damping + spring;
                load[i] -= damping * v[j] + spring * x[j];
            }
            for k in 0..count {
                load[i] -= by_mass * matrices.coupling[i * count + k] * v[m + k];
            }
        }
        // Modal coordinates, with unit modal mass.
        let mut stiffness = vec![0.0; count];
        load.extend(&matrices.modal_load);
        for k in 0..count {
            let square = self.modes.squares[k];
            let damping = by_mass + by_stiffness * square;
            stiffness[k] = of_mass + of_damping * damping + square;
            load[m + k] -= damping * v[m + k] + square * x[m + k];
            for i in 0..m {
                load[m + k] -= by_mass * matrices.coupling[i * count + k] * v[i];
            }
        }
        let coupled = of_mass + of_damping * by_mass;
        let coupling: Vec<f64> = matrices.coupling.iter().map(|entry| coupled * entry).collect();

        // Terms that would make the matrix unsymmetric, from the solution with the contact forces
        // of the previous step.
        let effective = EffectiveMatrix { matrix: &matrix, coupling: &coupling, stiffness: &stiffness };
        let following = |y: &[f64]| {
            let rates: Vec<f64> = y.iter().map(|y| of_damping * y).collect();
            matrices.on_coordinates(system, &matrices.following(system, y, &rates))
        };
        let known = matrices.on_coordinates(system, &matrices.following(system, x, v));
        let meanwhile: Vec<f64> = (0..m + count).map(|i| load[i] + known[i] + self.contact[i]).collect();
        let untouched = effective.free(&meanwhile, following);
        let end = |from: &[f64], by: f64| match &untouched {
            Some(y) => from.iter().zip(y).map(|(from, y)| from + by * y).collect(),
            None => from.to_vec(),
        };
        let following: Forces = matrices.following(system, &end(x, 1.0), &end(v, of_damping));
        let more = matrices.on_coordinates(system, &following);
        load.iter_mut().zip(more).for_each(|(load, more)| *load += more);

        let modal_load = load.split_off(m);
        // The solution of contact has the nonlinear bearings in place of their tangents.
        let (mut within, mut applied) = (matrix.clone(), load.clone());
        if system.has_nonlinear_bearings() {
            let linear = system.linear_springs(step.time)?;
            for i in 0..m {
                applied[i] -= springs.load[i] - linear.load[i];
                for j in 0..m {
                    let tangent = springs.stiffness[i * m + j] - linear.stiffness[i * m + j];
                    within[i * m + j] -= tangent;
                    applied[i] += tangent * x[j];
                }
            }
        }
        let elastic = ModalElimination {
            modes: &self.modes,
            stiffness: stiffness.clone(),
            coupling: coupling.clone(),
            load: modal_load,
            start: x[m..].to_vec(),
        };
        let start = &x[..m];
        let moving = springs.stepping(start, within);
        let with = Some(&elastic).filter(|_| count > 0);
        let mut result = system.step(step.time, &moving, &applied, start, with, &self.sizing)?;
        let mut y = difference(&result.motion, start);
        y.extend(&result.modal);
        load.extend(&elastic.load);
        let contact = difference(&effective.times(&y), &load);
        let state = scheme.corrected(predicted.clone(), &y, h);
        result.modal = state.displacement[m..].to_vec();
        result.velocity = state.velocity.clone();
        result.other_loads = self.other_loads(&matrices, step, &following, &state);
        // The damping proportional to the stiffness of bearings and elastic connections, which
        // these do not report themselves.
        if by_stiffness > 0.0 {
            let rates = &state.velocity[..m];
            let forces = system.spring_forces(step.time, &tangents, rates)?;
            for (body, force) in forces.into_iter().enumerate() {
                matrices.add_on_body(
                    &mut result.other_loads[body],
                    body,
                    force.map(|part| by_stiffness * part),
                );
            }
        }
        result.warnings.extend(warnings);
        // Observables use the springs of the scene, not the matrix of a step.
        result.problem.stiffness = springs.stiffness;
        Ok(CompletedStep { result, state, contact })
    }

    /// Returns the forces on each body besides contact, bearings and its whole load.
    fn other_loads(
        &self,
        matrices: &Matrices,
        step: &Step,
        following: &Forces,
        state: &State,
    ) -> Vec<[f64; 6]> {
        // Mass-proportional damping acts like an acceleration proportional to the rate.
        let [by_mass, _] = self.options.rayleigh;
        let rates = state.acceleration.iter().zip(&state.velocity);
        let resisted: Vec<f64> = rates.map(|(a, v)| a + by_mass * v).collect();
        let mut all = matrices.inertia(&self.system, following, &resisted);
        for (wrench, body) in all.iter_mut().zip(&self.system.scene.bodies) {
            let Wrench { force: [fx, fy, fz], moment: [mx, my, mz] } = body.load.at(step.time);
            for (part, whole) in wrench.iter_mut().zip([fx, fy, fz, mx, my, mz]) {
                *part += (step.load - 1.0) * whole;
            }
        }
        all
    }

    /// Computes the table of modes and the Campbell diagram about the start. It computes the start
    /// again, because a resumed run has not solved it.
    fn first_modes(&mut self) -> (Option<ModesTable>, Option<CampbellDiagram>) {
        let first = if self.scene.examines_modes() { self.begin().ok() } else { None };
        first.map_or((None, None), |first| {
            Equilibrium::new(&self.system, &first)
                .requested_modes(self.scene.modes_table.as_ref(), self.scene.campbell_diagram.as_ref())
        })
    }

    /// Computes the summaries, and estimates errors if requested.
    ///
    /// # Errors
    /// Those of the interrupt.
    pub fn finish(mut self) -> Result<AnalysisResult, EngineError> {
        let first = Certificate::default();
        let certificate = self.solved.iter().fold(first, |worst, solved| worst.worst(&solved.certificate));
        let (modes, campbell) = self.first_modes();
        let solved = std::mem::take(&mut self.solved);
        let rows: Vec<StepRow> = solved.into_iter().map(|solved| solved.row).collect();
        let mut summaries = summarize(&rows, self.outputs, self.scene);
        let recorder = self.recorder.take();
        let component_loads = recorder.map(|recorder| recorder.finish(&rows, self.scene));
        self.timing.add("positions", self.solving);
        if self.analysis.error_estimates != Estimates::None {
            let started = Instant::now();
            let evidence = self.evidence(&rows)?;
            estimate::attach(&mut summaries, &rows, self.outputs, self.scene, &evidence);
            self.timing.add(ERRORS, started.elapsed());
        }
        self.timing.memory = self.resources.interrupt.largest_request();
        Ok(AnalysisResult {
            plan: self.plan,
            rows,
            summaries,
            certificate,
            component_loads,
            modes,
            campbell,
            forced_response: None,
            sensitivities: Vec::new(),
            timing: self.timing,
            tolerance_search: None,
        })
    }
}

/// Step with its result.
struct CompletedStep {
    result: StepResult,
    state: State,
    /// Contact forces on all coordinates, per width of the model.
    contact: Vec<f64>,
}

fn difference(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter().zip(other).map(|(one, other)| one - other).collect()
}

impl Iterator for History<'_> {
    type Item = Result<Solved, EngineError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.failed || self.solved.len() >= self.positions.len() {
            return None;
        }
        let started = Instant::now();
        let resources = self.resources.clone();
        let advanced = resources.install(|| self.advance());
        self.solving += started.elapsed();
        match advanced {
            Ok(()) => self.solved.last().cloned().map(Ok),
            Err(error) => {
                self.failed = true;
                Some(Err(error))
            }
        }
    }
}

/// Runs a transient analysis from planning to results and reports its events to an observer.
///
/// # Errors
/// Those of [`History::new`] and of its steps, and of the observer.
pub fn dynamic(
    scene: &Scene,
    outputs: &[OutputRequest],
    options: &AnalysisOptions,
    dynamics: &DynamicOptions,
    observer: &mut dyn Observer,
) -> Result<AnalysisResult, EngineError> {
    let mut history = History::new(scene, outputs, options, dynamics, observer)?;
    let displayed = history.timing.displayed(scene, &history.plan, options)?;
    while let Some(solved) = history.next() {
        let solved = &solved?;
        let (index, count) = (history.solved().len() - 1, history.rows());
        let requested = requests_fields(options.fields, index, count);
        let fields = history.equilibrium().filter(|_| requested).map(|at| at.fields_with(&displayed));
        let fields = fields.transpose()?;
        observer.observe(Event::Step { index, count, solved, fields: fields.as_ref() })?;
    }
    if options.error_estimates != Estimates::None {
        observer.observe(Event::Stage(ERRORS))?;
    }
    history.finish()
}

#[cfg(test)]
mod ring_tests;
#[cfg(test)]
mod tests;
