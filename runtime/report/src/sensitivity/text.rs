//! Sensitivities as text.

use super::SensitivityTable;
use crate::sample::Statistic;
use crate::summary_table::{align, number};

/// Formats a table of derivatives for each statistic: of a model with several positions the largest
/// value and the peak-to-peak value, because the files have all.
pub fn text(all: &SensitivityTable) -> String {
    let mut text = String::new();
    let statistics: &[Statistic] =
        if all.is_single() { &[Statistic::Max] } else { &[Statistic::Max, Statistic::PeakToPeak] };
    for &output in &all.shown {
        for &statistic in statistics {
            let Some(value) = all.value(output, statistic) else {
                text += &format!("{} has no value\n\n", all.name(output, statistic));
                continue;
            };
            let unit = &all.outputs[output].unit;
            let unit = if unit == "1" { "" } else { unit };
            text += format!("{} = {} {unit}", all.name(output, statistic), number(value)).trim_end();
            text.push('\n');
            text += &table(all, output, statistic);
            text.push('\n');
        }
    }
    for own in &all.sensitivities {
        if let Some(failure) = &own.failure {
            text += &format!("no derivative with respect to `{}`: {}\n", own.param.name, failure.message);
        }
    }
    text
}

fn table(all: &SensitivityTable, output: usize, statistic: Statistic) -> String {
    let unit = &all.outputs[output].unit;
    let effect =
        if unit.is_empty() || unit == "1" { "per +1 %".to_owned() } else { format!("per +1 % [{unit}]") };
    let head = ["  param", "unit", "value", "derivative", "", &effect, "in %", ""];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for row in all.rows_of(output, statistic) {
        rows.push(vec![
            format!("  {}", row.param),
            if row.param_unit == "1" { String::new() } else { row.param_unit.clone() },
            number(row.param_value),
            row.shown_derivative(),
            row.derivative_unit.clone(),
            row.shown_effect(),
            row.shown_relative(),
            row.remarks().join(", "),
        ]);
    }
    align(&rows)
}
