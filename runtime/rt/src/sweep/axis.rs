//! Axes of a sweep: the values that a param takes, as given on the command line or in a file.

use crate::error::Error;
use crate::param_assignment::AssignedValue;
use crate::params::{InvalidParam, Setting, index_of};
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue};

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
    /// True if the values are equally spaced on a logarithmic scale.
    pub logarithmic: bool,
}

pub(super) fn refused(message: impl Into<String>, help: impl Into<String>) -> Error {
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
        let mut logarithmic = false;
        let points = match values {
            "*" => all_choices(param)?,
            range if range.contains("..") => {
                logarithmic = range.ends_with(LOG);
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
            logarithmic,
        })
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
