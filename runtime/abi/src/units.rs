//! Conversion between SI and other units: one definition, so that displayed numbers read back
//! unchanged.

/// Converts a number in a unit to SI.
///
/// If the unit is an integer fraction of the SI unit (`mm`, `um`, `%`), this divides, which rounds
/// once: `10 um` is the number nearest to 0.00001. Multiplication by a rounded factor would not
/// give this.
pub fn to_si(value: f64, factor: f64) -> f64 {
    match divisor(factor) {
        Some(divisor) => value / divisor,
        None => value * factor,
    }
}

/// Converts a number in SI to a unit.
pub fn from_si(value: f64, factor: f64) -> f64 {
    match divisor(factor) {
        Some(divisor) => value * divisor,
        None => value / factor,
    }
}

/// Returns the integer whose reciprocal is a factor below one.
fn divisor(factor: f64) -> Option<f64> {
    let inverse = (1.0 / factor).round();
    let whole = factor > 0.0 && factor < 1.0 && inverse < 9e15;
    (whole && 1.0 / inverse == factor).then_some(inverse)
}

/// Formats a number for people, without the rounding error that a unit conversion adds in the
/// sixteenth digit.
pub fn shortest(value: f64) -> String {
    let rounded: f64 = format!("{value:.12e}").parse().unwrap_or(value);
    if rounded != 0.0 && !(1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_units_round_once() {
        assert_eq!(to_si(10.0, 1e-6), 1e-5);
        assert_eq!(to_si(0.3, 1e-3), 0.0003);
        assert_eq!(to_si(7.0, 0.01), 0.07);
        assert_eq!(from_si(1e-5, 1e-3), 0.01);
        assert_eq!(to_si(3.0, 0.0254), 3.0 * 0.0254);
        assert_eq!(to_si(2.0, 1e9), 2e9);
        assert!(to_si(1.0, 0.0).abs() < 1.0 && to_si(f64::NAN, 1e-3).is_nan());
    }
}
