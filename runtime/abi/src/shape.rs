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
}

impl Shape {
    /// Returns the number of slots of a value, like [`Repr::slots`].
    pub const fn slots(self) -> usize {
        match self {
            Shape::Unit => 0,
            Shape::Vector => 3,
            Shape::Transform => 12,
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
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_are_those_of_the_representation() {
        use Shape::*;
        for shape in
            [Unit, Number, Bool, String, Vector, Transform, Handle, Array(&Vector), Symbolic(&Transform)]
        {
            assert_eq!(shape.slots(), shape.repr().slots(), "{shape:?}");
        }
    }
}
