//! Errors of rolling bearings.

/// Reason why a bearing is rejected or why it has no equilibrium.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RollingError {
    /// An input is invalid, or inputs contradict each other.
    #[error("{message}")]
    Input {
        /// Message: one sentence.
        message: String,
        /// Remedy, an imperative.
        help: String,
        /// Name of the input, such as `ball_diameter`; empty if several contradict each other.
        input: String,
    },
    /// No displacement of the inner ring balances the load.
    #[error("{message}")]
    Equilibrium {
        /// Message: one sentence.
        message: String,
        /// Remedy, an imperative.
        help: String,
    },
}

impl RollingError {
    /// Creates an error of an input from its message and remedy.
    pub(crate) fn input(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Input { message: message.into(), help: help.into(), input: String::new() }
    }

    /// Names the input of the error.
    pub(crate) fn of(mut self, name: impl Into<String>) -> Self {
        if let Self::Input { input, .. } = &mut self {
            *input = name.into();
        }
        self
    }

    /// Creates an error of the equilibrium from its message and remedy.
    pub(crate) fn equilibrium(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Equilibrium { message: message.into(), help: help.into() }
    }

    /// Returns the name of the input that is invalid, such as `ball_diameter`.
    pub fn invalid_input(&self) -> Option<&str> {
        match self {
            Self::Input { input, .. } if !input.is_empty() => Some(input),
            _ => None,
        }
    }

    /// Returns the remedy, an imperative.
    pub fn help(&self) -> &str {
        match self {
            Self::Input { help, .. } | Self::Equilibrium { help, .. } => help,
        }
    }
}

/// Checks that an input is finite and positive.
///
/// # Errors
/// [`RollingError::Input`] with the name of the input.
pub(crate) fn positive(name: &str, value: f64) -> Result<(), RollingError> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(RollingError::input(
        format!("the {name} of a rolling bearing must be positive, but is {value}"),
        format!("give a positive {name}"),
    )
    .of(name.replace(' ', "_")))
}

/// Checks that an input is finite.
///
/// # Errors
/// [`RollingError::Input`] with the name of the input.
pub(crate) fn finite(name: &str, value: f64) -> Result<(), RollingError> {
    if value.is_finite() {
        return Ok(());
    }
    Err(RollingError::input(
        format!("the {name} of a rolling bearing must be finite, but is {value}"),
        format!("give a finite {name}"),
    )
    .of(name.replace(' ', "_")))
}

/// Rounds a number for a message: digits that stem from the conversion of its unit are dropped.
pub(crate) fn for_message(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}
