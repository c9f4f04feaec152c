//! Records of universal files: lines, fixed columns and Fortran numbers.

use std::fmt::Write;

/// Reason why a universal file is rejected, with its location and a remedy.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {message}")]
pub struct UnvError {
    /// Line, from 1; for errors of writing, the number of the dataset in the list.
    pub line: usize,
    /// Statement of the problem.
    pub message: String,
    /// Remedy, in the imperative.
    pub help: String,
}

impl UnvError {
    pub(super) fn new(line: usize, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { line, message: message.into(), help: help.into() }
    }
}

/// Result with the errors of universal files.
pub(super) type Result<T> = std::result::Result<T, UnvError>;

/// Largest number of lines of a file; its locations are 32-bit numbers elsewhere.
pub(super) const MOST_LINES: usize = 100_000_000;

/// Lines of a dataset, without its delimiters and number.
pub(super) struct Records<'t> {
    pub number: u32,
    lines: &'t [&'t str],
    /// Line of the file before the first one, from 1.
    first: usize,
    at: usize,
    /// Characters of the lines from each one on, and 0.
    left: Vec<usize>,
}

impl<'t> Records<'t> {
    pub fn new(number: u32, lines: &'t [&'t str], first: usize) -> Self {
        let mut left = vec![0; lines.len() + 1];
        for (at, line) in lines.iter().enumerate().rev() {
            left[at] = left[at + 1] + line.len();
        }
        Self { number, lines, first, at: 0, left }
    }

    pub fn is_empty(&self) -> bool {
        self.at >= self.lines.len()
    }

    /// Line of the last record, for messages.
    pub fn line(&self) -> usize {
        self.first + self.at
    }

    pub fn error(&self, message: impl Into<String>, help: impl Into<String>) -> UnvError {
        UnvError::new(self.line(), message, help)
    }

    /// Returns the next line. `content` names it in the message if the dataset ends.
    pub fn text(&mut self, content: &str) -> Result<&'t str> {
        match self.lines.get(self.at) {
            Some(line) => {
                self.at += 1;
                Ok(line)
            }
            None => Err(self.error(
                format!("dataset {} ends where {content} is expected", self.number),
                "export the file again; it is not complete",
            )),
        }
    }

    /// Returns several lines without trailing spaces.
    pub fn texts(&mut self, count: usize, content: &str) -> Result<Vec<String>> {
        (0..count).map(|_| Ok(self.text(content)?.trim_end().to_owned())).collect()
    }

    /// Returns the integers of a record of up to eight, of ten columns each.
    pub fn integers(&mut self, content: &str) -> Result<Vec<i64>> {
        let line = self.text(content)?;
        let parse = |field: &str| field.parse::<i64>().ok();
        self.parsed(line, 10, content, "an integer", parse)
    }

    /// Returns the first integers of a record.
    pub fn exactly<const N: usize>(&mut self, content: &str) -> Result<[i64; N]> {
        let values = self.integers(content)?;
        match values.get(..N).and_then(|first| <[i64; N]>::try_from(first).ok()) {
            Some(values) => Ok(values),
            None => Err(self.error(
                format!("{content} has {} integers instead of {N}", values.len()),
                "correct the record, or export the file again",
            )),
        }
    }

    /// Returns the numbers of a record with fields of a width.
    pub fn reals(&mut self, width: usize, content: &str) -> Result<Vec<f64>> {
        let line = self.text(content)?;
        self.parsed(line, width, content, "a number", real)
    }

    /// Returns `count` numbers of records with fields of a width.
    pub fn many_reals(&mut self, count: usize, width: usize, content: &str) -> Result<Vec<f64>> {
        let mut values = Vec::new();
        while values.len() < count {
            values.extend(self.reals(width, content)?);
        }
        self.counted(values, count, content)
    }

    /// Returns `count` integers.
    pub fn many_integers(&mut self, count: usize, content: &str) -> Result<Vec<i64>> {
        let mut values = Vec::new();
        while values.len() < count {
            values.extend(self.integers(content)?);
        }
        self.counted(values, count, content)
    }

    fn counted<T>(&self, values: Vec<T>, count: usize, content: &str) -> Result<Vec<T>> {
        if values.len() > count {
            return Err(self.error(
                format!("{content} has {} values instead of {count}", values.len()),
                "correct the number of values",
            ));
        }
        Ok(values)
    }

    /// Converts a count of a record; the file must have at least one character for each item.
    pub fn count(&self, value: i64, content: &str) -> Result<usize> {
        let left = self.left[self.at];
        usize::try_from(value).ok().filter(|count| *count <= left).ok_or_else(|| {
            self.error(
                format!("the number of {content} is {value}, but the dataset has {left} characters left"),
                "correct the number, or export the file again",
            )
        })
    }

    /// Splits a line into fields of fixed width; if these are not numbers, at spaces.
    pub fn parsed<T>(
        &self,
        line: &str,
        width: usize,
        content: &str,
        expected: &str,
        parse: impl Fn(&str) -> Option<T>,
    ) -> Result<Vec<T>> {
        let line = line.trim_end();
        let fixed = || -> Option<Vec<T>> {
            let bytes = line.as_bytes();
            let fields = bytes.chunks(width).map(|field| std::str::from_utf8(field).ok());
            fields.map(|field| parse(field?.trim())).collect()
        };
        if let Some(values) = fixed() {
            return Ok(values);
        }
        let field = |field: &str| {
            parse(field).ok_or_else(|| {
                let short: String = field.chars().take(30).collect();
                self.error(
                    format!("{content} has `{short}` where {expected} is expected"),
                    "correct the field",
                )
            })
        };
        line.split_whitespace().map(field).collect()
    }
}

/// Parses a Fortran number: the exponent may have the letter D, or only a sign.
pub(crate) fn real(text: &str) -> Option<f64> {
    if text.is_empty() {
        return None;
    }
    let plain = text.replace(['d', 'D', 'e'], "E");
    let value = plain.parse::<f64>().ok().or_else(|| {
        let at = plain.rfind(['+', '-']).filter(|at| *at > 0)?;
        format!("{}E{}", &plain[..at], &plain[at..]).parse().ok()
    })?;
    value.is_finite().then_some(value)
}

/// Appends a number in the Fortran format `E<width>.<digits>` with one digit before the point.
pub(super) fn append_real(text: &mut String, value: f64, width: usize, digits: usize, letter: char) {
    let plain = format!("{value:.digits$e}");
    let (mantissa, exponent) = plain.split_once('e').unwrap_or((&plain, "0"));
    let (sign, size) = match exponent.strip_prefix('-') {
        Some(size) => ('-', size),
        None => ('+', exponent),
    };
    // Three digits of an exponent take the place of the letter, as in Fortran.
    let number = if size.len() > 2 {
        format!("{mantissa}{sign}{size}")
    } else {
        format!("{mantissa}{letter}{sign}{size:0>2}")
    };
    let _ = write!(text, "{number:>width$}");
}
