//! Functions that every program may call: `print`, `assert`, the check of `Rotate`, and the checks
//! of array elements against ranges and choices.

use crate::context::{RuntimeError, codes};
use crate::limits;

crate::externs! {
    /// `print(String)`: passes one line to [`Context::print`](crate::Context::print). The caller of
    /// the program decides about its use, so it may be called while nothing is solved.
    Scene fn calyx_std_print(context, line: String) -> () {
        if context.keeps_output {
            let bytes = (size_of::<String>() + line.len()) as u64;
            limits::request_memory(context, bytes)?;
            context.kept_output += bytes;
        }
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

    /// Check of the axis of a rotation: returns a unit vector unchanged, and fails with E0515 for
    /// any other.
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

    /// `first_outside(Array(Number), Number, Number, Bool)`: index of the first element outside a
    /// range, -1 if there is none. NaN is outside unless `nan_passes`.
    Pure fn calyx_std_first_outside(context, values: Vec<f64>, low: f64, high: f64, nan_passes: bool) -> f64 {
        let _ = context;
        Ok(index_of(values.iter().position(|&value| is_outside(value, low, high, nan_passes))))
    }

    /// Index of the first vector with a component outside a range, -1 if there is none.
    Pure fn calyx_std_first_vector_outside(
        context, values: Vec<[f64; 3]>, low: f64, high: f64, nan_passes: bool,
    ) -> f64 {
        let _ = context;
        let outside = |vector: &[f64; 3]| vector.iter().any(|&part| is_outside(part, low, high, nan_passes));
        Ok(index_of(values.iter().position(outside)))
    }

    /// `first_unknown(Array(String), Array(String))`: index of the first element that is not among
    /// the choices, -1 if there is none.
    Pure fn calyx_std_first_unknown(context, values: Vec<String>, choices: Vec<String>) -> f64 {
        let _ = context;
        Ok(index_of(values.iter().position(|value| !choices.contains(value))))
    }
}

fn is_outside(value: f64, low: f64, high: f64, nan_passes: bool) -> bool {
    if value.is_nan() { !nan_passes } else { value < low || value > high }
}

fn index_of(position: Option<usize>) -> f64 {
    position.map_or(-1.0, |index| index as f64)
}
