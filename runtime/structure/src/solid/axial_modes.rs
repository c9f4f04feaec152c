//! Legendre polynomials along the face, as shape functions for loads and displacements.
//!
//! Across a flank the compliance contains a logarithm that has to be subtracted, and every point
//! has a matching depth. Along the face, gear loads vary slowly, and the sharpest feature is the
//! end of the face. Polynomials are suitable test functions there. A load that is uniform along the
//! face is one of them, so the mesh receives it uniformly up to both ends, and polynomials resolve
//! ends more finely than the middle. Loads are projected on the polynomials and displacements are
//! sums of them, which treats both alike.

use calyx_numerics::quadrature::gauss_legendre;
use serde::{Deserialize, Serialize};

/// Stretches shorter than this part of half the range are treated as points.
const NARROW: f64 = 1e-6;

/// Legendre polynomials on the axial range of a body, scaled so that the integrals of their squares
/// are 1.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct AxialModes {
    range: [f64; 2],
    count: usize,
}

impl AxialModes {
    /// Builds the polynomials of degree 0 to `count - 1` between two axial coordinates, m.
    pub fn new(range: [f64; 2], count: usize) -> Self {
        Self { range, count }
    }

    /// Returns the number of polynomials.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the ends of the range, m.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Returns the length of the range, m.
    pub fn length(&self) -> f64 {
        self.range[1] - self.range[0]
    }

    /// Returns the values at `v`, 1/sqrt(m); `v` is clamped to the range.
    pub fn values(&self, v: f64) -> Vec<f64> {
        let [start, end] = self.range;
        let x = ((2.0 * v - start - end) / self.length()).clamp(-1.0, 1.0);
        let mut values = Vec::with_capacity(self.count);
        let (mut previous, mut value) = (0.0, 1.0);
        for degree in 0..self.count {
            let n = degree as f64;
            values.push(((2.0 * n + 1.0) / self.length()).sqrt() * value);
            (previous, value) = (value, ((2.0 * n + 1.0) * x * value - n * previous) / (n + 1.0));
        }
        values
    }

    /// Returns the averages over a stretch about `v`, 1/sqrt(m); if it extends beyond the range,
    /// over the part inside.
    pub fn means(&self, v: f64, length: f64) -> Vec<f64> {
        let [start, end] = self.range;
        let at = |v: f64| ((2.0 * v - start - end) / self.length()).clamp(-1.0, 1.0);
        let [from, to] = [at(v - 0.5 * length), at(v + 0.5 * length)];
        // Below this length, cancellation in the differences exceeds the difference between point
        // values and averages.
        if to - from < NARROW {
            return self.values(v);
        }
        // The integral of P_n is (P_{n+1} - P_{n-1}) / (2 n + 1).
        let [mut below, mut own] = [[0.0; 2], [1.0; 2]];
        let mut means = Vec::with_capacity(self.count);
        for degree in 0..self.count {
            let n = degree as f64;
            let above: [f64; 2] = std::array::from_fn(|k| {
                ((2.0 * n + 1.0) * [from, to][k] * own[k] - n * below[k]) / (n + 1.0)
            });
            let integral = ((above[1] - above[0]) - (below[1] - below[0])) / (2.0 * n + 1.0);
            means.push(((2.0 * n + 1.0) / self.length()).sqrt() * integral / (to - from));
            (below, own) = (own, above);
        }
        means
    }

    /// Returns points and weights that integrate products of any two polynomials, and of
    /// polynomials of degree `more`, exactly.
    pub fn quadrature(&self, [from, to]: [f64; 2], more: usize) -> Vec<(f64, f64)> {
        let half = 0.5 * (to - from);
        let rule = gauss_legendre(self.count + more.div_ceil(2));
        rule.into_iter().map(|(x, weight)| (from + half * (1.0 + x), half * weight)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_orthonormal() {
        let modes = AxialModes::new([-0.02, 0.03], 7);
        for n in 0..7 {
            for m in 0..7 {
                let points = modes.quadrature(modes.range(), 0).into_iter();
                let product: f64 =
                    points.map(|(v, weight)| weight * modes.values(v)[n] * modes.values(v)[m]).sum();
                assert!((product - f64::from(u8::from(n == m))).abs() < 1e-12, "{n} {m}: {product}");
            }
        }
        assert_eq!(modes.values(0.05), modes.values(0.03));
    }

    #[test]
    fn averages_are_those_of_their_values_and_of_stretches_side_by_side_nothing_is_left() {
        let modes = AxialModes::new([-0.02, 0.03], 13);
        for (v, length) in [(0.004, 0.006), (-0.0185, 0.003), (0.01, 1e-7), (0.005, 0.05), (0.01, 0.0)] {
            let points = modes.quadrature([v - 0.5 * length, v + 0.5 * length], 0);
            for (n, mean) in modes.means(v, length).into_iter().enumerate() {
                let sum: f64 = points.iter().map(|&(v, weight)| weight * modes.values(v)[n]).sum();
                let expected = if length > 0.0 { sum / length } else { modes.values(v)[n] };
                assert!((mean - expected).abs() < 1e-8 * modes.values(0.03)[n], "{v} {length} {n}");
            }
        }
        // The part beyond the range is cut off.
        for (cut, inside) in modes.means(0.03, 0.004).into_iter().zip(modes.means(0.029, 0.002)) {
            assert!((cut - inside).abs() < 1e-9);
        }
        // A uniform load on adjacent cells is the first polynomial alone.
        let cells = 17;
        let length = 0.05 / f64::from(cells);
        for n in 1..13 {
            let mean = |cell: i32| modes.means(-0.02 + (f64::from(cell) + 0.5) * length, length)[n];
            assert!((0..cells).map(mean).sum::<f64>().abs() < 1e-9, "{n}");
        }
    }
}
