//! Computed order tracking: a signal over time is resampled over the angle of a shaft, so its
//! spectrum is in events per revolution.
//!
//! The angle of the shaft, known at every sample, replaces the pulses of a tachometer.

use super::spectrum::{padded_spectrum, segments_of_map};
use super::{Uniform, Window};
use calyx_numerics::error::EngineError;
use calyx_numerics::interpolation::lagrange_polynomial;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::{PI, TAU};

/// Number of samples on either side for the interpolation between samples.
pub(super) const REACH: isize = 24;
/// Shape parameter of the Kaiser window over them: the passband up to 0.4 of the sampling rate is
/// accurate to a few millionths.
const KAISER: f64 = 12.0;
/// Number of points of the polynomial that interpolates the angle, which is smooth.
const STENCIL: usize = 6;

/// Number of candidates for the samples per revolution. It suffices for segments that are multiples
/// of 1/64 of a revolution.
const PARTS: u32 = 64;

/// Amplitudes over speed and order.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderMap {
    /// Mean speeds of the segments, rad/s, in order of time.
    pub speeds: Vec<f64>,
    /// Orders: events per revolution of the shaft.
    pub orders: Vec<f64>,
    /// Amplitudes by speed, then by order.
    pub amplitudes: Vec<Vec<f64>>,
}

/// Computes order spectra of overlapping segments of `revolutions` revolutions. `angles` (rad) are
/// those of the shaft at the samples, monotonic. Empty if the shaft rotates by less.
///
/// Every integer order has a line, on which a sine of that order shows its amplitude. For segments
/// with a fractional number of revolutions the lines are those of the next integer.
///
/// # Errors
/// Those of the interrupt, which is polled before each segment, also for the memory of its lines.
pub fn order_map(
    signal: &Uniform,
    angles: &[f64],
    revolutions: f64,
    highest: f64,
    window: Window,
    interrupt: &Interrupt,
) -> Result<OrderMap, EngineError> {
    let mut map = OrderMap { speeds: Vec::new(), orders: Vec::new(), amplitudes: Vec::new() };
    let Some((by_angle, times)) = resample_by_angle(signal, angles, highest, revolutions) else {
        return Ok(map);
    };
    let a_turn = (TAU / by_angle.step).round();
    let (count, lines_of) = ((revolutions * a_turn).round() as usize, (revolutions.ceil() * a_turn) as usize);
    for first in segments_of_map(&by_angle, count) {
        let _room = interrupt.reserve_memory(BYTES_PER_LINE * lines_of.max(count) as u64)?;
        let spectrum = padded_spectrum(&by_angle.part(first, count), window, lines_of);
        // The highest order is a multiple of the line spacing more often than its digits show.
        let lines = (highest / (spectrum.resolution * TAU) + 1e-9).floor() as usize + 1;
        let shown = lines.min(spectrum.amplitudes.len());
        map.speeds.push(by_angle.step * (count - 1) as f64 / (times[first + count - 1] - times[first]));
        map.orders = (0..shown).map(|line| spectrum.frequency(line) * TAU).collect();
        map.amplitudes.push(spectrum.amplitudes[..shown].to_vec());
    }
    Ok(map)
}

/// Memory of a segment per padded sample, bytes: the samples, half as many complex lines, their
/// amplitudes and phases.
const BYTES_PER_LINE: u64 = 32;

/// Resamples the signal at equal steps of the shaft's angle (rad), in its sense of rotation; also
/// returns the times (s) of these samples. The number per revolution resolves orders up to
/// `highest`, is at least that of the original samples, and gives an integer number of samples in
/// segments of `revolutions` revolutions if possible. A few samples at both ends are omitted,
/// because they have no neighbours. `None` if the shaft is at rest or reverses, or there are too
/// few samples.
pub fn resample_by_angle(
    signal: &Uniform,
    angles: &[f64],
    highest: f64,
    revolutions: f64,
) -> Option<(Uniform, Vec<f64>)> {
    let count = signal.values.len().min(angles.len());
    let margin = REACH as usize;
    let sense = (angles.last()? - angles.first()?).signum();
    let turned: Vec<f64> = angles[..count].iter().map(|angle| sense * (angle - angles[0])).collect();
    if count <= 2 * margin + STENCIL || turned.windows(2).any(|pair| pair[1] <= pair[0]) {
        return None;
    }
    let slowest = turned.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    let (first, last) = (turned[margin], turned[count - 1 - margin]);
    // Avoid aliasing at the lowest speed, but limit the number of samples to what can be resolved.
    let enough = (2.56 * highest).max(TAU / slowest).min(count as f64 * 64.0 * TAU / (last - first)).ceil();
    let whole = |a_turn: f64| (revolutions * a_turn - (revolutions * a_turn).round()).abs() < 1e-9;
    let a_turn = (0..PARTS).map(|more| enough + f64::from(more)).find(|more| whole(*more)).unwrap_or(enough);
    let step = TAU / a_turn;
    let samples = ((last - first) / step).floor() as usize + 1;
    let mut at = margin;
    let mut values = Vec::with_capacity(samples);
    let mut times = Vec::with_capacity(samples);
    for k in 0..samples {
        let angle = first + k as f64 * step;
        while at + 1 < count && turned[at + 1] <= angle {
            at += 1;
        }
        let place = inverse(&turned[..count], at, angle);
        values.push(between(&signal.values[..count], place));
        times.push(signal.start + place * signal.step);
    }
    Some((Uniform { start: sense * first + angles[0], step, values }, times))
}

/// Returns the fractional sample index, between samples `at` and the next, at which an increasing
/// smooth quantity has a value.
fn inverse(values: &[f64], at: usize, wanted: f64) -> f64 {
    let first = at.saturating_sub(STENCIL / 2 - 1).min(values.len() - STENCIL);
    let around = &values[first..first + STENCIL];
    let mut place = at as f64;
    let next = values.get(at + 1).copied().unwrap_or(values[at]);
    if next > values[at] {
        place += (wanted - values[at]) / (next - values[at]);
    }
    // Secant iteration on the interpolating polynomial, which is nearly linear.
    for _ in 0..4 {
        let [here, other_loads] = [0.0, 1e-3].map(|by| interpolated(around, place + by - first as f64));
        place -= (here - wanted) * 1e-3 / (other_loads - here);
    }
    place
}

/// Evaluates the polynomial through samples at 0, 1, 2 ...
fn interpolated(values: &[f64], at: f64) -> f64 {
    let points: [f64; STENCIL] = std::array::from_fn(|k| k as f64);
    let term = |(k, value): (usize, &f64)| value * lagrange_polynomial(&points, k, at).0;
    values.iter().enumerate().map(term).sum()
}

/// Interpolates a band-limited signal between its samples by a Kaiser-windowed sinc with weights
/// that add up to one.
fn between(values: &[f64], place: f64) -> f64 {
    let nearest = place.round() as isize;
    let (mut sum, mut weights) = (0.0, 0.0);
    for k in nearest - REACH..=nearest + REACH {
        let Some(value) = usize::try_from(k).ok().and_then(|k| values.get(k)) else { continue };
        let off = place - k as f64;
        let inside = 1.0 - (off / (REACH as f64 + 0.5)).powi(2);
        let sinc = if off == 0.0 { 1.0 } else { (PI * off).sin() / (PI * off) };
        let weight = sinc * bessel(KAISER * inside.max(0.0).sqrt());
        sum += weight * value;
        weights += weight;
    }
    sum / weights
}

/// Computes the modified Bessel function of the first kind and order 0 by its series.
fn bessel(x: f64) -> f64 {
    let (mut sum, mut term, quarter) = (1.0, 1.0, 0.25 * x * x);
    for k in 1..60 {
        term *= quarter / f64::from(k * k);
        sum += term;
        if term < 1e-17 * sum {
            break;
        }
    }
    sum
}
