//! A text with its lines, and the conversion between byte offsets and positions of the protocol,
//! which are lines and code units of an encoding.
//!
//! Positions from clients are clamped: a position past the end of a line or of the text, or in the
//! middle of a character, moves to the nearest position before it. No function here fails.

use std::ops::Range as Bytes;
use std::sync::Arc;
use tower_lsp_server::ls_types::{Position, Range, TextDocumentContentChangeEvent};

/// Encoding in which a client counts the units of a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    Utf8,
    /// Supported by every client.
    #[default]
    Utf16,
}

/// A text with its lines.
#[derive(Debug)]
pub struct Text {
    content: Arc<str>,
    /// Offset of the first byte of each line; the first is 0.
    starts: Vec<u32>,
}

impl Text {
    pub fn new(content: impl Into<Arc<str>>) -> Text {
        let content = content.into();
        let bytes = content.as_bytes();
        let mut starts = vec![0];
        for (at, byte) in bytes.iter().enumerate() {
            // A carriage return ends a line unless the line feed after it does.
            if *byte == b'\n' || (*byte == b'\r' && bytes.get(at + 1) != Some(&b'\n')) {
                starts.push(at as u32 + 1);
            }
        }
        Text { content, starts }
    }

    pub fn content(&self) -> &Arc<str> {
        &self.content
    }

    pub fn len(&self) -> u32 {
        self.content.len() as u32
    }

    pub fn is_empty(&self) -> bool {
        self.content.is_empty()
    }

    /// Returns the byte range of a line without its line terminator; lines count from 0.
    pub fn line(&self, line: u32) -> Bytes<u32> {
        let Some(&start) = self.starts.get(line as usize) else { return self.len()..self.len() };
        let end = self.starts.get(line as usize + 1).copied().unwrap_or(self.len());
        let text = self.slice(start..end);
        let content = text.strip_suffix("\r\n").or_else(|| text.strip_suffix(['\n', '\r'])).unwrap_or(text);
        start..start + content.len() as u32
    }

    /// Returns a part of the text; empty if the range is invalid.
    pub fn slice(&self, bytes: Bytes<u32>) -> &str {
        self.content.get(bytes.start as usize..bytes.end as usize).unwrap_or_default()
    }

    /// Converts a position of a client to a byte offset.
    pub fn offset(&self, position: Position, encoding: Encoding) -> u32 {
        let line = self.line(position.line);
        let text = self.slice(line.clone());
        let wanted = position.character as usize;
        let within = match encoding {
            Encoding::Utf8 => text.floor_char_boundary(wanted.min(text.len())),
            Encoding::Utf16 => {
                let mut units = 0;
                let fits = |character: &char| {
                    units += character.len_utf16();
                    units <= wanted
                };
                text.chars().take_while(fits).map(char::len_utf8).sum()
            }
        };
        line.start + within as u32
    }

    /// Converts a byte offset to a position for a client.
    pub fn position(&self, offset: u32, encoding: Encoding) -> Position {
        let offset = self.content.floor_char_boundary(offset as usize) as u32;
        let line = self.starts.partition_point(|start| *start <= offset).saturating_sub(1) as u32;
        let bytes = self.line(line);
        let before = self.slice(bytes.start..offset.min(bytes.end));
        let character = match encoding {
            Encoding::Utf8 => before.len(),
            Encoding::Utf16 => before.chars().map(char::len_utf16).sum(),
        };
        Position { line, character: character as u32 }
    }

    pub fn range(&self, bytes: Bytes<u32>, encoding: Encoding) -> Range {
        Range { start: self.position(bytes.start, encoding), end: self.position(bytes.end, encoding) }
    }

    /// Converts a range of a client to a byte range.
    pub fn bytes(&self, range: Range, encoding: Encoding) -> Bytes<u32> {
        let (start, end) = (self.offset(range.start, encoding), self.offset(range.end, encoding));
        start.min(end)..start.max(end)
    }

    /// Returns the text after changes; each refers to the result of the previous ones.
    pub fn changed(
        self: &Arc<Text>,
        changes: &[TextDocumentContentChangeEvent],
        encoding: Encoding,
    ) -> Arc<Text> {
        let mut text = self.clone();
        for change in changes {
            let bytes = match change.range {
                Some(range) => text.bytes(range, encoding),
                None => 0..text.len(),
            };
            let mut content = String::with_capacity(text.content.len() + change.text.len());
            content.push_str(text.slice(0..bytes.start));
            content.push_str(&change.text);
            content.push_str(text.slice(bytes.end..text.len()));
            text = Arc::new(Text::new(content));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(line: u32, character: u32) -> Position {
        Position { line, character }
    }

    fn change(from: Position, to: Position, text: &str) -> TextDocumentContentChangeEvent {
        let range = Some(Range { start: from, end: to });
        TextDocumentContentChangeEvent { range, range_length: None, text: text.into() }
    }

    #[test]
    fn every_byte_has_a_position_that_means_it() {
        let text = Text::new("aµ😀b\r\nü\rx\n");
        for encoding in [Encoding::Utf8, Encoding::Utf16] {
            for (offset, _) in text.content.char_indices() {
                // There is no position between a carriage return and its line feed.
                let expected = if offset == 9 { 8 } else { offset as u32 };
                let position = text.position(offset as u32, encoding);
                assert_eq!(text.offset(position, encoding), expected, "{position:?}");
            }
        }
        assert_eq!(text.position(8, Encoding::Utf16), at(0, 5));
        assert_eq!(text.position(8, Encoding::Utf8), at(0, 8));
        assert_eq!(text.position(text.len(), Encoding::Utf16), at(3, 0));
    }

    #[test]
    fn places_that_are_not_there_are_moved_before() {
        let text = Text::new("aµ😀b\r\nü");
        // The second half of a surrogate pair, the middle of a character, past the end of a line,
        // past the end of the text.
        assert_eq!(text.offset(at(0, 3), Encoding::Utf16), 3);
        assert_eq!(text.offset(at(0, 5), Encoding::Utf8), 3);
        assert_eq!(text.offset(at(0, 99), Encoding::Utf16), 8);
        assert_eq!(text.offset(at(0, u32::MAX), Encoding::Utf8), 8);
        assert_eq!(text.offset(at(7, 1), Encoding::Utf16), text.len());
        assert_eq!(text.position(99, Encoding::Utf16), at(1, 1));
    }

    #[test]
    fn changes_build_on_each_other() {
        let text = Arc::new(Text::new("first µ\nsecond\n"));
        let changes = [change(at(0, 6), at(0, 7), "😀"), change(at(0, 8), at(1, 3), "x\r\n")];
        let changed = text.changed(&changes, Encoding::Utf16);
        assert_eq!(&**changed.content(), "first 😀x\r\nond\n");
        let whole = TextDocumentContentChangeEvent { range: None, range_length: None, text: "new".into() };
        assert_eq!(&**text.changed(&[whole], Encoding::Utf16).content(), "new");
        let backwards = change(at(1, 6), at(1, 0), "");
        assert_eq!(&**text.changed(&[backwards], Encoding::Utf16).content(), "first µ\n\n");
    }
}
