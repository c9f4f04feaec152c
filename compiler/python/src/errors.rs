//! Errors as exceptions of `calyx.errors`.

use calyx::rt::{AcceptedValues, InvalidParam, ParamValue, RunError};
use calyx::{CompileError, Diagnostic, Diagnostics, Error, ErrorKind, Module, Severity};
use calyx_abi::units::{from_si, shortest};
use pyo3::exceptions::{PyFileNotFoundError, PyOSError};
use pyo3::prelude::*;
use std::fmt::Display;
use std::io;

/// Content of an exception.
#[derive(Default)]
pub struct Problem {
    pub message: String,
    /// Code that `calyx explain` describes; empty if there is none.
    pub code: String,
    /// Remedy; empty if there is none.
    pub help: String,
    /// Text with the source lines concerned.
    pub rendered: String,
}

impl Problem {
    /// Creates an exception of a class of `calyx.errors`.
    pub fn raised(self, py: Python<'_>, class: &str) -> PyErr {
        let Problem { message, code, help, rendered } = self;
        let raise = || -> PyResult<PyErr> {
            let class = py.import("calyx.errors")?.getattr(class)?;
            Ok(PyErr::from_value(class.call1((message, code, help, rendered))?))
        };
        raise().unwrap_or_else(|error| error)
    }

    /// Creates a problem from an error with a remedy.
    pub fn new(message: &impl Display, help: &str) -> Problem {
        let message = message.to_string();
        let rendered = if help.is_empty() { message.clone() } else { format!("{message}\n  help: {help}") };
        Problem { message, help: help.to_owned(), rendered, ..Problem::default() }
    }
}

/// Renders diagnostics without colour.
pub fn rendered(list: &[Diagnostic], module: &Module) -> String {
    Diagnostics { list: list.to_vec(), files: module.files().to_vec() }.to_string()
}

/// Converts an error of the compilation.
pub fn of_compilation(py: Python<'_>, error: CompileError) -> PyErr {
    match error {
        CompileError::Unreadable { path, error } => unreadable(&path.display(), &error),
        CompileError::Model(diagnostics) => {
            let rendered = diagnostics.to_string();
            let mut list = diagnostics.list.into_iter();
            let first = list.find(|diagnostic| diagnostic.severity == Severity::Error);
            let Some(Diagnostic { message, code, help, .. }) = first else {
                return Problem::new(&rendered, "").raised(py, "ModelError");
            };
            Problem { message, code, help: help.unwrap_or_default(), rendered }.raised(py, "ModelError")
        }
        error => Problem::new(&error, "").raised(py, "InternalError"),
    }
}

/// Converts an error of reading a model.
pub fn unreadable(path: &impl Display, error: &io::Error) -> PyErr {
    let text = format!("cannot read {path}: {error}");
    match error.kind() {
        io::ErrorKind::NotFound => PyFileNotFoundError::new_err(text),
        _ => PyOSError::new_err(text),
    }
}

/// Describes the values that a param takes, with an example in Python.
fn accepted(AcceptedValues { name, domain, default, unit }: &AcceptedValues) -> String {
    let number = |si: &f64| shortest(from_si(*si, unit.factor));
    let example = match default {
        Some(ParamValue::Bool(value)) => (if *value { "True" } else { "False" }).to_owned(),
        Some(ParamValue::String(value)) => format!("{value:?}"),
        Some(ParamValue::Number(si)) => number(si),
        Some(ParamValue::Numbers(all)) => {
            format!("[{}]", all.iter().map(number).collect::<Vec<_>>().join(", "))
        }
        None => return format!("`{name}` takes {domain}"),
    };
    // Names of components are no names of Python.
    let is_name = name.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
    let assignment = if is_name { format!("{name}={example}") } else { format!("{{{name:?}: {example}}}") };
    let bare =
        if unit.name.is_empty() { String::new() } else { format!(", in {} if no unit is given", unit.name) };
    format!("`{name}` takes {domain}, like `{assignment}`{bare}")
}

/// Replaces the remedy of the command line by one of Python.
fn in_python(invalid: &InvalidParam) -> InvalidParam {
    let help = invalid.accepted.as_ref().map(|accepted_values| accepted(accepted_values));
    InvalidParam { help: help.unwrap_or_else(|| invalid.help.clone()), ..invalid.clone() }
}

/// Converts an error of an instance.
pub fn of_run(py: Python<'_>, module: &Module, error: &Error) -> PyErr {
    let error = &match error {
        Error::Given(invalid) => Error::Given(in_python(invalid)),
        Error::Model(error) => Error::Model(error.clone()),
    };
    let rendered = match error {
        Error::Given(refused) => calyx::rt::messages::refused(refused),
        Error::Model(error) => rendered(&[module.error(error)], module),
    };
    let (message, help) = (error.message().to_owned(), error.help().to_owned());
    let code = error.code().unwrap_or_default().to_owned();
    let class = match error.kind() {
        ErrorKind::InvalidInput => "ParamError",
        ErrorKind::Model => "RunError",
        ErrorKind::Cancelled => "CancelledError",
        ErrorKind::Limit => "LimitError",
        ErrorKind::Internal => "InternalError",
    };
    Problem { message, code, help, rendered }.raised(py, class)
}

/// Converts an error of writing a run directory.
pub fn of_directory(py: Python<'_>, error: RunError) -> PyErr {
    match error {
        // The remedies name options of the command.
        RunError::Directory(error) => {
            let help = "choose another directory, or pass force=True, which replaces files with names of results and keeps all others";
            Problem::new(&error, help).raised(py, "DirectoryError")
        }
        RunError::Io { path, error } => {
            Problem::new(&format!("cannot write {}: {error}", path.display()), "choose another directory")
                .raised(py, "DirectoryError")
        }
        RunError::Run(error) => Problem::new(&error.message(), error.help()).raised(py, "RunError"),
        RunError::Ended { error, .. } => Problem::new(&error.message, &error.help).raised(py, "RunError"),
    }
}
