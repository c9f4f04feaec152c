//! Statistics of outputs over the positions: extremes, mean, and harmonics of quantities that
//! repeat in every mesh cycle.

use crate::observables::Periodicity;
pub use crate::results::Harmonic;
use crate::results::OutputSummary;
use crate::rows::StepRow;
use crate::scene::Scene;
use calyx_model::observed::OutputRequest;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Number of reported harmonics of the tooth mesh frequency.
const HARMONICS: usize = 5;
/// Distance of positions on both sides of a jump, as a fraction of the cycle, below which they
/// count as one.
const TOGETHER: f64 = 1e-4;

/// Squared pivot, of at most a half, below which a term is not distinguishable from the others at
/// these positions.
const DISTINCT: f64 = 0.05;

/// Summarizes every output over the rows.
pub fn summarize(rows: &[StepRow], outputs: &[OutputRequest], scene: &Scene) -> Vec<OutputSummary> {
    let cycle = Cycle::of(rows);
    let summary = |(output, request): (usize, &OutputRequest)| {
        let values: Vec<f64> = rows.iter().map(|row| row.outputs[output].value).collect();
        if values.iter().any(|value| value.is_nan()) {
            return OutputSummary::none();
        }
        let closed = cycle.as_ref().filter(|cycle| repeats(request, scene, [0.0, cycle.period]));
        let mut summary = OutputSummary {
            min: f64::INFINITY,
            max: f64::NEG_INFINITY,
            mean: closed.map_or_else(|| mean_over_time(rows, &values), |cycle| cycle.mean(&values)),
            peak_to_peak: 0.0,
            at_max: 0,
            location: None,
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
                summary.location = seen.location.clone();
            }
        }
        summary.peak_to_peak = summary.max - summary.min;
        summary
    };
    outputs.iter().enumerate().map(summary).collect()
}

/// Returns whether the rows cover a mesh cycle at whose end an output has its initial value.
pub(crate) fn is_closed(rows: &[StepRow], request: &OutputRequest, scene: &Scene) -> bool {
    Cycle::of(rows).is_some_and(|cycle| repeats(request, scene, [0.0, cycle.period]))
}

/// Returns the mean of values of an output at the positions, as in its summary.
pub(crate) fn mean_of(rows: &[StepRow], request: &OutputRequest, scene: &Scene, values: &[f64]) -> f64 {
    let cycle = Cycle::of(rows);
    let closed = cycle.as_ref().filter(|cycle| repeats(request, scene, [0.0, cycle.period]));
    closed.map_or_else(|| mean_over_time(rows, values), |cycle| cycle.mean(values))
}

/// Returns the mean over time of a quantity that repeats in every mesh cycle: over the closed cycle
/// if the rows cover one.
pub(crate) fn mean_of_repeating(rows: &[StepRow], scene: &Scene, values: &[f64]) -> f64 {
    match Cycle::of(rows).filter(|_| !orbits(scene)) {
        Some(cycle) => cycle.mean(values),
        None => mean_over_time(rows, values),
    }
}

/// Returns whether rolling elements orbit, whose positions differ in the next cycle.
fn orbits(scene: &Scene) -> bool {
    scene.bearings.iter().any(|bearing| bearing.rolling().is_some_and(|elements| elements.orbit()))
}

/// Returns whether an output repeats in every mesh cycle if all teeth are equal: it depends on an
/// observable, on none that follows a single tooth, and not on time itself. Nothing repeats if
/// rolling elements orbit, whose positions differ in the next cycle.
fn repeats(request: &OutputRequest, scene: &Scene, times: [f64; 2]) -> bool {
    let observables = &scene.observables;
    if orbits(scene) {
        return false;
    }
    let passes = |index: usize| {
        observables.get(index).is_none_or(|seen| seen.quantity().course == Periodicity::Passes)
    };
    // Use arbitrary values to test for a dependence on time.
    let [now, later] = times.map(|time| request.at(time, &|index| 0.7 + 0.1 * index as f64).to_bits());
    request.observes(|_| true) && !request.observes(passes) && now == later
}

/// Returns the mean by the trapezoidal rule from the first position to the last.
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
    /// Fractions of the cycle, ascending.
    at: Vec<f64>,
    /// Fraction of the cycle that each position represents: half the distance to both neighbours,
    /// across the end. They add up to one.
    weights: Vec<f64>,
    /// Duration of the cycle, s.
    period: f64,
}

impl Cycle {
    /// Returns the cycle that the rows cover; `None` if they do not cover one.
    fn of(rows: &[StepRow]) -> Option<Cycle> {
        let at: Vec<f64> = rows.iter().map(|row| row.position.cycle).collect();
        let (first, last) = (*at.first()?, *at.last()?);
        let mut steps: Vec<f64> = at.windows(2).map(|pair| pair[1] - pair[0]).collect();
        steps.push(first + 1.0 - last);
        // The rows cover a cycle if no step is longer than half of it.
        if !steps.iter().all(|&step| step > 0.0 && step <= 0.5) {
            return None;
        }
        let before = |index: usize| steps[(index + steps.len() - 1) % steps.len()];
        let weights = (0..at.len()).map(|index| 0.5 * (before(index) + steps[index])).collect();
        let time = rows.last()?.position.time - rows.first()?.position.time;
        Some(Cycle { at, weights, period: time / (last - first) })
    }

    /// Returns the mean by the periodic trapezoidal rule.
    fn mean(&self, values: &[f64]) -> f64 {
        self.weights.iter().zip(values).map(|(weight, value)| weight * value).sum()
    }

    /// Returns the least-squares fit of harmonics, weighted by the fractions that the positions
    /// represent; at uniform positions the discrete Fourier transform. As many as the positions
    /// distinguish, at most five.
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

    /// Fits the mean, and sine and cosine of `count` harmonics; `None` if the positions hardly
    /// distinguish these terms, because differences between them would be amplified.
    fn fitted(&self, values: &[f64], count: usize) -> Option<DVector<f64>> {
        let term = |row: usize, column: usize| {
            let angle = TAU * self.at[row] * column.div_ceil(2) as f64;
            if column.is_multiple_of(2) { angle.cos() } else { angle.sin() }
        };
        let terms = DMatrix::from_fn(self.at.len(), 2 * count + 1, term);
        let weighted = DMatrix::from_fn(terms.nrows(), terms.ncols(), |i, k| self.weights[i] * terms[(i, k)]);
        let right = weighted.transpose() * DVector::from_column_slice(values);
        let factor = (weighted.transpose() * terms).cholesky()?;
        // Pivots of sines and cosines are one half at uniform positions.
        let independent = factor.l_dirty().diagonal().iter().all(|pivot| pivot * pivot > DISTINCT);
        independent.then(|| factor.solve(&right))
    }
}

#[cfg(test)]
mod tests;
