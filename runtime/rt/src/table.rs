//! The summary people read after a run.

use crate::params::shortest;
use calyx_abi::description::ModelDescription;
use calyx_runtime::results::AnalysisResult;

/// One line per output, in the model's units, with the position of its maximum.
pub fn summary(description: &ModelDescription, result: &AnalysisResult) -> String {
    let mut rows =
        vec![["output", "unit", "min", "mean", "max", "peak to peak", "maximum at"].map(String::from)];
    for (output, summary) in description.outputs.iter().zip(&result.summaries) {
        let shown = |si: f64| number(si / output.unit.factor);
        rows.push([
            output.name.clone(),
            output.unit.name.clone(),
            shown(summary.min),
            shown(summary.mean),
            shown(summary.max),
            shown(summary.peak_to_peak),
            place(result, summary.at_max, summary.place.as_ref()),
        ]);
    }
    align(&rows)
}

/// Five significant digits.
fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    shortest(rounded)
}

fn place(result: &AnalysisResult, step: usize, place: Option<&calyx_runtime::results::Place>) -> String {
    let Some(row) = result.rows.get(step) else { return String::new() };
    let roll = row.position.roll.to_degrees();
    let mut text = format!("roll {roll:.2} deg");
    if !row.position.name.is_empty() {
        text += &format!(" ({})", row.position.name);
    }
    if let Some(place) = place {
        text += &format!(", {} tooth {}, ", place.body, place.tooth);
        if let Some(angle) = place.roll_angle {
            text += &format!("roll {:.2} deg there, ", angle.to_degrees());
        }
        text += &format!("radius {} mm", number(place.radius * 1e3));
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
