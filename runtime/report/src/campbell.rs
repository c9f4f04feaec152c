//! Campbell diagram at the first position, if the model requests it.

use calyx_runtime::observables::CampbellDiagram;
use std::f64::consts::TAU;
use std::io;
use std::path::Path;

/// File name in a run directory.
pub const NAME: &str = "campbell.csv";

/// Writes the diagram with one row per speed and mode: speed in rpm, frequency in Hz.
pub fn write(directory: &Path, diagram: &CampbellDiagram) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(directory.join(NAME))?;
    writer.write_record(["speed", "mode", "frequency", "whirl"])?;
    for point in &diagram.points {
        writer.write_record([
            (point.speed * 60.0 / TAU).to_string(),
            (point.mode + 1).to_string(),
            point.frequency.to_string(),
            point.sense.to_string(),
        ])?;
    }
    writer.flush()
}
