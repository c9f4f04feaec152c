//! Files of the tests, in memory and below `tests/data`.

use calyx_elastic::import::Unreadable;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Path of a file below `tests/data`.
pub fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

/// Content of a file below `tests/data`.
pub fn read(name: &str) -> Vec<u8> {
    std::fs::read(data(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Function that opens files below `tests/data`.
pub fn open_data(path: &str) -> Result<Vec<u8>, Unreadable> {
    std::fs::read(data(path)).map_err(|error| Unreadable::new(error.to_string(), "check the path"))
}

/// Files in memory.
pub type Files = BTreeMap<String, Vec<u8>>;

/// Function that opens files in memory.
pub fn open_in(files: &Files) -> impl FnMut(&str) -> Result<Vec<u8>, Unreadable> + '_ {
    |path| files.get(path).cloned().ok_or_else(|| Unreadable::new("there is no such file", "add the file"))
}
