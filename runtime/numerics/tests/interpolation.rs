//! Interpolation by polynomials.

use calyx_numerics::interpolation::*;

#[test]
fn a_cubic_is_interpolated_with_its_slope() {
    let cubic = |x: f64| 2.0 - x + 0.5 * x * x - 3.0 * x * x * x;
    let points = [-1.0, -0.25, 0.5, 1.0];
    for x in [-1.0, -0.7, 0.0, 0.4, 1.3] {
        let sum = |part: fn((f64, f64)) -> f64| -> f64 {
            let polynomials = lagrange_with_slopes(&points, x).into_iter();
            polynomials.zip(points).map(|(polynomial, at)| part(polynomial) * cubic(at)).sum()
        };
        assert!((sum(|(value, _)| value) - cubic(x)).abs() < 1e-13);
        assert!((sum(|(_, slope)| slope) - (-1.0 + x - 9.0 * x * x)).abs() < 1e-12);
        let values: Vec<f64> = lagrange_with_slopes(&points, x).iter().map(|(value, _)| *value).collect();
        assert_eq!(lagrange(&points, x), values);
    }
}
