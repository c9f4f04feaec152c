//! Hertz contact of parallel cylinders, and load against deflection of a roller.

use crate::material::Material;
use libm::{cbrt, pow};
use std::f64::consts::PI;

/// Coefficient of a lamina model in ISO/TS 16281, N/mm^{10/9} at 1 mm length, for steel: the load
/// of a roller between two raceways is 35948 L^{8/9} δ^{10/9} with lengths in mm.
const ROLLER_COEFFICIENT: f64 = 35948.0;

/// Exponent of the load against deflection of a line contact.
pub const EXPONENT: f64 = 10.0 / 9.0;

/// Returns the half-width of a line contact, m, from load per length, N/m, effective radius, m, and
/// composite modulus, Pa.
///
/// Source: Johnson, Contact Mechanics (1985), equation 4.43.
pub fn half_width(load: f64, radius: f64, modulus: f64) -> f64 {
    (4.0 * load.max(0.0) * radius / (PI * modulus)).sqrt()
}

/// Returns the largest pressure of a line contact, Pa, from load per length, N/m, effective radius,
/// m, and composite modulus, Pa.
///
/// Source: Johnson, Contact Mechanics (1985), equation 4.45.
pub fn pressure(load: f64, radius: f64, modulus: f64) -> f64 {
    (load.max(0.0) * modulus / (PI * radius)).sqrt()
}

/// Returns the load per length of a largest pressure, N/m.
pub fn load_of_pressure(pressure: f64, radius: f64, modulus: f64) -> f64 {
    pressure * pressure * PI * radius / modulus
}

/// Returns the coefficient c of one contact of a roller, N/m^{10/9}: the load is c δ^{10/9} with
/// the approach of this contact alone.
///
/// ISO/TS 16281 has the coefficient of both contacts in series and for steel. One of two equal
/// contacts is 2^{10/9} times as stiff, and the deflection of an elastic contact under a load
/// depends on the ratio of load to modulus.
pub fn coefficient(length: f64, modulus: f64) -> f64 {
    let steel = crate::material::composite_modulus(&Material::STEEL, &Material::STEEL);
    // N/mm^{10/9} · mm^{-8/9} · m^{8/9}: the powers of 1000 add up to 1000².
    1e6 * ROLLER_COEFFICIENT * pow(2.0, EXPONENT) * pow(length, 8.0 / 9.0) * modulus / steel
}

/// Returns δ^{1/9} of a positive number with a relative error of about 1e-16.
///
/// A division of the bits gives a first value within 3.3 %, and Halley's method cubes its error;
/// this is twice as fast as two cube roots, and laminae take most of the time of a roller bearing.
#[inline]
pub(crate) fn ninth_root(value: f64) -> f64 {
    /// Bits of 1.0 times 8/9, less what makes the largest errors to both sides equal.
    const BIAS: u64 = 0x38D4_B555_5555_5555;
    if value < 1e-280 {
        return cbrt(cbrt(value));
    }
    let mut root = f64::from_bits(value.to_bits() / 9 + BIAS);
    for _ in 0..3 {
        let square = root * root;
        let fourth = square * square;
        let ninth = fourth * fourth * root;
        root *= (4.0 * ninth + 5.0 * value) / (5.0 * ninth + 4.0 * value);
    }
    root
}
