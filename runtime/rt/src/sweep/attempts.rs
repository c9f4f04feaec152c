//! Journals of the workers of a plan: a file per attempt to solve the cases of an index.
//!
//! An attempt creates its file exclusively, so no two workers write to one file, on any file system
//! and without locks. The next attempt reads the files of all earlier ones and solves the cases
//! that are left. Each file begins with the subject of the plan; each following line is a case.

use super::journal::Line;
use calyx_report::directory::text_hash;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Folder of the journals in the directory of a plan.
pub const RESULTS: &str = "results";
/// Extension of the journals.
const EXTENSION: &str = "jsonl";

/// Cases that the workers of a plan have finished.
#[derive(Default)]
pub struct Found {
    /// Lines of the solved cases by number.
    pub solved: BTreeMap<usize, Line>,
    /// Lines of the failed cases by number; of several attempts the last one.
    pub failed: BTreeMap<usize, Line>,
    /// Files and lines that are ignored, with the reason.
    pub ignored: Vec<String>,
}

/// Returns the index and the number of the attempt of a journal.
fn named(name: &str) -> Option<(usize, usize)> {
    let mut parts = name.strip_suffix(EXTENSION)?.strip_suffix('.')?.splitn(2, '.');
    Some((parts.next()?.parse().ok()?, parts.next()?.parse().ok()?))
}

/// Returns the journals of a plan in order of index and attempt.
fn journals(directory: &Path) -> io::Result<Vec<((usize, usize), PathBuf)>> {
    let entries = match fs::read_dir(directory.join(RESULTS)) {
        Ok(entries) => entries,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(error),
    };
    let mut all = Vec::new();
    for entry in entries {
        let entry = entry?;
        if let Some(number) = entry.file_name().to_str().and_then(named) {
            all.push((number, entry.path()));
        }
    }
    all.sort();
    Ok(all)
}

/// Reads the cases that the workers have finished, of one index or of all. `subject` is the first
/// line of each journal and `count` the number of all cases.
///
/// # Errors
/// The folder or a journal cannot be read. A journal of another plan, and damaged lines, are
/// ignored and reported.
pub fn read(directory: &Path, subject: &Value, count: usize, index: Option<usize>) -> io::Result<Found> {
    let mut found = Found::default();
    for ((of, _), path) in journals(directory)? {
        if index.is_none_or(|index| index == of) {
            found.add(&path, &fs::read(&path)?, subject, count);
        }
    }
    Ok(found)
}

impl Found {
    fn add(&mut self, path: &Path, text: &[u8], subject: &Value, count: usize) {
        // A worker that was killed leaves an incomplete last line.
        let complete = text.split_inclusive(|byte| *byte == b'\n').filter(|line| line.ends_with(b"\n"));
        let mut lines = (1..).zip(complete);
        let Some((_, head)) = lines.next() else { return };
        if serde_json::from_slice::<Value>(head).ok().as_ref() != Some(subject) {
            self.ignored
                .push(format!("{} is not a journal of this plan, and its cases are ignored", path.display()));
            return;
        }
        for (number, line) in lines {
            match checked(line).filter(|line| (1..=count).contains(&line.row.case)) {
                Some(line) if line.row.failure.is_none() => {
                    self.solved.entry(line.row.case).or_insert(line);
                }
                Some(line) => {
                    self.failed.insert(line.row.case, line);
                }
                None => self
                    .ignored
                    .push(format!("line {number} of {} is damaged, and its case is ignored", path.display())),
            }
        }
    }
}

/// Number of digits of a checksum: accidental damage of a line is detected with a probability of
/// 1 - 2^-64.
const DIGITS: usize = 16;

/// Returns a line with its checksum in front.
fn with_checksum(text: &str) -> String {
    format!("{} {text}\n", &text_hash(text)[..DIGITS])
}

/// Returns the case of a line whose checksum agrees.
fn checked(line: &[u8]) -> Option<Line> {
    let (checksum, text) = std::str::from_utf8(line).ok()?.strip_suffix('\n')?.split_at_checked(DIGITS)?;
    let text = text.strip_prefix(' ')?;
    (text_hash(text)[..DIGITS] == *checksum).then_some(())?;
    serde_json::from_str(text).ok()
}

/// Returns the number of lines of cases in all journals: an upper bound of the number of finished
/// cases, which a failed case exceeds when it is tried again.
///
/// # Errors
/// The folder cannot be read.
pub fn lines(directory: &Path) -> io::Result<usize> {
    let count = |path: &Path| match fs::read(path) {
        Ok(text) => text.iter().filter(|byte| **byte == b'\n').count().saturating_sub(1),
        Err(_) => 0,
    };
    Ok(journals(directory)?.iter().map(|(_, path)| count(path)).sum())
}

/// Journal of an attempt. The file is created with the first case.
pub struct Attempt<'a> {
    directory: &'a Path,
    index: usize,
    subject: &'a Value,
    file: Mutex<Option<File>>,
}

impl<'a> Attempt<'a> {
    pub fn new(directory: &'a Path, index: usize, subject: &'a Value) -> Attempt<'a> {
        Attempt { directory, index, subject, file: Mutex::default() }
    }

    /// Writes a finished case.
    ///
    /// # Errors
    /// The file cannot be created or written.
    pub fn write(&self, line: &Line) -> io::Result<()> {
        let text = with_checksum(&serde_json::to_string(line)?);
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let file = match &mut *file {
            Some(file) => file,
            none => none.insert(self.create()?),
        };
        file.write_all(text.as_bytes())
    }

    /// Creates the file of the first free attempt. Exclusive creation is atomic, on network file
    /// systems as well.
    fn create(&self) -> io::Result<File> {
        let folder = self.directory.join(RESULTS);
        fs::create_dir_all(&folder)?;
        for attempt in 1.. {
            let path = folder.join(format!("{:04}.{attempt}.{EXTENSION}", self.index));
            match File::options().append(true).create_new(true).open(path) {
                Ok(mut file) => {
                    file.write_all(format!("{}\n", self.subject).as_bytes())?;
                    return Ok(file);
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(ErrorKind::AlreadyExists.into())
    }

    /// Completes the file on the disk.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn finish(self) -> io::Result<()> {
        let file = self.file.into_inner().unwrap_or_else(PoisonError::into_inner);
        file.map_or(Ok(()), |file| file.sync_all())
    }
}
