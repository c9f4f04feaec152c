//! Errors of a running model: message, location and call stack.

use crate::call::Status;

/// Byte range `(file, start, end)` of the source.
pub type Place = (u32, u32, u32);

/// Error of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct RuntimeError {
    /// Stable code, e.g. `E0703`, or one of the program.
    pub code: String,
    pub message: String,
    /// Remedy; empty if there is none.
    pub help: String,
    /// Name of the argument at fault, if any; the caller knows its location.
    pub argument: Option<String>,
    /// Source location, set by the first caller that knows it.
    pub place: Option<Place>,
    pub details: Box<Details>,
}

/// Rarely used details.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Details {
    /// Call stack of the program's functions, innermost first; each caller adds its entry as the
    /// error passes.
    pub calls: Vec<Call>,
    /// Path of the instance of a component that was being built, for a finding, which has no call
    /// stack; empty outside of components.
    pub instance: String,
    /// Innermost call of a library function by the program when a finding, which has no call
    /// stack, arose.
    pub library_call: Option<Place>,
    /// Number at fault, if the program that threw the error named one.
    pub value: Option<f64>,
    /// Origin of the error as stated by the program that threw it; empty if not stated.
    pub origin: String,
    /// Name of the function whose call at the location failed; empty if it is unknown.
    pub function: String,
    /// Additional causes with their own locations.
    pub notes: Vec<(Place, String)>,
}

/// Call that was active when an error arose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// Name of the called function.
    pub function: String,
    /// Location of the call.
    pub place: Place,
}

impl Call {
    /// Returns the path of the instance that the call creates, if it calls a component: its
    /// function is called `Stage low`.
    pub fn instance(&self) -> Option<&str> {
        // An anonymous function is called `(x, y) => ...`.
        let (_, path) = self.function.split_once(' ').filter(|_| !self.function.starts_with('('))?;
        Some(path)
    }
}

impl RuntimeError {
    /// Creates an error without a location.
    pub fn new(code: &str, message: impl Into<String>, help: impl Into<String>) -> Self {
        RuntimeError {
            code: code.into(),
            message: message.into(),
            help: help.into(),
            argument: None,
            place: None,
            details: Box::default(),
        }
    }

    /// Names the argument at fault of the failing call.
    #[must_use]
    pub fn of_argument(self, name: impl Into<String>) -> Self {
        RuntimeError { argument: Some(name.into()), ..self }
    }

    /// Returns the status of a function that fails with this error.
    pub fn status(&self) -> Status {
        match self.code.as_str() {
            codes::LIMIT | codes::CANCELLED | codes::EXHAUSTED | codes::INTERNAL => Status::Cancelled,
            _ => Status::Failed,
        }
    }

    /// Adds a call that the error passes to the stack.
    pub fn passed(&mut self, function: &str, place: Place) {
        self.details.calls.push(Call { function: function.into(), place });
    }
}

/// Number of calls at either end that are shown of a deep stack.
const SHOWN_CALLS: usize = 8;

/// Formats one line per call, innermost first: `` `f`, called at model.cx:3:7``. Equal consecutive
/// calls are counted, and the middle of a deep stack is omitted.
pub fn call_lines(calls: &[Call], shown_place: impl Fn(Place) -> String) -> Vec<String> {
    let mut lines = Vec::new();
    for group in calls.chunk_by(|a, b| a == b) {
        let Call { function, place } = &group[0];
        let times = if group.len() > 1 { format!(" ({} times)", group.len()) } else { String::new() };
        lines.push(format!("in `{function}`, called at {}{times}", shown_place(*place)));
    }
    if lines.len() > 2 * SHOWN_CALLS + 1 {
        let left_out = lines.len() - 2 * SHOWN_CALLS;
        lines.splice(SHOWN_CALLS..SHOWN_CALLS + left_out, [format!("... {left_out} more ...")]);
    }
    lines
}

/// Codes of the errors that running programs raise themselves.
pub mod codes {
    /// The axis of a rotation is not a unit vector.
    pub const AXIS: &str = "E0515";
    /// An index is not an integer or not within the array.
    pub const INDEX: &str = "E0701";
    /// The maximum depth of calls is exceeded.
    pub const DEPTH: &str = "E0702";
    /// The limit on the number of basic blocks was reached.
    pub const LIMIT: &str = "E0703";
    /// [`crate::Context::cancel`] was set.
    pub const CANCELLED: &str = "E0704";
    /// An `assert` failed.
    pub const ASSERTION: &str = "E0705";
    /// The value of an observable was requested while the model is still being built.
    pub const OBSERVABLE: &str = "E0706";
    /// An equation of `solve` has no solution near the guess.
    pub const NO_SOLUTION: &str = "E0863";
    /// The points of a spline are invalid.
    pub const SPLINE: &str = "E0864";
    /// The limit on time or memory was reached.
    pub const EXHAUSTED: &str = "E0707";
    /// A limit of a range or a slice is not an integer.
    pub const RANGE: &str = "E0851";
    /// The limits of a slice are not within the array.
    pub const SLICE: &str = "E0852";
    /// Arrays of different lengths are added or subtracted.
    pub const LENGTHS: &str = "E0853";
    /// The extreme of an empty array is requested.
    pub const EMPTY: &str = "E0854";
    /// The program threw an error without a code of its own.
    pub const THROWN: &str = "E0720";
    /// A host function of the embedding program failed.
    pub const HOST: &str = "E0725";
    /// An argument of the engine is NaN.
    pub const NOT_A_NUMBER: &str = "E0722";
    /// Defect of the engine or the compiler, not of the program.
    pub const INTERNAL: &str = "E0799";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deep_recursion_is_shown_at_its_ends() {
        let call = |function: &str, at| Call { function: function.into(), place: (0, at, at + 1) };
        let shown = |calls: &[Call]| call_lines(calls, |place| place.1.to_string());
        let deep = [vec![call("leaf", 9)], vec![call("f", 5); 998], vec![call("f", 1)]].concat();
        assert_eq!(
            shown(&deep),
            ["in `leaf`, called at 9", "in `f`, called at 5 (998 times)", "in `f`, called at 1"]
        );
        let mutual: Vec<Call> =
            (0..1000).map(|i| call(if i % 2 == 0 { "even" } else { "odd" }, i % 2)).collect();
        let lines = shown(&mutual);
        assert_eq!((lines.len(), lines[8].as_str()), (17, "... 984 more ..."));
    }
}
