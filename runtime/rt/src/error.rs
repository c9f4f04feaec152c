//! Why something that was asked of an instance was not done, as data.

use crate::param_assignment::Origin;
use crate::params::InvalidParam;
use calyx_abi::RuntimeError;
use calyx_abi::error::codes;
use std::fmt;

/// Why something was not done.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// What was given cannot be used: a name that the model does not have, a unit of another dimension, a value out of
    /// range.
    Given(InvalidParam),
    /// The model or its analysis failed, or was ended before its time.
    Model(RuntimeError),
}

/// Kinds of errors that are met in different ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// Give something else.
    Given,
    /// At these params the model cannot be built or solved.
    Model,
    /// Somebody cancelled it.
    Cancelled,
    /// It used up its time or memory.
    Limit,
    /// A defect of Calyx, or this machine refused what a run needs.
    Internal,
}

impl Error {
    pub(crate) fn given(message: impl Into<String>, help: impl Into<String>) -> Error {
        Error::Given(InvalidParam::new(message, help))
    }

    /// The same error of what was given in a file.
    pub(crate) fn placed(self, origin: Option<&Origin>) -> Error {
        match self {
            Error::Given(refused) => Error::Given(InvalidParam { origin: origin.cloned(), ..refused }),
            error => error,
        }
    }

    pub fn kind(&self) -> ErrorKind {
        match self.code() {
            None => ErrorKind::Given,
            Some(codes::CANCELLED) => ErrorKind::Cancelled,
            Some(codes::EXHAUSTED | codes::LIMIT) => ErrorKind::Limit,
            Some(codes::INTERNAL) => ErrorKind::Internal,
            Some(_) => ErrorKind::Model,
        }
    }

    /// The stable code, like `E0603`, by which `calyx explain` says more; what was given wrong has none.
    pub fn code(&self) -> Option<&str> {
        match self {
            Error::Given(_) => None,
            Error::Model(error) => Some(&error.code),
        }
    }

    pub fn message(&self) -> &str {
        match self {
            Error::Given(refused) => &refused.message,
            Error::Model(error) => &error.message,
        }
    }

    /// Remedy; empty if there is none.
    pub fn help(&self) -> &str {
        match self {
            Error::Given(refused) => &refused.help,
            Error::Model(error) => &error.help,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if let Some(code) = self.code() {
            write!(f, "[{code}] ")?;
        }
        f.write_str(self.message())?;
        match self.help() {
            "" => Ok(()),
            help => write!(f, " ({help})"),
        }
    }
}

impl std::error::Error for Error {}

impl From<RuntimeError> for Error {
    fn from(error: RuntimeError) -> Error {
        Error::Model(error)
    }
}
