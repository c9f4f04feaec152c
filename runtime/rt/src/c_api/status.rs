//! C API: status codes.

use crate::error::{Error, ErrorKind};
use std::ffi::{c_char, c_int};

/// `calyx_status` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CStatus {
    Ok = 0,
    End = 1,
    Given = 2,
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
            ErrorKind::Given => CStatus::Given,
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
        0 => c"all went well",
        1 => c"the run is complete: there is no further position",
        2 => c"what was given cannot be used",
        3 => c"the model or its analysis failed",
        4 => c"the run was cancelled",
        5 => c"the run used up its time or memory",
        6 => c"an internal error, which should be reported with the model",
        7 => c"a pointer is NULL where something must be",
        8 => c"the model was compiled by another version of Calyx than the library it is linked with; compile it again",
        _ => c"an unknown status",
    };
    message.as_ptr()
}
