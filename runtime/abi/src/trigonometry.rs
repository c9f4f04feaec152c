//! Sine and cosine: one polynomial for scalar code and for whole columns, with bitwise equal
//! results.
//!
//! Kinematic code consists mostly of sines and cosines, which vectorization makes cheap: eight
//! angles at a time with the instructions of this machine. Therefore the definition is
//! straight-line arithmetic without branches, tables or fused multiply-adds, which the compiler
//! vectorizes to two, four or eight lanes. Every operation is exact or rounded to nearest for any
//! width, so the width does not affect the bits.
//!
//! Argument reduction subtracts the nearest multiple `n` of pi/2 in three parts (Cody and Waite).
//! The products `n P1` and `n P2` are exact, and the rounding error of the second subtraction is
//! recovered, so the remainder is accurate to 2^-102. Minimax polynomials on -pi/4..pi/4 follow,
//! and the quadrant determines sign and exchange. The error is below 0.8 units in the last place.
//! Angles outside the range of the reduction use `libm`, one at a time: angles above [`LIMIT`];
//! remainders with too few accurate digits, as at the double next to pi; infinities; NaN.

/// Largest angle for which `n P1` is exact: 2^20 quarter revolutions.
const LIMIT: f64 = 1_647_000.0;
/// Smallest ratio of the remainder to the angle with sufficient digits.
const CANCELLED: f64 = 1.0 / (1u64 << 40) as f64;

const TWO_OVER_PI: f64 = std::f64::consts::FRAC_2_PI;
/// Adding it rounds to an integer, whose lowest bits are then those of the sum.
const TO_WHOLE: f64 = 1.5 * (1u64 << 52) as f64;
/// pi/2 in three parts: 33 bits, the next 33, and the next 53.
const P1: f64 = f64::from_bits(0x3ff9_21fb_5440_0000);
const P2: f64 = f64::from_bits(0x3dd0_b461_1a60_0000);
const P3: f64 = f64::from_bits(0x3ba3_198a_2e03_7073);

/// Polynomial for `(sin(r)/r - 1)/r^2` in `r^2`; relative error of the sine 2^-58.
const SINE: [f64; 6] = [
    -0.16666666666666632,
    0.008333333333322422,
    -0.00019841269829815096,
    2.755731369455517e-06,
    -2.505075854407543e-08,
    1.5896821376768944e-10,
];
/// Polynomial for `(cos(r) - 1 + r^2/2)/r^4` in `r^2`; error of the cosine 2^-64.
const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.0013888888888874136,
    2.4801587289489892e-05,
    -2.755731435465756e-07,
    2.087572360179884e-09,
    -1.1359665431826943e-11,
];

const SIGN: u64 = 1 << 63;

/// Returns sine and cosine of an angle in radians.
#[inline]
pub fn sincos(angle: f64) -> (f64, f64) {
    let (sine, cosine, holds) = ordinary(angle);
    if holds { (sine, cosine) } else { exceptional(angle) }
}

/// Computes sines and cosines of many angles with the bits of [`sincos`], by the widest
/// instructions of this machine. Elements beyond the shortest of the three slices are ignored.
pub fn sincos_columns(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq") {
            // SAFETY: the machine reports these instructions.
            return unsafe { eight_lanes(angles, sines, cosines) };
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: as above.
            return unsafe { four_lanes(angles, sines, cosines) };
        }
    }
    columns(angles, sines, cosines);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq")]
fn eight_lanes(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    columns(angles, sines, cosines);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn four_lanes(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    columns(angles, sines, cosines);
}

/// Loop that the compiler vectorizes to the width of its caller.
#[inline(always)]
fn columns(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    let count = angles.len().min(sines.len()).min(cosines.len());
    let (angles, sines, cosines) = (&angles[..count], &mut sines[..count], &mut cosines[..count]);
    let mut exceptions = 0u64;
    for i in 0..count {
        let (sine, cosine, holds) = ordinary(angles[i]);
        (sines[i], cosines[i]) = (sine, cosine);
        exceptions |= u64::from(!holds);
    }
    if exceptions != 0 {
        replace_exceptions(angles, sines, cosines);
    }
}

/// Replaces the results of angles that [`ordinary`] does not support by those of `libm`.
#[cold]
#[inline(never)]
fn replace_exceptions(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    for ((&angle, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
        (*sine, *cosine) = sincos(angle);
    }
}

#[cold]
#[inline(never)]
fn exceptional(angle: f64) -> (f64, f64) {
    libm::sincos(angle)
}

/// Returns sine, cosine, and whether they are valid.
#[inline(always)]
fn ordinary(angle: f64) -> (f64, f64, bool) {
    // The sine is odd and the cosine even, including the sign of a zero.
    let x = angle.abs();
    let shifted = x * TWO_OVER_PI + TO_WHOLE;
    let n = shifted - TO_WHOLE;
    let quadrant = shifted.to_bits();

    // Both subtractions are exact, or their error is: where n P2 exceeds t, the difference has few
    // enough digits.
    let t = x - n * P1;
    let w = n * P2;
    let r = t - w;
    let low = ((t - r) - w) - n * P3;
    let head = r + low;
    let tail = (r - head) + low;
    let holds = (x <= LIMIT) & (head.abs() >= x * CANCELLED);

    let z = head * head;
    let [s1, s2, s3, s4, s5, s6] = SINE;
    let p = s1 + z * (s2 + z * (s3 + z * (s4 + z * (s5 + z * s6))));
    let sine = head + (z * (head * p - 0.5 * tail) + tail);
    let [c1, c2, c3, c4, c5, c6] = COSINE;
    let q = c1 + z * (c2 + z * (c3 + z * (c4 + z * (c5 + z * c6))));
    let half = 0.5 * z;
    let rest = 1.0 - half;
    let cosine = rest + (((1.0 - rest) - half) + (z * (z * q) - head * tail));

    // All ones if an odd number of quarter revolutions exchanges the two.
    let exchange = (quadrant & 1).wrapping_neg();
    let difference = (sine.to_bits() ^ cosine.to_bits()) & exchange;
    let sine_sign = ((quadrant << 62) ^ angle.to_bits()) & SIGN;
    let cosine_sign = (quadrant.wrapping_add(1) << 62) & SIGN;
    let sine = f64::from_bits(sine.to_bits() ^ difference ^ sine_sign);
    let cosine = f64::from_bits(cosine.to_bits() ^ difference ^ cosine_sign);
    (sine, cosine, holds)
}

#[cfg(test)]
mod tests;
