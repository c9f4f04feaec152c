//! Files of an import: opening, locations and paths of included files.

use super::error::{ImportError, Unreadable};
use std::collections::HashMap;

/// Function that returns the content of a file, given its path.
///
/// The path of the main file is the one that was passed to the reader. The path of an included file
/// is relative to the directory of the including file, joined with that file's path; backslashes
/// are replaced by slashes. The function restricts the location, accepts regular files only, and
/// limits their size.
pub type OpenFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, Unreadable> + 'a;

/// Largest total size of all files of an import, bytes.
const LARGEST: usize = 1 << 30;
/// Largest number of files of an import.
const MOST_FILES: usize = 1000;

/// Largest number of labels that ranges and references to sets may give, for a model of this many
/// nodes and elements. Short files could otherwise state an unlimited amount of work.
pub(super) fn most_references(size: usize) -> usize {
    1_000_000 + 200 * size
}

/// Location in the files of an import.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// Index of the file.
    pub file: u32,
    /// Line, from 1.
    pub line: u32,
}

/// Files that an import has opened.
pub(super) struct Sources<'a> {
    open: &'a mut OpenFile<'a>,
    /// Names of the files, by their index.
    pub names: Vec<String>,
    bytes: usize,
}

impl<'a> Sources<'a> {
    pub fn new(open: &'a mut OpenFile<'a>) -> Self {
        Self { open, names: Vec::new(), bytes: 0 }
    }

    /// Opens a file that is included at a location, or the main file.
    pub fn bytes(&mut self, path: &str, from: Option<Place>) -> Result<(u32, Vec<u8>), ImportError> {
        let refused = |names: &[String], message: String, help: String| match from {
            Some(place) => error(names, place, message, help),
            None => ImportError { file: path.to_owned(), line: 1, message, help },
        };
        let split = "split the model, or leave out parts that are not needed";
        if self.names.len() >= MOST_FILES {
            return Err(refused(
                &self.names,
                format!("more than {MOST_FILES} files are included"),
                split.into(),
            ));
        }
        let content = (self.open)(path).map_err(|reason| {
            refused(&self.names, format!("`{path}` cannot be read: {}", reason.message), reason.help)
        })?;
        self.bytes = self.bytes.saturating_add(content.len());
        if self.bytes > LARGEST {
            let message = format!("the files of the model are larger than {} MB", LARGEST >> 20);
            return Err(refused(&self.names, message, split.into()));
        }
        self.names.push(path.to_owned());
        Ok((self.names.len() as u32 - 1, content))
    }

    /// Opens a text file. Characters that are not UTF-8 are replaced; they are valid in comments.
    pub fn text(&mut self, path: &str, from: Option<Place>) -> Result<(u32, String), ImportError> {
        let (file, content) = self.bytes(path, from)?;
        if let Some(at) = content.iter().position(|byte| *byte == 0) {
            let line = 1 + content[..at].iter().filter(|byte| **byte == b'\n').count() as u32;
            let place = Place { file, line };
            return Err(self.error(
                place,
                "the file is not text: it contains a zero byte",
                "export the model as text",
            ));
        }
        let text = match String::from_utf8(content) {
            Ok(text) => text,
            Err(error) => String::from_utf8_lossy(error.as_bytes()).into_owned(),
        };
        Ok((file, text))
    }

    pub fn error(&self, place: Place, message: impl Into<String>, help: impl Into<String>) -> ImportError {
        error(&self.names, place, message, help)
    }
}

pub(super) fn error(
    names: &[String],
    place: Place,
    message: impl Into<String>,
    help: impl Into<String>,
) -> ImportError {
    ImportError {
        file: names.get(place.file as usize).cloned().unwrap_or_default(),
        line: place.line as usize,
        message: message.into(),
        help: help.into(),
    }
}

/// Lines of a text with their numbers. Lines end with a line feed, a carriage return or both.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (u32, &str)> {
    let mut number = 0;
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest.filter(|text| !text.is_empty())?;
        number += 1;
        let end = text.find(['\n', '\r']).unwrap_or(text.len());
        let (line, tail) = text.split_at(end);
        let tail = tail.strip_prefix("\r\n").or_else(|| tail.get(1..)).unwrap_or("");
        rest = Some(tail);
        Some((number, line))
    })
}

/// Path of an included file relative to the directory of the including file.
pub(super) fn included(from: &str, path: &str) -> String {
    let path = path.replace('\\', "/");
    let absolute = path.starts_with('/') || path.chars().nth(1) == Some(':');
    match from.replace('\\', "/").rsplit_once('/') {
        Some((directory, _)) if !absolute => format!("{directory}/{path}"),
        _ => path,
    }
}

/// Path without `.` and `..`, to compare paths.
pub(super) fn plain(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            "." | "" if !parts.is_empty() => {}
            ".." if parts.last().is_some_and(|last| *last != "..") => drop(parts.pop()),
            _ => parts.push(part),
        }
    }
    parts.join("/")
}

/// Counts of skipped input, in the order of first occurrence.
#[derive(Default)]
pub(super) struct Skipped {
    order: Vec<(String, usize, Place)>,
    index: HashMap<String, usize>,
}

impl Skipped {
    pub fn add(&mut self, name: &str, place: Place) {
        match self.index.get(name) {
            Some(at) => self.order[*at].1 += 1,
            None => {
                self.index.insert(name.to_owned(), self.order.len());
                self.order.push((name.to_owned(), 1, place));
            }
        }
    }

    pub fn finish(self, files: &[String]) -> Vec<super::SkippedInput> {
        let entry = |(name, count, place): (String, usize, Place)| super::SkippedInput {
            name,
            count,
            file: files.get(place.file as usize).cloned().unwrap_or_default(),
            line: place.line as usize,
        };
        self.order.into_iter().map(entry).collect()
    }
}
