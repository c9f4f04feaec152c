//! What a model wants to know of its outputs in the frequency domain, and the answer once the analysis is done.

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
#[derive(Clone, Debug, PartialEq)]
pub enum SignalKind {
    /// Its spectrum.
    Spectrum {
        /// Weights.
        window: Window,
        /// Length of pieces whose spectra are averaged, s; `None` takes all as one.
        piece: Option<f64>,
        /// What the values of lines are.
        scaling: Scaling,
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
        /// Whose turns are counted: those of its frame; `None` of what does not turn.
        shaft: Option<BodyId>,
        /// The output by which the shaft is ahead of its frame, rad, as a tachometer sees it.
        ahead: Option<String>,
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

/// What the values of a spectrum are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scaling {
    /// Of sines, one-sided.
    #[default]
    Amplitude,
    /// Mean square by frequency, one-sided: the power spectral density.
    Density,
}

impl SignalKind {
    /// What results call it.
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

/// Answers a request from the rows of an analysis, of which it takes output number `output`. `angle` is that of the shaft in a row, rad, up to
/// whole turns. Positions with a name of their own stand between the uniform ones, and are left out.
///
/// # Errors
/// E0776: there are too few samples, in a piece or in all, or the shaft does not turn so far; E0777: they are not uniform;
/// that of the interrupt.
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
    // Ends are given in decimal digits, and times are sums of steps.
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
        SignalKind::Spectrum { window, piece, scaling } => {
            let spectrum = match piece {
                Some(piece) => averaged_spectrum(&signal, *window, piece_of(&signal, *piece)?, interrupt)?,
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
                    // A sine has no density: its peak is as high as its line.
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
        SignalKind::Spectrogram { window, piece } => {
            let Spectrogram { times, frequencies, amplitudes } =
                spectrogram(&signal, *window, piece_of(&signal, *piece)?, interrupt)?;
            map(times, frequencies, amplitudes)
        }
        SignalKind::OrderMap { turns, highest, window, .. } => {
            let angles = unwrapped(sampled().filter(within).map(angle));
            if angles.windows(2).any(|pair| (pair[1] - pair[0]).abs() > QUARTER) {
                return Err(EngineError::new(
                    "E0776",
                    "the shaft turns by more than a quarter of a turn from one sample to the next",
                    "keep more rows, or take shorter steps",
                ));
            }
            let OrderMap { speeds, orders, amplitudes } =
                order_map(&signal, &angles, *turns, *highest, *window, interrupt)?;
            if speeds.is_empty() {
                return Err(no_orders(&angles, *turns));
            }
            map(speeds, orders, amplitudes)
        }
    };
    Ok(Signal { request: request.clone(), resolution, table, peaks })
}

/// Why a shaft with these angles shows no orders.
fn no_orders(angles: &[f64], turns: f64) -> EngineError {
    let turned = angles.last().zip(angles.first()).map_or(0.0, |(last, first)| last - first);
    let goes_on = angles.windows(2).all(|pair| (pair[1] - pair[0]) * turned > 0.0);
    let (message, help) = match goes_on {
        true => (
            format!(
                "a piece of {turns} turns is longer than what the samples show: the shaft turns {} times in them",
                digits(turned.abs() / TAU)
            ),
            format!(
                "take fewer `turns`, or analyse a longer time; at both ends {REACH} samples are left out for want of neighbours"
            ),
        ),
        false => (
            "the shaft rests or turns back, so that nobody can count its turns".to_owned(),
            "take a range in which it turns one way, or another shaft".to_owned(),
        ),
    };
    EngineError::new("E0776", message, help)
}

/// Samples in a piece of so many seconds.
///
/// # Errors
/// E0776: they are too few, or more than there are.
fn piece_of(signal: &Uniform, seconds: f64) -> Result<usize, EngineError> {
    let (count, all) = ((seconds / signal.step).round(), signal.values.len());
    let refused = |message: String, help: String| Err(EngineError::new("E0776", message, help));
    let [piece, step, whole] = [seconds, signal.step, signal.duration()].map(digits);
    if count < FEWEST as f64 {
        return refused(
            format!(
                "a piece of {piece} s has {count} samples, which are {step} s apart, and a spectrum needs at least {FEWEST}"
            ),
            format!("take pieces of at least {} s, or keep more rows", digits(FEWEST as f64 * signal.step)),
        );
    }
    if count > all as f64 {
        return refused(
            format!("a piece of {piece} s is longer than the {all} samples, which last {whole} s"),
            "make the pieces shorter, or analyse a longer time".to_owned(),
        );
    }
    Ok(count as usize)
}

/// A number as messages show it: four digits.
fn digits(number: f64) -> String {
    format!("{number:.3e}").parse::<f64>().unwrap_or(number).to_string()
}

impl SignalRequest {
    /// How many lines of so many are shown.
    fn shown(&self, resolution: f64, lines: usize) -> usize {
        (0..lines).take_while(|&line| self.shows(line as f64 * resolution)).count()
    }

    /// Whether a frequency or an order is shown: the highest one is given in decimal digits.
    fn shows(&self, place: f64) -> bool {
        place <= self.highest * (1.0 + 1e-9)
    }
}

/// A line spectrum, and its peaks in Hz.
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

/// Angles that are known up to whole turns, as they go on: from one sample to the next by less than half a turn.
fn unwrapped(angles: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for angle in angles {
        let turned = all.last().map_or(angle, |last| angle - TAU * ((angle - last) / TAU).round());
        all.push(turned);
    }
    all
}
