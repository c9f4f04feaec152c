//! Continuations of a time history into the interval between two positions, from both sides.
//!
//! Let `L(t)` and `R(t)`, `0 <= t <= 1`, continue a time history into an interval from its left and
//! from its right end, each through positions on its own side alone. The model of the interval is
//!
//! ```text
//! f(t) = L(t) for t < s,   f(t) = R(t) for t > s,
//! ```
//!
//! with an unknown switch `s`. It covers all that a mesh cycle does between two positions. At a
//! kink, such as where a tooth pair takes up load or where the largest stress changes from one
//! tooth to the next, both continuations meet: `L(s) = R(s)`. Across a jump one of them ends. Where
//! the history is smooth, both agree but for their errors.
//!
//! A switch at `s` makes the history jump by `D(s) = L(s) - R(s)`. Histories are continuous but for
//! few jumps of any size, so `D` has a prior density with a heavy tail, the Cauchy density of a
//! width below all `D`. That gives `s` the density
//!
//! ```text
//! p(s) = D(s)^-2 / (integral of D^-2 over the interval),
//! ```
//!
//! which puts the switch where both meet, if they do, and otherwise close to where they nearly do.
//! The estimates are expectations over `s`: of the largest value, `max(max L over t <= s, max R
//! over t >= s)`, and of the integral. No constant is chosen.
//!
//! Two limits show why that is local. If one side is constant and the other leads to the same
//! value, as at the end of a plateau, `D` vanishes there and the largest value is that of the
//! plateau. If a history rises to a position by `d` in an interval and falls behind it by a slope
//! that the other side does not show, `D` is about the same over the interval and the largest value
//! is expected to lie up to `d / 2` above that position.

/// Parts of an interval in which the continuations are taken as linear.
const PARTS: usize = 16;
/// Fraction of the largest distance of the two continuations that counts as zero.
const NEGLIGIBLE: f64 = 1e-12;

/// A point of a time history: position and value.
pub(super) type Point = (f64, f64);

/// Both continuations at the ends of all parts of an interval.
#[derive(Clone, Debug)]
pub(super) struct Continuations {
    left: [f64; PARTS + 1],
    right: [f64; PARTS + 1],
}

/// The expected largest value in an interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct Largest {
    /// Expectation over all switches; no less than the values at the ends.
    pub expected: f64,
    /// Root mean square of the rise above a level.
    pub rise: f64,
}

impl Continuations {
    /// Continues a time history between two positions, from the points on either side, nearest
    /// first.
    ///
    /// A parabola neither rises nor falls faster than the line through the two nearest points. If
    /// the third point lies behind a kink or a jump, the parabola bends away without bound, while
    /// the line does not.
    pub fn new(points: &[Vec<Point>; 2], [from, to]: [f64; 2]) -> Continuations {
        let at = |points: &[Point], part: usize| {
            let x = from + part as f64 / PARTS as f64 * (to - from);
            let parabola = lagrange(points, x);
            match points {
                [nearest, next, _] => {
                    let line = lagrange(&[*nearest, *next], x);
                    nearest.1 + common_to(line - nearest.1, parabola - nearest.1)
                }
                _ => parabola,
            }
        };
        let [left, right] = [0, 1].map(|side: usize| std::array::from_fn(|part| at(&points[side], part)));
        Continuations { left, right }
    }

    /// Returns by how much each continuation misses the position at its other end.
    pub fn misses(&self) -> [f64; 2] {
        [self.left[PARTS] - self.right[PARTS], self.right[0] - self.left[0]]
    }

    fn distance(&self, point: usize) -> f64 {
        self.left[point] - self.right[point]
    }

    /// Returns whether both continuations meet in a part, or coincide.
    fn meets(&self, part: usize) -> bool {
        let [one, next] = [self.distance(part), self.distance(part + 1)];
        one * next < 0.0 || (one == 0.0 && next == 0.0)
    }

    /// Returns the probability of a switch in each part: with linear continuations the integral of
    /// `D^-2` over a part is its length divided by the product of `D` at its ends.
    fn probabilities(&self) -> [f64; PARTS] {
        let meeting = (0..PARTS).filter(|&part| self.meets(part)).count();
        if meeting > 0 {
            return std::array::from_fn(|part| if self.meets(part) { 1.0 / meeting as f64 } else { 0.0 });
        }
        let largest = (0..=PARTS).map(|point| self.distance(point).abs()).fold(0.0, f64::max);
        let distance = |point: usize| self.distance(point).abs() / largest + NEGLIGIBLE;
        let weights: [f64; PARTS] = std::array::from_fn(|part| (distance(part) * distance(part + 1)).recip());
        let sum: f64 = weights.iter().sum();
        weights.map(|weight| weight / sum)
    }

    /// Returns the switch in a part where both continuations meet, as a fraction of the part.
    fn meeting(&self, part: usize) -> f64 {
        let [one, next] = [self.distance(part), self.distance(part + 1)];
        if one == next { 0.5 } else { one / (one - next) }
    }

    /// Returns the expected location of a kink as a fraction of the interval: the two continuations
    /// change order between its ends.
    pub fn kink(&self) -> Option<f64> {
        if self.distance(0) * self.distance(PARTS) >= 0.0 {
            return None;
        }
        let at: Vec<f64> = (0..PARTS)
            .filter(|&part| self.meets(part))
            .map(|part| (part as f64 + self.meeting(part)) / PARTS as f64)
            .collect();
        if at.is_empty() { None } else { Some(at.iter().sum::<f64>() / at.len() as f64) }
    }

    /// Returns the largest value in the interval, and its rise above `level`.
    pub fn largest(&self, level: f64) -> Largest {
        let mut up_to = self.left;
        let mut from = self.right;
        for point in 1..=PARTS {
            up_to[point] = up_to[point].max(up_to[point - 1]);
            from[PARTS - point] = from[PARTS - point].max(from[PARTS - point + 1]);
        }
        let probabilities = self.probabilities();
        let (mut expected, mut square) = (0.0, 0.0);
        for (part, probability) in probabilities.into_iter().enumerate() {
            let mut largest = up_to[part].max(from[part + 1]);
            if self.meets(part) {
                let [one, next] = [self.left[part], self.left[part + 1]];
                largest = largest.max(one + self.meeting(part) * (next - one));
            }
            expected += probability * largest;
            square += probability * (largest - level).max(0.0).powi(2);
        }
        let end = self.left[0].max(self.right[PARTS]);
        Largest { expected: expected.max(end), rise: square.sqrt() }
    }

    /// Returns the expected mean over the interval minus that of the chord.
    pub fn above_chord(&self) -> f64 {
        let probabilities = self.probabilities();
        let [start, stop] = [self.left[0], self.right[PARTS]];
        let mut switched = 0.0;
        let mut sum = 0.0;
        for point in 0..=PARTS {
            let expected = (1.0 - switched) * self.left[point] + switched * self.right[point];
            let chord = start + point as f64 / PARTS as f64 * (stop - start);
            let weight = if point % PARTS == 0 { 0.5 } else { 1.0 };
            sum += weight * (expected - chord);
            switched += probabilities.get(point).copied().unwrap_or(0.0);
        }
        sum / PARTS as f64
    }
}

/// Returns the smaller of two deviations of equal sign; 0 for opposite signs.
fn common_to(one: f64, other: f64) -> f64 {
    if one * other > 0.0 { one.signum() * one.abs().min(other.abs()) } else { 0.0 }
}

/// Evaluates the interpolating polynomial through a few points.
fn lagrange(points: &[Point], x: f64) -> f64 {
    let term = |(index, &(own, value)): (usize, &Point)| {
        let others = points.iter().enumerate().filter(|(other, _)| *other != index);
        others.fold(value, |product, (_, (other, _))| product * (x - other) / (own - other))
    };
    points.iter().enumerate().map(term).sum()
}
