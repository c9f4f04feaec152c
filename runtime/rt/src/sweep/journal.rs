//! Journal of a sweep: a line of JSON with what is solved, then one line per finished case.

use super::Solved;
use calyx_report::sweep::{Column, Row};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::fs::{File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// File name of the journal.
pub const JOURNAL: &str = "cases.jsonl";

/// Journal that several threads write.
pub struct Journal(Mutex<File>);

/// Line of a case.
#[derive(Serialize, Deserialize)]
struct Line {
    row: Row,
    /// Name, unit and its value in SI, by output.
    columns: Vec<(String, String, f64)>,
}

impl Journal {
    /// Opens the journal in a directory and returns its cases. A journal of another `subject` is
    /// replaced. An incomplete last line, of a sweep that was killed, is ignored.
    ///
    /// # Errors
    /// The file cannot be read or written.
    pub fn open(directory: &Path, subject: &Value) -> io::Result<(Journal, Vec<Solved>)> {
        let path = directory.join(JOURNAL);
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == ErrorKind::NotFound => String::new(),
            Err(error) => return Err(error),
        };
        let mut complete = text.split_inclusive('\n').filter(|line| line.ends_with('\n'));
        let is_same = |line: &str| serde_json::from_str::<Value>(line).is_ok_and(|head| head == *subject);
        let mut cases = Vec::new();
        let mut kept = 0;
        if let Some(first) = complete.next().filter(|line| is_same(line)) {
            kept = first.len();
            for line in complete {
                let Ok(Line { row, columns }) = serde_json::from_str(line) else { break };
                kept += line.len();
                let column = |(name, unit, factor)| Column { name, unit, factor };
                cases.push((row, columns.into_iter().map(column).collect()));
            }
        }
        let mut file = OpenOptions::new().create(true).append(true).open(&path)?;
        file.set_len(kept as u64)?;
        if kept == 0 {
            writeln!(file, "{subject}")?;
        }
        Ok((Journal(Mutex::new(file)), cases))
    }

    /// Writes a finished case.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, (row, columns): &Solved) -> io::Result<()> {
        let columns = columns.iter().map(|column| (column.name.clone(), column.unit.clone(), column.factor));
        let line = Line { row: row.clone(), columns: columns.collect() };
        let mut text = serde_json::to_string(&line)?;
        text.push('\n');
        let mut file = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(text.as_bytes())
    }
}
