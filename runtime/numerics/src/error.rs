//! Errors of the engine: code, message, remedy and the part of the scene concerned.

use thiserror::Error;

/// Error of the engine. `code` is stable (`E06..`: the model cannot be built, `E07..`: it could not
/// be solved).
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{message}")]
pub struct EngineError {
    /// Stable code, such as `E0714`; `calyx explain` has a page for it.
    pub code: &'static str,
    /// Message: one sentence.
    pub message: String,
    /// Remedy; empty if there is none.
    pub help: String,
    /// Name of the argument at fault, as declared in the library.
    pub argument: Option<&'static str>,
    /// Part of the scene at fault, from which the caller finds the source location.
    pub subject: Option<Subject>,
}

/// Part of the scene or of the request, by index. Pairs of indices have 32 bits each, so that
/// errors stay small.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subject {
    /// Body of the scene.
    Body(usize),
    /// Prototype of a body: its gear.
    Prototype(usize),
    /// Bearing of the scene.
    Bearing(usize),
    /// Requested output.
    Output(usize),
    /// Forced response of the scene.
    ForcedResponse,
    /// Requested sound.
    Sound(usize),
    /// Point at which a requested sound has its pressure: request and point.
    SoundPoint(u32, u32),
    /// Field mesh of a requested sound: request and mesh.
    SoundField(u32, u32),
}

impl EngineError {
    /// Creates an error from its code, message and remedy.
    pub fn new(code: &'static str, message: impl Into<String>, help: impl Into<String>) -> Self {
        EngineError { code, message: message.into(), help: help.into(), argument: None, subject: None }
    }

    /// Names the argument at fault.
    pub fn blame(mut self, argument: &'static str) -> Self {
        self.argument = Some(argument);
        self
    }

    /// Names the part of the scene at fault.
    pub fn about(mut self, subject: Subject) -> Self {
        self.subject = Some(subject);
        self
    }
}
