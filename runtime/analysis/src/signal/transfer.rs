//! Transfer function from the response to a short impulse.

use super::Uniform;
use calyx_numerics::fourier::real_transform;

/// Complex ratio of response to force over frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct TransferFunction {
    /// Line spacing, Hz: the inverse of the duration of the response.
    pub resolution: f64,
    /// Magnitudes, in the unit of the response per N, or per N m of a moment.
    pub magnitudes: Vec<f64>,
    /// Phase lead of the response relative to the force, rad.
    pub phases: Vec<f64>,
}

impl TransferFunction {
    /// Returns the frequency of a line, Hz.
    pub fn frequency(&self, line: usize) -> f64 {
        self.resolution * line as f64
    }
}

/// Computes the transfer function from the response, starting at the impulse, minus its value
/// `at_rest`, for an impulse with a momentum (N s, or N m s) whose duration is much shorter than
/// the periods of interest. The response must have decayed at its end; otherwise leakage spreads it
/// over neighbouring lines.
///
/// The integral over time uses the trapezoidal rule, so a response that jumps at its first sample
/// counts by half there.
pub fn transfer_function(response: &Uniform, at_rest: f64, momentum: f64) -> TransferFunction {
    let mut input: Vec<f64> = response.values.iter().map(|value| value - at_rest).collect();
    if let Some(first) = input.first_mut() {
        *first *= 0.5;
    }
    let lines = real_transform(&mut input);
    let by = response.step / momentum;
    TransferFunction {
        resolution: 1.0 / response.duration(),
        magnitudes: lines.iter().map(|line| line.norm() * by.abs()).collect(),
        phases: lines.iter().map(|line| (line * by).arg()).collect(),
    }
}
