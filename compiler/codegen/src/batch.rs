//! Kernels for many points: two points per SIMD register, tile by tile.
//!
//! A [`BatchTape`] splits a tape into a uniform part and stages. Each stage becomes functions of
//! about [`CHUNK`] operations. Each function loops over the pairs of points of a tile, so that the
//! data of a tile stay in the cache from one function to the next. Values that a later function
//! needs are stored in the tile, pair by pair. Between two stages,
//! [`calyx_abi::math::sincos_columns`] computes the sines and cosines of all angles of the tile
//! with the widest SIMD instructions available. The results have the same bits as those of the
//! kernel for one point.

mod run;

use crate::backend::Backend;
use crate::error::CodegenError;
use crate::function::TRUSTED;
use crate::jit::Jit;
use crate::module::ModuleLowering;
use crate::newton::Solver;
use crate::operation::{self, References};
use calyx_lang::ir::Program;
use calyx_symbolic::batch::{BatchTape, Source};
use calyx_symbolic::{Instruction, Tape};
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{AbiParam, InstBuilder, MemFlagsData, Signature, Value, types};
use cranelift_frontend::FunctionBuilder;
use cranelift_module::{FuncId, Module};
use std::collections::HashMap;

pub use run::{Batch, BatchError, BatchKernel};

/// Operations in one function. The cost of register allocation grows faster than linearly.
const CHUNK: usize = 1000;

/// Size of a pair of numbers, bytes.
const PAIR: usize = 16;

/// Target size of a tile, bytes: it should fit in the first-level cache together with inputs,
/// outputs and uniform values.
const TILE_BYTES: usize = 32 << 10;

/// Pairs of points in a tile: enough that the fixed cost per tile is small, even if each pair
/// stores many values.
const TILE_PAIRS: std::ops::RangeInclusive<usize> = 16..=64;

/// Flags for the caller's columns, which have any alignment; all other memory is aligned to pairs.
const ANYWHERE: MemFlagsData = MemFlagsData::new().with_notrap();

/// Number of operations after which a value in memory is loaded again instead of staying in a
/// register.
const RELOAD_AFTER: usize = 24;

/// Compiles a tape for evaluation at many points. `varying` is `true` for each input that varies.
///
/// # Errors
/// The tape is malformed, or Cranelift does not support the machine.
pub fn compile_batch(tape: &Tape, varying: &[bool]) -> Result<BatchKernel, CodegenError> {
    if !tape.is_well_formed() {
        return Err(CodegenError::Malformed("a tape that uses a value before it is there"));
    }
    let batch = BatchTape::new(tape.clone(), varying);
    let plan = Plan::new(&batch);
    let program = Program::default();
    let mut jit = Jit::of_kernels()?;
    let mut lowering = ModuleLowering::new(jit.module(), &program)?;
    let uniform = crate::kernel::lower(&mut lowering, "calyx_uniform", &batch.uniform)?;
    let solvers = crate::kernel::solvers(&mut lowering, "calyx_batch", &batch.tape)?;
    let mut functions = Vec::new();
    for chunk in 0..plan.chunks.len() {
        functions.push(define_chunk(&mut lowering, &batch, (&plan, &solvers), chunk)?);
    }
    lowering.compile()?;
    let code = jit.into_code()?;
    Ok(BatchKernel::new(&batch, &plan, code, uniform, &functions))
}

/// Some operations of a stage.
struct Chunk {
    stage: usize,
    operations: std::ops::Range<usize>,
    /// `true` for the first chunk of a stage, which also copies angles that no operation computes.
    first: bool,
    /// `true` for the last chunk, which also writes outputs that no operation computes.
    last: bool,
}

/// The locations in a tile of the sines and cosines of one stage, in bytes.
#[derive(Clone, Copy, Default)]
struct Angles {
    /// Start of the angles, pair by pair. The sines start at `offset + size`, the cosines at
    /// `offset + 2 * size`.
    offset: usize,
    size: usize,
    count: usize,
}

/// The chunks of a tape and the layout of a tile.
struct Plan {
    chunks: Vec<Chunk>,
    /// For each value that a later function needs, its index among the stored values.
    places: HashMap<u32, usize>,
    carried: usize,
    angles: Vec<Angles>,
    /// Pairs of points in a full tile.
    pairs: usize,
    /// Size of a tile, bytes. The stored values are at its start.
    size: usize,
}

impl Plan {
    fn new(batch: &BatchTape) -> Plan {
        let mut chunks = Vec::new();
        for (stage, operations) in batch.stages.iter().enumerate() {
            let share = operations.len().div_ceil(operations.len().div_ceil(CHUNK).max(1)).max(1);
            for start in (0..operations.len().max(1)).step_by(share) {
                let operations = start..(start + share).min(operations.len());
                chunks.push(Chunk { stage, operations, first: start == 0, last: false });
            }
        }
        if let Some(chunk) = chunks.last_mut() {
            chunk.last = true;
        }

        let mut last_use: HashMap<u32, usize> = HashMap::new();
        for (number, chunk) in chunks.iter().enumerate() {
            for &id in &batch.stages[chunk.stage][chunk.operations.clone()] {
                for operand in batch.tape.operands(batch.tape.instructions[id as usize]) {
                    last_use.insert(operand, number);
                }
            }
        }
        let (mut places, mut free, mut carried) = (HashMap::new(), Vec::new(), 0);
        let mut ending = vec![Vec::new(); chunks.len()];
        for (number, chunk) in chunks.iter().enumerate() {
            for id in &batch.stages[chunk.stage][chunk.operations.clone()] {
                let Some(&last) = last_use.get(id).filter(|&&last| last > number) else { continue };
                let place = free.pop().unwrap_or_else(|| {
                    carried += 1;
                    carried - 1
                });
                places.insert(*id, place);
                ending[last].push(place);
            }
            free.append(&mut ending[number]);
        }

        let per_pair = PAIR * (carried + 3 * batch.angles.iter().map(Vec::len).sum::<usize>()).max(1);
        let pairs = (TILE_BYTES / per_pair).clamp(*TILE_PAIRS.start(), *TILE_PAIRS.end());
        let mut size = carried * pairs * PAIR;
        let angles = batch.angles.iter().map(|angles| {
            let block = Angles { offset: size, size: angles.len() * pairs * PAIR, count: angles.len() };
            size += 3 * block.size;
            block
        });
        let angles = angles.collect();
        Plan { chunks, places, carried, angles, pairs, size }
    }
}

/// Returns the signature of [`run::ChunkFn`].
fn signature<M: Module>(module: &M) -> Signature {
    let mut signature = module.make_signature();
    signature.params.extend([AbiParam::new(types::I64); 5]);
    signature
}

fn define_chunk<M: Module>(
    module: &mut ModuleLowering<M>,
    batch: &BatchTape,
    (plan, solvers): (&Plan, &[FuncId]),
    number: usize,
) -> Result<FuncId, CodegenError> {
    let signature = signature(module.module);
    let id = module.module.declare_anonymous_function(&signature)?;
    let chunk = &plan.chunks[number];
    module.define(id, signature, |module, mut builder| {
        let entry = builder.create_block();
        builder.append_block_params_for_function_params(entry);
        builder.switch_to_block(entry);
        let &[table, columns, outputs, tile, pairs] = builder.block_params(entry) else {
            return Err(CodegenError::Malformed("a batch function of another signature"));
        };
        // One pointer per stride: into the columns, into the stored values, and into the angles of
        // each stage.
        let strides: Vec<usize> = [PAIR, plan.carried * PAIR]
            .into_iter()
            .chain(plan.angles.iter().map(|angles| angles.count * PAIR))
            .collect();
        let position = builder.ins().iconst(types::I64, 0);
        let mut starts = vec![position.into(), tile.into()];
        for angles in &plan.angles {
            starts.push(builder.ins().iadd_imm_s(tile, angles.offset as i64).into());
        }
        let bytes = builder.ins().imul_imm_s(pairs, PAIR as i64);
        let (body, done) = (builder.create_block(), builder.create_block());
        let pointers: Vec<Value> =
            strides.iter().map(|_| builder.append_block_param(body, types::I64)).collect();
        builder.ins().jump(body, &starts);
        builder.switch_to_block(body);

        let lanes = Lanes {
            module,
            builder,
            batch,
            plan,
            table,
            columns,
            outputs,
            pointers,
            values: HashMap::new(),
            read: HashMap::new(),
            addresses: HashMap::new(),
            done: 0,
            references: References::new(),
            solvers,
            solved: HashMap::new(),
        };
        let Lanes { module, mut builder, pointers, .. } = lanes.lower(chunk)?;
        let next: Vec<Value> = pointers
            .iter()
            .zip(&strides)
            .map(|(&pointer, &stride)| builder.ins().iadd_imm_s(pointer, stride as i64))
            .collect();
        let more = builder.ins().icmp(IntCC::UnsignedLessThan, next[0], bytes);
        let next: Vec<_> = next.into_iter().map(Into::into).collect();
        builder.ins().brif(more, body, &next, done, &[]);
        builder.switch_to_block(done);
        builder.ins().return_(&[]);
        builder.seal_all_blocks();
        builder.finalize(module.module.target_config());
        Ok(())
    })?;
    Ok(id)
}

/// The body of a loop over pairs of points, under construction.
struct Lanes<'c, 'm, 'f, M: Module> {
    module: &'c mut ModuleLowering<'m, M>,
    builder: FunctionBuilder<'f>,
    batch: &'c BatchTape,
    plan: &'c Plan,
    /// The uniform values, each stored twice.
    table: Value,
    /// The start addresses of input and output columns.
    columns: Value,
    outputs: Value,
    /// The loop's pointers, in the order of its strides.
    pointers: Vec<Value>,
    /// Values computed by this function.
    values: HashMap<u32, Value>,
    /// Values loaded from memory, with the number of operations at that time.
    read: HashMap<u32, (Value, usize)>,
    /// Addresses of input columns.
    addresses: HashMap<u32, Value>,
    /// Number of operations so far.
    done: usize,
    references: References,
    /// The functions that solve the tape's systems.
    solvers: &'c [FuncId],
    /// The unknowns of the implicit functions that this function solved.
    solved: HashMap<u32, Vec<Value>>,
}

impl<M: Module> Lanes<'_, '_, '_, M> {
    fn lower(mut self, chunk: &Chunk) -> Result<Self, CodegenError> {
        let batch = self.batch;
        let mut outputs: HashMap<u32, Vec<usize>> = HashMap::new();
        for (position, &output) in batch.tape.outputs.iter().enumerate() {
            outputs.entry(output).or_default().push(position);
        }
        // The angles that this function computes for any later stage.
        let mut angles: HashMap<u32, Vec<(usize, usize)>> = HashMap::new();
        for (stage, list) in batch.angles.iter().enumerate() {
            for (index, &angle) in list.iter().enumerate() {
                if matches!(batch.sources[angle as usize], Source::Stage(_)) {
                    angles.entry(angle).or_default().push((stage, index));
                } else if chunk.first && stage == chunk.stage {
                    let value = self.operand(angle)?;
                    self.store_angle(value, stage, index);
                }
            }
        }
        for &id in &batch.stages[chunk.stage][chunk.operations.clone()] {
            let value = self.compute(id)?;
            self.values.insert(id, value);
            if let Some(&place) = self.plan.places.get(&id) {
                let address = self.pointers[1];
                self.builder.ins().store(TRUSTED, value, address, (place * PAIR) as i32);
            }
            for &(stage, index) in angles.get(&id).into_iter().flatten() {
                self.store_angle(value, stage, index);
            }
            for &position in outputs.get(&id).into_iter().flatten() {
                self.store_output(value, position);
            }
        }
        if chunk.last {
            for (position, &output) in batch.tape.outputs.iter().enumerate() {
                if !matches!(batch.sources[output as usize], Source::Stage(_) | Source::Uniform(_)) {
                    let value = self.operand(output)?;
                    self.store_output(value, position);
                }
            }
        }
        Ok(self)
    }

    fn compute(&mut self, id: u32) -> Result<Value, CodegenError> {
        let instruction: Instruction = self.batch.tape.instructions[id as usize];
        if let Instruction::Solution(solve, unknown) = instruction {
            return self.solution(solve, unknown);
        }
        if let Instruction::Lookup(order, table, x) = instruction {
            let operands = [self.operand(table)?, self.operand(x)?];
            self.done += 1;
            let (module, builder) = (&mut *self.module, &mut self.builder);
            return operation::lookup(module, builder, &mut self.references, (types::F64X2, order), operands);
        }
        if let Instruction::Piecewise(table, x) = instruction {
            let x = self.operand(x)?;
            self.done += 1;
            let table = self.batch.tape.tables.get(table as usize);
            let table = table.ok_or(CodegenError::Malformed("a table that does not exist"))?;
            let (module, builder) = (&mut *self.module, &mut self.builder);
            return operation::piecewise(module, builder, &mut self.references, (types::F64X2, table), x);
        }
        let operands = self
            .batch
            .tape
            .operands(instruction)
            .map(|id| self.operand(id))
            .collect::<Result<Vec<_>, _>>()?;
        self.done += 1;
        operation::lower(
            self.module,
            &mut self.builder,
            &mut self.references,
            types::F64X2,
            instruction,
            &operands,
        )
    }

    /// Returns an unknown of an implicit function, which is solved lane by lane.
    fn solution(&mut self, solve: u32, unknown: u32) -> Result<Value, CodegenError> {
        if !self.solved.contains_key(&solve) {
            let (Some(solved), Some(&function)) =
                (self.batch.tape.solves.get(solve as usize), self.solvers.get(solve as usize))
            else {
                return Err(CodegenError::Malformed("a solution without equations"));
            };
            let operands =
                solved.operands.iter().map(|&id| self.operand(id)).collect::<Result<Vec<_>, _>>()?;
            let solver = Solver { function, unknowns: solved.system.unknowns };
            let mut lane = |lane: u8| {
                let builder = &mut self.builder;
                let operands: Vec<Value> =
                    operands.iter().map(|&operand| builder.ins().extractlane(operand, lane)).collect();
                solver.call(self.module, builder, &operands)
            };
            let (first, second) = (lane(0), lane(1));
            let joined = first.into_iter().zip(second).map(|(first, second)| {
                let both = self.builder.ins().splat(types::F64X2, first);
                self.builder.ins().insertlane(both, second, 1)
            });
            let joined = joined.collect();
            self.done += operands.len();
            self.solved.insert(solve, joined);
        }
        let found = self.solved.get(&solve).and_then(|unknowns| unknowns.get(unknown as usize));
        found.copied().ok_or(CodegenError::Malformed("an unknown that the equations lack"))
    }

    /// Returns an operand. Values in memory are loaded close to their use, to keep registers free.
    fn operand(&mut self, id: u32) -> Result<Value, CodegenError> {
        if let Some(value) = self.values.get(&id) {
            return Ok(*value);
        }
        if let Some(&(value, after)) = self.read.get(&id)
            && self.done - after < RELOAD_AFTER
        {
            return Ok(value);
        }
        let value = self.read_from_memory(id)?;
        self.read.insert(id, (value, self.done));
        Ok(value)
    }

    fn read_from_memory(&mut self, id: u32) -> Result<Value, CodegenError> {
        let (address, offset) = match self.batch.sources[id as usize] {
            Source::Uniform(slot) => (self.table, slot as usize * PAIR),
            Source::Column(input) => {
                let address = self.column(input)?;
                let position = self.builder.ins().iadd(address, self.pointers[0]);
                return Ok(self.builder.ins().load(types::F64X2, ANYWHERE, position, 0));
            }
            Source::Sine { stage, angle } => {
                let block = self.plan.angles[stage as usize];
                (self.pointers[stage as usize + 2], block.size + angle as usize * PAIR)
            }
            Source::Cosine { stage, angle } => {
                let block = self.plan.angles[stage as usize];
                (self.pointers[stage as usize + 2], 2 * block.size + angle as usize * PAIR)
            }
            Source::Stage(_) => match self.plan.places.get(&id) {
                Some(&place) => (self.pointers[1], place * PAIR),
                None => return Err(CodegenError::Malformed("a batch that carries too little")),
            },
        };
        Ok(self.builder.ins().load(types::F64X2, TRUSTED, address, offset as i32))
    }

    /// Returns the start of an input's column.
    fn column(&mut self, input: u32) -> Result<Value, CodegenError> {
        if let Some(address) = self.addresses.get(&input) {
            return Ok(*address);
        }
        let place = self.batch.varying.iter().take(input as usize).filter(|&&varies| varies).count();
        let offset = (place * size_of::<usize>()) as i32;
        let address = self.builder.ins().load(types::I64, TRUSTED, self.columns, offset);
        self.addresses.insert(input, address);
        Ok(address)
    }

    fn store_angle(&mut self, value: Value, stage: usize, index: usize) {
        self.builder.ins().store(TRUSTED, value, self.pointers[stage + 2], (index * PAIR) as i32);
    }

    fn store_output(&mut self, value: Value, position: usize) {
        let offset = (position * size_of::<usize>()) as i32;
        let address = self.builder.ins().load(types::I64, TRUSTED, self.outputs, offset);
        let address = self.builder.ins().iadd(address, self.pointers[0]);
        self.builder.ins().store(ANYWHERE, value, address, 0);
    }
}
