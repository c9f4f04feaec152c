//! NaN tracing: finds the operation that produced a NaN. A program that failed because of a NaN is
//! interpreted again, and every NaN carries the number of its operation in its payload bits. The
//! origin of a NaN is therefore available wherever the value occurs: in a variable, an array, an
//! argument or a captured value.

use super::{Interpreter, Machine};
use crate::kernels::trace_nan;
use crate::nan::{NanSource, operation_text};
use calyx_abi::{Heap, HeapId, Repr, Slot};
use calyx_lang::ir::{Op, SiteId};
use calyx_lang::span::Span;
use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A quiet NaN with a marked payload. Its low 32 bits are the number of its source.
const MARK: u64 = 0x7ffc_0000_0000_0000;
/// All bits except the sign, which negation changes, and the number of the source.
const MARKED: u64 = 0x7fff_ffff_0000_0000;

/// Sources of NaN found so far.
#[derive(Debug, Default)]
pub struct NanTrace {
    /// True if infinite results of operations on finite numbers become marked NaN, too.
    infinities: bool,
    state: Mutex<State>,
}

#[derive(Debug, Default)]
struct State {
    sources: Vec<NanSource>,
    /// The source of a NaN among the arguments of the last engine call.
    in_call: Option<u32>,
    /// The source of the last NaN that was compared with another number, such as a limit.
    compared: Option<u32>,
    /// The source of a NaN among the values that a site captured when it was last bound.
    captured: HashMap<u32, u32>,
}

impl NanTrace {
    /// Returns the source of the NaN that the last engine call received.
    pub fn in_call(&self) -> Option<NanSource> {
        let state = self.state();
        state.in_call.and_then(|id| state.sources.get(id as usize).cloned())
    }

    /// Returns the source of the last NaN that was compared with another number, or that the last
    /// engine call received.
    pub fn compared(&self) -> Option<NanSource> {
        let state = self.state();
        let id = state.compared.or(state.in_call)?;
        state.sources.get(id as usize).cloned()
    }

    /// Returns the source of the NaN that a site captured when it was last bound.
    pub fn captured(&self, site: SiteId) -> Option<NanSource> {
        let state = self.state();
        state.captured.get(&site.0).and_then(|id| state.sources.get(*id as usize).cloned())
    }

    /// Returns the source of a NaN that a traced program returned.
    pub fn source(&self, slot: Slot) -> Option<NanSource> {
        self.state().sources.get(number(slot)? as usize).cloned()
    }

    // A poisoned lock is ignored: an incomplete trace is still useful.
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn add(&self, source: NanSource) -> Slot {
        let mut state = self.state();
        state.sources.push(source);
        MARK | (state.sources.len() - 1) as u64
    }

    pub(super) fn literal(&self, slot: &mut Slot, span: Span) {
        if is_nan(*slot) {
            *slot = self.add(NanSource { span, made_by: None, input: None, equation: None });
        }
    }

    /// Marks a NaN in the result of an operation: with the mark of an operand, or a new mark.
    pub(super) fn operation(&self, op: Op, operands: &[Slot], result: &mut [Slot], span: Span) {
        if matches!(op, Op::Less | Op::LessEqual | Op::Greater | Op::GreaterEqual)
            && let Some(source) = operands.iter().find_map(|slot| number(*slot))
        {
            self.state().compared = Some(source);
        }
        if self.infinities && operands.iter().all(|slot| f64::from_bits(*slot).is_finite()) {
            let infinite = result.iter_mut().filter(|slot| f64::from_bits(**slot).is_infinite());
            infinite.for_each(|slot| *slot = f64::NAN.to_bits());
        }
        if !result.iter().any(|slot| is_nan(*slot)) {
            return;
        }
        let mark = operands.iter().copied().find(|slot| number(*slot).is_some()).unwrap_or_else(|| {
            let values: Vec<f64> = operands.iter().map(|slot| f64::from_bits(*slot)).collect();
            self.add(NanSource {
                span,
                made_by: Some(operation_text(op, &values)),
                input: None,
                equation: None,
            })
        });
        result.iter_mut().filter(|slot| is_nan(**slot)).for_each(|slot| *slot = mark);
    }

    /// Records a NaN among the arguments of an engine call.
    pub(super) fn call(&self, parameters: &[(String, Repr)], arguments: &[Slot], heap: &Heap) {
        let mut found = None;
        let mut at = 0;
        for (_, repr) in parameters {
            let slots = arguments.get(at..at + repr.slots()).unwrap_or_default();
            at += repr.slots();
            found = found.or_else(|| marked(repr, slots, heap));
        }
        self.state().in_call = found;
    }

    pub(super) fn capture(&self, site: SiteId, captured: &[Slot]) {
        if let Some(id) = captured.iter().find_map(|slot| number(*slot)) {
            self.state().captured.insert(site.0, id);
        }
    }
}

impl Interpreter<'_> {
    /// Enables NaN tracing; see [`Interpreter::trace`].
    pub fn tracing(mut self) -> Self {
        self.trace = Some(NanTrace::default());
        self
    }

    /// As [`Interpreter::tracing`], and traces infinite results of operations on finite numbers in
    /// the same way. The program computes with NaN in their place.
    pub fn tracing_infinities(mut self) -> Self {
        self.trace = Some(NanTrace { infinities: true, ..NanTrace::default() });
        self
    }

    /// Returns the trace, if tracing is enabled.
    pub fn trace(&self) -> Option<&NanTrace> {
        self.trace.as_ref()
    }
}

impl Machine<'_, '_> {
    pub(super) fn trace(&self, work: impl FnOnce(&NanTrace)) {
        if let Some(trace) = &self.interpreter.trace {
            work(trace);
        }
    }

    /// Marks a NaN in the value of a symbolic expression, which its kernel has stored on the stack
    /// from `start` on.
    pub(super) fn trace_symbolic(&mut self, id: HeapId, time: f64, start: usize) {
        let Some(trace) = &self.interpreter.trace else { return };
        let Some(value) = self.ctx.heap.symbolic(id) else { return };
        if !self.stack[start..].iter().any(|slot| is_nan(*slot)) {
            return;
        }
        let captured = value.captured.iter().map(|held| held.to_bits()).find(|held| number(*held).is_some());
        let mark = captured.or_else(|| {
            let inputs: Vec<f64> =
                [time].iter().chain(&self.ctx.params).chain(&value.captured).copied().collect();
            Some(trace.add(trace_nan(self.interpreter.program, SiteId(value.site as u32), &inputs)?))
        });
        if let Some(mark) = mark {
            self.stack[start..].iter_mut().filter(|slot| is_nan(**slot)).for_each(|slot| *slot = mark);
        }
    }
}

fn is_nan(slot: Slot) -> bool {
    f64::from_bits(slot).is_nan()
}

/// Returns the number of a NaN's source if the NaN is marked.
fn number(slot: Slot) -> Option<u32> {
    (slot & MARKED == MARK).then_some(slot as u32)
}

/// Returns the first marked number in a value.
fn marked(repr: &Repr, slots: &[Slot], heap: &Heap) -> Option<u32> {
    match repr {
        Repr::Number | Repr::Vector | Repr::Transform => slots.iter().find_map(|slot| number(*slot)),
        Repr::Array(element) => {
            let (elements, stride) = heap.array(*slots.first()?)?;
            elements.chunks(stride.max(1)).find_map(|value| marked(element, value, heap))
        }
        // Such as an optional value, whose presence precedes it.
        Repr::Tuple(parts) => {
            let mut at = 0;
            parts.iter().find_map(|part| {
                let value = slots.get(at..at + part.slots()).unwrap_or_default();
                at += part.slots();
                marked(part, value, heap)
            })
        }
        _ => None,
    }
}
