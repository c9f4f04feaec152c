//! Functions that solve the equations of implicit functions.
//!
//! Each system becomes one function: Newton's method with the residuals and their derivatives
//! inlined, so that a solution costs one call and no memory traffic per iteration. The arithmetic
//! of the iteration is [`calyx_abi::newton::Step`], emitted as instructions. This module adds the
//! branches of [`calyx_abi::newton::newton`].

use crate::batched_sincos;
use crate::error::CodegenError;
use crate::function::{SLOT, TRUSTED};
use crate::kernel;
use crate::module::ModuleLowering;
use crate::operation::{self, References};
use calyx_abi::newton::{
    Arithmetic, MOST_EVALUATIONS, MOST_VALUES, Search, Step, Trial, is_positive_definite,
};
use calyx_symbolic::{System, Tape};
use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::{
    AbiParam, Block, BlockArg, InstBuilder, StackSlotData, StackSlotKind, Value, types,
};
use cranelift_frontend::FunctionBuilder;
use cranelift_module::{FuncId, Linkage, Module};

/// Operations of the largest residuals that are inlined. Larger ones are a function, whose call
/// costs little in comparison.
const INLINED: usize = 500;

/// A call of a function that solves a system.
pub struct Solver {
    pub function: FuncId,
    pub unknowns: usize,
}

impl Solver {
    /// Returns the unknowns, NaN without convergence. The operands are the guess and the arguments,
    /// one number each.
    pub fn call<M: Module>(
        &self,
        module: &mut ModuleLowering<M>,
        builder: &mut FunctionBuilder,
        operands: &[Value],
    ) -> Vec<Value> {
        let size = (operands.len() * SLOT) as u32;
        let buffer =
            builder.create_sized_stack_slot(StackSlotData::new(StackSlotKind::ExplicitSlot, size, 3));
        for (place, &operand) in operands.iter().enumerate() {
            builder.ins().stack_store(types::I64, operand, buffer, (place * SLOT) as i32);
        }
        let function = module.module.declare_func_in_func(self.function, builder.func);
        let address = builder.ins().stack_addr(types::I64, buffer, 0);
        builder.ins().call(function, &[address]);
        let load = |place| builder.ins().stack_load(types::I64, types::F64, buffer, (place * SLOT) as i32);
        (0..self.unknowns).map(load).collect()
    }
}

/// Defines the function that solves a system. Its argument is the address of the guess, which the
/// solution replaces, and of the arguments.
pub fn define<M: Module>(
    module: &mut ModuleLowering<M>,
    name: &str,
    system: &System,
) -> Result<FuncId, CodegenError> {
    let tape = &*batched_sincos::gathered(&system.residual);
    let evaluation = if tape.operations() > INLINED {
        Evaluation::Called(kernel::lower(module, &format!("{name}_residual"), tape)?)
    } else {
        Evaluation::Inlined(kernel::solvers(module, name, tape)?)
    };
    let solver = Lowering { tape, evaluation, search: system.search };
    match system.unknowns {
        1 => solver.define::<M, 1>(module, name),
        2 => solver.define::<M, 2>(module, name),
        3 => solver.define::<M, 3>(module, name),
        4 => solver.define::<M, 4>(module, name),
        _ => Err(CodegenError::Malformed("a system of too many equations")),
    }
}

/// How a solver evaluates the residuals.
enum Evaluation {
    /// Instructions in the loop, with the solvers of the implicit functions in the residuals.
    Inlined(Vec<FuncId>),
    /// A call of a kernel.
    Called(FuncId),
}

/// A solver under construction.
struct Lowering<'t> {
    /// Inputs: the unknowns, then the arguments. Outputs: residuals and Jacobian.
    tape: &'t Tape,
    evaluation: Evaluation,
    search: Search,
}

/// The values and blocks that all parts of a solver use.
struct Frame {
    /// Address of guess and arguments.
    buffer: Value,
    /// The arguments.
    arguments: Vec<Value>,
    /// Block that takes the state and the number of evaluations that remain.
    head: Block,
    /// Block that takes the solution.
    found: Block,
    failed: Block,
}

impl Lowering<'_> {
    fn define<M: Module, const N: usize>(
        &self,
        module: &mut ModuleLowering<M>,
        name: &str,
    ) -> Result<FuncId, CodegenError> {
        let mut signature = module.module.make_signature();
        signature.params.push(AbiParam::new(types::I64));
        let id = module.module.declare_function(name, Linkage::Local, &signature)?;
        module.define(id, signature, |module, mut builder| {
            let [buffer] = kernel::entry(&mut builder)?;
            let load = |place| builder.ins().load(types::F64, TRUSTED, buffer, (place * SLOT) as i32);
            let inputs: Vec<Value> = (0..self.tape.inputs).map(load).collect();
            let Some((&guess, arguments)) = inputs.split_first_chunk::<N>() else {
                return Err(CodegenError::Malformed("a system without a guess"));
            };
            let [head, found, failed] = std::array::from_fn(|_| builder.create_block());
            let frame = Frame { buffer, arguments: arguments.to_vec(), head, found, failed };
            let step = Step::<Value, N>::new(&mut Instructions(&mut builder), guess);
            let evaluations = builder.ins().iconst(types::I64, 1 + MOST_EVALUATIONS as i64);
            builder.ins().jump(head, &state(&step, evaluations));
            let builder = self.iterate::<M, N>(module, builder, &frame)?;
            let builder = self.finish::<M, N>(module, builder, &frame)?;
            kernel::finish(module, builder);
            Ok(())
        })?;
        Ok(id)
    }

    /// Emits the loop.
    fn iterate<'f, M: Module, const N: usize>(
        &self,
        module: &mut ModuleLowering<M>,
        mut builder: FunctionBuilder<'f>,
        frame: &Frame,
    ) -> Result<FunctionBuilder<'f>, CodegenError> {
        let [bounded, evaluate, accept, reject, damp] = std::array::from_fn(|_| builder.create_block());
        for _ in 0..Step::<Value, N>::NUMBERS {
            builder.append_block_param(frame.head, types::F64);
        }
        let remaining = builder.append_block_param(frame.head, types::I64);
        builder.switch_to_block(frame.head);
        let numbers = &builder.block_params(frame.head)[..Step::<Value, N>::NUMBERS];
        let Some(step) = Step::<Value, N>::from_numbers(numbers) else { return Err(MALFORMED) };
        let trial: Trial<Value, Value, N> = step.propose(&mut Instructions(&mut builder));
        builder.ins().brif(trial.converged, frame.found, &arguments(&trial.x), bounded, &[]);

        builder.switch_to_block(bounded);
        let exhausted = builder.ins().icmp_imm_s(IntCC::Equal, remaining, 0);
        builder.ins().brif(exhausted, frame.failed, &[], evaluate, &[]);

        builder.switch_to_block(evaluate);
        let (mut builder, values) = self.evaluate(module, builder, frame, &trial.x)?;
        let remaining = builder.ins().iadd_imm_s(remaining, -1);
        let judgement = step.judge(&mut Instructions(&mut builder), &values).ok_or(MALFORMED)?;
        builder.ins().brif(judgement.accepted, accept, &[], reject, &[]);

        builder.switch_to_block(reject);
        let (better, settled) = step.settle(&mut Instructions(&mut builder), &trial, &judgement);
        builder.ins().brif(settled, frame.found, &arguments(&better), damp, &[]);

        builder.switch_to_block(accept);
        let accepted = step.accept(&mut Instructions(&mut builder), &trial, &values, judgement);
        let (next, finite) = accepted.ok_or(MALFORMED)?;
        builder.ins().brif(finite, frame.head, &state(&next, remaining), frame.failed, &[]);

        builder.switch_to_block(damp);
        let (next, worthwhile) = step.damp(&mut Instructions(&mut builder));
        builder.ins().brif(worthwhile, frame.head, &state(&next, remaining), frame.failed, &[]);
        Ok(builder)
    }

    /// Emits the blocks that store the solution, or NaN.
    fn finish<'f, M: Module, const N: usize>(
        &self,
        module: &mut ModuleLowering<M>,
        mut builder: FunctionBuilder<'f>,
        frame: &Frame,
    ) -> Result<FunctionBuilder<'f>, CodegenError> {
        let solution: [Value; N] =
            std::array::from_fn(|_| builder.append_block_param(frame.found, types::F64));
        builder.switch_to_block(frame.found);
        if self.search == Search::Minimum {
            let values;
            (builder, values) = self.evaluate(module, builder, frame, &solution)?;
            let definite = is_positive_definite::<_, N>(&mut Instructions(&mut builder), &values);
            let minimum = builder.create_block();
            builder.ins().brif(definite.ok_or(MALFORMED)?, minimum, &[], frame.failed, &[]);
            builder.switch_to_block(minimum);
        }
        store(&mut builder, frame.buffer, &solution);
        builder.ins().return_(&[]);

        builder.switch_to_block(frame.failed);
        let search = i64::from(self.search == Search::Minimum);
        let search = builder.ins().iconst(types::I64, search);
        let (symbol, references) = ("calyx_math_unsolved", &mut References::new());
        let function = operation::reference(module, &mut builder, references, symbol)?;
        builder.ins().call(function, &[search]);
        let nan = builder.ins().f64const(f64::NAN);
        store(&mut builder, frame.buffer, &[nan; N]);
        Ok(builder)
    }

    /// Returns residuals and Jacobian at a point.
    fn evaluate<'f, M: Module>(
        &self,
        module: &mut ModuleLowering<M>,
        mut builder: FunctionBuilder<'f>,
        frame: &Frame,
        x: &[Value],
    ) -> Result<(FunctionBuilder<'f>, Vec<Value>), CodegenError> {
        match &self.evaluation {
            Evaluation::Inlined(solvers) => {
                let inputs: Vec<Value> = x.iter().chain(&frame.arguments).copied().collect();
                kernel::inline(module, builder, (self.tape, solvers), &inputs)
            }
            Evaluation::Called(kernel) => {
                store(&mut builder, frame.buffer, x);
                let size = (MOST_VALUES * SLOT) as u32;
                let data = StackSlotData::new(StackSlotKind::ExplicitSlot, size, 3);
                let results = builder.create_sized_stack_slot(data);
                let address = builder.ins().stack_addr(types::I64, results, 0);
                let kernel = module.module.declare_func_in_func(*kernel, builder.func);
                builder.ins().call(kernel, &[frame.buffer, address]);
                let load =
                    |place| builder.ins().stack_load(types::I64, types::F64, results, (place * SLOT) as i32);
                let values = (0..self.tape.outputs.len()).map(load).collect();
                Ok((builder, values))
            }
        }
    }
}

const MALFORMED: CodegenError = CodegenError::Malformed("a system with too few values");

/// Stores numbers at the start of a buffer.
fn store(builder: &mut FunctionBuilder, buffer: Value, numbers: &[Value]) {
    for (place, &number) in numbers.iter().enumerate() {
        builder.ins().store(TRUSTED, number, buffer, (place * SLOT) as i32);
    }
}

fn arguments(numbers: &[Value]) -> Vec<BlockArg> {
    numbers.iter().map(|&number| number.into()).collect()
}

/// Returns the arguments of the loop's first block.
fn state<const N: usize>(step: &Step<Value, N>, remaining: Value) -> Vec<BlockArg> {
    let mut numbers = step.numbers();
    numbers.push(remaining);
    arguments(&numbers)
}

/// Arithmetic that emits instructions with the semantics of [`calyx_abi::math`].
struct Instructions<'b, 'f>(&'b mut FunctionBuilder<'f>);

impl Arithmetic for Instructions<'_, '_> {
    type Number = Value;
    type Truth = Value;

    fn constant(&mut self, value: f64) -> Value {
        self.0.ins().f64const(value)
    }

    fn add(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().fadd(a, b)
    }

    fn subtract(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().fsub(a, b)
    }

    fn multiply(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().fmul(a, b)
    }

    fn divide(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().fdiv(a, b)
    }

    fn abs(&mut self, a: Value) -> Value {
        self.0.ins().fabs(a)
    }

    fn max(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().fmax(a, b)
    }

    fn less(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().fcmp(FloatCC::LessThan, a, b)
    }

    fn less_equal(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().fcmp(FloatCC::LessThanOrEqual, a, b)
    }

    fn both(&mut self, a: Value, b: Value) -> Value {
        self.0.ins().band(a, b)
    }

    fn choose(&mut self, condition: Value, a: Value, b: Value) -> Value {
        self.0.ins().select(condition, a, b)
    }
}
