//! Places: storage locations, resolved from a local into arrays and tuples.

use crate::error::CodegenError;
use crate::function::{FunctionLowering, SLOT, TRUSTED};
use calyx_abi::Repr;
use calyx_lang::ir::{Place, Step};
use calyx_lower::layout::tuple_part;
use cranelift_codegen::ir::{InstBuilder, Value, types};
use cranelift_module::Module;

/// The slots of a place, from its first slot on.
enum Storage {
    /// The index of a slot in the place's local.
    Local(usize),
    /// The address of an element, valid until the next call, and a slot offset.
    Element(Value, usize),
}

impl<'m, M: Module> FunctionLowering<'_, 'm, '_, M> {
    /// Evaluates the indices of a place, without bounds checks.
    pub fn indices(&mut self, place: &'m Place) -> Result<Vec<Value>, CodegenError> {
        place.indices().map(|index| self.scalar(index)).collect()
    }

    /// Stores the slots of a value in a place.
    pub fn store(&mut self, place: &Place, indices: &[Value], values: &[Value]) -> Result<(), CodegenError> {
        match self.spot(place, indices)? {
            Storage::Local(first) => self.assign_slots(place.local, first, values),
            Storage::Element(element, first) => {
                for (slot, &value) in values.iter().enumerate() {
                    self.builder.ins().store(TRUSTED, value, element, ((first + slot) * SLOT) as i32);
                }
                Ok(())
            }
        }
    }

    /// Returns the array stored in a place that changes.
    pub fn array_in(&mut self, place: &Place, indices: &[Value]) -> Result<Value, CodegenError> {
        let spot = self.spot(place, indices)?;
        self.array_at(place, &spot)
    }

    fn array_at(&mut self, place: &Place, spot: &Storage) -> Result<Value, CodegenError> {
        match *spot {
            Storage::Local(first) => {
                let slots = self.local(place.local)?;
                slots.get(first).copied().ok_or(CodegenError::Malformed("a place that is no array"))
            }
            Storage::Element(element, first) => {
                Ok(self.builder.ins().load(types::I64, TRUSTED, element, (first * SLOT) as i32))
            }
        }
    }

    fn spot(&mut self, place: &Place, indices: &[Value]) -> Result<Storage, CodegenError> {
        let mut repr = self.local_repr(place.local)?;
        let mut spot = Storage::Local(0);
        let mut indices = indices.iter();
        for step in &place.steps {
            match step {
                Step::Element(at) => {
                    let part = tuple_part(repr, *at);
                    let (before, part) =
                        part.ok_or(CodegenError::Malformed("an element of what is no tuple"))?;
                    let (Storage::Local(first) | Storage::Element(_, first)) = &mut spot;
                    *first += before;
                    repr = part;
                }
                Step::Index(expr) => {
                    let (Repr::Array(element), Some(&index)) = (repr, indices.next()) else {
                        return Err(CodegenError::Malformed("a place that is no array"));
                    };
                    let array = self.array_at(place, &spot)?;
                    self.at(expr.span);
                    spot = Storage::Element(self.element("calyx_array_slot", array, index)?, 0);
                    repr = element;
                }
            }
        }
        Ok(spot)
    }

    /// Returns the address of an array element, valid until the next call. `helper` returns it for
    /// reading or for a change.
    pub fn element(
        &mut self,
        helper: &'static str,
        array: Value,
        index: Value,
    ) -> Result<Value, CodegenError> {
        let index = self.bits(index);
        let into = self.buffer_address(0);
        self.helper(helper, &[array, index, into])?;
        Ok(self.load_buffer(0, &[types::I64])[0])
    }
}
