//! Why the engine could not do what was asked: a code, a plain sentence, what to do, and what is to blame.

use thiserror::Error;

/// A refusal. `code` is stable (`E06..` the model cannot be built, `E07..` it could not be solved).
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{message}")]
pub struct EngineError {
    pub code: &'static str,
    pub message: String,
    /// What to do about it; empty if nothing can be said.
    pub help: String,
    /// Name of the argument to blame, as the library declares it.
    pub argument: Option<&'static str>,
    /// What of the scene it is about, so that whoever built the scene finds the place in the source.
    pub subject: Option<Subject>,
}

/// A part of the scene or of what was asked for, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    Body(usize),
    Output(usize),
}

impl EngineError {
    pub fn new(code: &'static str, message: impl Into<String>, help: impl Into<String>) -> Self {
        EngineError { code, message: message.into(), help: help.into(), argument: None, subject: None }
    }

    pub fn blame(mut self, argument: &'static str) -> Self {
        self.argument = Some(argument);
        self
    }

    pub fn about(mut self, subject: Subject) -> Self {
        self.subject = Some(subject);
        self
    }
}
