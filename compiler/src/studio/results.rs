//! Results in the directory of a run, as JSON for the page.

use super::error::RequestError;
use super::settings;
use calyx_abi::units::{from_si, shortest};
use calyx_rt::directory::read_run;
use calyx_rt::run_directory::MARKER;
use serde_json::{Map, Value, json};
use std::collections::HashMap;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::UNIX_EPOCH;

/// Returns true if a run wrote or writes this directory.
pub(crate) fn is_run(directory: &Path) -> bool {
    directory.join("run.json").is_file() || directory.join(MARKER).is_file()
}

/// Returns a number that changes if one of the files is written, replaced, created or removed.
pub(crate) fn stamp(directory: &Path, files: &[&str]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for file in files {
        let about = fs::metadata(directory.join(file)).ok();
        about.map(|about| (about.len(), about.modified().ok())).hash(&mut hasher);
    }
    hasher.finish()
}

/// Returns the time of the directory's last result, s since 1970.
pub(crate) fn time_of(directory: &Path) -> Option<u64> {
    let file = [directory.join("run.json"), directory.join(MARKER), directory.to_owned()];
    let about = file.iter().find_map(|file| fs::metadata(file).ok())?;
    Some(about.modified().ok()?.duration_since(UNIX_EPOCH).ok()?.as_secs())
}

/// Files that change while a run is in progress.
pub(crate) const CHANGING: [&str; 3] = ["run.json", "steps.csv", "journal.jsonl"];

/// Summaries of runs, read again when their files change.
#[derive(Default)]
pub(crate) struct Summaries(Mutex<HashMap<PathBuf, (u64, Value)>>);

impl Summaries {
    /// Returns the part of `run.json` that a list shows, or of the journal of a run that ended
    /// before it wrote this file; `null` if there is neither.
    pub fn of(&self, directory: &Path) -> Value {
        let now = stamp(directory, &CHANGING);
        // Not locked while files are read: a slow disk would stop all requests.
        let known = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((then, summary)) = known().get(directory)
            && *then == now
        {
            return summary.clone();
        }
        let summary = described(directory).ok().flatten().map_or(Value::Null, |run| {
            let mut summary = summary(&run);
            if is_incomplete(&run) {
                summary["positions"] = json!(rows(directory));
            }
            let has_meshes = fs::read_dir(directory.join("vtu")).is_ok_and(|mut all| all.next().is_some());
            summary["settings"] = settings::of_run(&run, has_meshes).into();
            summary
        });
        known().insert(directory.to_owned(), (now, summary.clone()));
        summary
    }
}

fn summary(run: &Value) -> Value {
    let params = run["params"].as_object().into_iter().flatten();
    let params: Map<String, Value> = params.map(|(name, param)| (name.clone(), of_param(param))).collect();
    json!({
        "params": params,
        "positions": run["positions"],
        "fidelity": run["fidelity"],
        "calyx": run["calyx"],
        "source": run["source"]["sha256"],
        "incomplete": run["incomplete"],
        "warnings": run["warnings"].as_array().map_or(0, Vec::len),
    })
}

/// Returns a param as it is typed, in the unit of its default.
fn of_param(param: &Value) -> Value {
    let value = if param["display"].is_null() { &param["value"] } else { &param["display"]["value"] };
    json!({
        "text": typed(value),
        "unit": param["display"]["unit"].as_str().unwrap_or_default(),
        "at_default": param["at_default"],
    })
}

fn typed(value: &Value) -> String {
    match value {
        Value::Bool(truth) => (if *truth { "TRUE" } else { "FALSE" }).to_owned(),
        Value::Number(number) => shortest(number.as_f64().unwrap_or(f64::NAN)),
        Value::String(text) => text.clone(),
        Value::Array(all) => format!("[{}]", all.iter().map(typed).collect::<Vec<_>>().join(", ")),
        _ => "?".to_owned(),
    }
}

/// Longest description of a run in a journal, bytes.
const LONGEST_HEAD: u64 = 16 << 20;

/// Returns the description of a run: `run.json`, or the first line of the journal of a run that has
/// not written this file, with the key `incomplete`. `None` if there is neither.
///
/// # Errors
/// A file cannot be read.
fn described(directory: &Path) -> io::Result<Option<Value>> {
    ["run.json", "journal.jsonl"].into_iter().try_for_each(|name| check_file(&directory.join(name)))?;
    if let Some(run) = read_run(directory)? {
        return Ok(Some(run));
    }
    let file = match fs::File::open(directory.join("journal.jsonl")) {
        Ok(file) => file,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    };
    let mut line = String::new();
    BufReader::new(file.take(LONGEST_HEAD)).read_line(&mut line)?;
    // A line that a kill left incomplete describes nothing.
    let head: Value = serde_json::from_str(&line).unwrap_or(Value::Null);
    let run = head.get("run").filter(|run| run.is_object());
    Ok(run.map(|run| {
        let mut run = run.clone();
        run["incomplete"] = json!({ "code": null, "message": null });
        run
    }))
}

/// Rejects a path that exists and is no file: reading from a pipe would wait for ever.
fn check_file(path: &Path) -> io::Result<()> {
    match fs::metadata(path) {
        Ok(about) if !about.is_file() => Err(io::Error::other("it is no file")),
        _ => Ok(()),
    }
}

/// Returns true for a run that has not ended, or ended before its last position.
pub(crate) fn is_incomplete(run: &Value) -> bool {
    run.get("incomplete").is_some_and(Value::is_object)
}

/// Returns the description of a run without the gear data, which the page does not show; `null` if
/// there is none.
///
/// # Errors
/// A file cannot be read.
pub(crate) fn run(directory: &Path) -> Result<Value, RequestError> {
    let unreadable = |error| RequestError::internal("cannot read run.json", &error);
    let mut run = described(directory).map_err(unreadable)?.unwrap_or(Value::Null);
    if let Some(entries) = run.as_object_mut() {
        entries.remove("gear_data");
    }
    Ok(run)
}

/// Returns the number of complete rows of `steps.csv`.
fn rows(directory: &Path) -> usize {
    let table = text_of_steps(directory).ok().flatten().unwrap_or_default();
    table.bytes().filter(|byte| *byte == b'\n').count().saturating_sub(1)
}

/// Returns the outputs of an incomplete run at its solved positions, in the units of the model:
/// smallest, largest and last value. A mean over a part of the positions is none of the run.
///
/// # Errors
/// `steps.csv` cannot be read.
pub(crate) fn outputs_so_far(directory: &Path, run: &Value) -> Result<Value, RequestError> {
    let table = text_of_steps(directory)?.unwrap_or_default();
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(table.as_bytes());
    let names: Vec<String> =
        reader.headers().map_or_else(|_| Vec::new(), |names| names.iter().map(str::to_owned).collect());
    let mut values = vec![Vec::new(); names.len()];
    for record in reader.records().flatten() {
        for (values, cell) in values.iter_mut().zip(&record) {
            values.extend(cell.parse::<f64>().ok());
        }
    }
    let of_column = |(name, values): (String, Vec<f64>)| {
        let column = run["columns"].get(&name).filter(|column| column["choices"].is_null())?;
        let display = &column["display"];
        let shown = |si: f64| from_si(si, display["factor"].as_f64().unwrap_or(1.0));
        let last = values.last().copied().map(shown);
        let end = |select: fn(f64, f64) -> f64| values.iter().copied().reduce(select).map(shown);
        let output = json!({
            "doc": column["doc"], "unit": display["unit"], "min": end(f64::min), "max": end(f64::max), "last": last,
        });
        Some((name, output))
    };
    Ok(names.into_iter().zip(values).filter_map(of_column).collect::<Map<_, _>>().into())
}

/// Largest number of rows that the page plots.
const MOST_ROWS: usize = 20_000;

/// Columns of `steps.csv`, in SI.
pub(crate) struct Steps {
    /// Values by column, with `null` for missing ones; `null` without a table.
    pub columns: Value,
    /// Number of positions from one row to the next: 1 unless the table is long.
    pub stride: usize,
}

/// Returns the columns of `steps.csv`. A run may still be appending to the table: its last,
/// incomplete row is left out.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn steps(directory: &Path) -> Result<Steps, RequestError> {
    let Some(table) = text_of_steps(directory)? else {
        return Ok(Steps { columns: Value::Null, stride: 1 });
    };
    let rows = table.bytes().filter(|byte| *byte == b'\n').count().saturating_sub(1);
    let stride = rows.div_ceil(MOST_ROWS).max(1);
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(table.as_bytes());
    let names: Vec<String> = match reader.headers() {
        Ok(names) => names.iter().map(str::to_owned).collect(),
        Err(_) => return Ok(Steps { columns: Value::Null, stride: 1 }),
    };
    let mut columns: Vec<Vec<Value>> = vec![Vec::new(); names.len()];
    let records = reader.records().step_by(stride).flatten();
    for record in records.filter(|record| record.len() == names.len()) {
        for ((column, name), cell) in columns.iter_mut().zip(&names).zip(&record) {
            column.push(match name.as_str() {
                "point" => json!(cell),
                _ => json!(cell.parse::<f64>().ok()),
            });
        }
    }
    let columns: Map<_, _> = names.into_iter().zip(columns.into_iter().map(Value::from)).collect();
    Ok(Steps { columns: columns.into(), stride })
}

/// Returns the times of all positions, s.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn times(directory: &Path) -> Result<Vec<Option<f64>>, RequestError> {
    let table = text_of_steps(directory)?.unwrap_or_default();
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(table.as_bytes());
    let column = reader.headers().ok().and_then(|names| names.iter().position(|name| name == "time"));
    let Some(column) = column else { return Ok(Vec::new()) };
    Ok(reader.records().flatten().map(|record| record.get(column)?.parse().ok()).collect())
}

/// Returns the complete rows of `steps.csv`; `None` if there is no such table.
fn text_of_steps(directory: &Path) -> Result<Option<String>, RequestError> {
    let path = directory.join("steps.csv");
    match check_file(&path).and_then(|()| fs::read_to_string(path)) {
        Ok(mut text) => {
            text.truncate(text.rfind('\n').map_or(0, |end| end + 1));
            Ok(Some(text))
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(RequestError::internal("cannot read steps.csv", &error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_killed_run_is_described_by_its_journal_and_its_solved_positions() {
        let directory = tempfile::tempdir().expect("a temporary folder");
        let path = directory.path();
        assert!(run(path).expect("no run").is_null());
        let columns =
            json!({ "a": { "doc": "", "unit": "Pa", "display": { "unit": "MPa", "factor": 1e6 } } });
        let head = json!({ "journal": 2, "run": { "params": {}, "columns": columns, "overrides": { "contact_cells": 6 } } });
        fs::write(path.join("steps.csv"), "step,time,point,a\n0,0,SAP,2e6\n1,1,,5e6\n2,2,,3e6\n3,3,,9")
            .expect("a table");
        fs::write(path.join("journal.jsonl"), &head.to_string()[..40]).expect("a damaged journal");
        assert!(run(path).expect("no run").is_null());
        fs::write(path.join("journal.jsonl"), format!("{head}\n{{\"step\":0}}\n")).expect("a journal");
        let found = run(path).expect("a run");
        assert!(is_incomplete(&found));
        let outputs = outputs_so_far(path, &found).expect("a table");
        assert_eq!(outputs["a"], json!({ "doc": "", "unit": "MPa", "min": 2.0, "max": 5.0, "last": 3.0 }));
        let summary = Summaries::default().of(path);
        assert_eq!((&summary["positions"], &summary["settings"]["contact_cells"]), (&json!(3), &json!("6")));
    }

    /// Reading from a pipe would wait for a writer.
    #[cfg(unix)]
    #[test]
    fn pipes_in_place_of_results_are_not_read() {
        let directory = tempfile::tempdir().expect("a temporary folder");
        for name in ["run.json", "steps.csv"] {
            let made = std::process::Command::new("mkfifo").arg(directory.path().join(name)).status();
            assert!(made.expect("mkfifo").success());
        }
        assert!(run(directory.path()).is_err() && times(directory.path()).is_err());
        assert!(Summaries::default().of(directory.path()).is_null());
    }

    #[test]
    fn long_tables_are_thinned_and_incomplete_rows_left_out() {
        let directory = tempfile::tempdir().expect("a temporary folder");
        assert!(steps(directory.path()).expect("no table").columns.is_null());
        let rows = 3 * MOST_ROWS;
        let mut table = "step,time,point,a\n".to_owned();
        (0..rows).for_each(|row| table += &format!("{row},{},,{}\n", 0.5 * row as f64, 2 * row));
        table += "7,1.";
        fs::write(directory.path().join("steps.csv"), table).expect("a table");
        let thinned = steps(directory.path()).expect("a table");
        assert_eq!(thinned.stride, 3);
        let column = thinned.columns["a"].as_array().expect("a column");
        assert_eq!((column.len(), &column[1]), (MOST_ROWS, &json!(6.0)));
        let times = times(directory.path()).expect("a table");
        assert_eq!((times.len(), times[3]), (rows, Some(1.5)));
    }
}
