//! Pairs of strips whose interaction depends on their half-widths, as piecewise polynomials.

use super::integral::{Expansion, Integral};
use crate::linear::dot;
use std::f64::consts::PI;

/// Number of Chebyshev points of a piece. The nearest singularity leaves an error of 5.8 to this
/// negative power, which rounding exceeds.
const POINTS: usize = 18;
/// Largest number of pieces.
const PIECES: u32 = 6;
/// Chebyshev coefficients below this part of the pair's lengths are rounding errors.
const ROUNDING: f64 = 1e-17;

/// Points and transformation of a polynomial that agrees with a function at Chebyshev points.
pub(super) struct Rule {
    /// Points from -1 to 1.
    points: [f64; POINTS],
    /// Factors of the values in each Chebyshev coefficient.
    transform: [[f64; POINTS]; POINTS],
    /// Powers of the variable in each Chebyshev polynomial.
    powers: [[f64; POINTS]; POINTS],
}

impl Rule {
    pub fn new() -> Self {
        let angle = |k: usize| PI * (k as f64 + 0.5) / POINTS as f64;
        let mut rule = Self {
            points: [0.0; POINTS],
            transform: [[0.0; POINTS]; POINTS],
            powers: [[0.0; POINTS]; POINTS],
        };
        for k in 0..POINTS {
            rule.points[k] = libm::cos(angle(k));
            for order in 0..POINTS {
                let factor = if order == 0 { 1.0 } else { 2.0 };
                rule.transform[order][k] = factor * libm::cos(order as f64 * angle(k)) / POINTS as f64;
            }
        }
        // T₀ = 1, T₁ = x, Tₖ₊₁ = 2 x Tₖ - Tₖ₋₁.
        rule.powers[0][0] = 1.0;
        rule.powers[1][1] = 1.0;
        for order in 2..POINTS {
            for k in 0..POINTS {
                let raised = if k > 0 { rule.powers[order - 1][k - 1] } else { 0.0 };
                rule.powers[order][k] = 2.0 * raised - rule.powers[order - 2][k];
            }
        }
        rule
    }
}

/// Pair of strips: the sum of its integrals as a function of the mean square q of both half-widths.
///
/// The sum is `P(q) + root √q + logarithm ln q`, and P is analytic up to the singularity -g. With
/// g + q from g 2ᵏ to g 2ᵏ⁺¹, P is a polynomial. Its value and derivatives take a tenth of the time
/// of the integrals.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Near {
    pub first: usize,
    pub second: usize,
    integrals: Vec<Integral>,
    root: f64,
    logarithm: f64,
    /// Distance g of the singularity, m².
    singularity: f64,
    /// Coefficients of each piece, of a variable from -1 to 1.
    pieces: Vec<Vec<f64>>,
}

impl Near {
    /// Prepares the polynomials of a pair up to a half-width, m.
    pub fn new(rule: &Rule, [first, second]: [usize; 2], integrals: Vec<Integral>, half_width: f64) -> Self {
        let mut total = Expansion::default();
        let mut singularity = f64::INFINITY;
        for integral in &integrals {
            let own = integral.expansion();
            total.root += own.root;
            total.logarithm += own.logarithm;
            total.size = total.size.max(own.size);
            singularity = singularity.min(own.singularity);
        }
        let mut near = Self {
            first,
            second,
            integrals,
            root: total.root,
            logarithm: total.logarithm,
            singularity,
            pieces: Vec::new(),
        };
        for piece in 0..PIECES {
            let (middle, half) = near.bounds(piece);
            if middle - half > half_width * half_width {
                break;
            }
            near.pieces.push(near.polynomial(rule, middle, half, ROUNDING * total.size));
        }
        near
    }

    /// Returns the middle and half of the length of the interval of q of a piece, m².
    fn bounds(&self, piece: u32) -> (f64, f64) {
        let start = self.singularity * f64::from(1u32 << piece);
        (1.5 * start - self.singularity, 0.5 * start)
    }

    /// Returns the coefficients of the polynomial that agrees with P at Chebyshev points.
    fn polynomial(&self, rule: &Rule, middle: f64, half: f64, rounding: f64) -> Vec<f64> {
        let values = rule.points.map(|point| {
            let square = middle + half * point;
            let sum: f64 = self.integrals.iter().map(|integral| integral.evaluate(square)[0]).sum();
            sum - self.root * square.sqrt() - self.logarithm * libm::log(square)
        });
        let orders: Vec<f64> = rule.transform.iter().map(|row| dot(row, &values)).collect();
        let count = orders.iter().rposition(|order| order.abs() >= rounding).map_or(0, |last| last + 1);
        let mut result = vec![0.0; count];
        for (order, powers) in orders[..count].iter().zip(&rule.powers) {
            for (sum, power) in result.iter_mut().zip(powers) {
                *sum += order * power;
            }
        }
        result
    }

    /// Returns the sum of the integrals with its first and second derivative with respect to the
    /// mean square of both half-widths.
    #[inline]
    pub fn evaluate(&self, square: f64) -> [f64; 3] {
        // The exponent of two is that of the piece.
        let ratio = 1.0 + square / self.singularity;
        let piece = (ratio.to_bits() >> 52) as usize - 1023;
        let Some(coefficients) = self.pieces.get(piece) else {
            return self.by_integrals(square);
        };
        let (middle, half) = self.bounds(piece as u32);
        let inverse = 1.0 / half;
        let x = (square - middle) * inverse;
        let [mut value, mut slope, mut bend] = [0.0; 3];
        for coefficient in coefficients.iter().rev() {
            bend = bend * x + slope;
            slope = slope * x + value;
            value = value * x + coefficient;
        }
        let mut sums = [value, slope * inverse, 2.0 * bend * inverse * inverse];
        if self.root != 0.0 {
            let root = square.sqrt();
            let slope = 0.5 * self.root / root;
            sums[0] += self.root * root;
            sums[1] += slope;
            sums[2] -= 0.5 * slope / square;
        }
        if self.logarithm != 0.0 {
            let slope = self.logarithm / square;
            sums[0] += self.logarithm * libm::log(square);
            sums[1] += slope;
            sums[2] -= slope / square;
        }
        sums
    }

    /// Evaluates the integrals themselves.
    #[cold]
    fn by_integrals(&self, square: f64) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for integral in &self.integrals {
            let terms = integral.evaluate(square);
            for k in 0..3 {
                sums[k] += terms[k];
            }
        }
        sums
    }
}
