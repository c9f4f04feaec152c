//! Summary table after a run.

use crate::choices::{counts, described};
use calyx_abi::description::{ModelDescription, choice_of};
use calyx_abi::units::{from_si, shortest};
use calyx_runtime::estimate::Part;
use calyx_runtime::results::{AnalysisResult, Location, OutputSummary, StepRow};

/// Formats one line per output, in the model's units, with the position of its maximum.
pub fn summary(description: &ModelDescription, result: &AnalysisResult) -> String {
    let at = if passes_no_cycle(result) { "maximum at time" } else { "maximum at roll" };
    // Without error estimates there is no column of errors.
    let estimated = result.summaries.iter().any(|summary| summary.error.is_some());
    let with_error = |mut cells: Vec<String>, error: String| {
        if estimated {
            cells.insert(cells.len() - 1, error);
        }
        cells
    };
    let head = ["output", "unit", "min", "mean", "max", "peak to peak", at].map(String::from);
    let without_level = without_level(result);
    let error_head = if without_level.is_some() { "error*" } else { "error" };
    let mut rows = vec![with_error(head.into(), error_head.into())];
    for (index, (output, summary)) in description.outputs.iter().zip(&result.summaries).enumerate() {
        if !output.choices.is_empty() {
            let values = result.rows.iter().filter_map(|row| row.outputs.get(index)).map(|at| at.value);
            rows.push(with_error(of_choices(&output.name, &counts(&output.choices, values)), String::new()));
            continue;
        }
        let rounding = summary.error.as_ref().map_or(0.0, |error| error.rounding);
        let largest = summary.min.abs().max(summary.max.abs());
        let shown = |si: f64| number(from_si(without_rounding(si, largest, rounding), output.unit.factor));
        let variation = variation([summary.min, summary.max], summary.peak_to_peak);
        let cells = vec![
            output.name.clone(),
            output.unit.name.clone(),
            shown(summary.min),
            shown(summary.mean),
            shown(summary.max),
            shown(variation),
            match variation {
                _ if summary.max.is_nan() => String::new(),
                0.0 if result.rows.len() > 1 && summary.location.is_none() => "constant".into(),
                _ => place(result, summary.at_max, summary.location.as_ref()),
            },
        ];
        rows.push(with_error(cells, error(summary, output.unit.factor)));
    }
    let search = result.tolerance_search.as_ref().map(|search| search.describe() + "\n");
    without_level.unwrap_or_default() + &align(&rows) + &search.unwrap_or_default()
}

/// Formats the line of an output that numbers choices: the most frequent choice in place of the
/// mean, and all choices if there are several.
fn of_choices(name: &str, counts: &[(String, usize)]) -> Vec<String> {
    let most = counts.first().map_or_else(String::new, |(choice, _)| choice.clone());
    let several = if counts.len() > 1 { described(counts) } else { String::new() };
    let none = String::new;
    vec![name.to_owned(), none(), none(), most, none(), none(), several]
}

/// Variation of an output, relative to its largest magnitude, up to which it is rounding noise.
const ROUNDING: f64 = 1e-12;

/// Returns the peak-to-peak value of an output with these extremes, or 0 if it is rounding noise of
/// a constant.
pub(crate) fn variation(extremes: [f64; 2], peak_to_peak: f64) -> f64 {
    let [smallest, largest] = extremes.map(f64::abs);
    if peak_to_peak <= ROUNDING * smallest.max(largest) { 0.0 } else { peak_to_peak }
}

/// Returns a value, or 0 if it is the residue of a sum whose terms cancel: below the known rounding
/// error of its output, or below [`ROUNDING`] relative to the output's largest magnitude.
pub fn without_rounding(value: f64, largest: f64, rounding: f64) -> f64 {
    let noise = if largest.is_finite() { rounding.max(ROUNDING * largest) } else { rounding };
    if value.abs() <= noise { 0.0 } else { value }
}

/// Formats one line per output of a model without an analysis, which has one row.
pub fn values(description: &ModelDescription, rows: &[StepRow]) -> String {
    let Some(row) = rows.first() else { return String::new() };
    let mut lines = vec![["output", "unit", "value", ""].map(String::from).to_vec()];
    for (output, observed) in description.outputs.iter().zip(&row.outputs) {
        let value = match choice_of(&output.choices, observed.value) {
            Some(choice) => choice.to_owned(),
            None => number(from_si(observed.value, output.unit.factor)),
        };
        lines.push(vec![output.name.clone(), output.unit.name.clone(), value, String::new()]);
    }
    align(&lines)
}

/// Returns the line above the table that states which errors its column excludes; `None` if it
/// includes all, or if there is no such column.
fn without_level(result: &AnalysisResult) -> Option<String> {
    let estimates = || result.summaries.iter().filter_map(|summary| summary.error.as_ref());
    let shown = || estimates().filter(|error| !error.parts.is_empty());
    let reasons = || shown().filter(|error| !error.includes_level()).flat_map(|error| &error.not_estimated);
    let (_, reason) = reasons().find(|(part, _)| *part == Part::Level)?;
    let included = |part: &&Part| shown().any(|error| error.parts.iter().any(|(own, _)| own == *part));
    let missing = |part: &&Part| {
        **part != Part::Level && shown().any(|error| error.not_estimated.iter().any(|(own, _)| own == *part))
    };
    let [included, mut missing]: [Vec<String>; 2] = [
        Part::ALL.iter().filter(included).map(|part| part.title().to_owned()).collect(),
        Part::ALL.iter().filter(missing).map(|part| part.title().to_owned()).collect(),
    ];
    missing.push(format!("the error of fidelity \"{}\" itself", result.plan.fidelity.name()));
    Some(format!(
        "* numerical error: {}\n  not included: {}\n  ({reason})\n",
        included.join(", "),
        missing.join(", ")
    ))
}

/// Formats the estimated error of the largest magnitude as a fraction of it, or in the output's
/// unit if there is no such magnitude. Two digits, which is more than the accuracy of an estimate.
fn error(summary: &OutputSummary, factor: f64) -> String {
    let known = summary.error.as_ref().filter(|error| !summary.max.is_nan() && !error.parts.is_empty());
    let Some(error) = known else { return String::new() };
    let two_digits = |value: f64| format!("{value:.1e}").parse().unwrap_or(f64::NAN);
    if error.is_rounding(summary) {
        return "rounding".into();
    }
    match error.relative(summary).map(|part| two_digits(100.0 * part)) {
        Some(rounded) if rounded < 0.01 => "<0.01 %".into(),
        Some(rounded) => format!("±{} %", shortest((100.0 * rounded).round() / 100.0)),
        None => {
            let absolute = two_digits(from_si(error.of_largest(summary), factor));
            if absolute.is_nan() { String::new() } else { format!("±{}", shortest(absolute)) }
        }
    }
}

/// Returns true if positions differ in time alone, as in a dynamic analysis.
fn passes_no_cycle(result: &AnalysisResult) -> bool {
    result.rows.iter().all(|row| row.position.cycle == 0.0 && row.position.roll == 0.0)
}

/// Formats five significant digits, or a word for an output that the fidelity level does not
/// support.
pub(crate) fn number(value: f64) -> String {
    if value.is_nan() {
        return "none".into();
    }
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    shortest(rounded)
}

/// Formats roll angle and name of the position, and body and tooth of the location. Radius and roll
/// angle of the location are in `run.json` only: the table must fit a terminal.
fn place(result: &AnalysisResult, step: usize, place: Option<&Location>) -> String {
    let Some(row) = result.rows.get(step) else { return String::new() };
    let mut text = match passes_no_cycle(result) {
        true => format!("{} s", number(row.position.time)),
        false => format!("{:.2} deg", row.position.roll.to_degrees()),
    };
    if !row.position.name.is_empty() {
        text += &format!(" {}", row.position.name);
    }
    if let Some(place) = place {
        text += &format!(", {} tooth {}", place.body, place.tooth);
    }
    text
}

pub(crate) fn align(rows: &[Vec<String>]) -> String {
    let last = rows.first().map_or(0, |row| row.len() - 1);
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..=last).map(width).collect();
    let mut text = String::new();
    for row in rows {
        for (column, cell) in row.iter().enumerate() {
            let fill = " ".repeat(widths[column] - cell.chars().count());
            // Text is aligned left, numbers right.
            match column {
                _ if column == last => text += cell,
                2.. => text += &format!("{fill}{cell}  "),
                _ => text += &format!("{cell}{fill}  "),
            }
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{of_choices, variation, without_rounding};

    #[test]
    fn choices_have_names_in_place_of_statistics() {
        let counts = |all: &[(&str, usize)]| -> Vec<(String, usize)> {
            all.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect()
        };
        let one = of_choices("kind", &counts(&[("planet", 3)]));
        assert_eq!(one, ["kind", "", "", "planet", "", "", ""]);
        let several = of_choices("kind", &counts(&[("planet", 3), ("mixed", 1)]));
        assert_eq!(several, ["kind", "", "", "planet", "", "", "planet at 3 positions, mixed at 1"]);
    }

    #[test]
    fn rounding_noise_of_a_constant_is_no_variation() {
        assert_eq!(variation([1.0, 1.0 + 4e-16], 4e-16), 0.0);
        assert_eq!(variation([-2.0, -2.0 + 1e-15], 1e-15), 0.0);
        assert_eq!(variation([1.0, 1.0 + 1e-9], 1e-9), 1e-9);
        assert_eq!(variation([-1e-20, 1e-20], 2e-20), 2e-20);
        assert!(variation([f64::NAN; 2], f64::NAN).is_nan());
    }
    #[test]
    fn residues_of_sums_are_zero() {
        assert_eq!(without_rounding(1.9e-16, 2.2e-6, 2.2e-13), 0.0);
        assert_eq!(without_rounding(-1.5e-14, 1.5e-14, 1e-13), 0.0);
        assert_eq!(without_rounding(1.5e-14, 1.5e-14, 0.0), 1.5e-14);
        assert_eq!(without_rounding(1e-13, 1.0, 0.0), 0.0);
        assert!(without_rounding(f64::NAN, f64::NAN, 0.0).is_nan());
        assert_eq!(without_rounding(f64::INFINITY, f64::INFINITY, 0.0), f64::INFINITY);
        assert_eq!(without_rounding(1.0, f64::INFINITY, 0.0), 1.0);
    }
}
