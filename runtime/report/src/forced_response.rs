//! Tables of the forced response over the speed, if the model requests it.

use calyx_runtime::forced_response::ForcedResponse;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::io;
use std::path::Path;

/// File name of the response in a run directory.
pub const NAME: &str = "forced_response.csv";
/// File name of the natural frequencies in a run directory.
pub const MODES: &str = "forced_response_modes.csv";

/// Spectral line of a quantity at a speed: a row of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResponseRow {
    /// Speed of the first gear of the requested mesh, rpm.
    pub speed: f64,
    /// Quantity.
    pub quantity: String,
    /// Its unit, of the SI.
    pub unit: String,
    /// Gears of the first mesh with this frequency; empty for harmonic 0.
    pub mesh: String,
    /// Harmonic of the mesh frequency; 0 is the mean value and its sidebands.
    pub harmonic: usize,
    /// Carrier or other mesh that modulates the harmonic; empty for sideband 0.
    pub modulation: String,
    /// Multiple of the carrier's rotational frequency or of the other mesh frequency that is added.
    pub sideband: i64,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Amplitude; the mean value has its sign.
    pub amplitude: f64,
    /// Estimated error of the amplitude.
    pub error: f64,
    /// Phase, degrees: the quantity has its maximum at this angle before the start of the cycle.
    pub phase: f64,
    /// Factor by which a disturbance grows within a mesh cycle; above 1 the vibration is unstable.
    /// Unknown if carriers rotate.
    pub growth: Option<f64>,
}

/// Writes the response with one row per speed, quantity and spectral line, and the natural
/// frequencies.
pub fn write(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    let mut modes = csv::Writer::from_path(directory.join(MODES))?;
    modes.write_record(["mode", "frequency"])?;
    for (index, frequency) in response.natural_frequencies.iter().enumerate() {
        modes.write_record([(index + 1).to_string(), frequency.to_string()])?;
    }
    modes.flush()?;
    let mut writer = csv::Writer::from_path(directory.join(NAME))?;
    for point in &response.points {
        // Rounded, so that a speed can be found by its number.
        let speed = (point.speed * 60.0 / TAU * 1e9).round() / 1e9;
        let values = point.amplitudes.iter().zip(&point.errors);
        for (quantity, (amplitudes, errors)) in response.quantities.iter().zip(values) {
            for (line, (amplitude, &error)) in response.lines.iter().zip(amplitudes.iter().zip(errors)) {
                let mean = line.order == 0.0;
                writer.serialize(ResponseRow {
                    speed,
                    quantity: quantity.name.clone(),
                    unit: quantity.unit.to_owned(),
                    mesh: line.mesh.clone(),
                    harmonic: line.harmonic,
                    modulation: line.modulation.clone(),
                    sideband: line.sideband,
                    frequency: line.order * point.speed / TAU,
                    amplitude: if mean { amplitude.re } else { amplitude.norm() },
                    error,
                    phase: if mean { 0.0 } else { amplitude.arg().to_degrees() },
                    growth: Some(point.growth).filter(|growth| !growth.is_nan()),
                })?;
            }
        }
    }
    writer.flush()
}

/// Reads the natural frequencies of a run directory, Hz; empty if there are none.
pub fn read_modes(directory: &Path) -> io::Result<Vec<f64>> {
    let path = directory.join(MODES);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut reader = csv::Reader::from_path(path)?;
    let rows = reader.deserialize::<(usize, f64)>();
    rows.map(|row| row.map(|(_, frequency)| frequency).map_err(io::Error::other)).collect()
}

/// Reads the response of a run directory; empty if there is none.
pub fn read(directory: &Path) -> io::Result<Vec<ResponseRow>> {
    let path = directory.join(NAME);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut reader = csv::Reader::from_path(path)?;
    reader.deserialize().map(|row| row.map_err(io::Error::other)).collect()
}
