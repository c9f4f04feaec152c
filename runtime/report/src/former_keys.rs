//! Former names of keys and columns in result files.
//!
//! Files are written with the current and the former name of a key until version 0.2, so that
//! programs that read them have time to change. Readers in this project use current names only:
//! [`current`] brings a document of any version to them.

use calyx_runtime::settings_override::FORMER_NAMES;
use serde_json::{Map, Value};

/// A JSON file of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultFile {
    /// `run.json`, and the head of a journal.
    Run,
    /// `timing.json`.
    Timing,
    /// `tradeoff.json`.
    Tradeoff,
}

use ResultFile::{Run, Timing, Tradeoff};

impl ResultFile {
    /// Returns the name of the file.
    pub fn name(self) -> &'static str {
        match self {
            Run => "run.json",
            Timing => "timing.json",
            Tradeoff => "tradeoff.json",
        }
    }
}

/// A key that was renamed.
struct RenamedKey {
    file: ResultFile,
    /// Path of the objects with the key, from the top of the document, in current names. `*` stands
    /// for all members of an object or all elements of an array.
    path: &'static [&'static str],
    name: &'static str,
    former: &'static str,
}

const fn renamed(
    file: ResultFile,
    path: &'static [&'static str],
    name: &'static str,
    former: &'static str,
) -> RenamedKey {
    RenamedKey { file, path, name, former }
}

/// All renamed keys, those of inner objects before those of the objects around them. Keys that are
/// names of analysis settings are in [`SETTINGS`].
const RENAMED: [RenamedKey; 14] = [
    renamed(Run, &["tolerance_search", "setting"], "contact_cells", "cells"),
    renamed(Run, &["tolerance_search", "attempts", "*", "setting"], "contact_cells", "cells"),
    renamed(Run, &["tolerance_search"], "attempts", "tried"),
    renamed(Run, &["tolerance_search"], "satisfied", "met"),
    renamed(Run, &[], "tolerance_search", "chosen"),
    renamed(Run, &["outputs", "*", "max_at"], "location", "place"),
    renamed(Run, &["signals", "*"], "output", "of"),
    renamed(Run, &["signals", "*"], "plot", "picture"),
    renamed(Timing, &["memory"], "requested", "asked"),
    renamed(Tradeoff, &["settings", "*"], "overrides", "knobs"),
    renamed(Tradeoff, &["settings", "*"], "fidelity", "level"),
    renamed(Tradeoff, &["settings", "*"], "includes_mesh_error", "mesh_seen"),
    renamed(Tradeoff, &["settings", "*", "memory"], "requested", "asked"),
    renamed(Tradeoff, &[], "omitted", "left_out"),
];

/// Objects whose keys are names of analysis settings, with the former names of
/// [`FORMER_NAMES`].
const SETTINGS: [(ResultFile, &[&str]); 2] =
    [(Run, &["overrides"]), (Tradeoff, &["settings", "*", "overrides"])];

/// Columns of `tradeoff.csv` that repeat another column under its former name.
pub const TRADEOFF_COLUMNS: [(&str, &str); 6] = [
    ("fidelity", "level"),
    ("includes_mesh_error", "mesh_seen"),
    FORMER_NAMES[0],
    FORMER_NAMES[1],
    FORMER_NAMES[2],
    FORMER_NAMES[3],
];

/// Returns the renamed keys of a file as path, name and former name, inner objects first.
fn keys(file: ResultFile) -> Vec<(&'static [&'static str], &'static str, &'static str)> {
    let settings = SETTINGS.into_iter().filter(|(of, _)| *of == file);
    let settings = settings.flat_map(|(_, path)| FORMER_NAMES.map(|(name, former)| (path, name, former)));
    let keys = RENAMED.iter().filter(|key| key.file == file);
    settings.chain(keys.map(|key| (key.path, key.name, key.former))).collect()
}

/// Adds the former name of each renamed key with the same value.
pub fn with_former(file: ResultFile, mut document: Value) -> Value {
    for (path, name, former) in keys(file) {
        at(&mut document, path, &mut |object| {
            if let Some(value) = object.get(name).cloned() {
                object.insert(former.into(), value);
            }
        });
    }
    document
}

/// Renames former keys, as in files of earlier versions, and removes those that repeat a current
/// key.
pub fn current(file: ResultFile, mut document: Value) -> Value {
    for (path, name, former) in keys(file).into_iter().rev() {
        at(&mut document, path, &mut |object| {
            if let Some(value) = object.remove(former) {
                object.entry(name).or_insert(value);
            }
        });
    }
    document
}

/// Applies a change to all objects at a path.
fn at(document: &mut Value, path: &[&str], change: &mut dyn FnMut(&mut Map<String, Value>)) {
    match (path, document) {
        ([], Value::Object(object)) => change(object),
        (["*", rest @ ..], Value::Object(object)) => {
            object.values_mut().for_each(|value| at(value, rest, change));
        }
        (["*", rest @ ..], Value::Array(values)) => {
            values.iter_mut().for_each(|value| at(value, rest, change));
        }
        ([key, rest @ ..], Value::Object(object)) => {
            if let Some(value) = object.get_mut(*key) {
                at(value, rest, change);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// A document with the current keys of `run.json`. Names of outputs and params equal former
    /// keys, which must not matter.
    fn run() -> Value {
        json!({
            "params": { "chosen": { "value": 1 }, "place": { "value": 2 } },
            "overrides": { "contact_cells": 6, "fidelity": "plane" },
            "outputs": {
                "place": { "max": 1.0, "max_at": { "location": { "tooth": 3 } } },
                "tried": { "max": 2.0, "max_at": { "location": null } },
            },
            "signals": [{ "output": "place", "plot": "signals/place_spectrum.svg" }],
            "tolerance_search": {
                "satisfied": true,
                "setting": { "contact_cells": 2 },
                "attempts": [{ "setting": { "contact_cells": 1 } }],
            },
        })
    }

    #[test]
    fn both_names_have_the_same_value() {
        let both = with_former(Run, run());
        assert_eq!(both["chosen"]["tried"], both["tolerance_search"]["attempts"]);
        assert_eq!(both["chosen"]["tried"][0]["setting"]["cells"], 1);
        assert_eq!(both["chosen"]["met"], true);
        assert_eq!(both["outputs"]["place"]["max_at"]["place"]["tooth"], 3);
        assert_eq!(both["signals"][0]["picture"], both["signals"][0]["plot"]);
        assert_eq!(both["overrides"], json!({ "contact_cells": 6, "cells": 6, "fidelity": "plane" }));
        // Names that the user chose are not keys of the format.
        assert_eq!(both["params"], run()["params"]);
        assert_eq!(both["outputs"].as_object().unwrap().len(), 2);
        assert_eq!(with_former(Timing, json!({ "memory": { "requested": 8 } }))["memory"]["asked"], 8);
    }

    #[test]
    fn readers_find_current_names_in_files_of_any_version() {
        assert_eq!(current(Run, with_former(Run, run())), run());
        let earlier = json!({
            "params": { "chosen": { "value": 1 }, "place": { "value": 2 } },
            "overrides": { "cells": 6, "fidelity": "plane" },
            "outputs": {
                "place": { "max": 1.0, "max_at": { "place": { "tooth": 3 } } },
                "tried": { "max": 2.0, "max_at": { "place": null } },
            },
            "signals": [{ "of": "place", "picture": "signals/place_spectrum.svg" }],
            "chosen": { "met": true, "setting": { "cells": 2 }, "tried": [{ "setting": { "cells": 1 } }] },
        });
        assert_eq!(current(Run, earlier), run());
        for other in [json!([]), json!(3), json!({ "outputs": [1], "signals": {}, "overrides": null })] {
            assert_eq!(current(Run, other.clone()), other);
        }
    }

    #[test]
    fn the_reference_lists_every_pair() {
        let page = include_str!("../../../docs/cli.md");
        let columns = TRADEOFF_COLUMNS.map(|(name, former)| (Tradeoff, name, former));
        let keys = [Run, Timing, Tradeoff]
            .into_iter()
            .flat_map(|file| keys(file).into_iter().map(move |(_, name, former)| (file, name, former)));
        for (file, name, former) in keys.chain(columns) {
            let listed =
                |line: &str| line.contains(&format!("`{name}`")) && line.contains(&format!("`{former}`"));
            assert!(page.lines().any(listed), "{file:?}: {name}, {former}");
        }
    }
}
