//! Section on forced vibration: root mean squares of the response over the speed, its harmonics,
//! and waterfall plots.

use super::chart::{Axis, Curve, WIDE, curves};
use super::figure;
use super::read::Run;
use super::units::{Unit, Units};
use super::waterfall::{self, Point, Ray};
use crate::forced_response::ResponseRow;
use maud::{Markup, PreEscaped, html};

/// Amplitude relative to the largest one of its unit below which a quantity is not plotted.
const NEGLIGIBLE: f64 = 1e-6;
/// Largest number of lines in a plot.
const SHOWN: usize = 5;

/// Plots the transmission errors, tooth torques and bearing forces over the speed.
pub fn section(run: &Run, units: Units) -> Markup {
    let mut names: Vec<&str> = Vec::new();
    for row in &run.forced_response {
        if !names.contains(&row.quantity.as_str()) {
            names.push(&row.quantity);
        }
    }
    let is_plotted = |name: &&str| {
        ["transmission_error", "tooth_torque", "bearing_"].iter().any(|kind| name.starts_with(kind))
    };
    let plotted: Vec<&str> = names.iter().copied().filter(is_plotted).collect();
    let plotted: Vec<&str> = plotted.into_iter().filter(|name| !is_negligible(run, name)).collect();
    if plotted.is_empty() {
        return PreEscaped(String::new());
    }
    let natural = match run.natural_frequencies.is_empty() {
        true => "",
        false => ", and dashed lines are natural frequencies of the mean stiffness",
    };
    html! {
        p.note { "Steady vibration that the meshes excite, over the speed of the first gear of the requested mesh: root mean square of the variation about the mean, and the amplitudes of the lines that are largest over all speeds. The waterfall plot below it has the frequencies of all lines; colours are levels in dB of the largest amplitude" (natural) ". The computation assumes that teeth remain in contact; warnings of the run state the speeds at which the load on a gear changes its sign, but planets and idlers, whose meshes balance, are not examined. The motions of all bodies are in forced_response.csv." }
        @for name in plotted { (plots(run, name, units)) }
    }
}

/// Returns true if a quantity varies by less than a millionth of the largest one with its unit, as
/// by rounding.
fn is_negligible(run: &Run, name: &str) -> bool {
    let varies = |row: &&ResponseRow| row.harmonic > 0;
    let largest = |rows: &mut dyn Iterator<Item = &ResponseRow>| {
        rows.filter(varies).map(|row| row.amplitude).fold(0.0, f64::max)
    };
    let Some(unit) = run.forced_response.iter().find(|row| row.quantity == name).map(|row| &row.unit) else {
        return true;
    };
    let own = largest(&mut run.forced_response.iter().filter(|row| row.quantity == name));
    let of_all = largest(&mut run.forced_response.iter().filter(|row| row.unit == *unit));
    own <= NEGLIGIBLE * of_all
}

/// Rows of a spectral line over the speed, and its name.
struct Line<'r> {
    name: String,
    rows: Vec<&'r ResponseRow>,
}

/// Plots a quantity over the speed, and its waterfall plot.
fn plots(run: &Run, name: &str, units: Units) -> Markup {
    let rows: Vec<&ResponseRow> = run.forced_response.iter().filter(|row| row.quantity == name).collect();
    let Some(first) = rows.first() else { return PreEscaped(String::new()) };
    let unit = unit(&first.unit, units);
    // All lines of a speed are next to each other.
    let speeds: Vec<&[&ResponseRow]> = rows.chunk_by(|one, other| one.speed == other.speed).collect();
    let whole = Curve {
        name: "root mean square".into(),
        colour: 0,
        points: speeds.iter().map(|speed| (speed[0].speed, unit.of(root_mean_square(speed)))).collect(),
        ..Curve::default()
    };
    let mut lines = lines(&speeds);
    let rays: Vec<Ray> = lines
        .iter()
        .map(|line| {
            let point =
                |row: &&ResponseRow| Point { at: [row.speed, row.frequency], amplitude: row.amplitude };
            Ray { points: line.rows.iter().map(point).collect() }
        })
        .collect();
    let largest = |line: &Line<'_>| line.rows.iter().map(|row| row.amplitude).fold(0.0, f64::max);
    lines.sort_by(|one, other| largest(other).total_cmp(&largest(one)));
    let mut all = vec![whole];
    all.extend(lines.iter().take(SHOWN).enumerate().map(|(index, line)| Curve {
        name: line.name.clone(),
        colour: index + 1,
        points: line.rows.iter().map(|row| (row.speed, unit.of(row.amplitude))).collect(),
        ..Curve::default()
    }));
    let (x, y) = (Axis { what: "speed", unit: "rpm" }, Axis { what: "amplitude", unit: unit.name });
    let map = waterfall::plot(&x, &Axis { what: "frequency", unit: "Hz" }, &rays, &run.natural_frequencies);
    html! {
        (figure(&curves(WIDE, &x, &y, &all, &[]), name))
        // Moments of bearings have the spectra of their forces.
        @if !name.starts_with("bearing_moment") { (figure(&map, &format!("waterfall plot of {name}"))) }
    }
}

/// Returns the lines of a quantity but its mean value, from its rows by speed.
fn lines<'r>(speeds: &[&[&'r ResponseRow]]) -> Vec<Line<'r>> {
    let count = speeds.iter().map(|speed| speed.len()).min().unwrap_or_default();
    let several = |of: fn(&ResponseRow) -> &str| {
        let mut names: Vec<&str> =
            speeds[0].iter().map(|row| of(row)).filter(|name| !name.is_empty()).collect();
        names.sort_unstable();
        names.dedup();
        names.len() > 1
    };
    let line = |index: usize| {
        let rows: Vec<&ResponseRow> = speeds.iter().map(|speed| speed[index]).collect();
        let row = rows[0];
        let is_mean = row.harmonic == 0 && row.sideband == 0;
        (!is_mean)
            .then(|| Line { name: name(row, several(|row| &row.mesh), several(|row| &row.modulation)), rows })
    };
    (0..count).filter_map(line).collect()
}

/// Returns the name of a line, with mesh and modulation if there are several.
fn name(row: &ResponseRow, several_meshes: bool, several_modulations: bool) -> String {
    let mut name = match row.harmonic {
        0 => "mean value".to_owned(),
        harmonic if several_meshes => format!("harmonic {harmonic} of {}", row.mesh),
        harmonic => format!("harmonic {harmonic}"),
    };
    if row.sideband != 0 {
        name += &format!(", sideband {:+}", row.sideband);
        if several_modulations {
            name += &format!(" of {}", row.modulation);
        }
    }
    name
}

/// Returns the root mean square of the variation about the mean, from the lines of one speed.
fn root_mean_square(rows: &[&ResponseRow]) -> f64 {
    let variation = rows.iter().filter(|row| row.harmonic > 0 || row.sideband != 0);
    variation.map(|row| 0.5 * row.amplitude * row.amplitude).sum::<f64>().sqrt()
}

/// Returns the unit in which a quantity is plotted, from its unit in the table.
fn unit(of_table: &str, units: Units) -> Unit {
    match of_table {
        "rad" => Unit { name: "urad", size: 1e-6 },
        "N" => units.force,
        _ => Unit { name: "N*m", size: 1.0 },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The root mean square is that of all harmonics but the mean value.
    #[test]
    fn the_root_mean_square_leaves_out_the_mean() {
        let row = |harmonic: usize, amplitude: f64| ResponseRow {
            speed: 100.0,
            quantity: "tooth_torque(gear)".into(),
            unit: "N*m".into(),
            mesh: "pinion, gear".into(),
            harmonic,
            modulation: String::new(),
            sideband: 0,
            frequency: 0.0,
            amplitude,
            error: 0.0,
            phase: 0.0,
            growth: Some(0.5),
        };
        let rows = [row(0, 50.0), row(1, 3.0), row(2, 4.0)];
        let speed: Vec<&ResponseRow> = rows.iter().collect();
        let named: Vec<String> = lines(&[&speed, &speed]).into_iter().map(|line| line.name).collect();
        assert_eq!(named, ["harmonic 1", "harmonic 2"]);
        let found = root_mean_square(&rows.iter().collect::<Vec<_>>());
        assert!((found - 12.5_f64.sqrt()).abs() < 1e-14, "{found}");
    }
}
