//! Errors of elastic bodies.

use calyx_numerics::error::EngineError;

/// Error in a model or one of its elements.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct ElementError {
    /// Message: one sentence.
    pub message: String,
    /// Remedy, an imperative; empty if there is none.
    pub help: String,
}

impl ElementError {
    /// Creates an error from its message and remedy.
    pub fn new(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), help: help.into() }
    }

    /// Names the item that the error concerns, such as `element 12`.
    pub fn within(self, item: impl std::fmt::Display) -> Self {
        Self { message: format!("{item}: {}", self.message), help: self.help }
    }
}

/// Reasons why a body cannot be analysed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ElasticError {
    /// The model is invalid.
    #[error(transparent)]
    Model(#[from] ElementError),
    /// The body can move without deforming, or a part of it has no stiffness.
    #[error("{message}")]
    Mechanism {
        /// Message: one sentence.
        message: String,
        /// Remedy.
        help: String,
        /// Labels of nodes that move.
        nodes: Vec<u64>,
    },
    /// The computation needs more memory than its limit.
    #[error("{message}")]
    Memory {
        /// Message: one sentence with the number of unknowns that would fit.
        message: String,
        /// Remedy.
        help: String,
    },
    /// The eigenvalue solver does not converge.
    #[error("{0}")]
    Convergence(String),
    /// The caller ended the computation.
    #[error(transparent)]
    Interrupted(#[from] EngineError),
}

impl ElasticError {
    /// Creates an error of the model from its message and remedy.
    pub fn model(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Model(ElementError::new(message, help))
    }
}
