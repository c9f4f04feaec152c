//! Journal of a sweep: a line of JSON with the model, then one line per solved case.
//!
//! A case is known by the values of all params, so a sweep with more values solves only the new
//! cases. A case is solved again if a table that it has read has changed.

use super::Solved;
use calyx_report::sweep::{Column, Row};
use calyx_runtime::cache::Key;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// File name of the journal.
pub const JOURNAL: &str = "cases.jsonl";
/// Format of the journal. A journal of another format is replaced, and its cases are solved again.
/// Format 2 has the loads of meshes and bearings, printed lines, and outputs that are powers.
pub const FORMAT: u32 = 2;

/// Journal that several threads write.
pub struct Journal(Mutex<File>);

/// Line of a case.
#[derive(Serialize, Deserialize)]
pub struct Line {
    /// Values of all params, SI.
    pub params: Value,
    /// Fidelity level, if it is an axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fidelity: Option<String>,
    /// Content of each table that the case has read, by name.
    pub tables: BTreeMap<String, String>,
    pub row: Row,
    /// Columns of the outputs.
    pub columns: Vec<Column>,
}

impl Line {
    /// Returns the text by which the case is known.
    pub fn key(&self) -> String {
        key(&self.params, self.fidelity.as_deref())
    }

    /// Returns the line as that of a case with another number.
    pub fn of_case(self, case: usize) -> Line {
        Line { row: Row { case, ..self.row }, ..self }
    }

    /// Returns the row, with the columns of its outputs.
    pub fn solved(self) -> Solved {
        (self.row, self.columns)
    }
}

/// Returns the text by which a case with these params is known.
pub fn key(params: &Value, fidelity: Option<&str>) -> String {
    match fidelity {
        None => params.to_string(),
        Some(fidelity) => format!("{params} {fidelity}"),
    }
}

/// Returns a hash of the content of a table; empty if it cannot be read.
pub fn fingerprint(directory: Option<&Path>, table: &str) -> String {
    let path = directory.map_or_else(|| table.into(), |directory| directory.join(table));
    let Ok(content) = fs::read(path) else { return String::new() };
    let key = Key::of("table of a sweep").text(&String::from_utf8_lossy(&content)).finish();
    key.bytes().iter().map(|byte| format!("{byte:02x}")).collect()
}

impl Journal {
    /// Opens the journal at a path and returns its lines. A journal of another `subject`, or
    /// version, is replaced. An incomplete last line, of a process that was killed, is ignored.
    ///
    /// # Errors
    /// The file cannot be read or written.
    pub fn open<L: DeserializeOwned>(path: &Path, subject: &Value) -> io::Result<(Journal, Vec<L>)> {
        let text = match fs::read(path) {
            Ok(text) => text,
            Err(error) if error.kind() == ErrorKind::NotFound => Vec::new(),
            Err(error) => return Err(error),
        };
        let mut complete = text.split_inclusive(|byte| *byte == b'\n').filter(|line| line.ends_with(b"\n"));
        let is_same = |line: &[u8]| serde_json::from_slice::<Value>(line).is_ok_and(|head| head == *subject);
        let (mut cases, mut kept) = (Vec::new(), 0);
        if let Some(first) = complete.next().filter(|line| is_same(line)) {
            kept = first.len();
            for line in complete {
                let Ok(case) = serde_json::from_slice(line) else { break };
                kept += line.len();
                cases.push(case);
            }
        }
        let mut file = OpenOptions::new().create(true).append(true).open(path)?;
        file.set_len(kept as u64)?;
        if kept == 0 {
            writeln!(file, "{subject}")?;
        }
        Ok((Journal(Mutex::new(file)), cases))
    }

    /// Returns the number of lines that [`Journal::open`] would replace, because they belong to
    /// another subject.
    pub fn replaced(path: &Path, subject: &Value) -> usize {
        let Ok(text) = fs::read(path) else { return 0 };
        let mut complete = text.split_inclusive(|byte| *byte == b'\n').filter(|line| line.ends_with(b"\n"));
        let head = complete.next().map(serde_json::from_slice::<Value>);
        match head {
            Some(Ok(head)) if head == *subject => 0,
            _ => complete.count(),
        }
    }

    /// Writes a solved case.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, line: &impl Serialize) -> io::Result<()> {
        let mut text = serde_json::to_string(line)?;
        text.push('\n');
        let mut file = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(text.as_bytes())
    }
}
