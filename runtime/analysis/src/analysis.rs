//! Runs a frozen scene over a list of positions: plan, system, steps, results.
//!
//! [`Steps`] is the analysis as an iterator; [`quasi_static`] runs it to its end and tells an observer.

use crate::estimate::{self, Estimates, Judged, quasi_static_siblings};
use crate::observe::Observe;
use crate::observe::{Equilibrium, Fields, MeshedBodies, ModesTable};
pub use crate::options::AnalysisOptions;
use crate::results::Choosing;
use crate::results::{AnalysisResult, Timing};
use crate::rows::{Solved, StepRow};
use crate::scene::Scene;
use crate::summary::summarize;
use crate::validate::{Method, Request};
use calyx_contact::problem::Certificate;
use calyx_model::fidelity::StructureOptions;
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::plan::Plan;
pub use calyx_model::position::{Position, mesh_cycle};
use calyx_model::resources::Resources;
use calyx_numerics::error::{EngineError, Subject};
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use calyx_solve::vibration::check_vibrations;

use rayon::prelude::*;
use std::collections::VecDeque;
use std::iter::FusedIterator;
use std::time::{Duration, Instant};

/// An analysis that is planned and known to be held, before anything that takes long.
pub struct Planned<'s> {
    scene: &'s Scene,
    positions: &'s [Position],
    outputs: &'s [OutputRequest],
    resources: Resources,
    solved: Vec<Solved>,
    highest_frequency: f64,
    structure: StructureOptions,
    error_estimates: Estimates,
    plan: Plan,
    timing: Timing,
}

impl<'s> Planned<'s> {
    /// Plans the quasi-static analysis (inertia left out, every position in equilibrium) of a scene at some positions.
    ///
    /// # Errors
    /// The scene cannot be modelled so, contacts cannot hold what is free, or the earlier rows are of another analysis.
    pub fn new(
        scene: &'s Scene,
        positions: &'s [Position],
        outputs: &'s [OutputRequest],
        options: &AnalysisOptions,
    ) -> Result<Self, EngineError> {
        let mut timing = Timing::default();
        check_solved(&options.solved, positions, outputs)?;
        let highest_frequency = options.highest_frequency;
        // Structures take long, and this is known without them.
        let request = Request::new(scene, outputs, Method::QuasiStatic(positions), options);
        let plan = timing.stage("plan", || request.plan(&options.resources.interrupt))?;
        Ok(Planned {
            scene,
            positions,
            outputs,
            resources: options.resources.clone(),
            solved: options.solved.clone(),
            highest_frequency,
            structure: options.structure,
            error_estimates: options.error_estimates,
            plan,
            timing,
        })
    }

    /// What is modelled, and why.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Builds the structures, or takes them from the cache.
    ///
    /// # Errors
    /// A structure cannot be built, or the interrupt's.
    pub fn build(self) -> Result<Steps<'s>, EngineError> {
        let Planned { scene, positions, outputs, resources, solved, highest_frequency, plan, .. } = self;
        let (structure, error_estimates, mut timing) = (self.structure, self.error_estimates, self.timing);
        let system = timing.stage("structures", || System::with(scene, &plan, &resources))?;
        timing.structures = system.structure_counts();
        let system = match highest_frequency {
            0.0 => system,
            highest => timing.stage("modes", || system.vibrating(&plan, &resources, highest))?,
        };
        check_vibrations(&system, scene)?;
        Ok(Steps {
            scene,
            positions,
            outputs,
            resources,
            solved,
            highest_frequency,
            structure,
            error_estimates,
            plan,
            timing,
            system,
            ahead: VecDeque::new(),
            solving: Duration::ZERO,
            current: None,
            failed: None,
        })
    }
}

/// A position in equilibrium and what is observed of it.
struct Found {
    step: StepResult,
    observed: Vec<Observed>,
}

/// A quasi-static analysis under way: an iterator over its positions, in order.
///
/// As many are solved side by side as there are threads, the first of them being the one that is asked for. After an error it is at
/// its end.
pub struct Steps<'s> {
    scene: &'s Scene,
    positions: &'s [Position],
    outputs: &'s [OutputRequest],
    resources: Resources,
    solved: Vec<Solved>,
    highest_frequency: f64,
    structure: StructureOptions,
    error_estimates: Estimates,
    plan: Plan,
    timing: Timing,
    system: System<'s>,
    /// Positions that follow, solved side by side with one that was asked for.
    ahead: VecDeque<Result<Found, EngineError>>,
    /// Time spent on positions.
    solving: Duration,
    current: Option<StepResult>,
    failed: Option<EngineError>,
}

impl<'s> Steps<'s> {
    /// Plans an analysis and builds its structures.
    ///
    /// # Errors
    /// Those of [`Planned::new`] and [`Planned::build`].
    pub fn new(
        scene: &'s Scene,
        positions: &'s [Position],
        outputs: &'s [OutputRequest],
        options: &AnalysisOptions,
    ) -> Result<Self, EngineError> {
        Planned::new(scene, positions, outputs, options)?.build()
    }

    /// What is modelled, and why.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// What reads values off a solved position.
    pub fn system(&self) -> &System<'s> {
        &self.system
    }

    /// The position solved last, with its patches, cells and forces; `None` before the first.
    pub fn current(&self) -> Option<&StepResult> {
        self.current.as_ref()
    }

    /// The same as observables see it.
    pub fn equilibrium(&self) -> Option<Equilibrium<'_>> {
        Some(Equilibrium { system: &self.system, step: self.current.as_ref()? })
    }

    /// All positions solved so far, those of an earlier run among them.
    pub fn solved(&self) -> &[Solved] {
        &self.solved
    }

    /// Positions there are, solved or not.
    pub fn count(&self) -> usize {
        self.positions.len()
    }

    /// Solves what is left, sums up, and estimates errors if they are asked for.
    ///
    /// # Errors
    /// The first that a position ended with, or the interrupt's.
    pub fn finish(mut self) -> Result<AnalysisResult, EngineError> {
        for step in self.by_ref() {
            step?;
        }
        if let Some(error) = self.failed {
            return Err(error);
        }
        let first = Certificate::default();
        let certificate = self.solved.iter().fold(first, |worst, solved| worst.worst(&solved.certificate));
        let modes = self.first_modes()?;
        let rows: Vec<StepRow> = self.solved.into_iter().map(|solved| solved.row).collect();
        let mut summaries = summarize(&rows, self.outputs, &self.scene.observables);
        self.timing.add("positions", self.solving);
        if self.error_estimates != Estimates::None {
            let started = Instant::now();
            let judged = Judged {
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
            let evidence = quasi_static_siblings(&judged, self.error_estimates)?;
            estimate::attach(&mut summaries, &rows, self.outputs, &self.scene.observables, &evidence);
            self.timing.add(ERRORS, started.elapsed());
        }
        self.timing.memory = self.resources.interrupt.most_asked();
        Ok(AnalysisResult {
            plan: self.plan,
            rows,
            summaries,
            certificate,
            modes,
            timing: self.timing,
            chosen: None,
        })
    }

    /// The table of modes about the first position, which is solved once more for it: a run that goes on has not seen it.
    fn first_modes(&self) -> Result<Option<ModesTable>, EngineError> {
        let (Some(request), Some(first)) = (&self.scene.modes_table, self.positions.first()) else {
            return Ok(None);
        };
        let step = self.system.solve(first.time)?;
        Ok(Equilibrium::new(&self.system, &step).modes_table(request))
    }

    fn solve(&mut self, position: &Position) -> Result<Solved, EngineError> {
        self.resources.interrupt.check()?;
        if self.ahead.is_empty() {
            self.solve_ahead();
        }
        let Found { step, observed } = match self.ahead.pop_front() {
            Some(Ok(found)) => found,
            // Again and alone, so that what kernels note about an error is of this position and no other.
            _ => self.solve_alone(position)?,
        };
        let row = StepRow::new(position.clone(), self.outputs, &observed, step.warnings.clone());
        refuse_nan(&row, self.outputs, &self.plan)?;
        let certificate = step.certificate;
        self.current = Some(step);
        Ok(Solved { row, certificate, state: Vec::new() })
    }

    /// Solves the next positions, one a thread.
    fn solve_ahead(&mut self) {
        let positions = &self.positions[self.solved.len()..];
        let together = &positions[..self.resources.threads().min(positions.len())];
        let this = &*self;
        let all = || together.par_iter().map(|position| this.solve_alone(position)).collect::<Vec<_>>();
        self.ahead = self.resources.install(all).into();
    }

    fn solve_alone(&self, position: &Position) -> Result<Found, EngineError> {
        let step = self.system.solve(position.time)?;
        let observed = self.system.values(&step, self.plan.fidelity, &self.scene.observables);
        // An observable that was interrupted has no value, and that is not the model's fault.
        self.resources.interrupt.check()?;
        Ok(Found { step, observed })
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

/// The stage in which errors are estimated.
pub(crate) const ERRORS: &str = "errors";

/// What happens while an analysis runs, in order.
pub enum Event<'a> {
    /// The scene is planned and known to be held.
    Planned(&'a Plan),
    /// A stage begins: `structures`, `positions` or, where they are estimated, `errors`.
    Stage(&'static str),
    /// A setting is tried for a tolerance.
    Choosing(&'a Choosing),
    /// A position is solved. `index` counts from 0 to `count` - 1, beginning behind those that an earlier run had solved.
    Step {
        /// Of the position.
        index: usize,
        /// Of positions.
        count: usize,
        /// Its row and its certificate.
        solved: &'a Solved,
        /// Where [`AnalysisOptions::fields`] asks for them.
        fields: Option<&'a Fields>,
    },
}

/// Told of every event; an error from it ends the analysis.
pub trait Observer {
    /// Is told of an event.
    ///
    /// # Errors
    /// Whatever is to end the analysis.
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError>;
}

/// Observes nothing.
impl Observer for () {
    fn observe(&mut self, _: Event<'_>) -> Result<(), EngineError> {
        Ok(())
    }
}

/// A quasi-static analysis from beginning to end, watched: [`Planned`] and [`Steps`] with somebody who is told.
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
    let planned = Planned::new(scene, positions, outputs, options)?;
    observer.observe(Event::Planned(planned.plan()))?;
    observer.observe(Event::Stage("structures"))?;
    let mut steps = planned.build()?;
    let meshed = steps.timing.meshed(scene, &steps.plan, options)?;
    observer.observe(Event::Stage("positions"))?;
    while let Some(solved) = steps.next() {
        let solved = &solved?;
        let index = steps.solved().len() - 1;
        let told = tells_fields(options.fields, index, positions.len());
        let equilibrium = steps.equilibrium().filter(|_| told);
        let fields = equilibrium.map(|at| at.fields_with(meshed.as_ref())).transpose()?;
        observer.observe(Event::Step { index, count: positions.len(), solved, fields: fields.as_ref() })?;
    }
    if options.error_estimates != Estimates::None {
        observer.observe(Event::Stage(ERRORS))?;
    }
    steps.finish()
}

impl Timing {
    /// The meshes of bodies, if fields are to have them.
    pub(crate) fn meshed(
        &mut self,
        scene: &Scene,
        plan: &Plan,
        options: &AnalysisOptions,
    ) -> Result<Option<MeshedBodies>, EngineError> {
        let wanted = options.bodies && options.fields > 0;
        let meshed = || MeshedBodies::new(scene, plan, &options.resources);
        wanted.then(|| self.stage("meshes", meshed)).transpose()
    }
}

/// Whether a position is among those, so many at most, whose fields are told.
pub(crate) fn tells_fields(wanted: usize, index: usize, count: usize) -> bool {
    wanted > 0 && index.is_multiple_of(count.div_ceil(wanted).max(1))
}

/// Rows of an earlier run must be those of the first positions, bit for bit.
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

/// A result that is no number says nothing; the sooner the model's author knows where it came from the better.
///
/// Outputs that the plan refuses are expected to be none.
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
