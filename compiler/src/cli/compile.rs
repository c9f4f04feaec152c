//! Checking and compiling for `run` and `build`, with output of diagnostics.

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::directory::StageTimes;
use calyx::{Checked, Engine, Module};
use calyx_lang::diagnostic::Severity;
use std::io;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// Compiles the result of `check`, after printing its diagnostics (only errors if `quiet`). Returns
/// the module and the durations of both steps. `Err` is the exit status if the model has errors of
/// the language.
pub fn compile(
    file: &Path,
    quiet: bool,
    format: MessageFormat,
    check: impl FnOnce() -> io::Result<Checked>,
) -> Result<(Module, StageTimes), ExitCode> {
    let started = Instant::now();
    let checked = checked(file, quiet, format, check)?;
    let checking = started.elapsed();
    let started = Instant::now();
    let module = Module::from_checked(&Engine::default(), checked).map_err(|error| {
        format.failure(&error.to_string(), "");
        ExitCode::from(MODEL_ERROR)
    })?;
    Ok((module, vec![("check", checking), ("compile", started.elapsed())]))
}

/// Unwraps the result of `check`, after printing its diagnostics (only errors if `quiet`). `Err` is
/// the exit status if the model has errors of the language.
pub fn checked(
    file: &Path,
    quiet: bool,
    format: MessageFormat,
    check: impl FnOnce() -> io::Result<Checked>,
) -> Result<Checked, ExitCode> {
    let checked = check().map_err(|error| format.unreadable(file, &error))?;
    let mut shown = checked.diagnostics.clone();
    if quiet {
        shown.retain(|diagnostic| diagnostic.severity == Severity::Error);
    }
    format.diagnostics(&shown, &checked.files);
    if let Some(refused) = &checked.refused {
        format.refused(refused);
        return Err(ExitCode::from(USAGE));
    }
    if checked.program.is_none() {
        return Err(ExitCode::from(MODEL_ERROR));
    }
    Ok(checked)
}
