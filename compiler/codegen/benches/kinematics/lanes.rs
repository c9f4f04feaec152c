//! Two numbers in SIMD lanes, as hand-written code uses them, and their sine and cosine.

use std::ops::{Add, Mul, Neg, Sub};

#[cfg(target_arch = "x86_64")]
mod arch {
    use std::arch::x86_64::*;

    #[derive(Clone, Copy)]
    pub struct Lanes(pub __m128d);

    impl Lanes {
        #[inline(always)]
        pub fn splat(value: f64) -> Self {
            // SAFETY: SSE2 is part of the x86-64 baseline.
            Lanes(unsafe { _mm_set1_pd(value) })
        }

        /// Loads a pair of numbers.
        ///
        /// # Safety
        /// `from` points to two readable numbers.
        #[inline(always)]
        pub unsafe fn load(from: *const f64) -> Self {
            // SAFETY: guaranteed by the caller.
            Lanes(unsafe { _mm_loadu_pd(from) })
        }

        /// # Safety
        /// `to` points to memory for two numbers.
        #[inline(always)]
        pub unsafe fn store(self, to: *mut f64) {
            // SAFETY: guaranteed by the caller.
            unsafe { _mm_storeu_pd(to, self.0) }
        }

        #[inline(always)]
        pub fn sincos(self) -> (Self, Self) {
            // SAFETY: SSE2 is part of the x86-64 baseline.
            unsafe {
                let sign = _mm_castsi128_pd(_mm_set1_epi64x(i64::MIN));
                let x = Lanes(_mm_andnot_pd(sign, self.0));
                let shifted =
                    x * Lanes::splat(std::f64::consts::FRAC_2_PI) + Lanes::splat(6755399441055744.0);
                let quadrant = _mm_castpd_si128(shifted.0);
                let n = shifted - Lanes::splat(6755399441055744.0);
                let (sine, cosine) = super::reduced(x, n);
                let one = _mm_set1_epi64x(1);
                let exchange =
                    _mm_castsi128_pd(_mm_sub_epi64(_mm_setzero_si128(), _mm_and_si128(quadrant, one)));
                let difference = _mm_and_pd(_mm_xor_pd(sine.0, cosine.0), exchange);
                let turned = |quadrant| _mm_and_pd(_mm_castsi128_pd(_mm_slli_epi64(quadrant, 62)), sign);
                let sine_sign = _mm_xor_pd(turned(quadrant), _mm_and_pd(self.0, sign));
                let cosine_sign = turned(_mm_add_epi64(quadrant, one));
                let place = |value, sign| Lanes(_mm_xor_pd(_mm_xor_pd(value, difference), sign));
                (place(sine.0, sine_sign), place(cosine.0, cosine_sign))
            }
        }
    }

    impl std::ops::Add for Lanes {
        type Output = Self;
        #[inline(always)]
        fn add(self, other: Self) -> Self {
            // SAFETY: SSE2 is part of the x86-64 baseline.
            Lanes(unsafe { _mm_add_pd(self.0, other.0) })
        }
    }

    impl std::ops::Sub for Lanes {
        type Output = Self;
        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            // SAFETY: as above.
            Lanes(unsafe { _mm_sub_pd(self.0, other.0) })
        }
    }

    impl std::ops::Mul for Lanes {
        type Output = Self;
        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            // SAFETY: as above.
            Lanes(unsafe { _mm_mul_pd(self.0, other.0) })
        }
    }

    impl std::ops::Neg for Lanes {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            // SAFETY: as above.
            Lanes(unsafe { _mm_xor_pd(self.0, _mm_set1_pd(-0.0)) })
        }
    }
}

#[cfg(not(target_arch = "x86_64"))]
mod arch {
    /// Two numbers, which the compiler may place in one register.
    #[derive(Clone, Copy)]
    pub struct Lanes(pub [f64; 2]);

    impl Lanes {
        #[inline(always)]
        pub fn splat(value: f64) -> Self {
            Lanes([value; 2])
        }

        /// # Safety
        /// `from` points to two readable numbers.
        #[inline(always)]
        pub unsafe fn load(from: *const f64) -> Self {
            // SAFETY: guaranteed by the caller.
            Lanes(unsafe { [from.read(), from.add(1).read()] })
        }

        /// # Safety
        /// `to` points to memory for two numbers.
        #[inline(always)]
        pub unsafe fn store(self, to: *mut f64) {
            // SAFETY: guaranteed by the caller.
            unsafe {
                to.write(self.0[0]);
                to.add(1).write(self.0[1]);
            }
        }

        #[inline(always)]
        pub fn sincos(self) -> (Self, Self) {
            let [a, b] = self.0.map(calyx_abi::math::sincos);
            (Lanes([a.0, b.0]), Lanes([a.1, b.1]))
        }
    }

    impl std::ops::Add for Lanes {
        type Output = Self;
        #[inline(always)]
        fn add(self, other: Self) -> Self {
            Lanes([self.0[0] + other.0[0], self.0[1] + other.0[1]])
        }
    }

    impl std::ops::Sub for Lanes {
        type Output = Self;
        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            Lanes([self.0[0] - other.0[0], self.0[1] - other.0[1]])
        }
    }

    impl std::ops::Mul for Lanes {
        type Output = Self;
        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            Lanes([self.0[0] * other.0[0], self.0[1] * other.0[1]])
        }
    }

    impl std::ops::Neg for Lanes {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            Lanes(self.0.map(|x| -x))
        }
    }
}

pub use arch::Lanes;

/// The scalar type of hand-written formulas: one number or two lanes.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    const WIDTH: usize;
    fn of(value: f64) -> Self;
    /// # Safety
    /// `from` points to [`Number::WIDTH`] readable numbers.
    unsafe fn read(from: *const f64) -> Self;
    /// # Safety
    /// `to` points to memory for [`Number::WIDTH`] numbers.
    unsafe fn write(self, to: *mut f64);
    fn sine_and_cosine(self) -> (Self, Self);
}

impl Number for Lanes {
    const WIDTH: usize = 2;

    #[inline(always)]
    fn of(value: f64) -> Self {
        Lanes::splat(value)
    }

    #[inline(always)]
    unsafe fn read(from: *const f64) -> Self {
        // SAFETY: guaranteed by the caller.
        unsafe { Lanes::load(from) }
    }

    #[inline(always)]
    unsafe fn write(self, to: *mut f64) {
        // SAFETY: guaranteed by the caller.
        unsafe { self.store(to) }
    }

    #[inline(always)]
    fn sine_and_cosine(self) -> (Self, Self) {
        self.sincos()
    }
}

impl Number for f64 {
    const WIDTH: usize = 1;

    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    unsafe fn read(from: *const f64) -> Self {
        // SAFETY: guaranteed by the caller.
        unsafe { from.read() }
    }

    #[inline(always)]
    unsafe fn write(self, to: *mut f64) {
        // SAFETY: guaranteed by the caller.
        unsafe { to.write(self) }
    }

    #[inline(always)]
    fn sine_and_cosine(self) -> (Self, Self) {
        calyx_abi::math::sincos(self)
    }
}

/// Returns sine and cosine of `x - n pi/2` with the polynomials of `calyx_abi::trigonometry`, in
/// lanes.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn reduced(x: Lanes, n: Lanes) -> (Lanes, Lanes) {
    let c = Lanes::splat;
    let t = x - n * c(f64::from_bits(0x3ff9_21fb_5440_0000));
    let w = n * c(f64::from_bits(0x3dd0_b461_1a60_0000));
    let r = t - w;
    let low = ((t - r) - w) - n * c(f64::from_bits(0x3ba3_198a_2e03_7073));
    let head = r + low;
    let tail = (r - head) + low;
    let z = head * head;
    let mut p = c(1.5896821376768944e-10);
    for coefficient in [
        -2.505075854407543e-08,
        2.755731369455517e-06,
        -0.00019841269829815096,
        0.008333333333322422,
        -0.16666666666666632,
    ] {
        p = c(coefficient) + z * p;
    }
    let sine = head + (z * (head * p - c(0.5) * tail) + tail);
    let mut q = c(-1.1359665431826943e-11);
    for coefficient in [
        2.087572360179884e-09,
        -2.755731435465756e-07,
        2.4801587289489892e-05,
        -0.0013888888888874136,
        0.0416666666666666,
    ] {
        q = c(coefficient) + z * q;
    }
    let half = c(0.5) * z;
    let rest = c(1.0) - half;
    let cosine = rest + (((c(1.0) - rest) - half) + (z * (z * q) - head * tail));
    (sine, cosine)
}
