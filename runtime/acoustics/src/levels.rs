//! Levels in decibels and the A-weighting.

/// Reference sound power, W.
pub const REFERENCE_POWER: f64 = 1e-12;
/// Reference sound pressure in air, root mean square, Pa.
pub const REFERENCE_PRESSURE: f64 = 2e-5;

/// Returns the sound power level of a power in W, dB; minus infinity without power.
pub fn sound_power_level(power: f64) -> f64 {
    10.0 * (power.max(0.0) / REFERENCE_POWER).log10()
}

/// Returns the sound pressure level of a pressure amplitude in Pa, dB.
pub fn sound_pressure_level(amplitude: f64) -> f64 {
    20.0 * (amplitude.abs() / (std::f64::consts::SQRT_2 * REFERENCE_PRESSURE)).log10()
}

/// Returns the A-weighting at a frequency in Hz, dB (IEC 61672-1:2013, annex E); minus infinity at
/// zero.
pub fn a_weighting(frequency: f64) -> f64 {
    20.0 * (response(frequency) / response(1000.0)).log10()
}

/// Magnitude of the A-weighting without normalization, with the pole frequencies of annex E.
fn response(frequency: f64) -> f64 {
    let square = frequency * frequency;
    let pole = |f: f64| square + f * f;
    let [low, first, second, high] = [20.598_997, 107.652_65, 737.862_23, 12_194.217];
    high * high * square * square / (pole(low) * (pole(first) * pole(second)).sqrt() * pole(high))
}

/// Returns the level of the sum of incoherent sources of these levels, dB.
pub fn level_sum(levels: impl IntoIterator<Item = f64>) -> f64 {
    10.0 * levels.into_iter().map(|level| 10f64.powf(level / 10.0)).sum::<f64>().log10()
}
