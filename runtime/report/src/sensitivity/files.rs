//! Sensitivities as tables with all digits.

use super::{Entry, SensitivityTable};
use crate::sweep::exact;
use calyx_abi::units::from_si;
use calyx_runtime::sensitivity::Kind;
use std::io;
use std::path::Path;

/// File name of the derivatives of statistics.
pub const SENSITIVITIES: &str = "sensitivities.csv";
/// File name of the derivatives by position.
pub const SENSITIVITIES_BY_POSITION: &str = "sensitivities_by_position.csv";

/// Writes a row per statistic of an output and param.
///
/// # Errors
/// The file cannot be written.
pub fn write_table(path: &Path, all: &SensitivityTable) -> io::Result<()> {
    let mut table = csv::Writer::from_path(path)?;
    table.write_record([
        "output",
        "statistic",
        "value",
        "unit",
        "param",
        "param_value",
        "param_unit",
        "derivative",
        "derivative_below",
        "derivative_above",
        "derivative_unit",
        "estimated_error",
        "effect_of_1_percent",
        "structures",
    ])?;
    for &output in &all.shown {
        for statistic in all.shown_statistics() {
            let value = all.value(output, statistic).map(exact).unwrap_or_default();
            let statistic_name = if all.is_single() { "" } else { statistic.name() };
            for entry in all.entries(output, statistic) {
                let Entry { param, sides, error, effect, .. } = entry;
                let column = &all.params[param];
                let known = |value: f64| if value.is_nan() { String::new() } else { exact(value) };
                table.write_record([
                    all.outputs[output].name.clone(),
                    statistic_name.to_owned(),
                    value.clone(),
                    all.outputs[output].unit.clone(),
                    column.name.clone(),
                    exact(all.param_value(param)),
                    column.unit.clone(),
                    known(entry.value()),
                    known(sides[0]),
                    known(sides[1]),
                    all.unit(output, param),
                    known(error),
                    known(effect),
                    structures(all, param).to_owned(),
                ])?;
            }
        }
    }
    table.flush()
}

/// States whether a param changes structures.
fn structures(all: &SensitivityTable, param: usize) -> &'static str {
    match all.sensitivities[param].kind {
        Kind::SameStructures => "same",
        Kind::ChangedStructures => "new",
    }
}

/// Writes a row per position, output and param.
///
/// # Errors
/// The file cannot be written.
pub fn write_positions(path: &Path, all: &SensitivityTable) -> io::Result<()> {
    let mut table = csv::Writer::from_path(path)?;
    table.write_record([
        "time",
        "cycle",
        "position",
        "output",
        "param",
        "derivative",
        "derivative_below",
        "derivative_above",
        "derivative_unit",
        "estimated_error",
    ])?;
    for (row, position) in all.positions.iter().enumerate() {
        for &output in &all.shown {
            for (param, own) in all.sensitivities.iter().enumerate() {
                let Some(derivative) = own.positions.get(row).and_then(|row| row.get(output)) else {
                    continue;
                };
                let in_units = |si: f64| {
                    if si.is_nan() {
                        return String::new();
                    }
                    exact(from_si(si, all.outputs[output].factor) * all.params[param].factor)
                };
                table.write_record([
                    exact(position.time),
                    exact(position.cycle),
                    position.name.to_string(),
                    all.outputs[output].name.clone(),
                    all.params[param].name.clone(),
                    in_units(derivative.value()),
                    in_units(derivative.sides[0]),
                    in_units(derivative.sides[1]),
                    all.unit(output, param),
                    in_units(derivative.error),
                ])?;
            }
        }
    }
    table.flush()
}
