//! Array files: a JSON header that refers to arrays of numbers behind it, see
//! `docs/view-files.md`.

use serde_json::{Value, json};
use std::io::{self, Write};
use std::path::Path;
use std::{error, fmt, fs};

/// First bytes of an array file.
pub const MAGIC: &[u8; 8] = b"CALYXARR";
/// Version of the format.
pub const VERSION: u32 = 5;
/// Alignment of the header and of arrays, bytes.
const ALIGNMENT: usize = 8;
/// Number of bytes before the header.
const PREFIX: usize = 16;
/// Extension of files that are being written.
pub(crate) const UNFINISHED: &str = "part";

/// Arrays of a file that is being composed.
#[derive(Debug, Default)]
pub struct Arrays {
    bytes: Vec<u8>,
}

/// Reason why bytes are no array file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InvalidArrayFile(String);

impl fmt::Display for InvalidArrayFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl error::Error for InvalidArrayFile {}

impl Arrays {
    /// Adds an array of single-precision numbers, in rows of `N`, and returns the reference to it.
    pub fn single<const N: usize>(&mut self, rows: impl IntoIterator<Item = [f64; N]>) -> Value {
        let rows = rows.into_iter().map(|row| row.map(|number| (number as f32).to_le_bytes()));
        self.add("f32", rows)
    }

    /// Adds an array of double-precision numbers.
    pub fn double<const N: usize>(&mut self, rows: impl IntoIterator<Item = [f64; N]>) -> Value {
        self.add("f64", rows.into_iter().map(|row| row.map(f64::to_le_bytes)))
    }

    /// Adds an array of unsigned integers.
    pub fn indices<const N: usize>(&mut self, rows: impl IntoIterator<Item = [u32; N]>) -> Value {
        self.add("u32", rows.into_iter().map(|row| row.map(u32::to_le_bytes)))
    }

    fn add<const N: usize, const B: usize>(
        &mut self,
        kind: &str,
        rows: impl Iterator<Item = [[u8; B]; N]>,
    ) -> Value {
        self.bytes.resize(self.bytes.len().next_multiple_of(ALIGNMENT), 0);
        let offset = self.bytes.len();
        let mut count = 0;
        for row in rows {
            self.bytes.extend(row.as_flattened());
            count += 1;
        }
        json!({ "type": kind, "components": N, "count": count, "offset": offset })
    }

    /// Returns the bytes of the file with a header that refers to these arrays.
    pub fn file(self, header: &Value) -> Vec<u8> {
        let mut text = header.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(ALIGNMENT), b' ');
        let mut file = Vec::with_capacity(PREFIX + text.len() + self.bytes.len());
        file.extend(MAGIC);
        file.extend(VERSION.to_le_bytes());
        // Headers describe parts and have a few kilobytes.
        file.extend(u32::try_from(text.len()).unwrap_or(u32::MAX).to_le_bytes());
        file.extend(text);
        file.extend(self.bytes);
        file
    }
}

/// Writes a file under another name first, so that readers only ever find a complete one.
pub(crate) fn write_complete(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut unfinished = path.as_os_str().to_owned();
    unfinished.push(".");
    unfinished.push(UNFINISHED);
    let mut file = fs::File::create(&unfinished)?;
    file.write_all(bytes)?;
    drop(file);
    fs::rename(&unfinished, path)
}

/// Array file in memory.
#[derive(Clone, Debug)]
pub struct ArrayFile<'a> {
    /// Header.
    pub header: Value,
    arrays: &'a [u8],
}

impl<'a> ArrayFile<'a> {
    /// Reads the header of a file.
    ///
    /// # Errors
    /// The bytes are no array file of this version, or the file is truncated.
    pub fn read(bytes: &'a [u8]) -> Result<ArrayFile<'a>, InvalidArrayFile> {
        let invalid = |reason: &str| InvalidArrayFile(reason.to_owned());
        let (prefix, rest) =
            bytes.split_at_checked(PREFIX).ok_or_else(|| invalid("the file is truncated"))?;
        if &prefix[..8] != MAGIC {
            return Err(invalid("the file is no array file"));
        }
        let number = |at: usize| {
            prefix[at..].iter().take(4).rev().fold(0, |sum: u32, byte| sum << 8 | u32::from(*byte))
        };
        if number(8) < VERSION {
            return Err(invalid("it was written by an older version of Calyx"));
        }
        if number(8) != VERSION {
            return Err(InvalidArrayFile(format!(
                "the file has version {} of the format, not {VERSION}",
                number(8)
            )));
        }
        let (header, arrays) =
            rest.split_at_checked(number(12) as usize).ok_or_else(|| invalid("the file is truncated"))?;
        let header = serde_json::from_slice(header).map_err(|error| InvalidArrayFile(error.to_string()))?;
        Ok(ArrayFile { header, arrays })
    }

    /// Returns the numbers of an array from its reference; exact for every type.
    ///
    /// # Errors
    /// The reference is invalid, or the file is truncated.
    pub fn numbers(&self, reference: &Value) -> Result<Vec<f64>, InvalidArrayFile> {
        let invalid =
            || InvalidArrayFile(format!("the reference {reference} is invalid, or the file is truncated"));
        let size = |key: &str| {
            reference[key].as_u64().and_then(|size| usize::try_from(size).ok()).ok_or_else(invalid)
        };
        let count = size("components")?.checked_mul(size("count")?).ok_or_else(invalid)?;
        let bytes = self.arrays.get(size("offset")?..).ok_or_else(invalid)?;
        fn of<const B: usize>(bytes: &[u8], count: usize, number: fn([u8; B]) -> f64) -> Option<Vec<f64>> {
            let bytes = bytes.get(..count.checked_mul(B)?)?;
            Some(bytes.as_chunks().0.iter().map(|&chunk| number(chunk)).collect())
        }
        let numbers = match reference["type"].as_str() {
            Some("f32") => of(bytes, count, |chunk| f64::from(f32::from_le_bytes(chunk))),
            Some("f64") => of(bytes, count, f64::from_le_bytes),
            Some("u32") => of(bytes, count, |chunk| f64::from(u32::from_le_bytes(chunk))),
            _ => None,
        };
        numbers.ok_or_else(invalid)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_are_read_as_written() {
        let mut arrays = Arrays::default();
        let points = arrays.single([[1.0, 2.0, 0.1]]);
        let poses = arrays.double([[0.1, f64::NAN]]);
        let indices = arrays.indices([[7], [u32::MAX]]);
        assert_eq!(poses["offset"], 16);
        let bytes =
            arrays.file(&json!({ "name": "é", "points": points, "poses": poses, "indices": indices }));
        let file = ArrayFile::read(&bytes).unwrap();
        assert_eq!(file.header["name"], "é");
        assert_eq!(file.numbers(&file.header["points"]).unwrap(), [1.0, 2.0, f64::from(0.1_f32)]);
        assert_eq!(file.numbers(&file.header["poses"]).unwrap()[0], 0.1);
        assert!(file.numbers(&file.header["poses"]).unwrap()[1].is_nan());
        assert_eq!(file.numbers(&file.header["indices"]).unwrap(), [7.0, f64::from(u32::MAX)]);
    }

    #[test]
    fn broken_files_are_rejected() {
        let mut arrays = Arrays::default();
        let points = arrays.single([[1.0, 2.0, 0.1]]);
        let bytes = arrays.file(&json!({ "points": points }));
        for length in [0, 15, 20, bytes.len() - 1] {
            let read = ArrayFile::read(&bytes[..length]);
            let numbers = read.and_then(|file| file.numbers(&file.header["points"]));
            assert!(numbers.is_err(), "{length}");
        }
        let with = |at: usize, byte: u8| {
            let mut bytes = bytes.clone();
            bytes[at] = byte;
            ArrayFile::read(&bytes).unwrap_err().to_string()
        };
        assert_eq!(with(0, b'X'), "the file is no array file");
        assert_eq!(with(8, 6), "the file has version 6 of the format, not 5");
        assert_eq!(with(8, 4), "it was written by an older version of Calyx");
        assert_eq!(with(15, 255), "the file is truncated");
        let file = ArrayFile::read(&bytes).unwrap();
        for reference in [
            json!(null),
            json!({ "type": "f32", "components": u64::MAX, "count": 2, "offset": 0 }),
            json!({ "type": "f16", "components": 1, "count": 1, "offset": 0 }),
            json!({ "type": "f32", "components": 1, "count": 1, "offset": 1_u64 << 40 }),
        ] {
            assert!(file.numbers(&reference).is_err(), "{reference}");
        }
    }
}
