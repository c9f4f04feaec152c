//! Fourier transform of real samples.

use calyx_numerics::fourier::real_transform;
use std::f64::consts::TAU;

#[test]
fn the_lines_are_the_defining_sums() {
    for count in [1_usize, 2, 9, 16, 31, 60] {
        let samples: Vec<f64> = (0..count).map(|j| (1.0 + j as f64).ln() - 0.3 * (j as f64)).collect();
        let lines = real_transform(&mut samples.clone());
        assert_eq!(lines.len(), count / 2 + 1);
        for (k, line) in lines.iter().enumerate() {
            let angle = |j: usize| TAU * ((j * k) % count) as f64 / count as f64;
            let sum = |part: fn(f64) -> f64| -> f64 {
                samples.iter().enumerate().map(|(j, sample)| sample * part(angle(j))).sum()
            };
            let size: f64 = samples.iter().map(|sample| sample.abs()).sum();
            assert!((line.re - sum(f64::cos)).abs() <= 1e-14 * size, "{count} {k}");
            assert!((line.im + sum(f64::sin)).abs() <= 1e-14 * size, "{count} {k}");
        }
    }
}
