//! A kernel as a list of scalar instructions without branches, scheduled for locality. Tapes are
//! interpreted or compiled.

use calyx_abi::newton::{MOST_UNKNOWNS, MOST_VALUES, Search, last_iterate};
use calyx_abi::piecewise::{is_table, registered};
use calyx_abi::{Kernel, math};
use std::cell::RefCell;
use std::sync::Arc;

/// The index of an instruction, by which other instructions refer to its value.
pub type ValueId = u32;

/// A scalar operation. Truth values are 1.0 and 0.0. Each operation is defined by the function of
/// the same name in [`calyx_abi::math`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instruction {
    Constant(f64),
    /// Returns an input of the kernel, by index.
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
    /// See [`math::pow`].
    Power(ValueId, ValueId),
    Atan2(ValueId, ValueId),
    Min(ValueId, ValueId),
    Max(ValueId, ValueId),
    Less(ValueId, ValueId),
    LessEqual(ValueId, ValueId),
    Equal(ValueId, ValueId),
    And(ValueId, ValueId),
    Or(ValueId, ValueId),
    /// `condition != 0 ? a : b`. Both arms are evaluated; neither can trap.
    Select(ValueId, ValueId, ValueId),
    /// The value of a table of [`Tape::tables`], by index. See [`calyx_abi::piecewise`].
    Piecewise(u32, ValueId),
    /// The derivative of this order of a registered table, whose number is the first operand, at
    /// the second operand. See [`calyx_abi::piecewise::registered`].
    Lookup(u8, ValueId, ValueId),
    /// An unknown of an implicit function: an index of [`Tape::solves`], and the index of the
    /// unknown. Its operands are those of the [`Solve`].
    Solution(u32, u32),
}

impl Instruction {
    /// Returns the operands in order, except those of a solution, which only the tape contains.
    fn own_operands(self) -> impl Iterator<Item = ValueId> {
        use Instruction as I;
        let (operands, count) = match self {
            I::Constant(_) | I::Input(_) | I::Solution(..) => ([0; 3], 0),
            I::Negate(a)
            | I::Abs(a)
            | I::Sqrt(a)
            | I::Sin(a)
            | I::Cos(a)
            | I::Tan(a)
            | I::Asin(a)
            | I::Acos(a)
            | I::Atan(a)
            | I::Exp(a)
            | I::Log(a)
            | I::Floor(a)
            | I::Ceil(a)
            | I::Round(a)
            | I::Not(a)
            | I::Piecewise(_, a) => ([a, 0, 0], 1),
            I::Add(a, b)
            | I::Subtract(a, b)
            | I::Multiply(a, b)
            | I::Divide(a, b)
            | I::Power(a, b)
            | I::Atan2(a, b)
            | I::Min(a, b)
            | I::Max(a, b)
            | I::Less(a, b)
            | I::LessEqual(a, b)
            | I::Equal(a, b)
            | I::And(a, b)
            | I::Or(a, b)
            | I::Lookup(_, a, b) => ([a, b, 0], 2),
            I::Select(a, b, c) => ([a, b, c], 3),
        };
        operands.into_iter().take(count)
    }

    /// Returns the same operation on other operands. Those of a solution belong to the tape
    /// ([`Solve::with_operands`]).
    pub fn with_operands(self, place: impl Fn(ValueId) -> ValueId) -> Self {
        use Instruction as I;
        match self {
            I::Constant(_) | I::Input(_) | I::Solution(..) => self,
            I::Negate(a) => I::Negate(place(a)),
            I::Abs(a) => I::Abs(place(a)),
            I::Sqrt(a) => I::Sqrt(place(a)),
            I::Sin(a) => I::Sin(place(a)),
            I::Cos(a) => I::Cos(place(a)),
            I::Tan(a) => I::Tan(place(a)),
            I::Asin(a) => I::Asin(place(a)),
            I::Acos(a) => I::Acos(place(a)),
            I::Atan(a) => I::Atan(place(a)),
            I::Exp(a) => I::Exp(place(a)),
            I::Log(a) => I::Log(place(a)),
            I::Floor(a) => I::Floor(place(a)),
            I::Ceil(a) => I::Ceil(place(a)),
            I::Round(a) => I::Round(place(a)),
            I::Not(a) => I::Not(place(a)),
            I::Add(a, b) => I::Add(place(a), place(b)),
            I::Subtract(a, b) => I::Subtract(place(a), place(b)),
            I::Multiply(a, b) => I::Multiply(place(a), place(b)),
            I::Divide(a, b) => I::Divide(place(a), place(b)),
            I::Power(a, b) => I::Power(place(a), place(b)),
            I::Atan2(a, b) => I::Atan2(place(a), place(b)),
            I::Min(a, b) => I::Min(place(a), place(b)),
            I::Max(a, b) => I::Max(place(a), place(b)),
            I::Less(a, b) => I::Less(place(a), place(b)),
            I::LessEqual(a, b) => I::LessEqual(place(a), place(b)),
            I::Equal(a, b) => I::Equal(place(a), place(b)),
            I::And(a, b) => I::And(place(a), place(b)),
            I::Or(a, b) => I::Or(place(a), place(b)),
            I::Select(c, a, b) => I::Select(place(c), place(a), place(b)),
            I::Piecewise(table, a) => I::Piecewise(table, place(a)),
            I::Lookup(order, table, x) => I::Lookup(order, place(table), place(x)),
        }
    }

    /// Returns `true` for constants and inputs, which cost nothing.
    pub fn is_leaf(self) -> bool {
        matches!(self, Instruction::Constant(_) | Instruction::Input(_))
    }

    /// Returns the instruction's value, given the inputs and a function that returns operand
    /// values. A solution or the value of a table is NaN, because only [`Tape::eval`] can compute
    /// it.
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
            I::Lookup(order, table, x) => registered(v(table), f64::from(order), v(x)),
            I::Piecewise(..) | I::Solution(..) => f64::NAN,
        }
    }
}

/// Equations that define an implicit function: the unknowns at which all residuals vanish. For a
/// minimum, the residuals are the gradient of a function.
#[derive(Clone, Debug, PartialEq)]
pub struct System {
    /// The kind of point that solves the equations.
    pub search: Search,
    /// Number of unknowns and of residuals, at most [`MOST_UNKNOWNS`].
    pub unknowns: usize,
    /// Inputs: the unknowns, then the arguments. Outputs: the residuals, then their derivatives
    /// with respect to the unknowns, row by row.
    pub residual: Tape,
}

impl System {
    /// Returns `true` if the residual tape is well-formed and has the right numbers of inputs and
    /// outputs.
    fn is_well_formed(&self, operands: usize) -> bool {
        (1..=MOST_UNKNOWNS).contains(&self.unknowns)
            && self.residual.inputs == operands
            && operands >= self.unknowns
            && self.residual.outputs.len() == self.unknowns * (self.unknowns + 1)
            && self.residual.is_well_formed()
    }

    /// Repeats an iteration that failed. Replaces the guess in `inputs` by the last iterate, and
    /// returns the residuals there.
    pub fn last_iterate(&self, inputs: &mut [f64]) -> Vec<f64> {
        let mut scratch = Vec::new();
        let values =
            last_iterate(self.search, self.unknowns, inputs, |inputs, values: &mut [f64; MOST_VALUES]| {
                self.residual.eval(inputs, &mut scratch, values);
            });
        values[..self.unknowns].to_vec()
    }
}

/// A system with its guess and its arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Solve {
    pub system: Arc<System>,
    /// The guess of each unknown, then the arguments.
    pub operands: Vec<ValueId>,
}

impl Solve {
    /// Returns the same system with other operands.
    pub fn with_operands(&self, place: impl Fn(ValueId) -> ValueId) -> Self {
        Solve {
            system: self.system.clone(),
            operands: self.operands.iter().map(|&operand| place(operand)).collect(),
        }
    }
}

/// A kernel ready to run. Operands always precede their users.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tape {
    pub inputs: usize,
    pub instructions: Vec<Instruction>,
    pub outputs: Vec<ValueId>,
    /// The implicit functions of [`Instruction::Solution`].
    pub solves: Vec<Solve>,
    /// The tables of [`Instruction::Piecewise`].
    pub tables: Vec<Arc<[f64]>>,
}

impl Tape {
    /// Returns the operands of an instruction of this tape, in order.
    pub fn operands(&self, instruction: Instruction) -> impl Iterator<Item = ValueId> + '_ {
        let solve = match instruction {
            Instruction::Solution(solve, _) => self.solves.get(solve as usize),
            _ => None,
        };
        instruction.own_operands().chain(solve.into_iter().flat_map(|solve| solve.operands.iter().copied()))
    }

    /// Returns `true` if every operand precedes its user and all inputs and outputs exist.
    pub fn is_well_formed(&self) -> bool {
        let fits = |(index, instruction): (usize, &Instruction)| match *instruction {
            Instruction::Input(input) => (input as usize) < self.inputs,
            Instruction::Solution(solve, unknown) => self.solves.get(solve as usize).is_some_and(|solve| {
                (unknown as usize) < solve.system.unknowns
                    && solve.operands.iter().all(|&operand| (operand as usize) < index)
            }),
            Instruction::Piecewise(table, operand) => {
                (table as usize) < self.tables.len() && (operand as usize) < index
            }
            other => other.own_operands().all(|operand| (operand as usize) < index),
        };
        self.tables.iter().all(|table| is_table(table))
            && self.solves.iter().all(|solve| solve.system.is_well_formed(solve.operands.len()))
            && self.instructions.iter().enumerate().all(fits)
            && self.outputs.iter().all(|&output| (output as usize) < self.instructions.len())
    }

    /// Returns the number of operations, without constants and inputs.
    pub fn operations(&self) -> usize {
        self.instructions.iter().filter(|instruction| !instruction.is_leaf()).count()
    }
}

/// A tape that evaluates itself by interpretation. It is the reference for compiled kernels, and
/// `check` uses it.
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
