//! Tables of the contributions of panels over the speed, and of pressures on field meshes and
//! directivities at the speed of the model.

use super::{SoundRow, finite, has_sound, names, rows};
use calyx_runtime::acoustics::levels::{a_weighting, sound_power_level, sound_pressure_level};
use calyx_runtime::forced_response::{ForcedResponse, ResponseLine};
use calyx_runtime::radiated_sound::{PanelSummary, RadiatedSound};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::io;
use std::path::Path;

/// File name of the contributions of panels in a run directory.
pub const PANELS: &str = "panel_power.csv";
/// File name of the sound pressures on field meshes in a run directory.
pub const FIELDS: &str = "sound_field.csv";
/// File name of the directivities in a run directory.
pub const DIRECTIVITY: &str = "directivity.csv";

/// Contribution of a panel to a spectral line of the sound at a speed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PanelRow {
    /// Speed of the first gear of the mesh of the forced response, rpm.
    pub speed: f64,
    /// Body, with what distinguishes it if it has several sounds.
    pub body: String,
    /// Panel; "rest" for the surface that belongs to none.
    pub panel: String,
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
    /// Contribution to the sound power, W; negative if the panel absorbs sound.
    pub power: f64,
    /// Level of the contribution, dB; unknown if it is not positive.
    pub level: Option<f64>,
    /// A-weighted level of the contribution, dB.
    pub a_weighted_level: Option<f64>,
}

/// Sound pressure of a spectral line at a point of a field mesh.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FieldRow {
    /// Body.
    pub body: String,
    /// Field mesh.
    pub field: String,
    /// Number of the point, from 1.
    pub point: usize,
    /// Point in ground coordinates, m.
    pub x: f64,
    pub y: f64,
    pub z: f64,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Amplitude, Pa.
    pub pressure: f64,
    /// Phase, degrees.
    pub phase: f64,
    /// Sound pressure level, dB.
    pub level: Option<f64>,
}

/// Level of a spectral line in a direction of the far field.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DirectivityRow {
    /// Body.
    pub body: String,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Coordinate plane of ground: the axis of the angle zero, and that of 90 degrees.
    pub plane: String,
    /// Angle, degrees.
    pub angle: f64,
    /// Sound pressure level at a distance of 1 m that the far field has there, dB.
    pub level: Option<f64>,
}

/// Returns the names of the files of a response.
pub fn files(response: &ForcedResponse) -> Vec<&'static str> {
    let any = |has: fn(&RadiatedSound) -> bool| response.sounds.iter().any(has);
    let all = [
        (PANELS, any(|sound| !sound.panels.is_empty())),
        (FIELDS, any(|sound| !sound.fields.is_empty())),
        (DIRECTIVITY, any(|sound| sound.far_field.iter().any(|line| !line.is_empty()))),
    ];
    all.into_iter().filter(|(_, wanted)| *wanted).map(|(name, _)| name).collect()
}

/// Writes the tables.
pub fn write(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    let names = names(&response.sounds);
    let sounds = || response.sounds.iter().zip(&names);
    for file in files(response) {
        let path = directory.join(file);
        match file {
            PANELS => table(&path, sounds().flat_map(|sound| panels(sound, &response.lines)))?,
            FIELDS => table(&path, sounds().flat_map(fields))?,
            _ => table(&path, sounds().flat_map(directivity))?,
        }
    }
    Ok(())
}

/// Writes a table. One without rows has its head.
pub(super) fn table<T: Serialize + Default>(path: &Path, rows: impl Iterator<Item = T>) -> io::Result<()> {
    let mut rows = rows.peekable();
    if rows.peek().is_none() {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.serialize(T::default())?;
        let content = writer.into_inner().map_err(|error| io::Error::other(error.to_string()))?;
        let end = content.iter().position(|byte| *byte == b'\n').map_or(content.len(), |at| at + 1);
        return std::fs::write(path, &content[..end]);
    }
    let mut writer = csv::Writer::from_path(path)?;
    rows.try_for_each(|row| writer.serialize(row))?;
    writer.flush()
}

/// Reads a table; empty if there is none.
pub(super) fn read<T: DeserializeOwned>(path: &Path) -> io::Result<Vec<T>> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let mut reader = csv::Reader::from_path(path)?;
    reader.deserialize().map(|row| row.map_err(io::Error::other)).collect()
}

fn panels<'a>(
    (sound, name): (&'a RadiatedSound, &'a String),
    lines: &'a [ResponseLine],
) -> impl Iterator<Item = PanelRow> + 'a {
    sound.speeds.iter().flat_map(move |at| {
        // Rows are those of the lines with sound.
        let own = (0..lines.len()).filter(move |&line| has_sound(sound, line, at.speed));
        rows(name, sound, lines, at).zip(own).flat_map(move |(row, line)| {
            let SoundRow { speed, body, mesh, harmonic, modulation, sideband, frequency, .. } = row;
            let of_panel = move |(panel, power): (&PanelSummary, &f64)| PanelRow {
                speed,
                body: body.clone(),
                panel: panel.name.clone(),
                mesh: mesh.clone(),
                harmonic,
                modulation: modulation.clone(),
                sideband,
                frequency,
                power: *power,
                level: finite(sound_power_level(*power)),
                a_weighted_level: finite(sound_power_level(*power) + a_weighting(frequency)),
            };
            sound.panels.iter().zip(&at.panels[line]).map(of_panel)
        })
    })
}

fn fields<'a>((sound, name): (&'a RadiatedSound, &'a String)) -> impl Iterator<Item = FieldRow> + 'a {
    let speed = sound.own.speed;
    sound.fields.iter().flat_map(move |field| {
        let lines = (0..field.pressures.len()).filter(move |&line| has_sound(sound, line, speed));
        lines.flat_map(move |line| {
            let points = field.mesh.points.iter().zip(&field.pressures[line]).enumerate();
            points.map(move |(index, (&[x, y, z], pressure))| FieldRow {
                body: name.clone(),
                field: field.name.clone(),
                point: index + 1,
                x,
                y,
                z,
                frequency: sound.frequency(line, speed),
                pressure: pressure.norm(),
                phase: pressure.arg().to_degrees(),
                level: finite(sound_pressure_level(pressure.norm())),
            })
        })
    })
}

fn directivity<'a>(
    (sound, name): (&'a RadiatedSound, &'a String),
) -> impl Iterator<Item = DirectivityRow> + 'a {
    let lines = sound.far_field.iter().enumerate();
    lines.flat_map(move |(line, amplitudes)| {
        sound.directions.iter().zip(amplitudes).map(move |(at, amplitude)| DirectivityRow {
            body: name.clone(),
            frequency: sound.frequency(line, sound.own.speed),
            plane: at.plane.name().to_owned(),
            angle: (at.angle.to_degrees() * 1e9).round() / 1e9,
            level: finite(sound_pressure_level(amplitude.norm())),
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_without_rows_has_its_head() {
        let directory = tempfile::tempdir().expect("a folder");
        let path = directory.path().join(DIRECTIVITY);
        table(&path, std::iter::empty::<DirectivityRow>()).expect("written");
        let content = std::fs::read_to_string(&path).expect("readable");
        assert_eq!(content, "body,frequency,plane,angle,level\n");
        assert_eq!(read::<DirectivityRow>(&path).expect("readable"), []);
        let row = DirectivityRow { body: "a, b".into(), level: Some(60.0), ..DirectivityRow::default() };
        table(&path, [row.clone()].into_iter()).expect("written");
        assert_eq!(read::<DirectivityRow>(&path).expect("readable"), [row]);
    }
}
