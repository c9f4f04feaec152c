//! What a model wants to know of its outputs in the frequency domain, and the answer once the analysis is done.

use super::{
    OrderMap, Peak, Spectrogram, Spectrum, TransferFunction, Uniform, Window, averaged_spectrum, order_map,
    peaks, spectrogram, spectrum, transfer_function,
};
use crate::error::EngineError;
use crate::results::StepRow;
use crate::scene::BodyId;
use std::f64::consts::TAU;

/// Of a turn, rad: what is known up to whole turns is followed no further from one sample to the next.
const QUARTER: f64 = 0.25 * TAU;
/// Peaks that are told of a spectrum.
const PEAKS: usize = 8;

/// From when to when, s; both ends count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Beginning.
    pub from: f64,
    /// End; may be infinite.
    pub to: f64,
}

/// What is asked of an output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SignalKind {
    /// Its spectrum.
    Spectrum {
        /// Weights.
        window: Window,
        /// Length of pieces whose spectra are averaged, s; `None` takes all as one.
        piece: Option<f64>,
    },
    /// Spectra of pieces, over time.
    Spectrogram {
        /// Weights.
        window: Window,
        /// Length of a piece, s.
        piece: f64,
    },
    /// Order spectra of pieces, over the speed of a shaft.
    OrderMap {
        /// Whose turns are counted.
        shaft: BodyId,
        /// Turns in a piece.
        turns: f64,
        /// Up to this order.
        highest: f64,
        /// Weights.
        window: Window,
    },
    /// The transfer function from a blow at the beginning of the span.
    TransferFunction {
        /// Of the blow, N s, or N m s of a moment.
        momentum: f64,
    },
}

impl SignalKind {
    /// What results call it.
    pub fn name(&self) -> &'static str {
        match self {
            SignalKind::Spectrum { .. } => "spectrum",
            SignalKind::Spectrogram { .. } => "spectrogram",
            SignalKind::OrderMap { .. } => "order_map",
            SignalKind::TransferFunction { .. } => "transfer_function",
        }
    }
}

/// A request.
#[derive(Clone, Debug, PartialEq)]
pub struct SignalRequest {
    /// The output it is of.
    pub of: String,
    /// From when to when.
    pub span: Span,
    /// Frequencies (Hz) up to which it is shown; may be infinite.
    pub highest: f64,
    /// What is asked.
    pub kind: SignalKind,
}

/// Numbers of an answer, in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum SignalTable {
    /// One value a line.
    Lines {
        /// Frequencies, Hz.
        places: Vec<f64>,
        /// Amplitudes, or magnitudes of a transfer function.
        values: Vec<f64>,
        /// rad
        phases: Vec<f64>,
    },
    /// Values over two variables.
    Map {
        /// Times, s, or speeds, rad/s.
        rows: Vec<f64>,
        /// Frequencies, Hz, or orders.
        columns: Vec<f64>,
        /// By row, then by column.
        values: Vec<Vec<f64>>,
    },
}

/// An answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    /// What was asked.
    pub request: SignalRequest,
    /// Between lines: Hz, or 1 of orders.
    pub resolution: f64,
    /// The numbers.
    pub table: SignalTable,
    /// The largest peaks: frequency (Hz) and amplitude; none of maps.
    pub peaks: Vec<[f64; 2]>,
}

/// Answers a request from the rows of an analysis, of which it takes output number `output`. `angle` is that of the shaft at a time, rad, up to
/// whole turns. Positions with a name of their own stand between the uniform ones, and are left out.
///
/// # Errors
/// E0776: there are too few samples, or the shaft does not turn so far; E0777: they are not uniform.
pub fn evaluate(
    request: &SignalRequest,
    rows: &[StepRow],
    output: usize,
    angle: impl Fn(f64) -> f64,
) -> Result<Signal, EngineError> {
    let Span { from, to } = request.span;
    let sampled = || rows.iter().filter(|row| row.position.name.is_empty());
    let value = |row: &StepRow| row.outputs.get(output).map_or(f64::NAN, |seen| seen.value);
    // Ends are given in decimal digits, and times are sums of steps.
    let slack = 1e-9 * rows.last().map_or(0.0, |row| row.position.time.abs());
    let within = |row: &&StepRow| (from - slack..=to + slack).contains(&row.position.time);
    let times: Vec<f64> = sampled().filter(within).map(|row| row.position.time).collect();
    let values: Vec<f64> = sampled().filter(within).map(value).collect();
    let signal = Uniform::of(&times, &values)?;
    let count = |seconds: f64| (seconds / signal.step).round() as usize;
    let map = |rows: Vec<f64>, columns: Vec<f64>, values: Vec<Vec<f64>>, what: &str| {
        let shown = columns.iter().take_while(|column| **column <= request.highest).count();
        let resolution = columns.get(1).copied().unwrap_or(f64::NAN);
        let values = values.into_iter().map(|row| row[..shown.min(row.len())].to_vec()).collect();
        let columns = columns[..shown].to_vec();
        match rows.is_empty() {
            true => Err(EngineError::new(
                "E0776",
                format!("{what} longer than the samples last"),
                "make the pieces shorter, or analyse a longer time",
            )),
            false => Ok((resolution, SignalTable::Map { rows, columns, values }, Vec::new())),
        }
    };
    let (resolution, table, peaks) = match request.kind {
        SignalKind::Spectrum { window, piece } => {
            let spectrum = match piece {
                Some(piece) => averaged_spectrum(&signal, window, count(piece)),
                None => spectrum(&signal, window),
            };
            let Spectrum { resolution, amplitudes, phases } = spectrum;
            lines(request, resolution, amplitudes, phases)
        }
        SignalKind::TransferFunction { momentum } => {
            let before = sampled().take_while(|row| row.position.time < from - slack).last();
            let at_rest = before.map_or(signal.values[0], value);
            let TransferFunction { resolution, magnitudes, phases } =
                transfer_function(&signal, at_rest, momentum);
            lines(request, resolution, magnitudes, phases)
        }
        SignalKind::Spectrogram { window, piece } => {
            let Spectrogram { times, frequencies, amplitudes } = spectrogram(&signal, window, count(piece));
            map(times, frequencies, amplitudes, "a piece of the spectrogram is")?
        }
        SignalKind::OrderMap { shaft: _, turns, highest, window } => {
            let angles = unwrapped(times.iter().map(|&time| angle(time)));
            if angles.windows(2).any(|pair| (pair[1] - pair[0]).abs() > QUARTER) {
                return Err(EngineError::new(
                    "E0776",
                    "the shaft turns by more than a quarter of a turn from one sample to the next",
                    "keep more rows, or take shorter steps",
                ));
            }
            let OrderMap { speeds, orders, amplitudes } = order_map(&signal, &angles, turns, highest, window);
            map(speeds, orders, amplitudes, "the turns of a piece of the order map are")?
        }
    };
    Ok(Signal { request: request.clone(), resolution, table, peaks })
}

/// What is shown of a line spectrum.
fn lines(
    request: &SignalRequest,
    resolution: f64,
    values: Vec<f64>,
    phases: Vec<f64>,
) -> (f64, SignalTable, Vec<[f64; 2]>) {
    let shown = (0..values.len()).take_while(|&line| line as f64 * resolution <= request.highest).count();
    let values = values[..shown].to_vec();
    let found = peaks(&values, PEAKS);
    let peaks = found.iter().map(|Peak { line, amplitude }| [line * resolution, *amplitude]).collect();
    let places = (0..shown).map(|line| line as f64 * resolution).collect();
    (resolution, SignalTable::Lines { places, values, phases: phases[..shown].to_vec() }, peaks)
}

/// Angles that are known up to whole turns, as they go on: from one sample to the next by less than half a turn.
fn unwrapped(angles: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for angle in angles {
        let turned = all.last().map_or(angle, |last| angle - TAU * ((angle - last) / TAU).round());
        all.push(turned);
    }
    all
}
