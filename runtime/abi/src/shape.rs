//! Representations of the values of provided functions as compile-time constants.

use crate::call::Repr;

/// [`Repr`] as a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Unit,
    Number,
    Bool,
    String,
    Vector,
    Transform,
    Handle,
    Array(&'static Shape),
    Symbolic(&'static Shape),
    /// A slot that is 1 if there is a value, followed by the slots of the value.
    Optional(&'static Shape),
}

impl Shape {
    /// Returns the number of slots of a value, like [`Repr::slots`].
    pub const fn slots(self) -> usize {
        match self {
            Shape::Unit => 0,
            Shape::Vector => 3,
            Shape::Transform => 12,
            Shape::Optional(content) => 1 + content.slots(),
            _ => 1,
        }
    }

    pub fn repr(self) -> Repr {
        match self {
            Shape::Unit => Repr::Unit,
            Shape::Number => Repr::Number,
            Shape::Bool => Repr::Bool,
            Shape::String => Repr::String,
            Shape::Vector => Repr::Vector,
            Shape::Transform => Repr::Transform,
            Shape::Handle => Repr::Handle,
            Shape::Array(element) => Repr::Array(Box::new(element.repr())),
            Shape::Symbolic(content) => Repr::Symbolic(Box::new(content.repr())),
            Shape::Optional(content) => Repr::Tuple(vec![Repr::Bool, content.repr()]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_are_those_of_the_representation() {
        use Shape::*;
        let plain = [Unit, Number, Bool, String, Vector, Transform, Handle];
        let composed = [Array(&Vector), Symbolic(&Transform), Optional(&Number), Optional(&Vector)];
        for shape in plain.into_iter().chain(composed) {
            assert_eq!(shape.slots(), shape.repr().slots(), "{shape:?}");
        }
    }
}
