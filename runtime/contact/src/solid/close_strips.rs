//! Average of 1/r between the cells of two close strips.
//!
//! Between two strips the average over both intervals along the patch is a function of the distance
//! across it, `K(x)`. With `H(x, y) = y asinh(y / x) - r`, whose second derivative by y is 1/r, it
//! is the second difference of H along the patch, over the ends `Y` of the intervals:
//!
//! ```text
//! 4 a b K(x) = Σ ± H(x, Y),   H(x, Y) = (Y ln(Y + r) - r) - Y ln |x|,   H(x, 0) = -|x|
//! ```
//!
//! The term in parentheses is a smooth function of x², which Chebyshev polynomials interpolate, and
//! a Gauss rule averages it over two cells. The averages of `ln |x|` and of `|x|` are in closed
//! form. This takes less time than [`super::half_space::mean_inverse_distance`], where most of the
//! logarithms belong to the term in parentheses.

use super::grid::Cell;
use super::interval_averages::Sides;
use super::strips::Strip;
use calyx_structure::half_plane::mean_log_apart;
use std::array::from_fn;
use std::f64::consts::PI;

/// Error of the interpolation relative to the largest value.
const TOLERANCE: f64 = 1e-11;
/// Largest number of polynomials.
const MOST_TERMS: usize = 48;
/// Distance along the patch, relative to its extent, below which intervals touch.
const TOUCHING: f64 = 1e-9;
/// Largest distance of the centres of two strips along the patch, in sums of their half-lengths.
const FARTHEST: f64 = 4.0;
/// Smallest distance from the singularities of the smooth part, in sums of the halves of two cells
/// across the patch, at which the Gauss rule of five points is exact to about 1e-12.
const RULE_FROM: f64 = 7.0;

/// Two close strips.
pub(super) struct CloseStrips {
    /// Coefficients of the Chebyshev polynomials of the smooth part; those of x² are mapped to -1
    /// .. 1.
    smooth: Vec<f64>,
    /// Inverse of half of the largest x², 1/m².
    scale: f64,
    /// Factor of the average of ln |x|.
    logarithm: f64,
    /// Factor of the average of |x|, 1/m.
    absolute: f64,
    /// Distance of the nearest singularity of the smooth part from the axis, m.
    nearest: f64,
}

impl CloseStrips {
    /// Creates the function of two strips; `None` if its smooth part varies too fast, or if the
    /// strips are so distant that the second difference loses digits.
    pub fn new(first: &Strip, second: &Strip) -> Option<Self> {
        let along = Sides::new(first.center[1] - second.center[1], first.half[1], second.half[1]);
        let across = (first.center[0] - second.center[0]).abs() + first.half[0] + second.half[0];
        if along.distance > FARTHEST * along.sum {
            return None;
        }
        let unit = along.distance + along.sum;
        let ends = along.ends().map(|end| if end < TOUCHING * unit { 0.0 } else { end });
        let signs = [1.0, -1.0, 1.0, -1.0];
        let area = 4.0 * along.product;
        let all = || ends.into_iter().zip(signs);
        let nearest = all().map(|(end, _)| end).filter(|end| *end > 0.0).fold(f64::INFINITY, f64::min);
        let logarithm = -all().map(|(end, sign)| sign * end).sum::<f64>() / area;
        let absolute = -all().filter(|(end, _)| *end == 0.0).map(|(_, sign)| sign).sum::<f64>() / area;
        let smooth = |square: f64| -> f64 {
            let part = |(end, sign): (f64, f64)| {
                let r = (square + end * end).sqrt();
                sign * (end * (end + r).ln() - r)
            };
            all().filter(|(end, _)| *end > 0.0).map(part).sum::<f64>() / area
        };
        // The polynomials converge within the ellipse about 0 .. largest that ends at the branch
        // point at minus the square of the nearest end.
        let largest = across * across;
        let branch = 1.0 + 2.0 * (nearest * nearest) / largest;
        let rate = (branch + (branch * branch - 1.0).sqrt()).ln();
        // Infinite for ends that nearly touch.
        let terms = (-TOLERANCE.ln() / rate).ceil() + 1.0;
        let few = terms <= MOST_TERMS as f64;
        let smooth = few.then(|| chebyshev(terms as usize, |x| smooth(0.5 * largest * (x + 1.0))))?;
        Some(Self { smooth, scale: 2.0 / largest, logarithm, absolute, nearest })
    }

    /// Returns the average of 1/r between the points of two cells of the strips, 1/m; `None` if
    /// the cells are too wide.
    pub fn mean_inverse_distance(&self, first: &Cell, second: &Cell) -> Option<f64> {
        let across =
            Sides::new(first.center[0] - second.center[0], 0.5 * first.size[0], 0.5 * second.size[0]);
        if self.nearest < RULE_FROM * across.sum {
            return None;
        }
        let points = across.rule(self.nearest).points(across.distance);
        let values = self.smooth_at(points.map(|(x, _)| x));
        let smooth: f64 = points.iter().zip(values).map(|((_, weight), value)| weight * value).sum();
        let log = mean_log_apart(across.distance, across.halves[0], across.halves[1]);
        let apart = match self.absolute {
            0.0 => 0.0,
            _ if across.distance >= across.sum => across.distance,
            _ => across.second_difference(|x| x.abs().powi(3) / 6.0),
        };
        Some(smooth + self.logarithm * log + self.absolute * apart)
    }

    /// Returns the smooth part at several points by Clenshaw's recurrence.
    fn smooth_at(&self, x: [f64; 5]) -> [f64; 5] {
        let at = x.map(|x| x * x * self.scale - 1.0);
        let (mut next, mut after) = ([0.0; 5], [0.0; 5]);
        for coefficient in self.smooth[1..].iter().rev() {
            for k in 0..x.len() {
                (next[k], after[k]) = (coefficient + 2.0 * at[k] * next[k] - after[k], next[k]);
            }
        }
        from_fn(|k| self.smooth[0] + at[k] * next[k] - after[k])
    }
}

/// Returns the coefficients of the Chebyshev polynomials that interpolate a function on -1 .. 1.
fn chebyshev(terms: usize, function: impl Fn(f64) -> f64) -> Vec<f64> {
    let cosines: Vec<f64> = (0..4 * terms).map(|k| (0.5 * PI * k as f64 / terms as f64).cos()).collect();
    let values: Vec<f64> = (0..terms).map(|node| function(cosines[2 * node + 1])).collect();
    let coefficient = |order: usize| {
        let product = |(node, value): (usize, &f64)| value * cosines[order * (2 * node + 1) % (4 * terms)];
        let sum: f64 = values.iter().enumerate().map(product).sum();
        sum * if order == 0 { 1.0 } else { 2.0 } / terms as f64
    };
    (0..terms).map(coefficient).collect()
}

#[cfg(test)]
mod tests {
    use super::super::half_space::mean_inverse_distance;
    use super::super::image::tests::cell;
    use super::*;

    /// Cells of several widths in strips that are equal, adjacent and a strip apart, also of
    /// different lengths.
    #[test]
    fn averages_are_those_of_pairs_of_cells() {
        let strip = |y: f64, length: f64| {
            let widths = [0.08, 0.08, 0.05, 0.02, 0.006, 0.006, 0.03, 0.08];
            let mut x = -0.2;
            widths
                .map(|width| {
                    x += width;
                    cell([x - 0.5 * width, y], [width, length])
                })
                .to_vec()
        };
        let strips = [strip(0.0, 1.2), strip(1.2, 1.2), strip(2.4, 1.2), strip(0.0, 1.2), strip(1.5, 1.8)];
        for first in &strips {
            for second in &strips {
                let pair = [first, second].map(|cells| Strip::of(cells).remove(0));
                let close = CloseStrips::new(&pair[0], &pair[1]).expect("the strips are long");
                for one in first {
                    for other in second {
                        let offset = [0, 1].map(|k: usize| one.center[k] - other.center[k]);
                        let halves = [one, other].map(|cell| cell.size.map(|size| 0.5 * size));
                        let exact = mean_inverse_distance(offset, halves[0], halves[1]);
                        let found = close.mean_inverse_distance(one, other).expect("the cells are narrow");
                        assert!(
                            (found / exact - 1.0).abs() < 1e-10,
                            "{one:?} {other:?}: {found:e} {exact:e}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn strips_and_cells_that_vary_too_fast_are_left_to_closed_forms() {
        let narrow = |length: f64| {
            Strip::of(&[cell([-5.0, 0.0], [1.0, length]), cell([5.0, 0.0], [1.0, length])]).remove(0)
        };
        assert!(CloseStrips::new(&narrow(0.1), &narrow(0.1)).is_none());
        let apart = Strip::of(&[cell([0.0, 10.0 + 3e-8], [1.0, 10.0])]).remove(0);
        assert!(CloseStrips::new(&narrow(10.0), &apart).is_none());
        let distant = Strip::of(&[cell([0.0, 45.0], [1.0, 10.0])]).remove(0);
        assert!(CloseStrips::new(&narrow(10.0), &distant).is_none());
        let close = CloseStrips::new(&narrow(10.0), &narrow(10.0)).expect("the strips are long");
        assert!(
            close.mean_inverse_distance(&cell([0.0; 2], [2.0, 10.0]), &cell([0.0; 2], [2.0, 10.0])).is_none()
        );
    }
}
