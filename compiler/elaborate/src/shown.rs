//! Display of quantities: rounded, in the unit of the file.

use calyx_abi::units::from_si;
use calyx_gears::derived_quantities::{Kind, Quantity};
use calyx_gears::host::LengthUnit;
use calyx_lang::dimension::{Base, Dimension};
use calyx_lang::ir::DisplayUnit;

/// Significant digits of a derived value: more than a drawing has, but too few to show rounding
/// errors.
const DIGITS: i32 = 6;

/// Returns the dimension of a derived quantity.
pub fn dimension(kind: Kind) -> Dimension {
    match kind {
        Kind::Length => Dimension::of(Base::Length),
        Kind::Curvature => Dimension::NONE.over(Dimension::of(Base::Length)),
        Kind::Angle => Dimension::of(Base::Angle),
        Kind::Number => Dimension::NONE,
    }
}

/// Formats a derived quantity with its unit, for a file with the system of units `system`. Lengths
/// have the unit of messages about gears (mm or inches), angles are in degrees. Lengths are rounded
/// to 0.1 µm (1e-5 inch): finer than measurements, coarser than rounding errors.
pub fn value(quantity: &Quantity, system: &str) -> String {
    let LengthUnit { name, metres } = LengthUnit::of_system(system);
    match quantity.kind {
        Kind::Length if metres > 0.01 => format!("{} {name}", fixed(quantity.value / metres, 5)),
        Kind::Length => format!("{} {name}", fixed(quantity.value / metres, 4)),
        Kind::Curvature => format!("{} / {name}", rounded(quantity.value * metres)),
        Kind::Angle => format!("{} deg", fixed(quantity.value.to_degrees(), 4)),
        Kind::Number => fixed(quantity.value, 4),
    }
}

/// Formats a number in SI with a unit, rounded.
pub fn in_unit(si: f64, unit: &DisplayUnit) -> String {
    let number = rounded(from_si(si, unit.factor));
    if unit.name.is_empty() { number } else { format!("{number} {}", unit.name) }
}

/// Formats a count with separated thousands.
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|group| str::from_utf8(group).ok()).collect();
    groups.join(",")
}

/// Formats a number with two digits and a power of a thousand; `names` starts with the name for
/// thousands.
pub fn of_thousands(number: f64, names: [&str; 4]) -> String {
    let power = names.len().min(((number.max(1.0).log10() + 1e-9) / 3.0).floor().max(1.0) as usize);
    let value = number / 1e3_f64.powi(power as i32);
    let digits = if value < 9.95 { 1 } else { 0 };
    format!("{value:.digits$}{}", names[power - 1])
}

/// Formats a number with six significant digits and without trailing zeros.
pub fn rounded(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-4..9).contains(&magnitude) {
        let text = format!("{value:.*e}", DIGITS as usize - 1);
        return match text.split_once('e') {
            Some((digits, power)) => format!("{}e{power}", without_zeros(digits)),
            None => text,
        };
    }
    fixed(value, (DIGITS - 1 - magnitude).max(0) as usize)
}

/// Formats a number with at most `decimals` decimals.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match without_zeros(&text) {
        "-0" => "0".into(),
        text => text.to_owned(),
    }
}

fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}
