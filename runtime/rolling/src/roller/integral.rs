//! Interaction of two strips of a contact line on a half-space.

use libm::log;

/// Shares and values of the distance of two points under semi-elliptic pressures of half-width 1.
///
/// The distribution of the distance |y - y'| has the mean logarithm ln(1/2) - 1/4 and the mean
/// square 1/2; both are those of the three distances. Their modified Bessel functions K₀(k |y -
/// y'|) have the mean of the distribution within 0.1 % for wave numbers k from 0 to 12.
const DISTANCES: [(f64, f64); 3] =
    [(0.161_448_01, 0.045_630_357_5), (0.515_307_92, 0.388_021_413_3), (0.323_244_07, 1.142_674_334_5)];

/// Double integral of 1/√(x² + (y - y')²) over two intervals of x, averaged over semi-elliptic
/// pressures across the contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Integral {
    /// Distances of the ends of the intervals: two of positive and two of negative sign.
    corners: [f64; 4],
    /// Factor on the result.
    weight: f64,
    /// Overlap of the intervals times two.
    overlap: f64,
    /// The half-widths of the pressures are comparable with the distance.
    close: bool,
}

/// Terms of an integral that are singular at vanishing half-widths, and the analytic rest.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Expansion {
    /// Factor of the root of the mean square of the half-widths, m.
    pub root: f64,
    /// Factor of the logarithm of the mean square.
    pub logarithm: f64,
    /// The rest is analytic for mean squares above the negative of this, m².
    pub singularity: f64,
    /// Magnitude of the largest term, m.
    pub size: f64,
}

/// Corners below this part of the largest one are zero but for rounding.
const ZERO: f64 = 1e-9;

impl Integral {
    /// Two intervals of a line: `first` and `second` are their ends, and `close` states whether
    /// half-widths are comparable with the distance. Intervals are disjoint or equal.
    pub fn new(first: [f64; 2], second: [f64; 2], weight: f64, close: bool) -> Self {
        let ([a, b], [c, d]) = (first, second);
        let corners = [b - c, a - d, b - d, a - c].map(f64::abs);
        let overlap = if first == second { 2.0 * (b - a) } else { 0.0 };
        Self { corners, weight, overlap, close }
    }

    /// Returns the integral with its first and second derivative with respect to the mean square
    /// of both half-widths.
    #[inline]
    pub fn evaluate(&self, square: f64) -> [f64; 3] {
        if !self.close {
            // The mean square of the distance is half of that of the half-width.
            let [value, first, second] = self.at(0.5 * square);
            return [value, 0.5 * first, 0.25 * second];
        }
        let mut sums = [0.0; 3];
        for (share, distance) in DISTANCES {
            let scale = distance * distance;
            let terms = self.at(scale * square);
            sums[0] += share * terms[0];
            sums[1] += share * scale * terms[1];
            sums[2] += share * scale * scale * terms[2];
        }
        sums
    }

    /// Returns the singular terms of the integral.
    pub fn expansion(&self) -> Expansion {
        let size = self.corners.iter().copied().fold(0.0, f64::max);
        let zero = |corner: f64| corner < ZERO * size;
        let (mean_root, most) = if self.close {
            let roots = DISTANCES.map(|(share, distance)| share * distance);
            (roots.iter().sum(), DISTANCES[2].1 * DISTANCES[2].1)
        } else {
            (0.5f64.sqrt(), 0.5)
        };
        let mut root = 0.0;
        let mut least = f64::INFINITY;
        for (&corner, sign) in self.corners.iter().zip([1.0, 1.0, -1.0, -1.0]) {
            if zero(corner) {
                root -= sign * mean_root;
            } else {
                least = least.min(corner);
            }
        }
        Expansion {
            root: self.weight * root,
            logarithm: -0.5 * self.weight * self.overlap,
            singularity: least * least / most,
            size: self.weight.abs() * size,
        }
    }

    /// Returns the integral of 1/√(x² + s²) with its derivatives with respect to s²: the second
    /// difference of |x| asinh(|x|/s) - √(x² + s²). Terms of ln s cancel without overlap.
    #[inline]
    fn at(&self, square: f64) -> [f64; 3] {
        let roots = self.corners.map(|corner| (corner * corner + square).sqrt());
        let sides = [0, 1, 2, 3].map(|k| roots[k] + self.corners[k]);
        let logarithms = logarithms(sides);
        let mut sums = [0.0; 3];
        for (k, sign) in [1.0, 1.0, -1.0, -1.0].into_iter().enumerate() {
            let inverse = 1.0 / sides[k];
            sums[0] += sign * (self.corners[k] * logarithms[k] - roots[k]);
            sums[1] -= sign * 0.5 * inverse;
            sums[2] += sign * 0.25 * inverse * inverse / roots[k];
        }
        if self.overlap > 0.0 {
            sums[0] -= 0.5 * self.overlap * log(square);
            sums[1] -= 0.5 * self.overlap / square;
            sums[2] += 0.5 * self.overlap / (square * square);
        }
        sums.map(|sum| self.weight * sum)
    }
}

/// Returns the natural logarithms of positive normal numbers with an error of about 2e-16 of the
/// larger of 1 and the result.
///
/// The logarithms take most of the time of elastic contacts. Without branches, the compiler
/// computes several at once.
#[inline]
fn logarithms(values: [f64; 4]) -> [f64; 4] {
    /// Bits of √½.
    const ROOT: u64 = 0x3FE6_A09E_667F_3BCD;
    /// Bits of 2⁵² with an exponent that makes small integers exact, and this number.
    const SHIFT: (u64, f64) = (0x4330_0000_0000_0000, 4_503_599_627_370_496.0);
    values.map(|value| {
        // value = m 2^e with m from √½ to √2, and ln m = 2 atanh((m - 1) / (m + 1)).
        let bits = value.to_bits() + (0x3FF0_0000_0000_0000 - ROOT);
        let exponent = f64::from_bits((bits >> 52) | SHIFT.0) - SHIFT.1 - 1023.0;
        let mantissa = f64::from_bits((bits & 0x000F_FFFF_FFFF_FFFF) + ROOT);
        let ratio = (mantissa - 1.0) / (mantissa + 1.0);
        let square = ratio * ratio;
        let mut series = 0.0;
        for k in (1..=10).rev() {
            series = square * (series + 1.0 / f64::from(2 * k + 1));
        }
        exponent * std::f64::consts::LN_2 + 2.0 * (ratio + ratio * series)
    })
}
