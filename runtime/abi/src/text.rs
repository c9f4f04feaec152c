//! Formatting of values as text, for `print` and string interpolation.

use crate::call::{Repr, Slot};
use crate::display::{Display, NumberStyle};
use crate::error::RuntimeError;
use crate::heap::Heap;
use crate::helpers::malformed;
use crate::units::{from_si, to_si};

/// Formats the shortest decimal that reads back as the same number; scientific notation outside
/// 1e-5 .. 1e16.
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

/// Formats a number in SI in a unit: the shortest decimal that converts back to the number.
fn shortest(x: f64, factor: f64) -> String {
    let shown = from_si(x, factor);
    let text = number(shown);
    if !shown.is_finite() || (to_si(shown, factor) == x && text.len() <= 15) {
        return text;
    }
    // The quotient is rounded, so a neighbour may have a shorter decimal.
    let shorter = (0..17).find_map(|digits| {
        let candidate: f64 = format!("{shown:.digits$e}").parse().ok()?;
        (to_si(candidate, factor) == x).then(|| number(candidate))
    });
    shorter.unwrap_or(text)
}

/// Formats a number in SI with a style.
pub fn quantity(x: f64, style: &NumberStyle) -> String {
    let factor = if style.factor == 0.0 { 1.0 } else { style.factor };
    let shown = from_si(x, factor);
    let mut text = match (style.digits, style.scientific) {
        _ if !shown.is_finite() => number(shown),
        (None, false) => shortest(x, factor),
        (None, true) => format!("{shown:e}"),
        (Some(digits), scientific) => {
            let digits = usize::from(digits);
            let text = if scientific { format!("{shown:.digits$e}") } else { format!("{shown:.digits$}") };
            // A number that is rounded to zero has no sign.
            match text.strip_prefix('-') {
                Some(rest) if !rest.contains(|c: char| ('1'..='9').contains(&c)) => rest.to_string(),
                _ => text,
            }
        }
    };
    let missing = usize::from(style.width).saturating_sub(text.chars().count());
    text.insert_str(0, &" ".repeat(missing));
    if !style.unit.is_empty() {
        text.push(' ');
        text.push_str(&style.unit);
    }
    text
}

/// Text under construction with a memory limit.
pub struct BoundedText<'t> {
    text: &'t mut String,
    /// Fails if the text may not have this length in bytes.
    room: &'t dyn Fn(usize) -> Result<(), RuntimeError>,
}

impl<'t> BoundedText<'t> {
    pub fn new(text: &'t mut String, room: &'t dyn Fn(usize) -> Result<(), RuntimeError>) -> BoundedText<'t> {
        BoundedText { text, room }
    }

    fn push(&mut self, text: &str) -> Result<(), RuntimeError> {
        (self.room)(self.text.len().saturating_add(text.len()))?;
        self.text.push_str(text);
        Ok(())
    }

    /// Appends a value.
    ///
    /// # Errors
    /// The memory limit is reached; internal if the slots or the display do not fit the
    /// representation.
    pub fn append(
        &mut self,
        heap: &Heap,
        repr: &Repr,
        slots: &[Slot],
        display: &Display,
    ) -> Result<(), RuntimeError> {
        let plain = NumberStyle::default();
        let style = match display {
            Display::Number(style) => style,
            _ => &plain,
        };
        // A component of -0 is shown as 0.
        let numbers = |slots: &[Slot], style: &NumberStyle| {
            let shown: Vec<_> = slots.iter().map(|&s| quantity(f64::from_bits(s) + 0.0, style)).collect();
            format!("[{}]", shown.join(", "))
        };
        let first = || slots.first().copied().ok_or_else(not_shown);
        match repr {
            Repr::Unit => Ok(()),
            Repr::Number => self.push(&quantity(f64::from_bits(first()?), style)),
            Repr::Bool => self.pad(if first()? != 0 { "TRUE" } else { "FALSE" }, display),
            Repr::String => self.pad(heap.str(first()?).ok_or_else(not_shown)?, display),
            Repr::Vector => self.push(&numbers(slots.get(..3).ok_or_else(not_shown)?, style)),
            Repr::Transform => {
                // Rows of the rotation, then the translation.
                let rotation = NumberStyle { factor: 0.0, unit: String::new(), ..style.clone() };
                let (rows, translation) = slots.get(..12).ok_or_else(not_shown)?.split_at(9);
                let rows: Vec<_> = rows.chunks(3).map(|row| numbers(row, &rotation)).collect();
                self.push(&format!("[{}, {}]", rows.join(", "), numbers(translation, style)))
            }
            Repr::Array(element) => {
                let (elements, stride) = heap.array(first()?).ok_or_else(not_shown)?;
                let shown = match display {
                    Display::Array(shown) => shown,
                    other => other,
                };
                self.push("[")?;
                for (index, slots) in elements.chunks(stride.max(1)).enumerate() {
                    if index > 0 {
                        self.push(", ")?;
                    }
                    self.append(heap, element, slots, shown)?;
                }
                self.push("]")
            }
            Repr::Tuple(parts) => match (display, parts.as_slice(), slots.split_first()) {
                (Display::Optional(_), _, Some((0, _))) => self.push("none"),
                (Display::Optional(shown), [_, value], Some((_, slots))) => {
                    self.append(heap, value, slots, shown)
                }
                _ => self.append_parts(heap, parts, slots, display),
            },
            Repr::Symbolic(_) => self.push("(symbolic)"),
            Repr::Handle => self.push(&format!("#{}", first()?)),
        }
    }

    /// Appends a tuple or a record.
    fn append_parts(
        &mut self,
        heap: &Heap,
        parts: &[Repr],
        slots: &[Slot],
        display: &Display,
    ) -> Result<(), RuntimeError> {
        let (open, close) = match display {
            Display::Record(name, _) => (format!("{name}("), ")"),
            _ => ("[".into(), "]"),
        };
        self.push(&open)?;
        let mut rest = slots;
        for (index, part) in parts.iter().enumerate() {
            if index > 0 {
                self.push(", ")?;
            }
            let (slots, after) = rest.split_at_checked(part.slots()).ok_or_else(not_shown)?;
            rest = after;
            let shown = match display {
                Display::Tuple(all) => all.get(index).ok_or_else(not_shown)?,
                Display::Record(_, fields) => {
                    let (name, shown) = fields.get(index).ok_or_else(not_shown)?;
                    self.push(name)?;
                    self.push(" = ")?;
                    shown
                }
                other => other,
            };
            self.append(heap, part, slots, shown)?;
        }
        self.push(close)
    }

    /// Appends a text with trailing blanks up to its width.
    fn pad(&mut self, shown: &str, display: &Display) -> Result<(), RuntimeError> {
        self.push(shown)?;
        if let Display::Text { width } = display {
            let missing = usize::from(*width).saturating_sub(shown.chars().count());
            self.push(&" ".repeat(missing))?;
        }
        Ok(())
    }
}

/// Returns the error of slots that do not contain a value of their representation.
fn not_shown() -> RuntimeError {
    malformed("not a value that can be shown")
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
        // A short decimal in any unit must be shown unchanged, although conversions round.
        for (factor, unit) in [(0.0254, "inch"), (1e-3, "mm"), (1e-6, "um"), (0.01, "%"), (6894.757, "psi")] {
            for thousandths in -3000..3000 {
                let written = f64::from(thousandths) / 1000.0;
                let style = NumberStyle::in_unit(factor, unit);
                assert_eq!(quantity(to_si(written, factor), &style), format!("{} {unit}", number(written)));
            }
        }
        assert_eq!(quantity(to_si(10.0, 1e-6), &NumberStyle::in_unit(1e-3, "mm")), "0.01 mm");
    }

    #[test]
    fn styles_set_width_digits_and_powers_of_ten() {
        let style = |width, digits, scientific| NumberStyle {
            factor: 1e-3,
            unit: "mm".into(),
            width,
            digits,
            scientific,
        };
        for (x, style, expected) in [
            (0.0123456, style(0, Some(2), false), "12.35 mm"),
            (0.0123456, style(8, Some(2), false), "   12.35 mm"),
            (0.0123456, style(0, Some(1), true), "1.2e1 mm"),
            (0.0123456, style(0, None, true), "1.23456e1 mm"),
            (-1e-9, style(0, Some(3), false), "0.000 mm"),
            (f64::NEG_INFINITY, style(6, Some(3), false), "  -inf mm"),
            (0.5, style(6, None, false), "   500 mm"),
        ] {
            assert_eq!(quantity(x, &style), expected);
        }
    }

    #[test]
    fn records_tuples_and_frames_show_their_parts() {
        let mm = || Display::Number(NumberStyle::in_unit(1e-3, "mm"));
        let plain = || Display::Number(NumberStyle::default());
        let show = |repr: Repr, numbers: &[f64], display: Display| {
            let slots: Vec<Slot> = numbers.iter().map(|x| x.to_bits()).collect();
            let mut text = String::new();
            let endless = |_| Ok(());
            BoundedText::new(&mut text, &endless).append(&Heap::default(), &repr, &slots, &display).unwrap();
            text
        };
        let pair = Repr::Tuple(vec![Repr::Number, Repr::Vector]);
        let fields = vec![("n".into(), plain()), ("at".into(), mm())];
        let numbers = [3.0, -0.0, 0.5, 1.0];
        assert_eq!(
            show(pair.clone(), &numbers, Display::Record("P".into(), fields)),
            "P(n = 3, at = [0 mm, 500 mm, 1000 mm])"
        );
        assert_eq!(show(pair, &numbers, Display::Tuple(vec![plain(), mm()])), "[3, [0 mm, 500 mm, 1000 mm]]");
        let frame = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 1.0, 0.002, 0.0, 0.0];
        assert_eq!(
            show(Repr::Transform, &frame, mm()),
            "[[1, 0, 0], [0, 1, 0], [0, 0, 1], [2 mm, 0 mm, 0 mm]]"
        );
    }
}
