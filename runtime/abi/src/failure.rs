//! `throw` and `catch`: conversions between the values of a program and errors.

use crate::call::Slot;
use crate::context::Context;
use crate::error::{Place, RuntimeError, codes};
use crate::heap::{HeapId, Object};
use crate::helpers::malformed;
use crate::limits::check_memory;
use std::sync::Arc;

/// Number of slots of the record `Error`: code, message, place, value, help.
pub const ERROR_SLOTS: usize = 5;

/// Creates the error that a program throws from the slots of an `Error`. Its location is
/// [`Context::place`]. `help` is the remedy if the record has none.
pub fn thrown(ctx: &Context, error: &[Slot], help: &str) -> RuntimeError {
    let &[code, message, origin, value, own_help] = error else {
        return malformed("an error of another form");
    };
    let texts = [code, message, origin, own_help].map(|text| ctx.heap.str(text));
    let [Some(code), Some(message), Some(origin), Some(own_help)] = texts else {
        return malformed("an error without text");
    };
    let code = if code.is_empty() { codes::THROWN } else { code };
    let help = if own_help.is_empty() { help } else { own_help };
    let mut error = RuntimeError::new(code, message, help);
    error.place = Some(ctx.place);
    error.details.origin = origin.into();
    error.details.value = Some(f64::from_bits(value)).filter(|value| !value.is_nan());
    // A program cannot create an error that its callers could not catch.
    if error.status() != crate::call::Status::Failed {
        error.code = codes::THROWN.into();
    }
    error
}

/// Takes the error that ended a statement, and stores it while it is handled.
///
/// # Errors
/// Internal if nothing failed; E0707 if caught errors take too much memory.
pub fn catch(ctx: &mut Context) -> Result<HeapId, RuntimeError> {
    // Discard the string that was under construction when the error arose.
    ctx.text.clear();
    let error = ctx.error.take().ok_or_else(|| malformed("a handler without an error"))?;
    let id = ctx.heap.insert(Object::Error(Arc::new(error)));
    check_memory(ctx)?;
    Ok(id)
}

/// Returns the slots of the `Error` that a handler receives.
///
/// # Errors
/// Internal if `caught` is not an error.
pub fn fields(ctx: &mut Context, caught: HeapId) -> Result<[Slot; ERROR_SLOTS], RuntimeError> {
    let error = error(ctx, caught)?;
    let place = match error.details.origin.as_str() {
        "" => error.place.map(|place| shown_place(ctx, place)).unwrap_or_default(),
        origin => origin.into(),
    };
    let texts = [&error.code, &error.message, &place, &error.help].map(|text| ctx.heap.string(text));
    check_memory(ctx)?;
    let [code, message, place, help] = texts;
    Ok([code, message, place, error.details.value.unwrap_or(f64::NAN).to_bits(), help])
}

/// Returns the error that a handler rethrows.
pub fn rethrown(ctx: &Context, caught: HeapId) -> RuntimeError {
    match error(ctx, caught) {
        Ok(error) => (*error).clone(),
        Err(error) => error,
    }
}

fn error(ctx: &Context, id: HeapId) -> Result<Arc<RuntimeError>, RuntimeError> {
    match ctx.heap.get(id) {
        Some(Object::Error(error)) => Ok(error.clone()),
        _ => Err(malformed("no error")),
    }
}

/// Formats a location like `model.cx:3:7`; empty if the file is unknown.
pub fn shown_place(ctx: &Context, (file, start, _): Place) -> String {
    let Some(file) = ctx.files.get(file as usize) else { return String::new() };
    let before = file.text.get(..start as usize).unwrap_or_default();
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
    format!("{}:{line}:{column}", file.name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::FileDescription;

    #[test]
    fn a_caught_error_keeps_what_was_thrown() {
        let mut ctx = Context::new(Box::new(()));
        ctx.files = [FileDescription { name: "m.cx".into(), text: "var é;\nthrow;".into() }].into();
        ctx.place = (0, 8, 13);
        let texts = ["", "why", "", "wait"].map(|text| ctx.heap.string(text));
        let error = thrown(&ctx, &[texts[0], texts[1], texts[2], 2.5f64.to_bits(), texts[3]], "hurry");
        assert_eq!((error.code.as_str(), error.place), (codes::THROWN, Some((0, 8, 13))));
        assert_eq!(error.help, "wait");
        ctx.error = Some(error.clone());
        let caught = catch(&mut ctx).unwrap();
        let fields = fields(&mut ctx, caught).unwrap();
        let shown = [0, 1, 2, 4].map(|i| ctx.heap.str(fields[i]).unwrap().to_string());
        assert_eq!(shown, [codes::THROWN, "why", "m.cx:2:1", "wait"]);
        assert_eq!(f64::from_bits(fields[3]), 2.5);
        assert_eq!(rethrown(&ctx, caught), error);
        assert!(catch(&mut ctx).is_err());
    }

    #[test]
    fn a_program_cannot_throw_what_cannot_be_caught() {
        let mut ctx = Context::new(Box::new(()));
        let texts = [codes::CANCELLED, "why", "there", ""].map(|text| ctx.heap.string(text));
        let error = thrown(&ctx, &[texts[0], texts[1], texts[2], 0, texts[3]], "hurry");
        assert_eq!(error.help, "hurry");
        assert_eq!((error.code.as_str(), error.details.origin.as_str()), (codes::THROWN, "there"));
    }
}
