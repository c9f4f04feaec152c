//! Converts errors of the engine and the library to diagnostics at the responsible source location.

use calyx_abi::RuntimeError;
use calyx_abi::attribution::cause;
use calyx_gears::error::Severity as FindingSeverity;
use calyx_gears::host::Finding;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::span::{FileId, Span};
use calyx_lower::interpret::CallSites;

/// Returns `true` if any diagnostic is an error.
pub fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}

/// Converts a run-time error to a diagnostic at its source location.
pub fn diagnostic(error: &RuntimeError) -> Diagnostic {
    labelled(error, |path| format!("`{path}` cannot be built"), cause)
}

/// Converts a run-time error; `label` returns the label at the declaration of an instance, `cause`
/// that of an error that concerns no single argument.
fn labelled(
    error: &RuntimeError,
    label: impl Fn(&str) -> String,
    cause: impl Fn(&RuntimeError) -> String,
) -> Diagnostic {
    let instance = error.details.calls.iter().rfind(|call| call.instance().is_some());
    let instance = instance.filter(|call| Some(call.place) == error.place).and_then(|call| call.instance());
    let argument = error.argument.as_deref().filter(|argument| !argument.is_empty());
    let label = match (instance, argument) {
        (Some(path), _) => label(path),
        (None, Some(argument)) => format!("caused by `{argument}`"),
        (None, None) => cause(error),
    };
    let mut diagnostic = Diagnostic::error(&error.code, &error.message, place(error.place), label);
    diagnostic.calls = error.details.calls.clone();
    let diagnostic = error
        .details
        .notes
        .iter()
        .fold(diagnostic, |diagnostic, (at, note)| diagnostic.label(place(Some(*at)), note.clone()));
    match (error.help.as_str(), error.details.origin.as_str()) {
        // A `throw` in the library has no help of its own; the page of its code explains it.
        ("", "") if error.code.starts_with("E08") => {
            diagnostic.help(format!("see `calyx explain {}` for what to do", error.code))
        }
        ("", "") => diagnostic,
        ("", origin) => diagnostic.help(format!("the error states its origin: {origin}")),
        (help, _) => diagnostic.help(help),
    }
}

/// Converts a finding that accompanies the error that stopped the model, located at the responsible
/// argument.
pub fn finding_diagnostic(finding: &Finding, sites: &CallSites) -> Diagnostic {
    let mut error = finding.error.clone();
    sites.blame(&mut error);
    match finding.severity {
        FindingSeverity::Error => diagnostic(&error),
        FindingSeverity::Warning => {
            let call = |error: &RuntimeError| match error.details.function.as_str() {
                "" => "the warning concerns this".into(),
                function => format!("caused by this call of `{function}`"),
            };
            let found = labelled(&error, |path| format!("in `{path}`"), call);
            Diagnostic { severity: Severity::Warning, code: found.code.replacen('E', "W", 1), ..found }
        }
    }
}

/// Converts a source location of a running program to a span.
pub fn place(place: Option<(u32, u32, u32)>) -> Span {
    let (file, start, end) = place.unwrap_or_default();
    Span { file: FileId(file), start, end }
}
