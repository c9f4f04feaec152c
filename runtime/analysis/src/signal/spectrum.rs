//! Amplitude spectra: a windowed Fourier transform, corrected so that sines show their amplitude.

use super::Uniform;
use super::uniform::FEWEST;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use realfft::RealFftPlanner;
use std::f64::consts::{PI, TAU};

/// Weights of the samples over the length of a signal (Harris, Proc. IEEE 66(1), 1978), in the periodic form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Window {
    /// All alike: exact for whole periods, as over mesh cycles; all else leaks far.
    Rectangular,
    /// For signals of unknown periods.
    #[default]
    Hann,
    /// Amplitudes right to a thousandth between lines too; lines are wide.
    FlatTop,
}

impl Window {
    /// Every window by its name.
    pub const ALL: [(&'static str, Window); 3] =
        [("rectangular", Window::Rectangular), ("hann", Window::Hann), ("flat_top", Window::FlatTop)];

    /// A window by its name.
    pub fn named(name: &str) -> Option<Window> {
        Window::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, window)| window)
    }

    /// Terms of its cosine series.
    fn terms(self) -> &'static [f64] {
        match self {
            Window::Rectangular => &[1.0],
            Window::Hann => &[0.5, 0.5],
            // ISO 18431-2.
            Window::FlatTop => &[1.0, 1.933, 1.286, 0.388, 0.0322],
        }
    }

    /// Weights of `count` samples.
    pub fn weights(self, count: usize) -> Vec<f64> {
        let weight = |k: usize| {
            let angle = TAU * k as f64 / count as f64;
            let alternating = |(n, term): (usize, &f64)| {
                let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
                sign * term * (n as f64 * angle).cos()
            };
            self.terms().iter().enumerate().map(alternating).sum()
        };
        (0..count).map(weight).collect()
    }

    /// What a long window shows of a sine of amplitude 1 that is `off` lines away: 1 on its line.
    pub fn response(self, off: f64) -> f64 {
        let nearest = off.round();
        // Between lines each term of the series has a sine by its distance; on the line of a term that term alone is seen.
        let beside = off - nearest;
        if beside.abs() < 1e-9 {
            let term = self.terms().get(nearest.abs() as usize).copied().unwrap_or(0.0);
            return if nearest == 0.0 { 1.0 } else { 0.5 * term / self.terms()[0] };
        }
        let term = |(n, term): (usize, &f64)| {
            let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * term * off / (off * off - (n * n) as f64)
        };
        let sum: f64 = self.terms().iter().enumerate().map(term).sum();
        ((PI * off).sin() / PI * sum) / self.terms()[0]
    }

    /// The width of a line that lets through as much of a noise, in lines: 1 of the rectangular window.
    pub fn noise_width(self) -> f64 {
        let (first, others) = self.terms().split_first().unwrap_or((&1.0, &[]));
        1.0 + others.iter().map(|term| 0.5 * (term / first).powi(2)).sum::<f64>()
    }
}

/// One-sided amplitudes at uniform frequencies from 0 to half of the sampling rate.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// Between lines: 1/s of a signal over time, 1 of one over turns.
    pub resolution: f64,
    /// Of each line, in the unit of the signal; the first is the mean, with its sign.
    pub amplitudes: Vec<f64>,
    /// Of each line, rad: of `cos(2 pi f t + phase)` from the first sample on. Of averages, none: all are 0.
    pub phases: Vec<f64>,
    /// How many samples it is of; an even number of them has a line at half of the sampling rate.
    pub samples: usize,
}

impl Spectrum {
    /// Of a line.
    pub fn frequency(&self, line: usize) -> f64 {
        self.resolution * line as f64
    }

    /// The power spectral density of a signal that was seen through a window, one-sided: mean square by frequency, in the unit of the signal
    /// squared by that of the resolution. Without the mean; of noise the same whatever the resolution.
    pub fn density(&self, window: Window) -> Vec<f64> {
        let width = window.noise_width() * self.resolution;
        let square = |(line, amplitude): (usize, &f64)| match line {
            0 => 0.0,
            // The line at half of the sampling rate: its sine is sampled where it is largest.
            line if 2 * line == self.samples => amplitude * amplitude / width,
            _ => 0.5 * amplitude * amplitude / width,
        };
        self.amplitudes.iter().enumerate().map(square).collect()
    }

    /// All lines.
    pub fn frequencies(&self) -> Vec<f64> {
        (0..self.amplitudes.len()).map(|line| self.frequency(line)).collect()
    }
}

/// The spectrum of a signal. Its mean is taken out before it is weighted, so that it does not leak into the lines beside it.
pub fn spectrum(signal: &Uniform, window: Window) -> Spectrum {
    padded_spectrum(signal, window, signal.values.len())
}

/// The same with lines as of a signal of at least as many samples: zeros behind it show what is between its own lines.
pub(super) fn padded_spectrum(signal: &Uniform, window: Window, lines_of: usize) -> Spectrum {
    let count = lines_of.max(signal.values.len());
    let weights = window.weights(signal.values.len());
    let gain: f64 = weights.iter().sum();
    let mean = signal.mean();
    let mut input: Vec<f64> =
        signal.values.iter().zip(&weights).map(|(value, weight)| (value - mean) * weight).collect();
    input.resize(count, 0.0);
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(count);
    let mut lines = transform.make_output_vec();
    // It fails for buffers of other lengths alone, and these are its own.
    let _ = transform.process(&mut input, &mut lines);
    let amplitude = |(line, value): (usize, &realfft::num_complex::Complex<f64>)| match line {
        0 => mean,
        // The line at half of the sampling rate has no twin.
        line if 2 * line == count => value.norm() / gain,
        _ => 2.0 * value.norm() / gain,
    };
    let amplitudes = lines.iter().enumerate().map(amplitude).collect();
    let phases = lines.iter().enumerate().map(|(line, value)| if line == 0 { 0.0 } else { value.arg() });
    let (resolution, phases) = (1.0 / (signal.step * count as f64), phases.collect());
    Spectrum { resolution, amplitudes, phases, samples: count }
}

/// The root mean square of the spectra of pieces of `count` samples that overlap by half (Welch, IEEE Trans. Audio 15(2), 1967): noise
/// evens out, and lines are as wide as a piece is short. `None` of a signal shorter than a piece, or pieces of fewer than four samples.
///
/// # Errors
/// That of the interrupt, which is asked before each piece.
pub fn averaged_spectrum(
    signal: &Uniform,
    window: Window,
    count: usize,
    interrupt: &Interrupt,
) -> Result<Option<Spectrum>, EngineError> {
    let mut found: Option<Spectrum> = None;
    // Sums over pieces: of squares, and of means.
    let (mut squares, mut means, mut spectra) = (Vec::new(), 0.0, 0.0);
    for first in pieces(signal, count) {
        interrupt.check()?;
        let spectrum = spectrum(&signal.part(first, count), window);
        squares.resize(spectrum.amplitudes.len(), 0.0);
        for (sum, amplitude) in squares.iter_mut().zip(&spectrum.amplitudes) {
            *sum += amplitude.powi(2);
        }
        means += spectrum.amplitudes[0];
        spectra += 1.0;
        found.get_or_insert(spectrum);
    }
    let Some(one) = found else { return Ok(None) };
    let mut amplitudes: Vec<f64> = squares.into_iter().map(|square: f64| (square / spectra).sqrt()).collect();
    amplitudes[0] = means / spectra;
    Ok(Some(Spectrum { phases: vec![0.0; amplitudes.len()], amplitudes, ..one }))
}

/// First samples of pieces of `count` that overlap by half.
fn pieces(signal: &Uniform, count: usize) -> impl Iterator<Item = usize> {
    pieces_every(signal, count, count / 2)
}

/// First samples of the pieces of a map. They overlap by seven eighths, so that what rises and falls within a piece is seen to, but for long
/// signals of which that would be many: those overlap less, and by half at least.
pub(super) fn pieces_of_map(signal: &Uniform, count: usize) -> impl Iterator<Item = usize> {
    let between = signal.values.len().saturating_sub(count) / MOST_PIECES;
    pieces_every(signal, count, between.max(count / 8).min(count / 2))
}

/// Pieces of a map, unless they would overlap by less than half.
const MOST_PIECES: usize = 400;

fn pieces_every(signal: &Uniform, count: usize, hop: usize) -> impl Iterator<Item = usize> {
    let (hop, length) = (hop.max(1), signal.values.len());
    (0..length).step_by(hop).take_while(move |first| count >= FEWEST && first + count <= length)
}
