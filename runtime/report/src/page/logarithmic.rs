//! Logarithmic abscissa of a plot, with ticks at 1, 2 and 5 times powers of ten.

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use std::ops::Range;

/// Number of decades up to which 2 and 5 have ticks.
const DENSE: f64 = 3.5;

/// Positive values on a logarithmic scale.
#[derive(Clone, Debug)]
pub struct Logarithmic(Range<f64>);

impl Logarithmic {
    /// Creates the scale of a range with positive ends; `None` for other ends.
    pub fn new(range: &Range<f64>) -> Option<Logarithmic> {
        (range.start > 0.0 && range.end > range.start && range.end.is_finite())
            .then(|| Logarithmic(range.clone()))
    }

    fn ticks(&self, most: usize) -> Vec<f64> {
        let [low, high] = [self.0.start, self.0.end].map(f64::log10);
        let decades: Vec<i32> = (low.floor() as i32..=high.ceil() as i32).collect();
        let factors: &[f64] = if high - low <= DENSE { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let all = decades.iter().flat_map(|&decade| {
            // Parsing rounds correctly, unlike a power.
            let power: f64 = format!("1e{decade}").parse().unwrap_or(f64::NAN);
            factors.iter().map(move |factor| factor * power)
        });
        // Ends that are ticks are not exact.
        let [start, end] = [self.0.start * (1.0 - 1e-9), self.0.end * (1.0 + 1e-9)];
        let within: Vec<f64> = all.filter(|tick| (start..=end).contains(tick)).collect();
        let stride = within.len().div_ceil(most.max(1)).max(1);
        within.into_iter().step_by(stride).collect()
    }
}

impl Ranged for Logarithmic {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (low, high): (i32, i32)) -> i32 {
        let part = (value / self.0.start).ln() / (self.0.end / self.0.start).ln();
        low + (f64::from(high - low) * part).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        self.ticks(hint.bold_points())
    }

    fn range(&self) -> Range<f64> {
        self.0.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ratios_have_equal_distances() {
        let scale = Logarithmic::new(&(100.0..10_000.0)).expect("a scale");
        let at = [100.0, 1000.0, 10_000.0].map(|value| scale.map(&value, (0, 800)));
        assert_eq!(at, [0, 400, 800]);
        assert_eq!(scale.ticks(11), [100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10_000.0]);
        let narrow = Logarithmic::new(&(3.0..30.0)).expect("a scale");
        assert_eq!(narrow.ticks(11), [5.0, 10.0, 20.0]);
        let wide = Logarithmic::new(&(1e-3..1e3)).expect("a scale");
        assert_eq!(wide.ticks(11), [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1000.0]);
        assert!(Logarithmic::new(&(0.0..10.0)).is_none());
        assert!(Logarithmic::new(&(5.0..5.0)).is_none());
    }
}
