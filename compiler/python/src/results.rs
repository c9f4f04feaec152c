//! Results of runs.

use crate::arrays::{Array, array};
use crate::describe::{Units, output_json};
use crate::errors;
use crate::fields;
use crate::values;
use calyx::rt::FinishedRun;
use calyx::rt::directory::{Details, REPORT};
use calyx::rt::sensitivity::{Entry, SensitivityTable, Statistic};
use calyx::{Override, Step};
use calyx_runtime::observables::Fields;
use calyx_runtime::results::{ErrorEstimate, Location, OutputSummary, Solved, Statistics};
use calyx_runtime::sensitivity::{Kind, Sensitivity};
use pyo3::exceptions::{PyIndexError, PyOSError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::fs;
use std::path::PathBuf;
use std::time::Duration;

/// Output, statistic, param, unit, derivatives of both sides, estimated error, new structures.
type SensitivityRow = (String, String, String, String, [f64; 2], f64, bool);

/// Results of a run; immutable.
#[pyclass(frozen, module = "calyx._calyx", name = "Results")]
pub struct Results {
    pub results: calyx::Results,
    /// Solved positions, with their fields if the run requested them.
    pub positions: Vec<(Solved, Option<Fields>)>,
    pub overrides: Override,
    pub details: Details,
    /// Stages that preceded the run.
    pub before: Vec<(&'static str, Duration)>,
    /// Code, message and text with source lines of each finding.
    pub findings: Vec<(String, String, String)>,
}

#[pymethods]
impl Results {
    /// Describes the outputs as JSON.
    fn outputs(&self) -> String {
        let outputs = &self.results.description().outputs;
        serde_json::Value::from_iter(outputs.iter().map(output_json)).to_string()
    }

    fn units(&self) -> Units {
        Units::new(self.results.description())
    }

    /// Returns name, unit and value of each param.
    fn params<'py>(&self, py: Python<'py>) -> PyResult<Vec<(String, String, Bound<'py, PyAny>)>> {
        let described = self.results.description().params.iter().zip(self.results.params());
        let shown = described.map(|(param, value)| {
            let value = values::shown(py, value, param.unit.factor)?;
            Ok((param.name.clone(), param.unit.name.clone(), value))
        });
        shown.collect()
    }

    /// Returns time (s), fraction of the mesh cycle, roll angle (rad) and name of every position.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<(Array<'py>, Array<'py>, Array<'py>, Vec<String>)> {
        let steps: Vec<Step> = self.results.steps().collect();
        let column = |value: fn(&Step) -> f64| array(py, &steps.iter().map(value).collect::<Vec<_>>());
        Ok((
            column(|step| step.position().time)?,
            column(|step| step.position().cycle)?,
            column(|step| step.position().roll)?,
            steps.iter().map(|step| step.position().name.to_string()).collect(),
        ))
    }

    /// Returns the values of every output over the positions, in SI.
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Vec<Array<'py>>> {
        let steps: Vec<Step> = self.results.steps().collect();
        let output = |index: usize| {
            let value = |step: &Step| step.row().outputs.get(index).map_or(f64::NAN, |output| output.value);
            array(py, &steps.iter().map(value).collect::<Vec<_>>())
        };
        (0..self.results.description().outputs.len()).map(output).collect()
    }

    /// Returns the summary of every output in SI, as a dictionary.
    fn summaries<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let outputs = &self.results.description().outputs;
        let summaries = outputs.iter().filter_map(|output| self.results.summary_si(&output.name).ok());
        summaries.map(|summary| summary_dict(py, summary)).collect()
    }

    /// Returns facts about the run as a dictionary.
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let facts = PyDict::new(py);
        let (description, results) = (self.results.description(), &self.results);
        facts.set_item("model", &description.name)?;
        facts.set_item("doc", &description.doc)?;
        facts.set_item("seconds", results.time().as_secs_f64())?;
        facts.set_item("warnings", results.warnings())?;
        facts.set_item("findings", self.findings.clone())?;
        facts.set_item("settings", self.overrides.overridden())?;
        let plan = results.plan();
        facts.set_item("fidelity", plan.map(|plan| plan.fidelity.name()))?;
        let ignored = plan.into_iter().flat_map(|plan| &plan.ignored);
        let ignored: Vec<_> = ignored.map(|input| (input.input.clone(), input.reason.to_string())).collect();
        facts.set_item("ignored", ignored)?;
        let certificate = results.certificate().map(|certificate| {
            [
                certificate.complementarity,
                certificate.penetration,
                certificate.tension,
                certificate.equilibrium,
            ]
        });
        facts.set_item("certificate", certificate)?;
        let stages = results.timing().into_iter().flat_map(|timing| &timing.stages);
        let stages: Vec<_> = stages.map(|(name, time)| (*name, time.as_secs_f64())).collect();
        facts.set_item("stages", stages)?;
        Ok(facts)
    }

    /// Returns the derivatives of all statistics in the units of the model: output, statistic,
    /// param, unit, derivatives towards smaller and larger values, estimated error, and whether
    /// structures were built again.
    fn sensitivities(&self) -> Vec<SensitivityRow> {
        let all = self.sensitivity_table();
        let mut rows = Vec::new();
        for &output in &all.shown {
            for statistic in Statistic::ALL {
                let row = |entry: Entry| {
                    let is_new = all.sensitivities[entry.param].kind == Kind::ChangedStructures;
                    let [name, param] = [&all.outputs[output].name, &all.params[entry.param].name];
                    let unit = all.unit(output, entry.param);
                    let statistic = statistic.name().to_owned();
                    (name.clone(), statistic, param.clone(), unit, entry.sides, entry.error, is_new)
                };
                rows.extend(all.entries(output, statistic).into_iter().map(row));
            }
        }
        rows
    }

    /// Returns the params without derivatives, with reason and remedy.
    fn failed_sensitivities(&self) -> Vec<(String, String, String)> {
        let failure = |own: &Sensitivity| {
            let failure = own.failure.as_ref()?;
            Some((own.param.name.clone(), failure.message.clone(), failure.help.clone()))
        };
        self.results.sensitivities().iter().filter_map(failure).collect()
    }

    /// Returns the indices of the positions with fields.
    fn field_positions(&self) -> Vec<usize> {
        let positions = self.positions.iter().enumerate();
        positions.filter_map(|(index, (_, fields))| fields.as_ref().map(|_| index)).collect()
    }

    /// Returns the fields of a position as dictionaries of arrays, in SI.
    fn fields<'py>(&self, py: Python<'py>, position: usize) -> PyResult<Bound<'py, PyDict>> {
        match self.positions.get(position) {
            Some((_, Some(fields))) => fields::dict(py, fields),
            _ => Err(PyIndexError::new_err(format!("position {position} has no fields"))),
        }
    }

    /// Writes the run directory.
    fn save(&self, py: Python<'_>, directory: PathBuf, force: bool) -> PyResult<()> {
        let saved = py.detach(|| self.finished(self.details).save(&directory, force));
        saved.map_err(|error| errors::of_directory(py, error))
    }

    /// Writes what the report presents to an empty directory, and returns the page.
    fn report(&self, py: Python<'_>, directory: PathBuf) -> PyResult<String> {
        let saved = py.detach(|| self.finished(Details::default()).save(&directory, false));
        saved.map_err(|error| errors::of_directory(py, error))?;
        let page = directory.join(REPORT);
        fs::read_to_string(&page)
            .map_err(|error| PyOSError::new_err(format!("cannot read {}: {error}", page.display())))
    }
}

impl Results {
    fn sensitivity_table(&self) -> SensitivityTable {
        self.results.sensitivity_table(self.results.differentiated().to_vec())
    }

    fn finished(&self, details: Details) -> FinishedRun<'_> {
        FinishedRun {
            results: &self.results,
            overrides: self.overrides,
            positions: &self.positions,
            details,
            before: self.before.clone(),
        }
    }
}

fn summary_dict<'py>(py: Python<'py>, summary: &OutputSummary) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("min", summary.min)?;
    dict.set_item("max", summary.max)?;
    dict.set_item("mean", summary.mean)?;
    dict.set_item("peak_to_peak", summary.peak_to_peak)?;
    dict.set_item("at_max", summary.at_max)?;
    dict.set_item("location", summary.location.as_ref().map(|at| location_dict(py, at)).transpose()?)?;
    let harmonics = summary.harmonics.iter().map(|h| (h.order, h.amplitude, h.phase));
    dict.set_item("harmonics", harmonics.collect::<Vec<_>>())?;
    dict.set_item("error", summary.error.as_ref().map(|error| error_dict(py, error, summary)).transpose()?)?;
    Ok(dict)
}

fn error_dict<'py>(
    py: Python<'py>,
    error: &ErrorEstimate,
    summary: &OutputSummary,
) -> PyResult<Bound<'py, PyDict>> {
    let numbers = |of: &Statistics| [of.min, of.max, of.mean, of.peak_to_peak];
    let dict = PyDict::new(py);
    dict.set_item("total", numbers(&error.total))?;
    let parts = error.parts.iter().map(|(part, of)| (part.name(), numbers(of)));
    dict.set_item("parts", parts.collect::<Vec<_>>())?;
    let missing = error.not_estimated.iter().map(|(part, reason)| (part.name(), reason.clone()));
    dict.set_item("not_estimated", missing.collect::<Vec<_>>())?;
    dict.set_item("relative", error.relative(summary))?;
    Ok(dict)
}

fn location_dict<'py>(py: Python<'py>, location: &Location) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("body", &location.body)?;
    dict.set_item("tooth", location.tooth)?;
    dict.set_item("radius", location.radius)?;
    dict.set_item("roll_angle", location.roll_angle)?;
    dict.set_item("axial", location.axial)?;
    Ok(dict)
}
