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
    let of = |output: &str, statistic| Objective { output: output.to_owned(), statistic, maximize };
    if output_of(description, name).is_ok() {
        return Ok(of(name, Statistic::Max));
    }
    let parts = name.rsplit_once('.').and_then(|(output, part)| Some((output, Statistic::named(part)?)));
    if let Some((output, statistic)) = parts {
        return output_of(description, output).map(|_| of(output, statistic));
    }
    output_of(description, name).map(|_| of(name, Statistic::Max))
}
