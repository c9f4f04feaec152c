//! Display styles of values: units, digits, field names. They are constants of the program,
//! arguments of `text`.
//!
//! The structure follows the value's representation. In machine code it is a short byte string
//! ([`Display::encode`]).

/// Display style of a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Display {
    /// Plain: Booleans, handles, symbolic values.
    Plain,
    /// Text, padded to a width.
    Text {
        width: u8,
    },
    /// Number, each component of a vector, or the translation of a frame.
    Number(NumberStyle),
    /// Style of every element.
    Array(Box<Display>),
    Tuple(Vec<Display>),
    /// Name, and names of the fields of a value stored as a tuple.
    Record(String, Vec<(String, Display)>),
    /// Style of an optional value, stored as a tuple of a Boolean and the value.
    Optional(Box<Display>),
}

/// Display style of a number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NumberStyle {
    /// SI value of the unit; 0 stands for 1, so that the default is a dimensionless number.
    pub factor: f64,
    /// Name of the unit; empty for none.
    pub unit: String,
    /// Minimum width of the number in characters; 0 for none.
    pub width: u8,
    /// Digits after the decimal point; `None` for as many as are required to read the number back.
    pub digits: Option<u8>,
    /// True for scientific notation.
    pub scientific: bool,
}

impl NumberStyle {
    /// Creates a style with a unit and as many digits as are required.
    pub fn in_unit(factor: f64, unit: impl Into<String>) -> Self {
        NumberStyle { factor, unit: unit.into(), ..NumberStyle::default() }
    }
}

impl Display {
    /// Encodes the style as a constant of machine code.
    pub fn encode(&self) -> Vec<u8> {
        let mut code = Vec::new();
        self.append(&mut code);
        code
    }

    fn append(&self, code: &mut Vec<u8>) {
        match self {
            Display::Plain => code.push(b'p'),
            Display::Text { width } => code.extend([b's', *width]),
            Display::Number(style) => {
                let flags = u8::from(style.digits.is_some()) + 2 * u8::from(style.scientific);
                code.extend([b'n', flags, style.width, style.digits.unwrap_or(0)]);
                code.extend(style.factor.to_le_bytes());
                append_name(&style.unit, code);
            }
            Display::Array(element) => {
                code.push(b'a');
                element.append(code);
            }
            Display::Tuple(parts) => {
                code.push(b't');
                code.extend((parts.len() as u32).to_le_bytes());
                parts.iter().for_each(|part| part.append(code));
            }
            Display::Optional(value) => {
                code.push(b'o');
                value.append(code);
            }
            Display::Record(name, fields) => {
                code.push(b'r');
                append_name(name, code);
                code.extend((fields.len() as u32).to_le_bytes());
                for (name, field) in fields {
                    append_name(name, code);
                    field.append(code);
                }
            }
        }
    }

    /// Decodes a style; `None` if the code is invalid.
    pub fn decode(code: &[u8]) -> Option<Display> {
        let mut rest = code;
        let display = take(&mut rest)?;
        rest.is_empty().then_some(display)
    }
}

fn append_name(name: &str, code: &mut Vec<u8>) {
    code.extend((name.len() as u32).to_le_bytes());
    code.extend(name.as_bytes());
}

fn take(rest: &mut &[u8]) -> Option<Display> {
    let [letter] = bytes(rest)?;
    Some(match letter {
        b'p' => Display::Plain,
        b's' => {
            let [width] = bytes(rest)?;
            Display::Text { width }
        }
        b'n' => {
            let [flags, width, digits] = bytes(rest)?;
            let factor = f64::from_le_bytes(bytes(rest)?);
            let unit = take_name(rest)?;
            let digits = (flags & 1 != 0).then_some(digits);
            Display::Number(NumberStyle { factor, unit, width, digits, scientific: flags & 2 != 0 })
        }
        b'a' => Display::Array(Box::new(take(rest)?)),
        b'o' => Display::Optional(Box::new(take(rest)?)),
        b't' => {
            let count = u32::from_le_bytes(bytes(rest)?);
            Display::Tuple((0..count).map(|_| take(rest)).collect::<Option<_>>()?)
        }
        b'r' => {
            let name = take_name(rest)?;
            let count = u32::from_le_bytes(bytes(rest)?);
            let field = |_| Some((take_name(rest)?, take(rest)?));
            Display::Record(name, (0..count).map(field).collect::<Option<_>>()?)
        }
        _ => return None,
    })
}

fn bytes<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    let (first, after) = rest.split_first_chunk()?;
    *rest = after;
    Some(*first)
}

fn take_name(rest: &mut &[u8]) -> Option<String> {
    let length = u32::from_le_bytes(bytes(rest)?) as usize;
    let (name, after) = rest.split_at_checked(length)?;
    *rest = after;
    String::from_utf8(name.to_vec()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_read_back() {
        let number = Display::Number(NumberStyle {
            factor: 0.0254,
            unit: "µinch".into(),
            width: 9,
            digits: Some(0),
            scientific: true,
        });
        let record = Display::Record(
            "Blank".into(),
            vec![("width".into(), number), ("list".into(), Display::Array(Box::new(Display::Plain)))],
        );
        let all = Display::Tuple(vec![
            record,
            Display::Text { width: 3 },
            Display::Number(NumberStyle::default()),
            Display::Tuple(vec![]),
            Display::Optional(Box::new(Display::Plain)),
        ]);
        let code = all.encode();
        assert_eq!(Display::decode(&code), Some(all));
        for end in 0..code.len() {
            assert_eq!(Display::decode(&code[..end]), None);
        }
    }
}
