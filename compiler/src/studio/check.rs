//! Checks the values of a form as `calyx run` would, and predicts the cost of the run.

use super::error::RequestError;
use super::form;
use super::model::{Model, Snapshot, diagnostics, hash_of, rendered};
use super::settings::{self, CheckedSettings, Settings};
use crate::{Checked, check_run_within};
use axum::http::StatusCode;
use calyx_abi::description::ModelDescription;
use calyx_lang::diagnostic::Severity;
use calyx_rt::options::rates_file;
use calyx_rt::params::{assigned_value, check_assignment};
use calyx_rt::{InvalidParam, ParamAssignment};
use calyx_runtime::cost::Rates;
use calyx_runtime::resources::Resources;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::io;
use std::sync::OnceLock;

/// Values of a form: texts by name, as after `--set`.
pub(crate) type Values = BTreeMap<String, String>;

/// Content of a form: values of params, and analysis settings.
#[derive(Clone, Default)]
pub(crate) struct Form {
    pub params: Values,
    pub settings: Settings,
}

/// Returns the assignments of a form.
pub(crate) fn assignments(values: &Values) -> Vec<ParamAssignment> {
    values.iter().map(|(name, value)| ParamAssignment::text(name, value.trim())).collect()
}

/// Result of a check: the JSON of the response, and whether a run would start.
pub(crate) struct Outcome {
    pub json: Value,
    pub is_runnable: bool,
}

/// Returns the values of params in the units of the form, as records of runs have them, by name.
fn normalized(description: &ModelDescription, given: &[ParamAssignment]) -> Map<String, Value> {
    let text = |assignment: &ParamAssignment| {
        let param = description.params.iter().find(|param| param.name == assignment.name)?;
        let value = assigned_value(description, assignment).ok()?;
        Some((assignment.name.clone(), json!(form::text_of(&value, param))))
    };
    given.iter().filter_map(text).collect()
}

/// Checks the values of a form. Blocks while the model is elaborated.
///
/// # Errors
/// The model cannot be read.
pub(crate) fn check(model: &Model, snapshot: &Snapshot, form: &Form) -> io::Result<Outcome> {
    let values = &form.params;
    let mut errors = Map::new();
    let CheckedSettings { overrides, errors: mut setting_errors } = settings::checked(&form.settings);
    let given = assignments(values);
    let (valid, invalid): (Vec<_>, Vec<_>) = given
        .into_iter()
        .map(|assignment| (check_assignment(&snapshot.description, &assignment), assignment))
        .partition(|(checked, _)| checked.is_ok());
    for (checked, assignment) in invalid {
        if let Err(invalid) = checked {
            let is_missing = values.get(&assignment.name).is_some_and(|text| text.trim().is_empty());
            let found = if is_missing { missing() } else { reason(&invalid) };
            errors.insert(assignment.name, found);
        }
    }
    let given: Vec<ParamAssignment> = valid.into_iter().map(|(_, assignment)| assignment).collect();
    let checked = check_run_within(model.path(), model.allowed(), &given, overrides, None)?;
    let mut refused = Value::Null;
    if let Some(invalid) = &checked.refused {
        // The range of a param may depend on other params.
        match named_param(invalid, snapshot) {
            Some(name) => {
                errors.insert(name, reason(invalid));
            }
            None => refused = reason(invalid),
        }
    }
    if let Some((name, error)) = unsuitable_setting(&checked) {
        setting_errors.entry(name).or_insert(error);
    }
    let is_valid = errors.is_empty() && setting_errors.is_empty() && refused.is_null();
    let is_runnable = is_valid && checked.program.is_some() && !checked.has_errors();
    let json = json!({
        "version": snapshot.version,
        "source": hash_of(model.path()),
        "runnable": is_runnable,
        "values": normalized(&snapshot.description, &given),
        "errors": errors,
        "setting_errors": setting_errors,
        "refused": refused,
        "diagnostics": diagnostics(&checked.diagnostics, &checked.files),
        "rendered": rendered(&checked.diagnostics, &checked.files),
        "plan": plan(&checked, &form.settings),
        "gear_data": checked.gear_data.text(),
    });
    Ok(Outcome { json, is_runnable })
}

/// Returns the setting with which the model cannot be analysed, and the error of its field.
fn unsuitable_setting(checked: &Checked) -> Option<(String, Value)> {
    let mut errors = checked.diagnostics.iter().filter(|found| found.severity == Severity::Error);
    errors.find_map(|error| {
        let help = error.help.as_deref()?;
        let name = settings::named_in(help)?;
        Some((name.to_owned(), json!({ "message": error.message, "help": help })))
    })
}

/// Returns the files of the viewer for the scene at time 0: parts and position. Blocks while the
/// model is elaborated and its gears are meshed.
///
/// # Errors
/// The model cannot be read, its scene cannot be planned, or it analyses nothing.
pub(crate) fn scene_of(
    model: &Model,
    snapshot: &Snapshot,
    form: &Form,
) -> Result<[Vec<u8>; 2], RequestError> {
    let overrides = settings::checked(&form.settings).overrides;
    let given: Vec<ParamAssignment> = assignments(&form.params)
        .into_iter()
        .filter(|assignment| check_assignment(&snapshot.description, assignment).is_ok())
        .collect();
    let checked =
        check_run_within(model.path(), model.allowed(), &given, overrides, None).map_err(|error| {
            RequestError::conflict(format!("cannot read the model: {error}"), "restore its file")
        })?;
    let plan = checked.plan.as_ref().ok_or_else(|| {
        RequestError::not_found("the model has errors, or it analyses nothing: it has no scene")
    })?;
    let files = {
        let ModelDescription { name, units, .. } = &snapshot.description;
        plan.work.view_files((name, units), &Resources::default())
    };
    files.map_err(|error| RequestError::new(StatusCode::UNPROCESSABLE_ENTITY, error.message, error.help))
}

/// Returns the error of an empty field.
fn missing() -> Value {
    json!({ "code": null, "message": "a value is missing", "help": "enter a value, or reset the param to its default" })
}

fn reason(invalid: &InvalidParam) -> Value {
    json!({ "code": null, "message": invalid.message, "help": without_option(&invalid.help) })
}

/// Removes the example of a command line, which does not apply to a form.
fn without_option(help: &str) -> String {
    let example = ", like `--set";
    match help.split_once(example).and_then(|(before, rest)| Some((before, rest.split_once('`')?.1))) {
        Some((before, after)) => format!("{before}{after}"),
        None => help.to_owned(),
    }
}

/// Returns the param that a message names first.
fn named_param(invalid: &InvalidParam, snapshot: &Snapshot) -> Option<String> {
    let name = invalid.message.split('`').nth(1)?;
    snapshot.description.params.iter().any(|param| param.name == name).then(|| name.to_owned())
}

/// Returns the plan and the predictions, as `calyx explain` prints them; `null` if the model
/// analyses nothing or has errors.
fn plan(checked: &Checked, settings: &Settings) -> Value {
    let Some(plan) = &checked.plan else { return Value::Null };
    static RATES: OnceLock<Rates> = OnceLock::new();
    let rates = RATES.get_or_init(|| Rates::of_this_machine(rates_file().as_deref(), false));
    let (cost, disk) = (plan.cost(rates), plan.disk());
    json!({
        "fidelity": plan.fidelity,
        "three_dimensional": plan.three_dimensional,
        "positions": plan.positions.iter().sum::<usize>(),
        "time": cost.time(),
        "memory": cost.memory(),
        "disk": if settings::requests_meshes(settings) { disk.with_meshes } else { disk.view },
        "text": plan.text(),
        "cost": format!("{}  {}\n", cost.text(), disk.text()),
        "ignored_inputs": pairs(&plan.ignored_inputs),
        "refused_outputs": plan.refused.iter().map(|(name, reason)| (name.clone(), json!(reason))).collect::<Map<_, _>>(),
    })
}

fn pairs(all: &[(String, String)]) -> Map<String, Value> {
    all.iter().map(|(name, reason)| (name.clone(), json!(reason))).collect()
}
