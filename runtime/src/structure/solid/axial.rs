//! How loads and displacements vary along the face: Legendre polynomials.
//!
//! Across a flank the compliance has a logarithm to be rid of, and every place a matching depth; along the face, loads of gears vary
//! slowly, and the sharpest thing that a mesh meets is the face's end. Polynomials are the right test functions there: a load that is
//! uniform along the face is one of them, so that the mesh sees it uniform up to both ends, and they resolve ends more finely than the
//! middle. Loads are projected on them and displacements taken as their sums, which treats both alike.

use crate::fe::quadrature::gauss_legendre;
use serde::{Deserialize, Serialize};

/// Stretches shorter than this part of half the range are points.
const NARROW: f64 = 1e-6;

/// Legendre polynomials on the axial range of a body, scaled to integrals of their squares of 1.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct AxialModes {
    range: [f64; 2],
    count: usize,
}

impl AxialModes {
    /// The polynomials of degree 0 to `count - 1` between two axial places, m.
    pub fn new(range: [f64; 2], count: usize) -> Self {
        Self { range, count }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Ends of the range, m.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Length of the range, m.
    pub fn length(&self) -> f64 {
        self.range[1] - self.range[0]
    }

    /// Their values at `v`, 1/sqrt(m); beyond the range, those at its end.
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

    /// Their averages over a stretch about `v`, 1/sqrt(m); of what reaches beyond the range, over the part inside.
    pub fn means(&self, v: f64, length: f64) -> Vec<f64> {
        let [start, end] = self.range;
        let at = |v: f64| ((2.0 * v - start - end) / self.length()).clamp(-1.0, 1.0);
        let [from, to] = [at(v - 0.5 * length), at(v + 0.5 * length)];
        // Below this, differences cancel more than points and averages differ.
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

    /// Places and weights that integrate products of any two of them, and of polynomials of degree `more`, exactly.
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
        // What reaches beyond the range is cut off.
        for (cut, inside) in modes.means(0.03, 0.004).into_iter().zip(modes.means(0.029, 0.002)) {
            assert!((cut - inside).abs() < 1e-9);
        }
        // An even load on cells side by side is the first polynomial alone.
        let cells = 17;
        let length = 0.05 / f64::from(cells);
        for n in 1..13 {
            let mean = |cell: i32| modes.means(-0.02 + (f64::from(cell) + 0.5) * length, length)[n];
            assert!((0..cells).map(mean).sum::<f64>().abs() < 1e-9, "{n}");
        }
    }
}
