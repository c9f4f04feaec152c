//! A kernel as a straight list of scalar instructions, scheduled for locality: what is interpreted and compiled.

use calyx_abi::{Kernel, math};
use std::cell::RefCell;

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
    /// [`math::pow`].
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

impl Instruction {
    /// The instruction's value, given those of the inputs and of its operands.
    #[inline]
    pub fn evaluate(self, inputs: &[f64], v: impl Fn(ValueId) -> f64) -> f64 {
        use Instruction as I;
        match self {
            I::Constant(value) => value,
            I::Input(index) => inputs[index as usize],
            I::Negate(a) => -v(a),
            I::Abs(a) => math::abs(v(a)),
            I::Sqrt(a) => math::sqrt(v(a)),
            I::Sin(a) => math::sin(v(a)),
            I::Cos(a) => math::cos(v(a)),
            I::Tan(a) => math::tan(v(a)),
            I::Asin(a) => math::asin(v(a)),
            I::Acos(a) => math::acos(v(a)),
            I::Atan(a) => math::atan(v(a)),
            I::Exp(a) => math::exp(v(a)),
            I::Log(a) => math::log(v(a)),
            I::Floor(a) => math::floor(v(a)),
            I::Ceil(a) => math::ceil(v(a)),
            I::Round(a) => math::round(v(a)),
            I::Not(a) => math::not(v(a)),
            I::Add(a, b) => v(a) + v(b),
            I::Subtract(a, b) => v(a) - v(b),
            I::Multiply(a, b) => v(a) * v(b),
            I::Divide(a, b) => v(a) / v(b),
            I::Power(a, b) => math::pow(v(a), v(b)),
            I::Atan2(a, b) => math::atan2(v(a), v(b)),
            I::Min(a, b) => math::min(v(a), v(b)),
            I::Max(a, b) => math::max(v(a), v(b)),
            I::Less(a, b) => math::less(v(a), v(b)),
            I::LessEqual(a, b) => math::less_equal(v(a), v(b)),
            I::Equal(a, b) => math::equal(v(a), v(b)),
            I::And(a, b) => math::and(v(a), v(b)),
            I::Or(a, b) => math::or(v(a), v(b)),
            I::Select(c, a, b) => math::select(v(c), v(a), v(b)),
        }
    }
}

/// A kernel ready to run: operands always stand before their use.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tape {
    pub inputs: usize,
    pub instructions: Vec<Instruction>,
    pub outputs: Vec<ValueId>,
}

impl Tape {
    /// Interprets the tape. `scratch` only saves an allocation per call; what it holds does not matter.
    ///
    /// `inputs` holds [`Tape::inputs`] numbers, `outputs` receives one per element of [`Tape::outputs`].
    pub fn eval(&self, inputs: &[f64], scratch: &mut Vec<f64>, outputs: &mut [f64]) {
        scratch.clear();
        scratch.reserve(self.instructions.len());
        for instruction in &self.instructions {
            let value = instruction.evaluate(inputs, |id| scratch[id as usize]);
            scratch.push(value);
        }
        for (output, &id) in outputs.iter_mut().zip(&self.outputs) {
            *output = scratch[id as usize];
        }
    }
}

/// A tape that evaluates itself by interpretation: the oracle of compiled kernels, and what `check` runs.
#[derive(Clone, Debug)]
pub struct TapeKernel(pub Tape);

impl Kernel for TapeKernel {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        thread_local! {
            static SCRATCH: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
        }
        SCRATCH.with_borrow_mut(|scratch| self.0.eval(inputs, scratch, outputs));
    }

    fn inputs(&self) -> usize {
        self.0.inputs
    }

    fn outputs(&self) -> usize {
        self.0.outputs.len()
    }
}
