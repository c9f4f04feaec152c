//! Solution of the positions of a quasi-static analysis. While the observer receives a position,
//! the following ones are solved in parallel.

use super::{Event, Observer, Steps, differentiation, refuse_nan, requests_fields};
use crate::component_recorder::ComponentRecorder;
use crate::observables::{Displayed, Equilibrium, Fields, Observable, Observe, TransmissionError};
use crate::rows::{Solved, StepRow};
use crate::scene::Scene;
use calyx_model::ids::PairId;
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::pairs::GearMesh;
use calyx_model::plan::Plan;
use calyx_model::position::Position;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_solve::step::{ContactState, StepResult};
use calyx_solve::system::System;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::time::Instant;

/// Equilibrium at a position with its observables.
pub(super) struct Found {
    pub step: StepResult,
    pub observed: Vec<Observed>,
    /// Loads of meshes and bearings, if they are recorded.
    pub loads: Option<Vec<f64>>,
}

impl Found {
    /// Returns the row of the position.
    ///
    /// # Errors
    /// An output is not a number.
    pub fn solved(
        &self,
        position: &Position,
        outputs: &[OutputRequest],
        plan: &Plan,
    ) -> Result<Solved, EngineError> {
        let row = StepRow::new(position.clone(), outputs, &self.observed, self.step.warnings.clone());
        refuse_nan(&row, outputs, plan)?;
        Ok(Solved { row, certificate: self.step.certificate, state: Vec::new() })
    }
}

/// Inputs of the solution of a position.
pub(super) struct PositionSolver<'a, 's> {
    pub scene: &'s Scene,
    pub plan: &'a Plan,
    pub system: &'a System<'s>,
    pub recorder: Option<&'a ComponentRecorder>,
    pub interrupt: &'a Interrupt,
}

impl<'a, 's> PositionSolver<'a, 's> {
    /// Returns the solver of an analysis.
    pub fn of(steps: &'a Steps<'s>) -> Self {
        let (scene, system, plan) = (steps.scene, &steps.system, &steps.plan);
        let (recorder, interrupt) = (steps.recorder.as_ref(), &steps.resources.interrupt);
        PositionSolver { scene, plan, system, recorder, interrupt }
    }

    /// Solves a position and evaluates the observables.
    ///
    /// # Errors
    /// Those of the solution, and those of the interrupt.
    pub fn solve(&self, position: &Position) -> Result<Found, EngineError> {
        self.interrupt.check()?;
        let step = self.system.solve(position.time)?;
        self.check_engagement(&step)?;
        let observed = self.system.values(&step, self.plan.fidelity, &self.scene.observables);
        let of_position = (self.scene, &observed[..]);
        let evaluate =
            |loads: &ComponentRecorder| loads.evaluate(self.system, &step, self.plan.fidelity, of_position);
        let loads = self.recorder.map(evaluate);
        // An interrupted observable has no value, which is not an error of the model.
        self.interrupt.check()?;
        Ok(Found { step, observed, loads })
    }

    /// Rejects meshes whose teeth touch farther than a pitch from the position that the ratio
    /// gives. If gears engage, other teeth touch before. Meshes on carriers are not compared: the
    /// carrier may rotate under load, which their transmission error contains.
    ///
    /// # Errors
    /// E0734.
    fn check_engagement(&self, step: &StepResult) -> Result<(), EngineError> {
        let at = Equilibrium::new(self.system, step);
        for (index, pair) in self.scene.pairs.iter().enumerate() {
            let fixed = |mesh: &&GearMesh| pair.front.is_none() && mesh.carrier == [0.0; 3];
            let Some(mesh) = pair.mesh.as_ref().filter(fixed) else { continue };
            let pitch = TAU / f64::from(mesh.teeth[1]);
            let error = TransmissionError(PairId(index)).value(&at).value;
            if error.abs() <= pitch || error.is_nan() {
                continue;
            }
            let [first, second] = pair.bodies.map(|body| &self.scene.bodies[body.0].name);
            return Err(EngineError::new(
                "E0734",
                format!(
                    "the teeth of \"{first}\" and \"{second}\" do not engage: the transmission error is {:.1} deg, and a pitch of \"{second}\" is {:.1} deg",
                    error.to_degrees(),
                    pitch.to_degrees()
                ),
                "correct the centre distance, the axial positions or the flanks; if the load separates the driving flanks, set `coast_side_contact` of the mesh",
            ));
        }
        Ok(())
    }
}

/// Results of a position that are kept.
struct Results {
    solved: Solved,
    loads: Option<Vec<f64>>,
    /// State of contact, if it is requested; the inner value is `None` at a change of the state.
    state: Option<Option<ContactState>>,
    fields: Option<Fields>,
}

/// Receiver of solved positions and their fields.
pub(super) struct Receiver<'a> {
    /// Largest number of positions with fields.
    pub fields: usize,
    pub displayed: &'a Displayed,
    pub observer: &'a mut dyn Observer,
}

impl Steps<'_> {
    /// Solves the remaining positions in parallel and reports them in order.
    ///
    /// # Errors
    /// The first error of a position or of the observer, or those of the interrupt.
    pub(super) fn solve_remaining(&mut self, receiver: Receiver<'_>) -> Result<(), EngineError> {
        self.prepare()?;
        let started = Instant::now();
        let (positions, outputs) = (self.positions, self.outputs);
        let (mut next, count) = (self.solved.len(), positions.len());
        let Receiver { fields: wanted, displayed, observer } = receiver;
        let mut all = std::mem::take(&mut self.solved);
        let (mut states, mut loads) = (Vec::new(), Vec::new());

        let keeps_states = self.sensitivities.is_some();
        let (solver, system, plan) = (PositionSolver::of(self), &self.system, &self.plan);
        let solve = |index: usize| {
            let found = solver.solve(&positions[index])?;
            let fields = || Equilibrium::new(system, &found.step).fields_with(displayed);
            let fields = requests_fields(wanted, index, count).then(fields).transpose()?;
            Ok(Results {
                solved: found.solved(&positions[index], outputs, plan)?,
                loads: found.loads,
                state: keeps_states.then(|| differentiation::state_of(&found.step)),
                fields,
            })
        };
        let mut receive = |index: usize, own: Results| {
            // Positions solved ahead are not reported after the observer has cancelled the run.
            solver.interrupt.check()?;
            let fields = own.fields;
            states.extend(own.state);
            loads.extend(own.loads);
            all.push(own.solved);
            let solved = &all[index];
            observer.observe(Event::Step { index, count, solved, fields: fields.as_ref() })
        };
        let mut result = Ok(());
        // Solutions of following positions that are left after an error.
        let mut ahead: BTreeMap<usize, Result<Results, EngineError>> = BTreeMap::new();
        while next < count && result.is_ok() {
            if let Some(solved) = ahead.remove(&next) {
                // Solve a position with an error again, alone, so that notes of kernels about it
                // refer to this position only.
                let solved = solved.or_else(|_| solve(next));
                result = solved.and_then(|solved| receive(next, solved));
                next += 1;
                continue;
            }
            let first = next;
            let left = self.resources.in_order(
                count - first,
                |index| solve(first + index),
                |_, solved| {
                    match solved {
                        Ok(solved) => result = receive(next, solved),
                        Err(error) => {
                            ahead.insert(next, Err(error));
                            return ControlFlow::Break(());
                        }
                    }
                    next += 1;
                    if result.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
                },
            );
            ahead.extend(left.into_iter().map(|(index, solved)| (first + index, solved)));
        }
        self.solved = all;
        self.states.extend(states);
        if let Some(recorder) = &mut self.recorder {
            loads.into_iter().for_each(|loads| recorder.push(loads));
        }
        self.solving += started.elapsed();
        result
    }
}
