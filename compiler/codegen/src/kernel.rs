//! Compiles a tape to straight-line code.
//!
//! The cost of register allocation grows faster than the length of a function. A long tape is
//! therefore split into functions of about [`CHUNK`] operations, which are called in sequence.
//! Values that a later function needs are stored in scratch memory in the kernel's frame. Scratch
//! slots are reused after the last use of their values.

use crate::batched_sincos;
use crate::error::CodegenError;
use crate::function::{SLOT, TRUSTED};
use crate::module::ModuleLowering;
use crate::newton::{self, Solver};
use crate::operation::{self, References};
use calyx_symbolic::{Instruction, System, Tape};
use cranelift_codegen::ir::{
    AbiParam, InstBuilder, Signature, StackSlot, StackSlotData, StackSlotKind, Value, types,
};
use cranelift_codegen::isa::CallConv;
use cranelift_frontend::FunctionBuilder;
use cranelift_module::{FuncId, Linkage, Module};
use std::collections::HashMap;
use std::sync::Arc;

/// Operations in one function. On graphs of 30,000 operations, both compile time and run time have
/// their minimum here.
const CHUNK: usize = 1000;

/// Limit of the scratch values in a kernel's frame (512 KiB), because the threads of thread pools
/// have small stacks.
const MAX_SCRATCH: usize = 1 << 16;

/// Defines a kernel of signature [`calyx_abi::call::KernelFn`].
pub fn lower<M: Module>(
    module: &mut ModuleLowering<M>,
    name: &str,
    tape: &Tape,
) -> Result<FuncId, CodegenError> {
    if !tape.is_well_formed() {
        return Err(CodegenError::Malformed("a tape that uses a value before it is there"));
    }
    let tape = &*batched_sincos::gathered(tape);
    let plan = Plan::new(tape)?;
    let solvers = solvers(module, name, tape)?;
    let pointers = |count: usize| {
        let mut signature = module.module.make_signature();
        signature.params.extend(std::iter::repeat_n(AbiParam::new(types::I64), count));
        signature
    };
    let (kernel_signature, chunk_signature) = (pointers(2), pointers(3));
    let kernel = module.module.declare_function(name, Linkage::Local, &kernel_signature)?;
    if let [range] = &plan.chunks[..] {
        define_chunk(module, kernel, kernel_signature, tape, (&plan, &solvers), range.clone())?;
        return Ok(kernel);
    }
    let mut chunks = Vec::new();
    for range in &plan.chunks {
        let id = module.module.declare_anonymous_function(&chunk_signature)?;
        define_chunk(module, id, chunk_signature.clone(), tape, (&plan, &solvers), range.clone())?;
        chunks.push(id);
    }
    module.define(kernel, kernel_signature, |module, mut builder| {
        let [inputs, outputs] = entry(&mut builder)?;
        let size = (plan.scratch * SLOT) as u32;
        let scratch =
            builder.create_sized_stack_slot(StackSlotData::new(StackSlotKind::ExplicitSlot, size, 3));
        let scratch = builder.ins().stack_addr(types::I64, scratch, 0);
        for id in chunks {
            let chunk = module.module.declare_func_in_func(id, builder.func);
            builder.ins().call(chunk, &[inputs, outputs, scratch]);
        }
        finish(module, builder);
        Ok(())
    })?;
    Ok(kernel)
}

/// Defines the functions that solve a tape's systems, in order of [`Tape::solves`]. Equal systems
/// share a function.
pub fn solvers<M: Module>(
    module: &mut ModuleLowering<M>,
    name: &str,
    tape: &Tape,
) -> Result<Vec<FuncId>, CodegenError> {
    let mut known: HashMap<*const System, FuncId> = HashMap::new();
    let mut functions = Vec::with_capacity(tape.solves.len());
    for solve in &tape.solves {
        let system = Arc::as_ptr(&solve.system);
        let function = match known.get(&system) {
            Some(&function) => function,
            None => newton::define(module, &format!("{name}_solve_{}", known.len()), &solve.system)?,
        };
        known.insert(system, function);
        functions.push(function);
    }
    Ok(functions)
}

/// Evaluates a tape within the function under construction, and returns the builder and the
/// outputs. `inputs` are the inputs of the tape.
pub fn inline<'f, M: Module>(
    module: &mut ModuleLowering<M>,
    builder: FunctionBuilder<'f>,
    (tape, solvers): (&Tape, &[FuncId]),
    inputs: &[Value],
) -> Result<(FunctionBuilder<'f>, Vec<Value>), CodegenError> {
    let range = 0..tape.instructions.len();
    let plan = Plan { chunks: Vec::new(), places: HashMap::new(), scratch: 0 };
    let mut runs = batched_sincos::runs(tape, &range).into_iter().peekable();
    let mut chunk = Chunk::new(module, builder, (tape, range.clone()), &plan, solvers);
    chunk.inputs = Inputs::Values(inputs);
    for index in range {
        if let Some(run) = runs.next_if(|run| run.start == index) {
            chunk.take_together(&run.angles)?;
        }
        if !tape.instructions[index].is_leaf() && chunk.in_buffer(index).is_none() {
            chunk.value(index)?;
        }
    }
    let outputs = tape.outputs.iter().map(|&output| chunk.operand(output)).collect::<Result<Vec<_>, _>>()?;
    Ok((chunk.builder, outputs))
}

/// The instructions of each function, and the values passed between functions.
struct Plan {
    /// Ranges of instructions.
    chunks: Vec<std::ops::Range<usize>>,
    /// For each value that a later chunk needs, its slot in scratch memory.
    places: HashMap<usize, usize>,
    /// Number of scratch slots.
    scratch: usize,
}

impl Plan {
    fn new(tape: &Tape) -> Result<Plan, CodegenError> {
        let count = tape.instructions.len();
        // Chunks have equal numbers of operations. Constants and inputs are free and computed where
        // they are used.
        let operations = tape.operations();
        let share = operations.div_ceil(operations.div_ceil(CHUNK).max(1)).max(1);
        let mut chunk_of = vec![0; count];
        let mut done = 0;
        for (index, instruction) in tape.instructions.iter().enumerate() {
            chunk_of[index] = done / share;
            done += usize::from(!instruction.is_leaf());
        }
        let last = chunk_of.last().copied().unwrap_or(0);
        let start = |chunk| chunk_of.partition_point(|&c| c < chunk);
        let chunks: Vec<_> = (0..=last).map(|chunk| start(chunk)..start(chunk + 1)).collect();

        let mut last_use = chunk_of.clone();
        for (index, instruction) in tape.instructions.iter().enumerate() {
            for operand in tape.operands(*instruction) {
                let operand = operand as usize;
                last_use[operand] = last_use[operand].max(chunk_of[index]);
            }
        }
        let (mut places, mut free, mut scratch) = (HashMap::new(), Vec::new(), 0);
        // Values by the chunk of their last use; their slots are free for the results of later
        // chunks.
        let mut ending = vec![Vec::new(); chunks.len()];
        for (chunk, range) in chunks.iter().enumerate() {
            for index in range.clone() {
                if last_use[index] > chunk && !tape.instructions[index].is_leaf() {
                    let place = free.pop().unwrap_or_else(|| {
                        scratch += 1;
                        scratch - 1
                    });
                    places.insert(index, place);
                    ending[last_use[index]].push(place);
                }
            }
            free.append(&mut ending[chunk]);
        }
        if scratch > MAX_SCRATCH {
            return Err(CodegenError::Malformed("a kernel too large for its frame"));
        }
        Ok(Plan { chunks, places, scratch })
    }
}

/// Starts a function and returns its parameters.
pub fn entry<const N: usize>(builder: &mut FunctionBuilder) -> Result<[Value; N], CodegenError> {
    let block = builder.create_block();
    builder.append_block_params_for_function_params(block);
    builder.switch_to_block(block);
    let params = builder.block_params(block).get(..N).and_then(|params| params.try_into().ok());
    params.ok_or(CodegenError::Malformed("a kernel of another signature"))
}

/// Returns from a function and finishes it.
pub fn finish<M: Module>(module: &ModuleLowering<M>, mut builder: FunctionBuilder) {
    builder.ins().return_(&[]);
    builder.seal_all_blocks();
    builder.finalize(module.module.target_config());
}

/// Defines the function for a range of instructions.
fn define_chunk<M: Module>(
    module: &mut ModuleLowering<M>,
    id: FuncId,
    signature: Signature,
    tape: &Tape,
    (plan, solvers): (&Plan, &[FuncId]),
    range: std::ops::Range<usize>,
) -> Result<(), CodegenError> {
    module.define(id, signature, |module, mut builder| {
        let [inputs, outputs] = entry(&mut builder)?;
        let block = builder.current_block();
        let scratch = block.and_then(|block| builder.block_params(block).get(2).copied());
        let mut wanted: HashMap<usize, Vec<usize>> = HashMap::new();
        for (position, &output) in tape.outputs.iter().enumerate() {
            wanted.entry(output as usize).or_default().push(position);
        }
        let mut runs = batched_sincos::runs(tape, &range).into_iter().peekable();
        let mut chunk = Chunk::new(module, builder, (tape, range.clone()), plan, solvers);
        (chunk.inputs, chunk.scratch) = (Inputs::Memory(inputs), scratch);
        for index in range {
            if let Some(run) = runs.next_if(|run| run.start == index) {
                chunk.take_together(&run.angles)?;
            }
            let outputs_here = wanted.get(&index);
            // Leaves are free, and buffered values are loaded where they are used.
            let waits = tape.instructions[index].is_leaf() || chunk.in_buffer(index).is_some();
            if waits && outputs_here.is_none() && !plan.places.contains_key(&index) {
                continue;
            }
            let value = chunk.value(index)?;
            if let Some(&place) = plan.places.get(&index)
                && let Some(scratch) = scratch
            {
                chunk.builder.ins().store(TRUSTED, value, scratch, (place * SLOT) as i32);
            }
            for &position in outputs_here.into_iter().flatten() {
                chunk.builder.ins().store(TRUSTED, value, outputs, (position * SLOT) as i32);
            }
        }
        let Chunk { module, builder, .. } = chunk;
        finish(module, builder);
        Ok(())
    })
}

/// Returns the angles in a range of instructions whose sine and cosine are both needed there.
fn sine_cosine_pairs(tape: &Tape, range: &std::ops::Range<usize>) -> HashMap<u32, Option<[Value; 2]>> {
    let mut wanted: HashMap<u32, (bool, bool)> = HashMap::new();
    for instruction in &tape.instructions[range.clone()] {
        match *instruction {
            Instruction::Sin(angle) => wanted.entry(angle).or_default().0 = true,
            Instruction::Cos(angle) => wanted.entry(angle).or_default().1 = true,
            _ => {}
        }
    }
    wanted.into_iter().filter(|(_, both)| *both == (true, true)).map(|(angle, _)| (angle, None)).collect()
}

/// The inputs of a tape.
#[derive(Clone, Copy)]
enum Inputs<'c> {
    /// The address of the first one.
    Memory(Value),
    Values(&'c [Value]),
}

/// A function of a kernel, under construction.
struct Chunk<'c, 'm, 'f, M: Module> {
    module: &'c mut ModuleLowering<'m, M>,
    builder: FunctionBuilder<'f>,
    tape: &'c Tape,
    plan: &'c Plan,
    inputs: Inputs<'c>,
    scratch: Option<Value>,
    /// Available values, by instruction.
    values: HashMap<usize, Value>,
    references: References,
    /// Sine and cosine of angles that need both, once computed.
    pairs: HashMap<u32, Option<[Value; 2]>>,
    /// Angles whose sines and cosines were computed together with others.
    together: HashMap<u32, Buffered>,
    /// The functions that solve the tape's systems.
    solvers: &'c [FuncId],
    /// The unknowns of the implicit functions that this function solved.
    solved: HashMap<u32, Vec<Value>>,
}

/// The locations of an angle's sine and cosine in a buffer.
#[derive(Clone, Copy)]
struct Buffered {
    buffer: StackSlot,
    sine: i32,
    cosine: i32,
}

impl<'c, 'm, 'f, M: Module> Chunk<'c, 'm, 'f, M> {
    /// Starts a function without inputs and scratch memory.
    fn new(
        module: &'c mut ModuleLowering<'m, M>,
        builder: FunctionBuilder<'f>,
        (tape, range): (&'c Tape, std::ops::Range<usize>),
        plan: &'c Plan,
        solvers: &'c [FuncId],
    ) -> Self {
        Chunk {
            module,
            builder,
            tape,
            plan,
            inputs: Inputs::Values(&[]),
            scratch: None,
            values: HashMap::new(),
            references: HashMap::new(),
            pairs: sine_cosine_pairs(tape, &range),
            together: HashMap::new(),
            solvers,
            solved: HashMap::new(),
        }
    }

    /// Returns the value of an instruction: available, loaded from scratch memory, or computed.
    fn value(&mut self, index: usize) -> Result<Value, CodegenError> {
        if let Some(value) = self.values.get(&index) {
            return Ok(*value);
        }
        let value = self.compute(index)?;
        self.values.insert(index, value);
        Ok(value)
    }

    /// Returns the buffer and the offset of a buffered sine or cosine.
    fn in_buffer(&self, index: usize) -> Option<(StackSlot, i32)> {
        match self.tape.instructions[index] {
            Instruction::Sin(angle) => self.together.get(&angle).map(|found| (found.buffer, found.sine)),
            Instruction::Cos(angle) => self.together.get(&angle).map(|found| (found.buffer, found.cosine)),
            _ => None,
        }
    }

    /// Computes the sines and cosines of several angles with one call.
    fn take_together(&mut self, angles: &[u32]) -> Result<(), CodegenError> {
        let count = angles.len().next_multiple_of(batched_sincos::WIDTH);
        let block = (count * SLOT) as i32;
        let data = StackSlotData::new(StackSlotKind::ExplicitSlot, 3 * block as u32, 3);
        let buffer = self.builder.create_sized_stack_slot(data);
        for place in 0..count {
            let angle = match angles.get(place) {
                Some(&angle) => self.operand(angle)?,
                None => self.builder.ins().f64const(0.0),
            };
            self.builder.ins().stack_store(types::I64, angle, buffer, (place * SLOT) as i32);
        }
        let [from, sines, cosines] =
            [0, block, 2 * block].map(|offset| self.builder.ins().stack_addr(types::I64, buffer, offset));
        let length = self.builder.ins().iconst(types::I64, count as i64);
        let symbol = "calyx_math_sincos_columns";
        let function = operation::reference(self.module, &mut self.builder, &mut self.references, symbol)?;
        self.builder.ins().call(function, &[from, length, sines, cosines]);
        for (place, &angle) in angles.iter().enumerate() {
            let sine = block + (place * SLOT) as i32;
            self.together.insert(angle, Buffered { buffer, sine, cosine: sine + block });
        }
        Ok(())
    }

    /// Returns an operand. Operands from other functions are loaded from scratch memory.
    fn operand(&mut self, id: u32) -> Result<Value, CodegenError> {
        let index = id as usize;
        if let Some((buffer, offset)) = self.in_buffer(index) {
            return Ok(self.builder.ins().stack_load(types::I64, types::F64, buffer, offset));
        }
        if !self.values.contains_key(&index)
            && let (Some(&place), Some(scratch)) = (self.plan.places.get(&index), self.scratch)
        {
            let value = self.builder.ins().load(types::F64, TRUSTED, scratch, (place * SLOT) as i32);
            self.values.insert(index, value);
        }
        self.value(index)
    }

    fn compute(&mut self, index: usize) -> Result<Value, CodegenError> {
        let instruction = self.tape.instructions[index];
        match instruction {
            Instruction::Constant(value) => return Ok(self.builder.ins().f64const(value)),
            Instruction::Input(input) => match self.inputs {
                Inputs::Memory(address) => {
                    let offset = (input as usize * SLOT) as i32;
                    return Ok(self.builder.ins().load(types::F64, TRUSTED, address, offset));
                }
                Inputs::Values(values) => {
                    let value = values.get(input as usize).copied();
                    return value.ok_or(CodegenError::Malformed("a tape with too few inputs"));
                }
            },
            Instruction::Sin(angle) | Instruction::Cos(angle) => {
                if let Some((buffer, offset)) = self.in_buffer(index) {
                    return Ok(self.builder.ins().stack_load(types::I64, types::F64, buffer, offset));
                }
                if let Some([sine, cosine]) = self.sine_cosine(angle)? {
                    return Ok(if matches!(instruction, Instruction::Sin(_)) { sine } else { cosine });
                }
            }
            Instruction::Solution(solve, unknown) => return self.solution(solve, unknown),
            Instruction::Lookup(order, table, x) => {
                let operands = [self.operand(table)?, self.operand(x)?];
                let (module, builder) = (&mut *self.module, &mut self.builder);
                return operation::lookup(
                    module,
                    builder,
                    &mut self.references,
                    (types::F64, order),
                    operands,
                );
            }
            Instruction::Piecewise(table, x) => {
                let x = self.operand(x)?;
                let tables = &self.tape.tables;
                let table = tables.get(table as usize);
                let table = table.ok_or(CodegenError::Malformed("a table that does not exist"))?;
                let (module, builder) = (&mut *self.module, &mut self.builder);
                return operation::piecewise(module, builder, &mut self.references, (types::F64, table), x);
            }
            _ => {}
        }
        let operands =
            self.tape.operands(instruction).map(|id| self.operand(id)).collect::<Result<Vec<_>, _>>()?;
        operation::lower(
            self.module,
            &mut self.builder,
            &mut self.references,
            types::F64,
            instruction,
            &operands,
        )
    }

    /// Returns an unknown of an implicit function. All its unknowns are computed with one call.
    fn solution(&mut self, solve: u32, unknown: u32) -> Result<Value, CodegenError> {
        if !self.solved.contains_key(&solve) {
            let (Some(solved), Some(&function)) =
                (self.tape.solves.get(solve as usize), self.solvers.get(solve as usize))
            else {
                return Err(CodegenError::Malformed("a solution without equations"));
            };
            let operands =
                solved.operands.iter().map(|&id| self.operand(id)).collect::<Result<Vec<_>, _>>()?;
            let solver = Solver { function, unknowns: solved.system.unknowns };
            let found = solver.call(self.module, &mut self.builder, &operands);
            self.solved.insert(solve, found);
        }
        let found = self.solved.get(&solve).and_then(|unknowns| unknowns.get(unknown as usize));
        found.copied().ok_or(CodegenError::Malformed("an unknown that the equations lack"))
    }

    /// Computes sine and cosine of an angle with one call, if both are needed.
    fn sine_cosine(&mut self, angle: u32) -> Result<Option<[Value; 2]>, CodegenError> {
        let known = match self.pairs.get(&angle) {
            None => return Ok(None),
            Some(known) => *known,
        };
        if known.is_some() {
            return Ok(known);
        }
        // Elsewhere, the convention of C returns a pair through memory.
        let convention = self.module.module.target_config().default_call_conv;
        if !matches!(convention, CallConv::SystemV | CallConv::AppleAarch64) {
            return Ok(None);
        }
        let argument = self.operand(angle)?;
        let builder = &mut self.builder;
        let function = operation::reference(self.module, builder, &mut self.references, "calyx_math_sincos")?;
        let call = builder.ins().call(function, &[argument]);
        let &[sine, cosine] = builder.inst_results(call) else {
            return Err(CodegenError::Malformed("a sine without a cosine"));
        };
        let pair = [sine, cosine];
        self.pairs.insert(angle, Some(pair));
        Ok(Some(pair))
    }
}
