//! Helpers for the tests that cross crates.

pub mod coverage;
pub mod document;
pub mod judge;
pub mod modules;
pub mod plots;

use std::path::PathBuf;

/// The root of the workspace.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Whether snapshots are to be rewritten instead of compared: `CALYX_BLESS=1 cargo test`.
pub fn blessing() -> bool {
    std::env::var_os("CALYX_BLESS").is_some()
}
