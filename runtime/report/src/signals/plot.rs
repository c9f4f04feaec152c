//! Plots of outputs in the frequency domain.

use super::{Shown, number, title};
use calyx_runtime::signal::{Signal, SignalKind, SignalTable};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

/// Size of a plot, pixels.
const SIZE: (u32, u32) = (960, 540);
/// Height of the magnitude panel of a transfer function, above its phase panel, pixels.
const MAGNITUDES: u32 = 330;
/// Distance of the grid lines of phases, degrees.
const QUARTER: f64 = 90.0;
/// Width of the legend of a map, pixels.
const LEGEND: u32 = 130;
/// Orders of magnitude below the largest value that line spectra show.
const DECADES: i32 = 5;
/// Orders of magnitude that maps show; fewer, because colours are harder to distinguish than
/// heights.
const DECADES_OF_MAPS: i32 = 3;
/// Largest number of peaks labelled with their frequency.
const NAMED_PEAKS: usize = 6;
/// Width and height of such a label, pixels.
const NAME: [i32; 2] = [70, 16];
/// Limit from which frequencies are shown in kHz, Hz.
const MANY_HERTZ: f64 = 1e4;

/// Draws a signal into a file.
pub(super) fn draw(path: &Path, shown: &Shown, signal: &Signal) -> Result<(), Box<dyn Error>> {
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let [name, how] = title(signal);
    area.draw(&Text::new(name, (24, 12), ("sans-serif", 20)))?;
    area.draw(&Text::new(how, (24, 36), ("sans-serif", 13).into_font().color(&BLACK.mix(0.7))))?;
    let below = area.margin(52, 0, 0, 0);
    match &signal.table {
        SignalTable::Lines { places, values, phases } => match signal.request.kind {
            // A Bode plot.
            SignalKind::TransferFunction { .. } => {
                let (above, under) = below.split_vertically(MAGNITUDES);
                lines(&above, shown, signal, places, values)?;
                phase(&under, places, phases)?;
            }
            _ => lines(&below, shown, signal, places, values)?,
        },
        SignalTable::Map { rows, columns, values } => map(&below, shown, signal, rows, columns, values)?,
    }
    area.present()?;
    Ok(())
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Returns divisor and unit for an axis with frequencies up to this one.
fn hertz(highest: f64) -> (f64, &'static str) {
    if highest >= MANY_HERTZ { (1e3, "kHz") } else { (1.0, "Hz") }
}

/// Formats a number at an axis.
pub(crate) fn tick(value: f64) -> String {
    // Removes the rounding error of the accumulated steps of the axis.
    let value: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) { format!("{value}") } else { format!("{value:e}") }
}

fn lines(
    area: &Area<'_>,
    shown: &Shown,
    signal: &Signal,
    places: &[f64],
    values: &[f64],
) -> Result<(), Box<dyn Error>> {
    let end = places.last().copied().unwrap_or(1.0);
    let (scale, unit) = hertz(end);
    // The mean is omitted: it would dominate the scale.
    let points: Vec<(f64, f64)> = places
        .iter()
        .zip(values)
        .skip(1)
        .map(|(place, value)| (place / scale, shown.value(*value).abs()))
        .collect();
    let (lowest, largest) = range(points.iter().map(|point| point.1), DECADES);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .margin_right(24)
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(0.0..end / scale, (lowest..2.0 * largest).log_scale())?;
    let what = match signal.request.kind {
        SignalKind::TransferFunction { .. } => "magnitude",
        _ if signal.request.kind.name() == "spectral_density" => "density",
        _ => "amplitude",
    };
    chart
        .configure_mesh()
        .x_desc(format!("frequency [{unit}]"))
        .y_desc(label(what, &shown.unit))
        .axis_desc_style(("sans-serif", 15))
        .label_style(("sans-serif", 13))
        .x_label_formatter(&|value| tick(*value))
        .y_label_formatter(&|value| tick(*value))
        .light_line_style(BLACK.mix(0.05))
        .bold_line_style(BLACK.mix(0.15))
        .draw()?;
    let drawn = points.iter().map(|&(place, value)| (place, value.max(lowest)));
    chart.draw_series(LineSeries::new(drawn, &BLUE))?;
    let mut named: Vec<(i32, i32)> = Vec::new();
    for [place, value] in signal.peaks.iter().take(NAMED_PEAKS) {
        let at = (place / scale, shown.value(*value).abs());
        let (x, y) = chart.backend_coord(&at);
        // Larger peaks are labelled first, and labels do not overlap.
        let free = named.iter().all(|(left, top)| (x - left).abs() > NAME[0] || (y - top).abs() > NAME[1]);
        if !(free && (lowest..=2.0 * largest).contains(&at.1)) {
            continue;
        }
        named.push((x, y));
        let name = format!("{} {unit}", number(at.0));
        let element = EmptyElement::at(at)
            + Circle::new((0, 0), 3, RED.stroke_width(1))
            + Text::new(name, (6, -16), ("sans-serif", 12));
        chart.draw_series(std::iter::once(element))?;
    }
    Ok(())
}

/// Draws the phases of a transfer function, in degrees.
fn phase(area: &Area<'_>, places: &[f64], phases: &[f64]) -> Result<(), Box<dyn Error>> {
    let end = places.last().copied().unwrap_or(1.0);
    let (scale, unit) = hertz(end);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .margin_right(24)
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(0.0..end / scale, -2.1..2.1)?;
    chart
        .configure_mesh()
        .x_desc(format!("frequency [{unit}]"))
        .y_desc("phase [deg]")
        .y_labels(5)
        .axis_desc_style(("sans-serif", 15))
        .label_style(("sans-serif", 13))
        .x_label_formatter(&|value| tick(*value))
        .y_label_formatter(&|value| tick(QUARTER * value))
        .light_line_style(BLACK.mix(0.05))
        .bold_line_style(BLACK.mix(0.15))
        .draw()?;
    let drawn = places.iter().zip(phases).map(|(place, phase)| (place / scale, phase.to_degrees() / QUARTER));
    chart.draw_series(LineSeries::new(drawn, &BLUE))?;
    Ok(())
}

/// Formats the label of an axis, with its unit.
pub(crate) fn label(what: &str, unit: &str) -> String {
    if unit.is_empty() { what.to_owned() } else { format!("{what} [{unit}]") }
}

fn map(
    area: &Area<'_>,
    shown: &Shown,
    signal: &Signal,
    rows: &[f64],
    columns: &[f64],
    values: &[Vec<f64>],
) -> Result<(), Box<dyn Error>> {
    let by_order = matches!(signal.request.kind, SignalKind::OrderMap { .. });
    // Speeds in revolutions per minute.
    let rows: Vec<f64> = rows.iter().map(|row| if by_order { row * 60.0 / TAU } else { *row }).collect();
    let (scale, unit) = if by_order { (1.0, "") } else { hertz(columns.last().copied().unwrap_or_default()) };
    let columns: Vec<f64> = columns.iter().map(|column| column / scale).collect();
    let (below, beside) = match by_order {
        true => ("speed [rpm]", "order [per turn]".to_owned()),
        false => ("time [s]", format!("frequency [{unit}]")),
    };
    let all = values.iter().flat_map(|row| row.iter().skip(1)).map(|value| shown.value(*value).abs());
    let (lowest, largest) = range(all, DECADES_OF_MAPS);
    let (picture, legend) = area.split_horizontally(SIZE.0 - LEGEND);
    let mut chart = ChartBuilder::on(&picture)
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(70)
        .build_cartesian_2d(span(&rows), span(&columns))?;
    let part = |value: f64| (value.max(lowest) / lowest).ln() / (largest / lowest).ln();
    for (index, row) in values.iter().enumerate() {
        let [left, right] = edges(&rows, index).map(|edge| edge.max(0.0));
        // Neighbours of the same colour are merged to one rectangle, which keeps files small. The
        // mean is omitted.
        let mut begin = 1;
        for column in 1..row.len() {
            let colour = shade(part(shown.value(row[column]).abs()));
            let next = row.get(column + 1).map(|value| shade(part(shown.value(*value).abs())));
            if next != Some(colour) {
                let (low, high) = (edges(&columns, begin)[0].max(0.0), edges(&columns, column)[1]);
                chart.draw_series(std::iter::once(Rectangle::new(
                    [(left, low), (right, high)],
                    colour.filled(),
                )))?;
                begin = column + 1;
            }
        }
    }
    // Drawn over the map, so that frame and ticks are visible.
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc(below)
        .y_desc(beside)
        .axis_desc_style(("sans-serif", 15))
        .label_style(("sans-serif", 13))
        .x_label_formatter(&|value| tick(*value))
        .y_label_formatter(&|value| tick(*value))
        .draw()?;
    let mut key = ChartBuilder::on(&legend)
        .margin(12)
        .margin_right(40)
        .x_label_area_size(44)
        .y_label_area_size(56)
        .build_cartesian_2d(0.0..1.0, (lowest..largest).log_scale())?;
    let steps = SHADES;
    for step in 0..steps {
        let value = |k: usize| lowest * (largest / lowest).powf(k as f64 / steps as f64);
        let colour = shade((step as f64 + 0.5) / steps as f64);
        key.draw_series(std::iter::once(Rectangle::new(
            [(0.0, value(step)), (1.0, value(step + 1))],
            colour.filled(),
        )))?;
    }
    key.configure_mesh()
        .disable_mesh()
        .x_labels(0)
        .x_desc(label("amplitude", &shown.unit))
        .axis_desc_style(("sans-serif", 13))
        .label_style(("sans-serif", 13))
        .y_label_formatter(&|value| tick(*value))
        .draw()?;
    Ok(())
}

/// Returns the bounds of one point of a map: half way to its neighbours.
fn edges(places: &[f64], index: usize) -> [f64; 2] {
    let before = if index == 0 {
        places.get(1).map_or(1.0, |next| next - places[0])
    } else {
        places[index] - places[index - 1]
    };
    let after = places.get(index + 1).map_or(before, |next| next - places[index]);
    [places[index] - 0.5 * before, places[index] + 0.5 * after]
}

/// Returns the range of an axis of a map, with zero as its lower bound.
fn span(places: &[f64]) -> std::ops::Range<f64> {
    match places.len() {
        0 => 0.0..1.0,
        count => {
            let (first, last) = (edges(places, 0), edges(places, count - 1));
            first[0].min(last[1]).max(0.0)..first[0].max(last[1])
        }
    }
}

/// Returns the range of values of a plot: some decades below the largest value.
fn range(values: impl Iterator<Item = f64>, decades: i32) -> (f64, f64) {
    let largest = values.filter(|value| value.is_finite()).fold(0.0, f64::max);
    let below = 10f64.powi(-decades);
    if largest > 0.0 { (largest * below, largest) } else { (below, 1.0) }
}

/// Number of colours of maps.
const SHADES: usize = 32;

/// Returns a colour of the scale from white over blue to dark, for `part` from 0 to 1.
fn shade(part: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 3] = [[255.0, 255.0, 255.0], [65.0, 125.0, 200.0], [20.0, 10.0, 60.0]];
    let last = (SHADES - 1) as f64;
    let step = (part.clamp(0.0, 1.0) * last).round() / (0.5 * last);
    let (from, to, passed) =
        if step < 1.0 { (STOPS[0], STOPS[1], step) } else { (STOPS[1], STOPS[2], step - 1.0) };
    let [red, green, blue] = [0, 1, 2].map(|k: usize| (from[k] + (to[k] - from[k]) * passed).round() as u8);
    RGBColor(red, green, blue)
}
