//! Discrete Fourier transform of real samples.

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;

/// Returns the lines `0 ..= n / 2` of the discrete Fourier transform of `n` real samples: line `k`
/// is the sum of `samples[j] * exp(-2 pi i j k / n)`, in the unit of the samples. Overwrites the
/// samples.
pub fn real_transform(samples: &mut [f64]) -> Vec<Complex<f64>> {
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(samples.len());
    let mut lines = transform.make_output_vec();
    // The transform fails only for buffers of other lengths, and these have its own.
    let _ = transform.process(samples, &mut lines);
    lines
}
