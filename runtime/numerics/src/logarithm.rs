//! Natural logarithms of many numbers.
//!
//! The loop has no branches and no calls, so that the compiler vectorizes it; every operation is
//! exact or rounded to nearest, so the width of the vectors does not change the bits.

/// Difference between the bits of 1 and of the square root of 1/2.
const FROM_ROOT: u64 = 0x3ff0_0000_0000_0000 - 0x3fe6_a09e_667f_3bcd;
/// Bits of 2⁵²: integers below 2⁵² in the mantissa are added to it.
const INTEGER: u64 = 0x4330_0000_0000_0000;
const MANTISSA: u64 = (1 << 52) - 1;
/// ln 2 as a sum; multiples of the first part by exponents are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
/// Coefficients of the minimax polynomial of `(ln(1 + s) - ln(1 - s) - 2 s) / s` in s² by Sun
/// Microsystems (fdlibm, `e_log.c`, 1993); error below 2^-58.
const SERIES: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];

/// Replaces every number by its natural logarithm, with an error below one unit in the last place.
/// Numbers are positive and not subnormal; the result for zero is finite.
///
/// Source: `e_log.c` of fdlibm.
pub fn replace_by_logarithms(values: &mut [f64]) {
    for value in values {
        *value = ln(*value);
    }
}

#[inline(always)]
fn ln(x: f64) -> f64 {
    // x = 2^exponent * m with m between the roots of 1/2 and of 2.
    let shifted = x.to_bits().wrapping_add(FROM_ROOT);
    let exponent = f64::from_bits((shifted >> 52) | INTEGER) - f64::from_bits(INTEGER + 1023);
    let m = f64::from_bits((shifted & MANTISSA).wrapping_sub(FROM_ROOT).wrapping_add(1023 << 52));
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let [c1, c2, c3, c4, c5, c6, c7] = SERIES;
    let odd = z * (c1 + w * (c3 + w * (c5 + w * c7)));
    let even = w * (c2 + w * (c4 + w * c6));
    let half_square = 0.5 * f * f;
    let rest = s * (half_square + (odd + even)) + exponent * LN_2[1];
    exponent * LN_2[0] - ((half_square - rest) - f)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_are_accurate_to_one_unit_in_the_last_place() {
        let mut numbers = vec![f64::MIN_POSITIVE, 1e-300, 0.5, 1.0, 2.0, f64::MAX, 1.0 + f64::EPSILON];
        let (mut x, mut y) = (1e-18, 0.6);
        while x < 1e3 {
            numbers.extend([x, y]);
            x *= 1.001_7;
            y += 3.1e-5;
        }
        let mut found = numbers.clone();
        replace_by_logarithms(&mut found);
        for (x, found) in numbers.into_iter().zip(found) {
            let expected = x.ln();
            let error = (found - expected).abs() / (expected.abs() * f64::EPSILON).max(f64::MIN_POSITIVE);
            assert!(error <= 1.0, "{x:e}: {found:e}, {expected:e}");
        }
        let mut zero = [0.0];
        replace_by_logarithms(&mut zero);
        assert!(zero[0].is_finite());
    }
}
