//! Study file of an optimization: variables, objective, constraints and settings, besides the load
//! cases and tolerances of every study.

use super::problem::{Effort, Problem, parse_constraint, parse_range, variable};
use crate::error::Error;
use crate::param_assignment::{AssignedValue, ParamAssignment};
use crate::params::{InvalidParam, shown};
use crate::sweep::study_file::{Reader, StudyFile, Table, Value, kind_of};
use crate::sweep::{Axis, CaseFile, Study, Tolerance, Varied, objective};
use calyx_abi::description::{ModelDescription, ParamValue};
use calyx_report::optimization::{Constraint, Measure, Variable};
use calyx_report::study::Objective;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;
use toml::de::DeValue;

/// Keys of the file of an optimization.
const KEYS: [&str; 10] = [
    "cases",
    "objective",
    "constraints",
    "params",
    "variables",
    "axes",
    "tolerances",
    "deviations",
    "sampling",
    "optimization",
];
/// Keys of a variable.
const VARIABLE_KEYS: [&str; 3] = ["from", "to", "initial"];
/// Keys of the settings.
const SETTING_KEYS: [&str; 7] =
    ["starts", "rounds", "designs", "tolerance", "seed", "over_cases", "over_samples"];
/// Remedy for a value that is no range.
const RANGE_FORMS: &str = "write a text like \"0 um..20 um\", or a table like `{ from = \"0 um\", to = \"20 um\", initial = \"5 um\" }`";
/// Remedy for a value that is no measure.
const MEASURES: &str = "write \"worst\", \"mean\" or \"percentile 95\"";

/// Reads the problem of a study file. `cases` is a file of load cases in place of the file's own;
/// `given` are the values of params in all designs.
///
/// # Errors
/// All mistakes of the file, in its order.
pub fn read(
    file: &StudyFile,
    cases: Option<&Path>,
    given: &[ParamAssignment],
    description: &ModelDescription,
) -> Result<Problem, Vec<InvalidParam>> {
    let mut parts = Parts::default();
    let mut study =
        file.read_with(description, &KEYS, "the study file of an optimization", |reader, root, _| {
            parts.read(reader, root);
        })?;
    parts.check(file, &study, given, description)?;
    let refused = |error: Error| match error {
        Error::Given(refused) => vec![refused],
        Error::Model(error) => vec![InvalidParam::new(error.message, error.help)],
    };
    if let Some(path) = cases {
        study.cases = Some(CaseFile::read(path, description).map_err(refused)?);
    }
    let mut axes: Vec<Axis> = study.cases.take().map(|file| file.axis).into_iter().collect();
    axes.append(&mut study.axes);
    let variables = parts.variables.iter().map(|(_, _, variable)| variable.clone()).collect();
    let params: Vec<usize> = parts.variables.iter().map(|(_, index, _)| *index).collect();
    let toleranced = study.tolerances.into_iter().chain(parts.deviations.clone()).collect();
    // The sampled values of variables are deviations, which may be outside of the ranges of the
    // params.
    let unbounded = without_ranges(description, &params);
    let sample = study.sampling.axis(toleranced, &unbounded).map_err(refused)?.map(|(axis, _)| axis);
    parts.check_deviations(file, sample.as_ref(), description)?;
    let Some(objective) = parts.objective else {
        let help = "add one, like `objective = \"min transmission_error.peak_to_peak\"`";
        return Err(vec![InvalidParam::new("the study file has no objective", help)]);
    };
    let (over_cases, over_samples) = (parts.over_cases, parts.over_samples);
    Ok(Problem {
        variables,
        params,
        objective,
        over_cases,
        over_samples,
        constraints: parts.constraints,
        axes,
        sample,
        effort: parts.effort,
    })
}

/// Returns the description with params that have no range.
fn without_ranges(description: &ModelDescription, params: &[usize]) -> ModelDescription {
    let mut unbounded = description.clone();
    for &index in params {
        (unbounded.params[index].low, unbounded.params[index].high) = (None, None);
    }
    unbounded
}

/// Parts of the file that only an optimization has.
struct Parts {
    /// Variables in the order of the file, with their location and index.
    variables: Vec<(usize, usize, Variable)>,
    objective: Option<Objective>,
    constraints: Vec<Constraint>,
    deviations: Vec<Tolerance>,
    over_cases: Measure,
    over_samples: Measure,
    effort: Effort,
}

impl Default for Parts {
    fn default() -> Parts {
        Parts {
            variables: Vec::new(),
            objective: None,
            constraints: Vec::new(),
            deviations: Vec::new(),
            over_cases: Measure::Worst,
            over_samples: Measure::Worst,
            effort: Effort::default(),
        }
    }
}

impl Parts {
    fn read(&mut self, reader: &mut Reader<'_>, root: &Table<'_>) {
        if let Some(table) = root.get("variables").and_then(|value| reader.sub_table(value, "variables")) {
            let variables = &mut self.variables;
            reader.entries(table, "", &mut |reader, name, at, value| {
                variables.extend(read_variable(reader, name, at, value));
            });
        }
        // Tables are sorted by name; the order is that of the file.
        self.variables.sort_by_key(|(at, _, _)| *at);
        if let Some(value) = root.get("objective") {
            let help = "write one, like `objective = \"min transmission_error.peak_to_peak\"`";
            if let Some(text) = reader.text(value, "objective", help) {
                let parsed = objective::parse(text, reader.description);
                self.objective = reader.recorded(value.span(), parsed);
            }
        }
        if let Some(value) = root.get("constraints") {
            self.constraints = read_constraints(reader, value);
        }
        if let Some(table) = root.get("deviations").and_then(|value| reader.sub_table(value, "deviations")) {
            let indices: Vec<usize> = self.variables.iter().map(|(_, index, _)| *index).collect();
            let own = reader.description;
            let unbounded = without_ranges(own, &indices);
            let mut inner = reader.with_description(&unbounded);
            let deviations = &mut self.deviations;
            inner.entries(table, "", &mut |reader, name, at, value| {
                deviations.extend(reader.tolerance(name, at, value));
            });
            let mistakes = inner.into_mistakes();
            reader.extend(mistakes);
        }
        if let Some(table) =
            root.get("optimization").and_then(|value| reader.sub_table(value, "optimization"))
        {
            self.settings(reader, table);
        }
    }

    fn settings(&mut self, reader: &mut Reader<'_>, table: &Table<'_>) {
        reader.check_keys(table, &SETTING_KEYS, "`optimization`");
        let most = |reader: &mut Reader<'_>, key: &str, range: Range<usize>| -> Option<usize> {
            let value = table.get(key)?;
            let help = format!("give a whole number from {} to {}", range.start, range.end);
            let number = reader.whole(value, key, &help)?;
            if !(range.start..=range.end).contains(&number) {
                reader.mistake(value.span(), format!("`{key}` cannot be {number}"), help);
                return None;
            }
            Some(number)
        };
        if let Some(starts) = most(reader, "starts", 1..1000) {
            self.effort.starts = starts;
        }
        if let Some(rounds) = most(reader, "rounds", 1..100) {
            self.effort.rounds = rounds;
        }
        if let Some(designs) = most(reader, "designs", 10..1_000_000) {
            self.effort.designs = designs;
        }
        if let Some(value) = table.get("tolerance") {
            let help = "give a number from 1e-9 to 0.1, relative to the ranges of the variables";
            match reader.assigned(value) {
                Some(AssignedValue::Number(tolerance)) if (1e-9..=0.1).contains(&tolerance) => {
                    self.effort.tolerance = tolerance;
                }
                _ => reader.mistake(value.span(), "the tolerance is not a number within its bounds", help),
            }
        }
        if let Some(value) = table.get("seed") {
            let seed = reader.whole(value, "seed", "give a whole number, like `seed = 1`");
            self.effort.seed = seed.unwrap_or_default();
        }
        for (key, measure) in [("over_cases", &mut self.over_cases), ("over_samples", &mut self.over_samples)]
        {
            let Some(value) = table.get(key) else { continue };
            let Some(text) = reader.text(value, key, MEASURES) else { continue };
            match Measure::named(text) {
                Some(named) => *measure = named,
                None => {
                    reader.mistake(value.span(), format!("there is no measure called `{text}`"), MEASURES)
                }
            }
        }
    }

    /// Checks that no param has two roles.
    fn check(
        &self,
        file: &StudyFile,
        study: &Study,
        given: &[ParamAssignment],
        description: &ModelDescription,
    ) -> Result<(), Vec<InvalidParam>> {
        let mut mistakes = Vec::new();
        if self.variables.is_empty() {
            let help = "add `[variables]`, and below it lines like `tip_relief = \"0 um..20 um\"`";
            mistakes.push(InvalidParam::new("the study file has no variables", help));
        }
        let axes = study.axes.iter().chain(study.cases.as_ref().map(|file| &file.axis));
        let varied: Vec<Varied> = axes.flat_map(|axis| axis.params.clone()).collect();
        for (at, index, _) in &self.variables {
            let name = &description.params[*index].name;
            let mut twice = |what: &str, help: &str| {
                let origin = file.origin(*at..at + name.len());
                let message = format!("`{name}` is a variable and {what}");
                mistakes.push(InvalidParam { origin, ..InvalidParam::new(message, help) });
            };
            if varied.contains(&Varied::Param(*index)) {
                twice("differs between the load cases", "remove one of them");
            }
            if given.iter().any(|given| given.name == *name) {
                let help =
                    "remove it from [params], `--set` and `--params`, or give `initial` to the variable";
                twice("is also set to one value", help);
            }
            if study.tolerances.iter().any(|tolerance| tolerance.param == *index) {
                let help = "give its deviation from the variable in [deviations], like `normal(0 um, 2 um)`";
                twice("has a tolerance", help);
            }
        }
        for deviation in &self.deviations {
            if !self.variables.iter().any(|(_, index, _)| *index == deviation.param) {
                let name = &description.params[deviation.param].name;
                let help = "move it to [tolerances], with its own values";
                let message = format!("`{name}` has a deviation and is no variable");
                mistakes.push(InvalidParam {
                    origin: deviation.origin.clone(),
                    ..InvalidParam::new(message, help)
                });
            }
        }
        if mistakes.is_empty() { Ok(()) } else { Err(mistakes) }
    }
}

impl Parts {
    /// Checks that the variables with their deviations are in the ranges of their params, as far as
    /// these do not depend on other params.
    fn check_deviations(
        &self,
        file: &StudyFile,
        sample: Option<&Axis>,
        description: &ModelDescription,
    ) -> Result<(), Vec<InvalidParam>> {
        let Some(sample) = sample else { return Ok(()) };
        let mut mistakes = Vec::new();
        for (at, index, variable) in &self.variables {
            let own = sample.params.iter().position(|varied| *varied == Varied::Param(*index));
            let Some(column) = own else { continue };
            let deviations = sample.points.iter().filter_map(|point| match point.get(column) {
                Some(ParamValue::Number(deviation)) => Some(*deviation),
                _ => None,
            });
            let (least, largest) = deviations.fold((0.0_f64, 0.0_f64), |(least, largest), deviation| {
                (least.min(deviation), largest.max(deviation))
            });
            let param = &description.params[*index];
            let low = param.low.map_or(variable.low, |low| variable.low.max(low - least));
            let high = param.high.map_or(variable.high, |high| variable.high.min(high - largest));
            if (low, high) != (variable.low, variable.high) {
                let origin = file.origin(*at..at + param.name.len());
                let message = format!("`{}` with its deviations leaves the range of the param", param.name);
                let help = format!(
                    "give the variable a range within {} .. {}, or widen that of the model",
                    shown(param, low),
                    shown(param, high)
                );
                mistakes.push(InvalidParam { origin, ..InvalidParam::new(message, help) });
            }
        }
        if mistakes.is_empty() { Ok(()) } else { Err(mistakes) }
    }
}

fn read_variable(
    reader: &mut Reader<'_>,
    name: &str,
    at: Range<usize>,
    value: &Value<'_>,
) -> Option<(usize, usize, Variable)> {
    let index = variable(name, reader.description);
    let index = reader.recorded(at.clone(), index)?;
    let (ends, initial) = match value.get_ref() {
        DeValue::String(text) => {
            let Some((low, high)) = text.split_once("..") else {
                reader.mistake(value.span(), format!("`{text}` is not a range"), RANGE_FORMS);
                return None;
            };
            ([low, high].map(|end| AssignedValue::Text(end.trim().to_owned())), None)
        }
        DeValue::Table(table) => {
            reader.check_keys(table, &VARIABLE_KEYS, "a variable");
            let mut ends = Vec::new();
            for key in &VARIABLE_KEYS[..2] {
                let Some(end) = table.get(*key) else {
                    reader.mistake(
                        value.span(),
                        format!("the variable `{name}` has no `{key}`"),
                        RANGE_FORMS,
                    );
                    return None;
                };
                ends.push(reader.assigned(end)?);
            }
            let initial = match table.get("initial") {
                Some(initial) => Some(reader.assigned(initial)?),
                None => None,
            };
            ([ends[0].clone(), ends[1].clone()], initial)
        }
        other => {
            reader.mistake(value.span(), format!("the variable `{name}` is {}", kind_of(other)), RANGE_FORMS);
            return None;
        }
    };
    let mut texts: Vec<String> = ends.iter().map(ToString::to_string).collect();
    texts.extend(initial.as_ref().map(ToString::to_string));
    let checked = crate::sweep::check_units(Varied::Param(index), &texts, reader.description);
    reader.recorded(value.span(), checked)?;
    let range = parse_range(index, [&ends[0], &ends[1]], initial.as_ref(), reader.description);
    let range = reader.recorded(value.span(), range)?;
    Some((at.start, index, range))
}

fn read_constraints(reader: &mut Reader<'_>, value: &Value<'_>) -> Vec<Constraint> {
    let help = "list them, like `constraints = [\"max_contact_pressure <= 1500 MPa\"]`";
    let DeValue::Array(elements) = value.get_ref() else {
        let message = format!("`constraints` is {}, not an array", kind_of(value.get_ref()));
        reader.mistake(value.span(), message, help);
        return Vec::new();
    };
    let mut all = Vec::new();
    for element in elements.iter().map(|element: &Spanned<DeValue<'_>>| element) {
        let Some(text) = reader.text(element, "constraints", help) else { continue };
        let parsed = parse_constraint(text, reader.description);
        all.extend(reader.recorded(element.span(), parsed));
    }
    all
}
