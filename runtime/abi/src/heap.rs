//! Values that do not fit in slots: strings, arrays and symbolic values, owned by the running
//! instance.
//!
//! Arrays have value semantics: the program copies an array when it binds one that has another name
//! (the compiler inserts the copies). A copy shares its elements with the original until one of the
//! two changes. Nothing is freed before the instance ends, because models are built once and are
//! small.

use crate::call::{Repr, Slot};
use crate::error::{Call, RuntimeError};
use crate::helpers::malformed;
use crate::limits::Limits;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

/// Index into the [`Heap`], with [`SYMBOLIC`] set for a symbolic value.
pub type HeapId = u64;

/// Mark of the ids of symbolic values. It distinguishes them from indices of observables, because a
/// slot of the type `Observable` may have either.
pub const SYMBOLIC: HeapId = 1 << 48;

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
    /// Captured values as numbers, in the order of the site's captures. An observable of the engine
    /// is captured as its index and replaced by its value at each step (see
    /// [`SymbolicValue::observables`]); one that the program computed is a part.
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
    Array(Array),
    Symbolic(Arc<SymbolicValue>),
    /// Caught error.
    Error(Arc<RuntimeError>),
}

/// Array. Its copies have the same slots until one of them changes.
#[derive(Clone)]
pub struct Array {
    /// Number of slots of an element.
    stride: usize,
    /// Flat slots of the elements.
    slots: Arc<Vec<Slot>>,
    /// Representation of the elements, if they contain arrays and the array has been copied: the
    /// first change also separates these arrays.
    element: Option<Arc<Repr>>,
}

impl Object {
    /// Creates an array of elements of `stride` slots.
    pub fn array(stride: usize, slots: Vec<Slot>) -> Object {
        Object::Array(Array { stride, slots: Arc::new(slots), element: None })
    }

    /// Returns its approximate size, bytes.
    fn bytes(&self) -> u64 {
        let content = match self {
            Object::String(text) => text.len(),
            Object::Array(array) => size_of_val(array.slots.as_slice()),
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
        let mark = if matches!(object, Object::Symbolic(_)) { SYMBOLIC } else { 0 };
        self.objects.push(object);
        (self.objects.len() - 1) as HeapId | mark
    }

    /// Returns the approximate memory of all objects, bytes.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Accounts for slots that were appended to an object.
    pub fn grown(&mut self, slots: usize) {
        self.bytes += (slots * size_of::<Slot>()) as u64;
    }

    /// Accounts for bytes that the program took earlier and does not take again.
    pub fn charge(&mut self, bytes: u64) {
        self.bytes += bytes;
    }

    pub fn get(&self, id: HeapId) -> Option<&Object> {
        self.objects.get(usize::try_from(id & !SYMBOLIC).ok()?)
    }

    pub fn get_mut(&mut self, id: HeapId) -> Option<&mut Object> {
        self.objects.get_mut(usize::try_from(id & !SYMBOLIC).ok()?)
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
            Object::Array(array) => Some((&array.slots, array.stride)),
            _ => None,
        }
    }

    /// Returns the elements of an array of numbers.
    pub fn numbers(&self, id: HeapId) -> Option<Vec<f64>> {
        let (slots, _) = self.array(id)?;
        Some(slots.iter().map(|&s| f64::from_bits(s)).collect())
    }

    /// Returns a symbolic value; `None` for the id of another object, such as the index of an
    /// observable of the engine.
    pub fn symbolic(&self, id: HeapId) -> Option<Arc<SymbolicValue>> {
        match self.get(id).filter(|_| id & SYMBOLIC != 0)? {
            Object::Symbolic(value) => Some(value.clone()),
            _ => None,
        }
    }

    /// Returns the slots of an array for a change, and its stride.
    ///
    /// # Errors
    /// E0707 if the slots are shared with a copy and separate ones would exceed the memory limit;
    /// internal if it is not an array.
    pub fn array_mut(
        &mut self,
        id: HeapId,
        limits: &Limits,
    ) -> Result<(&mut Vec<Slot>, usize), RuntimeError> {
        self.separate(id, limits)?;
        match self.get_mut(id) {
            Some(Object::Array(array)) => Ok((Arc::make_mut(&mut array.slots), array.stride)),
            _ => Err(malformed("not an array")),
        }
    }

    /// Gives an array slots of its own if a copy shares them.
    fn separate(&mut self, id: HeapId, limits: &Limits) -> Result<(), RuntimeError> {
        let Some(Object::Array(array)) = self.get_mut(id) else { return Ok(()) };
        if Arc::get_mut(&mut array.slots).is_some() {
            return Ok(());
        }
        let Array { stride, slots, element } = array.clone();
        let bytes = size_of_val(slots.as_slice()) as u64;
        limits.check_memory(self.bytes + bytes)?;
        self.bytes += bytes;
        let mut own = slots.to_vec();
        if let Some(element) = &element {
            own.chunks_mut(stride.max(1)).try_for_each(|chunk| self.copy_value(chunk, element, limits))?;
        }
        if let Some(Object::Array(array)) = self.get_mut(id) {
            array.slots = Arc::new(own);
        }
        Ok(())
    }

    /// Copies an array. `element` is the element's representation. The copy shares the elements
    /// until the array or the copy changes.
    ///
    /// # Errors
    /// E0707 before the memory exceeds the limit; internal if it is not an array.
    pub fn copy_array(
        &mut self,
        id: HeapId,
        element: &Repr,
        limits: &Limits,
    ) -> Result<HeapId, RuntimeError> {
        limits.check_memory(self.bytes + OBJECT)?;
        let Some(Object::Array(array)) = self.get_mut(id) else { return Err(not_copied()) };
        if array.element.is_none() && contains_array(element) {
            array.element = Some(Arc::new(element.clone()));
        }
        let copy = Object::Array(array.clone());
        self.bytes += OBJECT;
        self.objects.push(copy);
        Ok((self.objects.len() - 1) as HeapId)
    }

    /// Replaces the arrays inside a value by copies.
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

    fn numbers() -> Repr {
        Repr::Array(Box::new(Repr::Number))
    }

    /// Writes a number into a row of a table.
    fn write(heap: &mut Heap, table: HeapId, value: f64) {
        let limits = Limits::default();
        let row = heap.array_mut(table, &limits).unwrap().0[0];
        heap.array_mut(row, &limits).unwrap().0[0] = value.to_bits();
    }

    fn read(heap: &Heap, table: HeapId) -> f64 {
        heap.numbers(heap.array(table).unwrap().0[0]).unwrap()[0]
    }

    #[test]
    fn changes_of_nested_arrays_are_not_visible_in_copies() {
        let mut heap = Heap::default();
        let row = heap.insert(Object::array(1, vec![1f64.to_bits()]));
        let table = heap.insert(Object::array(1, vec![row]));
        let copy = heap.copy_array(table, &numbers(), &Limits::default()).unwrap();
        let second = heap.copy_array(copy, &numbers(), &Limits::default()).unwrap();
        write(&mut heap, copy, 2.0);
        assert_eq!([table, copy, second].map(|id| read(&heap, id)), [1.0, 2.0, 1.0]);
        write(&mut heap, table, 3.0);
        assert_eq!([table, copy, second].map(|id| read(&heap, id)), [3.0, 2.0, 1.0]);
        write(&mut heap, copy, 4.0);
        write(&mut heap, second, 5.0);
        assert_eq!([table, copy, second].map(|id| read(&heap, id)), [3.0, 4.0, 5.0]);
    }

    #[test]
    fn copies_share_their_elements_until_one_of_them_changes() {
        let mut heap = Heap::default();
        let array = heap.insert(Object::array(1, vec![0; 20_000]));
        let limits = Limits::default();
        let before = heap.bytes();
        let copies: Vec<HeapId> =
            (0..20_000).map(|_| heap.copy_array(array, &Repr::Number, &limits).unwrap()).collect();
        assert_eq!(heap.bytes() - before, 20_000 * OBJECT);
        let shared = heap.array(array).unwrap().0.as_ptr();
        assert!(copies.iter().all(|copy| heap.array(*copy).unwrap().0.as_ptr() == shared));
        heap.array_mut(copies[0], &limits).unwrap().0[0] = 1;
        assert_eq!(heap.bytes() - before, 20_000 * OBJECT + 160_000);
        assert_eq!([array, copies[0], copies[1]].map(|id| heap.array(id).unwrap().0[0]), [0, 1, 0]);
    }

    #[test]
    fn changes_are_refused_before_they_exceed_the_limit() {
        let mut heap = Heap::default();
        let row = heap.insert(Object::array(1, vec![0; 1000]));
        let table = heap.insert(Object::array(1, vec![row; 1000]));
        let limit = 60_000;
        let limits = Limits { memory: Some(limit), ..Limits::default() };
        let copy = heap.copy_array(table, &numbers(), &limits).unwrap();
        assert_eq!(heap.array_mut(copy, &limits).unwrap_err().code, "E0707");
        assert!(heap.bytes() <= limit, "{}", heap.bytes());
    }
}
