//! Complete elliptic integrals by the arithmetic-geometric mean.

use std::f64::consts::FRAC_PI_2;

/// Complete elliptic integrals of one complementary modulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elliptic {
    /// First kind, K(m).
    pub first: f64,
    /// Second kind, E(m).
    pub second: f64,
    /// D(m) = (K(m) - E(m)) / m, which stays accurate as m vanishes.
    pub difference: f64,
}

impl Elliptic {
    /// Computes the integrals of the complementary modulus k' = √(1-m) with 0 < k' <= 1.
    ///
    /// Source: Abramowitz and Stegun (1964), section 17.6. The sum of 2ⁿ⁻¹cₙ² is divided by m term
    /// by term, so that the difference of K and E has no cancellation.
    pub fn of_complementary_modulus(modulus: f64) -> Self {
        let (mut arithmetic, mut geometric) = (1.0, modulus);
        // c₀²/m = 1, c₁²/m = (1-k') / (4(1+k')), cₙ₊₁ = cₙ² / (4aₙ₊₁).
        let mut scaled = (1.0 - modulus) / (4.0 * (1.0 + modulus));
        let mut square = (1.0 - modulus) * (1.0 - modulus) / 4.0;
        let mut weight = 1.0;
        let mut sum = 0.5;
        loop {
            let mean = 0.5 * (arithmetic + geometric);
            geometric = (arithmetic * geometric).sqrt();
            arithmetic = mean;
            sum += weight * scaled;
            if square <= 1e-33 {
                break;
            }
            let next = 0.5 * (arithmetic + geometric);
            let ratio = square / (16.0 * next * next);
            scaled *= ratio;
            square *= ratio;
            weight *= 2.0;
        }
        let first = FRAC_PI_2 / arithmetic;
        let parameter = (1.0 - modulus) * (1.0 + modulus);
        let difference = first * sum;
        Self { first, second: first - parameter * difference, difference }
    }
}
