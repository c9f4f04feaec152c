//! How a spectrum changes with time: spectra of short pieces, side by side.

use super::spectrum::pieces_of_map;
use super::{Uniform, Window, spectrum};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;

/// Amplitudes over time and frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrogram {
    /// Middles of the pieces, s.
    pub times: Vec<f64>,
    /// Of the lines, Hz.
    pub frequencies: Vec<f64>,
    /// By time, then by frequency.
    pub amplitudes: Vec<Vec<f64>>,
}

/// Spectra of pieces of `count` samples that overlap; empty where the signal is shorter than one.
///
/// # Errors
/// That of the interrupt, which is asked before each piece.
pub fn spectrogram(
    signal: &Uniform,
    window: Window,
    count: usize,
    interrupt: &Interrupt,
) -> Result<Spectrogram, EngineError> {
    let mut map = Spectrogram { times: Vec::new(), frequencies: Vec::new(), amplitudes: Vec::new() };
    for first in pieces_of_map(signal, count) {
        interrupt.check()?;
        let spectrum = spectrum(&signal.part(first, count), window);
        map.times.push(signal.start + signal.step * (first as f64 + 0.5 * (count - 1) as f64));
        map.frequencies = spectrum.frequencies();
        map.amplitudes.push(spectrum.amplitudes);
    }
    Ok(map)
}
