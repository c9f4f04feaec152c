//! Reuse of the results of earlier calls of repeatable functions, also of earlier runs.
//!
//! A reused result leaves everything as the call would: values, the number of basic blocks that
//! remain, and the memory that the call took. Its arrays share no elements with copies that the
//! call made, so a later change of an array may take less memory. Calls that fail are always
//! executed.

use super::{Interpreter, Machine};
use crate::fingerprint::{Fingerprint, FingerprintHasher};
use crate::repeatable::{Repeatable, RepeatableFunctions};
use calyx_abi::context::{MAX_DEPTH, RuntimeError};
use calyx_abi::heap::Object;
use calyx_abi::{Heap, Repr, Slot, limits};
use calyx_lang::ir::{Function, FunctionId, Mode};
use std::hash::Hash;
use std::sync::Arc;

/// A call: the content of its function and of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CallContent(Fingerprint);

/// Results of earlier calls.
pub trait CallResults: Sync {
    /// Returns the result of an equal call.
    fn find(&self, call: CallContent) -> Option<Arc<CallResult>>;
    /// Stores the result of a call.
    fn store(&self, call: CallContent, result: CallResult);
}

/// The result of a call, and what the call took.
#[derive(Debug)]
pub struct CallResult {
    /// The result, and the values of `out` and `inout` parameters.
    values: Vec<Value>,
    /// Number of basic blocks that it entered.
    blocks: u64,
    /// Memory of the program's values, bytes.
    bytes: u64,
}

impl CallResult {
    /// Returns the approximate memory of the stored result, bytes.
    pub fn size(&self) -> usize {
        size_of::<Self>() + self.values.iter().map(Value::size).sum::<usize>()
    }
}

/// A value without references to a heap.
#[derive(Debug)]
enum Value {
    Slots(Box<[Slot]>),
    String(Arc<str>),
    Array(usize, Box<[Value]>),
    Tuple(Box<[Value]>),
}

impl Value {
    /// Copies a value out of a heap; `None` for slots that do not contain such a value.
    fn read(heap: &Heap, repr: &Repr, slots: &[Slot]) -> Option<Self> {
        Some(match repr {
            Repr::String => match heap.get(*slots.first()?)? {
                Object::String(text) => Value::String(text.clone()),
                _ => return None,
            },
            Repr::Array(element) => {
                let (slots, stride) = heap.array(*slots.first()?)?;
                if is_flat(element) {
                    return Some(Value::Array(stride, [Value::Slots(slots.into())].into()));
                }
                let elements = slots.chunks(stride.max(1));
                Value::Array(
                    stride,
                    elements.map(|slots| Value::read(heap, element, slots)).collect::<Option<_>>()?,
                )
            }
            Repr::Tuple(parts) if !is_flat(repr) => {
                let mut at = 0;
                let parts = parts.iter().map(|part| {
                    let value = Value::read(heap, part, slots.get(at..)?);
                    at += part.slots();
                    value
                });
                Value::Tuple(parts.collect::<Option<_>>()?)
            }
            _ => Value::Slots(slots.get(..repr.slots())?.into()),
        })
    }

    /// Appends the value's slots, with its texts and arrays as new objects of a heap.
    fn write(&self, heap: &mut Heap, slots: &mut Vec<Slot>) {
        match self {
            Value::Slots(values) => slots.extend_from_slice(values),
            Value::String(text) => slots.push(heap.insert(Object::String(text.clone()))),
            Value::Array(stride, elements) => {
                let mut own = Vec::new();
                elements.iter().for_each(|element| element.write(heap, &mut own));
                slots.push(heap.insert(Object::array(*stride, own)));
            }
            Value::Tuple(parts) => parts.iter().for_each(|part| part.write(heap, slots)),
        }
    }

    fn size(&self) -> usize {
        let content = match self {
            Value::Slots(slots) => size_of_val::<[Slot]>(slots),
            Value::String(text) => text.len(),
            Value::Array(_, parts) | Value::Tuple(parts) => parts.iter().map(Value::size).sum(),
        };
        size_of::<Self>() + content
    }
}

/// Returns `true` if values of a representation have no objects in the heap.
fn is_flat(repr: &Repr) -> bool {
    match repr {
        Repr::String | Repr::Array(_) | Repr::Symbolic(_) => false,
        Repr::Tuple(parts) => parts.iter().all(is_flat),
        _ => true,
    }
}

/// Adds a value by content; `None` for slots that do not contain such a value.
fn hash(heap: &Heap, repr: &Repr, slots: &[Slot], hasher: &mut FingerprintHasher) -> Option<()> {
    match repr {
        Repr::String => heap.str(*slots.first()?)?.hash(hasher),
        Repr::Array(element) => {
            let (slots, stride) = heap.array(*slots.first()?)?;
            if is_flat(element) {
                slots.hash(hasher);
            } else {
                slots.len().hash(hasher);
                slots.chunks(stride.max(1)).try_for_each(|slots| hash(heap, element, slots, hasher))?;
            }
        }
        Repr::Tuple(parts) if !is_flat(repr) => {
            let mut rest = slots;
            for part in parts {
                let (slots, after) = rest.split_at_checked(part.slots())?;
                hash(heap, part, slots, hasher)?;
                rest = after;
            }
        }
        _ => slots.get(..repr.slots())?.hash(hasher),
    }
    Some(())
}

/// Number of basic blocks from which a result is stored. Calls with fewer blocks take little more
/// time than finding their results.
const LEAST_BLOCKS: u64 = 200;

/// What the interpreter needs to reuse results.
pub(super) struct Reuse<'p> {
    results: &'p dyn CallResults,
    functions: &'p RepeatableFunctions,
}

impl<'p> Interpreter<'p> {
    /// Reuses results of equal calls, of this run and of others.
    pub fn reusing(mut self, results: &'p dyn CallResults, functions: &'p RepeatableFunctions) -> Self {
        self.reuse = Some(Reuse { results, functions });
        self
    }
}

impl<'p> Machine<'_, 'p> {
    /// Calls a function as [`Machine::call`] does, or reuses an earlier result.
    pub(super) fn call_or_reuse(&mut self, id: FunctionId, start: usize) -> Result<(), RuntimeError> {
        // Tracing marks NaN by the operations that produce it.
        let reuse = self.interpreter.reuse.as_ref().filter(|_| self.interpreter.trace.is_none());
        let Some((reuse, properties)) = reuse.and_then(|reuse| Some((reuse, reuse.functions.long(id)?)))
        else {
            return self.call(id, start);
        };
        let (function, _) = self.interpreter.function(id)?;
        let Some(content) = self.content_of(function, properties, start) else {
            return self.call(id, start);
        };
        if let Some(found) = reuse.results.find(content).filter(|found| self.affords(found)) {
            return self.put_result(&found, start);
        }
        let (blocks, bytes) = (self.remaining_blocks(), self.ctx.heap.bytes());
        self.call(id, start)?;
        let blocks = blocks.saturating_sub(self.remaining_blocks());
        if blocks < LEAST_BLOCKS || self.has_failures() {
            return Ok(());
        }
        let bytes = self.ctx.heap.bytes() - bytes;
        if let Some(values) = self.values_of(function, start) {
            reuse.results.store(content, CallResult { values, blocks, bytes });
        }
        Ok(())
    }

    /// Returns the content of a call whose arguments are the slots from `start` on; `None` if its
    /// result depends on more than the arguments.
    fn content_of(&self, function: &Function, properties: Repeatable, start: usize) -> Option<CallContent> {
        // Failures poison what follows from them.
        if self.has_failures() || self.ctx.depth + properties.depth >= MAX_DEPTH {
            return None;
        }
        let mut hasher = FingerprintHasher::default();
        properties.content.hash(&mut hasher);
        let mut rest = self.stack.get(start..)?;
        for (local, mode) in &function.parameters {
            if *mode != Mode::Out {
                let repr = &function.locals.get(local.0 as usize)?.repr;
                let (slots, after) = rest.split_at_checked(repr.slots())?;
                hash(&self.ctx.heap, repr, slots, &mut hasher)?;
                rest = after;
            }
        }
        Some(CallContent(hasher.fingerprint()))
    }

    /// Copies the results of a call, the slots from `start` on.
    fn values_of(&self, function: &Function, start: usize) -> Option<Vec<Value>> {
        let changed = function.parameters.iter().filter(|(_, mode)| *mode != Mode::In);
        let changed = changed.map(|(local, _)| Some(&function.locals.get(local.0 as usize)?.repr));
        let mut rest = self.stack.get(start..)?;
        let values = [Some(&function.result)].into_iter().chain(changed).map(|repr| {
            let (slots, after) = rest.split_at_checked(repr?.slots())?;
            rest = after;
            Value::read(&self.ctx.heap, repr?, slots)
        });
        values.collect()
    }

    /// Returns `true` if the call would have stayed within the limits.
    fn affords(&self, found: &CallResult) -> bool {
        self.remaining_blocks() >= found.blocks && limits::request_memory(self.ctx, found.bytes).is_ok()
    }

    /// Replaces the arguments by an earlier result.
    fn put_result(&mut self, found: &CallResult, start: usize) -> Result<(), RuntimeError> {
        limits::check(self.ctx)?;
        limits::spend(self.ctx, found.blocks);
        let before = self.ctx.heap.bytes();
        self.stack.truncate(start);
        found.values.iter().for_each(|value| value.write(&mut self.ctx.heap, &mut self.stack));
        let written = self.ctx.heap.bytes() - before;
        self.ctx.heap.charge(found.bytes.saturating_sub(written));
        Ok(())
    }

    fn remaining_blocks(&self) -> u64 {
        self.ctx.granted.saturating_add(self.ctx.fuel)
    }
}
