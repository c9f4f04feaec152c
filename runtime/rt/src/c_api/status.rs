//! C API: status codes.

use crate::error::{Error, ErrorKind};
use std::ffi::{c_char, c_int};

/// `calyx_status` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CStatus {
    Ok = 0,
    End = 1,
    InvalidInput = 2,
    Model = 3,
    Cancelled = 4,
    Limit = 5,
    Internal = 6,
    Null = 7,
    Version = 8,
}

impl CStatus {
    pub(super) fn of(error: &Error) -> CStatus {
        match error.kind() {
            ErrorKind::InvalidInput => CStatus::InvalidInput,
            ErrorKind::Model => CStatus::Model,
            ErrorKind::Cancelled => CStatus::Cancelled,
            ErrorKind::Limit => CStatus::Limit,
            ErrorKind::Internal => CStatus::Internal,
        }
    }
}

/// Returns a description of a status. Accepts any number, because C may pass any.
#[unsafe(no_mangle)]
pub extern "C" fn calyx_status_message(status: c_int) -> *const c_char {
    let message = match status {
        0 => c"the function succeeded",
        1 => c"the run is complete: there is no further position",
        2 => c"an argument is invalid",
        3 => c"the model or its analysis failed",
        4 => c"the run was cancelled",
        5 => c"the run exceeded its limit of time or memory",
        6 => c"internal error; please report it with the model",
        7 => c"a required pointer is NULL",
        8 => c"the model was compiled by another version of Calyx than that of the linked library; compile it again",
        _ => c"unknown status",
    };
    message.as_ptr()
}
