//! Errors of the readers.

/// Reason why a model is rejected, with its location and a remedy.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}: {message}")]
pub struct ImportError {
    /// File, as its path was passed to the open function.
    pub file: String,
    /// Line, from 1. For binary data, the line at which the section starts.
    pub line: usize,
    /// Statement of the problem.
    pub message: String,
    /// Remedy, in the imperative.
    pub help: String,
}

/// Reason why the caller refuses to open a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// Statement of the problem, to follow "cannot be read:".
    pub message: String,
    /// Remedy, in the imperative.
    pub help: String,
}

impl Unreadable {
    /// Returns the error with this message and remedy.
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), help: help.into() }
    }
}
