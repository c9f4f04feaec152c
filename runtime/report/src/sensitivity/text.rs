//! Sensitivities as text.

use super::{Entry, SensitivityTable};
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
            text += &table(all, output, statistic, value);
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

fn table(all: &SensitivityTable, output: usize, statistic: Statistic, value: f64) -> String {
    let unit = &all.outputs[output].unit;
    let effect = if unit == "1" { "per +1 %".to_owned() } else { format!("per +1 % [{unit}]") };
    let head = ["  param", "unit", "value", "derivative", "", &effect, "in %", ""];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for entry in all.entries(output, statistic) {
        let column = &all.params[entry.param];
        rows.push(vec![
            format!("  {}", column.name),
            if column.unit == "1" { String::new() } else { column.unit.clone() },
            number(all.param_value(entry.param)),
            derivative(&entry),
            all.unit(output, entry.param),
            if entry.is_zero() { "0".to_owned() } else { number(entry.effect) },
            if entry.is_zero() { String::new() } else { relative(&entry, value) },
            all.remarks(&entry).join(", "),
        ]);
    }
    align(&rows)
}

/// Formats a derivative, at a kink those of both sides.
pub(crate) fn derivative(entry: &Entry) -> String {
    match entry.sides {
        _ if entry.is_zero() => "0".to_owned(),
        [below, above] if entry.is_kink => format!("{} below, {} above", number(below), number(above)),
        [value, _] => number(value),
    }
}

/// Formats the effect of a change relative to the value.
pub(crate) fn relative(entry: &Entry, value: f64) -> String {
    let part = 100.0 * entry.effect / value.abs();
    if part.is_finite() { format!("{part:+.3}") } else { String::new() }
}
