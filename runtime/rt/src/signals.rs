//! Outputs in the frequency domain as files of the run directory: for each a table and a picture, and their peaks for people.

use crate::directory::SIGNALS;
use crate::params::shortest;
use calyx_abi::description::{ModelDescription, OutputDescription};
use calyx_abi::units::from_si;
use calyx_runtime::signal::{Signal, SignalKind, SignalTable};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::io;
use std::path::Path;

/// Of a picture, in pixels.
const SIZE: (u32, u32) = (960, 540);
/// Orders of magnitude that pictures show below the largest value.
const DECADES: i32 = 5;

/// Writes all signals of a run; nothing if there are none.
pub fn write(directory: &Path, description: &ModelDescription, signals: &[Signal]) -> io::Result<()> {
    if signals.is_empty() {
        return Ok(());
    }
    let below = directory.join(SIGNALS);
    fs::create_dir_all(&below)?;
    for (name, signal) in names(signals).iter().zip(signals) {
        let shown = Shown::of(description, signal);
        table(&below.join(format!("{name}.csv")), signal)?;
        let picture = below.join(format!("{name}.svg"));
        draw(&picture, &shown, signal).map_err(|error| io::Error::other(error.to_string()))?;
    }
    Ok(())
}

/// Names of files: of the output and of the kind, with a number where there are several.
pub fn names(signals: &[Signal]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for signal in signals {
        let name = format!("{}_{}", signal.request.of, signal.request.kind.name());
        let again = names.iter().filter(|other| other.starts_with(&name)).count();
        names.push(if again == 0 { name } else { format!("{name}_{}", again + 1) });
    }
    names
}

/// The largest peaks of each spectrum, in the units of the model.
pub fn summary(description: &ModelDescription, signals: &[Signal]) -> String {
    let mut text = String::new();
    for (name, signal) in names(signals).iter().zip(signals).filter(|(_, signal)| !signal.peaks.is_empty()) {
        let shown = Shown::of(description, signal);
        let peak =
            |[place, value]: &[f64; 2]| format!("{} {} Hz", number(shown.value(*value)), at(number(*place)));
        let peaks: Vec<String> = signal.peaks.iter().take(4).map(peak).collect();
        let unit = if shown.unit.is_empty() { String::new() } else { format!(" [{}]", shown.unit) };
        text += &format!("{name}{unit}: {}\n", peaks.join(", "));
    }
    text
}

fn at(place: String) -> String {
    format!("at {place}")
}

/// Four significant digits.
fn number(value: f64) -> String {
    shortest(format!("{value:.3e}").parse().unwrap_or(value))
}

/// A signal in the unit that the model shows its output in.
struct Shown {
    name: String,
    unit: String,
    factor: f64,
}

impl Shown {
    fn of(description: &ModelDescription, signal: &Signal) -> Shown {
        let output: Option<&OutputDescription> =
            description.outputs.iter().find(|output| output.name == signal.request.of);
        Shown {
            name: signal.request.of.clone(),
            unit: output.map(|output| output.unit.name.clone()).unwrap_or_default(),
            factor: output.map_or(1.0, |output| output.unit.factor),
        }
    }

    fn value(&self, si: f64) -> f64 {
        from_si(si, self.factor)
    }

    /// What the values are, for an axis.
    fn label(&self, kind: &SignalKind) -> String {
        let of = match kind {
            SignalKind::TransferFunction { .. } => "by N or N m",
            _ => "",
        };
        match self.unit.as_str() {
            "" => format!("{} {of}", self.name).trim_end().to_owned(),
            unit => format!("{} [{unit}] {of}", self.name).trim_end().to_owned(),
        }
    }
}

/// All in SI.
fn table(path: &Path, signal: &Signal) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(path)?;
    match &signal.table {
        SignalTable::Lines { places, values, phases } => {
            writer.write_record(["frequency", "amplitude", "phase"])?;
            for ((place, value), phase) in places.iter().zip(values).zip(phases) {
                writer.write_record([place, value, phase].map(|number| number.to_string()))?;
            }
        }
        SignalTable::Map { rows, columns, values } => {
            let [row, column] = match signal.request.kind {
                SignalKind::OrderMap { .. } => ["speed", "order"],
                _ => ["time", "frequency"],
            };
            writer.write_record([row, column, "amplitude"])?;
            for (row, values) in rows.iter().zip(values) {
                for (column, value) in columns.iter().zip(values) {
                    writer.write_record([row, column, value].map(|number| number.to_string()))?;
                }
            }
        }
    }
    writer.flush()
}

fn draw(path: &Path, shown: &Shown, signal: &Signal) -> Result<(), Box<dyn Error>> {
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    match &signal.table {
        SignalTable::Lines { places, values, .. } => lines(&area, shown, signal, places, values)?,
        SignalTable::Map { rows, columns, values } => map(&area, shown, signal, rows, columns, values)?,
    }
    area.present()?;
    Ok(())
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn lines(
    area: &Area<'_>,
    shown: &Shown,
    signal: &Signal,
    places: &[f64],
    values: &[f64],
) -> Result<(), Box<dyn Error>> {
    // The mean would press all else down.
    let points: Vec<(f64, f64)> =
        places.iter().zip(values).skip(1).map(|(place, value)| (*place, shown.value(*value).abs())).collect();
    let (lowest, largest) = range(points.iter().map(|point| point.1));
    let end = points.last().map_or(1.0, |point| point.0);
    let mut chart = ChartBuilder::on(area)
        .caption(
            format!("{}: {}", shown.name, signal.request.kind.name().replace('_', " ")),
            ("sans-serif", 20),
        )
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(80)
        .build_cartesian_2d(0.0..end, (lowest..largest).log_scale())?;
    chart
        .configure_mesh()
        .x_desc("frequency [Hz]")
        .y_desc(shown.label(&signal.request.kind))
        .y_label_formatter(&|value| format!("{value:.0e}"))
        .light_line_style(BLACK.mix(0.06))
        .draw()?;
    let drawn = points.iter().map(|&(place, value)| (place, value.max(lowest)));
    chart.draw_series(LineSeries::new(drawn, &BLUE))?;
    Ok(())
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
    // Speeds as people read them.
    let rows: Vec<f64> = rows.iter().map(|row| if by_order { row * 60.0 / TAU } else { *row }).collect();
    let [below, beside] = match by_order {
        true => ["speed [rpm]", "order [1 per turn]"],
        false => ["time [s]", "frequency [Hz]"],
    };
    let all = values.iter().flat_map(|row| row.iter().skip(1)).map(|value| shown.value(*value).abs());
    let (lowest, largest) = range(all);
    let edges = |places: &[f64], index: usize| {
        let before = if index == 0 {
            places.get(1).map_or(1.0, |next| next - places[0])
        } else {
            places[index] - places[index - 1]
        };
        let after = places.get(index + 1).map_or(before, |next| next - places[index]);
        [places[index] - 0.5 * before, places[index] + 0.5 * after]
    };
    let span = |places: &[f64]| match places.len() {
        0 => 0.0..1.0,
        count => {
            let (first, last) = (edges(places, 0), edges(places, count - 1));
            first[0].min(last[1])..first[0].max(last[1])
        }
    };
    let (picture, legend) = area.split_horizontally(SIZE.0 - 110);
    let mut chart = ChartBuilder::on(&picture)
        .caption(
            format!("{}: {}", shown.name, signal.request.kind.name().replace('_', " ")),
            ("sans-serif", 20),
        )
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(70)
        .build_cartesian_2d(span(&rows), span(columns))?;
    chart.configure_mesh().disable_mesh().x_desc(below).y_desc(beside).draw()?;
    let part = |value: f64| (value.max(lowest) / lowest).ln() / (largest / lowest).ln();
    for (index, row) in values.iter().enumerate() {
        let [left, right] = edges(&rows, index);
        // Neighbours of one colour are one rectangle: pictures stay small.
        let mut begin = 0;
        for column in 0..row.len() {
            let colour = shade(part(shown.value(row[column]).abs()));
            let next = row.get(column + 1).map(|value| shade(part(shown.value(*value).abs())));
            if next != Some(colour) {
                let (low, high) = (edges(columns, begin)[0], edges(columns, column)[1]);
                chart.draw_series(std::iter::once(Rectangle::new(
                    [(left, low), (right, high)],
                    colour.filled(),
                )))?;
                begin = column + 1;
            }
        }
    }
    let mut key = ChartBuilder::on(&legend)
        .margin(12)
        .margin_top(40)
        .x_label_area_size(44)
        .y_label_area_size(60)
        .build_cartesian_2d(0.0..1.0, (lowest..largest).log_scale())?;
    key.configure_mesh()
        .disable_mesh()
        .x_labels(0)
        .x_desc(if shown.unit.is_empty() { "1" } else { &shown.unit })
        .y_label_formatter(&|value| format!("{value:.0e}"))
        .draw()?;
    let steps = 64;
    for step in 0..steps {
        let value = |k: usize| lowest * (largest / lowest).powf(k as f64 / steps as f64);
        let colour = shade((step as f64 + 0.5) / steps as f64);
        key.draw_series(std::iter::once(Rectangle::new(
            [(0.0, value(step)), (1.0, value(step + 1))],
            colour.filled(),
        )))?;
    }
    Ok(())
}

/// What a picture shows: some decades below the largest value.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let largest = values.filter(|value| value.is_finite()).fold(0.0, f64::max);
    if largest > 0.0 { (largest * 10f64.powi(-DECADES), largest * 1.2) } else { (1e-5, 1.0) }
}

/// From white over blue to dark: `part` from 0 to 1, in 32 steps.
fn shade(part: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 3] = [[255.0, 255.0, 255.0], [65.0, 125.0, 200.0], [20.0, 10.0, 60.0]];
    let step = (part.clamp(0.0, 1.0) * 31.0).round() / 15.5;
    let (from, to, passed) =
        if step < 1.0 { (STOPS[0], STOPS[1], step) } else { (STOPS[1], STOPS[2], step - 1.0) };
    let [red, green, blue] = [0, 1, 2].map(|k: usize| (from[k] + (to[k] - from[k]) * passed).round() as u8);
    RGBColor(red, green, blue)
}
