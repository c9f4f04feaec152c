//! Runs a frozen scene over a list of positions: plan, system, steps, results.
//!
//! [`Steps`] is the analysis as an iterator; [`quasi_static`] runs it to its end and tells an observer.

use crate::contact::problem::Certificate;
use crate::error::{EngineError, Subject};
use crate::estimate::{self, Estimates, Judged, quasi_static_siblings};
use crate::observe::{Equilibrium, Fields, MeshedBodies, ModesTable, check_vibrations};
use crate::plan::Plan;
use crate::resources::Resources;
use crate::results::{AnalysisResult, Observed, OutputRequest, Solved, StepRow, Timing};
use crate::scene::{Fidelity, GearMesh, Scene, StructureOptions};
use crate::step::StepResult;
use crate::summary::summarize;
use crate::system::System;
use crate::tolerance::Choosing;
use crate::validate::{Method, Request};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::VecDeque;
use std::iter::FusedIterator;
use std::time::{Duration, Instant};

/// Where the motion is analysed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Position {
    /// s
    pub time: f64,
    /// Part of the mesh cycle passed, 0 to 1.
    pub cycle: f64,
    /// Roll angle of the entering pair's first tooth, rad.
    pub roll: f64,
    /// Name of a characteristic point, or empty.
    pub name: Cow<'static, str>,
}

impl Position {
    /// A position by its time (s) alone, of a scene that has no mesh cycle.
    pub fn at(time: f64) -> Position {
        Position { time, cycle: 0.0, roll: 0.0, name: Cow::Borrowed("") }
    }
}

/// One mesh cycle: `steps` uniform positions from the moment a pair enters contact, and the characteristic points of
/// the path of contact.
///
/// Where a pair of rigid teeth enters or leaves, loads jump. Positions stand a millionth of the cycle beside every jump, on
/// both sides of it: just after a pair has entered and just before the next one does, just before the leaving pair leaves
/// and just after.
pub fn mesh_cycle(mesh: &GearMesh, steps: usize) -> Vec<Position> {
    const BESIDE: f64 = 1e-6;
    let mut at: Vec<(f64, &'static str)> = (0..steps).map(|i| (i as f64 / steps as f64, "")).collect();
    for point in &mesh.characteristic {
        let cycle = point.time / mesh.period + BESIDE * if point.after { 1.0 } else { -1.0 };
        // A uniform position at the jump itself would stand on neither side.
        at.retain(|&(other, name)| !(name.is_empty() && (other - cycle).abs() < 2.0 * BESIDE));
        at.push((cycle, point.name));
    }
    at.sort_by(|a, b| a.0.total_cmp(&b.0));
    at.into_iter()
        .map(|(cycle, name)| Position {
            time: mesh.start + cycle * mesh.period,
            cycle,
            roll: mesh.roll[0] + cycle * (mesh.roll[1] - mesh.roll[0]),
            name: Cow::Borrowed(name),
        })
        .collect()
}

/// How an analysis is done.
#[derive(Clone, Debug)]
pub struct AnalysisOptions {
    /// How bodies are modelled.
    pub fidelity: Fidelity,
    /// How finely.
    pub structure: StructureOptions,
    /// Natural frequencies of bodies up to which motion in time and the vibrations about an equilibrium see their modes, Hz; 0 takes bodies as
    /// rigid ones on elastic teeth. No equilibrium depends on it.
    pub highest_frequency: f64,
    /// Threads, kept structures, an interrupt: no result depends on them.
    pub resources: Resources,
    /// What an earlier run of the same analysis solved of its first positions; it goes on behind them, and its result is that
    /// of a run that solved them all.
    pub solved: Vec<Solved>,
    /// Of so many positions at most, evenly spread from the first on, tell the observer the fields too: pressures, line loads, stresses.
    /// They take no part in the results.
    pub fields: usize,
    /// Whether the meshes of elastic bodies, deformed, are among these fields: they are decomposed for it once, and each position takes a
    /// back-substitution for every tooth.
    pub bodies: bool,
    /// Which errors of its outputs are estimated, once all positions are solved.
    pub error_estimates: Estimates,
}

impl Default for AnalysisOptions {
    fn default() -> Self {
        AnalysisOptions {
            fidelity: Fidelity::Plane,
            structure: StructureOptions::default(),
            highest_frequency: 0.0,
            resources: Resources::default(),
            solved: Vec::new(),
            fields: 0,
            bodies: false,
            error_estimates: Estimates::None,
        }
    }
}

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
        check_vibrations(&system)?;
        Ok(Steps {
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
        let mut summaries = summarize(&rows, self.outputs, &self.system.scene.observables);
        self.timing.add("positions", self.solving);
        if self.error_estimates != Estimates::None {
            let started = Instant::now();
            let judged = Judged {
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
            estimate::attach(&mut summaries, &rows, self.outputs, &self.system.scene.observables, &evidence);
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
        let (Some(request), Some(first)) = (&self.system.scene.modes_table, self.positions.first()) else {
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
        let observed = self.plan.observe(&self.system, &step);
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
