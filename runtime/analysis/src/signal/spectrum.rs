//! Amplitude spectra: windowed Fourier transform, scaled to the amplitudes of sines.

use super::Uniform;
use super::uniform::FEWEST;
use calyx_numerics::error::EngineError;
use calyx_numerics::fourier::real_transform;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::{PI, TAU};

/// Window: weights of the samples over the length of a signal (Harris, Proc. IEEE 66(1), 1978), in
/// the periodic form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Window {
    /// Rectangular: exact for whole periods, as over mesh cycles; otherwise with strong leakage.
    Rectangular,
    /// Hann: for signals of unknown periods.
    #[default]
    Hann,
    /// Flat top: amplitudes between lines are accurate to a thousandth; lines are wide.
    FlatTop,
}

impl Window {
    /// All windows by name.
    pub const ALL: [(&'static str, Window); 3] =
        [("rectangular", Window::Rectangular), ("hann", Window::Hann), ("flat_top", Window::FlatTop)];

    /// Returns a window by its name.
    pub fn named(name: &str) -> Option<Window> {
        Window::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, window)| window)
    }

    /// Returns the coefficients of its cosine series.
    fn terms(self) -> &'static [f64] {
        match self {
            Window::Rectangular => &[1.0],
            Window::Hann => &[0.5, 0.5],
            // ISO 18431-2.
            Window::FlatTop => &[1.0, 1.933, 1.286, 0.388, 0.0322],
        }
    }

    /// Returns the weights of `count` samples.
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

    /// Returns the response of a long window to a sine of amplitude 1 at a distance of `off` lines:
    /// 1 on its line.
    pub fn response(self, off: f64) -> f64 {
        let nearest = off.round();
        // Between lines each term of the series has a sine divided by its distance; on the line of
        // a term only that term contributes.
        let other_loads = off - nearest;
        if other_loads.abs() < 1e-9 {
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

    /// Returns the equivalent noise bandwidth, in lines: 1 for the rectangular window.
    pub fn noise_width(self) -> f64 {
        let (first, others) = self.terms().split_first().unwrap_or((&1.0, &[]));
        1.0 + others.iter().map(|term| 0.5 * (term / first).powi(2)).sum::<f64>()
    }
}

/// One-sided amplitudes at uniform frequencies from 0 to half of the sampling rate.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// Line spacing: 1/s for a signal over time, 1 for one over revolutions.
    pub resolution: f64,
    /// Amplitudes by line, in the unit of the signal; the first is the signed mean.
    pub amplitudes: Vec<f64>,
    /// Phases by line, rad: of `cos(2 pi f t + phase)` from the first sample. All are 0 for
    /// averaged spectra.
    pub phases: Vec<f64>,
    /// Number of samples; an even number has a line at half of the sampling rate.
    pub samples: usize,
}

impl Spectrum {
    /// Returns the frequency of a line.
    pub fn frequency(&self, line: usize) -> f64 {
        self.resolution * line as f64
    }

    /// Returns the one-sided power spectral density of a signal seen through a window: mean square
    /// per frequency, in the squared unit of the signal divided by that of the resolution. Without
    /// the mean; independent of the resolution for noise.
    pub fn density(&self, window: Window) -> Vec<f64> {
        let width = window.noise_width() * self.resolution;
        let square = |(line, amplitude): (usize, &f64)| match line {
            0 => 0.0,
            // The line at half of the sampling rate: its cosine is sampled at its extremes.
            line if 2 * line == self.samples => amplitude * amplitude / width,
            _ => 0.5 * amplitude * amplitude / width,
        };
        self.amplitudes.iter().enumerate().map(square).collect()
    }

    /// Returns the frequencies of all lines.
    pub fn frequencies(&self) -> Vec<f64> {
        (0..self.amplitudes.len()).map(|line| self.frequency(line)).collect()
    }
}

/// Computes the spectrum of a signal. The mean is subtracted before windowing, so that it does not
/// leak into neighbouring lines.
pub fn spectrum(signal: &Uniform, window: Window) -> Spectrum {
    padded_spectrum(signal, window, signal.values.len())
}

/// Computes the spectrum with zero padding to at least this number of samples, which interpolates
/// between lines.
pub(super) fn padded_spectrum(signal: &Uniform, window: Window, lines_of: usize) -> Spectrum {
    let count = lines_of.max(signal.values.len());
    let weights = window.weights(signal.values.len());
    let gain: f64 = weights.iter().sum();
    let mean = signal.mean();
    let mut input: Vec<f64> =
        signal.values.iter().zip(&weights).map(|(value, weight)| (value - mean) * weight).collect();
    input.resize(count, 0.0);
    let lines = real_transform(&mut input);
    let amplitudes = lines.iter().map(|value| value.norm() / gain).enumerate();
    let amplitudes = amplitudes.map(|(line, amplitude)| match line {
        0 => mean,
        // The line at half of the sampling rate has no conjugate.
        line if 2 * line == count => amplitude,
        _ => 2.0 * amplitude,
    });
    let amplitudes = amplitudes.collect();
    let phases = lines.iter().enumerate().map(|(line, value)| if line == 0 { 0.0 } else { value.arg() });
    let (resolution, phases) = (1.0 / (signal.step * count as f64), phases.collect());
    Spectrum { resolution, amplitudes, phases, samples: count }
}

/// Computes the root mean square of the spectra of segments of `count` samples that overlap by half
/// (Welch, IEEE Trans. Audio 15(2), 1967). Averaging reduces noise; short segments have wide lines.
/// `None` for a signal shorter than a segment, or segments of fewer than four samples.
///
/// # Errors
/// Those of the interrupt, which is polled before each segment.
pub fn averaged_spectrum(
    signal: &Uniform,
    window: Window,
    count: usize,
    interrupt: &Interrupt,
) -> Result<Option<Spectrum>, EngineError> {
    let mut found: Option<Spectrum> = None;
    // Sums over segments: of squares, and of means.
    let (mut squares, mut means, mut spectra) = (Vec::new(), 0.0, 0.0);
    for first in segments(signal, count) {
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

/// Returns the first samples of segments of `count` that overlap by half.
fn segments(signal: &Uniform, count: usize) -> impl Iterator<Item = usize> {
    segments_every(signal, count, count / 2)
}

/// Returns the first samples of the segments of a map. They overlap by seven eighths, to resolve
/// changes within a segment; in long signals with many segments they overlap less, but at least by
/// half.
pub(super) fn segments_of_map(signal: &Uniform, count: usize) -> impl Iterator<Item = usize> {
    let between = signal.values.len().saturating_sub(count) / MOST_PIECES;
    segments_every(signal, count, between.max(count / 8).min(count / 2))
}

/// Maximum number of segments of a map, unless the overlap would be less than half.
const MOST_PIECES: usize = 400;

fn segments_every(signal: &Uniform, count: usize, hop: usize) -> impl Iterator<Item = usize> {
    let (hop, length) = (hop.max(1), signal.values.len());
    (0..length).step_by(hop).take_while(move |first| count >= FEWEST && first + count <= length)
}
