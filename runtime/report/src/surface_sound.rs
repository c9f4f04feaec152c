//! Sound of the vibration of a file: its tables in text, CSV and JSON.

use crate::summary_table::number;
use calyx_runtime::acoustics::levels::sound_pressure_level;
use calyx_runtime::acoustics::surface_sound::{CaseKind, CaseSound, SurfaceSound};
use serde::Serialize;
use serde_json::{Value, json};
use std::io;
use std::path::Path;

/// File name of the sound powers.
pub const SOUND: &str = "sound.csv";
/// File name of the sound pressures at points.
pub const PRESSURES: &str = "sound_pressure.csv";
/// File name of all results with notes and warnings.
pub const DOCUMENT: &str = "sound.json";
/// Files of a directory of sound.
pub const FILES: [&str; 3] = [SOUND, PRESSURES, DOCUMENT];

/// Row of [`SOUND`].
#[derive(Serialize)]
struct Row<'s> {
    /// Load case; empty if there is one.
    case: &'s str,
    mode: Option<i64>,
    /// Frequency, Hz.
    frequency: f64,
    /// Sound power, W; unknown for modes, whose amplitude is arbitrary.
    power: Option<f64>,
    level: Option<f64>,
    a_weighted_level: Option<f64>,
    equivalent_power: Option<f64>,
    efficiency: Option<f64>,
    /// Power per mean square of the normal velocity, W·s²/m².
    power_per_mean_square: Option<f64>,
    far_field_difference: Option<f64>,
}

/// Row of [`PRESSURES`].
#[derive(Serialize)]
struct PressureRow<'s> {
    case: &'s str,
    frequency: f64,
    x: f64,
    y: f64,
    z: f64,
    /// Amplitude, Pa.
    pressure: f64,
    /// Phase, degrees.
    phase: f64,
    level: Option<f64>,
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Returns the load case and the number of the mode.
fn kind(case: &CaseSound) -> (&str, Option<i64>) {
    match &case.kind {
        CaseKind::Response(load) => (load, None),
        CaseKind::Mode(number) => ("", Some(*number)),
    }
}

fn row(sound: &CaseSound) -> Row<'_> {
    let (case, mode) = kind(sound);
    let of_response = |value: f64| finite(value).filter(|_| mode.is_none());
    Row {
        case,
        mode,
        frequency: sound.frequency,
        power: of_response(sound.power),
        level: of_response(sound.level()),
        a_weighted_level: of_response(sound.a_weighted_level()),
        equivalent_power: of_response(sound.equivalent_power),
        efficiency: finite(sound.efficiency()),
        power_per_mean_square: finite(sound.power_per_mean_square()),
        far_field_difference: finite(sound.far_field_difference),
    }
}

fn pressures(sound: &SurfaceSound) -> impl Iterator<Item = PressureRow<'_>> {
    sound.cases.iter().flat_map(|case| {
        let (load, _) = kind(case);
        case.pressures.iter().zip(&sound.points).map(move |(pressure, &[x, y, z])| PressureRow {
            case: load,
            frequency: case.frequency,
            x,
            y,
            z,
            pressure: pressure.norm(),
            phase: pressure.arg().to_degrees(),
            level: finite(sound_pressure_level(pressure.norm())),
        })
    })
}

/// Returns the names of the files of a sound.
pub fn files(sound: &SurfaceSound) -> Vec<&'static str> {
    let all = [(SOUND, true), (PRESSURES, !sound.points.is_empty()), (DOCUMENT, true)];
    all.into_iter().filter(|(_, wanted)| *wanted).map(|(name, _)| name).collect()
}

/// Writes the files of a sound: its table, the pressures at points, and [`json()`].
///
/// # Errors
/// A file cannot be written.
pub fn write(directory: &Path, file: &str, sound: &SurfaceSound) -> io::Result<()> {
    let mut table = csv::Writer::from_path(directory.join(SOUND))?;
    sound.cases.iter().try_for_each(|case| table.serialize(row(case)))?;
    table.flush()?;
    if !sound.points.is_empty() {
        let mut table = csv::Writer::from_path(directory.join(PRESSURES))?;
        pressures(sound).try_for_each(|row| table.serialize(row))?;
        table.flush()?;
    }
    std::fs::write(directory.join(DOCUMENT), format!("{:#}\n", json(file, sound)))
}

/// Returns all results of a file as one document, SI.
pub fn json(file: &str, sound: &SurfaceSound) -> Value {
    let surface = &sound.surface;
    json!({
        "file": file,
        "method": sound.method.name(),
        "fluid": { "density": sound.fluid.density, "speed_of_sound": sound.fluid.speed_of_sound },
        "surface": {
            "triangles": surface.triangles,
            "coarse_triangles": surface.coarse_triangles,
            "area": surface.area,
            "edges": surface.edges,
            "lids": surface.lids,
        },
        "points": sound.points,
        "cases": sound.cases.iter().map(row).collect::<Vec<_>>(),
        "pressures": pressures(sound).collect::<Vec<_>>(),
        "notes": sound.notes,
        "warnings": sound.warnings,
    })
}

/// Formats the table of frequency responses, and that of normal modes.
pub fn text(sound: &SurfaceSound) -> String {
    let is_mode = |case: &&CaseSound| matches!(case.kind, CaseKind::Mode(_));
    let responses: Vec<&CaseSound> = sound.cases.iter().filter(|case| !is_mode(case)).collect();
    let modes: Vec<&CaseSound> = sound.cases.iter().filter(is_mode).collect();
    let mut text = String::new();
    if !responses.is_empty() {
        let has_cases = responses.iter().any(|case| !kind(case).0.is_empty());
        let mut names = vec!["frequency", "power", "level", "A-weighted", "equivalent power", "efficiency"];
        let mut units = vec!["Hz", "W", "dB", "dB", "W", ""];
        if has_cases {
            names.insert(0, "case");
            units.insert(0, "");
        }
        let at: Vec<String> = (1..=sound.points.len()).map(|number| format!("at point {number}")).collect();
        names.extend(at.iter().map(String::as_str));
        units.extend(at.iter().map(|_| "dB"));
        let mut rows: Vec<Vec<String>> =
            [names, units].map(|row| row.into_iter().map(str::to_owned).collect()).to_vec();
        rows.extend(responses.iter().map(|case| {
            let mut cells = vec![
                number(case.frequency),
                number(case.power),
                level(case.level()),
                level(case.a_weighted_level()),
                number(case.equivalent_power),
                number(case.efficiency()),
            ];
            if has_cases {
                cells.insert(0, kind(case).0.to_owned());
            }
            cells.extend(case.pressures.iter().map(|pressure| level(sound_pressure_level(pressure.norm()))));
            cells
        }));
        text += &aligned(&rows);
    }
    if !modes.is_empty() {
        if !text.is_empty() {
            text.push('\n');
        }
        let head = [
            ["mode", "frequency", "efficiency", "power per mean square velocity"],
            ["", "Hz", "", "W s²/m²"],
        ];
        let mut rows: Vec<Vec<String>> = head.map(|row| row.map(str::to_owned).to_vec()).to_vec();
        rows.extend(modes.iter().map(|case| {
            vec![
                kind(case).1.unwrap_or(0).to_string(),
                number(case.frequency),
                number(case.efficiency()),
                number(case.power_per_mean_square()),
            ]
        }));
        text += &aligned(&rows);
    }
    text
}

/// Formats a level with a tenth of a decibel.
fn level(value: f64) -> String {
    if value.is_finite() { format!("{value:.1}") } else { "none".into() }
}

/// Aligns all columns right.
fn aligned(rows: &[Vec<String>]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows.first().map_or(0, Vec::len)).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let cells: Vec<String> =
            row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}")).collect();
        text += cells.join("  ").trim_end();
        text.push('\n');
    }
    text
}
