//! Encoding of representations as short byte strings: constants in machine code that describe slots
//! to helpers.
//!
//! One letter per representation; an array or symbolic value is followed by its content, a tuple by
//! its elements and `)`. A list of pairs of a number and an array of strings is `a(nas)`.

use crate::call::Repr;

/// Encodes a representation.
pub fn encode(repr: &Repr) -> Vec<u8> {
    let mut code = Vec::new();
    append(repr, &mut code);
    code
}

fn append(repr: &Repr, code: &mut Vec<u8>) {
    match repr {
        Repr::Unit => code.push(b'u'),
        Repr::Number => code.push(b'n'),
        Repr::Bool => code.push(b'b'),
        Repr::String => code.push(b's'),
        Repr::Vector => code.push(b'v'),
        Repr::Transform => code.push(b't'),
        Repr::Handle => code.push(b'h'),
        Repr::Array(element) => {
            code.push(b'a');
            append(element, code);
        }
        Repr::Symbolic(content) => {
            code.push(b'y');
            append(content, code);
        }
        Repr::Tuple(elements) => {
            code.push(b'(');
            elements.iter().for_each(|element| append(element, code));
            code.push(b')');
        }
    }
}

/// Returns `true` for the code of a representation whose slots are the bits of numbers.
pub fn is_numbers(code: &[u8]) -> bool {
    code.iter().all(|letter| matches!(letter, b'n' | b'v' | b't' | b'(' | b')'))
}

/// Decodes a representation; `None` if the code is invalid.
pub fn decode(code: &[u8]) -> Option<Repr> {
    let (repr, rest) = take(code)?;
    rest.is_empty().then_some(repr)
}

fn take(code: &[u8]) -> Option<(Repr, &[u8])> {
    let (&letter, mut rest) = code.split_first()?;
    let repr = match letter {
        b'u' => Repr::Unit,
        b'n' => Repr::Number,
        b'b' => Repr::Bool,
        b's' => Repr::String,
        b'v' => Repr::Vector,
        b't' => Repr::Transform,
        b'h' => Repr::Handle,
        b'a' | b'y' => {
            let (content, after) = take(rest)?;
            rest = after;
            if letter == b'a' { Repr::Array(Box::new(content)) } else { Repr::Symbolic(Box::new(content)) }
        }
        b'(' => {
            let mut elements = Vec::new();
            while *rest.first()? != b')' {
                let (element, after) = take(rest)?;
                elements.push(element);
                rest = after;
            }
            rest = &rest[1..];
            Repr::Tuple(elements)
        }
        _ => return None,
    };
    Some((repr, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_read_back() {
        let strings = Repr::Array(Box::new(Repr::String));
        let pair = Repr::Tuple(vec![Repr::Number, strings, Repr::Tuple(vec![]), Repr::Bool]);
        for repr in [
            Repr::Unit,
            Repr::Transform,
            Repr::Symbolic(Box::new(Repr::Vector)),
            Repr::Array(Box::new(pair.clone())),
            Repr::Tuple(vec![pair, Repr::Handle]),
        ] {
            assert_eq!(decode(&encode(&repr)), Some(repr));
        }
        for bad in ["", "x", "a", "(n", "nn", ")"] {
            assert_eq!(decode(bad.as_bytes()), None, "{bad}");
        }
    }
}
