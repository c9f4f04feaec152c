//! Section on radiated sound: levels over the speed, waterfall plot, spectrum at the speed of the
//! model, the powers from the bearings to the fluid, the sound on the surface, and around it.

mod surface;
mod surroundings;

use super::chart::{Axis, Curve, WIDE, curves};
use super::figure;
use super::read::Run;
use super::waterfall::{self, Point, Ray};
use super::{number, percent};
use crate::radiated_sound::{DirectivityRow, FieldRow, KEY, PanelRow, SoundRow};
use maud::{Markup, PreEscaped, html};
use serde_json::Value;
use std::collections::BTreeMap;

/// Largest number of lines in a plot.
const SHOWN: usize = 4;
/// Range of levels below the largest one in a plot, dB.
const RANGE: f64 = 60.0;
/// Reference of sound power levels, W.
const REFERENCE: f64 = 1e-12;

/// Plots the sound of all bodies.
pub fn section(run: &Run) -> Markup {
    let Some(sounds) = run.head[KEY].as_array().filter(|sounds| !sounds.is_empty()) else {
        return PreEscaped(String::new());
    };
    html! {
        p.note {
            "Transmission errors and varying mesh stiffnesses excite the vibration; bearings carry it to the body, whose component modes give the velocity of its walls, and these the sound. "
            "Levels are sound power levels in dB relative to 1 pW. Amplitudes of the waterfall plot are roots of sound powers. The fluid does not change the vibration."
        }
        @for sound in sounds { (body(run, sound)) }
    }
}

fn text<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

fn body(run: &Run, sound: &Value) -> Markup {
    let name = text(sound, "body");
    let tables = &run.radiated_sound;
    let rows: Vec<&SoundRow> = tables.lines.iter().filter(|row| row.body == name).collect();
    let panels: Vec<&PanelRow> = tables.panels.iter().filter(|row| row.body == name).collect();
    let fields: Vec<&FieldRow> = tables.fields.iter().filter(|row| row.body == name).collect();
    let directivity: Vec<&DirectivityRow> =
        tables.directivity.iter().filter(|row| row.body == name).collect();
    html! {
        h3 { (name) }
        (facts(sound))
        (powers(sound))
        (over_speed(name, &rows))
        (waterfall_plot(name, &rows, &run.natural_frequencies))
        (spectrum(name, sound))
        (surface::pictures(name, &tables.pictures))
        (surface::panels(name, sound, &panels))
        (surroundings::directivity(name, sound, &directivity))
        (surroundings::fields(name, sound, &fields))
    }
}

/// Describes the last link, and what was changed on the surface.
fn facts(sound: &Value) -> Markup {
    let surface = &sound["surface"];
    let method = match text(sound, "method") {
        "erp" => "equivalent radiated power",
        "rayleigh" => "Rayleigh integral",
        _ => "boundary elements",
    };
    let count = |value: &Value| value.as_u64().unwrap_or_default();
    let closed: Vec<String> = surface["closed_openings"]
        .as_array()
        .into_iter()
        .flatten()
        .map(|opening| text(opening, "name").to_owned())
        .collect();
    let left_out = count(&surface["elements_left_out"]);
    let percent = |key: &str| sound[key].as_f64().map(|value| format!("{:.2} %", 1e2 * value));
    html! {
        p {
            "Method: " (method) " in " (surroundings(sound)) ", with " (count(&surface["triangles"])) " triangles (" (count(&surface["triangles_before_coarsening"])) " before coarsening) on "
            (number(1e4 * surface["area"].as_f64().unwrap_or_default())) " cm², with "
            (decimal(&sound["elements_per_wavelength"])) " elements per wavelength at the highest line. "
            "The body has component modes up to " (number(sound["highest_frequency"].as_f64().unwrap_or_default()))
            " Hz; lines above have no sound, so levels of all lines drop where one passes this frequency. "
            @if !closed.is_empty() { "Closed by lids: " (closed.join(", ")) ". " }
            @if left_out > 0 { (left_out) " elements are left out: ribs, inner parts, or shells on solids. " }
            @if count(&sound["solved_frequencies"]) > 0 {
                "The field is solved at " (count(&sound["solved_frequencies"])) " frequencies; the error of the power by interpolation is at most "
                (percent("interpolation_error").unwrap_or_default())
                @if let Some(difference) = percent("far_field_difference") { ", and the powers on the surface and in the far field differ by up to " (difference) }
                "."
            }
        }
    }
}

/// Describes the fluid and the rigid plane.
fn surroundings(sound: &Value) -> String {
    let fluid = match text(&sound["fluid"], "name") {
        "" => "a fluid",
        name => name,
    };
    match &sound["plane"] {
        Value::Null => format!("{fluid}, in free space"),
        plane => format!(
            "{fluid}, on the rigid plane through ({}) m with the normal ({})",
            coordinates(&plane["point"]),
            coordinates(&plane["normal"])
        ),
    }
}

fn decimal(value: &Value) -> String {
    value.as_f64().map_or_else(|| "unknown".into(), |value| format!("{value:.1}"))
}

/// Lists the powers from the bearings to the fluid at the speed of the model.
fn powers(sound: &Value) -> Markup {
    let power =
        |key: &str| sound[key].as_f64().map_or("unknown".to_owned(), |value| format!("{value:.4e} W"));
    let error = |key: &str| {
        let known = sound[&format!("{key}_error")].as_f64();
        known.map_or_else(String::new, |error| format!(" (estimated error {} dB)", rounded_up(error)))
    };
    let level = |key: &str| {
        sound[key].as_f64().map_or("none".to_owned(), |value| format!("{value:.1} dB{}", error(key)))
    };
    let efficiency = sound["radiation_efficiency"].as_f64();
    let equivalent = sound["lines"]
        .as_array()
        .map(|lines| lines.iter().filter_map(|line| line["equivalent_power"].as_f64()).sum::<f64>());
    let equivalent = equivalent
        .filter(|power| *power > 0.0)
        .map(|power| format!("{:.1} dB", 10.0 * (power / REFERENCE).log10()));
    let equivalent = equivalent.unwrap_or_else(|| "none".to_owned());
    html! {
        table {
            caption { "At the speed of the model, " (number(sound["speed"].as_f64().unwrap_or_default())) " rpm" }
            tr { th { "sound power level" } td { (level("level")) } }
            tr { th { "A-weighted sound power level" } td { (level("a_weighted_level")) } }
            tr { th { "level of the equivalent radiated power" } td { (equivalent) } }
            tr { th { "radiation efficiency" } td { (efficiency.map_or("none".to_owned(), |value| format!("{value:.3}"))) } }
            tr { th { "power into the body at its bearings" } td { (power("input_power")) } }
            tr { th { "power dissipated by the damping ratio" } td { (power("dissipated_power")) } }
            tr { th { "sound power" } td { (power("power")) } }
            @if let Some(ratio) = sound["fluid_mass_ratio"].as_f64() {
                tr { th { "estimated mass of the moving fluid over that of the body" } td { (percent(ratio)) } }
            }
            @for point in sound["points"].as_array().into_iter().flatten() {
                tr {
                    th { "A-weighted sound pressure level at (" (coordinates(&point["at"])) ") m" }
                    td { (point["a_weighted_level"].as_f64().map_or("none".to_owned(), |value| format!("{value:.1} dB"))) }
                }
            }
        }
    }
}

/// Returns an error in dB with a decimal, rounded up.
fn rounded_up(error: f64) -> String {
    format!("{:.1}", (1e1 * error).ceil() / 1e1)
}

fn coordinates(at: &Value) -> String {
    let all = at.as_array().into_iter().flatten().filter_map(Value::as_f64);
    coordinates_of(&all.collect::<Vec<f64>>())
}

fn coordinates_of(at: &[f64]) -> String {
    at.iter().map(|&value| number(value)).collect::<Vec<String>>().join(", ")
}

/// Returns the name of a line; meshes are named if there are several.
fn line_name(row: &SoundRow, several_meshes: bool) -> String {
    let mut name = match row.harmonic {
        0 => "mean value".to_owned(),
        harmonic if several_meshes => format!("harmonic {harmonic} of {}", row.mesh),
        harmonic => format!("harmonic {harmonic}"),
    };
    if row.sideband != 0 {
        name += &format!(", sideband {:+} of {}", row.sideband, row.modulation);
    }
    name
}

/// Returns the rows of each line over the speed, the line with the highest level first.
fn lines<'r>(rows: &[&'r SoundRow]) -> Vec<(String, Vec<&'r SoundRow>)> {
    let mut meshes: Vec<&str> =
        rows.iter().map(|row| row.mesh.as_str()).filter(|mesh| !mesh.is_empty()).collect();
    meshes.sort_unstable();
    meshes.dedup();
    let mut all: BTreeMap<String, Vec<&SoundRow>> = BTreeMap::new();
    for row in rows {
        all.entry(line_name(row, meshes.len() > 1)).or_default().push(row);
    }
    let largest = |rows: &[&SoundRow]| rows.iter().map(|row| row.power).fold(0.0, f64::max);
    let mut all: Vec<(String, Vec<&SoundRow>)> = all.into_iter().collect();
    all.sort_by(|one, other| largest(&other.1).total_cmp(&largest(&one.1)).then(one.0.cmp(&other.0)));
    all
}

/// Plots the levels of all lines together and of the loudest ones over the speed.
fn over_speed(name: &str, rows: &[&SoundRow]) -> Markup {
    let speeds: Vec<&[&SoundRow]> = rows.chunk_by(|one, other| one.speed == other.speed).collect();
    let sum = |of: fn(&SoundRow) -> Option<f64>| -> Vec<(f64, f64)> {
        let level = |speed: &&[&SoundRow]| {
            let powers = speed.iter().filter_map(|row| of(row)).map(|level| 10f64.powf(level / 10.0));
            (speed[0].speed, 10.0 * powers.sum::<f64>().log10())
        };
        speeds.iter().map(level).filter(|(_, level)| level.is_finite()).collect()
    };
    let total = |name: &str, colour: usize, points: Vec<(f64, f64)>| Curve {
        name: name.into(),
        colour,
        points,
        ..Curve::default()
    };
    let mut all = vec![
        total("all lines", 0, sum(|row| row.level)),
        total("all lines, A-weighted", 1, sum(|row| row.a_weighted_level)),
    ];
    let largest = all[0].points.iter().map(|point| point.1).fold(f64::NEG_INFINITY, f64::max);
    let shown = |level: &f64| *level > largest - RANGE;
    for (index, (line, rows)) in lines(rows).into_iter().take(SHOWN).enumerate() {
        let points = rows.iter().filter_map(|row| Some((row.speed, row.level.filter(shown)?)));
        all.push(total(&line, index + 2, points.collect()));
    }
    let (x, y) = (Axis { what: "speed", unit: "rpm" }, Axis { what: "sound power level", unit: "dB" });
    figure(&curves(WIDE, &x, &y, &all, &[]), &format!("sound power level of {name} over the speed"))
}

fn waterfall_plot(name: &str, rows: &[&SoundRow], natural_frequencies: &[f64]) -> Markup {
    let point = |row: &&SoundRow| Point { at: [row.speed, row.frequency], amplitude: row.power.sqrt() };
    let rays: Vec<Ray> =
        lines(rows).into_iter().map(|(_, rows)| Ray { points: rows.iter().map(point).collect() }).collect();
    let (x, y) = (Axis { what: "speed", unit: "rpm" }, Axis { what: "frequency", unit: "Hz" });
    let plot = waterfall::plot(&x, &y, &rays, natural_frequencies);
    figure(&plot, &format!("waterfall plot of the sound of {name}; dashed lines are natural frequencies"))
}

/// Plots the levels of the lines at the speed of the model.
fn spectrum(name: &str, sound: &Value) -> Markup {
    let lines = || sound["lines"].as_array().into_iter().flatten();
    let levels = |key: &'static str| -> Vec<(f64, f64)> {
        lines().filter_map(|line| Some((line["frequency"].as_f64()?, line[key].as_f64()?))).collect()
    };
    let (plain, weighted) = (levels("level"), levels("a_weighted_level"));
    let largest = plain.iter().map(|(_, level)| *level).fold(f64::NEG_INFINITY, f64::max);
    let floor = largest - RANGE;
    let mut all = Vec::new();
    for (title, colour, levels) in [("level", 0, &plain), ("A-weighted level", 1, &weighted)] {
        // Lines of both kinds are next to each other.
        let width = 0.002 * plain.iter().map(|(frequency, _)| *frequency).fold(0.0, f64::max);
        let shown = levels.iter().filter(|(_, level)| *level > floor);
        for (index, &(frequency, level)) in shown.enumerate() {
            let at = frequency + width * colour as f64;
            all.push(Curve {
                name: if index == 0 { title.into() } else { String::new() },
                colour,
                points: vec![(at, floor), (at, level)],
                ..Curve::default()
            });
        }
    }
    let (x, y) = (Axis { what: "frequency", unit: "Hz" }, Axis { what: "sound power level", unit: "dB" });
    let speed = number(sound["speed"].as_f64().unwrap_or_default());
    figure(&curves(WIDE, &x, &y, &all, &[]), &format!("spectrum of the sound of {name} at {speed} rpm"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(speed: f64, harmonic: usize, power: f64) -> SoundRow {
        SoundRow {
            speed,
            body: "housing".into(),
            mesh: "pinion, gear".into(),
            harmonic,
            modulation: String::new(),
            sideband: 0,
            frequency: speed * harmonic as f64,
            power,
            error: 0.0,
            level: Some(10.0 * (power / REFERENCE).log10()),
            a_weighted_level: None,
            equivalent_power: power,
            input_power: None,
            dissipated_power: 1e3 * power,
        }
    }

    #[test]
    fn the_loudest_line_is_first() {
        let rows = [row(100.0, 1, 1e-9), row(100.0, 2, 1e-6), row(200.0, 1, 1e-8), row(200.0, 2, 1e-8)];
        let all: Vec<&SoundRow> = rows.iter().collect();
        let found: Vec<(String, usize)> =
            lines(&all).into_iter().map(|(name, rows)| (name, rows.len())).collect();
        assert_eq!(found, [("harmonic 2".to_owned(), 2), ("harmonic 1".to_owned(), 2)]);
        assert!(!over_speed("housing", &all).0.is_empty());
    }
}
