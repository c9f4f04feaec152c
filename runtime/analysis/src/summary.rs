//! What a row of positions comes to: extremes, mean, and the harmonics of what every mesh cycle repeats.

use crate::observe::Course;
use crate::observe::Observable;
pub use crate::results::Harmonic;
use crate::results::OutputSummary;
use crate::rows::StepRow;
use calyx_model::observed::OutputRequest;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Multiples of the tooth mesh frequency that are told.
const HARMONICS: usize = 5;
/// Positions nearer to each other than this part of the cycle, on both sides of a jump, count as one.
const TOGETHER: f64 = 1e-4;

/// Terms of which less than this is left beside the others, of a half, are not told apart by the positions.
const TOLD_APART: f64 = 0.05;

/// Summarises every output over the rows.
pub fn summarize(
    rows: &[StepRow],
    outputs: &[OutputRequest],
    observables: &[Arc<dyn Observable>],
) -> Vec<OutputSummary> {
    let cycle = Cycle::of(rows);
    let summary = |(output, request): (usize, &OutputRequest)| {
        let values: Vec<f64> = rows.iter().map(|row| row.outputs[output].value).collect();
        if values.iter().any(|value| value.is_nan()) {
            return OutputSummary::none();
        }
        let closed = cycle.as_ref().filter(|cycle| repeats(request, observables, [0.0, cycle.period]));
        let mut summary = OutputSummary {
            min: f64::INFINITY,
            max: f64::NEG_INFINITY,
            mean: closed.map_or_else(|| mean_over_time(rows, &values), |cycle| cycle.mean(&values)),
            peak_to_peak: 0.0,
            at_max: 0,
            place: None,
            harmonics: closed.map(|cycle| cycle.harmonics(&values)).unwrap_or_default(),
            error: None,
        };
        for (index, row) in rows.iter().enumerate() {
            let seen = &row.outputs[output];
            let least = seen.least.unwrap_or(seen.value);
            summary.min = summary.min.min(seen.value.min(least));
            if seen.value.max(least) > summary.max {
                summary.max = seen.value.max(least);
                summary.at_max = index;
                summary.place = seen.place.clone();
            }
        }
        summary.peak_to_peak = summary.max - summary.min;
        summary
    };
    outputs.iter().enumerate().map(summary).collect()
}

/// Whether the rows go through a mesh cycle at whose end an output is as at its beginning.
pub(crate) fn is_closed(
    rows: &[StepRow],
    request: &OutputRequest,
    observables: &[Arc<dyn Observable>],
) -> bool {
    Cycle::of(rows).is_some_and(|cycle| repeats(request, observables, [0.0, cycle.period]))
}

/// Whether every mesh cycle gives the same values of an output, if teeth are alike: it observes something, nothing that follows
/// one tooth, and does not depend on time itself.
fn repeats(request: &OutputRequest, observables: &[Arc<dyn Observable>], times: [f64; 2]) -> bool {
    let passes =
        |index: usize| observables.get(index).is_none_or(|seen| seen.quantity().course == Course::Passes);
    // Any values will do to see whether time makes a difference.
    let [now, later] = times.map(|time| request.at(time, &|index| 0.7 + 0.1 * index as f64).to_bits());
    request.observes(|_| true) && !request.observes(passes) && now == later
}

/// The trapezoidal rule from the first position to the last.
fn mean_over_time(rows: &[StepRow], values: &[f64]) -> f64 {
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else { return f64::NAN };
    let span = last.position.time - first.position.time;
    if span <= 0.0 {
        return values[0];
    }
    let pieces = rows.windows(2).zip(values.windows(2));
    let area: f64 = pieces
        .map(|(rows, values)| 0.5 * (values[0] + values[1]) * (rows[1].position.time - rows[0].position.time))
        .sum();
    area / span
}

/// Positions over one mesh cycle.
struct Cycle {
    /// Part of the cycle passed, ascending.
    at: Vec<f64>,
    /// Of the cycle that each position stands for: half the way to both neighbours, round the end. They add up to one.
    weights: Vec<f64>,
    /// s
    period: f64,
}

impl Cycle {
    /// The cycle that the rows go through; `None` if they do not go through one.
    fn of(rows: &[StepRow]) -> Option<Cycle> {
        let at: Vec<f64> = rows.iter().map(|row| row.position.cycle).collect();
        let (first, last) = (*at.first()?, *at.last()?);
        let mut steps: Vec<f64> = at.windows(2).map(|pair| pair[1] - pair[0]).collect();
        steps.push(first + 1.0 - last);
        // A cycle is gone through where no step of it is longer than half of it.
        if !steps.iter().all(|&step| step > 0.0 && step <= 0.5) {
            return None;
        }
        let before = |index: usize| steps[(index + steps.len() - 1) % steps.len()];
        let weights = (0..at.len()).map(|index| 0.5 * (before(index) + steps[index])).collect();
        let time = rows.last()?.position.time - rows.first()?.position.time;
        Some(Cycle { at, weights, period: time / (last - first) })
    }

    /// The trapezoidal rule round the cycle.
    fn mean(&self, values: &[f64]) -> f64 {
        self.weights.iter().zip(values).map(|(weight, value)| weight * value).sum()
    }

    /// The harmonics that fit the values best, in the sense of least squares weighted by what each position stands for: on uniform
    /// positions they are those of the discrete Fourier transform. As many as the positions tell apart, at most five.
    fn harmonics(&self, values: &[f64]) -> Vec<Harmonic> {
        let mut apart = self.at.clone();
        apart.dedup_by(|later, earlier| *later - *earlier < TOGETHER);
        let most = HARMONICS.min(apart.len().saturating_sub(1) / 2);
        let fitted = (0..=most).rev().find_map(|count| self.fitted(values, count));
        let Some(fitted) = fitted else { return Vec::new() };
        let harmonic = |order: usize| {
            let (sine, cosine) = (fitted[2 * order - 1], fitted[2 * order]);
            Harmonic { order, amplitude: sine.hypot(cosine), phase: (-sine).atan2(cosine) }
        };
        (1..=fitted.len() / 2).map(harmonic).collect()
    }

    /// The mean, and of so many harmonics the sine and the cosine of each; `None` if the positions hardly tell these terms apart: what differs
    /// between them would be blown up.
    fn fitted(&self, values: &[f64], count: usize) -> Option<DVector<f64>> {
        let term = |row: usize, column: usize| {
            let angle = TAU * self.at[row] * column.div_ceil(2) as f64;
            if column.is_multiple_of(2) { angle.cos() } else { angle.sin() }
        };
        let terms = DMatrix::from_fn(self.at.len(), 2 * count + 1, term);
        let weighted = DMatrix::from_fn(terms.nrows(), terms.ncols(), |i, k| self.weights[i] * terms[(i, k)]);
        let right = weighted.transpose() * DVector::from_column_slice(values);
        let factor = (weighted.transpose() * terms).cholesky()?;
        // Pivots of sines and cosines are halves, if positions are uniform.
        let told = factor.l_dirty().diagonal().iter().all(|pivot| pivot * pivot > TOLD_APART);
        told.then(|| factor.solve(&right))
    }
}

#[cfg(test)]
mod tests;
