//! Functions every program may call: `print`, `assert`, and the check of `Rotate`.

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

    /// The axis of a rotation: hands back a unit vector, and fails with E0515 on any other.
    Pure fn calyx_std_unit_axis(context, axis: [f64; 3]) -> [f64; 3] {
        let _ = context;
        let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        if crate::math::is_unit(length) {
            return Ok(axis);
        }
        let help = match length > 0.0 {
            true => "divide the axis by its length: `axis / norm(axis)`",
            false => "give the axis a direction, such as `e3`",
        };
        let message = match length.is_nan() {
            true => "the axis of a rotation must be a unit vector, and this one is not a number".to_string(),
            false => format!("the axis of a rotation must be a unit vector, and this one has the length {length}"),
        };
        Err(RuntimeError::new(codes::AXIS, message, help))
    }
}
