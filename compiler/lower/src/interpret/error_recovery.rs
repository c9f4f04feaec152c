//! Continues after a failed library call, so that `check` reports all faulty gears instead of only
//! the first one.
//!
//! The failed call returns a poisoned handle. Calls that receive a poisoned handle are skipped
//! silently, because their errors would follow from the reported one.

use super::{Interpreter, Machine};
use calyx_abi::context::{Context, RuntimeError};
use calyx_abi::description::LIBRARY;
use calyx_abi::error::{Call, Place};
use calyx_abi::{HeapId, Repr, Slot, helpers};
use calyx_lang::ir::{ExternId, Program};
use std::collections::HashSet;
use std::sync::Mutex;

/// An invalid handle.
const POISON: Slot = Slot::MAX;

/// Failures after which the program continued.
pub(super) type Failures = Mutex<Vec<RuntimeError>>;

impl<'p> Interpreter<'p> {
    /// Continues after library calls that report a problem of the model.
    pub fn recovering(mut self) -> Self {
        self.failures = Some(Failures::default());
        self
    }

    /// Returns the failures after which the program continued, in order.
    pub fn failures(&self) -> Vec<RuntimeError> {
        let failures = self.failures.as_ref().and_then(|failures| failures.lock().ok());
        failures.map(|failures| failures.clone()).unwrap_or_default()
    }
}

impl<'p> Machine<'_, 'p> {
    /// Records a failure and continues, if this is enabled, the model causes the failure, and the
    /// program does not catch it. Otherwise returns the error.
    pub(super) fn survive(&mut self, mut error: RuntimeError) -> Result<(), RuntimeError> {
        let failures = self.interpreter.failures.as_ref();
        let Some(failures) = failures.filter(|_| is_finding(&error) && self.guards == 0) else {
            return Err(error);
        };
        error.place.get_or_insert(self.ctx.place);
        error.details.calls.extend(self.calls_of_failure(error.place));
        if let Ok(mut failures) = failures.lock() {
            failures.push(error);
        }
        // Later lines may show the poisoned result, so they are not printed.
        self.ctx.print = Box::new(|_| {});
        Ok(())
    }

    /// Returns the active calls that the message of a failure needs, innermost first. In a
    /// component these are all calls, because the message names the instance. In the library they
    /// end with the call of the program, whose argument is at fault. Elsewhere there are none.
    fn calls_of_failure(&self, place: Option<Place>) -> Vec<Call> {
        let program = self.interpreter.program;
        let is_library = |place: Place| {
            program.files.get(place.0 as usize).is_some_and(|file| file.name.starts_with(LIBRARY))
        };
        let calls = self.calls.iter().rev().map(|(id, place)| Call {
            function: program.functions.get(id.0 as usize).map_or("", |f| &f.name).into(),
            place: *place,
        });
        let mut calls: Vec<Call> = calls.collect();
        if !calls.iter().any(|call| call.instance().is_some()) {
            let within = match place.is_some_and(is_library) {
                true => calls.iter().position(|call| !is_library(call.place)).map_or(0, |outer| outer + 1),
                false => 0,
            };
            calls.truncate(within);
        }
        calls
    }

    /// Returns the names and representations of an engine function's parameters.
    pub(super) fn extern_parameters(&self, id: ExternId) -> &'p [(String, Repr)] {
        let program: &'p Program = self.interpreter.program;
        program.externs.get(id.0 as usize).map_or(&[], |decl| decl.parameters.as_slice())
    }

    /// Returns `true` if the program continued after a failure.
    pub(super) fn has_failures(&self) -> bool {
        let failures = self.interpreter.failures.as_ref();
        failures.is_some_and(|failures| !failures.lock().is_ok_and(|failures| failures.is_empty()))
    }

    /// Returns `true` if an argument on the stack from `start` on results from a failed call.
    pub(super) fn is_poisoned(&self, id: ExternId, start: usize) -> bool {
        if !self.has_failures() {
            return false;
        }
        let mut at = start;
        self.extern_parameters(id).iter().any(|(_, repr)| {
            let slots = self.stack.get(at..at + repr.slots()).unwrap_or_default();
            at += repr.slots();
            poisoned(self.ctx, repr, slots)
        })
    }

    /// Replaces the arguments of a failed call by a poisoned result.
    pub(super) fn put_poison(&mut self, result: &Repr, start: usize) {
        let slots = match result {
            Repr::Handle | Repr::Symbolic(_) => vec![POISON],
            Repr::Number | Repr::Vector | Repr::Transform => vec![f64::NAN.to_bits(); result.slots()],
            _ => helpers::zero_value(self.ctx, result),
        };
        self.stack.truncate(start);
        self.stack.extend(slots);
    }
}

/// Returns `true` for findings about gears and scenes, `false` for errors of the program.
fn is_finding(error: &RuntimeError) -> bool {
    ["E06", "E080", "E0927", "E0928", "E0929", "E0930"].iter().any(|block| error.code.starts_with(block))
}

/// Returns `true` if a value contains a poisoned handle. A number computed from a poisoned handle
/// is NaN.
fn poisoned(ctx: &Context, repr: &Repr, slots: &[Slot]) -> bool {
    let is_nan = |slot: &Slot| f64::from_bits(*slot).is_nan();
    match repr {
        Repr::Handle => slots.contains(&POISON),
        Repr::Number | Repr::Vector | Repr::Transform => slots.iter().any(is_nan),
        Repr::Symbolic(_) => slots.iter().any(|slot| *slot == POISON || captures_poison(ctx, *slot)),
        Repr::Array(element) => slots.iter().any(|slot| {
            let Some((elements, stride)) = ctx.heap.array(*slot) else { return false };
            elements.chunks(stride.max(1)).any(|value| poisoned(ctx, element, value))
        }),
        _ => false,
    }
}

/// Checks captured values: an observable is captured as its index, a number as its value, an
/// expression with its own captures.
fn captures_poison(ctx: &Context, id: HeapId) -> bool {
    let Some(value) = ctx.heap.symbolic(id) else { return false };
    let (mut seen, mut rest) = (HashSet::new(), vec![&*value]);
    while let Some(value) = rest.pop() {
        if value.captured.iter().any(|held| held.is_nan() || *held == POISON as f64) {
            return true;
        }
        let parts = value.parts.iter().map(|(_, part)| part.as_ref());
        rest.extend(parts.filter(|part| seen.insert(std::ptr::from_ref(*part))));
    }
    false
}
