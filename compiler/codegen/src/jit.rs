//! The back end that places code in memory.

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

/// Address space reserved for one module, bytes. Pages use memory only when they are accessed. Code
/// and constants are close together, so that relative addresses reach them.
const ADDRESS_SPACE: usize = 256 << 20;

/// A back end that places code in memory.
pub struct Jit {
    module: JITModule,
    functions: Vec<Signature>,
    main: FunctionId,
}

/// The signature of a function, as its callers need it.
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

/// The symbols that code can reach: helpers, numeric functions and the given engine functions, but
/// no other symbol of the process.
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
    /// Allocates memory and creates the symbol table, with the externs that the program declares.
    pub fn new(program: &Program, externs: &[Extern], effort: Effort) -> Result<Self, CodegenError> {
        let symbols = Symbols::new(resolve_externs(program, externs)?);
        let functions = program.functions.iter().map(Signature::new).collect();
        Jit::with_address_space(native_isa(effort)?, symbols, ADDRESS_SPACE, functions, program.main)
    }

    /// Creates a back end as [`Jit::new`] does, with `bytes` bytes of address space.
    pub fn with_address_space(
        isa: OwnedTargetIsa,
        symbols: Symbols,
        space: usize,
        functions: Vec<Signature>,
        main: FunctionId,
    ) -> Result<Self, CodegenError> {
        let mut builder = JITBuilder::with_isa(isa, default_libcall_names());
        builder.symbols(symbols.0);
        // This lookup precedes the system's lookup and always succeeds, so the latter is never
        // used.
        builder.symbol_lookup_fn(Box::new(|_| Some(unresolved as *const u8)));
        let memory = ArenaMemoryProvider::new_with_size(space)
            .map_err(|error| CodegenError::Cranelift(format!("cannot reserve memory for code: {error}")))?;
        builder.memory_provider(Box::new(memory));
        Ok(Jit { module: JITModule::new(builder), functions, main })
    }

    /// Creates a back end for kernels only. Their functions are called by address
    /// ([`Code::address`]).
    pub fn of_kernels() -> Result<Self, CodegenError> {
        Jit::new(&Program::default(), &[], Effort::AsWritten)
    }

    /// Finishes a module of kernels.
    pub fn into_code(mut self) -> Result<Arc<Code>, CodegenError> {
        self.module.finalize_definitions()?;
        Ok(Arc::new(Code(Mutex::new(Some(self.module)))))
    }
}

/// Replaces symbols that are not in the table. The lowering declares no such symbol.
extern "C" fn unresolved() -> i32 {
    calyx_abi::Status::Failed as i32
}

impl Backend for Jit {
    type Module = JITModule;
    type Artifact = JitModule;

    fn module(&mut self) -> &mut JITModule {
        &mut self.module
    }

    fn quick_isa(&self) -> Result<Option<OwnedTargetIsa>, CodegenError> {
        native_isa(Effort::Quick).map(Some)
    }

    fn finish(mut self, lowered: Lowered) -> Result<JitModule, CodegenError> {
        self.module.finalize_definitions()?;
        let functions = lowered.functions.iter().zip(self.functions).map(|(&id, signature)| {
            let address = self.module.get_finalized_function(id);
            // SAFETY: the lowering defines every program function with this signature. The `Code`
            // is stored next to the table of functions and keeps them alive.
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

/// Owns code memory, and frees it when the module and all its kernels are dropped.
///
/// The mutex is never contended. It makes Cranelift's module, which is `Send` but not `Sync`,
/// shareable.
pub struct Code(Mutex<Option<JITModule>>);

impl Code {
    /// Returns the start of a function; null if it does not exist.
    pub fn address(&self, function: FuncId) -> *const u8 {
        let module = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        module.as_ref().map_or(std::ptr::null(), |module| module.get_finalized_function(function))
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        let module = self.0.get_mut().map(Option::take).unwrap_or_default();
        if let Some(module) = module {
            // SAFETY: every caller of the code owns an `Arc` of this value, so no code is running
            // and none will be called.
            unsafe { module.free_memory() };
            #[cfg(test)]
            tests::FREED.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        }
    }
}

/// A compiled program in memory. It can run any number of times, also on several threads with one
/// [`Context`] each.
pub struct JitModule {
    functions: Vec<(SlotFn, Signature)>,
    kernels: Vec<Arc<dyn Kernel>>,
    main: FunctionId,
    /// Dropped last; the kernels also keep it alive.
    code: Arc<Code>,
}

impl JitModule {
    /// Runs the top level of the model.
    ///
    /// # Errors
    /// Any error of the program or of the engine, with its source location.
    pub fn run_main(&self, ctx: &mut Context) -> Result<(), RuntimeError> {
        self.run_function(self.main, &[], ctx).map(|_| ())
    }

    /// Runs one function (for example a param's default) and returns the slots of its result,
    /// followed by those of its `out` and `inout` parameters. `arguments` contains the slots of its
    /// `in` and `inout` parameters.
    ///
    /// # Errors
    /// As for [`JitModule::run_main`].
    pub fn run_function(
        &self,
        id: FunctionId,
        arguments: &[Slot],
        ctx: &mut Context,
    ) -> Result<Vec<Slot>, RuntimeError> {
        // Values may come from other modules, but only the code of a live module may be entered.
        let _alive = &self.code;
        let Some((function, signature)) = self.functions.get(id.0 as usize) else {
            return Err(malformed("a function that is not there"));
        };
        if arguments.len() != signature.arguments {
            return Err(malformed("a call with too few arguments"));
        }
        ctx.place = signature.place;
        // SAFETY: the function is alive, and its slot counts are those of its signature.
        unsafe { stack::run(ctx, *function, arguments, signature.results) }
    }

    /// Returns one kernel per site, in order of the sites. The kernels keep the code alive.
    pub fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        self.kernels.clone()
    }
}

/// Wraps a function of signature [`KernelFn`] as a kernel that keeps its code alive.
pub fn kernel(code: &Arc<Code>, function: FuncId, inputs: usize, outputs: usize) -> Arc<dyn Kernel> {
    // SAFETY: the lowering defines every kernel with this signature; `JitKernel` keeps the code
    // alive.
    let call = unsafe { std::mem::transmute::<*const u8, KernelFn>(code.address(function)) };
    Arc::new(JitKernel { code: code.clone(), call, inputs, outputs })
}

/// A kernel in memory.
struct JitKernel {
    /// Keeps the code of `call` alive.
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
        // SAFETY: the code is alive; it reads `inputs` values and writes `outputs` values, and both
        // slices have these lengths.
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

    /// Returns a program whose top level is empty.
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
            ..Tape::default()
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
