//! Quasi-static analysis of a frozen scene over a list of positions: plan, system, steps, results.
//!
//! [`Steps`] is the analysis as an iterator; [`quasi_static`] runs all of it and reports to an
//! observer.

mod differentiation;
mod position_solver;

use self::position_solver::{Found, PositionSolver, Receiver};
use crate::component_recorder::ComponentRecorder;
use crate::estimate::{self, BaseAnalysis, Estimates, quasi_static_perturbed_solves};
use crate::forced_response::{self, ForcedResponse};
use crate::method::QuasiStatic;
use crate::observables::{CampbellDiagram, Displayed, Equilibrium, Fields, MeshedBodies, ModesTable, parts};
pub use crate::options::AnalysisOptions;
use crate::radiated_sound::{self, SoundTask};
use crate::results::SearchProgress;
use crate::results::{AnalysisResult, Timing};
use crate::rows::{Solved, StepRow};
use crate::scene::Scene;
use crate::sensitivity::SensitivityRequest;
use crate::summary::summarize;
use crate::validate::Request;
use calyx_contact::problem::Certificate;
use calyx_model::fidelity::StructureOptions;
use calyx_model::observed::OutputRequest;
use calyx_model::plan::Plan;
pub use calyx_model::position::{Position, mesh_cycle};
use calyx_model::resources::Resources;
use calyx_model::target::Examined;
use calyx_numerics::error::{EngineError, Subject};
use calyx_solve::step::{ContactState, StepResult};
use calyx_solve::system::System;
use calyx_solve::vibration::check_vibrations;

use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::VecDeque;
use std::iter::FusedIterator;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Analysis that has passed planning and the restraint check, before anything expensive.
pub struct PlannedAnalysis<'s> {
    scene: &'s Scene,
    positions: &'s [Position],
    outputs: &'s [OutputRequest],
    resources: Resources,
    solved: Vec<Solved>,
    highest_frequency: f64,
    structure: StructureOptions,
    error_estimates: Estimates,
    component_loads: bool,
    sensitivities: Option<SensitivityRequest>,
    plan: Plan,
    timing: Timing,
}

impl<'s> PlannedAnalysis<'s> {
    /// Plans the quasi-static analysis (equilibrium without inertia) of a scene at some positions.
    ///
    /// # Errors
    /// The scene cannot be modelled at this fidelity, a free motion meets no resistance, or the
    /// earlier rows belong to another analysis.
    pub fn new(
        scene: &'s Scene,
        positions: &'s [Position],
        outputs: &'s [OutputRequest],
        options: &AnalysisOptions,
    ) -> Result<Self, EngineError> {
        let mut timing = Timing::default();
        check_solved(&options.solved, positions, outputs)?;
        let highest_frequency = options.highest_frequency;
        // Check this first: structures are expensive, and the check does not need them.
        let method = QuasiStatic { positions: Cow::Borrowed(positions) };
        let request = Request::new(scene, outputs, &method, options);
        let plan = timing.stage("plan", || request.plan(&options.resources.interrupt))?;
        Ok(PlannedAnalysis {
            scene,
            positions,
            outputs,
            resources: options.resources.clone(),
            solved: options.solved.clone(),
            highest_frequency,
            structure: options.structure,
            error_estimates: options.error_estimates,
            component_loads: options.component_loads,
            sensitivities: options.sensitivities.clone(),
            plan,
            timing,
        })
    }

    /// Returns the plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Builds the structures, or takes them from the cache.
    ///
    /// # Errors
    /// A structure cannot be built, or those of the interrupt.
    pub fn build(self) -> Result<Steps<'s>, EngineError> {
        let PlannedAnalysis { scene, positions, outputs, resources, solved, highest_frequency, plan, .. } =
            self;
        let (structure, error_estimates, mut timing) = (self.structure, self.error_estimates, self.timing);
        let (component_loads, sensitivities) = (self.component_loads, self.sensitivities);
        let system = timing.stage("structures", || System::with(scene, &plan, &resources))?;
        timing.structures = system.structure_counts();
        let system = match highest_frequency {
            0.0 => system,
            highest => timing.stage("modes", || system.with_modes(&plan, &resources, highest))?,
        };
        check_vibrations(&system, scene)?;
        let recorder = (component_loads && solved.is_empty()).then(|| ComponentRecorder::new(scene));
        Ok(Steps {
            scene,
            positions,
            outputs,
            resources,
            solved,
            highest_frequency,
            structure,
            error_estimates,
            sensitivities,
            states: Vec::new(),
            plan,
            timing,
            system,
            recorder,
            forced_response: None,
            ahead: VecDeque::new(),
            solving: Duration::ZERO,
            current: None,
            failed: None,
        })
    }
}

/// Quasi-static analysis in progress: an iterator over its positions, in order.
///
/// It solves as many positions in parallel as there are threads, starting with the requested one.
/// [`quasi_static`] and [`Steps::finish`] do not wait for all of them before they solve the next.
/// After an error it ends.
pub struct Steps<'s> {
    scene: &'s Scene,
    positions: &'s [Position],
    outputs: &'s [OutputRequest],
    resources: Resources,
    solved: Vec<Solved>,
    highest_frequency: f64,
    structure: StructureOptions,
    error_estimates: Estimates,
    sensitivities: Option<SensitivityRequest>,
    /// States of contact of the solved positions, if sensitivities are requested.
    states: Vec<Option<ContactState>>,
    plan: Plan,
    timing: Timing,
    system: System<'s>,
    recorder: Option<ComponentRecorder>,
    /// Forced response, if outputs need it.
    forced_response: Option<ForcedResponse>,
    /// Following positions, solved in parallel with the requested one.
    ahead: VecDeque<Result<Found, EngineError>>,
    /// Time spent on positions, including the observer of [`quasi_static`].
    solving: Duration,
    current: Option<StepResult>,
    failed: Option<EngineError>,
}

impl<'s> Steps<'s> {
    /// Plans an analysis and builds its structures.
    ///
    /// # Errors
    /// Those of [`PlannedAnalysis::new`] and [`PlannedAnalysis::build`].
    pub fn new(
        scene: &'s Scene,
        positions: &'s [Position],
        outputs: &'s [OutputRequest],
        options: &AnalysisOptions,
    ) -> Result<Self, EngineError> {
        PlannedAnalysis::new(scene, positions, outputs, options)?.build()
    }

    /// Returns the plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Returns the system, which evaluates observables at solved positions.
    pub fn system(&self) -> &System<'s> {
        &self.system
    }

    /// Returns the last solved position, with its contact patches, cells and forces; `None` before
    /// the first.
    pub fn current(&self) -> Option<&StepResult> {
        self.current.as_ref()
    }

    /// Returns the last solved position in the form that observables use.
    pub fn equilibrium(&self) -> Option<Equilibrium<'_>> {
        Some(Equilibrium { system: &self.system, step: self.current.as_ref()? })
    }

    /// Returns all solved positions, including those of an earlier run.
    pub fn solved(&self) -> &[Solved] {
        &self.solved
    }

    /// Returns the number of all positions, solved or not.
    pub fn count(&self) -> usize {
        self.positions.len()
    }

    /// Solves the remaining positions, computes the summaries, and estimates errors if requested.
    ///
    /// # Errors
    /// The first error of a position, or those of the interrupt.
    pub fn finish(mut self) -> Result<AnalysisResult, EngineError> {
        if let Some(error) = self.failed {
            return Err(error);
        }
        for _ in 0..self.ahead.len() {
            self.next().transpose()?;
        }
        self.solve_remaining(Receiver { fields: 0, displayed: &Displayed::default(), observer: &mut () })?;
        self.summarized(&mut ())
    }

    /// Computes everything that follows from the solved positions, and reports the stages to an
    /// observer.
    fn summarized(mut self, observer: &mut dyn Observer) -> Result<AnalysisResult, EngineError> {
        let sensitivities = self.differentiate(observer)?;
        let first = Certificate::default();
        let certificate = self.solved.iter().fold(first, |worst, solved| worst.worst(&solved.certificate));
        let (modes, campbell) = self.first_modes()?;
        let forced_response = self.forced_response()?;
        let rows: Vec<StepRow> = self.solved.into_iter().map(|solved| solved.row).collect();
        let mut summaries = summarize(&rows, self.outputs, self.scene);
        let component_loads = self.recorder.map(|recorder| recorder.finish(&rows, self.scene));
        self.timing.add("positions", self.solving);
        if self.error_estimates != Estimates::None {
            let started = Instant::now();
            let judged = BaseAnalysis {
                scene: self.scene,
                system: &self.system,
                plan: &self.plan,
                structure: self.structure,
                highest_frequency: self.highest_frequency,
                resources: &self.resources,
                positions: self.positions,
                outputs: self.outputs,
                rows: &rows,
            };
            let evidence = quasi_static_perturbed_solves(&judged, self.error_estimates)?;
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
            forced_response,
            sensitivities,
            timing: self.timing,
            tolerance_search: None,
        })
    }

    /// Computes the forced response that the scene requests, unless it is known.
    fn forced_response(&mut self) -> Result<Option<ForcedResponse>, EngineError> {
        if let (None, Some(request)) = (&self.forced_response, &self.scene.forced_response) {
            let started = Instant::now();
            let task = SoundTask {
                requests: &self.scene.sounds,
                plan: &self.plan,
                highest_frequency: self.highest_frequency,
                shared: None,
            };
            let (scene, resources) = (self.scene, &self.resources);
            let found = forced_response::forced_response(&self.system, scene, request, &task, resources)?;
            self.forced_response = Some(found);
            let sound = radiated_sound::of_system(&self.system).map(|sound| sound.time);
            let sound = sound.unwrap_or_default();
            self.timing.add(FORCED_RESPONSE, started.elapsed().saturating_sub(sound));
            if !sound.is_zero() {
                self.timing.add(RADIATED_SOUND, sound);
            }
        }
        Ok(self.forced_response.take())
    }

    /// Computes the forced response before the positions if outputs have values of it.
    ///
    /// # Errors
    /// Those of the forced response and of the sound.
    fn prepare(&mut self) -> Result<(), EngineError> {
        if self.needs_preparation() {
            self.forced_response = self.forced_response()?;
        }
        Ok(())
    }

    fn needs_preparation(&self) -> bool {
        !self.scene.sounds.is_empty() && radiated_sound::of_system(&self.system).is_none()
    }

    /// Computes the table of modes and the Campbell diagram about the first position. It solves
    /// this position again, because a resumed run has not solved it.
    fn first_modes(&self) -> Result<(Option<ModesTable>, Option<CampbellDiagram>), EngineError> {
        match self.positions.first() {
            Some(first) if self.scene.examines_modes() => {
                let step = self.system.solve(first.time)?;
                Ok(Equilibrium::new(&self.system, &step)
                    .requested_modes(self.scene.modes_table.as_ref(), self.scene.campbell_diagram.as_ref()))
            }
            _ => Ok((None, None)),
        }
    }

    fn solve(&mut self, position: &Position) -> Result<Solved, EngineError> {
        self.resources.interrupt.check()?;
        if self.ahead.is_empty() {
            self.solve_ahead();
        }
        let found = match self.ahead.pop_front() {
            Some(Ok(found)) => found,
            // Solve the position again, alone, so that notes of kernels about an error refer to
            // this position only.
            _ => PositionSolver::of(self).solve(position)?,
        };
        let solved = found.solved(position, self.outputs, &self.plan)?;
        let Found { step, loads, .. } = found;
        if let (Some(recorder), Some(loads)) = (&mut self.recorder, loads) {
            recorder.push(loads);
        }
        if self.sensitivities.is_some() {
            self.states.push(differentiation::state_of(&step));
        }
        self.current = Some(step);
        Ok(solved)
    }

    /// Solves the next positions in parallel, one per thread.
    fn solve_ahead(&mut self) {
        let positions = &self.positions[self.solved.len()..];
        let together = &positions[..self.resources.threads().min(positions.len())];
        let solver = PositionSolver::of(self);
        let all = || together.par_iter().map(|position| solver.solve(position)).collect::<Vec<_>>();
        self.ahead = self.resources.install(all).into();
    }
}

impl Iterator for Steps<'_> {
    type Item = Result<Solved, EngineError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.failed.is_some() {
            return None;
        }
        let positions = self.positions;
        let position = positions.get(self.solved.len())?;
        if let Err(error) = self.prepare() {
            self.failed = Some(error.clone());
            return Some(Err(error));
        }
        let started = Instant::now();
        let solved = self.solve(position);
        self.solving += started.elapsed();
        match &solved {
            Ok(solved) => self.solved.push(solved.clone()),
            Err(error) => self.failed = Some(error.clone()),
        }
        Some(solved)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = if self.failed.is_some() { 0 } else { self.positions.len() - self.solved.len() };
        (usize::from(left > 0), Some(left))
    }
}

impl FusedIterator for Steps<'_> {}

/// Name of the stage in which the forced response is computed.
const FORCED_RESPONSE: &str = "forced response";
/// Stage of the sound in [`Timing`].
const RADIATED_SOUND: &str = "radiated sound";
/// Stage of both for observers.
const RESPONSE_AND_SOUND: &str = "forced response and radiated sound";
/// Name of the stage in which errors are estimated.
pub(crate) const ERRORS: &str = "errors";

/// Events of a running analysis, in order.
pub enum Event<'a> {
    /// The scene is planned and has passed the restraint check.
    Planned(&'a Plan),
    /// A stage begins: `structures`, `positions`, `forced response` if the scene requests it
    /// (before `positions` if outputs are values of it), or, if errors are estimated, `errors`.
    Stage(&'static str),
    /// The tolerance search tries a setting.
    SearchProgress(&'a SearchProgress),
    /// A position is solved. `index` runs from 0 to `count` - 1 and starts after the positions of
    /// an earlier run.
    Step {
        /// Index of the position.
        index: usize,
        /// Number of positions.
        count: usize,
        /// Row and certificate of the position.
        solved: &'a Solved,
        /// Fields, if [`AnalysisOptions::fields`] requests them.
        fields: Option<&'a Fields>,
    },
    /// The outputs are differentiated with respect to the next param.
    Differentiated {
        /// Index of the param.
        index: usize,
        /// Number of params.
        count: usize,
    },
}

/// Receiver of the events of an analysis; an error from it ends the analysis.
pub trait Observer {
    /// Receives an event.
    ///
    /// # Errors
    /// Any error; it ends the analysis.
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError>;
}

/// Ignores all events.
impl Observer for () {
    fn observe(&mut self, _: Event<'_>) -> Result<(), EngineError> {
        Ok(())
    }
}

/// Runs a quasi-static analysis from planning to results ([`PlannedAnalysis`], [`Steps`]) and
/// reports its events to an observer.
///
/// # Errors
/// Those of planning, building and solving, and of the observer.
pub fn quasi_static(
    scene: &Scene,
    positions: &[Position],
    outputs: &[OutputRequest],
    options: &AnalysisOptions,
    observer: &mut dyn Observer,
) -> Result<AnalysisResult, EngineError> {
    let planned = PlannedAnalysis::new(scene, positions, outputs, options)?;
    observer.observe(Event::Planned(planned.plan()))?;
    observer.observe(Event::Stage("structures"))?;
    let mut steps = planned.build()?;
    let displayed = steps.timing.displayed(scene, &steps.plan, options)?;
    if steps.needs_preparation() {
        observer.observe(Event::Stage(RESPONSE_AND_SOUND))?;
        steps.prepare()?;
    }
    observer.observe(Event::Stage("positions"))?;
    steps.solve_remaining(Receiver { fields: options.fields, displayed: &displayed, observer })?;
    if scene.forced_response.is_some() && scene.sounds.is_empty() {
        observer.observe(Event::Stage(FORCED_RESPONSE))?;
    }
    if options.error_estimates != Estimates::None {
        observer.observe(Event::Stage(ERRORS))?;
    }
    steps.summarized(observer)
}

impl Timing {
    /// Returns the shapes of bodies that the fields include.
    pub(crate) fn displayed(
        &mut self,
        scene: &Scene,
        plan: &Plan,
        options: &AnalysisOptions,
    ) -> Result<Displayed, EngineError> {
        if options.fields == 0 {
            return Ok(Displayed::default());
        }
        let meshed = || MeshedBodies::new(scene, plan, &options.resources);
        let meshed = options.bodies.then(|| self.stage("meshes", meshed)).transpose()?;
        let shapes = || parts(scene, plan, &options.resources).map(Arc::new);
        let parts = options.parts.then(|| self.stage("shapes", shapes)).transpose()?;
        Ok(Displayed { meshed, parts })
    }
}

/// Returns whether the fields of a position are reported, if at most `wanted` positions are.
pub(crate) fn requests_fields(wanted: usize, index: usize, count: usize) -> bool {
    wanted > 0 && index.is_multiple_of(count.div_ceil(wanted).max(1))
}

/// Checks that the rows of an earlier run equal those of the first positions, bit for bit.
pub(crate) fn check_solved(
    solved: &[Solved],
    positions: &[Position],
    outputs: &[OutputRequest],
) -> Result<(), EngineError> {
    let fits = |(solved, position): (&Solved, &Position)| {
        solved.row.position == *position && solved.row.outputs.len() == outputs.len()
    };
    if solved.len() <= positions.len() && solved.iter().zip(positions).all(fits) {
        return Ok(());
    }
    Err(EngineError::new(
        "E0724",
        "the positions solved before are not those that this analysis begins with",
        "resume with the model and params of the earlier run, or start a new run",
    ))
}

/// Rejects NaN results, so that the author of a model learns of their origin early.
///
/// Outputs that the plan refuses are expected to be NaN.
pub(crate) fn refuse_nan(row: &StepRow, outputs: &[OutputRequest], plan: &Plan) -> Result<(), EngineError> {
    let refused = |output: usize| plan.refused.iter().any(|refused| refused.output == output);
    let nan = |output: &usize| row.outputs[*output].value.is_nan() && !refused(*output);
    let Some(output) = (0..row.outputs.len()).find(nan) else { return Ok(()) };
    let name = outputs.get(output).map_or("", |request| request.name.as_str());
    Err(EngineError::new(
        "E0721",
        format!("output `{name}` is not a number at Time = {} s", row.position.time),
        "look for 0/0, inf - inf or the root of a negative number",
    )
    .about(Subject::Output(output)))
}
