//! Operations of programs besides arithmetic: arrays, strings, symbolic values.
//!
//! The interpreter calls these functions directly, machine code through [`crate::entry`]. So both
//! have the same behaviour and error messages.

use crate::call::{Extern, Repr, Slot, Status};
use crate::context::{Context, RuntimeError, codes};
use crate::display::Display;
use crate::heap::{HeapId, OBJECT, Object, SymbolicValue};
use crate::limits::{check_memory, request_memory};
use crate::newton;
use std::ops::Range;
use std::sync::Arc;

/// Returns the error of a slot that does not match its representation: a defect of the compiler.
pub fn malformed(what: &str) -> RuntimeError {
    RuntimeError::new(codes::INTERNAL, format!("internal error: {what}"), "please report it with the model")
}

/// Calls a function of the engine.
///
/// # Errors
/// Those of the function, located at the call ([`Context::place`]) unless they have a location.
pub fn call_extern(
    function: &Extern,
    ctx: &mut Context,
    arguments: &[Slot],
    result: &mut [Slot],
) -> Result<(), RuntimeError> {
    let expected: usize = function.params.iter().map(|(_, shape)| shape.slots()).sum();
    if arguments.len() != expected || result.len() != function.result.slots() {
        return Err(malformed(&format!("`{}` is called with the wrong number of slots", function.symbol)));
    }
    // SAFETY: the row guarantees a function of the calling convention with these numbers of slots,
    // checked above.
    let status = unsafe { (function.call)(ctx, arguments.as_ptr(), result.as_mut_ptr()) };
    outcome(ctx, status)
}

/// Converts a status to a result.
///
/// # Errors
/// [`Context::error`], if the status is not `Ok`.
pub fn outcome(ctx: &mut Context, status: i32) -> Result<(), RuntimeError> {
    if status == Status::Ok as i32 {
        return Ok(());
    }
    let mut error = ctx.error.take().unwrap_or_else(|| malformed("a function failed without saying why"));
    error.place.get_or_insert(ctx.place);
    Err(error)
}

/// Creates an array of elements of `stride` slots.
///
/// # Errors
/// E0707 if it takes too much memory.
pub fn new_array(ctx: &mut Context, stride: usize, slots: Vec<Slot>) -> Result<HeapId, RuntimeError> {
    request_memory(ctx, OBJECT + size_of_val(slots.as_slice()) as u64)?;
    Ok(ctx.heap.insert(Object::array(stride, slots)))
}

/// Creates a string.
///
/// # Errors
/// E0707 if it takes too much memory.
pub fn new_string(ctx: &mut Context, text: &str) -> Result<HeapId, RuntimeError> {
    request_memory(ctx, OBJECT + text.len() as u64)?;
    Ok(ctx.heap.string(text))
}

fn array(ctx: &Context, id: HeapId) -> Result<(&[Slot], usize), RuntimeError> {
    ctx.heap.array(id).ok_or_else(|| malformed("not an array"))
}

fn length(slots: usize, stride: usize) -> usize {
    slots.checked_div(stride).unwrap_or(0)
}

/// Returns the number of elements of an array.
///
/// # Errors
/// Internal if it is not an array.
pub fn array_length(ctx: &Context, id: HeapId) -> Result<f64, RuntimeError> {
    let (slots, stride) = array(ctx, id)?;
    Ok(length(slots.len(), stride) as f64)
}

/// Returns the slots of an element.
///
/// # Errors
/// E0701 if the index is not an integer from 0 to the length minus one.
pub fn element(ctx: &Context, id: HeapId, index: f64) -> Result<&[Slot], RuntimeError> {
    let (slots, stride) = array(ctx, id)?;
    let range = element_range(index, slots.len(), stride)?;
    Ok(&slots[range])
}

/// Returns the slots of an element for a change, which copies of the array do not see.
///
/// # Errors
/// As for [`element`]; E0707 if the array takes too much memory.
pub fn element_mut(ctx: &mut Context, id: HeapId, index: f64) -> Result<&mut [Slot], RuntimeError> {
    let (slots, stride) = array(ctx, id)?;
    let range = element_range(index, slots.len(), stride)?;
    let (slots, _) = ctx.heap.array_mut(id, &ctx.limits)?;
    Ok(&mut slots[range])
}

fn element_range(index: f64, slots: usize, stride: usize) -> Result<Range<usize>, RuntimeError> {
    let length = length(slots, stride);
    if index >= 0.0 && index < length as f64 && index.fract() == 0.0 {
        // The index is an integer below a length in memory, so the conversion is exact.
        let start = index as usize * stride;
        return Ok(start..start + stride);
    }
    let shown = crate::text::number(index);
    Err(if index.fract() != 0.0 || index.is_nan() {
        let help = "an index counts elements from 0; round() makes a number whole";
        RuntimeError::new(codes::INDEX, format!("the index {shown} is not a whole number"), help)
    } else {
        let elements = if length == 1 { "element" } else { "elements" };
        let help = match length {
            0 => "the array is empty".to_string(),
            _ => format!("indices go from 0 to {}", length - 1),
        };
        RuntimeError::new(codes::INDEX, format!("index {shown} of an array of {length} {elements}"), help)
    })
}

/// Appends an element to an array.
///
/// # Errors
/// Internal if it is not an array of such elements; E0707 if it takes too much memory.
pub fn push(ctx: &mut Context, id: HeapId, value: &[Slot]) -> Result<(), RuntimeError> {
    let (_, stride) = array(ctx, id)?;
    if value.len() != stride {
        return Err(malformed("an element of the wrong size"));
    }
    request_memory(ctx, size_of_val(value) as u64)?;
    let (slots, _) = ctx.heap.array_mut(id, &ctx.limits)?;
    slots.extend_from_slice(value);
    ctx.heap.grown(value.len());
    Ok(())
}

/// Replaces the arrays inside a value by copies.
///
/// # Errors
/// Internal if the slots do not contain such a value; E0707 if it takes too much memory.
pub fn copy(ctx: &mut Context, repr: &Repr, slots: &mut [Slot]) -> Result<(), RuntimeError> {
    ctx.heap.copy_value(slots, repr, &ctx.limits)
}

/// Appends text to the string under construction ([`Context::text`]).
///
/// # Errors
/// E0707 if it takes too much memory.
pub fn append_text(ctx: &mut Context, text: &str) -> Result<(), RuntimeError> {
    request_memory(ctx, text.len() as u64)?;
    ctx.text.push_str(text);
    Ok(())
}

/// Appends a value to the string under construction ([`Context::text`]).
///
/// # Errors
/// Internal if the slots do not contain such a value; E0707 if its text takes too much memory.
pub fn append_value(
    ctx: &mut Context,
    repr: &Repr,
    slots: &[Slot],
    display: &Display,
) -> Result<(), RuntimeError> {
    let others = ctx.heap.bytes().saturating_add(ctx.kept_output);
    let limits = ctx.limits;
    let room = |length: usize| limits.check_memory(others.saturating_add(length as u64));
    let mut text = crate::text::BoundedText::new(&mut ctx.text, &room);
    text.append(&ctx.heap, repr, slots, display)
}

/// Creates a string from the text under construction and clears the text.
///
/// # Errors
/// E0707 if it takes too much memory.
pub fn finish_text(ctx: &mut Context) -> Result<HeapId, RuntimeError> {
    // The string is a copy of the text.
    request_memory(ctx, OBJECT + ctx.text.len() as u64)?;
    let text = std::mem::take(&mut ctx.text);
    Ok(ctx.heap.string(&text))
}

/// Compares two values: numbers as in IEEE 754, others by content.
///
/// # Errors
/// Internal if the slots do not contain such values.
pub fn equal(ctx: &Context, repr: &Repr, a: &[Slot], b: &[Slot]) -> Result<bool, RuntimeError> {
    equal_values(ctx, repr, a, b).ok_or_else(|| malformed("not values that can be compared"))
}

/// Returns whether a string has this text.
///
/// # Errors
/// Internal if it is not a string.
pub fn has_text(ctx: &Context, id: HeapId, text: &str) -> Result<bool, RuntimeError> {
    let own = ctx.heap.str(id).ok_or_else(|| malformed("not values that can be compared"))?;
    Ok(own == text)
}

fn equal_values(ctx: &Context, repr: &Repr, a: &[Slot], b: &[Slot]) -> Option<bool> {
    let numbers = |count| Some((0..count).all(|i| f64::from_bits(a[i]) == f64::from_bits(b[i])));
    if a.len() < repr.slots() || b.len() < repr.slots() {
        return None;
    }
    match repr {
        Repr::Unit => Some(true),
        Repr::Number | Repr::Vector | Repr::Transform => numbers(repr.slots()),
        Repr::Bool | Repr::Handle | Repr::Symbolic(_) => Some(a[0] == b[0]),
        Repr::String => Some(ctx.heap.str(a[0])? == ctx.heap.str(b[0])?),
        Repr::Array(element) => {
            let ((a, stride), (b, _)) = (ctx.heap.array(a[0])?, ctx.heap.array(b[0])?);
            if a.len() != b.len() {
                return Some(false);
            }
            let stride = stride.max(1);
            for (a, b) in a.chunks(stride).zip(b.chunks(stride)) {
                if !equal_values(ctx, element, a, b)? {
                    return Some(false);
                }
            }
            Some(true)
        }
        Repr::Tuple(parts) => {
            let mut at = 0;
            for part in parts {
                if !equal_values(ctx, part, &a[at..], &b[at..])? {
                    return Some(false);
                }
                at += part.slots();
            }
            Some(true)
        }
    }
}

/// Conversion of a captured slot to a number of [`SymbolicValue::captured`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum CaptureKind {
    /// Bits of a number.
    Number = 0,
    /// 0 or 1.
    Bool = 1,
    /// Index of an observable of the engine, or heap id of one that the program computed.
    Observable = 2,
    /// Heap id of a symbolic value.
    Part = 3,
}

impl CaptureKind {
    /// Returns `true` for the byte of a kind whose slots may be those of symbolic values.
    fn is_symbolic(kind: u8) -> bool {
        kind == CaptureKind::Observable as u8 || kind == CaptureKind::Part as u8
    }

    /// Returns the kinds of the slots of one capture.
    pub fn of_slots(repr: &Repr, observable: bool) -> impl Iterator<Item = CaptureKind> {
        let mut kinds = Vec::with_capacity(repr.slots());
        let mut pending = vec![repr];
        while let Some(repr) = pending.pop() {
            let kind = match repr {
                _ if observable => CaptureKind::Observable,
                Repr::Tuple(parts) => {
                    pending.extend(parts.iter().rev());
                    continue;
                }
                Repr::Symbolic(_) => CaptureKind::Part,
                // No expression reads the identifiers of texts and handles in a record.
                Repr::Bool | Repr::String | Repr::Handle | Repr::Array(_) => CaptureKind::Bool,
                _ => CaptureKind::Number,
            };
            kinds.extend(std::iter::repeat_n(kind, repr.slots()));
        }
        kinds.into_iter()
    }
}

/// Returns `true` if no capture is symbolic. `kinds` contains [`CaptureKind`]s as bytes.
pub fn are_plain(kinds: &[u8]) -> bool {
    !kinds.iter().any(|kind| CaptureKind::is_symbolic(*kind))
}

/// Maximum nesting depth of captured expressions.
const MOST_PARTS: usize = 1000;

/// Executes a `:=`: creates a symbolic value of the site with the captured slots. `kinds` contains
/// [`CaptureKind`]s as bytes.
///
/// # Errors
/// Internal if the module has no kernel for the site.
pub fn make_symbolic(
    ctx: &mut Context,
    site: usize,
    repr: Repr,
    kinds: &[u8],
    slots: &[Slot],
) -> Result<HeapId, RuntimeError> {
    let kernel = ctx.kernels.get(site).cloned().ok_or_else(|| malformed("a symbolic site without kernel"))?;
    let is = |index: usize, kind: CaptureKind| kinds.get(index) == Some(&(kind as u8));
    let captured = slots.iter().enumerate().map(|(index, &slot)| {
        if is(index, CaptureKind::Number) { f64::from_bits(slot) } else { slot as f64 }
    });
    let captured = captured.collect();
    let (mut observables, mut parts) = (Vec::new(), Vec::new());
    for (index, &slot) in slots.iter().enumerate() {
        let observable = is(index, CaptureKind::Observable);
        if !observable && !is(index, CaptureKind::Part) {
            continue;
        }
        match ctx.heap.symbolic(slot) {
            Some(part) => parts.push((index, part)),
            None if observable => observables.push(index),
            None => return Err(malformed("not a symbolic value")),
        }
    }
    let value = SymbolicValue::new(site, repr, kernel, captured, observables, parts);
    if value.depth() > MOST_PARTS {
        return Err(RuntimeError::new(
            codes::DEPTH,
            format!("an expression is built of more than {MOST_PARTS} others one inside another"),
            "look for a loop that binds a `:=` name again without end",
        ));
    }
    let id = ctx.heap.insert(Object::Symbolic(Arc::new(value)));
    check_memory(ctx)?;
    Ok(id)
}

/// Evaluates a symbolic value at a time with the present params, without its derivatives. Brackets,
/// which are a tuple in the symbolic value, become arrays where `repr` has arrays.
///
/// # Errors
/// E0706 if it depends on an observable; E0863 if the iteration of an implicit function does not
/// converge; internal if `id` is not a symbolic value of this size.
pub fn eval_symbolic(
    ctx: &mut Context,
    id: HeapId,
    time: f64,
    repr: &Repr,
    result: &mut [Slot],
) -> Result<(), RuntimeError> {
    let value = ctx.heap.symbolic(id).ok_or_else(|| malformed("not a symbolic value"))?;
    if !value.observes().is_empty() {
        return Err(RuntimeError::new(
            codes::OBSERVABLE,
            "an observable has no value before the analysis has run",
            "make it an `output`, which is evaluated at every step",
        ));
    }
    let failures = newton::failures();
    let outputs = value.evaluate(time, &ctx.params, &|_| f64::NAN);
    let outputs = outputs.ok_or_else(|| malformed("a kernel of another size"))?;
    check_solutions(failures, &outputs)?;
    pack_all(ctx, (&value.repr, repr), &outputs, result)
}

/// Executes a `:=` and evaluates it at a time with the present params, without its derivatives: as
/// [`make_symbolic`] and [`eval_symbolic`], but without a symbolic value, unless captures are
/// symbolic. `kinds` contains [`CaptureKind`]s as bytes. `reprs` are the representations of the
/// site and of the result; `None` if they are equal and consist of numbers.
///
/// # Errors
/// As for [`make_symbolic`] and [`eval_symbolic`].
pub fn evaluate_site(
    ctx: &mut Context,
    site: usize,
    (kinds, captured): (&[u8], &[Slot]),
    time: f64,
    reprs: Option<(&Repr, &Repr)>,
    result: &mut [Slot],
) -> Result<(), RuntimeError> {
    if let Some((from, to)) = reprs.filter(|_| !are_plain(kinds)) {
        let id = make_symbolic(ctx, site, from.clone(), kinds, captured)?;
        return eval_symbolic(ctx, id, time, to, result);
    }
    let kernel = ctx.kernels.get(site).cloned().ok_or_else(|| malformed("a symbolic site without kernel"))?;
    let mut numbers = std::mem::take(&mut ctx.numbers);
    numbers.clear();
    numbers.push(time);
    numbers.extend_from_slice(&ctx.params);
    numbers.extend(captured.iter().zip(kinds).map(|(&slot, &kind)| {
        if kind == CaptureKind::Number as u8 { f64::from_bits(slot) } else { slot as f64 }
    }));
    let inputs = numbers.len();
    numbers.resize(inputs + kernel.outputs(), f64::NAN);
    let (inputs, outputs) = numbers.split_at_mut(inputs);
    if inputs.len() != kernel.inputs() || outputs.len() < result.len() {
        return Err(malformed("a kernel of another size"));
    }
    let failures = newton::failures();
    kernel.eval(inputs, outputs);
    check_solutions(failures, outputs)?;
    match reprs {
        None => result.iter_mut().zip(&*outputs).for_each(|(slot, output)| *slot = output.to_bits()),
        Some(reprs) => pack_all(ctx, reprs, outputs, result)?,
    }
    ctx.numbers = numbers;
    Ok(())
}

/// Checks the outputs of a kernel. `before` are the failures of iterations before its evaluation.
///
/// # Errors
/// E0863 if the iteration of an implicit function did not converge.
fn check_solutions(before: newton::Failures, outputs: &[f64]) -> Result<(), RuntimeError> {
    let failed = newton::failures();
    // The arm of a conditional expression that is not selected may have no solution.
    if failed == before || !outputs.iter().any(|output| output.is_nan()) {
        return Ok(());
    }
    Err(match failed.minima == before.minima {
        true => RuntimeError::new(
            codes::NO_SOLUTION,
            "an equation has no solution near the guess of `solve`",
            "choose a guess closer to the solution, and check that the equation has one for these values",
        ),
        false => RuntimeError::new(
            codes::NO_SOLUTION,
            "a function has no minimum near the guess of `minimize`",
            "choose a guess where the function is convex, and check that it has a minimum for these values",
        ),
    })
}

/// Stores a kernel's numbers in the slots of a result, see [`pack`].
fn pack_all(
    ctx: &mut Context,
    (from, to): (&Repr, &Repr),
    outputs: &[f64],
    result: &mut [Slot],
) -> Result<(), RuntimeError> {
    let mut slots = Vec::with_capacity(result.len());
    pack(ctx, from, to, &mut outputs.iter().copied(), &mut slots)?;
    if slots.len() != result.len() {
        return Err(malformed("a kernel of another size"));
    }
    result.copy_from_slice(&slots);
    Ok(())
}

/// Stores a kernel's numbers in slots: `from` is the representation of the kernel, `to` that of the
/// program.
fn pack(
    ctx: &mut Context,
    from: &Repr,
    to: &Repr,
    numbers: &mut impl Iterator<Item = f64>,
    slots: &mut Vec<Slot>,
) -> Result<(), RuntimeError> {
    let mut next = || numbers.next().ok_or_else(|| malformed("a kernel of another size"));
    match (from, to) {
        (Repr::Tuple(parts), Repr::Array(element)) => {
            let mut elements = Vec::new();
            for part in parts {
                pack(ctx, part, element, numbers, &mut elements)?;
            }
            slots.push(new_array(ctx, element.slots(), elements)?);
        }
        (Repr::Tuple(parts), Repr::Tuple(wanted)) if parts.len() == wanted.len() => {
            for (part, wanted) in parts.iter().zip(wanted) {
                pack(ctx, part, wanted, numbers, slots)?;
            }
        }
        (Repr::Bool, Repr::Bool) => slots.push(u64::from(next()? != 0.0)),
        _ => {
            for _ in 0..from.slots() {
                slots.push(next()?.to_bits());
            }
        }
    }
    Ok(())
}

/// Reads the slots of a param; `offset` is the number of slots of the params before it.
///
/// # Errors
/// Internal if the params have not been set.
pub fn param(ctx: &Context, offset: usize, result: &mut [Slot]) -> Result<(), RuntimeError> {
    let slots = ctx
        .param_slots
        .get(offset..offset + result.len())
        .ok_or_else(|| malformed("a param without value"))?;
    result.copy_from_slice(slots);
    Ok(())
}

/// Returns the placeholder for the result of a function that was not called: zeros, an empty
/// string, an empty array.
pub fn zero_value(ctx: &mut Context, repr: &Repr) -> Vec<Slot> {
    match repr {
        Repr::String => vec![ctx.heap.string("")],
        Repr::Array(element) => {
            vec![ctx.heap.insert(Object::array(element.slots(), Vec::new()))]
        }
        Repr::Tuple(parts) => parts.iter().flat_map(|part| zero_value(ctx, part)).collect(),
        _ => vec![0; repr.slots()],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_whole_and_within_bounds() {
        let mut ctx = Context::new(Box::new(()));
        let id = new_array(&mut ctx, 2, vec![1, 2, 3, 4]).unwrap();
        assert_eq!(element(&ctx, id, 1.0).unwrap(), [3, 4]);
        assert_eq!(element(&ctx, id, -0.0).unwrap(), [1, 2]);
        for bad in [-1.0, 2.0, 0.5, f64::NAN, f64::INFINITY, 1e300] {
            assert_eq!(element(&ctx, id, bad).unwrap_err().code, codes::INDEX, "{bad}");
        }
    }

    #[test]
    fn equality_goes_by_content() {
        let mut ctx = Context::new(Box::new(()));
        let strings = |ctx: &mut Context| {
            let elements = vec![ctx.heap.string("a"), ctx.heap.string("b")];
            new_array(ctx, 1, elements).unwrap()
        };
        let (a, b) = (strings(&mut ctx), strings(&mut ctx));
        let repr = Repr::Array(Box::new(Repr::String));
        assert!(equal(&ctx, &repr, &[a], &[b]).unwrap());
        let c = ctx.heap.string("c");
        push(&mut ctx, b, &[c]).unwrap();
        assert!(!equal(&ctx, &repr, &[a], &[b]).unwrap());
        assert!(!equal(&ctx, &Repr::Number, &[f64::NAN.to_bits()], &[f64::NAN.to_bits()]).unwrap());
        assert!(equal(&ctx, &Repr::Number, &[f64::NAN.to_bits()], &[]).is_err());
    }
}
