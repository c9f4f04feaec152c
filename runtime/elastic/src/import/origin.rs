//! Where a part of a model comes from, and problems with it.

use super::error::ImportError;
use super::source::{Place, error};

/// Card or element type that a part of the model comes from, and its location.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    pub name: &'static str,
    pub place: Place,
}

/// Problem without its file name.
pub(super) struct Problem {
    pub place: Place,
    pub message: String,
    pub help: String,
}

impl Problem {
    pub fn new(place: Place, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { place, message: message.into(), help: help.into() }
    }

    /// Returns the error with the name of its file.
    pub fn located(self, files: &[String]) -> ImportError {
        error(files, self.place, self.message, self.help)
    }
}
