//! Mean, standard deviation and percentiles of a sample, with 95 % confidence intervals.

use statrs::function::beta::beta_reg;

/// Percentiles that are estimated.
pub const PERCENTILES: [f64; 5] = [1.0, 5.0, 50.0, 95.0, 99.0];
/// Probability that a confidence interval misses the true value on one side.
const TAIL: f64 = 0.025;
/// Quantile of the standard normal distribution for that probability.
pub(super) const Z: f64 = 1.959_963_984_540_054;

/// Estimated value with its 95 % confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    pub value: f64,
    /// Lower bound; `None` if the samples are too few to give one.
    pub low: Option<f64>,
    /// Upper bound; `None` if the samples are too few to give one.
    pub high: Option<f64>,
}

impl Estimate {
    /// Returns whether the interval contains a value. An interval without a bound is open there.
    pub fn contains(&self, value: f64) -> bool {
        self.low.is_none_or(|low| low <= value) && self.high.is_none_or(|high| value <= high)
    }
}

/// Returns the mean with the interval of Student's t distribution.
pub fn mean(values: &[f64]) -> Estimate {
    let count = values.len() as f64;
    let value = mean_of(values);
    let half = (values.len() > 1).then(|| student(count - 1.0) * deviation(values) / count.sqrt());
    Estimate { value, low: half.map(|half| value - half), high: half.map(|half| value + half) }
}

/// Returns the standard deviation with the interval of Bonett, "Approximate confidence interval for
/// standard deviation of nonnormal distributions", Computational Statistics & Data Analysis 50
/// (2006), 775-782. `sorted` is in ascending order.
pub fn standard_deviation(sorted: &[f64]) -> Estimate {
    let value = deviation(sorted);
    let count = sorted.len() as f64;
    if sorted.len() < 5 || value == 0.0 {
        return Estimate { value, low: None, high: None };
    }
    let cut = (count / (2.0 * (count - 4.0).sqrt())).floor() as usize;
    let trimmed =
        mean_of(&sorted[cut.min((sorted.len() - 1) / 2)..sorted.len() - cut.min((sorted.len() - 1) / 2)]);
    let fourth: f64 = sorted.iter().map(|y| (y - trimmed).powi(4)).sum();
    let squares = value * value * (count - 1.0);
    let kurtosis = count * fourth / (squares * squares);
    let correction = count / (count - Z);
    let error = correction * ((kurtosis - (count - 3.0) / count) / (count - 1.0)).max(0.0).sqrt();
    let at = |sign: f64| value * correction.sqrt() * (0.5 * sign * Z * error).exp();
    Estimate { value, low: Some(at(-1.0)), high: Some(at(1.0)) }
}

/// Returns a percentile by linear interpolation (Hyndman and Fan 1996, definition 7) with the
/// interval between order statistics, which contains the percentile of any distribution with a
/// probability of at least 95 %: David and Nagaraja, "Order Statistics" (2003), section 7.1.
/// `sorted` is in ascending order and not empty.
pub fn percentile(sorted: &[f64], percent: f64) -> Estimate {
    let (count, part) = (sorted.len(), 0.01 * percent);
    let at = part * (count - 1) as f64;
    let (below, above) = (sorted[at.floor() as usize], sorted[at.ceil() as usize]);
    let value = below + (at - at.floor()) * (above - below);
    let [low, high] = ranks(count, part);
    let bound = |rank: Option<usize>| rank.map(|rank| sorted[rank - 1]);
    Estimate { value, low: bound(low), high: bound(high) }
}

/// Returns the ranks, from 1, of the order statistics that bound a quantile. The number of samples
/// below the quantile has a binomial distribution.
fn ranks(count: usize, part: f64) -> [Option<usize>; 2] {
    // The first rank whose distribution function exceeds a probability, by bisection.
    let first = |probability: f64| {
        let (mut low, mut high) = (0, count);
        while low < high {
            let middle = (low + high) / 2;
            if binomial(count, part, middle) > probability { high = middle } else { low = middle + 1 }
        }
        low
    };
    // At most `rank - 1` samples are below with at most the probability of a tail.
    let low = first(TAIL);
    let high = first(1.0 - TAIL) + 1;
    [Some(low).filter(|rank| *rank >= 1), Some(high).filter(|rank| *rank <= count)]
}

/// Returns the probability that at most `most` of `count` samples are below a quantile.
fn binomial(count: usize, part: f64, most: usize) -> f64 {
    if most >= count { 1.0 } else { beta_reg((count - most) as f64, most as f64 + 1.0, 1.0 - part) }
}

/// Returns the quantile of Student's t distribution that 2.5 % of the values exceed.
pub(super) fn student(freedom: f64) -> f64 {
    let exceeded = |t: f64| 0.5 * beta_reg(0.5 * freedom, 0.5, freedom / (freedom + t * t));
    let (mut low, mut high) = (0.0, 13.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if exceeded(middle) > TAIL { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

pub(super) fn mean_of(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Returns the standard deviation with the divisor N - 1.
pub(super) fn deviation(values: &[f64]) -> f64 {
    let mean = mean_of(values);
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (squares / (values.len() as f64 - 1.0).max(1.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers that an independent implementation gives: R, `qt(0.975, n)` and `qbinom`.
    #[test]
    fn quantiles_and_ranks_are_those_of_tables() {
        for (freedom, known) in [(1.0, 12.706_204_736), (5.0, 2.570_581_836), (199.0, 1.971_956_544)] {
            assert!((student(freedom) - known).abs() < 1e-6, "{freedom}: {}", student(freedom));
        }
        // The interval of the median of 10 samples is that of the 2nd and the 9th.
        assert_eq!(ranks(10, 0.5), [Some(2), Some(9)]);
        assert_eq!(ranks(100, 0.5), [Some(40), Some(61)]);
        // 0.99^n falls below 2.5 % at n = 368.
        assert_eq!(ranks(367, 0.01)[0], None);
        assert_eq!(ranks(368, 0.01)[0], Some(1));
        assert_eq!(ranks(367, 0.99)[1], None);
        assert_eq!(ranks(368, 0.99)[1], Some(368));
        let known = percentile(&[1.0, 2.0, 3.0, 4.0], 50.0);
        assert_eq!(known, Estimate { value: 2.5, low: None, high: None });
    }
}
