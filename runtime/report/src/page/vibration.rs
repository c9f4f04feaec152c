//! Section on forced vibration: root mean squares of the response over the speed, and its
//! harmonics.

use super::chart::{Axis, Curve, WIDE, curves};
use super::figure;
use super::read::Run;
use super::units::{Unit, Units};
use crate::forced_response::ResponseRow;
use maud::{Markup, PreEscaped, html};

/// Largest number of harmonics in a plot.
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
    if plotted.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        p.note { "Steady vibration that a mesh excites, over the speed of its first gear: root mean square of the variation about the mean, and the amplitudes of the first harmonics of the mesh frequency. The computation assumes that teeth remain in contact; warnings of the run state the speeds at which they separate. The motions of all bodies are in forced_response.csv." }
        @for name in plotted { (plot(run, name, units)) }
    }
}

fn plot(run: &Run, name: &str, units: Units) -> Markup {
    let rows: Vec<&ResponseRow> = run.forced_response.iter().filter(|row| row.quantity == name).collect();
    let Some(first) = rows.first() else { return PreEscaped(String::new()) };
    let unit = unit(&first.unit, units);
    let highest = rows.iter().map(|row| row.harmonic).max().unwrap_or_default();
    let whole = Curve {
        name: "root mean square".into(),
        colour: 0,
        // All harmonics of a speed are next to each other.
        points: rows
            .chunks(highest + 1)
            .map(|speed| (speed[0].speed, unit.of(root_mean_square(speed))))
            .collect(),
        ..Curve::default()
    };
    let mut all = vec![whole];
    all.extend((1..=highest.min(SHOWN)).map(|harmonic| {
        Curve {
            name: format!("harmonic {harmonic}"),
            colour: harmonic,
            points: rows
                .iter()
                .filter(|row| row.harmonic == harmonic)
                .map(|row| (row.speed, unit.of(row.amplitude)))
                .collect(),
            ..Curve::default()
        }
    }));
    let (x, y) = (Axis { what: "speed", unit: "rpm" }, Axis { what: "amplitude", unit: unit.name });
    figure(&curves(WIDE, &x, &y, &all, &[]), name)
}

/// Returns the root mean square of the variation about the mean, from the harmonics of one speed.
fn root_mean_square(rows: &[&ResponseRow]) -> f64 {
    let variation = rows.iter().filter(|row| row.harmonic > 0);
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
            harmonic,
            frequency: 0.0,
            amplitude,
            error: 0.0,
            phase: 0.0,
            growth: 0.5,
        };
        let rows = [row(0, 50.0), row(1, 3.0), row(2, 4.0)];
        let found = root_mean_square(&rows.iter().collect::<Vec<_>>());
        assert!((found - 12.5_f64.sqrt()).abs() < 1e-14, "{found}");
    }
}
