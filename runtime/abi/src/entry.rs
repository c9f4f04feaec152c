//! Helpers as called by machine code: C linkage, words as arguments, a status as result, no panics.
//!
//! One table generates the functions, their link symbols (for object files) and the rows from which
//! the code generator declares them and the in-memory linker finds them.

use crate::call::{Slot, Status};
use crate::context::{Context, RuntimeError};
use crate::display::Display;
use crate::{failure, helpers, limits, repr_code, stack};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs the body of a function that generated code calls. Errors and panics become a status and
/// [`Context::error`], located at the present call unless the error has a location.
///
/// Every function of the calling convention ([`crate::SlotFn`]) should consist of one call of this.
///
/// # Safety
/// `ctx` must be valid and not aliased.
pub unsafe fn guarded(ctx: *mut Context, body: impl FnOnce(&mut Context) -> Result<(), RuntimeError>) -> i32 {
    // SAFETY: the caller guarantees a valid context without other users during the call.
    let ctx = unsafe { &mut *ctx };
    let result = catch_unwind(AssertUnwindSafe(|| body(ctx)));
    let Err(mut error) = result.unwrap_or_else(|payload| Err(stack::panicked(payload.as_ref()))) else {
        return Status::Ok as i32;
    };
    error.place.get_or_insert(ctx.place);
    let status = error.status();
    ctx.error = Some(error);
    status as i32
}

/// Helper for the code generator and the in-memory linker.
#[derive(Clone, Copy, Debug)]
pub struct EntryPoint {
    /// Link symbol.
    pub symbol: &'static str,
    /// Number of arguments after the context, one word each. The result is a status.
    pub arguments: usize,
    pub address: *const u8,
}

/// Returns the slots at an address from generated code.
///
/// # Safety
/// `count` slots must exist there and live for `'a`. Without slots, any address is valid.
unsafe fn slots<'a>(address: u64, count: u64) -> &'a [Slot] {
    if count == 0 {
        return &[];
    }
    // SAFETY: guaranteed by the caller.
    unsafe { std::slice::from_raw_parts(address as *const Slot, count as usize) }
}

/// Returns writable slots, like [`slots`].
///
/// # Safety
/// As for [`slots`]; nothing else may access them.
unsafe fn slots_mut<'a>(address: u64, count: u64) -> &'a mut [Slot] {
    if count == 0 {
        return &mut [];
    }
    // SAFETY: guaranteed by the caller.
    unsafe { std::slice::from_raw_parts_mut(address as *mut Slot, count as usize) }
}

/// Returns the bytes of a constant of generated code.
///
/// # Safety
/// As for [`slots`], in bytes.
unsafe fn bytes<'a>(address: u64, count: u64) -> &'a [u8] {
    if count == 0 {
        return &[];
    }
    // SAFETY: guaranteed by the caller.
    unsafe { std::slice::from_raw_parts(address as *const u8, count as usize) }
}

/// Returns the text of a constant of generated code.
///
/// # Safety
/// As for [`bytes`].
unsafe fn text<'a>(address: u64, count: u64) -> Result<&'a str, RuntimeError> {
    // SAFETY: guaranteed by the caller.
    std::str::from_utf8(unsafe { bytes(address, count) })
        .map_err(|_| helpers::malformed("text that is not UTF-8"))
}

/// Decodes a representation.
///
/// # Safety
/// As for [`bytes`].
unsafe fn repr(address: u64, count: u64) -> Result<crate::Repr, RuntimeError> {
    // SAFETY: guaranteed by the caller.
    let code = unsafe { bytes(address, count) };
    repr_code::decode(code).ok_or_else(|| helpers::malformed("an unknown representation"))
}

macro_rules! entry_points {
    ($(
        $(#[$doc:meta])*
        fn $symbol:ident($ctx:ident $(, $argument:ident)*) $body:block
    )+) => {
        $(
            $(#[$doc])*
            ///
            /// # Safety
            /// `ctx` must be valid and not aliased; addresses must point to the stated numbers of
            /// slots or bytes.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $symbol(ctx: *mut Context $(, $argument: u64)*) -> i32 {
                // SAFETY: the caller guarantees a valid context and valid addresses.
                unsafe { guarded(ctx, |$ctx| $body) }
            }
        )+

        /// Link symbol of every helper, with its number of arguments after the context.
        pub const ENTRY_SIGNATURES: &[(&str, usize)] =
            &[$((stringify!($symbol), <[&str]>::len(&[$(stringify!($argument)),*])),)+];

        /// Returns every helper that machine code may call.
        pub fn entry_points() -> Vec<EntryPoint> {
            vec![$(
                EntryPoint {
                    symbol: stringify!($symbol),
                    arguments: <[&str]>::len(&[$(stringify!($argument)),*]),
                    address: $symbol as *const u8,
                },
            )+]
        }
    };
}

entry_points! {
    /// Requests more basic blocks.
    fn calyx_refuel(ctx) { limits::refuel(ctx) }

    /// Fails because the maximum depth of calls is exceeded.
    fn calyx_too_deep(_ctx) { Err(limits::too_deep()) }

    /// Fails with the error whose slots are at `address`, with the remedy `help`.
    fn calyx_throw(ctx, address, help, help_count) {
        Err(failure::thrown(ctx, slots(address, failure::ERROR_SLOTS as u64), text(help, help_count)?))
    }

    /// Fails with a caught error.
    fn calyx_rethrow(ctx, caught) { Err(failure::rethrown(ctx, caught)) }

    /// Takes the error that a handler catches; stores its id in `result`.
    fn calyx_catch(ctx, result) {
        slots_mut(result, 1)[0] = failure::catch(ctx)?;
        Ok(())
    }

    /// Stores the fields of a caught error in the slots of `result`.
    fn calyx_caught(ctx, caught, result) {
        let fields = failure::fields(ctx, caught)?;
        slots_mut(result, fields.len() as u64).copy_from_slice(&fields);
        Ok(())
    }

    /// Records that the present error left a function that was called at a location. Fails with
    /// that error.
    fn calyx_passed(ctx, name, name_count, file, start, end) {
        let function = text(name, name_count)?;
        let mut error = ctx.error.take().ok_or_else(|| helpers::malformed("a failure without an error"))?;
        error.passed(function, (file as u32, start as u32, end as u32));
        Err(error)
    }

    /// Moves the present error to the argument that it names, if `arguments` contains its location
    /// ([`crate::blame`]). Fails with that error.
    fn calyx_blame(ctx, arguments, count) {
        let mut error = ctx.error.take().ok_or_else(|| helpers::malformed("a failure without an error"))?;
        crate::blame::blame(&mut error, bytes(arguments, count));
        Err(error)
    }

    /// Creates an array of `count` slots; stores its id in `result`.
    fn calyx_array_new(ctx, stride, address, count, result) {
        let elements = slots(address, count);
        limits::request_memory(ctx, size_of_val(elements) as u64)?;
        let elements = elements.to_vec();
        slots_mut(result, 1)[0] = helpers::new_array(ctx, stride as usize, elements)?;
        Ok(())
    }

    /// Stores the address of an element in `result`; it is valid until the next call of any
    /// function.
    fn calyx_array_element(ctx, array, index, result) {
        let element = helpers::element(ctx, array, f64::from_bits(index))?;
        slots_mut(result, 1)[0] = element.as_ptr() as u64;
        Ok(())
    }

    /// Stores the address of an element for a change in `result`; it is valid until the next call
    /// of any function.
    fn calyx_array_slot(ctx, array, index, result) {
        let element = helpers::element_mut(ctx, array, f64::from_bits(index))?;
        slots_mut(result, 1)[0] = element.as_mut_ptr() as u64;
        Ok(())
    }

    /// Stores the number of elements in `result`.
    fn calyx_array_length(ctx, array, result) {
        slots_mut(result, 1)[0] = helpers::array_length(ctx, array)?.to_bits();
        Ok(())
    }

    /// Appends an element of `count` slots.
    fn calyx_array_push(ctx, array, address, count) {
        helpers::push(ctx, array, slots(address, count))
    }

    /// Replaces the arrays in a value of `count` slots by copies.
    fn calyx_copy(ctx, repr_address, repr_count, address, count) {
        helpers::copy(ctx, &repr(repr_address, repr_count)?, slots_mut(address, count))
    }

    /// Appends text to the string under construction.
    fn calyx_text(ctx, address, count) {
        helpers::append_text(ctx, text(address, count)?)
    }

    /// Appends a value to the string under construction.
    fn calyx_text_value(ctx, repr_address, repr_count, address, count, display, display_count) {
        let repr = repr(repr_address, repr_count)?;
        let display = Display::decode(bytes(display, display_count));
        let display = display.ok_or_else(|| helpers::malformed("not the code of a display"))?;
        helpers::append_value(ctx, &repr, slots(address, count), &display)
    }

    /// Finishes the string under construction; stores its id in `result`.
    fn calyx_text_finish(ctx, result) {
        slots_mut(result, 1)[0] = helpers::finish_text(ctx)?;
        Ok(())
    }

    /// Compares two values of `count` slots; stores 1 or 0 in `result`.
    fn calyx_equal(ctx, repr_address, repr_count, a, b, count, result) {
        let equal = helpers::equal(ctx, &repr(repr_address, repr_count)?, slots(a, count), slots(b, count))?;
        slots_mut(result, 1)[0] = u64::from(equal);
        Ok(())
    }

    /// Compares a string with a text; stores 1 or 0 in `result`.
    fn calyx_has_text(ctx, string, address, count, result) {
        let equal = helpers::has_text(ctx, string, text(address, count)?)?;
        slots_mut(result, 1)[0] = u64::from(equal);
        Ok(())
    }

    /// Executes a `:=` with `count` captured slots and as many bytes with their kinds; stores its
    /// id in `result`.
    fn calyx_make_symbolic(ctx, site, repr_address, repr_count, kinds, address, count, result) {
        let repr = repr(repr_address, repr_count)?;
        let captured = slots(address, count);
        let id = helpers::make_symbolic(ctx, site as usize, repr, bytes(kinds, count), captured)?;
        slots_mut(result, 1)[0] = id;
        Ok(())
    }

    /// Evaluates a symbolic value at a time; stores its `count` slots in `result`.
    fn calyx_eval_symbolic(ctx, value, time, repr_address, repr_count, result, count) {
        let repr = repr(repr_address, repr_count)?;
        helpers::eval_symbolic(ctx, value, f64::from_bits(time), &repr, slots_mut(result, count))
    }

    /// Executes a `:=` with `count` captured slots and as many bytes with their kinds, and
    /// evaluates it at a time; stores its `result_count` slots in `result`. `from` is the
    /// representation of the site, `to` that of the result.
    fn calyx_evaluate_site(
        ctx, site, from, from_count, kinds, address, count, time, to, to_count, result, result_count
    ) {
        let (from_code, to_code) = (bytes(from, from_count), bytes(to, to_count));
        let captured = (bytes(kinds, count), slots(address, count));
        let (time, result) = (f64::from_bits(time), slots_mut(result, result_count));
        if from_code == to_code && repr_code::is_numbers(from_code) && helpers::are_plain(captured.0) {
            return helpers::evaluate_site(ctx, site as usize, captured, time, None, result);
        }
        let reprs = (repr(from, from_count)?, repr(to, to_count)?);
        helpers::evaluate_site(ctx, site as usize, captured, time, Some((&reprs.0, &reprs.1)), result)
    }

    /// Calls a host function with `count` slots of arguments if the embedding program provides it;
    /// stores the slots of its result in `result`, and in `provided` whether it was called.
    fn calyx_host(ctx, function, arguments, count, result, result_count, provided) {
        let (arguments, result) = (slots(arguments, count), slots_mut(result, result_count));
        let called = crate::host::ask(ctx, function as usize, arguments, result)?;
        slots_mut(provided, 1)[0] = u64::from(called);
        Ok(())
    }

    /// Stores the `count` slots of a param in `result`.
    fn calyx_param(ctx, offset, result, count) {
        helpers::param(ctx, offset as usize, slots_mut(result, count))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context::codes;

    #[test]
    fn panics_become_a_status_with_a_place() {
        let mut ctx = Context::new(Box::new(()));
        ctx.place = (1, 2, 3);
        // SAFETY: the context is a local variable.
        let status = unsafe { guarded(&mut ctx, |_| panic!("broken")) };
        assert_eq!(status, Status::Cancelled as i32);
        let error = ctx.error.unwrap();
        assert_eq!((error.code.as_str(), error.place), (codes::INTERNAL, Some((1, 2, 3))));
    }

    #[test]
    fn the_table_counts_arguments() {
        let table = entry_points();
        let arguments = |symbol| table.iter().find(|row| row.symbol == symbol).map(|row| row.arguments);
        assert_eq!(arguments("calyx_refuel"), Some(0));
        assert_eq!(arguments("calyx_array_element"), Some(3));
    }
}
