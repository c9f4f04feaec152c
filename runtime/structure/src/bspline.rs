//! Cubic splines on graded nodes, with sparse evaluation: four weights for each point.
//!
//! A table over samples is converted to spline coefficients once; a value at any point is then a
//! short sum. Applied to the rows and to the columns of a table, the spline interpolates a function
//! of two variables and treats both alike.

use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Mat, MatRef};

const ORDER: usize = 4;

/// B-splines that interpolate at given nodes (not-a-knot: third derivative continuous at the second
/// and the last but one).
#[derive(Clone, Debug)]
pub struct BSpline {
    nodes: Vec<f64>,
    knots: Vec<f64>,
    collocation: PartialPivLu<f64>,
}

/// B-splines that are not zero at a point: their values, and the index of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BSplineWeights {
    pub first: usize,
    pub values: [f64; ORDER],
}

impl BSpline {
    /// Builds the splines on at least four ascending `nodes`.
    pub fn new(nodes: Vec<f64>) -> Self {
        let count = nodes.len();
        assert!(count >= ORDER && nodes.windows(2).all(|pair| pair[0] < pair[1]), "ascending nodes");
        let mut knots = vec![nodes[0]; ORDER];
        knots.extend(&nodes[2..count - 2]);
        knots.extend([nodes[count - 1]; ORDER]);
        let mut matrix = Mat::zeros(count, count);
        for (row, &s) in nodes.iter().enumerate() {
            let weights = weights_at(&knots, s);
            for (k, value) in weights.values.into_iter().enumerate() {
                matrix[(row, weights.first + k)] = value;
            }
        }
        Self { collocation: matrix.partial_piv_lu(), nodes, knots }
    }

    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// Returns the weights at `s`; beyond the nodes, those of linear extrapolation.
    pub fn weights(&self, s: f64) -> BSplineWeights {
        let beyond = self.beyond(s);
        let mut weights = weights_at(&self.knots, s - beyond);
        if beyond != 0.0 {
            let slopes = self.slopes(usize::from(beyond > 0.0));
            for (value, slope) in weights.values.iter_mut().zip(slopes.values) {
                *value += beyond * slope;
            }
        }
        weights
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        // The two factors of the collocation matrix, as one matrix.
        let entries = self.nodes.len() + self.knots.len() + self.nodes.len() * self.nodes.len();
        entries * size_of::<f64>()
    }

    /// Returns the distance of `s` beyond the last node, or, negative, before the first.
    pub fn beyond(&self, s: f64) -> f64 {
        s - s.clamp(self.nodes[0], self.nodes[self.nodes.len() - 1])
    }

    /// Returns the derivatives of the weights at the first (0) or last (1) node.
    pub fn slopes(&self, end: usize) -> BSplineWeights {
        // At an end knot only two splines have a slope: `3 / (gap to the next knot)`, and its
        // negative.
        let last = self.knots.len() - ORDER;
        let (first, at, gap) = if end == 0 {
            (0, 0, self.knots[ORDER] - self.knots[0])
        } else {
            (last - ORDER, ORDER - 2, self.knots[last] - self.knots[last - 1])
        };
        let mut values = [0.0; ORDER];
        values[at] = -((ORDER - 1) as f64) / gap;
        values[at + 1] = (ORDER - 1) as f64 / gap;
        BSplineWeights { first, values }
    }

    /// Returns the coefficients of the splines through the columns of a table whose rows belong to
    /// the nodes.
    pub fn coefficients(&self, table: MatRef<'_, f64>) -> Mat<f64> {
        self.collocation.solve(table)
    }
}

impl BSplineWeights {
    /// Returns the sum of `coefficient(i)` times the weights.
    pub fn sum(&self, coefficient: impl Fn(usize) -> f64) -> f64 {
        self.values.iter().enumerate().map(|(k, value)| value * coefficient(self.first + k)).sum()
    }
}

/// Evaluates De Boor's recursion at `s` between the first and the last knot.
fn weights_at(knots: &[f64], s: f64) -> BSplineWeights {
    let last = knots.len() - ORDER - 1;
    let span = (knots.partition_point(|&knot| knot <= s).max(ORDER) - 1).min(last);
    let mut values = [0.0; ORDER];
    values[0] = 1.0;
    for degree in 1..ORDER {
        let mut carried = 0.0;
        for r in 0..degree {
            let right = knots[span + r + 1];
            let left = knots[span + r + 1 - degree];
            let share = values[r] / (right - left);
            values[r] = carried + (right - s) * share;
            carried = (s - left) * share;
        }
        values[degree] = carried;
    }
    BSplineWeights { first: span + 1 - ORDER, values }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graded(count: usize) -> Vec<f64> {
        (0..count).map(|i| (i as f64 / (count - 1) as f64).powi(2)).collect()
    }

    #[test]
    fn cubics_are_exact_and_smooth_functions_converge() {
        let f = |s: f64| 1.0 + s * (2.0 - s * (3.0 - 0.5 * s));
        for count in [4, 5, 9] {
            let spline = BSpline::new(graded(count));
            let table = Mat::from_fn(count, 1, |i, _| f(spline.nodes()[i]));
            let coefficients = spline.coefficients(table.as_ref());
            for s in [0.0, 0.1, 0.33, 0.8, 1.0] {
                let value = spline.weights(s).sum(|i| coefficients[(i, 0)]);
                assert!((value - f(s)).abs() < 1e-12, "{count} nodes at {s}");
            }
        }
        let error = |count| {
            let spline = BSpline::new(graded(count));
            let table = Mat::from_fn(count, 1, |i, _| (4.0 * spline.nodes()[i]).sin());
            let coefficients = spline.coefficients(table.as_ref());
            (0..200)
                .map(|i| {
                    let s = f64::from(i) / 199.0;
                    (spline.weights(s).sum(|i| coefficients[(i, 0)]) - (4.0 * s).sin()).abs()
                })
                .fold(0.0, f64::max)
        };
        // Fourth order: a factor of 16 for twice as many nodes, slightly less because of the ends.
        assert!(error(20) / error(40) > 10.0);
    }

    #[test]
    fn beyond_the_nodes_it_continues_straight() {
        let spline = BSpline::new(graded(6));
        let table = Mat::from_fn(6, 1, |i, _| spline.nodes()[i].powi(3));
        let coefficients = spline.coefficients(table.as_ref());
        let value = |s: f64| spline.weights(s).sum(|i| coefficients[(i, 0)]);
        assert!((value(1.5) - (1.0 + 3.0 * 0.5)).abs() < 1e-12);
        assert!(value(-0.5).abs() < 1e-12);
    }
}
