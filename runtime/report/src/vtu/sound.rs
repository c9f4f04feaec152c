//! VTU files of radiated sound at the speed of the model, one per spectral line: the surface of
//! each body and its field meshes. The times of their PVD collections are the frequencies in Hz.

use super::grid::{Grid, QUADRILATERAL, TRIANGLE, VERTEX, Values};
use super::{FOLDER, folder, write_collection};
use calyx_runtime::acoustics::levels::sound_pressure_level;
use calyx_runtime::forced_response::ForcedResponse;
use calyx_runtime::radiated_sound::{RadiatedSound, Skin, SkinField, SoundField};
use std::path::Path;
use std::{fs, io};

/// Beginnings of the names: surfaces and field meshes.
const SURFACE: &str = "sound_surface-";
const FIELD: &str = "sound_field-";
/// Amplitude of a pressure that counts as zero in levels, Pa: -149 dB, so that levels are finite.
const SILENT: f64 = 1e-12;

/// Collection of files: its name without extension, and its lines.
struct Series<'a> {
    name: String,
    lines: Vec<Line<'a>>,
}

/// Frequency of a line, Hz, and its grid.
type Line<'a> = (f64, Box<dyn Fn() -> Grid + 'a>);

impl Series<'_> {
    fn file(&self, index: usize) -> String {
        format!("{}-{index:02}.vtu", self.name)
    }

    fn collection(&self) -> String {
        format!("{}.pvd", self.name)
    }
}

/// Returns true if a run may write a file of this name.
pub(super) fn is_name(name: &str) -> bool {
    let is_kind = [SURFACE, FIELD].iter().any(|kind| name.starts_with(kind));
    is_kind && (name.ends_with(".vtu") || name.ends_with(".pvd"))
}

/// Returns the names of the files of a response, relative to the run directory.
pub fn sound_files(response: &ForcedResponse) -> Vec<String> {
    let of_series = |series: Series<'_>| {
        let files: Vec<String> = (0..series.lines.len()).map(|index| series.file(index)).collect();
        files.into_iter().chain([series.collection()])
    };
    let names = all(response).into_iter().flat_map(of_series);
    names.map(|name| format!("{FOLDER}/{name}")).collect()
}

/// Writes the files of a response into folder [`FOLDER`] of a run directory.
///
/// # Errors
/// A file cannot be written.
pub fn write_sound(directory: &Path, response: &ForcedResponse) -> io::Result<()> {
    let folder = folder(directory);
    for series in all(response) {
        fs::create_dir_all(&folder)?;
        let mut files = Vec::new();
        for (index, (frequency, grid)) in series.lines.iter().enumerate() {
            let name = series.file(index);
            fs::write(folder.join(&name), grid().text()?)?;
            files.push((*frequency, name));
        }
        write_collection(&folder.join(series.collection()), &files)?;
    }
    Ok(())
}

fn all(response: &ForcedResponse) -> Vec<Series<'_>> {
    let mut all = Vec::new();
    for (index, sound) in response.sounds.iter().enumerate() {
        all.extend(sound.skin.as_ref().map(|skin| Series {
            name: format!("{SURFACE}{index:02}"),
            lines: lines(sound, skin.fields.iter().map(|field| (field.line, field)), move |field| {
                surface(skin, field)
            }),
        }));
        for (number, field) in sound.fields.iter().enumerate() {
            let frequency = |line: usize| sound.frequency(line, sound.own.speed);
            let has_sound =
                |line: &usize| frequency(*line) > 0.0 && frequency(*line) <= sound.highest_frequency;
            let own = (0..field.pressures.len()).filter(has_sound).map(|line| (line, line));
            all.push(Series {
                name: format!("{FIELD}{index:02}-{number:02}"),
                lines: lines(sound, own, move |line| points(field, line)),
            });
        }
    }
    all.retain(|series| !series.lines.is_empty());
    all
}

/// Returns the frequencies and grids of lines by ascending frequency.
fn lines<'a, T: Copy + 'a>(
    sound: &RadiatedSound,
    all: impl Iterator<Item = (usize, T)>,
    grid: impl Fn(T) -> Grid + Copy + 'a,
) -> Vec<Line<'a>> {
    let own = |(line, item): (usize, T)| -> Line<'a> {
        (sound.frequency(line, sound.own.speed), Box::new(move || grid(item)))
    };
    let mut all: Vec<_> = all.map(own).collect();
    all.sort_by(|one, other| one.0.total_cmp(&other.0));
    all
}

fn level(amplitude: f64) -> f64 {
    sound_pressure_level(amplitude.max(SILENT))
}

/// Returns the surface with velocities and intensities of the triangles, and with pressures at the
/// vertices if they are known.
fn surface(skin: &Skin, field: &SkinField) -> Grid {
    let velocity =
        |of: fn(&SkinField, usize) -> f64| (0..skin.triangles.len()).map(|k| of(field, k)).collect();
    let mut grid = Grid {
        points: skin.vertices.clone(),
        cells: skin.triangles.iter().map(|triangle| (TRIANGLE, triangle.to_vec())).collect(),
        cell_values: vec![
            Values::scalars("normal_velocity", velocity(|field, k| field.velocities[k].norm())),
            Values::scalars("normal_velocity_real", velocity(|field, k| field.velocities[k].re)),
            Values::scalars("normal_velocity_imaginary", velocity(|field, k| field.velocities[k].im)),
            Values::scalars("intensity", field.intensities.clone()),
        ],
        ..Grid::default()
    };
    if !field.pressures.is_empty() {
        grid.point_values = pressures(field.pressures.iter().map(|pressure| [pressure.re, pressure.im]));
    }
    grid
}

/// Returns a field mesh with the pressures of a line.
fn points(field: &SoundField, line: usize) -> Grid {
    let mesh = &field.mesh;
    let cells = match mesh.faces.is_empty() {
        true => (0..mesh.points.len()).map(|point| (VERTEX, vec![point])).collect(),
        false => mesh.faces.iter().map(|face| (QUADRILATERAL, face.to_vec())).collect(),
    };
    Grid {
        points: mesh.points.clone(),
        cells,
        point_values: pressures(field.pressures[line].iter().map(|pressure| [pressure.re, pressure.im])),
        ..Grid::default()
    }
}

/// Returns the values of pressures from their real and imaginary parts, Pa.
fn pressures(parts: impl Iterator<Item = [f64; 2]>) -> Vec<Values> {
    let parts: Vec<[f64; 2]> = parts.collect();
    let values = |of: fn(&[f64; 2]) -> f64| parts.iter().map(of).collect();
    vec![
        Values::scalars("sound_pressure_level", values(|[real, imaginary]| level(real.hypot(*imaginary)))),
        Values::scalars("pressure_real", values(|parts| parts[0])),
        Values::scalars("pressure_imaginary", values(|parts| parts[1])),
    ]
}
