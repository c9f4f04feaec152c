//! Reads the final files of a run for byte-wise comparison.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// File that marks a run directory.
const MARKER: &str = ".calyx-run";

/// Returns every file of a run directory by its relative path, except data that depends on
/// computing times: `timing.json`, and its section in the report.
///
/// # Panics
/// If the run is not finished: `run.json` or one of those files is missing, or temporary files
/// exist.
pub fn results(directory: &Path) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    read(directory, "", &mut all);
    assert!(all.contains_key("run.json") && all.remove("timing.json").is_some(), "{:?}", all.keys());
    let left = |name: &&String| *name == "journal.jsonl" || name.ends_with(".part");
    assert_eq!(all.keys().find(left), None, "of a run under way");
    let report = all.get_mut("report.html").expect("a report");
    if let Some((before, rest)) = report.split_once("<section id=\"time\">") {
        let (_, after) = rest.split_once("</section>").expect("its end");
        *report = format!("{before}{after}");
    }
    all
}

fn read(directory: &Path, below: &str, all: &mut BTreeMap<String, String>) {
    for entry in fs::read_dir(directory).expect("a directory") {
        let path = entry.expect("an entry").path();
        let name = format!("{below}{}", path.file_name().unwrap_or_default().to_string_lossy());
        // The marker contains process id and time.
        if name == MARKER {
            continue;
        }
        match path.is_dir() {
            true => read(&path, &format!("{name}/"), all),
            false => {
                // Pictures are not text.
                let content = fs::read(&path).expect("a file");
                let text =
                    String::from_utf8(content).unwrap_or_else(|other| format!("{:?}", other.as_bytes()));
                all.insert(name, text);
            }
        }
    }
}
