//! Errors of operations on an instance, as data.

use crate::param_assignment::Origin;
use crate::params::InvalidParam;
use calyx_abi::RuntimeError;
use calyx_abi::error::codes;
use std::fmt;

/// Error of an operation on an instance.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// An argument is invalid: a name that the model does not have, a unit of another dimension, a
    /// value out of range.
    Given(InvalidParam),
    /// The model or its analysis failed, or was ended early.
    Model(RuntimeError),
}

/// Categories of errors by remedy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// An argument must be changed.
    InvalidInput,
    /// The model cannot be built or solved with these params.
    Model,
    /// The run was cancelled.
    Cancelled,
    /// The run exceeded its time or memory limit.
    Limit,
    /// A defect of Calyx, or a resource that the machine refused.
    Internal,
}

impl ErrorKind {
    /// Former name of [`ErrorKind::InvalidInput`].
    #[deprecated(since = "0.1.0", note = "use `ErrorKind::InvalidInput`")]
    #[expect(non_upper_case_globals, reason = "the name of the former variant")]
    pub const Given: ErrorKind = ErrorKind::InvalidInput;
}

impl Error {
    pub(crate) fn given(message: impl Into<String>, help: impl Into<String>) -> Error {
        Error::Given(InvalidParam::new(message, help))
    }

    /// Adds the location in a file to an error about a given value.
    pub(crate) fn placed(self, origin: Option<&Origin>) -> Error {
        match self {
            Error::Given(refused) => Error::Given(InvalidParam { origin: origin.cloned(), ..refused }),
            error => error,
        }
    }

    pub fn kind(&self) -> ErrorKind {
        match self.code() {
            None => ErrorKind::InvalidInput,
            Some(codes::CANCELLED) => ErrorKind::Cancelled,
            Some(codes::EXHAUSTED | codes::LIMIT) => ErrorKind::Limit,
            Some(codes::INTERNAL) => ErrorKind::Internal,
            Some(_) => ErrorKind::Model,
        }
    }

    /// Returns the stable code, like `E0603`, that `calyx explain` describes. Errors about given
    /// values have none.
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

    /// Returns the remedy; empty if there is none.
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
