//! Table of the forced response over the speed, if the model requests it.

use calyx_runtime::forced_response::ForcedResponse;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::io;
use std::path::Path;

/// File name in a run directory.
pub const NAME: &str = "forced_response.csv";

/// Harmonic of a quantity at a speed: a row of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResponseRow {
    /// Speed of the first gear of the mesh, rpm.
    pub speed: f64,
    /// Quantity.
    pub quantity: String,
    /// Its unit, of the SI.
    pub unit: String,
    /// Harmonic of the mesh frequency; 0 is the mean value.
    pub harmonic: usize,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Amplitude; the mean value has its sign.
    pub amplitude: f64,
    /// Estimated error of the amplitude.
    pub error: f64,
    /// Phase, degrees: the quantity has its maximum at this angle before the start of the cycle.
    pub phase: f64,
    /// Factor by which a disturbance grows within a mesh cycle; above 1 the vibration is unstable.
    pub growth: f64,
}

/// Writes the response with one row per speed, quantity and harmonic.
pub fn write(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(directory.join(NAME))?;
    for point in &response.points {
        // Rounded, so that a speed can be found by its number.
        let speed = (point.speed * 60.0 / TAU * 1e9).round() / 1e9;
        let values = point.amplitudes.iter().zip(&point.errors);
        for (quantity, (amplitudes, errors)) in response.quantities.iter().zip(values) {
            for (harmonic, (amplitude, &error)) in amplitudes.iter().zip(errors).enumerate() {
                let mean = harmonic == 0;
                writer.serialize(ResponseRow {
                    speed,
                    quantity: quantity.name.clone(),
                    unit: quantity.unit.to_owned(),
                    harmonic,
                    frequency: harmonic as f64 * response.order * point.speed / TAU,
                    amplitude: if mean { amplitude.re } else { amplitude.norm() },
                    error,
                    phase: if mean { 0.0 } else { amplitude.arg().to_degrees() },
                    growth: point.growth,
                })?;
            }
        }
    }
    writer.flush()
}

/// Reads the table of a run directory; empty if there is none.
pub fn read(directory: &Path) -> io::Result<Vec<ResponseRow>> {
    let path = directory.join(NAME);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut reader = csv::Reader::from_path(path)?;
    reader.deserialize().map(|row| row.map_err(io::Error::other)).collect()
}
