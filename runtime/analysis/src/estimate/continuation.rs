//! Continuations of a time history into the interval between two positions, from both sides.
//!
//! Let `L(t)` and `R(t)`, `0 <= t <= 1`, continue a time history into an interval from its left and
//! from its right end, each through positions on its own side alone. The model of the interval is
//! (Harten 1989, subcell resolution)
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
//! Each side is continued in two ways ([`Bend`]), because the third position may lie behind a kink
//! or a jump of its own. The estimates are the averages of both.
//!
//! Two limits show why that is local. If one side is constant and the other leads to the same
//! value, as at the end of a plateau, `D` vanishes there and the largest value is that of the
//! plateau. If a history rises to a position by `d` in an interval and falls behind it by a slope
//! that the other side does not show, `D` is about the same over the interval and the largest value
//! is expected to lie up to `d / 2` above that position.

/// Parts of an interval in which the continuations are taken as linear.
const PARTS: usize = 16;
/// Fraction of the largest distance of the two continuations that counts as zero, and of the values
/// for the deviation from a line.
const NEGLIGIBLE: f64 = 1e-12;

/// A point of a time history: position and value.
pub(super) type Point = (f64, f64);

/// How a continuation departs from the line through the two nearest points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    /// Follows the parabola through three points, but neither rises nor falls faster than the line.
    /// If the third point lies behind a kink, the parabola bends away without bound, while the line
    /// does not. Too flat where the history accelerates towards the interval.
    Limited,
    /// Uses the smallest second difference of the stencils: a stencil across a kink or a jump has a
    /// large one (Harten, Engquist, Osher and Chakravarthy 1987, essentially non-oscillatory
    /// interpolation). Too steep where the history accelerated only up to its last point.
    Smoothest,
}

impl Bend {
    pub const ALL: [Bend; 2] = [Bend::Limited, Bend::Smoothest];
}

/// Points on one side of an interval, nearest first.
#[derive(Clone, Debug)]
pub(super) struct Side {
    /// Up to three points; those behind the first one are of the other side if this side has only
    /// one.
    pub points: Vec<Point>,
    /// Stencils of this side, and one that includes the other end of the interval if the history is
    /// smooth there.
    pub stencils: Vec<[Point; 3]>,
}

impl Side {
    fn at(&self, x: f64, bend: Bend) -> f64 {
        let parabola = lagrange(&self.points, x);
        let [nearest, next, ..] = self.points[..] else { return parabola };
        let line = lagrange(&[nearest, next], x);
        let differences = self.stencils.iter().map(second_difference);
        let smallest = differences.min_by(|one, other| one.abs().total_cmp(&other.abs()));
        match bend {
            Bend::Limited => nearest.1 + common_to(line - nearest.1, parabola - nearest.1),
            Bend::Smoothest => smallest.map_or(parabola, |bent| line + bent * (x - nearest.0) * (x - next.0)),
        }
    }
}

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
    /// Continues a time history between two positions from both sides.
    pub fn new(sides: &[Side; 2], [from, to]: [f64; 2], bend: Bend) -> Continuations {
        let at = |side: &Side, part: usize| side.at(from + part as f64 / PARTS as f64 * (to - from), bend);
        let [left, right] = [0, 1].map(|side: usize| std::array::from_fn(|part| at(&sides[side], part)));
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

/// Returns the second divided difference of three points.
pub(super) fn second_difference(&[one, two, three]: &[Point; 3]) -> f64 {
    let slope = |from: Point, to: Point| (to.1 - from.1) / (to.0 - from.0);
    (slope(two, three) - slope(one, two)) / (three.0 - one.0)
}

/// Returns the magnitude of the change of slope that three points show. At a kink it does not
/// depend on their distances, unlike the second difference.
pub(super) fn slope_change(points: &[Point; 3]) -> f64 {
    (second_difference(points) * (points[2].0 - points[0].0)).abs()
}

/// Returns whether three points lie on a line, within rounding.
pub(super) fn is_straight(points: &[Point; 3]) -> bool {
    let span = (points[2].0 - points[0].0).powi(2);
    let magnitude: f64 = points.iter().map(|point| point.1.abs()).sum();
    second_difference(points).abs() * span <= NEGLIGIBLE * magnitude
}
