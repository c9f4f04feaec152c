//! Objectives of a study, as they are written.

use super::axis::refused;
use crate::error::Error;
use crate::params::output_of;
use calyx_abi::description::ModelDescription;
use calyx_report::study::{Objective, Statistic};

/// Parses `min OUTPUT.STATISTIC` or `max OUTPUT.STATISTIC`. Without a statistic, the objective is
/// the largest value over the positions.
///
/// # Errors
/// The text has another form, or the model has no such output.
pub fn parse(text: &str, description: &ModelDescription) -> Result<Objective, Error> {
    const FORM: &str =
        "write `min OUTPUT` or `max OUTPUT`, where OUTPUT may end with .min, .mean, .max or .peak_to_peak";
    let words: Vec<&str> = text.split_whitespace().collect();
    let [direction, name] = words[..] else {
        return Err(refused(format!("`{text}` is not an objective"), FORM));
    };
    let maximize = match direction {
        "min" => false,
        "max" => true,
        _ => return Err(refused(format!("an objective begins with min or max, not `{direction}`"), FORM)),
    };
    let (output, statistic) = output_and_statistic(name, description)?;
    let statistic = statistic.unwrap_or(Statistic::Max);
    Ok(Objective { output: output.to_owned(), statistic, maximize })
}

/// Splits `OUTPUT.STATISTIC`, or `OUTPUT` alone.
///
/// # Errors
/// The model has no such output, or there is no such statistic.
pub(crate) fn output_and_statistic<'n>(
    name: &'n str,
    description: &ModelDescription,
) -> Result<(&'n str, Option<Statistic>), Error> {
    let Err(unknown) = output_of(description, name) else { return Ok((name, None)) };
    let Some((output, part)) = name.rsplit_once('.') else { return Err(unknown) };
    output_of(description, output)?;
    match Statistic::named(part) {
        Some(statistic) => Ok((output, Some(statistic))),
        None => Err(refused(
            format!("`{output}` has no statistic called `{part}`"),
            "choose among .min, .mean, .max and .peak_to_peak",
        )),
    }
}
