//! The transfer function that a response to a short blow shows.

use super::Uniform;
use realfft::RealFftPlanner;

/// Response by force over frequency, complex.
#[derive(Clone, Debug, PartialEq)]
pub struct TransferFunction {
    /// Between lines, Hz: one over how long the response was followed.
    pub resolution: f64,
    /// Response by force, in the unit of the response per N, or per N m of a moment.
    pub magnitudes: Vec<f64>,
    /// By which the response is ahead of the force, rad.
    pub phases: Vec<f64>,
}

impl TransferFunction {
    /// Of a line, Hz.
    pub fn frequency(&self, line: usize) -> f64 {
        self.resolution * line as f64
    }
}

/// Of the response from the blow on, less what it was at rest (`at_rest`), to a blow of a momentum (N s, or N m s) that takes much less
/// than a period of what is looked at. The response has to have died down at its end: what has not is smeared over lines beside.
///
/// The integral over time is by the trapezoidal rule, so a response that jumps at its first sample counts there by half.
pub fn transfer_function(response: &Uniform, at_rest: f64, momentum: f64) -> TransferFunction {
    let mut input: Vec<f64> = response.values.iter().map(|value| value - at_rest).collect();
    if let Some(first) = input.first_mut() {
        *first *= 0.5;
    }
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(input.len());
    let mut lines = transform.make_output_vec();
    // It fails for buffers of other lengths alone, and these are its own.
    let _ = transform.process(&mut input, &mut lines);
    let by = response.step / momentum;
    TransferFunction {
        resolution: 1.0 / response.duration(),
        magnitudes: lines.iter().map(|line| line.norm() * by.abs()).collect(),
        phases: lines.iter().map(|line| (line * by).arg()).collect(),
    }
}
