//! Former names of types and modules, which work until version 0.2.

/// Former name of [`ParamAssignment`](crate::ParamAssignment).
#[deprecated(since = "0.1.0", note = "use `ParamAssignment`")]
pub type Given = crate::ParamAssignment;
/// Former name of [`AssignedValue`](crate::AssignedValue).
#[deprecated(since = "0.1.0", note = "use `AssignedValue`")]
pub type GivenValue = crate::AssignedValue;
/// Former name of [`InvalidParam`](crate::InvalidParam).
#[deprecated(since = "0.1.0", note = "use `InvalidParam`")]
pub type Refused = crate::InvalidParam;
/// Former name of [`NanLog`](crate::NanLog).
#[deprecated(since = "0.1.0", note = "use `NanLog`")]
pub type Seen = crate::NanLog;

/// Former name of [`param_assignment`](crate::param_assignment).
#[deprecated(since = "0.1.0", note = "use `param_assignment`")]
pub mod given {
    pub use crate::param_assignment::*;
    #[allow(deprecated, reason = "the former names are there under their former path")]
    pub use crate::{Given, GivenValue};
}

/// Former name of [`nan_log`](crate::nan_log).
#[deprecated(since = "0.1.0", note = "use `nan_log`")]
pub mod seen {
    #[allow(deprecated, reason = "the former name is there under its former path")]
    pub use crate::Seen;
    pub use crate::nan_log::*;
}

/// Former name of [`settings_override`](crate::settings_override).
#[cfg(feature = "command")]
#[deprecated(since = "0.1.0", note = "use `settings_override`")]
pub mod overriding {
    pub use crate::settings_override::*;
}
