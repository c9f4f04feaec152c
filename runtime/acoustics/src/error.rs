//! Errors of acoustic models and their solution.

use calyx_numerics::error::EngineError;

/// Reasons why radiated sound cannot be computed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AcousticError {
    /// The surface mesh does not enclose a body.
    #[error("{place}: {message}")]
    Mesh {
        /// Location, such as `element 12` (indices of vertices and elements count from 0).
        place: String,
        /// Statement of the problem.
        message: String,
        /// Remedy, in the imperative.
        help: String,
    },
    /// An argument is out of its range.
    #[error("{message}")]
    Input {
        /// Statement of the problem.
        message: String,
        /// Remedy, in the imperative.
        help: String,
    },
    /// The iterative solution does not converge, or a matrix is singular.
    #[error("{message}")]
    Convergence {
        /// Statement of the problem.
        message: String,
        /// Remedy, in the imperative.
        help: String,
    },
    /// The caller ended the computation, or refused its memory.
    #[error(transparent)]
    Interrupted(#[from] EngineError),
}

impl AcousticError {
    /// Creates an error of the mesh from its location, message and remedy.
    pub fn mesh(place: impl Into<String>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Mesh { place: place.into(), message: message.into(), help: help.into() }
    }

    /// Creates an error of an argument from its message and remedy.
    pub fn input(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Input { message: message.into(), help: help.into() }
    }

    /// Creates an error of the solution from its message and remedy.
    pub fn convergence(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Convergence { message: message.into(), help: help.into() }
    }

    /// Returns the remedy.
    pub fn help(&self) -> &str {
        match self {
            Self::Mesh { help, .. } | Self::Input { help, .. } | Self::Convergence { help, .. } => help,
            Self::Interrupted(error) => &error.help,
        }
    }
}
