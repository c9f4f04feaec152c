//! Going on after a call of the library that failed, so that `check` reports every gear that is wrong and not the first.
//!
//! What the failed call should have made is a poisoned handle. Calls that are given one are passed over in silence: what
//! they would say follows from what has been said.

use super::{Interpreter, Machine};
use calyx_abi::context::{Context, RuntimeError};
use calyx_abi::{HeapId, Repr, Slot, helpers};
use calyx_lang::ir::{ExternId, Program};
use std::sync::Mutex;

/// A handle to nothing.
const POISON: Slot = Slot::MAX;

/// Failures survived so far.
pub(super) type Failures = Mutex<Vec<RuntimeError>>;

impl<'p> Interpreter<'p> {
    /// Goes on after calls of the library that find something wrong with the model.
    pub fn going_on(mut self) -> Self {
        self.failures = Some(Failures::default());
        self
    }

    /// What the program survived, in order.
    pub fn failures(&self) -> Vec<RuntimeError> {
        let failures = self.failures.as_ref().and_then(|failures| failures.lock().ok());
        failures.map(|failures| failures.clone()).unwrap_or_default()
    }
}

impl<'p> Machine<'_, 'p> {
    /// Notes a failure and goes on, where that is wanted, the failure is the model's, and the program does not catch it
    /// itself.
    pub(super) fn survive(&mut self, mut error: RuntimeError) -> Result<(), RuntimeError> {
        let failures = self.interpreter.failures.as_ref();
        let Some(failures) = failures.filter(|_| is_finding(&error) && self.guards == 0) else {
            return Err(error);
        };
        error.place.get_or_insert(self.ctx.place);
        if let Ok(mut failures) = failures.lock() {
            failures.push(error);
        }
        Ok(())
    }

    /// Names and representations of a provided function's parameters.
    pub(super) fn extern_parameters(&self, id: ExternId) -> &'p [(String, Repr)] {
        let program: &'p Program = self.interpreter.program;
        program.externs.get(id.0 as usize).map_or(&[], |decl| decl.parameters.as_slice())
    }

    /// Whether an argument on the stack from `start` on comes from a call that failed.
    pub(super) fn is_poisoned(&self, id: ExternId, start: usize) -> bool {
        let Some(failures) = &self.interpreter.failures else { return false };
        if failures.lock().is_ok_and(|failures| failures.is_empty()) {
            return false;
        }
        let mut at = start;
        self.extern_parameters(id).iter().any(|(_, repr)| {
            let slots = self.stack.get(at..at + repr.slots()).unwrap_or_default();
            at += repr.slots();
            poisoned(self.ctx, repr, slots)
        })
    }

    /// Puts what stands for the result of a failed call in place of its arguments.
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

/// Findings about gears and scenes; anything else is an error of the program.
fn is_finding(error: &RuntimeError) -> bool {
    ["E06", "E080"].iter().any(|block| error.code.starts_with(block))
}

/// A number that was computed from nothing is NaN, whatever else may be.
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

/// An observable is captured as its index, a number as itself.
fn captures_poison(ctx: &Context, id: HeapId) -> bool {
    let value = ctx.heap.symbolic(id);
    value.is_some_and(|value| value.captured.iter().any(|held| held.is_nan() || *held == POISON as f64))
}
