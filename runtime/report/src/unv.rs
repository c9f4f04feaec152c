//! Universal files of the vibration of radiating surfaces at the speed of the model, for other
//! acoustic programs.
//!
//! Velocities are written as dataset 55: programs of modal testing and of acoustics have read it
//! for longer than dataset 2414, and it has a record for the frequency of a response. The Python
//! package pyuff reads vectors only in dataset 55, so the surface pressure is a dataset 2414.
//! Numbers of both have six digits.

use calyx_runtime::acoustics::unv::{
    AnalysisData, Entity, Header, LocatedValues, NodalData, ResultKind, UnvDataset, triangle_datasets, write,
};
use calyx_runtime::forced_response::ForcedResponse;
use calyx_runtime::radiated_sound::{RadiatedSound, SurfaceVibration};
use std::collections::HashMap;
use std::path::Path;
use std::{fs, io};

/// Folder of the files in a run directory.
pub const FOLDER: &str = "unv";
/// Beginning of the names of the files.
const SURFACE: &str = "sound_surface-";
/// Quantities of results.
const VELOCITY: i64 = 11;
const PRESSURE: i64 = 15;
/// Largest number of characters of a line.
const COLUMNS: usize = 80;

/// Returns true if a run may write a file of this name into [`FOLDER`].
pub fn is_name_of_a_run(name: &str) -> bool {
    name.starts_with(SURFACE) && name.ends_with(".unv")
}

/// Returns the sounds with a file, and the names of these, relative to the run directory.
fn named(response: &ForcedResponse) -> impl Iterator<Item = (&RadiatedSound, &SurfaceVibration, String)> {
    let sounds = response.sounds.iter().enumerate();
    sounds.filter_map(|(index, sound)| {
        let vibration = sound.vibration.as_ref().filter(|vibration| vibration.lines().next().is_some())?;
        Some((sound, vibration, format!("{FOLDER}/{SURFACE}{index:02}.unv")))
    })
}

/// Returns the names of the files of a response, relative to the run directory.
pub fn files(response: &ForcedResponse) -> Vec<String> {
    named(response).map(|(.., name)| name).collect()
}

/// Writes the files of a response.
///
/// # Errors
/// A file cannot be written, or a value does not fit into the format.
pub fn write_sound(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    for (sound, vibration, name) in named(response) {
        fs::create_dir_all(directory.join(FOLDER))?;
        let text = write(&datasets(sound, vibration)).map_err(|error| {
            let message = format!("{name}, dataset {}: {}; {}", error.line, error.message, error.help);
            io::Error::new(io::ErrorKind::InvalidData, message)
        })?;
        fs::write(directory.join(name), text)?;
    }
    Ok(())
}

/// Returns a text that fits into a line.
fn line(text: &str) -> String {
    let printable = text.chars().map(|c| if c.is_control() { ' ' } else { c });
    printable.take(COLUMNS).collect()
}

fn datasets(sound: &RadiatedSound, vibration: &SurfaceVibration) -> Vec<UnvDataset> {
    let plane = if sound.plane.is_some() { ", rigid plane" } else { "" };
    let description = format!(
        "Surface velocities, ground axes; sound: {}, {:.5} kg/m3{plane}",
        sound.method.name(),
        sound.fluid.density
    );
    // Files of the same model are equal, so they have no date.
    let header = [
        &sound.body,
        &description,
        "Calyx",
        "01-Jan-00  00:00:00           0         0         0",
        "01-Jan-00  00:00:00",
        "Calyx",
        "01-Jan-00  00:00:00",
    ];
    let mut all = vec![UnvDataset::Header(Header { lines: header.into_iter().map(line).collect() })];
    all.extend(triangle_datasets(&vibration.vertices, &vibration.triangles));
    let mut lines: Vec<usize> = vibration.lines().collect();
    let frequency = |line: usize| sound.frequency(line, sound.own.speed);
    lines.sort_by(|one, other| frequency(*one).total_cmp(&frequency(*other)));
    for (step, index) in lines.into_iter().enumerate() {
        let names = |quantity: &str| -> Vec<String> {
            let names = [
                quantity,
                &sound.body,
                "Peak amplitudes; time factor exp(+i omega t)",
                &format!("Spectral line {index} of the forced response"),
                "NONE",
            ];
            names.into_iter().map(line).collect()
        };
        // Structural model, frequency response.
        let kind = |[characteristic, quantity]: [i64; 2]| ResultKind {
            model: 1,
            analysis: 5,
            characteristic,
            quantity,
        };
        let (step, frequency) = (step as i64 + 1, frequency(index));
        let values = vibration.velocities(index).into_iter().enumerate();
        let values = values.map(|(node, own)| LocatedValues { label: node as i64 + 1, values: own.to_vec() });
        all.push(UnvDataset::NodalData(NodalData {
            names: names("Velocity, m/s"),
            kind: kind([2, VELOCITY]),
            is_complex: true,
            integers: vec![1, step],
            reals: vec![frequency],
            values: values.collect(),
        }));
        let values = pressures(sound, vibration, index);
        if !values.is_empty() {
            all.push(UnvDataset::AnalysisData(Box::new(AnalysisData {
                label: step,
                name: line("Sound pressure on the surface"),
                entity: Entity::Nodes,
                names: names("Sound pressure on the surface, Pa"),
                kind: kind([1, PRESSURE]),
                is_complex: true,
                // The load set is the fifth one, the number of the frequency the eighth one.
                integers: vec![1, 0, 0, 0, 1, 0, 0, step],
                reals: vec![0.0, frequency],
                values,
            })));
        }
    }
    all
}

/// Returns the surface pressure of a line at the nodes of the coarsened surface, which are nodes of
/// the skin; empty if it is unknown.
fn pressures(sound: &RadiatedSound, vibration: &SurfaceVibration, line: usize) -> Vec<LocatedValues> {
    let Some(skin) = &sound.skin else { return Vec::new() };
    let Some(field) = skin.fields.iter().find(|field| field.line == line) else { return Vec::new() };
    let bits = |at: &[f64; 3]| at.map(f64::to_bits);
    let labels: HashMap<[u64; 3], i64> =
        vibration.vertices.iter().enumerate().map(|(index, at)| (bits(at), index as i64 + 1)).collect();
    let value = |(at, pressure): (&[f64; 3], _)| {
        Some(LocatedValues { label: *labels.get(&bits(at))?, values: vec![pressure] })
    };
    let mut values: Vec<LocatedValues> =
        skin.vertices.iter().zip(field.pressures.iter().copied()).filter_map(value).collect();
    values.sort_by_key(|own| own.label);
    values
}
