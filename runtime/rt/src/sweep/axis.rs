//! Axes of a sweep: the values that a param takes, as given on the command line or in a file.

use crate::error::Error;
use crate::param_assignment::AssignedValue;
use crate::params::{InvalidParam, Setting, index_of};
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue};
use std::path::Path;

/// Largest number of cases of a sweep.
pub const MOST_CASES: usize = 1_000_000;
/// Suffix of a number of values that are equally spaced on a logarithmic scale.
const LOG: &str = "log";

/// Values of some params that vary together: one point per value, or per row of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Indices of the params in the model's description.
    pub params: Vec<usize>,
    /// Names of the points; empty if they have none.
    pub names: Vec<String>,
    /// Values by point and param.
    pub points: Vec<Vec<ParamValue>>,
}

fn refused(message: impl Into<String>, help: impl Into<String>) -> Error {
    Error::Given(InvalidParam::new(message, help))
}

impl Axis {
    /// Parses `NAME=VALUES`. The values are `FROM..TO:COUNT` for equally spaced numbers with both
    /// ends (`:COUNTlog` on a logarithmic scale), `A,B,C` for a list, or `*` for all choices of a
    /// text or Boolean param.
    ///
    /// # Errors
    /// The model has no such param, or the values are invalid for it.
    pub fn parse(text: &str, description: &ModelDescription) -> Result<Axis, Error> {
        let Some((name, values)) = text.split_once('=') else {
            return Err(refused(
                format!("`--over {text}` has no `=`"),
                "give the values after the name, like `--over torque=50..500:10`",
            ));
        };
        let index = index_of(description, name.trim())?;
        let (param, values) = (&description.params[index], values.trim());
        if matches!(param.repr, Repr::Array(_)) {
            return Err(refused(
                format!("`{}` is an array, which an axis cannot vary", param.name),
                "list its values in a file of cases, `--cases`",
            ));
        }
        let valid =
            |value: AssignedValue| Setting::new(description, index, &value, None).map(|set| set.value);
        let points = match values {
            "*" => all_choices(param)?,
            range if range.contains("..") => {
                let numbers = numbers_of(range, param, &valid)?;
                numbers.into_iter().map(|si| valid(AssignedValue::Si(si))).collect::<Result<_, _>>()?
            }
            list => {
                check_units(param, &list.split(',').collect::<Vec<_>>())?;
                let texts = list.split(',').map(|text| valid(AssignedValue::Text(text.trim().to_owned())));
                texts.collect::<Result<Vec<_>, _>>()?
            }
        };
        Ok(Axis {
            params: vec![index],
            names: Vec::new(),
            points: points.into_iter().map(|value| vec![value]).collect(),
        })
    }

    /// Reads cases from a CSV file: a line with the names of params, then a line per case with
    /// their values as after `--set`. A column `name` names the cases, unless the model has a param
    /// of this name.
    ///
    /// # Errors
    /// The file cannot be read; it has no case; a name is unknown; a value is invalid.
    pub fn of_file(path: &Path, description: &ModelDescription) -> Result<Axis, Error> {
        let shown = path.display();
        let unreadable = |error: csv::Error| {
            refused(
                format!("cannot read the cases in {shown}: {error}"),
                "give a CSV file with a line of param names",
            )
        };
        let reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_path(path);
        let mut reader = reader.map_err(unreadable)?;
        let head = reader.headers().map_err(unreadable)?.clone();
        let is_name = |column: &str| column == "name" && index_of(description, column).is_err();
        let mut columns = Vec::new();
        for column in &head {
            // A heading may have a unit in brackets, as those of sweep.csv.
            let (name, unit) = match column.strip_suffix(']').and_then(|column| column.split_once('[')) {
                Some((name, unit)) if index_of(description, column).is_err() => (name.trim(), unit.trim()),
                _ => (column, ""),
            };
            columns.push(match is_name(name) {
                true => None,
                false => Some((
                    index_of(description, name).map_err(|error| in_file(error, &shown))?,
                    unit.to_owned(),
                )),
            });
        }
        let named = columns.iter().filter(|column| column.is_none()).count();
        if named > 1 {
            return Err(refused(format!("{shown} has {named} columns `name`"), "keep one of them"));
        }
        let mut axis = Axis {
            params: columns.iter().flatten().map(|(index, _)| *index).collect(),
            names: Vec::new(),
            points: Vec::new(),
        };
        for (line, record) in reader.records().enumerate() {
            let record = record.map_err(unreadable)?;
            let mut point = Vec::new();
            for (cell, column) in record.iter().zip(&columns) {
                let Some((index, unit)) = column else {
                    axis.names.push(cell.to_owned());
                    continue;
                };
                if cell.is_empty() {
                    return Err(refused(
                        format!(
                            "case {} of {shown} has no value of `{}`",
                            line + 1,
                            description.params[*index].name
                        ),
                        "give every case a value of every param in the first line",
                    ));
                }
                let has_unit = cell.parse::<f64>().is_err();
                let text =
                    if unit.is_empty() || has_unit { cell.to_owned() } else { format!("{cell} {unit}") };
                let value = AssignedValue::Text(text);
                let set = Setting::new(description, *index, &value, None).map_err(|error| match error {
                    Error::Given(why) => {
                        let message = format!("case {} of {shown}: {}", line + 1, why.message);
                        Error::Given(InvalidParam { message, ..why })
                    }
                    error => error,
                })?;
                point.push(set.value);
            }
            axis.points.push(point);
        }
        match axis.points.is_empty() {
            true => Err(refused(format!("{shown} has no case"), "add a line of values below the names")),
            false => Ok(axis),
        }
    }
}

/// Adds the name of a file to an error.
fn in_file(error: Error, file: &std::path::Display<'_>) -> Error {
    match error {
        Error::Given(why) => {
            Error::Given(InvalidParam { message: format!("{file}: {}", why.message), ..why })
        }
        error => error,
    }
}

/// Refuses values of a number of which some have a unit and others not: 50..100 N*m would mean
/// 50 in another unit.
fn check_units(param: &ParamDescription, texts: &[&str]) -> Result<(), Error> {
    let bare = texts.iter().filter(|text| text.trim().parse::<f64>().is_ok()).count();
    if matches!(param.repr, Repr::Number) && bare > 0 && bare < texts.len() {
        return Err(refused(
            format!("some values of `{}` have a unit, and others do not: {}", param.name, texts.join(", ")),
            "give each value its unit, or none",
        ));
    }
    Ok(())
}

fn all_choices(param: &ParamDescription) -> Result<Vec<ParamValue>, Error> {
    match param.repr {
        Repr::Bool => Ok(vec![ParamValue::Bool(false), ParamValue::Bool(true)]),
        Repr::String if !param.choices.is_empty() => {
            Ok(param.choices.iter().cloned().map(ParamValue::String).collect())
        }
        _ => Err(refused(
            format!("`{}` has no list of choices for `*`", param.name),
            format!("list its values, like `{}=A,B`, or give a range, `FROM..TO:COUNT`", param.name),
        )),
    }
}

/// Returns the numbers of a range in SI.
fn numbers_of(
    range: &str,
    param: &ParamDescription,
    valid: &impl Fn(AssignedValue) -> Result<ParamValue, Error>,
) -> Result<Vec<f64>, Error> {
    let help = format!("give a range like `{}=FROM..TO:COUNT`, with both ends", param.name);
    let (ends, count) = range
        .rsplit_once(':')
        .ok_or_else(|| refused(format!("the range `{range}` has no number of values"), help.clone()))?;
    let (count, log) = match count.trim().strip_suffix(LOG) {
        Some(count) => (count.trim(), true),
        None => (count.trim(), false),
    };
    let count: usize =
        count.parse().ok().filter(|count| (2..=MOST_CASES).contains(count)).ok_or_else(|| {
            refused(format!("`{count}` is not a number of values from 2 to {MOST_CASES}"), help.clone())
        })?;
    let Some((from, to)) = ends.split_once("..") else { return Err(refused(help.clone(), "")) };
    check_units(param, &[from, to])?;
    let end = |text: &str| match valid(AssignedValue::Text(text.trim().to_owned()))? {
        ParamValue::Number(si) => Ok(si),
        _ => Err(refused(format!("`{}` is not numeric, so it has no range", param.name), "list its values")),
    };
    let (from, to) = (end(from)?, end(to)?);
    if log && !(from > 0.0 && to > 0.0) {
        return Err(refused(
            format!("the logarithmic range `{range}` is not positive"),
            "give positive ends",
        ));
    }
    let part = |k: usize| k as f64 / (count - 1) as f64;
    let at = |k: usize| match (k, log) {
        (0, _) => from,
        (k, _) if k == count - 1 => to,
        (k, false) => from + part(k) * (to - from),
        (k, true) => from * (to / from).powf(part(k)),
    };
    let round = |si: f64| if param.integral { si.round() } else { si };
    let mut numbers: Vec<f64> = (0..count).map(|k| round(at(k))).collect();
    numbers.dedup();
    Ok(numbers)
}
