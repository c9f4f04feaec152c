//! Helpers of the tests that involve several crates.

pub mod coverage;
pub mod document;
pub mod judge;
pub mod modules;
pub mod plots;
pub mod printed;
pub mod python;
pub mod scenes;

use std::path::PathBuf;

/// Returns the root of the workspace.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Returns true if snapshots are rewritten instead of compared: `CALYX_BLESS=1 cargo test`.
pub fn blessing() -> bool {
    std::env::var_os("CALYX_BLESS").is_some()
}
