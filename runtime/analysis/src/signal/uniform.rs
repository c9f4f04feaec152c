//! Uniformly sampled signals over time or angle.

use calyx_numerics::error::EngineError;

/// Tolerance of sample times, relative to a step.
const UNIFORM: f64 = 1e-6;

/// Number of samples that a spectrum requires.
pub(super) const FEWEST: usize = 4;

/// Samples at `start + k step`.
#[derive(Clone, Debug, PartialEq)]
pub struct Uniform {
    /// Position of the first sample, s or rad.
    pub start: f64,
    /// Step between samples.
    pub step: f64,
    /// Samples, at least two.
    pub values: Vec<f64>,
}

impl Uniform {
    /// Creates a signal from samples at ascending times (s).
    ///
    /// # Errors
    /// E0776: there are fewer than four; E0777: they are not uniform.
    pub fn of(times: &[f64], values: &[f64]) -> Result<Uniform, EngineError> {
        let count = times.len().min(values.len());
        if count < FEWEST {
            return Err(EngineError::new(
                "E0776",
                format!("a spectrum needs at least {FEWEST} samples, and there are {count}"),
                "analyse more positions, or widen the range from `from` to `to`",
            ));
        }
        let (start, step) = (times[0], (times[count - 1] - times[0]) / (count - 1) as f64);
        let off = |(k, time): (usize, &f64)| (time - start - k as f64 * step).abs();
        let far = times.iter().enumerate().map(off).fold(0.0, f64::max);
        // Large times have a larger rounding error in their last bit.
        let written = 4.0 * f64::EPSILON * times[count - 1].abs().max(start.abs());
        if !(step > 0.0 && far <= UNIFORM * step + written) {
            return Err(EngineError::new(
                "E0777",
                "the samples are not equally far apart in time",
                "take a range of uniform steps by `from` and `to`",
            ));
        }
        Ok(Uniform { start, step, values: values[..count].to_vec() })
    }

    /// Returns the duration, with one step per sample.
    pub fn duration(&self) -> f64 {
        self.step * self.values.len() as f64
    }

    /// Returns the arithmetic mean of the samples.
    pub fn mean(&self) -> f64 {
        self.values.iter().sum::<f64>() / self.values.len() as f64
    }

    /// Returns `count` samples, starting at number `first`.
    pub(super) fn part(&self, first: usize, count: usize) -> Uniform {
        let end = (first + count).min(self.values.len());
        let values = self.values.get(first..end).unwrap_or_default().to_vec();
        Uniform { start: self.start + first as f64 * self.step, step: self.step, values }
    }
}
