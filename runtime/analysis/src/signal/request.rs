//! Requests of a model for frequency-domain results, and their evaluation after the analysis.

use super::orders::REACH;
use super::uniform::FEWEST;
use super::{
    OrderMap, Peak, Shape, Spectrogram, Spectrum, TransferFunction, Uniform, Window, averaged_spectrum,
    order_map, peaks, spectrogram, transfer_function,
};
use crate::rows::StepRow;
use calyx_model::ids::BodyId;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::TAU;

/// Quarter of a revolution, rad: largest difference between samples to which angles modulo
/// revolutions are unwrapped.
const QUARTER: f64 = 0.25 * TAU;
/// Number of reported peaks of a spectrum.
const PEAKS: usize = 8;

/// Time interval, s, including both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Start.
    pub from: f64,
    /// End; may be infinite.
    pub to: f64,
}

/// Kind of a request.
#[derive(Clone, Debug, PartialEq)]
pub enum SignalKind {
    /// Spectrum of the output.
    Spectrum {
        /// Window.
        window: Window,
        /// Length of segments whose spectra are averaged, s; `None` uses the whole signal.
        segment: Option<f64>,
        /// Scaling of the lines.
        scaling: Scaling,
    },
    /// Spectrogram: spectra of segments, over time.
    Spectrogram {
        /// Window.
        window: Window,
        /// Length of a segment, s.
        segment: f64,
    },
    /// Order map: order spectra of segments, over the speed of a shaft.
    OrderMap {
        /// Shaft whose revolutions are counted by its frame; `None` without rotation.
        shaft: Option<BodyId>,
        /// Name of the output that contains the lead of the shaft relative to its frame, rad, as a
        /// tachometer measures it.
        ahead: Option<String>,
        /// Revolutions per segment.
        revolutions: f64,
        /// Highest order.
        highest: f64,
        /// Window.
        window: Window,
    },
    /// Transfer function from an impulse at the start of the interval.
    TransferFunction {
        /// Momentum of the impulse, N s, or N m s for a moment.
        momentum: f64,
    },
}

/// Scaling of a spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scaling {
    /// Amplitudes of sines, one-sided.
    #[default]
    Amplitude,
    /// Power spectral density: mean square per frequency, one-sided.
    Density,
}

impl SignalKind {
    /// Returns the name in results.
    pub fn name(&self) -> &'static str {
        match self {
            SignalKind::Spectrum { scaling: Scaling::Density, .. } => "spectral_density",
            SignalKind::Spectrum { .. } => "spectrum",
            SignalKind::Spectrogram { .. } => "spectrogram",
            SignalKind::OrderMap { .. } => "order_map",
            SignalKind::TransferFunction { .. } => "transfer_function",
        }
    }
}

/// Request.
#[derive(Clone, Debug, PartialEq)]
pub struct SignalRequest {
    /// Name of the output.
    pub of: String,
    /// Time interval.
    pub span: Span,
    /// Highest frequency (Hz) of the result; may be infinite.
    pub highest: f64,
    /// Kind of the request.
    pub kind: SignalKind,
}

/// Numbers of a result, SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum SignalTable {
    /// One value per line.
    Lines {
        /// Frequencies, Hz.
        places: Vec<f64>,
        /// Amplitudes, or magnitudes of a transfer function.
        values: Vec<f64>,
        /// Phases, rad.
        phases: Vec<f64>,
    },
    /// Values over two variables.
    Map {
        /// Times, s, or speeds, rad/s.
        rows: Vec<f64>,
        /// Frequencies, Hz, or orders.
        columns: Vec<f64>,
        /// Values by row, then by column.
        values: Vec<Vec<f64>>,
    },
}

/// Result of a request.
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    /// The request.
    pub request: SignalRequest,
    /// Line spacing: Hz, or 1 for orders.
    pub resolution: f64,
    /// The numbers.
    pub table: SignalTable,
    /// Largest peaks: frequency (Hz) and amplitude; empty for maps.
    pub peaks: Vec<[f64; 2]>,
}

/// Evaluates a request from output number `output` in the rows of an analysis. `angle` is that of
/// the shaft in a row, rad, modulo revolutions. Named positions lie between the uniform ones and
/// are omitted.
///
/// # Errors
/// E0776: there are too few samples, in a segment or in total, or the shaft does not rotate far
/// enough; E0777: the samples are not uniform; those of the interrupt.
pub fn evaluate(
    request: &SignalRequest,
    rows: &[StepRow],
    output: usize,
    angle: impl Fn(&StepRow) -> f64,
    interrupt: &Interrupt,
) -> Result<Signal, EngineError> {
    let Span { from, to } = request.span;
    let sampled = || rows.iter().filter(|row| row.position.name.is_empty());
    let value = |row: &StepRow| row.outputs.get(output).map_or(f64::NAN, |seen| seen.value);
    // The ends have decimal digits, and times are sums of steps.
    let slack = 1e-9 * rows.last().map_or(0.0, |row| row.position.time.abs());
    let within = |row: &&StepRow| (from - slack..=to + slack).contains(&row.position.time);
    let times: Vec<f64> = sampled().filter(within).map(|row| row.position.time).collect();
    let values: Vec<f64> = sampled().filter(within).map(value).collect();
    let signal = Uniform::of(&times, &values)?;
    let map = |rows: Vec<f64>, columns: Vec<f64>, values: Vec<Vec<f64>>| {
        let shown = columns.iter().take_while(|column| request.shows(**column)).count();
        let resolution = columns.get(1).copied().unwrap_or(f64::NAN);
        let values = values.into_iter().map(|row| row[..shown.min(row.len())].to_vec()).collect();
        (resolution, SignalTable::Map { rows, columns: columns[..shown].to_vec(), values }, Vec::new())
    };
    let (resolution, table, peaks) = match &request.kind {
        SignalKind::Spectrum { window, segment, scaling } => {
            let spectrum = match segment {
                Some(segment) => {
                    averaged_spectrum(&signal, *window, segment_of(&signal, *segment)?, interrupt)?
                }
                None => None,
            };
            let spectrum = spectrum.unwrap_or_else(|| super::spectrum(&signal, *window));
            let Spectrum { resolution, mut amplitudes, phases, .. } = spectrum.clone();
            amplitudes.truncate(request.shown(resolution, amplitudes.len()));
            let mut found = peaks(&amplitudes, PEAKS, Shape::Sine(*window));
            match scaling {
                Scaling::Amplitude => lines(resolution, amplitudes, phases, found),
                Scaling::Density => {
                    let mut density = spectrum.density(*window);
                    density.truncate(amplitudes.len());
                    // A sine has no density: its peak has the height of its line.
                    for peak in &mut found {
                        peak.amplitude = density.get(peak.line.round() as usize).copied().unwrap_or_default();
                    }
                    let none = vec![0.0; density.len()];
                    lines(resolution, density, none, found)
                }
            }
        }
        SignalKind::TransferFunction { momentum } => {
            let before = sampled().take_while(|row| row.position.time < from - slack).last();
            let at_rest = before.map_or(signal.values[0], value);
            let TransferFunction { resolution, mut magnitudes, phases } =
                transfer_function(&signal, at_rest, *momentum);
            magnitudes.truncate(request.shown(resolution, magnitudes.len()));
            let found = peaks(&magnitudes, PEAKS, Shape::Resonance);
            lines(resolution, magnitudes, phases, found)
        }
        SignalKind::Spectrogram { window, segment } => {
            let Spectrogram { times, frequencies, amplitudes } =
                spectrogram(&signal, *window, segment_of(&signal, *segment)?, interrupt)?;
            map(times, frequencies, amplitudes)
        }
        SignalKind::OrderMap { revolutions, highest, window, .. } => {
            let angles = unwrapped(sampled().filter(within).map(angle));
            if angles.windows(2).any(|pair| (pair[1] - pair[0]).abs() > QUARTER) {
                return Err(EngineError::new(
                    "E0776",
                    "the shaft rotates by more than a quarter of a revolution from one sample to the next",
                    "keep more rows, or take shorter steps",
                ));
            }
            let OrderMap { speeds, orders, amplitudes } =
                order_map(&signal, &angles, *revolutions, *highest, *window, interrupt)?;
            if speeds.is_empty() {
                return Err(no_orders(&angles, *revolutions));
            }
            map(speeds, orders, amplitudes)
        }
    };
    Ok(Signal { request: request.clone(), resolution, table, peaks })
}

/// Returns the error that a shaft with these angles has no order spectrum.
fn no_orders(angles: &[f64], revolutions: f64) -> EngineError {
    let turned = angles.last().zip(angles.first()).map_or(0.0, |(last, first)| last - first);
    let goes_on = angles.windows(2).all(|pair| (pair[1] - pair[0]) * turned > 0.0);
    let (message, help) = match goes_on {
        true => (
            format!(
                "a segment of {revolutions} revolutions is longer than the signal, in which the shaft rotates {} times",
                digits(turned.abs() / TAU)
            ),
            format!(
                "reduce `revolutions`, or analyse a longer time; {REACH} samples at each end are omitted, because they have too few neighbours"
            ),
        ),
        false => (
            "the shaft stops or reverses, so its revolutions cannot be counted".to_owned(),
            "select a range in which it rotates in one direction, or another shaft".to_owned(),
        ),
    };
    EngineError::new("E0776", message, help)
}

/// Returns the number of samples in a segment of this duration (s).
///
/// # Errors
/// E0776: it is too small, or larger than the number of samples.
fn segment_of(signal: &Uniform, seconds: f64) -> Result<usize, EngineError> {
    let (count, all) = ((seconds / signal.step).round(), signal.values.len());
    let refused = |message: String, help: String| Err(EngineError::new("E0776", message, help));
    let [segment, step, whole] = [seconds, signal.step, signal.duration()].map(digits);
    if count < FEWEST as f64 {
        return refused(
            format!(
                "a segment of {segment} s has {count} samples, which are {step} s apart, and a spectrum needs at least {FEWEST}"
            ),
            format!(
                "set `segment` to at least {} s, or store more rows",
                digits(FEWEST as f64 * signal.step)
            ),
        );
    }
    if count > all as f64 {
        return refused(
            format!("a segment of {segment} s is longer than the {all} samples, which last {whole} s"),
            "reduce `segment`, or analyse a longer time".to_owned(),
        );
    }
    Ok(count as usize)
}

/// Formats a number for messages with four digits.
fn digits(number: f64) -> String {
    format!("{number:.3e}").parse::<f64>().unwrap_or(number).to_string()
}

impl SignalRequest {
    /// Returns the number of lines that are shown.
    fn shown(&self, resolution: f64, lines: usize) -> usize {
        (0..lines).take_while(|&line| self.shows(line as f64 * resolution)).count()
    }

    /// Returns whether a frequency or an order is shown, with a tolerance for the decimal digits of
    /// the highest one.
    fn shows(&self, place: f64) -> bool {
        place <= self.highest * (1.0 + 1e-9)
    }
}

/// Creates a line spectrum with its peaks in Hz.
fn lines(
    resolution: f64,
    values: Vec<f64>,
    mut phases: Vec<f64>,
    found: Vec<Peak>,
) -> (f64, SignalTable, Vec<[f64; 2]>) {
    phases.truncate(values.len());
    let peaks = found.iter().map(|Peak { line, amplitude }| [line * resolution, *amplitude]).collect();
    let places = (0..values.len()).map(|line| line as f64 * resolution).collect();
    (resolution, SignalTable::Lines { places, values, phases }, peaks)
}

/// Unwraps angles that are known modulo revolutions, with steps of less than half a revolution
/// between samples.
fn unwrapped(angles: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for angle in angles {
        let turned = all.last().map_or(angle, |last| angle - TAU * ((angle - last) / TAU).round());
        all.push(turned);
    }
    all
}
