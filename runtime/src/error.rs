//! Why the engine could not do what was asked: a code, a plain sentence, what to do, and what is to blame.

use thiserror::Error;

/// A refusal. `code` is stable (`E06..` the model cannot be built, `E07..` it could not be solved).
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{message}")]
pub struct EngineError {
    pub code: &'static str,
    pub message: String,
    /// What to do about it; empty if nothing can be said.
    pub help: String,
    /// Name of the argument to blame, as the library declares it.
    pub argument: Option<&'static str>,
}

impl EngineError {
    pub fn new(code: &'static str, message: impl Into<String>, help: impl Into<String>) -> Self {
        EngineError { code, message: message.into(), help: help.into(), argument: None }
    }

    pub fn blame(mut self, argument: &'static str) -> Self {
        self.argument = Some(argument);
        self
    }
}
