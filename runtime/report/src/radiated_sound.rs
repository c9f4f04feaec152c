//! Tables of the sound that elastic bodies radiate over the speed, and its entry in `run.json`.

use calyx_runtime::acoustics::levels::{a_weighting, sound_power_level, sound_pressure_level};
use calyx_runtime::forced_response::{ForcedResponse, ResponseLine};
use calyx_runtime::radiated_sound::{RadiatedSound, SoundPoint, Weighting};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::io;
use std::path::Path;

/// File name of the sound powers in a run directory.
pub const NAME: &str = "radiated_sound.csv";
/// File name of the sound pressures at points in a run directory.
pub const PRESSURES: &str = "sound_pressure.csv";
/// Key of the sound in `run.json`.
pub const KEY: &str = "radiated_sound";

/// Spectral line of the sound of a body at a speed: a row of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SoundRow {
    /// Speed of the first gear of the mesh of the forced response, rpm.
    pub speed: f64,
    /// Body, with what distinguishes it if it has several sounds.
    pub body: String,
    /// Gears of the first mesh with this frequency.
    pub mesh: String,
    /// Harmonic of the mesh frequency.
    pub harmonic: usize,
    /// Carrier or other mesh that modulates the harmonic; empty for sideband 0.
    pub modulation: String,
    /// Multiple of the carrier's rotational frequency or of the other mesh frequency that is added.
    pub sideband: i64,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Sound power, W.
    pub power: f64,
    /// Estimated error of the power by the number of positions of the forced response, W.
    pub error: f64,
    /// Sound power level, dB; unknown without power.
    pub level: Option<f64>,
    /// A-weighted sound power level, dB.
    pub a_weighted_level: Option<f64>,
    /// Equivalent radiated power, W.
    pub equivalent_power: f64,
    /// Power that enters the body at its bearings, W; unknown if forces act that are not linear.
    pub input_power: Option<f64>,
    /// Power that the damping ratio dissipates in the body, W.
    pub dissipated_power: f64,
}

/// Sound pressure of a spectral line at a point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct PressureRow {
    speed: f64,
    body: String,
    /// Point in ground coordinates, m.
    x: f64,
    y: f64,
    z: f64,
    frequency: f64,
    /// Amplitude, Pa.
    pressure: f64,
    /// Phase, degrees.
    phase: f64,
    /// Sound pressure level, dB.
    level: Option<f64>,
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Rounded, so that a speed can be found by its number.
fn rpm(speed: f64) -> f64 {
    (speed * 60.0 / TAU * 1e9).round() / 1e9
}

/// Returns the names of all sounds: the body, with method and number if it has several.
fn names(sounds: &[RadiatedSound]) -> Vec<String> {
    let name = |(index, sound): (usize, &RadiatedSound)| match sounds
        .iter()
        .filter(|other| other.body == sound.body)
        .count()
    {
        1 => sound.body.clone(),
        _ => format!("{}, {}, {}", sound.body, sound.level.name(), index + 1),
    };
    sounds.iter().enumerate().map(name).collect()
}

/// Returns the rows of a sound at a speed: the lines with sound.
fn rows<'a>(
    name: &'a str,
    sound: &'a RadiatedSound,
    lines: &'a [ResponseLine],
    at: &'a SoundPoint,
) -> impl Iterator<Item = SoundRow> + 'a {
    let frequency = |line: usize| sound.frequency(line, at.speed);
    let has_sound = move |line: &usize| frequency(*line) > 0.0 && frequency(*line) <= sound.highest_frequency;
    (0..lines.len()).filter(has_sound).map(move |line| {
        let (power, frequency) = (at.powers[line], frequency(line));
        let own = &lines[line];
        SoundRow {
            speed: rpm(at.speed),
            body: name.to_owned(),
            mesh: own.mesh.clone(),
            harmonic: own.harmonic,
            modulation: own.modulation.clone(),
            sideband: own.sideband,
            frequency,
            power,
            error: at.errors[line],
            level: finite(sound_power_level(power)),
            a_weighted_level: finite(sound_power_level(power) + a_weighting(frequency)),
            equivalent_power: at.equivalent_powers[line],
            input_power: finite(at.input[line]),
            dissipated_power: at.dissipated[line],
        }
    })
}

/// Returns the names of the files of a response; none without sound.
pub fn files(response: &ForcedResponse) -> Vec<&'static str> {
    let with_points = response.sounds.iter().any(|sound| !sound.points.is_empty());
    let all = [(NAME, !response.sounds.is_empty()), (PRESSURES, with_points)];
    all.into_iter().filter(|(_, wanted)| *wanted).map(|(name, _)| name).collect()
}

/// Writes the tables: one row per speed, body and spectral line, and point.
pub fn write(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    let names = names(&response.sounds);
    for file in files(response) {
        let mut writer = csv::Writer::from_path(directory.join(file))?;
        for (sound, name) in response.sounds.iter().zip(&names) {
            for at in &sound.speeds {
                if file == NAME {
                    rows(name, sound, &response.lines, at).try_for_each(|row| writer.serialize(row))?;
                } else {
                    pressures(name, sound, at).try_for_each(|row| writer.serialize(row))?;
                }
            }
        }
        writer.flush()?;
    }
    Ok(())
}

fn pressures<'a>(
    name: &'a str,
    sound: &'a RadiatedSound,
    at: &'a SoundPoint,
) -> impl Iterator<Item = PressureRow> + 'a {
    let frequency = |line: usize| sound.frequency(line, at.speed);
    let has_sound = move |line: &usize| frequency(*line) > 0.0 && frequency(*line) <= sound.highest_frequency;
    let lines = (0..at.pressures.len()).filter(has_sound);
    lines.flat_map(move |line| {
        at.pressures[line].iter().zip(&sound.points).map(move |(pressure, &[x, y, z])| PressureRow {
            speed: rpm(at.speed),
            body: name.to_owned(),
            x,
            y,
            z,
            frequency: frequency(line),
            pressure: pressure.norm(),
            phase: pressure.arg().to_degrees(),
            level: finite(sound_pressure_level(pressure.norm())),
        })
    })
}

/// Reads the sound powers of a run directory; empty if there are none.
pub fn read(directory: &Path) -> io::Result<Vec<SoundRow>> {
    let path = directory.join(NAME);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut reader = csv::Reader::from_path(path)?;
    reader.deserialize().map(|row| row.map_err(io::Error::other)).collect()
}

/// Returns the sound at the speed of the model, its surface and its errors for `run.json`.
pub fn json(response: &ForcedResponse) -> Value {
    let names = names(&response.sounds);
    let entry = |(sound, name): (&RadiatedSound, &String)| {
        let own = &sound.own;
        let closed: Vec<Value> =
            sound.surface.closed.iter().map(|(name, lids)| json!({ "name": name, "lids": lids })).collect();
        let points: Vec<Value> = sound
            .points
            .iter()
            .enumerate()
            .map(|(index, at)| {
                json!({
                    "at": at,
                    "level": sound.pressure_level(own, index, Weighting::None),
                    "a_weighted_level": sound.pressure_level(own, index, Weighting::A),
                })
            })
            .collect();
        let lines: Vec<Value> = rows(name, sound, &response.lines, own)
            .map(|row| serde_json::to_value(row).unwrap_or_default())
            .collect();
        json!({
            "body": name,
            "method": sound.level.name(),
            "fluid": { "density": sound.fluid.density, "speed_of_sound": sound.fluid.speed_of_sound },
            "surface": {
                "triangles": sound.surface.triangles,
                "triangles_before_coarsening": sound.surface.fine_triangles,
                "area": sound.surface.area,
                "longest_edge": sound.surface.longest_edge,
                "closed_openings": closed,
                "elements_left_out": sound.surface.left_out,
            },
            "highest_frequency": sound.highest_frequency,
            "elements_per_wavelength": sound.elements_per_wavelength(),
            "solved_frequencies": sound.solved_frequencies.len(),
            "interpolation_error": sound.interpolation_error,
            "far_field_difference": sound.far_field_difference,
            "speed": rpm(own.speed),
            "power": own.powers.iter().sum::<f64>(),
            "level": sound.level(own, Weighting::None),
            "a_weighted_level": sound.level(own, Weighting::A),
            "radiation_efficiency": sound.efficiency(own),
            "input_power": own.input.iter().sum::<f64>(),
            "dissipated_power": own.dissipated.iter().sum::<f64>(),
            "lines": lines,
            "points": points,
        })
    };
    response.sounds.iter().zip(&names).map(entry).collect()
}
