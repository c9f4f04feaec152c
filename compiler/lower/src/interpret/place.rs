//! Places: storage locations, resolved from a local into arrays and tuples.

use super::Machine;
use crate::layout::tuple_part;
use calyx_abi::context::RuntimeError;
use calyx_abi::{Repr, Slot, helpers};
use calyx_lang::ir::{Place, Step};
use std::ops::Range;

/// The slots of a place.
enum Storage {
    /// On the stack.
    Frame(Range<usize>),
    /// In an element of an array.
    Element { array: Slot, index: f64, range: Range<usize> },
}

impl<'p> Machine<'_, 'p> {
    /// Evaluates the indices of a place, without bounds checks.
    pub(super) fn indices(&mut self, place: &'p Place) -> Result<Vec<f64>, RuntimeError> {
        place.indices().map(|index| self.number(index)).collect()
    }

    /// Stores the stack slots from `from` on in a place.
    pub(super) fn store(&mut self, place: &Place, indices: &[f64], from: usize) -> Result<(), RuntimeError> {
        let count = place.repr.slots();
        match self.spot(place, indices)? {
            Storage::Frame(target) if target.len() == count => {
                self.stack.copy_within(from..from + count, target.start);
                Ok(())
            }
            Storage::Element { array, index, range } => {
                let value = self.stack.get(from..from + count).map(<[Slot]>::to_vec);
                let element = helpers::element_mut(self.ctx, array, index)?.get_mut(range);
                match (value, element) {
                    (Some(value), Some(element)) if value.len() == element.len() => {
                        element.copy_from_slice(&value);
                        Ok(())
                    }
                    _ => Err(helpers::malformed("an element of the wrong size")),
                }
            }
            Storage::Frame(_) => Err(helpers::malformed("a value of the wrong size")),
        }
    }

    /// Returns the array stored in a place that changes.
    pub(super) fn array_in(&mut self, place: &Place, indices: &[f64]) -> Result<Slot, RuntimeError> {
        let spot = self.spot(place, indices)?;
        self.array_at(&spot)
    }

    fn array_at(&mut self, spot: &Storage) -> Result<Slot, RuntimeError> {
        let slot = match spot {
            Storage::Frame(range) => self.stack.get(range.clone()).and_then(|slots| slots.first()),
            Storage::Element { array, index, range } => {
                let element = helpers::element(self.ctx, *array, *index)?;
                element.get(range.clone()).and_then(|slots| slots.first())
            }
        };
        slot.copied().ok_or_else(|| helpers::malformed("not an array"))
    }

    fn spot(&mut self, place: &Place, indices: &[f64]) -> Result<Storage, RuntimeError> {
        let locals = &self.activation.function.locals;
        let mut repr = &locals
            .get(place.local.0 as usize)
            .ok_or_else(|| helpers::malformed("a local that is not there"))?
            .repr;
        let mut spot = Storage::Frame(self.local(place.local)?);
        let mut indices = indices.iter();
        for step in &place.steps {
            match step {
                Step::Element(at) => {
                    let (before, part) =
                        tuple_part(repr, *at).ok_or_else(|| helpers::malformed("not a tuple"))?;
                    let (Storage::Frame(range) | Storage::Element { range, .. }) = &mut spot;
                    *range = range.start + before..range.start + before + part.slots();
                    repr = part;
                }
                Step::Index(expr) => {
                    let (Repr::Array(element), Some(&index)) = (repr, indices.next()) else {
                        return Err(helpers::malformed("not an array of arrays"));
                    };
                    let array = self.array_at(&spot)?;
                    self.at(expr.span);
                    helpers::element_mut(self.ctx, array, index)?;
                    spot = Storage::Element { array, index, range: 0..element.slots() };
                    repr = element;
                }
            }
        }
        Ok(spot)
    }
}
