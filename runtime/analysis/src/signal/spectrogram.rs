//! Spectrogram: spectra of short segments of a signal, over time.

use super::spectrum::segments_of_map;
use super::{Uniform, Window, spectrum};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;

/// Amplitudes over time and frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrogram {
    /// Middles of the segments, s.
    pub times: Vec<f64>,
    /// Frequencies of the lines, Hz.
    pub frequencies: Vec<f64>,
    /// Amplitudes by time, then by frequency.
    pub amplitudes: Vec<Vec<f64>>,
}

/// Computes spectra of overlapping segments of `count` samples; empty if the signal is shorter than
/// a segment.
///
/// # Errors
/// Those of the interrupt, which is polled before each segment.
pub fn spectrogram(
    signal: &Uniform,
    window: Window,
    count: usize,
    interrupt: &Interrupt,
) -> Result<Spectrogram, EngineError> {
    let mut map = Spectrogram { times: Vec::new(), frequencies: Vec::new(), amplitudes: Vec::new() };
    for first in segments_of_map(signal, count) {
        interrupt.check()?;
        let spectrum = spectrum(&signal.part(first, count), window);
        map.times.push(signal.start + signal.step * (first as f64 + 0.5 * (count - 1) as f64));
        map.frequencies = spectrum.frequencies();
        map.amplitudes.push(spectrum.amplitudes);
    }
    Ok(map)
}
