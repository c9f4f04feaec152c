//! Computed order tracking: a signal over time becomes one over the angle of a shaft, and its spectrum counts events a turn.
//!
//! What a tachometer does with pulses the angle of the shaft does here, which is known at every sample.

use super::spectrum::{padded_spectrum, pieces_of_map};
use super::{Uniform, Window};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::{PI, TAU};

/// Samples on either side that a value between samples is made of.
pub(super) const REACH: isize = 24;
/// Shape of Kaiser's window over them: what it lets through is right to a few millionths up to 0.4 of the sampling rate.
const KAISER: f64 = 12.0;
/// Points of the polynomial by which the angle is found between samples: it is smooth.
const STENCIL: usize = 6;

/// Parts of a turn that pieces may be whole numbers of.
const PARTS: u32 = 64;

/// Amplitudes over speed and order.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderMap {
    /// Mean speeds of the pieces, rad/s, in order of time.
    pub speeds: Vec<f64>,
    /// Events a turn of the shaft.
    pub orders: Vec<f64>,
    /// By speed, then by order.
    pub amplitudes: Vec<Vec<f64>>,
}

/// Order spectra of pieces of `turns` turns, which overlap. `angles` (rad) are those of the shaft at the samples, going one way.
/// Empty where the shaft does not turn so far.
///
/// Every whole order has a line, on which a sine of that order shows its amplitude: of pieces that are no whole number of turns the lines are
/// those of the next one.
///
/// # Errors
/// That of the interrupt, which is asked before each piece, and whether there is memory for its lines.
pub fn order_map(
    signal: &Uniform,
    angles: &[f64],
    turns: f64,
    highest: f64,
    window: Window,
    interrupt: &Interrupt,
) -> Result<OrderMap, EngineError> {
    let mut map = OrderMap { speeds: Vec::new(), orders: Vec::new(), amplitudes: Vec::new() };
    let Some((by_angle, times)) = resample_by_angle(signal, angles, highest, turns) else {
        return Ok(map);
    };
    let a_turn = (TAU / by_angle.step).round();
    let (count, lines_of) = ((turns * a_turn).round() as usize, (turns.ceil() * a_turn) as usize);
    for first in pieces_of_map(&by_angle, count) {
        let _room = interrupt.room_for(BYTES_PER_LINE * lines_of.max(count) as u64)?;
        let spectrum = padded_spectrum(&by_angle.part(first, count), window, lines_of);
        // The highest order is a whole number of lines more often than its digits say.
        let lines = (highest / (spectrum.resolution * TAU) + 1e-9).floor() as usize + 1;
        let shown = lines.min(spectrum.amplitudes.len());
        map.speeds.push(by_angle.step * (count - 1) as f64 / (times[first + count - 1] - times[first]));
        map.orders = (0..shown).map(|line| spectrum.frequency(line) * TAU).collect();
        map.amplitudes.push(spectrum.amplitudes[..shown].to_vec());
    }
    Ok(map)
}

/// Bytes that a piece takes for each sample with its zeros: the samples, half as many complex lines, their amplitudes and phases.
const BYTES_PER_LINE: u64 = 32;

/// The signal at equal steps of the angle (rad) through which the shaft has turned, in the direction in which it turns, and the times (s) of
/// these samples. As many a turn as show orders up to `highest`, no fewer than there were, and a whole number of them in pieces of so many `turns` where that
/// can be. Of both ends a few samples are left out, for want of neighbours.
/// `None` if the shaft rests or turns back, or there are too few samples.
pub fn resample_by_angle(
    signal: &Uniform,
    angles: &[f64],
    highest: f64,
    turns: f64,
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
    // What the signal shows at the slowest speed must not be mistaken for a lower order; nor is more kept than can be told apart.
    let enough = (2.56 * highest).max(TAU / slowest).min(count as f64 * 64.0 * TAU / (last - first)).ceil();
    let whole = |a_turn: f64| (turns * a_turn - (turns * a_turn).round()).abs() < 1e-9;
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

/// Where between samples `at` and the next an ascending smooth quantity has a value: in samples from the first.
fn inverse(values: &[f64], at: usize, wanted: f64) -> f64 {
    let first = at.saturating_sub(STENCIL / 2 - 1).min(values.len() - STENCIL);
    let around = &values[first..first + STENCIL];
    let mut place = at as f64;
    let next = values.get(at + 1).copied().unwrap_or(values[at]);
    if next > values[at] {
        place += (wanted - values[at]) / (next - values[at]);
    }
    // The polynomial through the samples, by the secant that joins it to a step of a thousandth: it hardly bends.
    for _ in 0..4 {
        let [here, beside] = [0.0, 1e-3].map(|by| lagrange(around, place + by - first as f64));
        place -= (here - wanted) * 1e-3 / (beside - here);
    }
    place
}

/// The polynomial through samples at 0, 1, 2 ...
fn lagrange(values: &[f64], at: f64) -> f64 {
    let term = |(k, value): (usize, &f64)| {
        let others = (0..values.len()).filter(|&other| other != k);
        value * others.map(|other| (at - other as f64) / (k as f64 - other as f64)).product::<f64>()
    };
    values.iter().enumerate().map(term).sum()
}

/// A band-limited signal between its samples: Kaiser's windowed sinc, of which the weights add up to one.
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

/// The modified Bessel function of the first kind and order 0, by its series.
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
