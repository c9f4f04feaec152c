//! Values that do not fit in slots: strings, arrays and symbolic values, owned by the running
//! instance.
//!
//! Arrays have value semantics: the program copies an array when it binds one that has another name
//! (the compiler inserts the copies). Nothing is freed before the instance ends, because models are
//! built once and are small.

use crate::call::{Repr, Slot};
use crate::error::{Call, RuntimeError};
use crate::helpers::malformed;
use crate::limits::Limits;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

/// Index into the [`Heap`].
pub type HeapId = u64;

/// Evaluator of a kernel. Machine code and the interpreter implement it with bitwise equal results.
pub trait Kernel: Send + Sync {
    /// Evaluates the kernel with `inputs` = `[Time, params..., captured...]`; `outputs.len()` =
    /// [`Kernel::outputs`].
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]);
    /// Returns the number of inputs.
    fn inputs(&self) -> usize;
    /// Returns the number of outputs: values, then first, then second time derivatives. If other
    /// kernels take them as inputs, also the same of the derivative by each param of
    /// differentiation. Per derivative order 1 for a number, 3 for a vector, 12 for a transform
    /// (rotation row by row, translation).
    fn outputs(&self) -> usize;
}

/// Symbolic value of a `:=` binding: the kernel of its site, and the values captured when the
/// binding executed.
#[derive(Clone)]
pub struct SymbolicValue {
    /// Index of the site in the module's kernel table.
    pub site: usize,
    /// Representation of its value: Number, Vector or Transform.
    pub repr: Repr,
    pub kernel: Arc<dyn Kernel>,
    /// Captured values as numbers, in the order of the site's captures. An observable is captured
    /// as its index and replaced by its value at each step (see [`SymbolicValue::observables`]).
    pub captured: Vec<f64>,
    /// Positions in `captured` of indices of observables.
    pub observables: Vec<usize>,
    /// Captured expressions, by their position in `captured`. The kernel takes all outputs of an
    /// expression's kernel as inputs.
    pub parts: Vec<(usize, Arc<SymbolicValue>)>,
    /// Nesting depth of expressions, including this one.
    depth: usize,
}

impl SymbolicValue {
    pub fn new(
        site: usize,
        repr: Repr,
        kernel: Arc<dyn Kernel>,
        captured: Vec<f64>,
        observables: Vec<usize>,
        parts: Vec<(usize, Arc<SymbolicValue>)>,
    ) -> Self {
        let depth = 1 + parts.iter().map(|(_, part)| part.depth).max().unwrap_or(0);
        SymbolicValue { site, repr, kernel, captured, observables, parts, depth }
    }

    /// Returns the nesting depth of captured expressions, including this one.
    pub fn depth(&self) -> usize {
        self.depth
    }

    /// Evaluates its kernel. `observed` returns the value of an observable by index. `None` if the
    /// kernel has other inputs.
    pub fn evaluate(&self, time: f64, params: &[f64], observed: &dyn Fn(usize) -> f64) -> Option<Vec<f64>> {
        let inputs = self.inputs(time, params, observed)?;
        Some(self.outputs(&inputs))
    }

    /// Returns the indices of the observables that it depends on, directly or through captured
    /// expressions.
    pub fn observes(&self) -> BTreeSet<usize> {
        let (mut found, mut seen) = (BTreeSet::new(), HashSet::new());
        let mut rest = vec![self];
        while let Some(value) = rest.pop() {
            let positions = value.observables.iter();
            found.extend(positions.filter_map(|&at| value.captured.get(at)).map(|&index| index as usize));
            let parts = value.parts.iter().map(|(_, part)| part.as_ref());
            rest.extend(parts.filter(|&part| seen.insert(std::ptr::from_ref(part))));
        }
        found
    }

    /// Returns the kernel's inputs: time, params, then captured values, with the outputs of its
    /// kernel for each expression.
    pub fn inputs(&self, time: f64, params: &[f64], observed: &dyn Fn(usize) -> f64) -> Option<Vec<f64>> {
        self.inputs_with(time, params, observed, &mut HashMap::new())
    }

    fn inputs_with(
        &self,
        time: f64,
        params: &[f64],
        observed: &dyn Fn(usize) -> f64,
        known: &mut HashMap<*const SymbolicValue, Vec<f64>>,
    ) -> Option<Vec<f64>> {
        let mut inputs = Vec::with_capacity(self.kernel.inputs());
        inputs.push(time);
        inputs.extend_from_slice(params);
        for (position, &captured) in self.captured.iter().enumerate() {
            if let Some((_, part)) = self.parts.iter().find(|(at, _)| *at == position) {
                // An expression that several others capture is evaluated once.
                if !known.contains_key(&Arc::as_ptr(part)) {
                    let below = part.inputs_with(time, params, observed, known)?;
                    known.insert(Arc::as_ptr(part), part.outputs(&below));
                }
                inputs.extend(known.get(&Arc::as_ptr(part))?);
            } else if self.observables.contains(&position) {
                inputs.push(observed(captured as usize));
            } else {
                inputs.push(captured);
            }
        }
        (inputs.len() == self.kernel.inputs()).then_some(inputs)
    }

    fn outputs(&self, inputs: &[f64]) -> Vec<f64> {
        let mut outputs = vec![f64::NAN; self.kernel.outputs()];
        self.kernel.eval(inputs, &mut outputs);
        outputs
    }
}

/// Heap object.
#[derive(Clone)]
pub enum Object {
    String(Arc<str>),
    /// Flat slots of the elements, `stride` slots each.
    Array {
        stride: usize,
        slots: Vec<Slot>,
    },
    Symbolic(Arc<SymbolicValue>),
    /// Caught error.
    Error(Arc<RuntimeError>),
}

impl Object {
    /// Returns its approximate size, bytes.
    fn bytes(&self) -> u64 {
        let content = match self {
            Object::String(text) => text.len(),
            Object::Array { slots, .. } => size_of_val(slots.as_slice()),
            Object::Symbolic(value) => {
                let lists = size_of_val(value.captured.as_slice())
                    + size_of_val(value.observables.as_slice())
                    + size_of_val(value.parts.as_slice());
                size_of::<SymbolicValue>() + lists
            }
            Object::Error(error) => {
                let calls = error.details.calls.len() * size_of::<Call>();
                size_of::<RuntimeError>() + error.message.len() + error.help.len() + calls
            }
        };
        OBJECT + content as u64
    }
}

/// Memory overhead of an object, bytes: its entry in the heap, and the overhead of an allocation.
pub const OBJECT: u64 = size_of::<Object>() as u64 + 32;

/// Heap objects of an instance.
#[derive(Default)]
pub struct Heap {
    objects: Vec<Object>,
    bytes: u64,
}

impl Heap {
    pub fn insert(&mut self, object: Object) -> HeapId {
        self.bytes += object.bytes();
        self.objects.push(object);
        (self.objects.len() - 1) as HeapId
    }

    /// Returns the approximate memory of all objects, bytes.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Accounts for slots that were appended to an object.
    pub fn grown(&mut self, slots: usize) {
        self.bytes += (slots * size_of::<Slot>()) as u64;
    }

    pub fn get(&self, id: HeapId) -> Option<&Object> {
        self.objects.get(usize::try_from(id).ok()?)
    }

    pub fn get_mut(&mut self, id: HeapId) -> Option<&mut Object> {
        self.objects.get_mut(usize::try_from(id).ok()?)
    }

    pub fn string(&mut self, text: &str) -> HeapId {
        self.insert(Object::String(text.into()))
    }

    pub fn str(&self, id: HeapId) -> Option<&str> {
        match self.get(id)? {
            Object::String(text) => Some(text),
            _ => None,
        }
    }

    /// Returns the flat slots of an array and its stride.
    pub fn array(&self, id: HeapId) -> Option<(&[Slot], usize)> {
        match self.get(id)? {
            Object::Array { stride, slots } => Some((slots, *stride)),
            _ => None,
        }
    }

    /// Returns the elements of an array of numbers.
    pub fn numbers(&self, id: HeapId) -> Option<Vec<f64>> {
        let (slots, _) = self.array(id)?;
        Some(slots.iter().map(|&s| f64::from_bits(s)).collect())
    }

    pub fn symbolic(&self, id: HeapId) -> Option<Arc<SymbolicValue>> {
        match self.get(id)? {
            Object::Symbolic(value) => Some(value.clone()),
            _ => None,
        }
    }

    /// Makes a deep copy of an array. `element` is the element's representation.
    ///
    /// # Errors
    /// E0707 before the memory exceeds the limit; internal if the slots do not fit the
    /// representation.
    pub fn copy_array(
        &mut self,
        id: HeapId,
        element: &Repr,
        limits: &Limits,
    ) -> Result<HeapId, RuntimeError> {
        let (slots, stride) = self.array(id).ok_or_else(not_copied)?;
        limits.check_memory(self.bytes + OBJECT + size_of_val(slots) as u64)?;
        let slots = slots.to_vec();
        let stride_of_parts = if contains_array(element) { stride } else { 0 };
        // Insert the copy before its elements are copied, so that all its memory counts.
        let copy = self.insert(Object::Array { stride, slots });
        if stride_of_parts > 0 {
            let mut slots = self.take_slots(copy);
            let copied =
                slots.chunks_mut(stride).try_for_each(|chunk| self.copy_value(chunk, element, limits));
            self.put_slots(copy, slots);
            copied?;
        }
        Ok(copy)
    }

    /// Replaces the arrays inside a value by deep copies.
    ///
    /// # Errors
    /// As for [`Heap::copy_array`].
    pub fn copy_value(
        &mut self,
        slots: &mut [Slot],
        repr: &Repr,
        limits: &Limits,
    ) -> Result<(), RuntimeError> {
        match repr {
            Repr::Array(element) => {
                let slot = slots.first_mut().ok_or_else(not_copied)?;
                *slot = self.copy_array(*slot, element, limits)?;
            }
            Repr::Tuple(parts) => {
                let mut rest = slots;
                for part in parts {
                    let (slots, after) = rest.split_at_mut_checked(part.slots()).ok_or_else(not_copied)?;
                    self.copy_value(slots, part, limits)?;
                    rest = after;
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Takes the slots out of an array under construction.
    fn take_slots(&mut self, id: HeapId) -> Vec<Slot> {
        match self.get_mut(id) {
            Some(Object::Array { slots, .. }) => std::mem::take(slots),
            _ => Vec::new(),
        }
    }

    /// Returns the slots to the array.
    fn put_slots(&mut self, id: HeapId, taken: Vec<Slot>) {
        if let Some(Object::Array { slots, .. }) = self.get_mut(id) {
            *slots = taken;
        }
    }
}

/// Returns the error of slots that do not contain a value of their representation.
fn not_copied() -> RuntimeError {
    malformed("not a value that can be copied")
}

fn contains_array(repr: &Repr) -> bool {
    match repr {
        Repr::Array(_) => true,
        Repr::Tuple(parts) => parts.iter().any(contains_array),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_of_nested_arrays_share_nothing() {
        let mut heap = Heap::default();
        let inner = heap.insert(Object::Array { stride: 1, slots: vec![1f64.to_bits()] });
        let outer = heap.insert(Object::Array { stride: 1, slots: vec![inner] });
        let copy = heap.copy_array(outer, &Repr::Array(Box::new(Repr::Number)), &Limits::default()).unwrap();
        let copied_inner = heap.array(copy).unwrap().0[0];
        assert_ne!(copied_inner, inner);
        if let Some(Object::Array { slots, .. }) = heap.get_mut(copied_inner) {
            slots[0] = 2f64.to_bits();
        }
        assert_eq!(heap.numbers(inner).unwrap(), [1.0]);
    }

    #[test]
    fn copies_are_refused_before_they_are_made() {
        let mut heap = Heap::default();
        let row = heap.insert(Object::Array { stride: 1, slots: vec![0; 1000] });
        let table = heap.insert(Object::Array { stride: 1, slots: vec![row; 1000] });
        let limit = 100_000;
        let limits = Limits { memory: Some(limit), ..Limits::default() };
        let nested = Repr::Array(Box::new(Repr::Number));
        assert_eq!(heap.copy_array(table, &nested, &limits).unwrap_err().code, "E0707");
        assert!(heap.bytes() <= limit, "{}", heap.bytes());
    }
}
