//! Why the engine could not do what was asked: a code, a plain sentence, what to do, and what is to blame.

use thiserror::Error;

/// A refusal. `code` is stable (`E06..` the model cannot be built, `E07..` it could not be solved).
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{message}")]
pub struct EngineError {
    /// Stable, such as `E0714`; `calyx explain` has a page for it.
    pub code: &'static str,
    /// One plain sentence.
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
    /// A body of the scene.
    Body(usize),
    /// What a body of the scene is made of: its gear.
    Prototype(usize),
    /// A bearing of the scene.
    Bearing(usize),
    /// An output that was asked for.
    Output(usize),
}

impl EngineError {
    /// A refusal by its code, its sentence and its remedy.
    pub fn new(code: &'static str, message: impl Into<String>, help: impl Into<String>) -> Self {
        EngineError { code, message: message.into(), help: help.into(), argument: None, subject: None }
    }

    /// Names the argument to blame.
    pub fn blame(mut self, argument: &'static str) -> Self {
        self.argument = Some(argument);
        self
    }

    /// Names the part of the scene it is about.
    pub fn about(mut self, subject: Subject) -> Self {
        self.subject = Some(subject);
        self
    }
}
