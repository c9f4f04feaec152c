//! Derivatives of a quasi-static analysis: its states of contact, and solutions in them.

use super::{AnalysisOptions, Event, Observer, Steps};
use crate::observables::Observe;
use crate::scene::Scene;
use crate::sensitivity::{Base, Sensitivity};
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::structure_building::structure_keys;
use calyx_numerics::error::EngineError;
use calyx_solve::step::{ContactState, StepResult};
use std::time::Instant;

/// Name of the stage in which outputs are differentiated.
const SENSITIVITIES: &str = "sensitivities";

impl<'s> Steps<'s> {
    /// Computes the derivatives that the options request.
    pub(super) fn differentiate(
        &mut self,
        observer: &mut dyn Observer,
    ) -> Result<Vec<Sensitivity>, EngineError> {
        let Some(request) = self.sensitivities.take() else { return Ok(Vec::new()) };
        let started = Instant::now();
        // An earlier run has solved the first positions without their states.
        let missing = self.solved.len() - self.states.len();
        let resolved = self.positions[..missing].iter().map(|position| {
            let step = self.system.solve(position.time)?;
            Ok(state_of(&step))
        });
        let mut states = resolved.collect::<Result<Vec<_>, EngineError>>()?;
        states.append(&mut self.states);
        let rows = self.solved.iter().map(|solved| solved.row.clone()).collect();
        let base = Base { steps: self, rows, states };
        let count = request.params.len();
        let begin = |index| observer.observe(Event::Differentiated { index, count });
        let found = base.sensitivities(&request, begin)?;
        self.timing.add(SENSITIVITIES, started.elapsed());
        Ok(found)
    }

    /// Returns the options of the analysis itself, without those of its results.
    pub(crate) fn options(&self) -> AnalysisOptions {
        AnalysisOptions {
            fidelity: self.plan.fidelity,
            structure: self.structure,
            highest_frequency: self.highest_frequency,
            resources: self.resources.clone(),
            ..AnalysisOptions::default()
        }
    }

    /// Returns the scene.
    pub(crate) fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// Returns the requested outputs.
    pub(crate) fn outputs(&self) -> &'s [OutputRequest] {
        self.outputs
    }

    /// Returns whether all structures of the plan equal those of another analysis.
    pub(crate) fn has_structures_of(&self, other: &Steps<'_>) -> bool {
        let stiffness = |steps: &Steps<'_>| {
            let connections = steps.system.elastic_connections.iter();
            connections.map(|connection| connection.stiffness.clone()).collect::<Vec<_>>()
        };
        let [own, others] = [self, other].map(|steps| structure_keys(steps.scene, &steps.plan));
        own.is_some() && own == others && stiffness(self) == stiffness(other)
    }

    /// Solves a position in a state of contact, or finds the state without a given one. Returns the
    /// outputs; `None` if the state cannot be kept.
    pub(crate) fn outputs_in_state(
        &self,
        position: usize,
        state: Option<&ContactState>,
    ) -> Result<Option<Vec<Observed>>, EngineError> {
        self.resources.interrupt.check()?;
        let time = self.positions[position].time;
        let step = match state {
            Some(state) => self.system.solve_in_state(time, state)?,
            None => self.system.solve(time)?,
        };
        // Rigid bodies touch without cells.
        if !self.system.rigid && state.is_some_and(|state| step.contact_state() != *state) {
            return Ok(None);
        }
        let observed = self.system.values(&step, self.plan.fidelity, &self.scene.observables);
        self.resources.interrupt.check()?;
        Ok(Some(self.outputs.iter().map(|output| output.evaluate(time, &observed)).collect()))
    }
}

/// Returns the state of contact of a position; `None` at a change of the state.
pub(super) fn state_of(step: &StepResult) -> Option<ContactState> {
    (!step.is_at_change_of_state()).then(|| step.contact_state())
}
