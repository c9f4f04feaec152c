//! Distributions of toleranced params, by their quantile functions.
//!
//! All functions are those of `libm`, so that samples have the same bits on every machine.

use calyx_abi::description::ParamDescription;
use calyx_abi::units::{from_si, shortest};
use std::f64::consts::FRAC_1_SQRT_2;

/// Number of standard deviations between the mean and the bounds of a normal distribution that is
/// given by bounds.
pub const SIGMAS_OF_BOUNDS: f64 = 3.0;

/// Distribution of a number. All values are in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    Normal {
        mean: f64,
        standard_deviation: f64,
    },
    /// Normal distribution without the values outside of the bounds. Mean and standard deviation
    /// are those before the truncation.
    TruncatedNormal {
        mean: f64,
        standard_deviation: f64,
        low: f64,
        high: f64,
    },
    Uniform {
        low: f64,
        high: f64,
    },
    Triangular {
        low: f64,
        mode: f64,
        high: f64,
    },
}

/// Names of the distributions.
pub const NAMES: [&str; 4] = ["normal", "truncated_normal", "uniform", "triangular"];

impl Distribution {
    /// Creates a normal distribution whose bounds are three standard deviations from the mean.
    pub fn normal_within(low: f64, high: f64) -> Distribution {
        Distribution::Normal {
            mean: 0.5 * (low + high),
            standard_deviation: (high - low) / (2.0 * SIGMAS_OF_BOUNDS),
        }
    }

    /// Returns the value below which the share `part` of all values lies, 0 < `part` < 1.
    pub fn quantile(&self, part: f64) -> f64 {
        match *self {
            Distribution::Normal { mean, standard_deviation } => {
                mean + standard_deviation * standard_normal_quantile(part)
            }
            Distribution::TruncatedNormal { mean, standard_deviation, low, high } => {
                let [from, to] = [low, high].map(|bound| (bound - mean) / standard_deviation);
                // The upper tail is mirrored, because its probabilities are near 1.
                let inner = if from > 0.0 {
                    let [from, to] = [from, to].map(|bound| standard_normal_cdf(-bound));
                    -standard_normal_quantile(from + part * (to - from))
                } else {
                    let [from, to] = [from, to].map(standard_normal_cdf);
                    standard_normal_quantile(from + part * (to - from))
                };
                (mean + standard_deviation * inner).clamp(low, high)
            }
            Distribution::Uniform { low, high } => low + part * (high - low),
            Distribution::Triangular { low, mode, high } => {
                let width = high - low;
                if part * width < mode - low {
                    low + libm::sqrt(part * width * (mode - low))
                } else {
                    high - libm::sqrt((1.0 - part) * width * (high - mode))
                }
            }
        }
    }

    /// Describes the distribution as it is written on a command line, in the unit of the param,
    /// with six digits.
    pub fn shown(&self, param: &ParamDescription) -> String {
        let number = |si: f64| {
            let value = from_si(si, param.unit.factor);
            shortest(format!("{value:.5e}").parse().unwrap_or(value))
        };
        let unit = if param.unit.name == "1" { "" } else { param.unit.name.as_str() };
        let value = |si: f64| format!("{} {unit}", number(si)).trim_end().to_owned();
        let range = |low: f64, high: f64| format!("{}..{}", value(low), value(high));
        match *self {
            Distribution::Normal { mean, standard_deviation } => {
                format!("normal({}, {})", value(mean), value(standard_deviation))
            }
            Distribution::TruncatedNormal { mean, standard_deviation, low, high } => format!(
                "truncated_normal({}, {}, {})",
                value(mean),
                value(standard_deviation),
                range(low, high)
            ),
            Distribution::Uniform { low, high } => format!("uniform({})", range(low, high)),
            Distribution::Triangular { low, mode, high } => {
                format!("triangular({}, {})", range(low, high), value(mode))
            }
        }
    }
}

/// Returns the probability that a standard normal variable is at most `x`.
fn standard_normal_cdf(x: f64) -> f64 {
    0.5 * libm::erfc(-x * FRAC_1_SQRT_2)
}

/// Evaluates a polynomial, highest power first.
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// Returns the quantile of the standard normal distribution, with a relative error of about 1e-16:
/// Wichura, "Algorithm AS 241: The percentage points of the normal distribution", Applied
/// Statistics 37 (1988), 477-484, function PPND16.
pub fn standard_normal_quantile(part: f64) -> f64 {
    let q = part - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180625 - q * q;
        return q * polynomial(&CENTRE[0], r) / polynomial(&CENTRE[1], r);
    }
    let tail = if q < 0.0 { part } else { 1.0 - part };
    let r = libm::sqrt(-libm::log(tail));
    let (shift, [above, below]) = if r <= 5.0 { (1.6, TAIL) } else { (5.0, FAR_TAIL) };
    let value = polynomial(&above, r - shift) / polynomial(&below, r - shift);
    if q < 0.0 { -value } else { value }
}

/// Numerator and denominator for the central part.
const CENTRE: [[f64; 8]; 2] = [
    [
        2_509.080_928_730_122_7,
        33_430.575_583_588_13,
        67_265.770_927_008_7,
        45_921.953_931_549_87,
        13_731.693_765_509_46,
        1_971.590_950_306_551_4,
        133.141_667_891_784_38,
        3.387_132_872_796_366_5,
    ],
    [
        5_226.495_278_852_545,
        28_729.085_735_721_943,
        39_307.895_800_092_71,
        21_213.794_301_586_597,
        5_394.196_021_424_751,
        687.187_007_492_057_9,
        42.313_330_701_600_91,
        1.0,
    ],
];
/// Numerator and denominator for the tails.
const TAIL: [[f64; 8]; 2] = [
    [
        7.745_450_142_783_414e-4,
        0.022_723_844_989_269_184,
        0.241_780_725_177_450_6,
        1.270_458_252_452_368_4,
        3.647_848_324_763_204_5,
        5.769_497_221_460_691,
        4.630_337_846_156_546,
        1.423_437_110_749_683_5,
    ],
    [
        1.050_750_071_644_416_9e-9,
        5.475_938_084_995_345e-4,
        0.015_198_666_563_616_457,
        0.148_103_976_427_480_08,
        0.689_767_334_985_1,
        1.676_384_830_183_803_8,
        2.053_191_626_637_759,
        1.0,
    ],
];
/// Numerator and denominator for probabilities below 1e-11.
const FAR_TAIL: [[f64; 8]; 2] = [
    [
        2.010_334_399_292_288_1e-7,
        2.711_555_568_743_487_6e-5,
        0.001_242_660_947_388_078_4,
        0.026_532_189_526_576_124,
        0.296_560_571_828_504_87,
        1.784_826_539_917_291_3,
        5.463_784_911_164_114,
        6.657_904_643_501_103,
    ],
    [
        2.044_263_103_389_939_8e-15,
        1.421_511_758_316_446e-7,
        1.846_318_317_510_054_7e-5,
        7.868_691_311_456_132e-4,
        0.014_875_361_290_850_615,
        0.136_929_880_922_735_8,
        0.599_832_206_555_888,
        1.0,
    ],
];
