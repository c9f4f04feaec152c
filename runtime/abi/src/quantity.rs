//! Parser of quantities given as text: `0.5 mm`, `1000 lbf*inch`, `10 / inch`, `2e-3`, with the
//! units of the language.

use crate::description::{DimensionDescription, Exponents, OWN_BASES, UnitDescription};
use crate::units::to_si;

/// Exponents of a dimensionless number.
pub const PURE: Exponents = [(0, 1); 5 + OWN_BASES];

/// Number in SI with its dimension. `unit` is false if no unit was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    pub value: f64,
    pub dimension: Exponents,
    pub unit: bool,
}

/// Parses `NUMBER [UNIT]`, where UNIT consists of names with integer exponents, joined by `*` and
/// `/`. The error describes the problem.
pub fn parse(text: &str, units: &[UnitDescription]) -> Result<Quantity, String> {
    let (number, unit) = split_number(text.trim())?;
    with_unit(number, unit, units)
}

/// Converts a number with a unit like [`parse`]; an empty text is no unit.
///
/// # Errors
/// A description of the problem.
pub fn with_unit(number: f64, unit: &str, units: &[UnitDescription]) -> Result<Quantity, String> {
    let mut quantity = Quantity { value: number, dimension: PURE, unit: false };
    let mut rest = unit;
    while !rest.trim_start().is_empty() {
        rest = rest.trim_start();
        let divide = rest.starts_with('/');
        if let Some(after) = rest.strip_prefix(['*', '/']) {
            rest = after.trim_start();
        } else if quantity.unit {
            return Err(format!("`{rest}` was not understood; join units by `*` and `/`"));
        }
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '%')).unwrap_or(rest.len());
        let (name, after) = rest.split_at(end);
        if name.is_empty() {
            return Err(format!("a unit is missing or misspelt at the end of `{}`", unit.trim()));
        }
        let Some(unit) = units.iter().find(|unit| unit.name == name) else {
            return Err(format!("there is no unit called `{name}`"));
        };
        let (exponent, after) = split_exponent(after)?;
        let exponent = if divide { -exponent } else { exponent };
        let factor = unit.factor.powi(exponent);
        // As in the compiler, the unit right after the number is part of the literal.
        quantity.value = if quantity.unit { quantity.value * factor } else { to_si(quantity.value, factor) };
        for (sum, part) in quantity.dimension.iter_mut().zip(unit.dimension) {
            *sum = add(*sum, (part.0 * exponent, part.1));
        }
        quantity.unit = true;
        rest = after;
    }
    Ok(quantity)
}

/// Splits off the longest prefix that is a number.
fn split_number(text: &str) -> Result<(f64, &str), String> {
    (1..=text.len())
        .rev()
        .filter(|&end| text.is_char_boundary(end))
        // Reject `inf` and `nan`, which are not intended as numbers.
        .filter(|&end| !text[..end].contains(|c: char| c.is_alphabetic() && c != 'e' && c != 'E'))
        .find_map(|end| Some((text[..end].trim_end().parse().ok()?, &text[end..])))
        .ok_or_else(|| format!("`{text}` does not begin with a number"))
}

fn split_exponent(text: &str) -> Result<(i32, &str), String> {
    let Some(after) = text.trim_start().strip_prefix('^') else { return Ok((1, text)) };
    let end = after
        .char_indices()
        .find(|&(at, c)| !(c.is_ascii_digit() || (at == 0 && c == '-')))
        .map_or(after.len(), |(at, _)| at);
    let exponent = after[..end].parse().ok().filter(|e: &i32| e.abs() <= 12);
    exponent.map(|e| (e, &after[end..])).ok_or_else(|| "an exponent must be a small whole number".to_owned())
}

fn add(a: (i32, i32), b: (i32, i32)) -> (i32, i32) {
    let (n, d) = (a.0 * b.1 + b.0 * a.1, a.1 * b.1);
    let g = gcd(n.abs(), d).max(1);
    (n / g, d / g)
}

fn gcd(a: i32, b: i32) -> i32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Returns whether two dimensions are compatible: the exponent of angle is ignored.
pub fn fits(a: Exponents, b: Exponents) -> bool {
    const ANGLE: usize = 3;
    (0..a.len()).filter(|&base| base != ANGLE).all(|base| a[base].0 * b[base].1 == b[base].0 * a[base].1)
}

/// Returns the name of a dimension with an article: `a length`, `a second moment of area`; `None`
/// if it has no name.
pub fn kind(dimension: Exponents, known: &[DimensionDescription]) -> Option<String> {
    if dimension == PURE {
        return Some("a pure number".into());
    }
    let exact = known.iter().find(|named| named.exponents == dimension);
    // A factor of angle does not change the kind of a quantity.
    let found = exact.or_else(|| known.iter().find(|named| fits(named.exponents, dimension)))?;
    let mut words = String::new();
    for letter in found.name.chars() {
        if letter.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(letter.to_lowercase());
    }
    let article = if words.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    Some(format!("{article} {words}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn units() -> Vec<UnitDescription> {
        let unit = |name: &str, factor, exponents: [i32; 5]| UnitDescription {
            name: name.into(),
            factor,
            dimension: std::array::from_fn(|base| (exponents.get(base).copied().unwrap_or(0), 1)),
        };
        vec![
            unit("mm", 1e-3, [1, 0, 0, 0, 0]),
            unit("inch", 0.0254, [1, 0, 0, 0, 0]),
            unit("lbf", 4.5, [1, 1, -2, 0, 0]),
            unit("deg", 0.0175, [0, 0, 0, 1, 0]),
        ]
    }

    #[test]
    fn texts_mean_quantities() {
        for (text, value, length, unit) in [
            ("0.5 mm", 0.5e-3, 1, true),
            ("0.5mm", 0.5e-3, 1, true),
            ("-2e-3", -2e-3, 0, false),
            ("7", 7.0, 0, false),
            ("10 / inch", 10.0 / 0.0254, -1, true),
            ("2 mm^2", 2e-6, 2, true),
            ("3 lbf*inch", 3.0 * 4.5 * 0.0254, 2, true),
            ("3 lbf/inch^2", 3.0 * 4.5 / (0.0254 * 0.0254), -1, true),
        ] {
            let quantity = parse(text, &units()).unwrap();
            assert!((quantity.value - value).abs() <= 1e-15 * value.abs(), "{text}: {}", quantity.value);
            assert_eq!((quantity.dimension[0].0, quantity.unit), (length, unit), "{text}");
        }
    }

    #[test]
    fn nonsense_is_refused_with_a_reason() {
        for (text, reason) in [
            ("", "does not begin with a number"),
            ("mm", "does not begin with a number"),
            ("nan", "does not begin with a number"),
            ("1 furlong", "no unit called `furlong`"),
            ("1 mm inch", "join units"),
            ("1 mm *", "a unit is missing"),
            ("1 mm^99", "small whole number"),
        ] {
            let error = parse(text, &units()).unwrap_err();
            assert!(error.contains(reason), "{text}: {error}");
        }
    }

    #[test]
    fn kinds_are_told_in_words() {
        let of = |exponents: [i32; 5]| {
            std::array::from_fn(|base| (exponents.get(base).copied().unwrap_or(0), 1)) as Exponents
        };
        let known = [
            ("Length", of([1, 0, 0, 0, 0])),
            ("Angle", of([0, 0, 0, 1, 0])),
            ("SecondMomentOfArea", of([4, 0, 0, 0, 0])),
        ];
        let known =
            known.map(|(name, exponents)| DimensionDescription { name: name.into(), exponents }).to_vec();
        for (exponents, words) in [
            ([0, 0, 0, 0, 0], Some("a pure number")),
            ([0, 0, 0, 1, 0], Some("an angle")),
            ([1, 0, 0, 0, 0], Some("a length")),
            ([1, 0, 0, 1, 0], Some("a length")),
            ([4, 0, 0, 0, 0], Some("a second moment of area")),
            ([5, 0, 0, 0, 0], None),
        ] {
            assert_eq!(kind(of(exponents), &known).as_deref(), words, "{exponents:?}");
        }
    }

    #[test]
    fn angle_never_blocks() {
        for base in 0..PURE.len() {
            let mut dimension = PURE;
            dimension[base] = (1, 1);
            assert_eq!(fits(dimension, PURE), base == 3);
        }
    }
}
