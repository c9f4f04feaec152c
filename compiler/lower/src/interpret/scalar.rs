//! Scalar operations on slots, as [`calyx_abi::math`] defines them.

use crate::operations::Scalars;
use calyx_abi::piecewise::registered;
use calyx_abi::{Slot, math};
use calyx_lang::ir::Op;

/// Scalar operations on slots.
pub struct SlotScalars;

impl Scalars for SlotScalars {
    type Value = Slot;

    fn number(&mut self, value: f64) -> Slot {
        value.to_bits()
    }

    fn apply(&mut self, op: Op, operands: &[Slot]) -> Option<Slot> {
        let &first = operands.first()?;
        // Operations with one operand ignore the second.
        let second = operands.get(1).copied().unwrap_or(first);
        let x = |index: usize| f64::from_bits([first, second][index]);
        let number = f64::to_bits;
        let truth = u64::from;
        Some(match op {
            Op::Add => number(x(0) + x(1)),
            Op::Subtract => number(x(0) - x(1)),
            Op::Multiply => number(x(0) * x(1)),
            Op::Divide => number(x(0) / x(1)),
            Op::Power => number(math::pow(x(0), x(1))),
            Op::Negate => number(-x(0)),
            Op::Not => truth(first == 0),
            Op::Less => truth(x(0) < x(1)),
            Op::LessEqual => truth(x(0) <= x(1)),
            Op::Greater => truth(x(0) > x(1)),
            Op::GreaterEqual => truth(x(0) >= x(1)),
            Op::Equal => truth(x(0) == x(1)),
            Op::NotEqual => truth(x(0) != x(1)),
            Op::Sqrt => number(math::sqrt(x(0))),
            Op::Abs => number(math::abs(x(0))),
            Op::Sin => number(math::sin(x(0))),
            Op::Cos => number(math::cos(x(0))),
            Op::Tan => number(math::tan(x(0))),
            Op::Asin => number(math::asin(x(0))),
            Op::Acos => number(math::acos(x(0))),
            Op::Atan => number(math::atan(x(0))),
            Op::Exp => number(math::exp(x(0))),
            Op::Log => number(math::log(x(0))),
            Op::Floor => number(math::floor(x(0))),
            Op::Ceil => number(math::ceil(x(0))),
            Op::Round => number(math::round(x(0))),
            Op::Spline => number(registered(x(0), 0.0, x(1))),
            Op::Atan2 => number(math::atan2(x(0), x(1))),
            Op::Min => number(math::min(x(0), x(1))),
            Op::Max => number(math::max(x(0), x(1))),
            _ => return None,
        })
    }

    fn both(&mut self, a: Slot, b: Slot) -> Slot {
        a & b
    }
}
