//! A kernel as a straight list of scalar instructions, scheduled for locality: what is interpreted and compiled.

/// Position of an instruction; its value is referred to by it.
pub type ValueId = u32;

/// One scalar operation. Truth values are 1.0 and 0.0.
/// Semantics of each: the function of the same name in [`calyx_abi::math`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instruction {
    Constant(f64),
    /// By index in the kernel's inputs.
    Input(u32),
    Negate(ValueId),
    Abs(ValueId),
    Sqrt(ValueId),
    Sin(ValueId),
    Cos(ValueId),
    Tan(ValueId),
    Asin(ValueId),
    Acos(ValueId),
    Atan(ValueId),
    Exp(ValueId),
    Log(ValueId),
    Floor(ValueId),
    Ceil(ValueId),
    Round(ValueId),
    Not(ValueId),
    Add(ValueId, ValueId),
    Subtract(ValueId, ValueId),
    Multiply(ValueId, ValueId),
    Divide(ValueId, ValueId),
    Power(ValueId, ValueId),
    Atan2(ValueId, ValueId),
    Min(ValueId, ValueId),
    Max(ValueId, ValueId),
    Less(ValueId, ValueId),
    LessEqual(ValueId, ValueId),
    Equal(ValueId, ValueId),
    And(ValueId, ValueId),
    Or(ValueId, ValueId),
    /// `condition != 0 ? a : b`; both are evaluated, neither can trap.
    Select(ValueId, ValueId, ValueId),
}

/// A kernel ready to run: operands always stand before their use.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tape {
    pub inputs: usize,
    pub instructions: Vec<Instruction>,
    pub outputs: Vec<ValueId>,
}
