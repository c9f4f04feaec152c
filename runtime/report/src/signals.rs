//! Outputs in the frequency domain: a table and a plot of each in the run directory, their
//! description in `run.json`, and a summary of their peaks.

mod plot;

pub(crate) use plot::{label, tick};

use crate::directory::SIGNALS;
use calyx_abi::description::{ModelDescription, OutputDescription};
use calyx_abi::units::{from_si, shortest};
use calyx_runtime::signal::{Scaling, Signal, SignalKind, SignalTable, Window};
use serde_json::{Value, json};
use std::fs;
use std::io;
use std::path::Path;

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
        let path = below.join(format!("{name}.svg"));
        plot::draw(&path, &shown, signal).map_err(|error| io::Error::other(error.to_string()))?;
    }
    Ok(())
}

/// Returns the description of the signals in `run.json`: output and kind of each, its files below
/// [`SIGNALS`], and its peaks, in SI.
pub fn list(description: &ModelDescription, signals: &[Signal]) -> Value {
    let entry = |(name, signal): (&String, &Signal)| {
        let peak = |[frequency, value]: &[f64; 2]| json!({ "frequency": frequency, "value": value });
        let unit = output(description, signal).map_or("", |output| &output.si);
        json!({
            "output": signal.request.of,
            "kind": signal.request.kind.name(),
            "unit": signal_unit(&signal.request.kind, unit),
            "resolution": signal.resolution,
            "table": format!("{SIGNALS}/{name}.csv"),
            "plot": format!("{SIGNALS}/{name}.svg"),
            "peaks": signal.peaks.iter().map(peak).collect::<Vec<_>>(),
        })
    };
    names(signals).iter().zip(signals).map(entry).collect()
}

/// Returns file names: name of the output and the kind, with a number to make them unique.
pub fn names(signals: &[Signal]) -> Vec<String> {
    let own = |signal: &Signal| format!("{}_{}", signal.request.of, signal.request.kind.name());
    let numbered = |(index, signal): (usize, &Signal)| {
        let name = own(signal);
        match signals[..index].iter().filter(|other| own(other) == name).count() {
            0 => name,
            before => format!("{name}_{}", before + 1),
        }
    };
    signals.iter().enumerate().map(numbered).collect()
}

/// Returns the file names of all signals, relative to the run directory.
pub fn files(signals: &[Signal]) -> Vec<String> {
    let of = |name: String| ["csv", "svg"].map(|ending| format!("{SIGNALS}/{name}.{ending}"));
    names(signals).into_iter().flat_map(of).collect()
}

/// Returns true if a run of this model may write a file of this name into [`SIGNALS`].
pub fn is_name_of_a_run(description: &ModelDescription, file: &str) -> bool {
    let stem = file.strip_suffix(".csv").or_else(|| file.strip_suffix(".svg"));
    stem.is_some_and(|stem| {
        let of = |output: &OutputDescription| {
            stem.strip_prefix(output.name.as_str()).is_some_and(|rest| rest.starts_with('_'))
        };
        description.outputs.iter().any(of)
    })
}

/// Formats the largest peaks of each spectrum in the units of the model.
pub fn summary(description: &ModelDescription, signals: &[Signal]) -> String {
    let mut text = String::new();
    for (name, signal) in names(signals).iter().zip(signals).filter(|(_, signal)| !signal.peaks.is_empty()) {
        let shown = Shown::of(description, signal);
        let peak =
            |[place, value]: &[f64; 2]| format!("{} at {} Hz", number(shown.value(*value)), number(*place));
        let peaks: Vec<String> = signal.peaks.iter().take(4).map(peak).collect();
        let unit = if shown.unit.is_empty() { String::new() } else { format!(" [{}]", shown.unit) };
        text += &format!("{name}{unit}: {}\n", peaks.join(", "));
    }
    text
}

/// Formats a number with four significant digits.
fn number(value: f64) -> String {
    shortest(format!("{value:.3e}").parse().unwrap_or(value))
}

fn output<'a>(description: &'a ModelDescription, signal: &Signal) -> Option<&'a OutputDescription> {
    description.outputs.iter().find(|output| output.name == signal.request.of)
}

/// Returns the unit of the values of a signal, from the unit of its output.
fn signal_unit(kind: &SignalKind, unit: &str) -> String {
    let whole =
        |unit: &str| if unit.contains(['*', '/', '^', ' ']) { format!("({unit})") } else { unit.to_owned() };
    match kind {
        SignalKind::Spectrum { scaling: Scaling::Density, .. } => match unit {
            "" | "1" => "1/Hz".to_owned(),
            unit => format!("{}^2/Hz", whole(unit)),
        },
        SignalKind::TransferFunction { .. } => match unit {
            "" => "1 per N or N*m".to_owned(),
            unit => format!("{unit} per N or N*m"),
        },
        _ => unit.to_owned(),
    }
}

/// A signal in the unit in which the model shows its output.
struct Shown {
    unit: String,
    factor: f64,
}

impl Shown {
    fn of(description: &ModelDescription, signal: &Signal) -> Shown {
        let output = output(description, signal);
        let factor = output.map_or(1.0, |output| output.unit.factor);
        let squared = matches!(signal.request.kind, SignalKind::Spectrum { scaling: Scaling::Density, .. });
        Shown {
            unit: signal_unit(&signal.request.kind, output.map_or("", |output| &output.unit.name)),
            factor: if squared { factor * factor } else { factor },
        }
    }

    fn value(&self, si: f64) -> f64 {
        from_si(si, self.factor)
    }
}

/// Returns title and subtitle of a plot: the kind of the signal, and the parameters needed to
/// interpret it.
fn title(signal: &Signal) -> [String; 2] {
    let seen = |window: &Window| {
        let name = Window::ALL.iter().find(|(_, known)| known == window).map_or("", |(name, _)| name);
        // Capitalized: named after von Hann.
        let name = if *window == Window::Hann { "Hann".to_owned() } else { name.replace('_', " ") };
        format!("{name} window")
    };
    let name = signal.request.kind.name().replace('_', " ");
    let apart = match signal.request.kind {
        SignalKind::OrderMap { .. } => format!("order lines every {}", number(signal.resolution)),
        _ => format!("lines every {} Hz", number(signal.resolution)),
    };
    let how = match &signal.request.kind {
        SignalKind::Spectrum { window, segment: Some(segment), .. } => {
            format!("{}, averaged over segments of {} s", seen(window), number(*segment))
        }
        SignalKind::Spectrum { window, .. } => seen(window),
        SignalKind::Spectrogram { window, segment } => {
            format!("{}, segments of {} s", seen(window), number(*segment))
        }
        SignalKind::OrderMap { window, revolutions, .. } => {
            format!("{}, segments of {} revolutions", seen(window), number(*revolutions))
        }
        SignalKind::TransferFunction { .. } => "from the response to an impulse".to_owned(),
    };
    [format!("{}: {name}", signal.request.of), format!("{how}, {apart}")]
}

/// Writes the table of a signal; all columns in SI.
fn table(path: &Path, signal: &Signal) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(path)?;
    match &signal.table {
        SignalTable::Lines { places, values, phases } => {
            let density =
                matches!(signal.request.kind, SignalKind::Spectrum { scaling: Scaling::Density, .. });
            // A power spectral density has no phase.
            let columns = if density { 2 } else { 3 };
            let value = if density { "density" } else { "amplitude" };
            writer.write_record(&["frequency", value, "phase"][..columns])?;
            for ((place, value), phase) in places.iter().zip(values).zip(phases) {
                writer.write_record(&[place, value, phase].map(|number| number.to_string())[..columns])?;
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
