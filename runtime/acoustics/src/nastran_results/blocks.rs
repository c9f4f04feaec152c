//! Physical structure of OP2 files: Fortran records, keys, and data blocks of logical records.
//!
//! Source: NX Nastran DMAP Programmer's Guide, "OUTPUT2"; data blocks by `PARAM,POST,-1`.
//!
//! Each Fortran record has its length in bytes before and after it, as 32-bit integers of the byte
//! order of the file. A record of one word is a key: a positive one is the number of words of the
//! next record, a negative one begins a logical record, and zero ends a data block. Words have four
//! or eight bytes. A data block begins with its name; its logical records are 1, the trailer, 2,
//! the header, and from 3 on the content. From 2 on, the first word is the type: zero for tables,
//! and others for columns of matrices.

use super::vectors::{Result, error};
use std::borrow::Cow;

/// Remedy for damaged files.
const DAMAGED: &str = "write the file again, with PARAM,POST,-1, and transfer it as binary data";

/// Words of a logical record.
#[derive(Clone, Debug)]
pub(super) struct Words<'f> {
    bytes: Cow<'f, [u8]>,
    order: Order,
}

/// Size and byte order of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Order {
    /// Bytes of a word: 4 or 8.
    size: usize,
    is_big_endian: bool,
}

impl Order {
    fn length(self, bytes: [u8; 4]) -> i64 {
        i64::from(if self.is_big_endian { i32::from_be_bytes(bytes) } else { i32::from_le_bytes(bytes) })
    }

    fn integer(self, word: &[u8]) -> Option<i64> {
        if self.size == 4 {
            return word.try_into().ok().map(|bytes| self.length(bytes));
        }
        let bytes = word.try_into().ok()?;
        Some(if self.is_big_endian { i64::from_be_bytes(bytes) } else { i64::from_le_bytes(bytes) })
    }

    fn real(self, word: &[u8]) -> Option<f64> {
        if self.size == 4 {
            let bytes = word.try_into().ok()?;
            let value =
                if self.is_big_endian { f32::from_be_bytes(bytes) } else { f32::from_le_bytes(bytes) };
            return Some(f64::from(value));
        }
        let bytes = word.try_into().ok()?;
        Some(if self.is_big_endian { f64::from_be_bytes(bytes) } else { f64::from_le_bytes(bytes) })
    }
}

impl Words<'_> {
    /// Returns the number of words.
    pub fn len(&self) -> usize {
        self.bytes.len() / self.order.size
    }

    fn word(&self, at: usize) -> Option<&[u8]> {
        let from = at.checked_mul(self.order.size)?;
        self.bytes.get(from..from.checked_add(self.order.size)?)
    }

    /// Returns a word, from 0, as an integer; 0 after the end.
    pub fn integer(&self, at: usize) -> i64 {
        self.word(at).and_then(|word| self.order.integer(word)).unwrap_or(0)
    }

    /// Returns a word, from 0, as a real number; NaN after the end.
    pub fn real(&self, at: usize) -> f64 {
        self.word(at).and_then(|word| self.order.real(word)).unwrap_or(f64::NAN)
    }
}

/// Logical record of a data block.
pub(super) struct LogicalRecord<'f> {
    /// Number, from 1.
    pub number: i64,
    /// Words without the type.
    pub words: Words<'f>,
}

/// Name of a data block with its first byte in the file.
pub(super) struct BlockName {
    pub name: String,
    pub at: usize,
}

/// Reader of the data blocks of a file.
pub(super) struct Blocks<'f> {
    content: &'f [u8],
    /// Next byte.
    at: usize,
    order: Order,
    /// Name of the current data block, for messages.
    block: String,
    /// Key that was read ahead.
    next: Option<i64>,
    /// True after the zero that ends most files, which follows that of the last data block.
    has_end: bool,
}

impl<'f> Blocks<'f> {
    /// Recognizes size and order of the words, and skips the label of the file.
    pub fn new(content: &'f [u8]) -> Result<Self> {
        let first = content.first_chunk::<4>().copied().unwrap_or_default();
        let sizes = [(false, i32::from_le_bytes(first)), (true, i32::from_be_bytes(first))];
        let found = sizes.into_iter().find(|(_, size)| [4, 8].contains(size));
        let Some((is_big_endian, size)) = found else {
            return error(
                "byte 0",
                "the file does not begin with a Fortran record of one word, as OP2 files do",
                "give the results as an OP2 file (PARAM,POST,-1), or as a punch file (DISP(PUNCH)=ALL)",
            );
        };
        let order = Order { size: size as usize, is_big_endian };
        let mut blocks = Self { content, at: 0, order, block: String::new(), next: None, has_end: false };
        // Files of PARAM,POST,-2 have no label, and begin with the name of a data block.
        let mut key = blocks.key()?;
        if key == Some(2) {
            blocks.next = key;
            return Ok(blocks);
        }
        while let Some(count) = key.filter(|key| *key != 0) {
            if count > 0 {
                // Some programs write a date that is shorter than its key announces.
                blocks.data(count, true)?;
            }
            key = blocks.key()?;
        }
        Ok(blocks)
    }

    fn place(&self, at: usize) -> String {
        match self.block.as_str() {
            "" => format!("byte {at}"),
            name => format!("table {name}, byte {at}"),
        }
    }

    fn damaged<T>(&self, at: usize, message: impl Into<String>) -> Result<T> {
        error(self.place(at), message, DAMAGED)
    }

    fn truncated<T>(&self) -> Result<T> {
        error(
            self.place(self.content.len()),
            "the file ends within a table",
            "check that the analysis finished, and copy the whole file",
        )
    }

    /// Returns the next Fortran record; `None` at the end of the file.
    fn record(&mut self) -> Result<Option<&'f [u8]>> {
        let at = self.at;
        if at == self.content.len() {
            return Ok(None);
        }
        let marker =
            |at: usize| -> Option<[u8; 4]> { self.content.get(at..at.checked_add(4)?)?.try_into().ok() };
        let Some(before) = marker(at) else { return self.truncated() };
        let length = self.order.length(before);
        let Ok(size) = usize::try_from(length) else {
            return self.damaged(at, format!("the Fortran record has {length} bytes"));
        };
        let Some(bytes) = self.content.get(at + 4..).and_then(|rest| rest.get(..size)) else {
            return self.truncated();
        };
        let Some(after) = marker(at + 4 + size) else { return self.truncated() };
        if after != before {
            let after = self.order.length(after);
            return self.damaged(
                at,
                format!("the Fortran record has {length} bytes at its beginning, and {after} at its end"),
            );
        }
        self.at = at + 8 + size;
        Ok(Some(bytes))
    }

    /// Returns the next key; `None` at the end of the file.
    fn key(&mut self) -> Result<Option<i64>> {
        if let Some(key) = self.next.take() {
            return Ok(Some(key));
        }
        let at = self.at;
        let Some(bytes) = self.record()? else { return Ok(None) };
        match self.order.integer(bytes) {
            Some(key) => Ok(Some(key)),
            None => self.damaged(
                at,
                format!("a record of {} bytes is where a key of one word is expected", bytes.len()),
            ),
        }
    }

    /// Returns the record that a key announces. It may have `any` size if it is skipped, as those
    /// of matrices, which are longer than their keys announce.
    fn data(&mut self, count: i64, any: bool) -> Result<&'f [u8]> {
        let at = self.at;
        let Some(bytes) = self.record()? else { return self.truncated() };
        let is_valid = i64::try_from(bytes.len()).ok() == count.checked_mul(self.order.size as i64);
        match is_valid || any {
            true => Ok(bytes),
            false => self.damaged(
                at,
                format!("the record has {} bytes, and its key announces {count} words", bytes.len()),
            ),
        }
    }

    /// Returns the name of the next data block; `None` at the end of the file.
    pub fn next_block(&mut self) -> Result<Option<BlockName>> {
        self.block.clear();
        self.has_end = false;
        loop {
            let at = self.at;
            match self.key()? {
                None => return Ok(None),
                Some(0) => self.has_end = true,
                Some(2) => {
                    let bytes = self.data(2, false)?;
                    let name: String = bytes
                        .iter()
                        .filter(|byte| byte.is_ascii_graphic())
                        .map(|byte| char::from(*byte))
                        .collect();
                    self.block.clone_from(&name);
                    // Newer programs add their version to the name.
                    self.next = self.key()?;
                    while let Some(count) = self.next.filter(|key| *key > 0) {
                        self.next = None;
                        self.data(count, false)?;
                        self.next = self.key()?;
                    }
                    return Ok(Some(BlockName { name, at }));
                }
                Some(key) => {
                    return self
                        .damaged(at, format!("the key {key} is where the name of a table is expected"));
                }
            }
        }
    }

    /// Returns whether the file has its end mark: without it, the last tables may be missing.
    pub fn has_end(&self) -> bool {
        self.has_end
    }

    /// Returns the next logical record of the data block; `None` at its end.
    pub fn next_record(&mut self) -> Result<Option<LogicalRecord<'f>>> {
        let at = self.at;
        let number = match self.key()? {
            None => return self.truncated(),
            Some(0) => return Ok(None),
            Some(key) if key < 0 => key.saturating_neg(),
            Some(key) => {
                return self
                    .damaged(at, format!("the key {key} is where a logical record is expected to begin"));
            }
        };
        let mut is_matrix = false;
        let mut words: Cow<'f, [u8]> = Cow::Borrowed(&[]);
        let mut has_type = number == 1;
        loop {
            let Some(key) = self.key()? else { return self.truncated() };
            if key <= 0 {
                self.next = Some(key);
                break;
            }
            let bytes = self.data(key, is_matrix)?;
            if !has_type {
                has_type = true;
                is_matrix = self.order.integer(bytes) != Some(0);
            } else if words.is_empty() {
                words = Cow::Borrowed(bytes);
            } else {
                words.to_mut().extend_from_slice(bytes);
            }
        }
        Ok(Some(LogicalRecord { number, words: Words { bytes: words, order: self.order } }))
    }
}
