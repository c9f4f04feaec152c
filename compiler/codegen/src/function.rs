//! Lowers one function of the program: its frame, its calls, and the checks around them.
//!
//! Values are in registers, with one Cranelift value per slot: `F64` if the slot contains a number,
//! otherwise `I64`. Only the arguments and results of calls pass through memory, a buffer in the
//! frame.

use crate::error::CodegenError;
use crate::module::ModuleLowering;
use calyx_abi::context::{Layout, MAX_DEPTH};
use calyx_abi::description::LIBRARY;
use calyx_abi::{Repr, Status};
use calyx_lang::ir::{BlockId, Function, FunctionId, LocalId, Mode, Program};
use calyx_lang::span::Span;
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{
    Block, BlockArg, FuncRef, InstBuilder, MemFlagsData, StackSlot, StackSlotData, StackSlotKind, Type,
    Value, types,
};
use cranelift_frontend::{FunctionBuilder, Variable};
use cranelift_module::{FuncId, Module};
use std::collections::{BTreeMap, HashMap};

/// Flags for memory that is always mapped and aligned: the context, arguments, results, the buffer.
pub const TRUSTED: MemFlagsData = MemFlagsData::trusted();

/// Offsets of the source range of the innermost active call of a library function.
const LIBRARY_CALL: [usize; 3] =
    [Layout::LIBRARY_CALL_FILE, Layout::LIBRARY_CALL_START, Layout::LIBRARY_CALL_END];

/// Size of a slot, bytes.
pub const SLOT: usize = 8;

/// A function under construction.
pub struct FunctionLowering<'l, 'm, 'f, M: Module> {
    pub module: &'l mut ModuleLowering<'m, M>,
    pub builder: FunctionBuilder<'f>,
    pub function: &'m Function,
    /// For each local, one variable per slot.
    pub locals: Vec<Vec<Variable>>,
    /// Blocks in order of `Function::blocks`.
    pub blocks: Vec<Block>,
    context: Value,
    arguments: Value,
    results: Value,
    /// Block that takes a status, ends the current call and returns the status.
    leave: Block,
    /// Block that takes a status: the target of errors in the current block.
    on_error: Block,
    /// For each handler of the function, the value of `on_error` in the blocks that it covers.
    landings: BTreeMap<BlockId, Block>,
    /// Buffer for arguments and results, as large as the largest call needs.
    buffer: StackSlot,
    buffer_slots: usize,
    references: HashMap<FuncId, FuncRef>,
}

/// Returns the machine types of a value's slots.
pub fn slot_types(repr: &Repr) -> Vec<Type> {
    match repr {
        Repr::Number | Repr::Vector | Repr::Transform => vec![types::F64; repr.slots()],
        Repr::Tuple(parts) => parts.iter().flat_map(slot_types).collect(),
        _ => vec![types::I64; repr.slots()],
    }
}

/// Returns true for a location in a file of the library.
pub fn is_library(program: &Program, span: Span) -> bool {
    let file = program.files.get(span.file.0 as usize);
    file.is_some_and(|file| file.name.starts_with(LIBRARY))
}

impl<'l, 'm, 'f, M: Module> FunctionLowering<'l, 'm, 'f, M> {
    /// Starts a function: declares its variables and blocks.
    pub fn new(
        module: &'l mut ModuleLowering<'m, M>,
        mut builder: FunctionBuilder<'f>,
        function: &'m Function,
    ) -> Result<Self, CodegenError> {
        let entry = builder.create_block();
        builder.append_block_params_for_function_params(entry);
        builder.switch_to_block(entry);
        let &[context, arguments, results] = builder.block_params(entry) else {
            return Err(CodegenError::Malformed("a function of another signature"));
        };
        let leave = builder.create_block();
        builder.append_block_param(leave, types::I32);
        builder.set_cold_block(leave);
        let buffer = builder.create_sized_stack_slot(StackSlotData::new(StackSlotKind::ExplicitSlot, 0, 3));
        let locals = function.locals.iter().map(|local| {
            let types = slot_types(&local.repr);
            types.into_iter().map(|ty| builder.declare_var(ty)).collect()
        });
        let locals = locals.collect();
        let blocks = function.blocks.iter().map(|_| builder.create_block()).collect();
        Ok(FunctionLowering {
            module,
            builder,
            function,
            locals,
            blocks,
            context,
            arguments,
            results,
            leave,
            on_error: leave,
            landings: BTreeMap::new(),
            buffer,
            buffer_slots: 0,
            references: HashMap::new(),
        })
    }

    /// Lowers the whole function.
    pub fn lower(mut self) -> Result<(), CodegenError> {
        self.enter()?;
        for (index, block) in self.function.blocks.iter().enumerate() {
            self.on_error = self.landing(block.handler);
            self.builder.switch_to_block(self.blocks[index]);
            self.count_block(block.span)?;
            self.block(block)?;
        }
        for (handler, landing) in std::mem::take(&mut self.landings) {
            self.land(handler, landing)?;
        }
        self.builder.switch_to_block(self.leave);
        let status = self.builder.block_params(self.leave)[0];
        self.end_call();
        self.builder.ins().return_(&[status]);
        self.builder.seal_all_blocks();
        self.builder.func.sized_stack_slots[self.buffer].size = (self.buffer_slots * SLOT) as u32;
        self.builder.finalize(self.module.module.target_config());
        Ok(())
    }

    /// Counts the call, loads the arguments, sets all other locals to zero, and jumps to block 0.
    fn enter(&mut self) -> Result<(), CodegenError> {
        let depth = self.load_context(types::I64, Layout::DEPTH);
        let too_deep =
            self.builder.ins().icmp_imm_u(IntCC::UnsignedGreaterThanOrEqual, depth, MAX_DEPTH as i64);
        let (refuse, proceed) = (self.cold_block(), self.builder.create_block());
        self.builder.ins().brif(too_deep, refuse, &[], proceed, &[]);
        self.builder.switch_to_block(refuse);
        let status = self.helper_status("calyx_too_deep", &[])?;
        self.builder.ins().return_(&[status]);
        self.builder.switch_to_block(proceed);
        let deeper = self.builder.ins().iadd_imm_u(depth, 1);
        self.store_context(deeper, Layout::DEPTH);

        for local in 0..self.locals.len() {
            for (slot, ty) in slot_types(&self.function.locals[local].repr).into_iter().enumerate() {
                let zero = self.zero(ty);
                self.builder.def_var(self.locals[local][slot], zero);
            }
        }
        let mut at = 0;
        for (local, mode) in &self.function.parameters {
            if *mode != Mode::Out {
                let types = slot_types(self.local_repr(*local)?);
                let values = self.load_slots(self.arguments, at, &types);
                at += values.len();
                self.assign_local(*local, &values)?;
            }
        }
        let first = *self.blocks.first().ok_or(CodegenError::Malformed("a function without blocks"))?;
        self.builder.ins().jump(first, &[]);
        Ok(())
    }

    /// Returns the target of errors in blocks with this handler.
    fn landing(&mut self, handler: Option<BlockId>) -> Block {
        let Some(handler) = handler else { return self.leave };
        if let Some(landing) = self.landings.get(&handler) {
            return *landing;
        }
        let landing = self.cold_block();
        self.builder.append_block_param(landing, types::I32);
        self.landings.insert(handler, landing);
        landing
    }

    /// Emits the jump from a landing block to the handler, if the error can be caught.
    fn land(&mut self, handler: BlockId, landing: Block) -> Result<(), CodegenError> {
        let target = self.target(handler)?;
        self.builder.switch_to_block(landing);
        let status = self.builder.block_params(landing)[0];
        let failed = self.builder.ins().icmp_imm_s(IntCC::Equal, status, i64::from(Status::Failed as i32));
        self.builder.ins().brif(failed, target, &[], self.leave, &[BlockArg::Value(status)]);
        Ok(())
    }

    /// Returns the Cranelift block of a basic block.
    pub fn target(&self, block: BlockId) -> Result<Block, CodegenError> {
        let block = self.blocks.get(block.0 as usize).copied();
        block.ok_or(CodegenError::Malformed("a block that is not there"))
    }

    /// Decrements the number of basic blocks that the program may still enter, and fails at zero.
    fn count_block(&mut self, span: Span) -> Result<(), CodegenError> {
        let granted = self.load_context(types::I64, Layout::GRANTED);
        let (refuel, proceed) = (self.cold_block(), self.builder.create_block());
        let left = self.builder.append_block_param(proceed, types::I64);
        self.builder.ins().brif(granted, proceed, &[BlockArg::Value(granted)], refuel, &[]);
        self.builder.switch_to_block(refuel);
        self.at(span);
        self.helper("calyx_refuel", &[])?;
        let granted = self.load_context(types::I64, Layout::GRANTED);
        self.builder.ins().jump(proceed, &[BlockArg::Value(granted)]);
        self.builder.switch_to_block(proceed);
        let left = self.builder.ins().iadd_imm_s(left, -1);
        self.store_context(left, Layout::GRANTED);
        Ok(())
    }

    /// Stores the result and the values of `out` and `inout` parameters, and returns.
    pub fn return_values(&mut self, mut values: Vec<Value>) -> Result<(), CodegenError> {
        for (local, mode) in &self.function.parameters {
            if *mode != Mode::In {
                values.extend(self.local(*local)?);
            }
        }
        for (slot, value) in values.into_iter().enumerate() {
            self.builder.ins().store(TRUSTED, value, self.results, (slot * SLOT) as i32);
        }
        self.end_call();
        let ok = self.builder.ins().iconst(types::I32, 0);
        self.builder.ins().return_(&[ok]);
        Ok(())
    }

    fn end_call(&mut self) {
        let depth = self.load_context(types::I64, Layout::DEPTH);
        let depth = self.builder.ins().iadd_imm_s(depth, -1);
        self.store_context(depth, Layout::DEPTH);
    }

    /// Records the source range of the next operation, for errors.
    pub fn at(&mut self, span: Span) {
        self.store_place(span, [Layout::PLACE_FILE, Layout::PLACE_START, Layout::PLACE_END]);
    }

    fn store_place(&mut self, span: Span, offsets: [usize; 3]) {
        for (word, offset) in [span.file.0, span.start, span.end].into_iter().zip(offsets) {
            let value = self.builder.ins().iconst(types::I32, i64::from(word));
            self.store_context(value, offset);
        }
    }

    fn load_context(&mut self, ty: Type, offset: usize) -> Value {
        self.builder.ins().load(ty, TRUSTED, self.context, offset as i32)
    }

    fn store_context(&mut self, value: Value, offset: usize) {
        self.builder.ins().store(TRUSTED, value, self.context, offset as i32);
    }

    /// Calls a compiled or provided function with the slots of its arguments, and returns the slots
    /// of its results. If the call fails, `note` adds information to the error and returns the
    /// status.
    pub fn call_slots(
        &mut self,
        id: FuncId,
        arguments: &[Value],
        types: &[Type],
        note: impl FnOnce(&mut Self) -> Result<Value, CodegenError>,
    ) -> Result<Vec<Value>, CodegenError> {
        self.store_buffer(0, arguments);
        let into = arguments.len();
        let (from, to) = (self.buffer_address(0), self.buffer_address(into));
        self.reserve(into + types.len());
        let function = self.reference(id);
        let call = self.builder.ins().call(function, &[self.context, from, to]);
        let status = self.builder.inst_results(call)[0];
        let (failed, proceed) = (self.cold_block(), self.builder.create_block());
        self.builder.ins().brif(status, failed, &[], proceed, &[]);
        self.builder.switch_to_block(failed);
        let status = note(self)?;
        self.fail(status);
        self.builder.switch_to_block(proceed);
        Ok(self.load_buffer(into, types))
    }

    /// Calls a function of the program at a source location.
    pub fn call_function(
        &mut self,
        id: FunctionId,
        arguments: &[Value],
        types: &[Type],
        span: Span,
    ) -> Result<Vec<Value>, CodegenError> {
        let missing = CodegenError::Malformed("a function that is not there");
        let (Some(&target), Some(callee)) =
            (self.module.functions.get(id.0 as usize), self.module.program.functions.get(id.0 as usize))
        else {
            return Err(missing);
        };
        self.at(span);
        let program = self.module.program;
        let enters_library = !is_library(program, span) && is_library(program, callee.span);
        let around = enters_library.then(|| LIBRARY_CALL.map(|word| self.load_context(types::I32, word)));
        if enters_library {
            self.store_place(span, LIBRARY_CALL);
        }
        let restored = around.into_iter().flatten().zip(LIBRARY_CALL);
        let results = self.call_slots(target, arguments, types, |f| {
            restored.clone().for_each(|(value, offset)| f.store_context(value, offset));
            let [name, length] = f.constant(callee.name.as_bytes())?;
            let place = [span.file.0, span.start, span.end].map(|word| f.word(word as usize));
            f.helper_status("calyx_passed", &[&[name, length], &place[..]].concat())
        })?;
        restored.for_each(|(value, offset)| self.store_context(value, offset));
        Ok(results)
    }

    /// Jumps to the target of errors in the current block.
    pub fn fail(&mut self, status: Value) {
        self.builder.ins().jump(self.on_error, &[BlockArg::Value(status)]);
    }

    /// Calls a helper with words, and continues if it succeeds.
    pub fn helper(&mut self, symbol: &str, arguments: &[Value]) -> Result<(), CodegenError> {
        let status = self.helper_status(symbol, arguments)?;
        self.check(status);
        Ok(())
    }

    /// Calls a helper with words, and returns its status.
    pub fn helper_status(&mut self, symbol: &str, arguments: &[Value]) -> Result<Value, CodegenError> {
        let id = self.module.import(symbol)?;
        let function = self.reference(id);
        let arguments = [&[self.context], arguments].concat();
        let call = self.builder.ins().call(function, &arguments);
        Ok(self.builder.inst_results(call)[0])
    }

    /// Jumps to the target of errors unless the status is `Ok`.
    fn check(&mut self, status: Value) {
        let proceed = self.builder.create_block();
        self.builder.ins().brif(status, self.on_error, &[BlockArg::Value(status)], proceed, &[]);
        self.builder.switch_to_block(proceed);
    }

    /// Returns a reference to a function for calls from this one.
    pub fn reference(&mut self, id: FuncId) -> FuncRef {
        let (module, function) = (&mut *self.module.module, &mut *self.builder.func);
        *self.references.entry(id).or_insert_with(|| module.declare_func_in_func(id, function))
    }

    fn cold_block(&mut self) -> Block {
        let block = self.builder.create_block();
        self.builder.set_cold_block(block);
        block
    }

    /// Returns the address of a slot of the buffer.
    pub fn buffer_address(&mut self, slot: usize) -> Value {
        self.builder.ins().stack_addr(types::I64, self.buffer, (slot * SLOT) as i32)
    }

    fn reserve(&mut self, slots: usize) {
        self.buffer_slots = self.buffer_slots.max(slots);
    }

    /// Stores values in the buffer, starting at a slot.
    pub fn store_buffer(&mut self, slot: usize, values: &[Value]) {
        self.reserve(slot + values.len());
        let base = self.buffer_address(slot);
        for (index, &value) in values.iter().enumerate() {
            self.builder.ins().store(TRUSTED, value, base, (index * SLOT) as i32);
        }
    }

    /// Loads values from the buffer, starting at a slot.
    pub fn load_buffer(&mut self, slot: usize, types: &[Type]) -> Vec<Value> {
        self.reserve(slot + types.len());
        let base = self.buffer_address(slot);
        self.load_slots(base, 0, types)
    }

    /// Loads values from memory, starting at a slot.
    pub fn load_slots(&mut self, base: Value, slot: usize, types: &[Type]) -> Vec<Value> {
        let load = |(index, &ty): (usize, &Type)| {
            self.builder.ins().load(ty, TRUSTED, base, ((slot + index) * SLOT) as i32)
        };
        types.iter().enumerate().map(load).collect()
    }

    /// Returns address and length of constant bytes, as words.
    pub fn constant(&mut self, bytes: &[u8]) -> Result<[Value; 2], CodegenError> {
        let id = self.module.constant(bytes)?;
        let global = self.module.module.declare_data_in_func(id, self.builder.func);
        let address = self.builder.ins().symbol_value(types::I64, global);
        Ok([address, self.word(bytes.len())])
    }

    /// Returns a constant word.
    pub fn word(&mut self, value: usize) -> Value {
        self.builder.ins().iconst(types::I64, value as i64)
    }

    fn zero(&mut self, ty: Type) -> Value {
        if ty == types::F64 { self.builder.ins().f64const(0.0) } else { self.builder.ins().iconst(ty, 0) }
    }

    /// Returns the bits of a value as a word.
    pub fn bits(&mut self, value: Value) -> Value {
        if self.builder.func.dfg.value_type(value) == types::F64 {
            self.builder.ins().bitcast(types::I64, MemFlagsData::new(), value)
        } else {
            value
        }
    }

    /// Returns the representation of a local.
    pub fn local_repr(&self, local: LocalId) -> Result<&'m Repr, CodegenError> {
        let local = self.function.locals.get(local.0 as usize);
        local.map(|local| &local.repr).ok_or(CodegenError::Malformed("a local that is not there"))
    }

    /// Returns the current slots of a local.
    pub fn local(&mut self, local: LocalId) -> Result<Vec<Value>, CodegenError> {
        let variables = self.locals.get(local.0 as usize);
        let variables = variables.ok_or(CodegenError::Malformed("a local that is not there"))?;
        Ok(variables.iter().map(|&variable| self.builder.use_var(variable)).collect())
    }

    /// Assigns the slots of a local.
    pub fn assign_local(&mut self, local: LocalId, values: &[Value]) -> Result<(), CodegenError> {
        match self.locals.get(local.0 as usize) {
            Some(variables) if variables.len() == values.len() => self.assign_slots(local, 0, values),
            _ => Err(CodegenError::Malformed("a value of another representation than its place")),
        }
    }

    /// Assigns consecutive slots of a local, starting at `first`.
    pub fn assign_slots(
        &mut self,
        local: LocalId,
        first: usize,
        values: &[Value],
    ) -> Result<(), CodegenError> {
        let wrong = CodegenError::Malformed("a value of another representation than its place");
        let types = slot_types(self.local_repr(local)?);
        let Some(types) = types.get(first..first + values.len()) else { return Err(wrong) };
        let fits =
            values.iter().map(|&value| self.builder.func.dfg.value_type(value)).eq(types.iter().copied());
        if !fits {
            return Err(wrong);
        }
        let variables = self.locals[local.0 as usize].iter().skip(first);
        for (&variable, &value) in variables.zip(values) {
            self.builder.def_var(variable, value);
        }
        Ok(())
    }
}
