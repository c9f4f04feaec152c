//! Sensitivities as tables with all digits.

use super::{DerivativeRow, SensitivityTable};
use crate::sweep::exact;
use calyx_abi::units::from_si;
use std::io;
use std::path::Path;

/// File name of the derivatives of statistics.
pub const SENSITIVITIES: &str = "sensitivities.csv";
/// File name of the derivatives by position.
pub const SENSITIVITIES_BY_POSITION: &str = "sensitivities_by_position.csv";

/// Columns of the table: the fields of [`DerivativeRow`].
const COLUMNS: [&str; 14] = [
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
];

/// Writes a row per statistic of an output and param.
///
/// # Errors
/// The file cannot be written.
pub fn write_table(path: &Path, all: &SensitivityTable) -> io::Result<()> {
    // A table without rows has its head, too.
    let mut table = csv::WriterBuilder::new().has_headers(false).from_path(path)?;
    table.write_record(COLUMNS)?;
    for row in all.rows() {
        table.serialize(row)?;
    }
    table.flush()
}

/// Reads the rows of a table; none if the file does not exist.
///
/// # Errors
/// The file cannot be read.
pub fn read_table(directory: &Path) -> io::Result<Vec<DerivativeRow>> {
    let path = directory.join(SENSITIVITIES);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let rows = csv::Reader::from_path(path)?.deserialize().collect::<Result<Vec<DerivativeRow>, _>>();
    Ok(rows?)
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
