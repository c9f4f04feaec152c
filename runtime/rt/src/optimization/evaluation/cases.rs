//! Load cases and samples of a design: their solution and derivatives, and the journal of both.

use super::super::Optimizer;
use super::super::problem::{deviated, variable_of};
use super::super::slopes::{self, CaseSlopes};
use super::{CaseValues, EVALUATIONS, Evaluator, Stop, locked};
use crate::error::Error;
use crate::instance::{Instance, NO_PARAMS};
use crate::results::Results;
use crate::run::RunError;
use crate::sweep::journal::{self, fingerprint};
use crate::sweep::{Varied, fidelity_of};
use calyx_abi::Status;
use calyx_report::sweep::Statistics;
use calyx_runtime::estimate::Estimates;
use calyx_runtime::scene::Fidelity;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Line of the journal.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct Line {
    /// Hash of the model and the settings: a journal keeps the lines of others, so that a return to
    /// them solves nothing again.
    pub(super) subject: String,
    /// Values of all params, SI.
    pub(super) params: Value,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) fidelity: Option<String>,
    /// Content of each table that the case has read, by name.
    pub(super) tables: BTreeMap<String, String>,
    pub(super) values: CaseValues,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) slopes: Option<KnownSlopes>,
}

/// Derivatives of a load case and sample.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct KnownSlopes {
    /// Names of the variables with respect to which it was differentiated.
    pub(super) by: Vec<String>,
    pub(super) slopes: CaseSlopes,
}

impl Evaluator<'_> {
    /// Solves a load case and sample of a design, unless the journal has it.
    pub(super) fn solve_case(
        &self,
        variables: &[f64],
        case: usize,
        sample: usize,
    ) -> Result<Result<CaseValues, String>, Stop> {
        let prepared = match self.prepared(variables, case, sample)? {
            Ok(prepared) => prepared,
            Err(reason) => return Ok(Err(reason)),
        };
        if let Some(known) = locked(&self.known).get(&prepared.key) {
            return Ok(Ok(known.clone()));
        }
        let results = match solved(&prepared.instance)? {
            Ok(results) => results,
            Err(reason) => return Ok(Err(reason)),
        };
        let values = self.case_values(&results);
        let key = prepared.key.clone();
        self.write(prepared, &results, (values.clone(), None))?;
        locked(&self.known).insert(key, values.clone());
        Ok(Ok(values))
    }

    /// Differentiates a load case and sample of a design with respect to variables, unless the
    /// journal has it; `None` if it fails.
    pub(in super::super) fn differentiate_case(
        &self,
        variables: &[f64],
        (case, sample): (usize, usize),
        by: &[String],
    ) -> Result<Option<CaseSlopes>, Stop> {
        let Ok(mut prepared) = self.prepared(variables, case, sample)? else { return Ok(None) };
        let known = locked(&self.known_slopes).get(&prepared.key).cloned();
        if let Some(known) = known.filter(|known| by.iter().all(|name| known.by.contains(name))) {
            return Ok(Some(known.slopes));
        }
        let requested = prepared.instance.request_sensitivities(by);
        let outputs = self.outputs.iter().cloned();
        if requested.and_then(|()| prepared.instance.limit_sensitivities(outputs)).is_err() {
            return Ok(None);
        }
        let Ok(results) = solved(&prepared.instance)? else { return Ok(None) };
        let names: Vec<&str> =
            results.description().outputs.iter().map(|output| output.name.as_str()).collect();
        let slopes = slopes::of_results(results.sensitivities(), &names, &self.outputs);
        let known = KnownSlopes { by: by.to_vec(), slopes: slopes.clone() };
        let key = prepared.key.clone();
        self.write(prepared, &results, (self.case_values(&results), Some(known.clone())))?;
        locked(&self.known_slopes).insert(key, known);
        Ok(Some(slopes))
    }

    /// Prepares the solution of a load case and sample of a design, or returns why it has none.
    fn prepared(
        &self,
        variables: &[f64],
        case: usize,
        sample: usize,
    ) -> Result<Result<Prepared, String>, Stop> {
        if self.optimizer.cancel.is_cancelled() {
            return Err(Stop::Cancelled);
        }
        let prepared = self.instance(variables, case, sample).and_then(|instance| {
            let params = json!(instance.params()?);
            let fidelity = fidelity_of(&self.varied, &self.cases[case]).map(str::to_owned);
            let key = journal::key(&params, fidelity.as_deref());
            Ok(Prepared { instance, params, fidelity, key })
        });
        Ok(prepared.map_err(|error| reason(&error)))
    }

    /// Writes a line of the journal.
    fn write(
        &self,
        Prepared { params, fidelity, .. }: Prepared,
        results: &Results,
        (values, slopes): (CaseValues, Option<KnownSlopes>),
    ) -> Result<(), Stop> {
        let directory = self.optimizer.program.directory();
        let table = |name: &String| (name.clone(), fingerprint(directory.as_deref(), name));
        let tables = results.tables().iter().map(table).collect();
        let line = Line { subject: self.subject.clone(), params, fidelity, tables, values, slopes };
        self.journal.write(&line).map_err(|error| {
            let path = self.optimizer.directory.join(EVALUATIONS);
            locked(&self.error).get_or_insert(RunError::Io { path, error });
            Stop::Unwritable
        })
    }

    fn case_values(&self, results: &Results) -> CaseValues {
        let outputs = &results.description().outputs;
        let statistics = outputs.iter().zip(results.summaries());
        let statistics = statistics.map(|(output, summary)| (output.name.clone(), Statistics::of(summary)));
        let positions = |name: &String| {
            let all: Vec<f64> = results.steps().filter_map(|step| step.si(name.as_str()).ok()).collect();
            let is_whole = all.len() == results.steps().len() && all.iter().all(|value| value.is_finite());
            (name.clone(), if is_whole { all } else { Vec::new() })
        };
        CaseValues {
            statistics: statistics.collect(),
            positions: self.outputs.iter().map(positions).collect(),
        }
    }

    /// Returns the instance of a load case and sample of a design.
    fn instance(&self, variables: &[f64], case: usize, sample: usize) -> Result<Instance, Error> {
        let Optimizer { program, given, overrides, problem, engine, cancel, .. } = self.optimizer;
        let description = program.description();
        let mut instance = Instance::new(engine, program.clone());
        instance.request_sensitivities(NO_PARAMS)?;
        for given in given {
            instance.give(given)?;
        }
        let case = &self.cases[case];
        for (&varied, value) in self.varied.iter().zip(&case.values) {
            if let Varied::Param(index) = varied {
                instance.set(description.params[index].name.as_str(), value.clone())?;
            }
        }
        let mut values = variables.to_vec();
        if let Some(all) = &problem.sample {
            for (&varied, value) in all.params.iter().zip(&all.points[sample]) {
                match (variable_of(&problem.params, varied), varied) {
                    (Some(k), _) => values[k] = deviated(values[k], value),
                    (None, Varied::Param(index)) => {
                        instance.set(description.params[index].name.as_str(), value.clone())?;
                    }
                    (None, Varied::Fidelity) => {}
                }
            }
        }
        for (&index, value) in problem.params.iter().zip(&values) {
            instance.set_si(description.params[index].name.as_str(), *value)?;
        }
        let mut own = *overrides;
        own.fidelity = fidelity_of(&self.varied, case).and_then(Fidelity::named).or(overrides.fidelity);
        // Estimates of errors cost more than the values.
        own.error_estimates = own.error_estimates.or(Some(Estimates::None));
        instance.override_analysis(own);
        instance.set_cancel(cancel.clone());
        Ok(instance)
    }
}

/// Load case and sample of a design before its solution.
struct Prepared {
    instance: Instance,
    /// Values of all params.
    params: Value,
    fidelity: Option<String>,
    /// Key in the journal.
    key: String,
}

/// Solves an instance, or returns why it has no solution.
fn solved(instance: &Instance) -> Result<Result<Results, String>, Stop> {
    match instance.solve() {
        Ok(results) => Ok(Ok(results)),
        Err(Error::Model(error)) if error.status() == Status::Cancelled => Err(Stop::Cancelled),
        Err(error) => Ok(Err(reason(&error))),
    }
}

fn reason(error: &Error) -> String {
    match error {
        Error::Model(error) => format!("{}: {}", error.code, error.message),
        Error::Given(why) => why.message.clone(),
    }
}
