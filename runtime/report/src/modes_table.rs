//! Table of the modes at the first position, if the model requests it.

use calyx_runtime::observables::{ModeKind, ModesTable};
use std::io;
use std::path::Path;

/// File name in a run directory.
pub const NAME: &str = "modes.csv";
/// Number of modes in the summary.
const SHOWN: usize = 12;

/// Writes the table with one row per mode; frequencies in Hz.
pub fn write(directory: &Path, table: &ModesTable) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(directory.join(NAME))?;
    let columns = ["mode", "frequency", "kind", "translation", "rotation", "elastic"];
    writer.write_record(columns.into_iter().chain(table.bodies.iter().map(String::as_str)))?;
    for (index, mode) in table.modes.iter().enumerate() {
        let parts = [mode.translation, mode.rotation, mode.elastic];
        let kind = mode.kind.map_or("", ModeKind::name).to_owned();
        let mut record = vec![(index + 1).to_string(), mode.frequency.to_string(), kind];
        record.extend(parts.iter().chain(&mode.bodies).map(f64::to_string));
        writer.write_record(record)?;
    }
    writer.flush()
}

/// Formats the lowest modes in one line.
pub fn summary(table: &ModesTable) -> String {
    let mode = |mode: &calyx_runtime::observables::ModeRow| {
        let kind = mode.kind.map(|kind| format!(" {}", kind.name())).unwrap_or_default();
        format!("{:.1}{kind}", mode.frequency)
    };
    let shown: Vec<String> = table.modes.iter().take(SHOWN).map(mode).collect();
    format!("modes [Hz]: {}\n", shown.join(", "))
}
