//! Functions every program may call: `print` and `assert`.

use crate::context::{RuntimeError, codes};

crate::externs! {
    /// `print(String)`: hands one line to [`Context::print`](crate::Context::print). Whoever runs the program decides what
    /// becomes of it, so it may be called while nothing is solved.
    Scene fn calyx_std_print(context, line: String) -> () {
        (context.print)(&line);
        Ok(())
    }

    /// `assert(Bool, String)`: fails with E0705 and the message if the condition is false.
    Pure fn calyx_std_assert(context, condition: bool, message: String) -> () {
        if condition {
            return Ok(());
        }
        let message = match message.as_str() {
            "" => "assertion failed".to_string(),
            _ => format!("assertion failed: {message}"),
        };
        let _ = context;
        Err(RuntimeError::new(codes::ASSERTION, message, ""))
    }
}
