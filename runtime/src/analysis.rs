//! Runs a frozen scene over a list of positions: plan, system, steps, results.

use crate::contact::problem::Certificate;
use crate::error::{EngineError, Subject};
use crate::holding;
use crate::plan::Plan;
use crate::results::{AnalysisResult, OutputRequest, StepRow, Timing, summarize};
use crate::scene::{Fidelity, GearMesh, Scene, StructureOptions};
use crate::system::System;
use std::time::Instant;

/// Where the motion is analysed.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// s
    pub time: f64,
    /// Part of the mesh cycle passed, 0 to 1.
    pub cycle: f64,
    /// Roll angle of the entering pair's first tooth, rad.
    pub roll: f64,
    /// Name of a characteristic point, or empty.
    pub name: &'static str,
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
            name,
        })
        .collect()
}

/// How an analysis is done.
#[derive(Clone, Debug)]
pub struct AnalysisOptions {
    pub fidelity: Fidelity,
    pub structure: StructureOptions,
}

impl Default for AnalysisOptions {
    fn default() -> Self {
        AnalysisOptions { fidelity: Fidelity::Plane, structure: StructureOptions::default() }
    }
}

/// What happens while an analysis runs, in order.
pub enum Event<'a> {
    Planned(&'a Plan),
    /// A stage begins: `structures` or `positions`.
    Stage(&'static str),
    /// A position is solved. `index` counts from 0 to `count` - 1.
    Step {
        index: usize,
        count: usize,
        row: &'a StepRow,
    },
}

/// Told of every event; an error from it ends the analysis.
pub trait Observer {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError>;
}

/// Observes nothing.
impl Observer for () {
    fn observe(&mut self, _: Event<'_>) -> Result<(), EngineError> {
        Ok(())
    }
}

/// Quasi-static analysis: inertia left out, every position in equilibrium.
pub fn quasi_static(
    scene: &Scene,
    positions: &[Position],
    outputs: &[OutputRequest],
    options: &AnalysisOptions,
    observer: &mut dyn Observer,
) -> Result<AnalysisResult, EngineError> {
    let mut timing = Timing::default();
    let plan = timing.stage("plan", || Plan::new(scene, options.fidelity, options.structure))?;
    // Structures take long, and this is known without them.
    holding::check(scene, &plan, positions.first().map_or(0.0, |position| position.time))?;
    observer.observe(Event::Planned(&plan))?;
    observer.observe(Event::Stage("structures"))?;
    let mut system = timing.stage("structures", || System::new(scene, &plan))?;
    observer.observe(Event::Stage("positions"))?;
    let started = Instant::now();
    let mut rows = Vec::with_capacity(positions.len());
    let mut certificate = Certificate::default();
    for (index, position) in positions.iter().enumerate() {
        let step = system.solve(position.time)?;
        certificate = certificate.worst(&step.certificate);
        let observed: Vec<_> = scene.observables.iter().map(|&o| system.value(&step, o)).collect();
        let row = StepRow::new(position.clone(), outputs, &observed, step.warnings.clone());
        refuse_nan(&row, outputs)?;
        observer.observe(Event::Step { index, count: positions.len(), row: &row })?;
        rows.push(row);
    }
    timing.add("positions", started.elapsed());
    let summaries = summarize(&rows, outputs);
    Ok(AnalysisResult { plan, rows, summaries, certificate, timing })
}

/// A result that is no number says nothing; the sooner the model's author knows where it came from the better.
fn refuse_nan(row: &StepRow, outputs: &[OutputRequest]) -> Result<(), EngineError> {
    let Some(output) = row.outputs.iter().position(|output| output.value.is_nan()) else { return Ok(()) };
    let name = outputs.get(output).map_or("", |request| request.name.as_str());
    Err(EngineError::new(
        "E0721",
        format!("output `{name}` is not a number at Time = {} s", row.position.time),
        "look for 0/0, inf - inf or the root of a negative number",
    )
    .about(Subject::Output(output)))
}
