//! Code in memory.

use crate::backend::{Backend, Effort, Lowered, native_isa};
use crate::error::CodegenError;
use calyx_abi::call::KernelFn;
use calyx_abi::context::{Context, RuntimeError};
use calyx_abi::entry::entry_points;
use calyx_abi::helpers::malformed;
use calyx_abi::{Extern, Kernel, Slot, SlotFn, math, stack};
use calyx_lang::ir::{Function, FunctionId, Mode, Program};
use calyx_lower::link::resolve_externs;
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_jit::{ArenaMemoryProvider, JITBuilder, JITModule};
use cranelift_module::{FuncId, default_libcall_names};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Address space reserved for one module. Pages cost something only when they are used; code and its constants lie
/// close together, so that they reach each other by short offsets.
const ADDRESS_SPACE: usize = 256 << 20;

/// The back end that puts code into memory.
pub struct Jit {
    module: JITModule,
    functions: Vec<Signature>,
    main: FunctionId,
}

/// What a caller must know of a function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Signature {
    arguments: usize,
    results: usize,
    place: (u32, u32, u32),
}

impl Signature {
    pub fn new(function: &Function) -> Self {
        let (mut arguments, mut results) = (0, function.result.slots());
        for (local, mode) in &function.parameters {
            let slots = function.locals.get(local.0 as usize).map_or(0, |local| local.repr.slots());
            arguments += if *mode == Mode::Out { 0 } else { slots };
            results += if *mode == Mode::In { 0 } else { slots };
        }
        let span = function.span;
        Signature { arguments, results, place: (span.file.0, span.start, span.end) }
    }
}

/// What code can reach: the helpers, the numeric functions and the engine's functions it was given. Nothing else, in
/// particular no other symbol of the process.
pub struct Symbols(HashMap<&'static str, *const u8>);

impl Symbols {
    pub fn new<'e>(externs: impl IntoIterator<Item = &'e Extern>) -> Self {
        let helpers = entry_points().into_iter().map(|row| (row.symbol, row.address));
        let numeric = math::FUNCTIONS.iter().map(|&(symbol, function)| (symbol, function.address()));
        let externs = externs.into_iter().map(|row| (row.symbol, row.call as *const u8));
        Symbols(helpers.chain(numeric).chain(externs).collect())
    }

    pub fn contains(&self, symbol: &str) -> bool {
        self.0.contains_key(symbol)
    }
}

impl Jit {
    /// Prepares memory and the table of symbols, with the externs that the program declares.
    pub fn new(program: &Program, externs: &[Extern], effort: Effort) -> Result<Self, CodegenError> {
        let symbols = Symbols::new(resolve_externs(program, externs)?);
        let functions = program.functions.iter().map(Signature::new).collect();
        Jit::in_space(native_isa(effort)?, symbols, ADDRESS_SPACE, functions, program.main)
    }

    /// As [`Jit::new`], with so many bytes of address space.
    pub fn in_space(
        isa: OwnedTargetIsa,
        symbols: Symbols,
        space: usize,
        functions: Vec<Signature>,
        main: FunctionId,
    ) -> Result<Self, CodegenError> {
        let mut builder = JITBuilder::with_isa(isa, default_libcall_names());
        builder.symbols(symbols.0);
        // Asked before the system's own lookup, which therefore never answers.
        builder.symbol_lookup_fn(Box::new(|_| Some(unresolved as *const u8)));
        let memory = ArenaMemoryProvider::new_with_size(space)
            .map_err(|error| CodegenError::Cranelift(format!("cannot reserve memory for code: {error}")))?;
        builder.memory_provider(Box::new(memory));
        Ok(Jit { module: JITModule::new(builder), functions, main })
    }

    /// Memory for kernels alone. Their functions are called by address ([`Code::address`]).
    pub fn of_kernels() -> Result<Self, CodegenError> {
        Jit::new(&Program::default(), &[], Effort::AsWritten)
    }

    /// Ends a module of kernels.
    pub fn into_code(mut self) -> Result<Arc<Code>, CodegenError> {
        self.module.finalize_definitions()?;
        Ok(Arc::new(Code(Mutex::new(Some(self.module)))))
    }
}

/// Stands for every symbol that is not in the tables. The lowering declares none such.
extern "C" fn unresolved() -> i32 {
    calyx_abi::Status::Failed as i32
}

impl Backend for Jit {
    type Module = JITModule;
    type Artifact = JitModule;

    fn module(&mut self) -> &mut JITModule {
        &mut self.module
    }

    fn finish(mut self, lowered: Lowered) -> Result<JitModule, CodegenError> {
        self.module.finalize_definitions()?;
        let functions = lowered.functions.iter().zip(self.functions).map(|(&id, signature)| {
            let address = self.module.get_finalized_function(id);
            // SAFETY: the lowering gave every function of the program this signature. The code lives as long as
            // the `Code` that the table of functions is kept beside.
            let call = unsafe { std::mem::transmute::<*const u8, SlotFn>(address) };
            (call, signature)
        });
        let functions = functions.collect();
        let code = Arc::new(Code(Mutex::new(Some(self.module))));
        let kernels = lowered.kernels.iter();
        let kernels =
            kernels.map(|found| kernel(&code, found.function, found.inputs, found.outputs)).collect();
        Ok(JitModule { functions, kernels, main: self.main, code })
    }
}

/// Owns code memory and frees it when the module and all its kernels are gone.
///
/// The mutex is never contended; it only makes Cranelift's module, which is `Send`, shareable.
pub struct Code(Mutex<Option<JITModule>>);

impl Code {
    /// Where a function of this code begins; null if there is none.
    pub fn address(&self, function: FuncId) -> *const u8 {
        let module = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        module.as_ref().map_or(std::ptr::null(), |module| module.get_finalized_function(function))
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        let module = self.0.get_mut().map(Option::take).unwrap_or_default();
        if let Some(module) = module {
            // SAFETY: whoever calls the code holds an `Arc` of this, so nothing runs in it and nobody will call it.
            unsafe { module.free_memory() };
            #[cfg(test)]
            tests::FREED.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        }
    }
}

/// A compiled program in memory. Can be run any number of times, by several threads with a [`Context`] each.
pub struct JitModule {
    functions: Vec<(SlotFn, Signature)>,
    kernels: Vec<Arc<dyn Kernel>>,
    main: FunctionId,
    /// Dropped last, though the kernels keep it alive as well.
    code: Arc<Code>,
}

impl JitModule {
    /// Runs the top level of the model.
    ///
    /// # Errors
    /// What the program or the engine fails with, and where.
    pub fn run_main(&self, ctx: &mut Context) -> Result<(), RuntimeError> {
        self.run_function(self.main, &[], ctx).map(|_| ())
    }

    /// Runs one function (a param's default, say) and returns the slots of its result, followed by those of its
    /// `out` and `inout` parameters. `arguments` holds the slots of its `in` and `inout` parameters.
    ///
    /// # Errors
    /// As for [`JitModule::run_main`].
    pub fn run_function(
        &self,
        id: FunctionId,
        arguments: &[Slot],
        ctx: &mut Context,
    ) -> Result<Vec<Slot>, RuntimeError> {
        // Code of other modules may have made this one's values, but only a live module may be entered.
        let _alive = &self.code;
        let Some((function, signature)) = self.functions.get(id.0 as usize) else {
            return Err(malformed("a function that is not there"));
        };
        if arguments.len() != signature.arguments {
            return Err(malformed("a call with too few arguments"));
        }
        ctx.place = signature.place;
        // SAFETY: the function is alive, and takes and returns as many slots as its signature says.
        unsafe { stack::run(ctx, *function, arguments, signature.results) }
    }

    /// One kernel per site, in order of site; they keep the code alive.
    pub fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        self.kernels.clone()
    }
}

/// A function of signature [`KernelFn`] as a kernel that keeps its code alive.
pub fn kernel(code: &Arc<Code>, function: FuncId, inputs: usize, outputs: usize) -> Arc<dyn Kernel> {
    // SAFETY: the lowering gave every kernel this signature; `JitKernel` keeps the code alive.
    let call = unsafe { std::mem::transmute::<*const u8, KernelFn>(code.address(function)) };
    Arc::new(JitKernel { code: code.clone(), call, inputs, outputs })
}

/// A kernel in memory.
struct JitKernel {
    /// Keeps the code that `call` points into.
    #[expect(dead_code, reason = "held for its lifetime only")]
    code: Arc<Code>,
    call: KernelFn,
    inputs: usize,
    outputs: usize,
}

impl Kernel for JitKernel {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        assert!(
            inputs.len() >= self.inputs && outputs.len() >= self.outputs,
            "kernel called with too few values"
        );
        // SAFETY: the code is alive, reads `inputs` values and writes `outputs` values, which are there.
        unsafe { (self.call)(inputs.as_ptr(), outputs.as_mut_ptr()) }
    }

    fn inputs(&self) -> usize {
        self.inputs
    }

    fn outputs(&self) -> usize {
        self.outputs
    }
}

#[cfg(test)]
mod tests {
    use crate::compile_jit_with_tapes;
    use calyx_abi::Repr;
    use calyx_lang::ir::{Block, Function, Program, Terminator};
    use calyx_lang::span::Span;
    use calyx_symbolic::{Instruction, Tape};
    use std::sync::atomic::{AtomicUsize, Ordering};

    pub(super) static FREED: AtomicUsize = AtomicUsize::new(0);

    /// A program whose top level does nothing.
    fn empty_program() -> Program {
        let main = Function {
            name: "main".into(),
            parameters: vec![],
            result: Repr::Unit,
            locals: vec![],
            blocks: vec![Block {
                statements: vec![],
                terminator: Terminator::Return(None),
                handler: None,
                span: Span::default(),
            }],
            span: Span::default(),
        };
        Program { functions: vec![main], ..Program::default() }
    }

    #[test]
    fn code_is_freed_with_its_last_user() {
        let tape = Tape {
            inputs: 1,
            instructions: vec![Instruction::Input(0), Instruction::Sin(0)],
            outputs: vec![1],
        };
        let program = empty_program();
        for cycle in 0..1000 {
            let module = compile_jit_with_tapes(&program, std::slice::from_ref(&tape), &[]).unwrap();
            let kernels = module.kernels();
            drop(module);
            assert_eq!(FREED.load(Ordering::Relaxed), cycle, "the kernel still needs the code");
            let mut output = [0.0];
            kernels[0].eval(&[0.5], &mut output);
            assert_eq!(output[0], calyx_abi::math::sin(0.5));
            drop(kernels);
            assert_eq!(FREED.load(Ordering::Relaxed), cycle + 1);
        }
    }
}
