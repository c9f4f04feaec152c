//! Mollifiers: smooth distributions of unit force around a point of a profile, and the response of
//! the half-plane to them.
//!
//! Finite elements cannot resolve a concentrated force on their surface, and the logarithm of the
//! half-plane is singular under one. Both can respond to a force distributed over the *matching
//! depth* (report figure 2.1). A mollifier reproduces polynomials up to degree three: applied as
//! load and as observer, it leaves a function that is smooth over its width `w` unchanged to O(w⁴).
//! The difference between both responses is therefore the smooth part of the compliance itself, not
//! an average of it.
//!
//! See `docs/theory/compliance.md`.

use calyx_numerics::quadrature::gauss_legendre;
use nalgebra::{Matrix4, Vector4};

/// Number of coefficients of a mollifier's polynomial: `(1 - x²)²` times a cubic.
const COEFFICIENTS: usize = 8;

/// Mollifier `psi(s) = P(x) / width`, `x = (s - center) / width` in -1 ..= 1, zero elsewhere, with
/// continuous slope.
#[derive(Clone, Debug)]
pub struct Mollifier {
    /// Middle of the support, m.
    pub center: f64,
    /// Half of the length of the support, m.
    pub width: f64,
    /// Coefficients of `P`, by ascending power of `x`.
    polynomial: [f64; COEFFICIENTS],
}

impl Mollifier {
    /// Builds the mollifier on `center - width ..= center + width` of a force at `s`: the integral
    /// of `psi p` is `p(s)` for every cubic `p`. `s` lies in the support, but need not be its
    /// middle near the end of a profile.
    pub fn new(s: f64, center: f64, width: f64) -> Self {
        // Moments of (1 - x²)².
        let moment = |power: usize| {
            let m = power as f64;
            if power % 2 == 1 { 0.0 } else { 2.0 / (m + 1.0) - 4.0 / (m + 3.0) + 2.0 / (m + 5.0) }
        };
        let x = (s - center) / width;
        let moments = Matrix4::from_fn(|i, j| moment(i + j));
        let wanted = Vector4::new(1.0, x, x * x, x * x * x);
        // A Gram matrix of independent functions is always invertible.
        let cubic = moments.cholesky().map_or(Vector4::zeros(), |factor| factor.solve(&wanted));
        let mut polynomial = [0.0; COEFFICIENTS];
        for (power, &coefficient) in cubic.iter().enumerate() {
            polynomial[power] += coefficient;
            polynomial[power + 2] -= 2.0 * coefficient;
            polynomial[power + 4] += coefficient;
        }
        Self { center, width, polynomial }
    }

    /// Returns the ends of the support, m.
    pub fn support(&self) -> [f64; 2] {
        [self.center - self.width, self.center + self.width]
    }

    /// Returns the force per length, 1/m.
    pub fn value(&self, s: f64) -> f64 {
        let x = (s - self.center) / self.width;
        if x.abs() >= 1.0 {
            return 0.0;
        }
        self.polynomial_at(x) / self.width
    }

    fn polynomial_at(&self, x: f64) -> f64 {
        self.polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }
}

/// Selects the rule of [`FAR`] for the double integral over a pair, from the distance of either
/// mollifier to the support of the other; `None` for near pairs.
fn far_rule(a: &Mollifier, b: &Mollifier) -> Option<usize> {
    let apart = (a.center - b.center).abs();
    let distance = ((apart - b.width) / a.width).min((apart - a.width) / b.width);
    FAR.iter().rposition(|&(least, _)| distance >= least)
}

/// Mollifier at the quadrature points of its own support.
#[derive(Clone, Debug)]
pub struct MollifierSamples<T> {
    mollifier: Mollifier,
    /// Value and kernel data at the points of the rule for near pairs.
    near: Vec<(f64, T)>,
    /// Mollifier times the weight of the point, and kernel data, by rule of [`FAR`].
    points: Vec<Vec<(f64, T)>>,
}

/// Least distance of the singularity from the middle of a support, in halves of the support, and
/// number of quadrature points from there on. The error of the Gauss rule with `n` points for a
/// logarithm times a polynomial of degree seven is `r^-(2n - 7)`, `r = x + sqrt(x² - 1)`: here less
/// than 1e-14.
const FAR: [(f64, usize); 4] = [(2.0, 17), (3.0, 14), (6.0, 11), (12.0, 9)];

/// Quadrature for pairs of mollifiers.
#[derive(Clone, Debug)]
pub struct PairQuadrature {
    /// Rule for the potential of the logarithm, which has limited smoothness at the end of its
    /// mollifier's support.
    outer: Vec<(f64, f64)>,
    inner: Vec<(f64, f64)>,
    /// Rule for a kernel with a kink: on each piece approximately a polynomial of degree 16.
    kinked: Vec<(f64, f64)>,
    /// Rules of [`FAR`].
    far: Vec<Vec<(f64, f64)>>,
}

impl Default for PairQuadrature {
    fn default() -> Self {
        let far = FAR.map(|(_, points)| gauss_legendre(points)).to_vec();
        let [outer, inner, kinked] = [24, 32, 12].map(gauss_legendre);
        Self { outer, inner, kinked, far }
    }
}

impl PairQuadrature {
    /// Samples the support of a mollifier once: `place` returns the data of the kernel at an arc
    /// length.
    pub fn sampled<T>(&self, mollifier: &Mollifier, place: impl Fn(f64) -> T) -> MollifierSamples<T> {
        let at = |x: f64| mollifier.center + mollifier.width * x;
        let near = self.kinked.iter().map(|&(x, _)| (mollifier.value(at(x)), place(at(x)))).collect();
        let far =
            |&(x, weight): &(f64, f64)| (weight * mollifier.width * mollifier.value(at(x)), place(at(x)));
        let points = self.far.iter().map(|rule| rule.iter().map(far).collect()).collect();
        MollifierSamples { mollifier: mollifier.clone(), near, points }
    }

    /// Returns the double integral of `a(s) b(s') ln|s - s'|`.
    pub fn logarithm(&self, a: &Mollifier, b: &Mollifier) -> f64 {
        let Some(rule) = far_rule(a, b) else {
            return outer_integral(&self.outer, a, b, |s| self.log_potential(b, s));
        };
        let [a, b] = [a, b].map(|of| {
            let point = |&(x, weight): &(f64, f64)| (weight * of.polynomial_at(x), of.center + of.width * x);
            self.far[rule].iter().map(point)
        });
        let b: Vec<(f64, f64)> = b.collect();
        a.map(|(outer, s)| outer * b.iter().map(|(inner, other)| inner * (s - other).abs().ln()).sum::<f64>())
            .sum()
    }

    /// Returns the double integral of `a(s) b(s') f(s, s')`, where `f` is symmetric and smooth
    /// except where both points coincide. `f` takes the `place` data of both.
    pub fn mean<T: Copy>(
        &self,
        a: &MollifierSamples<T>,
        b: &MollifierSamples<T>,
        place: impl Fn(f64) -> T,
        f: impl Fn(T, T) -> f64,
    ) -> f64 {
        if let Some(rule) = far_rule(&a.mollifier, &b.mollifier) {
            let seen =
                |here: T| b.points[rule].iter().map(|&(inner, there)| inner * f(here, there)).sum::<f64>();
            return a.points[rule].iter().map(|&(outer, here)| outer * seen(here)).sum();
        }
        let [start, end] = b.mollifier.support();
        outer_integral(&self.kinked, &a.mollifier, &b.mollifier, |s| {
            let here = place(s);
            let part = |from: f64, to: f64| {
                if from == to {
                    return 0.0;
                }
                let half = 0.5 * (to - from);
                let mut sum = 0.0;
                for (&(x, weight), &known) in self.kinked.iter().zip(&b.near) {
                    let (value, there) = if (from, to) == (start, end) {
                        known
                    } else {
                        let other = from + half * (1.0 + x);
                        (b.mollifier.value(other), place(other))
                    };
                    sum += weight * value * f(here, there);
                }
                half * sum
            };
            let split = s.clamp(start, end);
            part(start, split) + part(split, end)
        })
    }

    /// Returns the integral of `b(s') ln|s - s'|`: in closed form near the support, where the
    /// logarithm is singular or nearly so; by quadrature further away, where the closed form would
    /// suffer from cancellation.
    fn log_potential(&self, b: &Mollifier, s: f64) -> f64 {
        let x = (s - b.center) / b.width;
        // The integral of the mollifier is 1, so the scale of the logarithm is a constant term.
        let scale = b.width.ln();
        if x.abs() > 1.2 {
            let rule = FAR.iter().rposition(|&(least, _)| x.abs() >= least);
            let rule = rule.map_or(&self.inner, |rule| &self.far[rule]);
            let part = |&(y, weight): &(f64, f64)| weight * b.polynomial_at(y) * (x - y).abs().ln();
            let sum: f64 = rule.iter().map(part).sum();
            return scale + sum;
        }
        // P about x: P(x + u) = sum of shifted[j] u^j.
        let mut shifted = b.polynomial;
        for i in 0..COEFFICIENTS {
            for j in (i..COEFFICIENTS - 1).rev() {
                shifted[j] += x * shifted[j + 1];
            }
        }
        let antiderivative = |u: f64| {
            if u == 0.0 {
                return 0.0;
            }
            let log = u.abs().ln();
            let mut power = 1.0;
            let mut sum = 0.0;
            for (j, coefficient) in shifted.iter().enumerate() {
                let next = (j + 1) as f64;
                power *= u;
                sum += coefficient * power / next * (log - 1.0 / next);
            }
            sum
        };
        scale + antiderivative(1.0 - x) - antiderivative(-1.0 - x)
    }
}

/// Integrates `a(s) potential(s)` in pieces on which the potential of `b` is smooth.
fn outer_integral(rule: &[(f64, f64)], a: &Mollifier, b: &Mollifier, potential: impl Fn(f64) -> f64) -> f64 {
    let [start, end] = a.support();
    let mut ends = vec![start];
    ends.extend(b.support().into_iter().filter(|&s| s > start && s < end));
    ends.push(end);
    let mut sum = 0.0;
    for piece in ends.windows(2) {
        let half = 0.5 * (piece[1] - piece[0]);
        for &(x, weight) in rule {
            let s = piece[0] + half * (1.0 + x);
            sum += weight * half * a.value(s) * potential(s);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_reproduced_also_off_the_middle() {
        for (s, center, width) in [(0.3, 0.3, 0.2), (0.1, 0.3, 0.2), (0.47, 0.3, 0.2)] {
            let psi = Mollifier::new(s, center, width);
            for power in 0..4 {
                let mean: f64 = gauss_legendre(12)
                    .iter()
                    .map(|&(x, weight)| {
                        let at = center + width * x;
                        weight * width * psi.value(at) * at.powi(power)
                    })
                    .sum();
                assert!((mean - s.powi(power)).abs() < 1e-12, "power {power} at {s}: {mean}");
            }
        }
    }

    /// Computes the same integral with every piece cut into panels graded towards the singularity.
    fn by_brute_force(a: &Mollifier, b: &Mollifier) -> f64 {
        let rule = gauss_legendre(16);
        let graded = |f: &dyn Fn(f64) -> f64, from: f64, to: f64| {
            // Geometric panels towards `from`.
            let mut sum = 0.0;
            let mut outer = 1.0;
            for _ in 0..40 {
                let inner = outer * 0.5;
                let (p, q) = (from + inner * (to - from), from + outer * (to - from));
                let half = 0.5 * (q - p);
                sum += rule.iter().map(|&(x, w)| w * half * f(p + half * (1.0 + x))).sum::<f64>();
                outer = inner;
            }
            sum
        };
        let [start, end] = b.support();
        let inner = |s: f64| {
            let f = |other: f64| b.value(other) * (s - other).abs().max(f64::MIN_POSITIVE).ln();
            if s <= start || s >= end {
                if s <= start { graded(&f, start, end) } else { -graded(&f, end, start) }
            } else {
                graded(&f, s, end) - graded(&f, s, start)
            }
        };
        let [from, to] = a.support();
        let mut ends = vec![from];
        ends.extend([start, end].into_iter().filter(|&s| s > from && s < to));
        ends.push(to);
        ends.windows(2)
            .map(|piece| {
                let middle = 0.5 * (piece[0] + piece[1]);
                let f = |s: f64| a.value(s) * inner(s);
                graded(&f, piece[0], middle) - graded(&f, piece[1], middle)
            })
            .sum()
    }

    #[test]
    fn logarithm_of_pairs_is_exact() {
        let quadrature = PairQuadrature::default();
        let a = Mollifier::new(0.3, 0.3, 0.1);
        for (s, center, width) in [
            (0.3, 0.3, 0.1),
            (0.31, 0.31, 0.08),
            (0.35, 0.38, 0.15),
            (0.5, 0.5, 0.1),
            (0.55, 0.55, 0.1),
            (2.0, 2.0, 0.2),
        ] {
            let b = Mollifier::new(s, center, width);
            let value = quadrature.logarithm(&a, &b);
            let brute = by_brute_force(&a, &b);
            // At the end of a support the potential behaves like x³ ln|x|: 24 points leave an error
            // of about 1e-10.
            assert!((value - brute).abs() < 2e-9, "at {s}: {value} against {brute}");
            assert!((value - quadrature.logarithm(&b, &a)).abs() < 2e-9);
        }
    }

    /// Tests both sides of each distance beyond which fewer points are used.
    #[test]
    fn pairs_far_from_each_other_take_fewer_points_and_lose_no_digit() {
        let quadrature = PairQuadrature::default();
        let a = Mollifier::new(0.05, 0.1, 0.1);
        for (distance, _) in FAR {
            for width in [0.1, 0.03] {
                let center = 0.1 + (distance * 1.0001) * 0.1 + width;
                let b = Mollifier::new(center, center, width);
                assert!(far_rule(&a, &b).is_some());
                let all = outer_integral(&quadrature.outer, &a, &b, |s| quadrature.log_potential(&b, s));
                let few = quadrature.logarithm(&a, &b);
                assert!((few - all).abs() < 3e-14, "{distance} {width}: {few} {all}");
            }
        }
    }

    #[test]
    fn mean_of_a_kink() {
        let quadrature = PairQuadrature::default();
        let kink = |s: f64, other: f64| 3.0 * (s - other).abs();
        let sampled = |center, width| quadrature.sampled(&Mollifier::new(center, center, width), |s| s);
        let mean = |a: &MollifierSamples<f64>, b: &MollifierSamples<f64>| quadrature.mean(a, b, |s| s, kink);
        let (a, b) = (sampled(0.0, 0.1), sampled(1.0, 0.2));
        assert!((mean(&b, &a) - 3.0).abs() < 1e-12);
        // With itself, the value is of the order of the width.
        let own = mean(&a, &a);
        assert!(own.abs() < 0.1 && own != 0.0);
        // A kernel with a kink and curvature terms, with four times as many points.
        let mut finer = quadrature.clone();
        finer.kinked = gauss_legendre(48);
        let curved = |s: f64, other: f64| {
            let apart = (s - other).abs();
            apart + if apart > 0.0 { apart * apart * apart.ln() } else { 0.0 }
        };
        for center in [0.0, 0.03, 0.1, 0.2, 0.25] {
            let mean = |quadrature: &PairQuadrature| {
                let [a, b] = [0.0, center].map(|at| quadrature.sampled(&Mollifier::new(at, at, 0.1), |s| s));
                quadrature.mean(&a, &b, |s| s, curved)
            };
            assert!((mean(&quadrature) - mean(&finer)).abs() < 1e-8, "{center}");
        }
    }
}
