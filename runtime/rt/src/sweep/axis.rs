//! Axes of a sweep: the values that a param takes, as given on the command line or in a file.

use super::varied::Varied;
use crate::error::Error;
use crate::param_assignment::AssignedValue;
use crate::params::InvalidParam;
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamValue};

/// Largest number of cases of a sweep.
pub const MOST_CASES: usize = 1_000_000;
/// Suffix of a number of values that are equally spaced on a logarithmic scale.
const LOG: &str = "log";

/// Values of some params that vary together: one point per value, or per row of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    pub params: Vec<Varied>,
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
    /// Creates the axis of one quantity.
    pub(super) fn of(varied: Varied, values: Vec<ParamValue>, logarithmic: bool) -> Axis {
        let points = values.into_iter().map(|value| vec![value]).collect();
        Axis { params: vec![varied], names: Vec::new(), points, logarithmic }
    }

    /// Parses `NAME=VALUES`, see [`Axis::of_values`].
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
        Axis::of_values(Varied::named(name.trim(), description)?, values.trim(), description)
    }

    /// Parses the values of a quantity: `FROM..TO:COUNT` for equally spaced numbers with both ends
    /// (`:COUNTlog` on a logarithmic scale), `A,B,C` for a list, or `*` for all choices of a text
    /// or Boolean param.
    ///
    /// # Errors
    /// The values are invalid.
    pub(super) fn of_values(
        varied: Varied,
        values: &str,
        description: &ModelDescription,
    ) -> Result<Axis, Error> {
        check_not_array(varied, description)?;
        let valid = |value: AssignedValue| varied.value(&value, None, description);
        let mut logarithmic = false;
        let values = match values {
            "*" => varied.all_choices(description)?,
            range if range.contains("..") => {
                logarithmic = range.ends_with(LOG);
                let numbers = numbers_of(range, varied, description)?;
                numbers.into_iter().map(|si| valid(AssignedValue::Si(si))).collect::<Result<_, _>>()?
            }
            list => {
                check_units(varied, &list.split(',').collect::<Vec<_>>(), description)?;
                let texts = list.split(',').map(|text| valid(AssignedValue::Text(text.trim().to_owned())));
                texts.collect::<Result<Vec<_>, _>>()?
            }
        };
        Ok(Axis::of(varied, values, logarithmic))
    }
}

pub(super) fn check_not_array(varied: Varied, description: &ModelDescription) -> Result<(), Error> {
    match varied.param(description) {
        Some(param) if matches!(param.repr, Repr::Array(_)) => Err(refused(
            format!("`{}` is an array, which an axis cannot vary", param.name),
            "list its values in a file of cases, `--cases`",
        )),
        _ => Ok(()),
    }
}

/// Refuses values of a number of which some have a unit and others not: 50..100 N*m would mean
/// 50 in another unit.
pub(crate) fn check_units(
    varied: Varied,
    texts: &[impl AsRef<str>],
    description: &ModelDescription,
) -> Result<(), Error> {
    let Some(param) = varied.param(description).filter(|param| matches!(param.repr, Repr::Number)) else {
        return Ok(());
    };
    let bare = texts.iter().filter(|text| text.as_ref().trim().parse::<f64>().is_ok()).count();
    if bare > 0 && bare < texts.len() {
        let texts: Vec<&str> = texts.iter().map(AsRef::as_ref).collect();
        return Err(refused(
            format!("some values of `{}` have a unit, and others do not: {}", param.name, texts.join(", ")),
            "give each value its unit, or none",
        ));
    }
    Ok(())
}

/// Returns the numbers of a range in SI.
fn numbers_of(range: &str, varied: Varied, description: &ModelDescription) -> Result<Vec<f64>, Error> {
    let name = varied.name(description);
    let help = format!("give a range like `{name}=FROM..TO:COUNT`, with both ends");
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
    check_units(varied, &[from, to], description)?;
    let end = |text: &str| {
        let value = varied.value(&AssignedValue::Text(text.trim().to_owned()), None, description)?;
        number(&value, name)
    };
    let (from, to) = (end(from)?, end(to)?);
    if log && !(from > 0.0 && to > 0.0) {
        return Err(refused(
            format!("the logarithmic range `{range}` is not positive"),
            "give positive ends",
        ));
    }
    let integral = varied.param(description).is_some_and(|param| param.integral);
    Ok(spaced([from, to], count, log, integral))
}

/// Returns the number that is an end of a range.
pub(super) fn number(value: &ParamValue, name: &str) -> Result<f64, Error> {
    match value {
        ParamValue::Number(si) => Ok(*si),
        _ => Err(refused(format!("`{name}` is not numeric, so it has no range"), "list its values")),
    }
}

/// Returns equally spaced numbers with both ends, on a linear or logarithmic scale.
pub(super) fn spaced([from, to]: [f64; 2], count: usize, log: bool, integral: bool) -> Vec<f64> {
    let part = |k: usize| k as f64 / (count - 1) as f64;
    let at = |k: usize| match (k, log) {
        (0, _) => from,
        (k, _) if k == count - 1 => to,
        (k, false) => from + part(k) * (to - from),
        (k, true) => from * libm::pow(to / from, part(k)),
    };
    let round = |si: f64| if integral { si.round() } else { si };
    let mut numbers: Vec<f64> = (0..count).map(|k| round(at(k))).collect();
    numbers.dedup();
    numbers
}
