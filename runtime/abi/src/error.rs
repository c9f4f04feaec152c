//! Errors of a running model: what they say, where they arose, and the calls that led there.

use crate::call::Status;

/// Byte range `(file, start, end)` of the source.
pub type Place = (u32, u32, u32);

/// Why a call failed.
#[derive(Clone, Debug, PartialEq)]
pub struct RuntimeError {
    /// Stable code, e.g. `E0703`, or the program's own.
    pub code: String,
    pub message: String,
    /// What to do about it; empty if nothing can be said.
    pub help: String,
    /// Name of the argument to blame, if one is (the caller knows where it was written).
    pub argument: Option<String>,
    /// The blamed source, filled in by whoever knows it first.
    pub place: Option<Place>,
    pub details: Box<Details>,
}

/// What most errors do not have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Details {
    /// Calls of the program's functions under way, innermost first; each caller adds its own as the error passes it.
    pub calls: Vec<Call>,
    /// The number to blame, if the program that threw the error named one.
    pub value: Option<f64>,
    /// Where the error arose by the words of the program that threw it; empty if it said nothing of it.
    pub origin: String,
    /// What else led to it, at places of their own.
    pub notes: Vec<(Place, String)>,
}

/// A call that was under way when an error arose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// The function that was called.
    pub function: String,
    /// Where.
    pub place: Place,
}

impl RuntimeError {
    /// An error without a place; whoever knows one fills it in.
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

    /// The same error, blamed on an argument of the call that fails with it.
    #[must_use]
    pub fn of_argument(self, name: impl Into<String>) -> Self {
        RuntimeError { argument: Some(name.into()), ..self }
    }

    /// What a function that fails with this error returns.
    pub fn status(&self) -> Status {
        match self.code.as_str() {
            codes::LIMIT | codes::CANCELLED | codes::EXHAUSTED | codes::INTERNAL => Status::Cancelled,
            _ => Status::Failed,
        }
    }

    /// Notes a call that the error passes on its way out.
    pub fn passed(&mut self, function: &str, place: Place) {
        self.details.calls.push(Call { function: function.into(), place });
    }
}

/// Calls at either end that are shown of very many.
const SHOWN_CALLS: usize = 8;

/// One line a call, innermost first: `` `f`, called at model.cx:3:7``. Equal calls in a row are counted, and the middle
/// of very many is left out.
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

/// Codes of the errors that running programs raise by themselves.
pub mod codes {
    /// An axis of a rotation that is no unit vector.
    pub const AXIS: &str = "E0515";
    /// An index that is not whole or not within the array.
    pub const INDEX: &str = "E0701";
    /// Functions call each other too deeply.
    pub const DEPTH: &str = "E0702";
    /// The limit on the number of basic blocks was reached.
    pub const LIMIT: &str = "E0703";
    /// Somebody set [`crate::Context::cancel`].
    pub const CANCELLED: &str = "E0704";
    /// An `assert` failed.
    pub const ASSERTION: &str = "E0705";
    /// An observable was asked for its value while the model is still being built.
    pub const OBSERVABLE: &str = "E0706";
    /// The limit on time or memory was reached.
    pub const EXHAUSTED: &str = "E0707";
    /// The program threw an error without a code of its own.
    pub const THROWN: &str = "E0720";
    /// A function that the embedding program provides failed.
    pub const HOST: &str = "E0725";
    /// An argument of the engine is NaN.
    pub const NOT_A_NUMBER: &str = "E0722";
    /// A fault of the engine or the compiler, not of the program.
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
