//! Values of an MSH file, in text or binary form.

use super::super::origin::Problem;
use super::super::source::Place;

pub(super) type Result<T> = std::result::Result<T, Problem>;

/// Form of the numbers of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Form {
    Text,
    /// Binary; true if the bytes are in the other order than `u64::from_le_bytes` expects.
    Binary(bool),
}

/// Position in the content of a file.
pub(super) struct Reader<'d> {
    data: &'d [u8],
    at: usize,
    pub form: Form,
    /// Section that is being read, and its start.
    section: String,
    section_start: usize,
    /// Position up to which lines are counted, and the line there.
    counted: (usize, u32),
}

impl<'d> Reader<'d> {
    pub fn new(data: &'d [u8]) -> Self {
        Self { data, at: 0, form: Form::Text, section: String::new(), section_start: 0, counted: (0, 1) }
    }

    /// Location for messages: the line of text, or the line at which a binary section starts.
    pub fn place(&self) -> Place {
        let end = match self.form {
            Form::Text => self.at,
            Form::Binary(_) => self.section_start,
        };
        let line = 1 + self.data[..end.min(self.data.len())].iter().filter(|byte| **byte == b'\n').count();
        Place { file: 0, line: line as u32 }
    }

    /// Location of an item for later messages. Lines are counted from the last one, so that it
    /// costs little.
    pub fn counted_place(&mut self) -> Place {
        if let Form::Text = self.form {
            let (at, line) = self.counted;
            let line = line + self.data[at..self.at].iter().filter(|byte| **byte == b'\n').count() as u32;
            self.counted = (self.at, line);
            return Place { file: 0, line };
        }
        let (at, line) = self.counted;
        let end = self.section_start.max(at);
        let line = line + self.data[at..end].iter().filter(|byte| **byte == b'\n').count() as u32;
        self.counted = (end, line);
        Place { file: 0, line }
    }

    pub fn problem(&self, message: impl Into<String>, help: impl Into<String>) -> Problem {
        Problem::new(self.place(), message, help)
    }

    fn truncated(&self, what: &str) -> Problem {
        let message = match self.section.as_str() {
            "" => format!("the file ends where {what} is expected"),
            section => format!("${section} ends where {what} is expected"),
        };
        self.problem(message, "export the mesh again; the file is not complete")
    }

    /// Next line without its end, or `None` at the end of the file.
    pub fn line(&mut self) -> Option<&'d str> {
        let rest = self.data.get(self.at..).filter(|rest| !rest.is_empty())?;
        let end = rest.iter().position(|byte| *byte == b'\n').unwrap_or(rest.len());
        self.at += (end + 1).min(rest.len());
        Some(std::str::from_utf8(&rest[..end]).unwrap_or("").trim())
    }

    /// Starts the next section, and returns its name.
    pub fn next_section(&mut self) -> Result<Option<String>> {
        loop {
            let start = self.at;
            let Some(line) = self.line() else { return Ok(None) };
            if let Some(name) = line.strip_prefix('$') {
                self.section = name.to_owned();
                self.section_start = start;
                return Ok(Some(name.to_owned()));
            }
            if !line.is_empty() {
                self.at = start;
                return Err(
                    self.problem("a section that begins with `$` is expected here", "export the mesh again")
                );
            }
        }
    }

    /// Ends a section.
    pub fn end_section(&mut self) -> Result<()> {
        let expected = format!("$End{}", self.section);
        self.skip_blanks();
        self.form = Form::Text;
        if self.data[self.at..].starts_with(expected.as_bytes()) {
            self.at += expected.len();
            self.line();
            self.section.clear();
            return Ok(());
        }
        Err(self.problem(format!("{expected} is expected here"), "export the mesh again; a count is wrong"))
    }

    /// Skips to the end of a section.
    pub fn skip_section(&mut self) -> Result<()> {
        let expected = format!("$End{}", self.section).into_bytes();
        let rest = &self.data[self.at..];
        match rest.windows(expected.len()).position(|window| window == expected) {
            Some(offset) => {
                self.at += offset;
                self.end_section()
            }
            None => Err(self.truncated("its end")),
        }
    }

    fn skip_blanks(&mut self) {
        while self.data.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
    }

    fn token(&mut self, what: &str) -> Result<&'d str> {
        self.skip_blanks();
        let rest = &self.data[self.at..];
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let token = std::str::from_utf8(&rest[..end])
            .ok()
            .filter(|token| !token.is_empty() && !token.starts_with('$'));
        let token = token.ok_or_else(|| self.truncated(what))?;
        self.at += end;
        Ok(token)
    }

    fn bytes<const N: usize>(&mut self, swapped: bool, what: &str) -> Result<[u8; N]> {
        let bytes = self.data.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        let mut bytes = *bytes.ok_or_else(|| self.truncated(what))?;
        self.at += N;
        if swapped {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn parsed<T: std::str::FromStr>(&mut self, what: &str) -> Result<T> {
        let token = self.token(what)?;
        token.parse().map_err(|_| {
            self.problem(format!("{what} is `{token}`, but must be a number"), "export the mesh again")
        })
    }

    /// Integer of four bytes.
    pub fn int(&mut self, what: &str) -> Result<i32> {
        match self.form {
            Form::Text => self.parsed(what),
            Form::Binary(swapped) => self.bytes(swapped, what).map(i32::from_le_bytes),
        }
    }

    /// Unsigned integer of eight bytes.
    pub fn size(&mut self, what: &str) -> Result<u64> {
        match self.form {
            Form::Text => self.parsed(what),
            Form::Binary(swapped) => self.bytes(swapped, what).map(u64::from_le_bytes),
        }
    }

    pub fn double(&mut self, what: &str) -> Result<f64> {
        let value: f64 = match self.form {
            Form::Text => self.parsed(what)?,
            Form::Binary(swapped) => self.bytes(swapped, what).map(f64::from_le_bytes)?,
        };
        match value.is_finite() {
            true => Ok(value),
            false => Err(self.problem(format!("{what} is not finite"), "export the mesh again")),
        }
    }

    /// Number one that shows the order of bytes.
    pub fn byte_order(&mut self) -> Result<bool> {
        match i32::from_le_bytes(self.bytes(false, "the number one of a binary file")?) {
            1 => Ok(false),
            0x0100_0000 => Ok(true),
            _ => {
                Err(self
                    .problem("the binary file does not begin with the number one", "export the mesh again"))
            }
        }
    }
}
