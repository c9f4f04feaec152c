//! The summary people read after a run.

use crate::params::shortest;
use calyx_abi::description::ModelDescription;
use calyx_abi::units::from_si;
use calyx_runtime::results::{AnalysisResult, Place};

/// One line per output, in the model's units, with the position of its maximum.
pub fn summary(description: &ModelDescription, result: &AnalysisResult) -> String {
    let at = if passes_no_cycle(result) { "maximum at time" } else { "maximum at roll" };
    let mut rows = vec![["output", "unit", "min", "mean", "max", "peak to peak", at].map(String::from)];
    for (output, summary) in description.outputs.iter().zip(&result.summaries) {
        let shown = |si: f64| number(from_si(si, output.unit.factor));
        rows.push([
            output.name.clone(),
            output.unit.name.clone(),
            shown(summary.min),
            shown(summary.mean),
            shown(summary.max),
            shown(summary.peak_to_peak),
            if summary.max.is_nan() {
                String::new()
            } else {
                place(result, summary.at_max, summary.place.as_ref())
            },
        ]);
    }
    align(&rows)
}

/// Whether positions are places in time alone, as those of a dynamic analysis.
fn passes_no_cycle(result: &AnalysisResult) -> bool {
    result.rows.iter().all(|row| row.position.cycle == 0.0 && row.position.roll == 0.0)
}

/// Five significant digits; a word of an output that the fidelity has no value of.
fn number(value: f64) -> String {
    if value.is_nan() {
        return "none".into();
    }
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    shortest(rounded)
}

/// Roll angle of the position, its name if it has one, and body and tooth of the place. Radius and roll angle of the
/// place itself stand in `run.json`: the table is to fit a terminal.
fn place(result: &AnalysisResult, step: usize, place: Option<&Place>) -> String {
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

fn align(rows: &[[String; 7]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..7).map(width).collect();
    let mut text = String::new();
    for row in rows {
        for (column, cell) in row.iter().enumerate() {
            let fill = " ".repeat(widths[column] - cell.chars().count());
            // Words to the left, numbers to the right.
            match column {
                6 => text += cell,
                2..=5 => text += &format!("{fill}{cell}  "),
                _ => text += &format!("{cell}{fill}  "),
            }
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}
