//! Lines of a text: starts, ends and indentation.

/// Line index of a text.
pub struct Lines<'t> {
    text: &'t str,
    /// Start of each line; the first is 0.
    starts: Vec<u32>,
}

impl<'t> Lines<'t> {
    pub fn new(text: &'t str) -> Lines<'t> {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let starts = std::iter::once(0).chain(ends.map(|(at, _)| at as u32 + 1)).collect();
        Lines { text, starts }
    }

    /// Returns the line of a byte, counted from 0.
    pub fn line(&self, offset: u32) -> usize {
        self.starts.partition_point(|start| *start <= offset).saturating_sub(1)
    }

    /// Returns the start of a line; after the last line, the end of the text.
    pub fn start(&self, line: usize) -> u32 {
        self.starts.get(line).copied().unwrap_or(self.text.len() as u32)
    }

    /// Returns the end of a line, without its line break.
    pub fn end(&self, line: usize) -> u32 {
        let start = self.start(line);
        let content = slice(self.text, start, self.start(line + 1));
        start + content.trim_end_matches(['\n', '\r']).len() as u32
    }

    /// Returns a line without its line break.
    pub fn content(&self, line: usize) -> &'t str {
        slice(self.text, self.start(line), self.end(line))
    }

    /// Returns the blanks at the start of a line.
    pub fn indentation(&self, line: usize) -> &'t str {
        let content = self.content(line);
        &content[..content.len() - content.trim_start().len()]
    }

    /// Returns true if only blanks precede a byte on its line.
    pub fn begins(&self, offset: u32) -> bool {
        slice(self.text, self.start(self.line(offset)), offset).trim().is_empty()
    }
}

/// Returns a part of a text; empty if the range is invalid.
pub fn slice(text: &str, start: u32, end: u32) -> &str {
    text.get(start as usize..end as usize).unwrap_or_default()
}
