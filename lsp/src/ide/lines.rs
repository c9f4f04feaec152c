//! Lines of a text: where they begin, end, and how far they are indented.

/// The line ends of a text, found once.
pub struct Lines<'t> {
    text: &'t str,
    /// Where each line begins; the first at 0.
    starts: Vec<u32>,
}

impl<'t> Lines<'t> {
    pub fn new(text: &'t str) -> Lines<'t> {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let starts = std::iter::once(0).chain(ends.map(|(at, _)| at as u32 + 1)).collect();
        Lines { text, starts }
    }

    /// The line a byte is on, counted from 0.
    pub fn line(&self, offset: u32) -> usize {
        self.starts.partition_point(|start| *start <= offset).saturating_sub(1)
    }

    /// Where a line begins; past the last line, the end of the text.
    pub fn start(&self, line: usize) -> u32 {
        self.starts.get(line).copied().unwrap_or(self.text.len() as u32)
    }

    /// Where a line ends, its line end left out.
    pub fn end(&self, line: usize) -> u32 {
        let start = self.start(line);
        let content = slice(self.text, start, self.start(line + 1));
        start + content.trim_end_matches(['\n', '\r']).len() as u32
    }

    /// A line without its line end.
    pub fn content(&self, line: usize) -> &'t str {
        slice(self.text, self.start(line), self.end(line))
    }

    /// The blanks a line begins with.
    pub fn indentation(&self, line: usize) -> &'t str {
        let content = self.content(line);
        &content[..content.len() - content.trim_start().len()]
    }

    /// Whether only blanks stand before a byte on its line.
    pub fn begins(&self, offset: u32) -> bool {
        slice(self.text, self.start(self.line(offset)), offset).trim().is_empty()
    }
}

/// A part of a text; nothing where the places are not in it.
pub fn slice(text: &str, start: u32, end: u32) -> &str {
    text.get(start as usize..end as usize).unwrap_or_default()
}
