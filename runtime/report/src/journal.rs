//! Journal of a running analysis: the data from which a run resumes, one line of JSON per position,
//! each on disk before the next position starts.
//!
//! The table of positions has less: it lacks locations of maxima, warnings and certificates. The
//! first line, the head, describes the subject of the run. A line that a kill left incomplete is
//! dropped, and so is everything after a line that cannot be read: those positions are solved
//! again, to the same bits. A finished run has no journal.

use crate::former_keys::{self, ResultFile};
use calyx_runtime::analysis::Position;
use calyx_runtime::contact::problem::Certificate;
use calyx_runtime::results::{Location, Observed, Solved, StepRow};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Value, json};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Version of the line format; a journal of another format is not read.
const FORMAT: u64 = 2;

pub fn path(directory: &Path) -> PathBuf {
    directory.join("journal.jsonl")
}

/// Contents of a journal.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundJournal {
    /// Subject of the run, with current names of keys.
    pub head: Value,
    /// Completed positions, from the first one on.
    pub solved: Vec<Solved>,
    /// Length of the readable part, bytes.
    bytes: u64,
}

/// Reads the journal in a directory; `None` if there is none, or one with an incomplete head.
///
/// # Errors
/// The journal exists and cannot be read.
pub fn find(directory: &Path) -> io::Result<Option<FoundJournal>> {
    let text = match fs::read(path(directory)) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    };
    let mut lines = text.split_inclusive(|&byte| byte == b'\n').filter(|line| line.ends_with(b"\n"));
    let first = lines.next().and_then(|line| Some((line.len(), serde_json::from_slice::<Value>(line).ok()?)));
    let Some((bytes, first)) = first.filter(|(_, first)| first["journal"] == FORMAT) else { return Ok(None) };
    let head = former_keys::current(ResultFile::Run, first["run"].clone());
    let mut found = FoundJournal { head, solved: Vec::new(), bytes: bytes as u64 };
    for line in lines {
        let entry = serde_json::from_slice::<JournalEntry>(line).ok();
        let Some(entry) = entry.filter(|entry| entry.step == found.solved.len()) else { break };
        found.solved.push(entry.solved());
        found.bytes += line.len() as u64;
    }
    Ok(Some(found))
}

/// Writer of a journal.
pub struct Journal {
    file: File,
    written: usize,
}

impl Journal {
    /// Creates a journal with the subject of the run.
    ///
    /// # Errors
    /// The journal cannot be written.
    pub fn create(directory: &Path, head: &Value) -> io::Result<Journal> {
        let mut file = File::create(path(directory))?;
        write_line(&mut file, &json!({ "journal": FORMAT, "run": head }))?;
        Ok(Journal { file, written: 0 })
    }

    /// Continues after the readable part of a journal.
    ///
    /// # Errors
    /// The journal cannot be written.
    pub fn resume(directory: &Path, found: &FoundJournal) -> io::Result<Journal> {
        let file = OpenOptions::new().append(true).open(path(directory))?;
        file.set_len(found.bytes)?;
        Ok(Journal { file, written: found.solved.len() })
    }

    /// Appends the next position.
    ///
    /// # Errors
    /// The journal cannot be written.
    pub fn write(&mut self, solved: &Solved) -> io::Result<()> {
        write_line(&mut self.file, &JournalEntry::of(self.written, solved))?;
        self.written += 1;
        Ok(())
    }
}

/// Writes a line with its line break by a single call.
fn write_line(file: &mut File, line: &impl Serialize) -> io::Result<()> {
    let mut text = serde_json::to_vec(line)?;
    text.push(b'\n');
    file.write_all(&text)
}

/// Removes the journal of a finished run, or of one that is not resumed.
///
/// # Errors
/// The journal exists and cannot be removed.
pub fn remove(directory: &Path) -> io::Result<()> {
    match fs::remove_file(path(directory)) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// Line of a position.
#[derive(Serialize, Deserialize)]
struct JournalEntry {
    step: usize,
    time: ExactNumber,
    cycle: ExactNumber,
    roll: ExactNumber,
    point: String,
    /// Value, minimum and location of each output.
    outputs: Vec<(ExactNumber, Option<ExactNumber>, Option<LocationRecord>)>,
    warnings: Vec<String>,
    /// Complementarity, penetration, tension, equilibrium.
    certificate: [ExactNumber; 4],
    /// State of a time step.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    state: Vec<ExactNumber>,
}

/// Location on a body.
#[derive(Serialize, Deserialize)]
struct LocationRecord {
    body: String,
    tooth: u32,
    roll_angle: Option<ExactNumber>,
    radius: ExactNumber,
    axial: Option<ExactNumber>,
}

impl JournalEntry {
    fn of(step: usize, solved: &Solved) -> JournalEntry {
        let Solved { row: StepRow { position, outputs, warnings }, certificate, state } = solved;
        let at = |place: &Location| LocationRecord {
            body: place.body.clone(),
            tooth: place.tooth,
            roll_angle: place.roll_angle.map(ExactNumber),
            radius: ExactNumber(place.radius),
            axial: place.axial.map(ExactNumber),
        };
        let Certificate { complementarity, penetration, tension, equilibrium } = *certificate;
        JournalEntry {
            step,
            time: ExactNumber(position.time),
            cycle: ExactNumber(position.cycle),
            roll: ExactNumber(position.roll),
            point: position.name.to_string(),
            outputs: outputs
                .iter()
                .map(|output| {
                    (
                        ExactNumber(output.value),
                        output.least.map(ExactNumber),
                        output.location.as_ref().map(at),
                    )
                })
                .collect(),
            warnings: warnings.clone(),
            certificate: [complementarity, penetration, tension, equilibrium].map(ExactNumber),
            state: state.iter().copied().map(ExactNumber).collect(),
        }
    }

    fn solved(self) -> Solved {
        let place = |at: LocationRecord| Location {
            body: at.body,
            tooth: at.tooth,
            roll_angle: at.roll_angle.map(|ExactNumber(angle)| angle),
            radius: at.radius.0,
            axial: at.axial.map(|ExactNumber(axial)| axial),
        };
        let outputs = self.outputs.into_iter();
        let outputs = outputs.map(|(ExactNumber(value), least, at)| Observed {
            value,
            least: least.map(|ExactNumber(least)| least),
            location: at.map(place),
        });
        let [complementarity, penetration, tension, equilibrium] =
            self.certificate.map(|ExactNumber(number)| number);
        let position =
            Position { time: self.time.0, cycle: self.cycle.0, roll: self.roll.0, name: self.point.into() };
        Solved {
            row: StepRow { position, outputs: outputs.collect(), warnings: self.warnings },
            certificate: Certificate { complementarity, penetration, tension, equilibrium },
            state: self.state.into_iter().map(|ExactNumber(number)| number).collect(),
        }
    }
}

/// Number that parses to the same bits. JSON has no infinity, so a number that is not finite is a
/// text.
#[derive(Clone, Copy, Debug)]
pub struct ExactNumber(pub f64);

impl Serialize for ExactNumber {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0.is_finite() {
            true => serializer.serialize_f64(self.0),
            false => serializer.collect_str(&self.0),
        }
    }
}

impl<'de> Deserialize<'de> for ExactNumber {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Written {
            Finite(f64),
            Other(String),
        }
        match Written::deserialize(deserializer)? {
            Written::Finite(number) => Ok(ExactNumber(number)),
            Written::Other(text) => text.parse().map(ExactNumber).map_err(serde::de::Error::custom),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(time: f64) -> Solved {
        let place = Location {
            body: "pinion".into(),
            tooth: 3,
            roll_angle: None,
            radius: 0.1 + 0.2,
            axial: Some(-1e-3),
        };
        let outputs = vec![
            Observed { value: 1.0 / 3.0, least: Some(-0.1), location: Some(place) },
            Observed::number(f64::INFINITY),
            Observed::number(-0.0),
        ];
        let position = Position { time, cycle: 5e-324, roll: 2.0_f64.sqrt(), name: "lowest".into() };
        let certificate =
            Certificate { complementarity: 1e-17, penetration: 0.0, tension: 3e300, equilibrium: 7.1e-15 };
        let warnings = vec!["a \"quoted\"\nline".into()];
        let state = vec![0.1, -3e-300];
        Solved { row: StepRow { position, outputs, warnings }, certificate, state }
    }

    #[test]
    fn what_is_written_reads_back_to_the_bit_wherever_it_was_cut_off() {
        let directory = tempfile::tempdir().unwrap();
        let directory = directory.path();
        assert_eq!(find(directory).unwrap(), None);
        let head = json!({ "params": { "torque": 0.1 } });
        let mut journal = Journal::create(directory, &head).unwrap();
        let all = [0.1, 0.2, 0.3].map(solved);
        all.iter().for_each(|solved| journal.write(solved).unwrap());
        let text = fs::read(path(directory)).unwrap();
        let ends: Vec<usize> =
            text.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(at, _)| at + 1).collect();
        for length in 0..=text.len() {
            fs::write(path(directory), &text[..length]).unwrap();
            let whole = ends.iter().filter(|end| **end <= length).count();
            let Some(found) = find(directory).unwrap() else {
                assert_eq!(whole, 0, "cut off after {length} bytes");
                continue;
            };
            assert_eq!((&found.head, &found.solved[..]), (&head, &all[..whole - 1]));
            assert!(found.solved.iter().all(|solved| solved.row.outputs[2].value.is_sign_negative()));
            // A resumed run leaves the journal that an uninterrupted run writes.
            let mut journal = Journal::resume(directory, &found).unwrap();
            all[whole - 1..].iter().for_each(|solved| journal.write(solved).unwrap());
            assert!(fs::read(path(directory)).unwrap() == text, "cut off after {length} bytes");
        }
    }

    #[test]
    fn what_cannot_be_read_ends_the_journal() {
        let directory = tempfile::tempdir().unwrap();
        let directory = directory.path();
        let mut journal = Journal::create(directory, &json!({})).unwrap();
        [0.1, 0.2, 0.3].iter().for_each(|&time| journal.write(&solved(time)).unwrap());
        let text = fs::read_to_string(path(directory)).unwrap();
        for (damage, count) in [
            (text.replacen("\"step\":1", "\"step\":7", 1), Some(1)),
            (text.replacen("\"step\":2", "\"step\":\0", 1), Some(2)),
            (text.replacen("\"journal\":2", "\"journal\":1", 1), None),
            (text.replacen('{', "", 1), None),
        ] {
            fs::write(path(directory), damage).unwrap();
            assert_eq!(find(directory).unwrap().map(|found| found.solved.len()), count);
        }
        remove(directory).unwrap();
        remove(directory).unwrap();
    }
}
