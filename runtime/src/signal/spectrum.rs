//! Amplitude spectra: a windowed Fourier transform, corrected so that sines show their amplitude.

use super::Uniform;
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

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
}

impl Spectrum {
    /// Of a line.
    pub fn frequency(&self, line: usize) -> f64 {
        self.resolution * line as f64
    }

    /// All lines.
    pub fn frequencies(&self) -> Vec<f64> {
        (0..self.amplitudes.len()).map(|line| self.frequency(line)).collect()
    }
}

/// The spectrum of a signal. Its mean is taken out before it is weighted, so that it does not leak into the lines beside it.
pub fn spectrum(signal: &Uniform, window: Window) -> Spectrum {
    let count = signal.values.len();
    let weights = window.weights(count);
    let gain: f64 = weights.iter().sum();
    let mean = signal.mean();
    let mut input: Vec<f64> =
        signal.values.iter().zip(&weights).map(|(value, weight)| (value - mean) * weight).collect();
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(count);
    let mut lines = transform.make_output_vec();
    // It fails for buffers of other lengths alone, and these are its own.
    let _ = transform.process(&mut input, &mut lines);
    let last = lines.len().saturating_sub(1);
    let amplitude = |(line, value): (usize, &realfft::num_complex::Complex<f64>)| match line {
        0 => mean,
        // The line at half of the sampling rate has no twin.
        line if line == last && count.is_multiple_of(2) => value.norm() / gain,
        _ => 2.0 * value.norm() / gain,
    };
    let amplitudes = lines.iter().enumerate().map(amplitude).collect();
    let phases = lines.iter().enumerate().map(|(line, value)| if line == 0 { 0.0 } else { value.arg() });
    Spectrum { resolution: 1.0 / signal.duration(), amplitudes, phases: phases.collect() }
}

/// The root mean square of the spectra of pieces of `count` samples that overlap by half (Welch, IEEE Trans. Audio 15(2), 1967): noise
/// evens out, and lines are as wide as a piece is short. The whole signal if it is no longer than a piece.
pub fn averaged_spectrum(signal: &Uniform, window: Window, count: usize) -> Spectrum {
    let spectra: Vec<Spectrum> =
        pieces(signal, count).map(|first| spectrum(&signal.part(first, count), window)).collect();
    let Some(one) = spectra.first() else { return spectrum(signal, window) };
    let mean = |line: usize| {
        let square: f64 = spectra.iter().map(|spectrum| spectrum.amplitudes[line].powi(2)).sum();
        (square / spectra.len() as f64).sqrt()
    };
    let mut amplitudes: Vec<f64> = (0..one.amplitudes.len()).map(mean).collect();
    amplitudes[0] = spectra.iter().map(|spectrum| spectrum.amplitudes[0]).sum::<f64>() / spectra.len() as f64;
    Spectrum { resolution: one.resolution, phases: vec![0.0; amplitudes.len()], amplitudes }
}

/// First samples of pieces of `count` that overlap by half.
pub(super) fn pieces(signal: &Uniform, count: usize) -> impl Iterator<Item = usize> {
    let (hop, length) = ((count / 2).max(1), signal.values.len());
    (0..length).step_by(hop).take_while(move |first| count >= 4 && first + count <= length)
}
