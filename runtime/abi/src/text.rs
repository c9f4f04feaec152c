//! Values as text: what `print` and string interpolation show.

use crate::call::{Repr, Slot};
use crate::heap::Heap;
use std::fmt::Write;

/// The shortest decimal that reads back as the same number; powers of ten outside 1e-5 .. 1e16.
pub fn number(x: f64) -> String {
    let magnitude = x.abs();
    if x.is_nan() {
        "nan".into()
    } else if x == 0.0 || x.is_infinite() || (1e-5..1e16).contains(&magnitude) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// A number in SI shown in a unit: the shortest decimal that, times `factor`, gives the number again.
pub fn quantity(x: f64, factor: f64, unit: &str) -> String {
    let shown = x / factor;
    let mut text = number(shown);
    if shown.is_finite() && shown * factor != x || text.len() > 15 {
        // The quotient is rounded, so a neighbour of it may be shorter.
        let shorter = (0..17).find_map(|digits| {
            let candidate: f64 = format!("{shown:.digits$e}").parse().ok()?;
            (candidate * factor == x).then(|| number(candidate))
        });
        text = shorter.unwrap_or(text);
    }
    if !unit.is_empty() {
        text.push(' ');
        text.push_str(unit);
    }
    text
}

/// Appends a value. `factor` and `unit` apply to every number in it. `None` if the slots do not fit.
pub fn append(
    heap: &Heap,
    repr: &Repr,
    slots: &[Slot],
    factor: f64,
    unit: &str,
    text: &mut String,
) -> Option<()> {
    let numbers = |slots: &[Slot]| {
        let shown: Vec<_> = slots.iter().map(|&s| quantity(f64::from_bits(s), factor, unit)).collect();
        format!("[{}]", shown.join(", "))
    };
    match repr {
        Repr::Unit => {}
        Repr::Number => text.push_str(&quantity(f64::from_bits(*slots.first()?), factor, unit)),
        Repr::Bool => text.push_str(if *slots.first()? != 0 { "TRUE" } else { "FALSE" }),
        Repr::String => text.push_str(heap.str(*slots.first()?)?),
        Repr::Vector => text.push_str(&numbers(slots.get(..3)?)),
        Repr::Transform => {
            // Rows of the rotation, then the translation.
            let rows: Vec<_> = slots.get(..12)?.chunks(3).map(numbers).collect();
            write!(text, "[{}]", rows.join(", ")).ok()?;
        }
        Repr::Array(element) => {
            let (elements, stride) = heap.array(*slots.first()?)?;
            let elements = elements.chunks(stride.max(1)).map(|slots| (&**element, slots));
            list(heap, elements, factor, unit, text)?;
        }
        Repr::Tuple(parts) => {
            let mut rest = slots;
            let mut elements = Vec::new();
            for part in parts {
                let (slots, after) = rest.split_at_checked(part.slots())?;
                elements.push((part, slots));
                rest = after;
            }
            list(heap, elements, factor, unit, text)?;
        }
        Repr::Symbolic(_) => text.push_str("(symbolic)"),
        Repr::Handle => write!(text, "#{}", slots.first()?).ok()?,
    }
    Some(())
}

fn list<'a>(
    heap: &Heap,
    elements: impl IntoIterator<Item = (&'a Repr, &'a [Slot])>,
    factor: f64,
    unit: &str,
    text: &mut String,
) -> Option<()> {
    text.push('[');
    for (index, (repr, slots)) in elements.into_iter().enumerate() {
        if index > 0 {
            text.push_str(", ");
        }
        append(heap, repr, slots, factor, unit, text)?;
    }
    text.push(']');
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_and_are_short() {
        let cases = [
            (0.0, "0"),
            (3.0, "3"),
            (0.1 + 0.2, "0.30000000000000004"),
            (1e300, "1e300"),
            (-2.5e-7, "-2.5e-7"),
            (f64::INFINITY, "inf"),
            (-f64::NAN, "nan"),
        ];
        for (x, expected) in cases {
            assert_eq!(number(x), expected);
        }
    }

    #[test]
    fn quantities_show_the_decimal_that_was_written() {
        // 0.0254 times any short decimal must come out as that decimal, although the quotient is rounded.
        for thousandths in -3000..3000 {
            let written = f64::from(thousandths) / 1000.0;
            assert_eq!(quantity(written * 0.0254, 0.0254, "inch"), format!("{} inch", number(written)));
        }
    }
}
