//! Functions that every program may call: `print`, `assert`, the check of `Rotate`, and the checks
//! of array elements against ranges and choices.

use crate::context::{RuntimeError, codes};
use crate::limits;

/// Start of the message of a failed assertion.
const FAILED: &str = "assertion failed";

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
            "" => FAILED.to_string(),
            // The message of another assertion, as `e.message` in a `catch`.
            repeated if repeated.strip_prefix(FAILED).is_some_and(|rest| rest.starts_with(':')) => message,
            _ => format!("{FAILED}: {message}"),
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

    /// Start of a range: returns an integer unchanged, and fails with E0851 for any other number.
    Pure fn calyx_std_range_start(context, start: f64) -> f64 {
        let _ = context;
        whole("the start of a range", start)
    }

    /// End of a range: returns an integer or infinity unchanged, and fails with E0851 for any other
    /// number.
    Pure fn calyx_std_range_end(context, end: f64) -> f64 {
        let _ = context;
        if end.is_infinite() { Ok(end) } else { whole("the end of a range", end) }
    }

    /// End of the slice `start .. end` of an array. Fails with E0852 unless 0 <= start <= end <=
    /// length.
    Pure fn calyx_std_slice_end(context, start: f64, end: f64, length: f64) -> f64 {
        let _ = context;
        whole("the start of a slice", start)?;
        whole("the end of a slice", end)?;
        if 0.0 <= start && start <= end && end <= length {
            return Ok(end);
        }
        let shown = crate::text::number;
        let message = format!(
            "the slice {} .. {} of an array of {}", shown(start), shown(end), elements(length)
        );
        let help = match start > end {
            true => "the start is not greater than the end".to_string(),
            false => format!("the limits lie between 0 and {}", shown(length)),
        };
        Err(RuntimeError::new(codes::SLICE, message, help))
    }

    /// Fails with E0853 unless two arrays that are added have the same length.
    Pure fn calyx_std_same_length(context, left: f64, right: f64) -> () {
        let _ = context;
        if left == right {
            return Ok(());
        }
        let shown = crate::text::number;
        let message =
            format!("an array of {} and one of {} cannot be added or subtracted", shown(left), elements(right));
        let help = "use arrays of the same length, or a slice of the longer one";
        Err(RuntimeError::new(codes::LENGTHS, message, help))
    }

    /// Registers the natural cubic spline through points, and returns the number of its table.
    /// Fails with E0864 if the abscissas do not ascend, for example.
    Pure fn calyx_std_spline_table(context, xs: Vec<f64>, ys: Vec<f64>) -> f64 {
        let bytes = 20 * size_of::<f64>() as u64 * xs.len() as u64;
        limits::request_memory(context, bytes)?;
        match crate::piecewise::natural_spline(&xs, &ys) {
            Some(table) => Ok(crate::piecewise::register(table)),
            None => {
                let help = "give as many ordinates as abscissas, in the order of ascending abscissas";
                Err(RuntimeError::new(codes::SPLINE, crate::piecewise::refusal(&xs, &ys), help))
            }
        }
    }

    /// The smallest number of an array. Fails with E0854 if the array is empty.
    Pure fn calyx_std_smallest(context, values: Vec<f64>) -> f64 {
        let _ = context;
        values.into_iter().reduce(crate::math::min).ok_or_else(|| empty("min"))
    }

    /// The largest number of an array. Fails with E0854 if the array is empty.
    Pure fn calyx_std_largest(context, values: Vec<f64>) -> f64 {
        let _ = context;
        values.into_iter().reduce(crate::math::max).ok_or_else(|| empty("max"))
    }

    /// Numbers in ascending order; NaN follows all others.
    Pure fn calyx_std_sorted(context, values: Vec<f64>) -> Vec<f64> {
        let _ = context;
        let mut values = values;
        values.sort_by(|a, b| a.is_nan().cmp(&b.is_nan()).then(a.total_cmp(b)));
        Ok(values)
    }

    /// Begins and ends the body of a component: sets the path of the instance that is being built.
    Scene fn calyx_std_instance(context, path: String) -> () {
        context.instance = path;
        Ok(())
    }
}

/// Returns an integer unchanged, or the error for any other number.
fn whole(what: &str, value: f64) -> Result<f64, RuntimeError> {
    if value.fract() == 0.0 {
        return Ok(value);
    }
    let shown = crate::text::number(value);
    let message = format!("{what} must be a whole number, not {shown}");
    Err(RuntimeError::new(codes::RANGE, message, "`round` makes a number whole"))
}

fn elements(count: f64) -> String {
    let noun = if count == 1.0 { "element" } else { "elements" };
    format!("{} {noun}", crate::text::number(count))
}

fn empty(function: &str) -> RuntimeError {
    let message = format!("`{function}` of an empty array");
    RuntimeError::new(codes::EMPTY, message, "test `len(array) > 0` before")
}

fn is_outside(value: f64, low: f64, high: f64, nan_passes: bool) -> bool {
    if value.is_nan() { !nan_passes } else { value < low || value > high }
}

fn index_of(position: Option<usize>) -> f64 {
    position.map_or(-1.0, |index| index as f64)
}
