//! Division of lengths into elements of target sizes.

use crate::root_finding::solve_bracketed;

pub(crate) fn ends(at: &[f64]) -> (f64, f64) {
    (at[0], at[at.len() - 1])
}

/// Maps values linearly to the range from 0 at the first to 1 at the last, both exact.
pub(crate) fn normalised(at: &[f64]) -> Vec<f64> {
    let (from, to) = ends(at);
    let mut divisions: Vec<f64> = at.iter().map(|value| (value - from) / (to - from)).collect();
    divisions[at.len() - 1] = 1.0;
    divisions
}

/// Divides `from ..= to` into elements of about the target sizes, using the integral of 1 / size.
pub(crate) fn divisions(from: f64, to: f64, size: impl Fn(f64) -> f64) -> Vec<f64> {
    const SAMPLES: usize = 200;
    let step = (to - from) / SAMPLES as f64;
    let mut counts = vec![0.0];
    let mut count = 0.0;
    for sample in 0..SAMPLES {
        count += step / size(from + (sample as f64 + 0.5) * step);
        counts.push(count);
    }
    // The small margin prevents an additional element for a length that divides evenly.
    let elements = (count - 1e-6).ceil().max(1.0) as usize;
    let mut at = vec![from];
    for element in 1..elements {
        let target = count * element as f64 / elements as f64;
        let after = counts.partition_point(|&sum| sum < target).max(1);
        let within = (target - counts[after - 1]) / (counts[after] - counts[after - 1]);
        at.push(from + (after as f64 - 1.0 + within) * step);
    }
    at.push(to);
    at
}

/// Ratio of successive lengths of `count` parts of a whole whose smallest part is `smallest`, at
/// most 1 / `count`.
pub(crate) fn growth(count: usize, smallest: f64) -> f64 {
    if count < 2 {
        return 1.0;
    }
    let excess = |ratio: f64| smallest * (0..count).fold(0.0, |sum, _| sum * ratio + 1.0) - 1.0;
    solve_bracketed(excess, 1.0, 1.0 + 1.0 / smallest)
}

/// Piecewise linear function through values at equal distances, evaluated at `u` in 0 ..= 1.
pub(crate) fn piecewise_linear(values: &[f64], u: f64) -> f64 {
    let last = values.len() - 1;
    let place = u * last as f64;
    let first = (place.floor() as usize).min(last - 1);
    let part = place - first as f64;
    (1.0 - part) * values[first] + part * values[first + 1]
}
