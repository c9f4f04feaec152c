//! Python with a package that a test needs.

use std::io::Write;
use std::path::PathBuf;
use std::process::Command;

/// Returns the Python that `.ci/programs` installed a package for, or one that has it. Without it,
/// prints that the test is skipped and returns `None`.
///
/// # Panics
/// No Python has the package, and `CALYX_CI_STRICT` is 1.
pub fn python_with(package: &str) -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?;
    let installed = program.ancestors().nth(3)?.join("python/bin/python3");
    let has_it = |program: &PathBuf| {
        let asked = Command::new(program).args(["-c", &format!("import {package}")]).output();
        asked.is_ok_and(|answer| answer.status.success())
    };
    let found = [installed, "python3".into()].into_iter().find(has_it);
    if found.is_none() {
        let why = format!("no Python has {package}; `.ci/programs` installs it");
        assert!(std::env::var_os("CALYX_CI_STRICT").is_none_or(|strict| strict != "1"), "{why}");
        // The harness captures the output macros of a passing test, but not direct writes to
        // standard error.
        let _ = std::io::stderr().write_all(format!("SKIPPED: {why}\n").as_bytes());
    }
    found
}
