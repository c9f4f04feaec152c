//! Resuming an earlier run: finds its state in the directory, and checks that model and params are
//! the same.

use crate::params::InvalidParam;
use calyx_report::directory::read_run;
use calyx_report::journal::{self, FoundJournal};
use serde_json::Value;
use std::collections::BTreeSet;
use std::io;
use std::path::Path;

/// State of an earlier run.
pub enum EarlierRun {
    Nothing,
    /// Solved positions, after which the run can resume.
    Unfinished(FoundJournal),
    /// The earlier run is complete.
    Finished,
}

/// Reason why an earlier run cannot be resumed.
pub enum ResumeError {
    /// The earlier run has another subject.
    Other(InvalidParam),
    Io(io::Error),
}

impl From<io::Error> for ResumeError {
    fn from(error: io::Error) -> ResumeError {
        ResumeError::Io(error)
    }
}

/// Searches a directory for an earlier run with the subject `head` (see
/// [`calyx_report::directory::head`]).
///
/// # Errors
/// The directory has a run of another model, of other params, or by another version of Calyx; or it
/// cannot be read.
pub fn find(directory: &Path, head: &Value) -> Result<EarlierRun, ResumeError> {
    let same = |then: &Value| match differences(then, head) {
        differences if differences.is_empty() => Ok(()),
        differences => Err(ResumeError::Other(InvalidParam::new(
            format!("the run in {} is another one: {}", directory.display(), differences.join("; ")),
            "resume with the same model and params, or start a new run without --resume",
        ))),
    };
    // The journal is removed last, so a run with a journal may have been ended while it wrote its
    // final files.
    if let Some(found) = journal::find(directory)? {
        return same(&found.head).map(|()| EarlierRun::Unfinished(found));
    }
    // Results that miss their tolerance belong to a search that was ended.
    let finished =
        |run: &Value| run.get("incomplete").is_none() && run["tolerance_search"]["satisfied"] != false;
    match read_run(directory)?.filter(finished) {
        Some(run) => same(&run).map(|()| EarlierRun::Finished),
        None => Ok(EarlierRun::Nothing),
    }
}

/// Describes the differences between the subjects of two runs.
pub fn differences(then: &Value, now: &Value) -> Vec<String> {
    let mut all = Vec::new();
    // Numbers are compared in their written form, independent of their source.
    let written = |value: &Value| value.to_string();
    if written(&then["calyx"]) != written(&now["calyx"]) {
        all.push(format!(
            "it was begun by Calyx {}, and this is {}",
            text(&then["calyx"]),
            text(&now["calyx"])
        ));
    } else if written(&then["abi"]) != written(&now["abi"]) {
        all.push("it was begun by another build of Calyx".into());
    }
    for (kind, what) in [("files", "the model"), ("tables", "the tables")] {
        let (then, now) = (list(&then["source"][kind]), list(&now["source"][kind]));
        let changed = then.iter().zip(now).filter(|(then, now)| then["sha256"] != now["sha256"]);
        all.extend(changed.map(|(_, now)| format!("{} has changed", text(&now["name"]))));
        if then.len() != now.len() {
            all.push(format!("{what} consisted of other files"));
        }
    }
    let none = serde_json::Map::new();
    let [before, after] = [then, now].map(|run| run["params"].as_object().unwrap_or(&none));
    for (name, now) in after {
        let then = &before.get(name).unwrap_or(&Value::Null);
        if written(&then["value"]) != written(&now["value"]) {
            all.push(format!("`{name}` was {} and is {} now", shown(then), shown(now)));
        }
    }
    let overridden = |run: &Value| run["overrides"].as_object().cloned().unwrap_or_default();
    let (then, now) = (overridden(then), overridden(now));
    let names: BTreeSet<&String> = then.keys().chain(now.keys()).collect();
    for name in names {
        let [then, now] = [&then, &now].map(|overridden| {
            overridden.get(name).map_or_else(|| "the model's own".to_owned(), Value::to_string)
        });
        if then != now {
            all.push(format!("`{name}` of the analysis was {then} and is {now} now"));
        }
    }
    all
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or("?")
}

/// Formats a param of `run.json` in its own unit.
fn shown(param: &Value) -> String {
    let value = if param["display"].is_null() { &param["value"] } else { &param["display"]["value"] };
    let number = match value {
        Value::Bool(truth) => (if *truth { "TRUE" } else { "FALSE" }).into(),
        Value::Null => "nothing".into(),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), |n| n.to_string()),
        other => other.to_string(),
    };
    format!("{number} {}", param["display"]["unit"].as_str().unwrap_or_default()).trim_end().to_owned()
}
