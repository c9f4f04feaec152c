//! The single scalar definition of every numeric operation.
//!
//! Constant folding, the interpreters, machine code in memory and object files all use these
//! definitions, so their results are bitwise equal (except for the sign and payload of a NaN, which
//! IEEE 754 leaves open). Sine and cosine are implemented in [`crate::trigonometry`]; the other
//! transcendental functions come from `libm` (pure Rust), never from the system. Multiply-adds are
//! never fused.
//!
//! `+ - * /` and [`sqrt`] are IEEE 754 operations rounded to nearest, so machine code uses its own
//! instructions; likewise [`abs`], [`min`], [`max`] and the comparisons. All other operations are
//! *called*: the macro below defines a symbol `calyx_math_<name>` of C linkage for each, and its
//! row in [`FUNCTIONS`].
//!
//! Booleans are 1.0 and 0.0; any value not equal to zero, including NaN, counts as true. No
//! operation traps.

use crate::newton::calyx_math_unsolved;
use crate::piecewise::{calyx_math_piecewise, calyx_math_spline};

/// Tolerance of the length of a unit vector. It covers components rounded to six digits.
pub const UNIT_TOLERANCE: f64 = 1e-6;

/// Returns whether a vector of this length counts as a unit vector.
pub fn is_unit(length: f64) -> bool {
    (length - 1.0).abs() <= UNIT_TOLERANCE
}

/// Converts a Boolean to a number.
#[inline]
pub fn truth(condition: bool) -> f64 {
    if condition { 1.0 } else { 0.0 }
}

#[inline]
pub fn abs(x: f64) -> f64 {
    x.abs()
}

/// Square root, correctly rounded; NaN below zero, `sqrt(-0) = -0`.
#[inline]
pub fn sqrt(x: f64) -> f64 {
    x.sqrt()
}

/// Returns the smaller of two numbers; NaN if either is NaN; `-0 < +0` (`minimum` of IEEE
/// 754-2019).
#[inline]
pub fn min(a: f64, b: f64) -> f64 {
    if a < b {
        a
    } else if b < a {
        b
    } else if a == b {
        // Equal numbers have different bits only if they are zeros of opposite sign: the negative
        // one is the minimum.
        f64::from_bits(a.to_bits() | b.to_bits())
    } else {
        a + b
    }
}

/// Returns the larger of two numbers; NaN if either is NaN; `-0 < +0` (`maximum` of IEEE 754-2019).
#[inline]
pub fn max(a: f64, b: f64) -> f64 {
    if a > b {
        a
    } else if b > a {
        b
    } else if a == b {
        f64::from_bits(a.to_bits() & b.to_bits())
    } else {
        a + b
    }
}

/// `a < b`; false if either is NaN.
#[inline]
pub fn less(a: f64, b: f64) -> f64 {
    truth(a < b)
}

/// `a <= b`; false if either is NaN.
#[inline]
pub fn less_equal(a: f64, b: f64) -> f64 {
    truth(a <= b)
}

/// `a == b`; false if either is NaN; zeros of opposite sign are equal.
#[inline]
pub fn equal(a: f64, b: f64) -> f64 {
    truth(a == b)
}

#[inline]
pub fn not(a: f64) -> f64 {
    truth(a == 0.0)
}

#[inline]
pub fn and(a: f64, b: f64) -> f64 {
    truth(a != 0.0 && b != 0.0)
}

#[inline]
pub fn or(a: f64, b: f64) -> f64 {
    truth(a != 0.0 || b != 0.0)
}

/// `a` if the condition is true, else `b`.
#[inline]
pub fn select(condition: f64, a: f64, b: f64) -> f64 {
    if condition != 0.0 { a } else { b }
}

pub use crate::trigonometry::{sincos, sincos_columns};

/// Returns `x` to an integer power from -2 to 8 by products; `None` for any other exponent. [`pow`]
/// and expressions compute these powers in the same way, so all have the same bits.
///
/// The error of squares is at most half a unit in the last place, that of the eighth power four
/// units. If an intermediate product overflows or underflows, so does the result.
#[inline]
pub fn whole_power(x: f64, exponent: f64) -> Option<f64> {
    let square = x * x;
    let fourth = square * square;
    Some(match exponent {
        -2.0 => 1.0 / square,
        -1.0 => 1.0 / x,
        0.0 => 1.0,
        1.0 => x,
        2.0 => square,
        3.0 => square * x,
        4.0 => fourth,
        5.0 => fourth * x,
        6.0 => fourth * square,
        7.0 => (fourth * square) * x,
        8.0 => fourth * fourth,
        _ => return None,
    })
}

/// Function as called by machine code.
#[derive(Clone, Copy, Debug)]
pub enum MathFn {
    Unary(extern "C" fn(f64) -> f64),
    Binary(extern "C" fn(f64, f64) -> f64),
    /// Argument: angle.
    Sincos(extern "C" fn(f64) -> SineCosine),
    /// Arguments: pointer to the angles, their number, pointers to the sines and the cosines.
    ///
    /// Calling it is safe if the three arrays have this length, the results are writable, and they
    /// do not overlap.
    SincosColumns(unsafe extern "C" fn(*const f64, usize, *mut f64, *mut f64)),
    /// Arguments: pointer to a table, number.
    ///
    /// See [`calyx_math_piecewise`] for safety.
    Piecewise(unsafe extern "C" fn(*const f64, f64) -> f64),
    /// Arguments: number of a registered table, order of the derivative, number.
    Registered(extern "C" fn(f64, f64, f64) -> f64),
    /// Argument: see [`calyx_math_unsolved`].
    Unsolved(extern "C" fn(usize)),
}

impl MathFn {
    /// Returns the address, for a symbol table.
    pub fn address(self) -> *const u8 {
        match self {
            MathFn::Unary(function) => function as *const u8,
            MathFn::Binary(function) => function as *const u8,
            MathFn::Sincos(function) => function as *const u8,
            MathFn::SincosColumns(function) => function as *const u8,
            MathFn::Unsolved(function) => function as *const u8,
            MathFn::Piecewise(function) => function as *const u8,
            MathFn::Registered(function) => function as *const u8,
        }
    }
}

/// Defines each called function once: for Rust, for machine code, and as a row of [`FUNCTIONS`].
macro_rules! called {
    ($(
        $(#[$doc:meta])*
        $kind:ident $name:ident($($argument:ident),+) = $symbol:ident $body:block
    )+) => {
        $(
            $(#[$doc])*
            #[inline]
            pub fn $name($($argument: f64),+) -> f64 $body

            #[doc = concat!("[`", stringify!($name), "`] as machine code calls it.")]
            #[unsafe(no_mangle)]
            pub extern "C" fn $symbol($($argument: f64),+) -> f64 {
                $name($($argument),+)
            }
        )+

        /// Link symbol and address of every function that machine code calls.
        pub const FUNCTIONS: &[(&str, MathFn)] = &[
            $((stringify!($symbol), MathFn::$kind($symbol)),)+
            ("calyx_math_sincos", MathFn::Sincos(calyx_math_sincos)),
            ("calyx_math_sincos_columns", MathFn::SincosColumns(calyx_math_sincos_columns)),
            ("calyx_math_unsolved", MathFn::Unsolved(calyx_math_unsolved)),
            ("calyx_math_piecewise", MathFn::Piecewise(calyx_math_piecewise)),
            ("calyx_math_spline", MathFn::Registered(calyx_math_spline)),
        ];
    };
}

called! {
    /// Sine of `x` (radians).
    Unary sin(x) = calyx_math_sin { sincos(x).0 }
    /// Cosine of `x` (radians).
    Unary cos(x) = calyx_math_cos { sincos(x).1 }
    /// Tangent of `x` (radians).
    Unary tan(x) = calyx_math_tan { libm::tan(x) }
    /// Arc sine, from -pi/2 to pi/2; NaN outside -1..1.
    Unary asin(x) = calyx_math_asin { libm::asin(x) }
    /// Arc cosine, from 0 to pi; NaN outside -1..1.
    Unary acos(x) = calyx_math_acos { libm::acos(x) }
    /// Arc tangent, from -pi/2 to pi/2.
    Unary atan(x) = calyx_math_atan { libm::atan(x) }
    Unary exp(x) = calyx_math_exp { libm::exp(x) }
    /// Natural logarithm; `log(0) = -inf`, NaN below zero.
    Unary log(x) = calyx_math_log { libm::log(x) }
    /// Largest integer not above `x`.
    Unary floor(x) = calyx_math_floor { x.floor() }
    /// Smallest integer not below `x`.
    Unary ceil(x) = calyx_math_ceil { x.ceil() }
    /// Nearest integer; halves are rounded away from zero, as in C: `round(2.5) = 3`, `round(-2.5)
    /// = -3`.
    Unary round(x) = calyx_math_round { x.round() }
    /// `x` to the power `y`, with the conventions of C: `pow(x, 0) = pow(1, y) = 1` even for NaN,
    /// NaN for a negative `x` and a non-integer `y`. Small integer powers are products
    /// ([`whole_power`]).
    Binary pow(x, y) = calyx_math_pow {
        match whole_power(x, y) {
            Some(power) => power,
            None => libm::pow(x, y),
        }
    }
    /// Angle of the point `(x, y)`, from -pi to pi; `atan2(0, 0) = 0`.
    Binary atan2(y, x) = calyx_math_atan2 { libm::atan2(y, x) }
}

/// Sine and cosine of an angle. The conventions of System V and of AArch64 return them in the first
/// two floating-point registers.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SineCosine {
    pub sine: f64,
    pub cosine: f64,
}

/// [`sincos`] for machine code.
#[unsafe(no_mangle)]
pub extern "C" fn calyx_math_sincos(x: f64) -> SineCosine {
    let (sine, cosine) = sincos(x);
    SineCosine { sine, cosine }
}

/// [`sincos_columns`] for machine code.
///
/// # Safety
/// `angles` must be valid for reading `count` numbers, `sines` and `cosines` for writing as many;
/// they must not overlap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_math_sincos_columns(
    angles: *const f64,
    count: usize,
    sines: *mut f64,
    cosines: *mut f64,
) {
    // SAFETY: guaranteed by the caller.
    let (angles, sines, cosines) = unsafe {
        (
            std::slice::from_raw_parts(angles, count),
            std::slice::from_raw_parts_mut(sines, count),
            std::slice::from_raw_parts_mut(cosines, count),
        )
    };
    sincos_columns(angles, sines, cosines);
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPECIAL: [f64; 12] =
        [0.0, -0.0, 1.0, -1.0, 0.5, -2.5, 2.5, 1e300, 5e-324, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

    #[test]
    fn minimum_and_maximum_follow_ieee_754_2019() {
        let cases =
            [(1.0, 2.0, 1.0, 2.0), (-0.0, 0.0, -0.0, 0.0), (f64::NEG_INFINITY, 3.0, f64::NEG_INFINITY, 3.0)];
        for (a, b, least, greatest) in cases {
            for (a, b) in [(a, b), (b, a)] {
                assert_eq!(min(a, b).to_bits(), f64::to_bits(least));
                assert_eq!(max(a, b).to_bits(), f64::to_bits(greatest));
            }
        }
        for x in SPECIAL {
            assert!(min(x, f64::NAN).is_nan() && max(f64::NAN, x).is_nan());
        }
    }

    #[test]
    fn sine_and_cosine_together_have_the_same_bits_as_apart() {
        let angles =
            (0..20_000).map(|i| (f64::from(i) - 10_000.0) * 0.037).chain([1e9, -3e17, 1e300]).chain(SPECIAL);
        for angle in angles {
            let SineCosine { sine: s, cosine: c } = calyx_math_sincos(angle);
            if angle.is_finite() {
                assert_eq!(
                    (s.to_bits(), c.to_bits()),
                    (sin(angle).to_bits(), cos(angle).to_bits()),
                    "{angle}"
                );
            } else {
                assert!(s.is_nan() && c.is_nan());
            }
        }
    }

    #[test]
    fn small_whole_powers_are_products_with_the_conventions_of_c() {
        let bases = (-40..40).map(|i| f64::from(i) * 0.37 + 0.01).chain(SPECIAL);
        for x in bases {
            for exponent in -2..=8 {
                let (power, reference) = (pow(x, f64::from(exponent)), libm::pow(x, f64::from(exponent)));
                let ordinary = reference.is_normal() && power.is_normal();
                if ordinary {
                    let error = ((power - reference) / reference).abs();
                    assert!(error <= 4.0 * f64::EPSILON, "{x}^{exponent}: {error:e}");
                } else if x != 5e-324 && x != 1e300 {
                    assert!(power.to_bits() == reference.to_bits() || power.is_nan() && reference.is_nan());
                }
            }
            assert_eq!(pow(x, 2.0).to_bits() << 1, (x * x).to_bits() << 1);
        }
        assert_eq!(pow(5e-324, 2.0), 0.0);
        assert_eq!(pow(1e300, -2.0), 0.0);
    }

    #[test]
    fn the_table_names_each_function_once_and_calls_the_rust_definition() {
        let mut names: Vec<_> = FUNCTIONS.iter().map(|(name, _)| *name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), FUNCTIONS.len());
        let call = |name: &str| match FUNCTIONS.iter().find(|(row, _)| *row == name) {
            Some((_, MathFn::Unary(function))) => function(0.7),
            Some((_, MathFn::Binary(function))) => function(0.7, 0.3),
            _ => f64::NAN,
        };
        assert_eq!(call("calyx_math_acos"), acos(0.7));
        assert_eq!(call("calyx_math_pow"), pow(0.7, 0.3));
        assert_eq!(call("calyx_math_atan2"), atan2(0.7, 0.3));
    }

    #[test]
    fn truth_values_and_rounding() {
        assert_eq!((not(0.0), not(-0.0), not(3.0), not(f64::NAN)), (1.0, 1.0, 0.0, 0.0));
        assert_eq!((and(2.0, -1.0), and(1.0, 0.0), or(0.0, 0.0), or(f64::NAN, 0.0)), (1.0, 0.0, 0.0, 1.0));
        assert_eq!((less(1.0, f64::NAN), less_equal(1.0, 1.0), equal(-0.0, 0.0)), (0.0, 1.0, 1.0));
        assert_eq!((select(0.0, 1.0, 2.0), select(f64::NAN, 1.0, 2.0)), (2.0, 1.0));
        assert_eq!((round(2.5), round(-2.5), round(0.49999999999999994)), (3.0, -3.0, 0.0));
    }
}
