//! Argument table of a call, stored in compiled code: source locations of arguments by name. With
//! it an error that names an argument can be located in an executable without its source tree.
//!
//! Encoding of an argument: its file, start and end as little-endian `u32`, the length of its name,
//! its name.

use crate::error::{Place, RuntimeError};

/// Encodes the table of some arguments.
pub fn encode<'n>(arguments: impl IntoIterator<Item = (&'n str, Place)>) -> Vec<u8> {
    let mut bytes = Vec::new();
    for (name, (file, start, end)) in arguments {
        for word in [file, start, end, name.len() as u32] {
            bytes.extend(word.to_le_bytes());
        }
        bytes.extend(name.bytes());
    }
    bytes
}

/// Moves the location of an error to the argument that it names, if the table contains it.
/// Otherwise (default values) the location of the call remains.
pub fn blame(error: &mut RuntimeError, table: &[u8]) {
    let Some(wanted) = &error.argument else { return };
    let mut rest = table;
    while let Some((head, after)) = rest.split_at_checked(16) {
        let word =
            |i: usize| head[4 * i..4 * i + 4].iter().rev().fold(0, |sum, &byte| sum << 8 | u32::from(byte));
        let Some((name, after)) = after.split_at_checked(word(3) as usize) else { return };
        if name == wanted.as_bytes() {
            error.place = Some((word(0), word(1), word(2)));
            return;
        }
        rest = after;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_blamed_argument_is_found() {
        let table = encode([("teeth", (0, 1, 2)), ("größe", (3, 70_000, 70_009))]);
        let mut error = RuntimeError::new("E0604", "", "").of_argument("größe");
        blame(&mut error, &table);
        assert_eq!(error.place, Some((3, 70_000, 70_009)));
        let mut other = RuntimeError::new("E0604", "", "").of_argument("module");
        blame(&mut other, &table);
        blame(&mut other, &table[..20]);
        assert_eq!(other.place, None);
    }
}
