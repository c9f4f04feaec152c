//! Frequency-domain analysis of sampled outputs: spectra, spectrograms, transfer functions, orders
//! of a shaft.
//!
//! All functions work on plain numbers, so they serve computed and measured signals alike.
//! Amplitudes are one-sided and those of sines: `a sin(2 pi f t)` has the amplitude `a` at `f`, for
//! any window. Densities are one-sided mean squares per frequency. A [`SignalRequest`] describes a
//! request of an analysis; [`evaluate`] computes it.
//!
//! See `docs/theory/signals.md`.

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
