//! What sampled outputs say in the frequency domain: spectra, spectrograms, transfer functions, orders of a shaft.
//!
//! Everything here works on numbers alone, so it serves results of Calyx and measured ones alike. Amplitudes are one-sided and those of
//! sines: `a sin(2 pi f t)` shows `a` at `f`, whatever the window. Densities are mean squares by frequency, one-sided too. What is asked of an analysis is a [`SignalRequest`]; [`evaluate`] answers
//! it.

mod orders;
mod peaks;
mod request;
mod spectrogram;
mod spectrum;
mod transfer;
mod uniform;

pub use orders::{OrderMap, order_map, resample_by_angle};
pub use peaks::{Peak, Shape, peaks};
pub use request::{Scaling, Signal, SignalKind, SignalRequest, SignalTable, Span, evaluate};
pub use spectrogram::{Spectrogram, spectrogram};
pub use spectrum::{Spectrum, Window, averaged_spectrum, spectrum};
pub use transfer::{TransferFunction, transfer_function};
pub use uniform::Uniform;

#[cfg(test)]
mod tests;
