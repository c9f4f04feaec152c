//! Response of the half-space to loads that are mollifiers across a flank and polynomials along it.
//!
//! The mean of `1/r` over two such loads is an integral over four variables. On a helical surface
//! the distance of two points depends on their coordinates across the flank and on the difference
//! of the axial coordinates alone; the distance to an image in a side face also depends on their
//! sum. With `q = v - v'` the difference and `t` the axial distance (`|q|` itself, or to the image
//! `2 z - v - v'`), both are `r² = |R(rate q) p(u) - p(u')|² + t²`: `|q| = t` for the load itself,
//! `|q| <= t` for its images. So one function of `t` and `q / t` covers the load and its images in
//! both faces, and the distribution of products of polynomials over it is the same for all pairs of
//! coordinates across. The integrals over `u - u'` and `t` are graded towards the point where both
//! vanish.

use super::axial_modes::AxialModes;
use super::screw::Screw;
use crate::kernel::Mollifier;
use calyx_numerics::interpolation::lagrange;
use calyx_numerics::quadrature::gauss_legendre;
use faer::Mat;

/// Sampling points of `q / t` on a twisted surface (Gauss-Lobatto points): the distance is nearly a
/// quadratic function of it.
const DIRECTIONS: [f64; 6] = [
    -1.0,
    -0.765_055_323_929_464_7,
    -0.285_231_516_480_645_1,
    0.285_231_516_480_645_1,
    0.765_055_323_929_464_7,
    1.0,
];
/// Quadrature points over the sum of `u` and `u'`: exact for the product of two mollifiers.
pub(super) const ACROSS: usize = 8;
/// Sampling points of that sum at which the distance is computed: it hardly depends on it.
pub(super) const PLACES: usize = 4;
/// Points on each panel of graded quadrature over `u - u'`.
pub(super) const POINTS: usize = 12;
/// Largest ratio of the length of a panel to its distance from the singularity.
pub(super) const GRADING: f64 = 8.0;
/// Length of the finest panel, relative to the smallest width of a mollifier.
pub(super) const FINEST: f64 = 1e-4;

/// Means of `1/r`, with images, over pairs of loads on a helical surface.
pub(crate) struct ReciprocalMeans {
    screw: Screw,
    modes: usize,
    panels: Vec<Panel>,
    /// Distribution of the products of modes over the points of all panels: rows by point, columns
    /// by `n * modes + m`, n the observer.
    spread: Mat<f64>,
    /// Sampling points of the sum of `u` and `u'` on -1 ..= 1, with the weights that quadrature
    /// points have on them.
    across: Vec<f64>,
    onto_places: Vec<(f64, f64, Vec<f64>)>,
    along: Vec<(f64, f64)>,
    finest: f64,
}

/// Interval of `t`. Its points are numbered direction by direction.
struct Panel {
    from: f64,
    squares: Vec<f64>,
    /// Cosine and sine of `rate q` at each point, for each direction.
    rotations: Vec<Vec<[f64; 2]>>,
}

impl ReciprocalMeans {
    /// Prepares the means. `mirrored`: whether there are images in the faces at the start and the
    /// end of the axial range. `smallest` is the least width of a mollifier, m.
    pub fn new(screw: Screw, modes: &AxialModes, mirrored: [bool; 2], smallest: f64) -> Self {
        let length = modes.length();
        let finest = FINEST * smallest;
        let mut ends = vec![2.0 * length, length];
        while ends[ends.len() - 1] > finest {
            ends.push(ends[ends.len() - 1] / GRADING);
        }
        ends.push(0.0);
        ends.reverse();
        if mirrored == [false; 2] {
            ends.pop();
        }
        // Without a twist the direction does not matter.
        let directions = if screw.rate == 0.0 { vec![1.0] } else { DIRECTIONS.to_vec() };
        let (mut panels, mut rows) = (Vec::new(), Vec::<Vec<f64>>::new());
        for interval in ends.windows(2) {
            // On a long panel the products of polynomials vary too.
            let long = interval[1] * GRADING > 0.5 * length;
            let rule = gauss_legendre(if long { POINTS.max(modes.count() + 4) } else { POINTS });
            let half = 0.5 * (interval[1] - interval[0]);
            let points = || rule.iter().map(|(x, weight)| (interval[0] + half * (1.0 + x), half * weight));
            let rotations = |&direction: &f64| {
                points()
                    .map(|(t, _)| {
                        let (sin, cos) = (screw.rate * t * direction).sin_cos();
                        [cos, sin]
                    })
                    .collect()
            };
            panels.push(Panel {
                from: interval[0],
                squares: points().map(|(t, _)| t * t).collect(),
                rotations: directions.iter().map(rotations).collect(),
            });
            let first = rows.len();
            rows.resize(first + directions.len() * rule.len(), vec![0.0; modes.count() * modes.count()]);
            for (point, (t, weight)) in points().enumerate() {
                spread_at(modes, mirrored, &directions, t, |direction, n, m, value| {
                    rows[first + direction * rule.len() + point][n * modes.count() + m] += weight * value;
                });
            }
        }
        let spread = Mat::from_fn(rows.len(), modes.count() * modes.count(), |row, column| rows[row][column]);
        let across: Vec<f64> = gauss_legendre(PLACES).into_iter().map(|(place, _)| place).collect();
        let onto = |(x, weight)| (x, weight, lagrange(&across, x));
        let onto_places = gauss_legendre(ACROSS).into_iter().map(onto).collect();
        let along = gauss_legendre(POINTS);
        Self { screw, modes: modes.count(), panels, spread, across, onto_places, along, finest }
    }

    /// Returns the means over an observer `a` times a polynomial and a load `b` times another: rows
    /// by the observer's polynomial, 1/m.
    pub fn between(&self, a: &Mollifier, b: &Mollifier) -> Mat<f64> {
        let mut at_points = Vec::with_capacity(self.spread.nrows());
        for panel in &self.panels {
            self.add_panel(panel, a, b, &mut at_points);
        }
        Mat::from_fn(self.modes, self.modes, |n, m| {
            let column = self.spread.col(n * self.modes + m);
            column.iter().zip(&at_points).map(|(share, value)| share * value).sum()
        })
    }

    /// Adds the means over both mollifiers at the points of one panel.
    fn add_panel(&self, panel: &Panel, a: &Mollifier, b: &Mollifier, at_points: &mut Vec<f64>) {
        let points = panel.squares.len();
        let mut means = vec![0.0; points * panel.rotations.len()];
        let ([a_start, a_end], [b_start, b_end]) = (a.support(), b.support());
        for interval in differences(a, b, self.finest.max(2.0 * panel.from)).windows(2) {
            let half = 0.5 * (interval[1] - interval[0]);
            for (x, along) in &self.along {
                let difference = interval[0] + half * (1.0 + x);
                // Half the sum of `u` and `u'`.
                let from = (a_start - 0.5 * difference).max(b_start + 0.5 * difference);
                let to = (a_end - 0.5 * difference).min(b_end + 0.5 * difference);
                let half_across = 0.5 * (to - from);
                let half_difference = 0.5 * difference;
                let sum_at = |y: f64| from + half_across * (1.0 + y);
                let mut weights = [0.0; PLACES];
                for (y, across, shares) in &self.onto_places {
                    let product =
                        a.value(sum_at(*y) + half_difference) * b.value(sum_at(*y) - half_difference);
                    for (sum, share) in weights.iter_mut().zip(shares) {
                        *sum += half * along * half_across * across * product * share;
                    }
                }
                for (&y, weight) in self.across.iter().zip(weights) {
                    let [x1, y1] = self.screw.profile(sum_at(y) + half_difference);
                    let [x2, y2] = self.screw.profile(sum_at(y) - half_difference);
                    for (rotations, means) in panel.rotations.iter().zip(means.chunks_exact_mut(points)) {
                        for ((&[cos, sin], square), mean) in rotations.iter().zip(&panel.squares).zip(means) {
                            let dx = cos * x1 - sin * y1 - x2;
                            let dy = sin * x1 + cos * y1 - y2;
                            *mean += weight / (dx * dx + dy * dy + square).sqrt();
                        }
                    }
                }
            }
        }
        at_points.extend(means);
    }
}

/// Returns the ends of the panels over `u - u'`, ascending. On each panel the product of the
/// mollifiers is smooth. Panels next to zero are no shorter than `finest`.
pub(super) fn differences(a: &Mollifier, b: &Mollifier, finest: f64) -> Vec<f64> {
    let apart = a.center - b.center;
    let (sum, rest) = (a.width + b.width, (a.width - b.width).abs());
    let mut ends = vec![apart - sum, apart - rest, apart + rest, apart + sum];
    if ends[0] < 0.0 && ends[3] > 0.0 {
        ends.push(0.0);
    }
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let mut all = vec![ends[0]];
    for pair in ends.windows(2) {
        let inner = graded(pair[0].abs().min(pair[1].abs()), pair[0].abs().max(pair[1].abs()), finest);
        if pair[1] <= 0.0 {
            all.extend(inner.into_iter().rev().map(|distance| -distance));
        } else {
            all.extend(inner);
        }
        all.push(pair[1]);
    }
    all
}

/// Returns ascending distances at which an interval between two others is cut.
fn graded(near: f64, far: f64, finest: f64) -> Vec<f64> {
    let mut cuts = Vec::new();
    let mut end = far;
    while end - near > finest.max((GRADING - 1.0) * near) {
        end /= GRADING;
        if end <= near {
            break;
        }
        cuts.push(end);
    }
    cuts.reverse();
    cuts
}

/// Computes the distribution of products of modes over the directions at axial distance `t`: of the
/// load itself and of its images.
fn spread_at(
    modes: &AxialModes,
    mirrored: [bool; 2],
    directions: &[f64],
    t: f64,
    mut add: impl FnMut(usize, usize, usize, f64),
) {
    let ([start, end], length) = (modes.range(), modes.length());
    let mut product = |direction: usize, [v, other]: [f64; 2], weight: f64| {
        let (observer, load) = (modes.values(v), modes.values(other));
        for (n, a) in observer.iter().enumerate() {
            for (m, b) in load.iter().enumerate() {
                add(direction, n, m, weight * a * b);
            }
        }
    };
    if t < length {
        // The observer is ahead of the load or behind it.
        let last = directions.len() - 1;
        for (behind, weight) in modes.quadrature([start, end - t], 0) {
            product(last, [behind + t, behind], weight);
            product(0, [behind, behind + t], weight);
        }
    }
    if mirrored == [false; 2] {
        return;
    }
    let reach = t.min(2.0 * length - t);
    for (q, weight) in modes.quadrature([-reach, reach], DIRECTIONS.len()) {
        for (direction, share) in lagrange(directions, q / t).into_iter().enumerate() {
            // dv dv' = dq dt / 2.
            let weight = 0.5 * weight * share;
            if mirrored[0] {
                product(direction, [start + 0.5 * (t + q), start + 0.5 * (t - q)], weight);
            }
            if mirrored[1] {
                product(direction, [end - 0.5 * (t - q), end - 0.5 * (t + q)], weight);
            }
        }
    }
}

#[cfg(test)]
mod tests;
