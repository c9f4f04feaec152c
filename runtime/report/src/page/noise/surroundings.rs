//! Sound around a body in the report: directivity, field meshes and maps of planes.

use super::{coordinates_of, text};
use crate::page::chart::{Axis, MapCell, map};
use crate::page::polar::{Pattern, plot};
use crate::page::{figure, number};
use crate::radiated_sound::{DirectivityRow, FieldRow};
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

/// Largest number of lines in a directivity.
const SHOWN: usize = 4;
/// Level below the loudest line from which others are left out, dB.
const QUIET: f64 = 30.0;

/// Plots the levels of the loudest lines in the coordinate planes.
pub fn directivity(name: &str, sound: &Value, rows: &[&DirectivityRow]) -> Markup {
    let mut lines: Vec<(f64, Vec<&DirectivityRow>)> = Vec::new();
    for row in rows {
        match lines.iter_mut().find(|(frequency, _)| *frequency == row.frequency) {
            Some((_, own)) => own.push(row),
            None => lines.push((row.frequency, vec![row])),
        }
    }
    let largest =
        |rows: &[&DirectivityRow]| rows.iter().filter_map(|row| row.level).fold(f64::NEG_INFINITY, f64::max);
    lines.sort_by(|one, other| largest(&other.1).total_cmp(&largest(&one.1)));
    let loudest = lines.first().map_or(f64::NEG_INFINITY, |(_, rows)| largest(rows));
    lines.retain(|(_, rows)| largest(rows) >= loudest - QUIET);
    lines.truncate(SHOWN);
    let pattern = |(frequency, rows): &(f64, Vec<&DirectivityRow>)| {
        let of_plane = |plane: &str| {
            let own = rows.iter().filter(|row| row.plane == plane);
            own.filter_map(|row| Some((row.angle, row.level?))).collect()
        };
        Pattern { name: line_name(sound, *frequency), planes: ["xy", "yz", "zx"].map(of_plane) }
    };
    let patterns: Vec<Pattern> = lines.iter().map(pattern).collect();
    let axes = [["x", "y"], ["y", "z"], ["z", "x"]];
    let caption = format!(
        "directivity of {name} in the planes xy, yz and zx of ground: sound pressure level in dB at a distance of 1 m, extrapolated from the far field"
    );
    figure(&plot(axes, &patterns), &caption)
}

/// Names a line by its harmonic and frequency.
fn line_name(sound: &Value, frequency: f64) -> String {
    let lines = sound["lines"].as_array().into_iter().flatten();
    let mut own = lines.filter(|line| line["frequency"].as_f64() == Some(frequency));
    let line = own.next();
    let harmonic = line.and_then(|line| line["harmonic"].as_u64()).filter(|&number| number > 0);
    let sideband = line.and_then(|line| line["sideband"].as_i64()).unwrap_or_default();
    match harmonic {
        Some(harmonic) if sideband == 0 => format!("harmonic {harmonic}, {} Hz", number(frequency)),
        _ => format!("{} Hz", number(frequency)),
    }
}

/// Lists the field meshes with their levels, and shows maps of planes.
pub fn fields(name: &str, sound: &Value, rows: &[&FieldRow]) -> Markup {
    let all = sound["fields"].as_array().filter(|all| !all.is_empty());
    let Some(all) = all else { return PreEscaped(String::new()) };
    let level = |field: &Value, key: &str| {
        field[key].as_f64().map_or_else(|| "–".to_owned(), |value| format!("{value:.1} dB"))
    };
    let exact = level(sound, "a_weighted_level");
    html! {
        table.numbers {
            caption { "Field meshes, with A-weighted levels. The sound power level of " (name) " is " (exact) "." }
            thead { tr {
                th { "field" } th.word { "kind" } th { "points" } th { "area" }
                th { "mean pressure level" } th { "power level by ISO 3744" }
            } }
            tbody { @for field in all { tr {
                th scope="row" { (text(field, "name")) }
                td.word { (text(field, "kind")) }
                td { (field["points"].as_u64().unwrap_or_default()) }
                td { (number(field["area"].as_f64().unwrap_or_default())) " m²" }
                td { (level(field, "a_weighted_level")) }
                td { (level(field, "a_weighted_measured_power_level")) }
            } } }
        }
        @for field in all { (plane(name, field, rows)) }
    }
}

/// Draws the sound pressure on a plane.
fn plane(name: &str, field: &Value, rows: &[&FieldRow]) -> Markup {
    let counts: Option<Vec<usize>> = field["grid"]
        .as_array()
        .map(|counts| counts.iter().filter_map(|count| Some(count.as_u64()? as usize)).collect());
    let Some(&[across, up]) = counts.as_deref() else { return PreEscaped(String::new()) };
    let title = text(field, "name");
    // The sum of the mean squares of all lines.
    let mut squares = vec![0.0; across * up];
    let mut places = vec![[0.0; 3]; across * up];
    for row in rows.iter().filter(|row| row.field == title) {
        let Some(at) = row.point.checked_sub(1).filter(|at| *at < squares.len()) else { continue };
        squares[at] += 0.5 * row.pressure * row.pressure;
        places[at] = [row.x, row.y, row.z];
    }
    if across < 2 || up < 2 {
        return PreEscaped(String::new());
    }
    let step = |to: usize| {
        let square: f64 = (0..3).map(|k| (places[to][k] - places[0][k]).powi(2)).sum();
        square.sqrt()
    };
    let [width, height] = [step(1), step(across)];
    let cell = |(index, square): (usize, &f64)| {
        let (i, j) = ((index % across) as f64, (index / across) as f64);
        MapCell {
            x: [i * width, (i + 1.0) * width],
            y: [j * height, (j + 1.0) * height],
            value: 1e3 * square.sqrt(),
        }
    };
    let cells: Vec<MapCell> = squares.iter().enumerate().map(cell).collect();
    let (x, y) =
        (Axis { what: "along the first edge", unit: "m" }, Axis { what: "along the second edge", unit: "m" });
    let drawing = map(&x, &y, &Axis { what: "pressure", unit: "mPa" }, &cells);
    let first = coordinates_of(&places[0]);
    figure(
        &drawing,
        &format!(
            "effective sound pressure of {name} on the plane {title}, all lines; the first point is at ({first}) m"
        ),
    )
}
