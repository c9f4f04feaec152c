//! Tables of the sound that elastic bodies radiate over the speed, its entry in `run.json`, and
//! pictures of the surface.

mod pictures;
mod tables;

pub use pictures::{
    PICTURES, SoundPicture, is_picture_of_a_run, picture_files, read_pictures, write_pictures,
};
pub use tables::{DIRECTIVITY, DirectivityRow, FIELDS, FieldRow, PANELS, PanelRow};

use calyx_runtime::acoustics::Fluid;
use calyx_runtime::acoustics::levels::{a_weighting, sound_power_level, sound_pressure_level};
use calyx_runtime::forced_response::{ForcedResponse, ResponseLine};
use calyx_runtime::radiated_sound::{RadiatedSound, SoundField, SoundPoint, Weighting};
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
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
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

/// Returns true if a line has sound at a speed, rad/s.
fn has_sound(sound: &RadiatedSound, line: usize, speed: f64) -> bool {
    let frequency = sound.frequency(line, speed);
    frequency > 0.0 && frequency <= sound.highest_frequency
}

/// Returns the names of all sounds: the body, with what distinguishes it if it has several.
fn names(sounds: &[RadiatedSound]) -> Vec<String> {
    let parts: [fn(&RadiatedSound) -> String; 3] = [
        |sound| sound.method.name().to_owned(),
        |sound| format!("in {}", fluid_name(sound)),
        |sound| plane_name(sound).map_or_else(|| "in free space".to_owned(), |name| format!("on the {name}")),
    ];
    let name = |sound: &RadiatedSound| {
        let own: Vec<&RadiatedSound> = sounds.iter().filter(|other| other.body == sound.body).collect();
        let differs =
            |part: &&fn(&RadiatedSound) -> String| own.iter().any(|other| part(other) != part(sound));
        let differing = parts.iter().filter(differs).map(|part| part(sound));
        std::iter::once(sound.body.clone()).chain(differing).collect::<Vec<String>>().join(", ")
    };
    let mut all: Vec<String> = sounds.iter().map(name).collect();
    // Planes may differ by less than the digits of their names.
    for index in 1..all.len() {
        if all[..index].contains(&all[index]) {
            all[index] += &format!(", {}", index + 1);
        }
    }
    all
}

fn fluid_name(sound: &RadiatedSound) -> String {
    let Fluid { density, speed_of_sound } = sound.fluid;
    let unnamed = || format!("a fluid of {density} kg/m³ and {speed_of_sound} m/s");
    sound.fluid.name().map_or_else(unnamed, str::to_owned)
}

/// Returns the name of the rigid plane of a sound; `None` in free space.
fn plane_name(sound: &RadiatedSound) -> Option<String> {
    let [point, normal] = sound.plane?;
    let numbers = |all: [f64; 3], scale: f64| -> String {
        let rounded = all.map(|value| ((value * scale * 1e3).round() / 1e3 + 0.0).to_string());
        rounded.join(", ")
    };
    Some(format!("plane through ({}) mm with normal ({})", numbers(point, 1e3), numbers(normal, 1.0)))
}

/// Returns the rows of a sound at a speed: the lines with sound.
fn rows<'a>(
    name: &'a str,
    sound: &'a RadiatedSound,
    lines: &'a [ResponseLine],
    at: &'a SoundPoint,
) -> impl Iterator<Item = SoundRow> + 'a {
    (0..lines.len()).filter(|&line| has_sound(sound, line, at.speed)).map(move |line| {
        let (power, frequency) = (at.powers[line], sound.frequency(line, at.speed));
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
    let all = all.into_iter().filter(|(_, wanted)| *wanted).map(|(name, _)| name);
    all.chain(tables::files(response)).collect()
}

/// Writes the tables: one row per speed, body and spectral line, and point.
pub fn write(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    let names = names(&response.sounds);
    let speeds = || {
        let all = response.sounds.iter().zip(&names);
        all.flat_map(|(sound, name)| sound.speeds.iter().map(move |at| (name, sound, at)))
    };
    for file in files(response) {
        let path = directory.join(file);
        match file {
            NAME => {
                let all = speeds().flat_map(|(name, sound, at)| rows(name, sound, &response.lines, at));
                tables::table(&path, all)?;
            }
            PRESSURES => {
                tables::table(&path, speeds().flat_map(|(name, sound, at)| pressures(name, sound, at)))?;
            }
            _ => {}
        }
    }
    tables::write(directory, response)
}

fn pressures<'a>(
    name: &'a str,
    sound: &'a RadiatedSound,
    at: &'a SoundPoint,
) -> impl Iterator<Item = PressureRow> + 'a {
    let frequency = |line: usize| sound.frequency(line, at.speed);
    let lines = (0..at.pressures.len()).filter(|&line| has_sound(sound, line, at.speed));
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

/// Tables and pictures of the sound in a run directory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SoundTables {
    /// Spectral lines of all bodies over the speed.
    pub lines: Vec<SoundRow>,
    /// Contributions of panels over the speed.
    pub panels: Vec<PanelRow>,
    /// Pressures on field meshes.
    pub fields: Vec<FieldRow>,
    /// Levels of the far field.
    pub directivity: Vec<DirectivityRow>,
    /// Pictures with their content in base 64.
    pub pictures: Vec<(SoundPicture, String)>,
}

/// Reads the sound of a run directory; empty if there is none.
pub fn read(directory: &Path) -> io::Result<SoundTables> {
    Ok(SoundTables {
        lines: tables::read(&directory.join(NAME))?,
        panels: tables::read(&directory.join(PANELS))?,
        fields: tables::read(&directory.join(FIELDS))?,
        directivity: tables::read(&directory.join(DIRECTIVITY))?,
        pictures: read_pictures(directory),
    })
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
        let panels: Vec<Value> = sound
            .panels
            .iter()
            .enumerate()
            .map(|(index, panel)| {
                let power = |weighting| sound.panel_power_of(own, index, weighting, |_| true);
                json!({
                    "name": panel.name,
                    "area": panel.area,
                    "power": power(Weighting::None),
                    "level": sound_power_level(power(Weighting::None)),
                    "a_weighted_level": sound_power_level(power(Weighting::A)),
                })
            })
            .collect();
        let lines: Vec<Value> = rows(name, sound, &response.lines, own)
            .map(|row| serde_json::to_value(row).unwrap_or_default())
            .collect();
        json!({
            "body": name,
            "method": sound.method.name(),
            "fluid": {
                "name": sound.fluid.name(),
                "density": sound.fluid.density,
                "speed_of_sound": sound.fluid.speed_of_sound,
            },
            "plane": sound.plane.map(|[point, normal]| json!({ "point": point, "normal": normal })),
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
            "level_error": sound.level_error(own, Weighting::None),
            "a_weighted_level_error": sound.level_error(own, Weighting::A),
            "fluid_mass_ratio": sound.fluid_mass_ratio(),
            "radiation_efficiency": sound.efficiency(own),
            "input_power": own.input.iter().sum::<f64>(),
            "dissipated_power": own.dissipated.iter().sum::<f64>(),
            "lines": lines,
            "points": points,
            "panels": panels,
            "fields": fields(sound),
        })
    };
    response.sounds.iter().zip(&names).map(entry).collect()
}

/// Describes the field meshes with their mean levels at the speed of the model.
fn fields(sound: &RadiatedSound) -> Vec<Value> {
    let field = |(index, field): (usize, &SoundField)| {
        json!({
            "name": field.name,
            "kind": field.kind,
            "grid": field.grid,
            "points": field.mesh.points.len(),
            "area": field.mesh.area(),
            "level": sound.field_level(index, Weighting::None),
            "a_weighted_level": sound.field_level(index, Weighting::A),
            "measured_power_level": sound.measured_power_level(index, Weighting::None),
            "a_weighted_measured_power_level": sound.measured_power_level(index, Weighting::A),
        })
    };
    sound.fields.iter().enumerate().map(field).collect()
}
