//! Derivatives of a quasi-static analysis: its states of contact, and solutions in them.

use super::{AnalysisOptions, Event, Observer, Steps};
use crate::observables::Observe;
use crate::rows::StepRow;
use crate::scene::Scene;
use crate::sensitivity::{
    Kind, Neighbour, Neighbours, Sensitivity, SensitivityRequest, Stencil, VariedParam, narrowed,
    other_positions, statistics_of,
};
use crate::summary::mean_of;
use calyx_model::connection::ElasticConnection;
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::position::Position;
use calyx_model::structure_building::structure_keys;
use calyx_numerics::error::EngineError;
use calyx_solve::step::{ContactState, StepResult};
use rayon::prelude::*;
use std::time::Instant;

/// Name of the stage in which outputs are differentiated.
const SENSITIVITIES: &str = "sensitivities";

impl Steps<'_> {
    /// Computes the derivatives that the options request.
    pub(super) fn differentiate(
        &mut self,
        observer: &mut dyn Observer,
    ) -> Result<Vec<Sensitivity>, EngineError> {
        let Some(request) = self.sensitivities.take() else { return Ok(Vec::new()) };
        let started = Instant::now();
        // A damaged store may have other numbers of positions or outputs.
        let (positions, outputs) = (self.solved.len(), self.outputs.len());
        let fits = |own: &Sensitivity| {
            let rows = || own.positions.iter().chain([&own.means]);
            own.positions.len() == positions && rows().all(|row| row.len() == outputs)
        };
        let stored: Vec<_> = request.params.iter().map(|param| request.find(param).filter(fits)).collect();
        let found = if stored.iter().all(Option::is_some) {
            let rows: Vec<StepRow> = self.solved.iter().map(|solved| solved.row.clone()).collect();
            stored.into_iter().flatten().map(|own| with_statistics(own, &rows)).collect()
        } else {
            let base = self.base(&request)?;
            let count = request.params.len();
            let begin = |index| observer.observe(Event::Differentiated { index, count });
            base.sensitivities(&request, stored, begin)?
        };
        self.timing.add(SENSITIVITIES, started.elapsed());
        Ok(found)
    }

    /// Returns the solved positions in their states of contact.
    fn base(&mut self, request: &SensitivityRequest) -> Result<Base<'_, '_>, EngineError> {
        // An earlier run has solved the first positions without their states.
        let missing = self.solved.len() - self.states.len();
        let resolved = self.positions[..missing].iter().map(|position| {
            let step = self.system.solve(position.time)?;
            Ok(state_of(&step))
        });
        let mut states = resolved.collect::<Result<Vec<_>, EngineError>>()?;
        states.append(&mut self.states);
        let rows = self.solved.iter().map(|solved| solved.row.clone()).collect();
        let of_response = |index: usize| {
            self.scene.observables.get(index).is_some_and(|observable| observable.is_of_forced_response())
        };
        let requested = request.differentiated(self.outputs).into_iter().zip(self.outputs);
        let requested: Vec<bool> =
            requested.map(|(requested, output)| requested && !output.observes(of_response)).collect();
        let of_observable = |index: usize| {
            let own = self.outputs.iter().zip(&requested).filter(|(_, requested)| **requested);
            own.into_iter().any(|(output, _)| output.observes(|observed| observed == index))
        };
        let observed = (0..self.scene.observables.len()).map(of_observable).collect();
        let base = Base { steps: self, rows, states, requested, observed, values: Vec::new() };
        Ok(Base { values: base.values_in_state()?, ..base })
    }

    /// Returns the options of the analysis itself, without those of its results.
    fn options(&self) -> AnalysisOptions {
        AnalysisOptions {
            fidelity: self.plan.fidelity,
            structure: self.structure,
            highest_frequency: self.highest_frequency,
            resources: self.resources.clone(),
            ..AnalysisOptions::default()
        }
    }

    /// Returns whether all stored structures of the plan equal those of another analysis. Closed
    /// forms are not stored: they depend smoothly on params, as everything else.
    fn has_structures_of(&self, other: &Steps<'_>) -> bool {
        let matrices = |steps: &Steps<'_>| {
            let connections = steps.system.elastic_connections.iter();
            let of =
                |connection: &ElasticConnection| (connection.stiffness.clone(), connection.raceways.clone());
            connections.map(of).collect::<Vec<_>>()
        };
        let [own, others] = [self, other].map(|steps| structure_keys(steps.scene, &steps.plan));
        own == others && matrices(self) == matrices(other)
    }

    /// Solves a position in a state of contact, or finds the state without a given one. Returns the
    /// outputs; `None` if the state cannot be kept. `observed` are the observables that are
    /// evaluated.
    fn outputs_in_state(
        &self,
        position: usize,
        state: Option<&ContactState>,
        observed: &[bool],
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
        let observed = self.system.values_of(&step, self.plan.fidelity, &self.scene.observables, observed);
        self.resources.interrupt.check()?;
        Ok(Some(self.outputs.iter().map(|output| output.evaluate(time, &observed)).collect()))
    }
}

/// Returns the state of contact of a position; `None` at a change of the state.
pub(super) fn state_of(step: &StepResult) -> Option<ContactState> {
    (!step.is_at_change_of_state()).then(|| step.contact_state())
}

/// Solved positions whose outputs are differentiated.
struct Base<'a, 's> {
    /// The finished analysis.
    steps: &'a Steps<'s>,
    rows: Vec<StepRow>,
    /// State of contact by position; `None` at a change of the state.
    states: Vec<Option<ContactState>>,
    /// Outputs to differentiate.
    requested: Vec<bool>,
    /// Observables of these outputs.
    observed: Vec<bool>,
    /// Outputs by position, solved in the states as those of neighbouring models are.
    values: Vec<Vec<Observed>>,
}

impl Base<'_, '_> {
    /// Solves the positions in their states of contact: their values differ from those of the
    /// analysis by rounding, which must not appear as a kink.
    fn values_in_state(&self) -> Result<Vec<Vec<Observed>>, EngineError> {
        let solve = |position: usize| {
            let state = self.states[position].as_ref();
            let values = self.steps.outputs_in_state(position, state, &self.observed)?;
            Ok(values.unwrap_or_else(|| self.rows[position].outputs.clone()))
        };
        let all = || (0..self.rows.len()).into_par_iter().map(solve).collect::<Result<Vec<_>, EngineError>>();
        self.steps.resources.install(all)
    }

    /// Differentiates all outputs with respect to each requested param without `stored`
    /// derivatives. `begin` receives the index of each param before its turn.
    ///
    /// # Errors
    /// Those of the interrupt, of `begin`, and of the store.
    fn sensitivities(
        &self,
        request: &SensitivityRequest,
        stored: Vec<Option<Sensitivity>>,
        mut begin: impl FnMut(usize) -> Result<(), EngineError>,
    ) -> Result<Vec<Sensitivity>, EngineError> {
        let mut all = Vec::with_capacity(request.params.len());
        for (index, (param, stored)) in request.params.iter().zip(stored).enumerate() {
            begin(index)?;
            if let Some(stored) = stored {
                all.push(with_statistics(stored, &self.rows));
                continue;
            }
            let neighbours = request.neighbours.as_ref();
            let differences = |stencil: &Stencil| self.differences(neighbours, param, stencil);
            let found =
                narrowed(param, &self.requested, differences, || self.steps.resources.interrupt.check())?;
            request.store(&found)?;
            all.push(with_statistics(found, &self.rows));
        }
        Ok(all)
    }

    /// Differentiates with differences of one width.
    fn differences(
        &self,
        neighbours: &dyn Neighbours,
        param: &VariedParam,
        stencil: &Stencil,
    ) -> Result<Sensitivity, EngineError> {
        let models = stencil.values().into_iter().map(|value| neighbours.at(param.index, value));
        let models = models.collect::<Result<Vec<Neighbour>, EngineError>>()?;
        let options = self.steps.options();
        let count = self.rows.len();
        let fits = |model: &Neighbour| {
            model.positions.len() == count && model.outputs.len() == self.steps.outputs.len()
        };
        if !models.iter().all(fits) {
            return Err(other_positions(param));
        }
        let built = models.iter().map(|model| of_neighbour(model, &options));
        let built = built.collect::<Result<Vec<Steps<'_>>, EngineError>>()?;
        let same = built.iter().all(|steps| steps.has_structures_of(self.steps));
        let solve = |position: usize| {
            let state = self.states[position].as_ref();
            let values = built.iter().map(|steps| steps.outputs_in_state(position, state, &self.observed));
            values.collect::<Result<Vec<_>, EngineError>>()
        };
        let all = || (0..count).into_par_iter().map(solve).collect::<Result<Vec<_>, EngineError>>();
        let values = options.resources.install(all)?;
        let of_position =
            |(at, values): (&Vec<Observed>, &Vec<Option<Vec<Observed>>>)| stencil.derivatives(at, values);
        let positions = self.values.iter().zip(&values).map(of_position).collect();
        // Positions, and with them the weights of a mean, may move with the param.
        let means: Vec<Option<Vec<Observed>>> = (0..models.len())
            .map(|index| {
                models[index].means(&values.iter().map(|row| row[index].as_ref()).collect::<Vec<_>>())
            })
            .collect();
        let own: Vec<Option<&Vec<Observed>>> = self.values.iter().map(Some).collect();
        let at = means_of(self.steps.scene, self.steps.positions, self.steps.outputs, &own);
        let means = stencil.derivatives(&at.unwrap_or_default(), &means);
        Ok(Sensitivity {
            param: param.clone(),
            width: stencil.width(),
            kind: if same { Kind::SameStructures } else { Kind::ChangedStructures },
            positions,
            means,
            statistics: Vec::new(),
            failure: None,
        })
    }
}

/// Adds the derivatives of the statistics over the positions.
fn with_statistics(found: Sensitivity, rows: &[StepRow]) -> Sensitivity {
    if found.failure.is_some() {
        return found;
    }
    let statistics = statistics_of(rows, &found.positions, &found.means);
    Sensitivity { statistics, ..found }
}

impl Neighbour {
    /// Returns the means of the outputs from their values by position; `None` if one is unknown.
    fn means(&self, values: &[Option<&Vec<Observed>>]) -> Option<Vec<Observed>> {
        means_of(&self.scene, &self.positions, &self.outputs, values)
    }
}

/// Returns the means over the positions by output, `values` being those of each position; `None` if
/// one is unknown.
fn means_of(
    scene: &Scene,
    positions: &[Position],
    outputs: &[OutputRequest],
    values: &[Option<&Vec<Observed>>],
) -> Option<Vec<Observed>> {
    let values: Vec<&Vec<Observed>> = values.iter().copied().collect::<Option<_>>()?;
    let row = |position: &Position| StepRow {
        position: position.clone(),
        outputs: Vec::new(),
        warnings: Vec::new(),
    };
    let rows: Vec<StepRow> = positions.iter().map(row).collect();
    let mean = |(index, output): (usize, &OutputRequest)| {
        let values: Vec<f64> = values.iter().map(|row| row[index].value).collect();
        Observed::number(mean_of(&rows, output, scene, &values))
    };
    Some(outputs.iter().enumerate().map(mean).collect())
}

/// Plans and builds the analysis of a neighbouring model.
fn of_neighbour<'n>(model: &'n Neighbour, options: &AnalysisOptions) -> Result<Steps<'n>, EngineError> {
    let Neighbour { scene, positions, outputs } = model;
    Steps::new(scene, positions, outputs, options)
}
