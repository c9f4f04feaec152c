//! B-splines of any degree through given nodes, of one and of two variables.
//!
//! Knots are the averages of consecutive nodes (de Boor, A Practical Guide to Splines, chapter
//! XIII), for which interpolation is unique and well conditioned. Beyond the nodes the splines
//! continue straight.

use nalgebra::DMatrix;

/// Largest degree.
pub const MOST_DEGREE: usize = 5;
const MOST_SPLINES: usize = MOST_DEGREE + 1;

/// B-splines that interpolate at ascending nodes.
#[derive(Clone, Debug)]
pub struct Basis {
    degree: usize,
    nodes: Vec<f64>,
    knots: Vec<f64>,
    spans: Vec<Span>,
}

/// Splines on the interval between two knots, as polynomials of a variable from -1 to 1. The
/// compiler vectorizes their evaluation, unlike de Boor's recursion.
#[derive(Clone, Copy, Debug)]
struct Span {
    /// Middle of the interval, and inverse of half its length.
    middle: f64,
    scale: f64,
    /// Coefficients by power, then by spline.
    coefficients: [[f64; MOST_SPLINES]; MOST_SPLINES],
}

impl Span {
    /// Creates the splines of a degree on the interval that starts at a knot, by de Boor's
    /// recursion between polynomials.
    fn new(knots: &[f64], start: usize, degree: usize) -> Self {
        let [from, to] = [knots[start], knots[start + 1]];
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        // Polynomials by spline, then by power.
        let mut splines = [[0.0; MOST_SPLINES]; MOST_SPLINES];
        splines[0][0] = 1.0;
        for order in 1..=degree {
            let mut carried = [0.0; MOST_SPLINES];
            for r in 0..order {
                let (left, right) = (knots[start + 1 + r - order], knots[start + 1 + r]);
                let share = splines[r].map(|coefficient| coefficient / (right - left));
                // Products with the distances from the point to the right knot and from the left
                // one.
                let times = |constant: f64, slope: f64| -> [f64; MOST_SPLINES] {
                    std::array::from_fn(|power| {
                        let below = if power > 0 { share[power - 1] } else { 0.0 };
                        constant * share[power] + slope * below
                    })
                };
                let (falling, rising) = (times(right - middle, -half), times(middle - left, half));
                splines[r] = std::array::from_fn(|power| carried[power] + falling[power]);
                carried = rising;
            }
            splines[order] = carried;
        }
        let coefficients = std::array::from_fn(|power| std::array::from_fn(|spline| splines[spline][power]));
        Self { middle, scale: half.recip(), coefficients }
    }
}

/// Splines that are not zero at a point: index of the first, values, and first derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    pub first: usize,
    pub count: usize,
    pub values: [f64; MOST_SPLINES],
    pub slopes: [f64; MOST_SPLINES],
}

impl Weights {
    /// Value and derivative of a curve with these coefficients of the splines.
    #[inline(always)]
    fn sums<const N: usize>(&self, coefficients: &[[f64; N]]) -> [[f64; N]; 2] {
        let mut sums = [[0.0; N]; 2];
        for ((coefficient, value), slope) in coefficients.iter().zip(&self.values).zip(&self.slopes) {
            for component in 0..N {
                sums[0][component] += value * coefficient[component];
                sums[1][component] += slope * coefficient[component];
            }
        }
        sums
    }
}

impl Basis {
    /// Creates the splines on at least two ascending nodes, with the largest degree up to `degree`
    /// that their number permits.
    pub fn new(nodes: Vec<f64>, degree: usize) -> Self {
        let count = nodes.len();
        let degree = degree.min(MOST_DEGREE).min(count - 1);
        let mut knots = vec![nodes[0]; degree + 1];
        knots.extend((1..count - degree).map(|j| nodes[j..j + degree].iter().sum::<f64>() / degree as f64));
        knots.extend(vec![nodes[count - 1]; degree + 1]);
        let spans = (degree..count).map(|start| Span::new(&knots, start, degree)).collect();
        Self { degree, nodes, knots, spans }
    }

    /// Nodes, ascending.
    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// First and last node.
    pub fn range(&self) -> [f64; 2] {
        [self.nodes[0], self.nodes[self.nodes.len() - 1]]
    }

    /// Coefficients of the splines through values at the nodes; the values of each node are one row
    /// of `width` numbers. `None` if a value is not finite.
    pub fn coefficients(&self, values: &[f64], width: usize) -> Option<Vec<f64>> {
        let count = self.nodes.len();
        let mut matrix = DMatrix::zeros(count, count);
        for (row, &node) in self.nodes.iter().enumerate() {
            let weights = self.weights(node);
            for k in 0..weights.count {
                matrix[(row, weights.first + k)] = weights.values[k];
            }
        }
        let table = DMatrix::from_row_slice(count, width, values);
        let solved = matrix.lu().solve(&table)?;
        let all: Vec<f64> = solved.transpose().iter().copied().collect();
        all.iter().all(|value| value.is_finite()).then_some(all)
    }

    /// Splines at a point; beyond the nodes, those of linear extrapolation.
    pub fn weights(&self, at: f64) -> Weights {
        let [start, end] = self.range();
        let inside = at.clamp(start, end);
        let mut weights = self.inner_weights(inside);
        let beyond = at - inside;
        if beyond != 0.0 {
            for k in 0..weights.count {
                weights.values[k] += beyond * weights.slopes[k];
            }
        }
        weights
    }

    /// Splines between the first and the last knot, by Horner's rule for values and derivatives.
    fn inner_weights(&self, at: f64) -> Weights {
        let last = self.spans.len() - 1;
        let inner = &self.knots[self.degree + 1..=self.degree + last];
        let first = inner.partition_point(|&knot| knot <= at);
        let Span { middle, scale, coefficients } = &self.spans[first];
        let x = (at - middle) * scale;
        let mut values = coefficients[self.degree];
        let mut slopes = [0.0; MOST_SPLINES];
        for coefficients in coefficients[..self.degree].iter().rev() {
            for spline in 0..MOST_SPLINES {
                slopes[spline] = slopes[spline] * x + values[spline];
                values[spline] = values[spline] * x + coefficients[spline];
            }
        }
        Weights { first, count: self.degree + 1, values, slopes: slopes.map(|slope| slope * scale) }
    }
}

/// Function of one variable with `N` components.
#[derive(Clone, Debug)]
pub struct Line<const N: usize> {
    basis: Basis,
    coefficients: Vec<[f64; N]>,
}

impl<const N: usize> Line<N> {
    /// Interpolates values at the nodes of a basis. `None` if one is not finite.
    pub fn through(basis: Basis, values: &[[f64; N]]) -> Option<Self> {
        let flat = basis.coefficients(values.as_flattened(), N)?;
        let coefficients =
            flat.chunks_exact(N).map(|part| std::array::from_fn(|component| part[component])).collect();
        Some(Self { basis, coefficients })
    }

    /// Value and derivative.
    pub fn at(&self, x: f64) -> [[f64; N]; 2] {
        let weights = self.basis.weights(x);
        weights.sums(&self.coefficients[weights.first..][..weights.count])
    }
}

/// Plane curve that varies over a second variable: tensor product of splines.
#[derive(Clone, Debug)]
pub struct Sheet {
    bases: [Basis; 2],
    /// Ordered by the first variable, then the second.
    coefficients: Vec<[f64; 2]>,
}

/// Point of a [`Sheet`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetPoint {
    pub position: [f64; 2],
    /// Derivatives by the first variable, the second, and both.
    pub by_u: [f64; 2],
    pub by_v: [f64; 2],
    pub by_both: [f64; 2],
}

impl Sheet {
    /// Interpolates rows of points: row `j` belongs to node `j` of the second basis and has one
    /// point for each node of the first. `None` if a coordinate is not finite.
    pub fn through(bases: [Basis; 2], rows: &[Vec<[f64; 2]>]) -> Option<Self> {
        let [columns, count] = [bases[0].nodes.len(), rows.len()];
        // Along the second variable first: one row of numbers for each of its nodes.
        let along: Vec<f64> = rows.iter().flat_map(|row| row.as_flattened().iter().copied()).collect();
        let solved = bases[1].coefficients(&along, 2 * columns)?;
        let mut across = vec![0.0; along.len()];
        for column in 0..columns {
            for row in 0..count {
                for axis in 0..2 {
                    across[(column * count + row) * 2 + axis] = solved[(row * columns + column) * 2 + axis];
                }
            }
        }
        let flat = bases[0].coefficients(&across, 2 * count)?;
        let coefficients = flat.chunks_exact(2).map(|part| [part[0], part[1]]).collect();
        Some(Self { bases, coefficients })
    }

    /// Range of the first variable.
    pub fn range(&self) -> [f64; 2] {
        self.bases[0].range()
    }

    /// Point at two coordinates.
    pub fn at(&self, u: f64, v: f64) -> SheetPoint {
        let [of_u, of_v] = [self.bases[0].weights(u), self.bases[1].weights(v)];
        let width = self.bases[1].nodes.len();
        let mut point = SheetPoint { position: [0.0; 2], by_u: [0.0; 2], by_v: [0.0; 2], by_both: [0.0; 2] };
        for k in 0..of_u.count {
            let row = &self.coefficients[(of_u.first + k) * width + of_v.first..][..of_v.count];
            // The compiler unrolls the loop over a number of splines that it knows.
            let [value, slope] = match row.first_chunk::<MOST_SPLINES>() {
                Some(row) => of_v.sums(row),
                None => of_v.sums(row),
            };
            for axis in 0..2 {
                point.position[axis] += of_u.values[k] * value[axis];
                point.by_u[axis] += of_u.slopes[k] * value[axis];
                point.by_v[axis] += of_u.values[k] * slope[axis];
                point.by_both[axis] += of_u.slopes[k] * slope[axis];
            }
        }
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graded(count: usize) -> Vec<f64> {
        (0..count).map(|i| (i as f64 / (count - 1) as f64).powf(1.3)).collect()
    }

    #[test]
    fn polynomials_are_exact_and_smooth_functions_converge() {
        for degree in 1..=MOST_DEGREE {
            for count in [2, 3, 6, 9] {
                let basis = Basis::new(graded(count), degree);
                let power = degree.min(count - 1) as i32;
                let f = |x: f64| [1.0 - 2.0 * x, (x - 0.3).powi(power)];
                let values: Vec<[f64; 2]> = basis.nodes().iter().map(|&x| f(x)).collect();
                let line = Line::through(basis, &values).expect("finite values");
                for x in [0.0, 0.13, 0.5, 0.91, 1.0] {
                    let [value, slope] = line.at(x);
                    let expected = f(x);
                    let rate = f64::from(power) * (x - 0.3_f64).powi(power - 1);
                    assert!((value[0] - expected[0]).abs() < 1e-13 && (value[1] - expected[1]).abs() < 1e-13);
                    assert!((slope[0] + 2.0).abs() < 1e-11 && (slope[1] - rate).abs() < 1e-10);
                }
                // Straight beyond the ends.
                let [end, slope] = line.at(1.0);
                let [beyond, _] = line.at(1.25);
                assert!((beyond[1] - end[1] - 0.25 * slope[1]).abs() < 1e-12);
            }
        }
        let error = |count| {
            let basis = Basis::new(graded(count), MOST_DEGREE);
            let values: Vec<[f64; 1]> = basis.nodes().iter().map(|&x| [(4.0 * x).sin()]).collect();
            let line = Line::through(basis, &values).expect("finite values");
            let off =
                |i: i32| (line.at(f64::from(i) / 199.0)[0][0] - (4.0 * f64::from(i) / 199.0).sin()).abs();
            (0..200).map(off).fold(0.0, f64::max)
        };
        // A factor of 64 for twice as many equidistant nodes; these are graded.
        assert!(error(16) / error(32) > 25.0, "{} {}", error(16), error(32));
    }

    #[test]
    fn sheets_have_exact_derivatives() {
        let bases = [Basis::new(graded(12), 5), Basis::new(graded(7), 5)];
        let f = |u: f64, v: f64| [(u + 0.4 * v).sin(), (1.0 + u) * (0.7 * v).cos()];
        let rows: Vec<Vec<[f64; 2]>> =
            bases[1].nodes().iter().map(|&v| bases[0].nodes().iter().map(|&u| f(u, v)).collect()).collect();
        let sheet = Sheet::through(bases, &rows).expect("finite values");
        let h = 1e-5;
        for (u, v) in [(0.2, 0.3), (0.77, 0.5), (-0.1, 0.4), (0.5, 1.2)] {
            let at = sheet.at(u, v);
            let [left, right] = [sheet.at(u - h, v), sheet.at(u + h, v)];
            let [below, above] = [sheet.at(u, v - h), sheet.at(u, v + h)];
            for axis in 0..2 {
                let central = |a: f64, b: f64| (b - a) / (2.0 * h);
                assert!((at.by_u[axis] - central(left.position[axis], right.position[axis])).abs() < 1e-8);
                assert!((at.by_v[axis] - central(below.position[axis], above.position[axis])).abs() < 1e-8);
                assert!((at.by_both[axis] - central(left.by_v[axis], right.by_v[axis])).abs() < 1e-7);
            }
        }
        let inside = sheet.at(0.4, 0.6).position;
        assert!((inside[0] - f(0.4, 0.6)[0]).abs() < 1e-7 && (inside[1] - f(0.4, 0.6)[1]).abs() < 1e-7);
    }
}
