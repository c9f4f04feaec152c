//! Fingerprint of the interface between generated code and engine: code that was compiled for
//! another interface is rejected.
//!
//! The hash is computed when the engine is compiled, from the tables that the code generator uses,
//! so a change of a signature changes it automatically. Changes of meaning that the tables do not
//! show are counted by hand ([`SEMANTICS`]).

use crate::call::{Extern, Purity};
use crate::context::{Layout, MAX_DEPTH};
use crate::description::ModuleTable;
use crate::entry::ENTRY_SIGNATURES;
use crate::failure::ERROR_SLOTS;
use crate::math::{FUNCTIONS, MathFn};
use crate::shape::Shape;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::mem::{offset_of, size_of};
use std::str::FromStr;

/// Version of the meaning of the interface, to be incremented for changes that leave names, arities
/// and layouts unchanged: the effect of a helper, the codes of representations, displays and
/// argument tables, the JSON of the description.
pub const SEMANTICS: u64 = 4;

/// Hash of the interface between generated code and an engine, written as sixteen hexadecimal
/// digits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Fingerprint(pub u64);

impl Fingerprint {
    /// Computes the fingerprint of an engine that provides these functions.
    pub const fn of(tables: &[&[Extern]]) -> Fingerprint {
        let mut hash = Hash::new().number(SEMANTICS);
        // Data that generated code accesses itself.
        let words = [
            Layout::GRANTED,
            Layout::DEPTH,
            Layout::PLACE_FILE,
            Layout::PLACE_START,
            Layout::PLACE_END,
            Layout::LIBRARY_CALL_FILE,
            Layout::LIBRARY_CALL_START,
            Layout::LIBRARY_CALL_END,
            MAX_DEPTH as usize,
            ERROR_SLOTS,
            // Data of generated code that the engine reads.
            size_of::<ModuleTable>(),
            offset_of!(ModuleTable, abi),
            offset_of!(ModuleTable, main),
            offset_of!(ModuleTable, kernels),
            offset_of!(ModuleTable, kernel_count),
            offset_of!(ModuleTable, description),
            offset_of!(ModuleTable, description_len),
            offset_of!(ModuleTable, param_functions),
        ];
        let mut i = 0;
        while i < words.len() {
            hash = hash.number(words[i] as u64);
            i += 1;
        }
        i = 0;
        while i < ENTRY_SIGNATURES.len() {
            let (symbol, arguments) = ENTRY_SIGNATURES[i];
            hash = hash.text(symbol).number(arguments as u64);
            i += 1;
        }
        i = 0;
        while i < FUNCTIONS.len() {
            let (symbol, function) = &FUNCTIONS[i];
            let kind = match function {
                MathFn::Unary(_) => 1,
                MathFn::Binary(_) => 2,
                MathFn::Sincos(_) => 8,
                MathFn::SincosColumns(_) => 4,
                MathFn::Unsolved(_) => 5,
                MathFn::Piecewise(_) => 6,
                MathFn::Registered(_) => 7,
            };
            hash = hash.text(symbol).number(kind);
            i += 1;
        }
        i = 0;
        while i < tables.len() {
            hash = hash.externs(tables[i]);
            i += 1;
        }
        Fingerprint(hash.0)
    }
}

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

impl FromStr for Fingerprint {
    type Err = String;

    fn from_str(text: &str) -> Result<Fingerprint, String> {
        let number = u64::from_str_radix(text, 16).ok().filter(|_| text.len() == 16);
        number.map(Fingerprint).ok_or_else(|| format!("`{text}` is not sixteen hexadecimal digits"))
    }
}

// Serialize as text, because JSON readers keep at most 53 bits of a number.
impl Serialize for Fingerprint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Fingerprint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Fingerprint, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}

/// FNV-1a hash, which is short and can be evaluated at compile time. It distinguishes accidental
/// differences, not malicious ones.
#[derive(Clone, Copy)]
struct Hash(u64);

impl Hash {
    const fn new() -> Hash {
        Hash(0xcbf2_9ce4_8422_2325)
    }

    const fn byte(self, byte: u8) -> Hash {
        Hash((self.0 ^ byte as u64).wrapping_mul(0x0000_0100_0000_01b3))
    }

    const fn number(self, number: u64) -> Hash {
        let bytes = number.to_le_bytes();
        let (mut hash, mut i) = (self, 0);
        while i < bytes.len() {
            hash = hash.byte(bytes[i]);
            i += 1;
        }
        hash
    }

    /// Hashes the length too, so that adjacent texts cannot be confused.
    const fn text(self, text: &str) -> Hash {
        let bytes = text.as_bytes();
        let (mut hash, mut i) = (self.number(bytes.len() as u64), 0);
        while i < bytes.len() {
            hash = hash.byte(bytes[i]);
            i += 1;
        }
        hash
    }

    const fn shape(self, shape: &Shape) -> Hash {
        match shape {
            Shape::Unit => self.byte(b'u'),
            Shape::Number => self.byte(b'n'),
            Shape::Bool => self.byte(b'b'),
            Shape::String => self.byte(b's'),
            Shape::Vector => self.byte(b'v'),
            Shape::Transform => self.byte(b't'),
            Shape::Handle => self.byte(b'h'),
            Shape::Array(element) => self.byte(b'a').shape(element),
            Shape::Symbolic(content) => self.byte(b'y').shape(content),
            Shape::Optional(content) => self.byte(b'o').shape(content),
        }
    }

    const fn externs(self, table: &[Extern]) -> Hash {
        let (mut hash, mut i) = (self, 0);
        while i < table.len() {
            let row = &table[i];
            let purity = match row.purity {
                Purity::Pure => 0,
                Purity::Scene => 1,
                Purity::Effect => 2,
            };
            hash = hash.text(row.symbol).byte(purity).number(row.params.len() as u64).shape(&row.result);
            let mut k = 0;
            while k < row.params.len() {
                hash = hash.shape(&row.params[k].1);
                k += 1;
            }
            i += 1;
        }
        hash
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROW: Extern = Extern { symbol: "calyx_test_row", ..crate::standard::EXTERNS[0] };

    #[test]
    fn whatever_changes_shows() {
        let same = Fingerprint::of(&[&[ROW]]);
        assert_eq!(same, Fingerprint::of(&[&[], &[ROW]]));
        let more: &[(&str, Shape)] = &[("line", Shape::String), ("more", Shape::Number)];
        let array: &[(&str, Shape)] = &[("line", Shape::Array(&Shape::String))];
        let others = [
            vec![],
            vec![ROW, ROW],
            vec![Extern { symbol: "calyx_test_low", ..ROW }],
            vec![Extern { purity: Purity::Pure, ..ROW }],
            vec![Extern { params: more, ..ROW }],
            vec![Extern { params: array, ..ROW }],
            vec![Extern { result: Shape::Number, ..ROW }],
        ];
        let mut seen = vec![same];
        for other in others {
            let other = Fingerprint::of(&[&other]);
            assert!(!seen.contains(&other), "{other}");
            seen.push(other);
        }
        // The name of an argument affects only messages.
        let renamed: &[(&str, Shape)] = &[("text", Shape::String)];
        assert_eq!(same, Fingerprint::of(&[&[Extern { params: renamed, ..ROW }]]));
    }

    #[test]
    fn written_as_hexadecimal_digits() {
        let fingerprint = Fingerprint(0x0123_4567_89ab_cdef);
        let json = serde_json::to_string(&fingerprint).unwrap();
        assert_eq!(json, "\"0123456789abcdef\"");
        assert_eq!(serde_json::from_str::<Fingerprint>(&json).unwrap(), fingerprint);
        for wrong in ["", "2", "0123456789abcdeg", "00123456789abcdef"] {
            assert!(wrong.parse::<Fingerprint>().is_err(), "{wrong}");
        }
    }
}
