//! Lagrange interpolation: the polynomials that are 1 at one of several points and 0 at the others.

/// Returns value and slope at `x` of the polynomial of point `own`.
#[inline]
pub fn lagrange_polynomial(points: &[f64], own: usize, x: f64) -> (f64, f64) {
    let (mut value, mut slope) = (1.0, 0.0);
    for (_, other) in points.iter().enumerate().filter(|(index, _)| *index != own) {
        let gap = points[own] - other;
        slope = (slope * (x - other) + value) / gap;
        value *= (x - other) / gap;
    }
    (value, slope)
}

/// Returns the values at `x` of the polynomials of all points.
pub fn lagrange(points: &[f64], x: f64) -> Vec<f64> {
    (0..points.len()).map(|own| lagrange_polynomial(points, own, x).0).collect()
}

/// Returns values and slopes at `x` of the polynomials of all points.
pub fn lagrange_with_slopes(points: &[f64], x: f64) -> Vec<(f64, f64)> {
    (0..points.len()).map(|own| lagrange_polynomial(points, own, x)).collect()
}
