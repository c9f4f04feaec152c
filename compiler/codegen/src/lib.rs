//! Machine code through Cranelift: in memory ([`compile_jit`]), as an object file ([`compile_object`]), or as data to be
//! kept and loaded again ([`compile_code`], [`load_code`]).
//!
//! One lowering (modules `module`, `function`, `kernel`) serves all, generic over where the code goes
//! ([`Backend`]). No other crate names Cranelift. Compiled code gives the same bits, the same errors and the
//! same places as the interpreter of `calyx-lower`: arithmetic is IEEE 754 without fused multiply-adds, everything
//! else is a call of the one definition in `calyx-abi`. No call unwinds: each returns a status, checked at once.

mod backend;
mod batch;
mod code;
mod error;
mod expression;
mod function;
mod jit;
mod kernel;
mod listing;
mod load;
mod module;
mod object;
mod operation;
mod place;
mod recorder;
mod scalar;
mod statement;
mod together;

pub use backend::{Backend, TargetCpu};
pub use batch::{Batch, BatchError, BatchKernel, compile_batch};
pub use code::{LoadError, Machine, ModuleCode};
pub use error::CodegenError;
pub use jit::JitModule;
pub use listing::{Listing, list};
pub use object::{ObjectOptions, model_symbol};

use calyx_abi::{Extern, Kernel};
use calyx_lang::ir::Program;
use calyx_lower::kernels::lower_sites;
use calyx_symbolic::Tape;
use std::sync::Arc;

/// Compiles a program into memory. `externs` are the functions of the engine; the program's own declarations are
/// looked up there by symbol, and code can reach nothing else.
///
/// # Errors
/// The engine lacks a function the program declares, a symbolic expression cannot be made a kernel, or the machine
/// is not one that Cranelift knows.
pub fn compile_jit(program: &Program, externs: &[Extern]) -> Result<JitModule, CodegenError> {
    compile_jit_with_tapes(program, &lower_sites(program).map_err(CodegenError::Kernel)?, externs)
}

/// As [`compile_jit`], with the kernels' tapes (one per site) made beforehand.
///
/// # Errors
/// As [`compile_jit`].
pub fn compile_jit_with_tapes(
    program: &Program,
    tapes: &[Tape],
    externs: &[Extern],
) -> Result<JitModule, CodegenError> {
    backend::compile(jit::Jit::new(program, externs, backend::Effort::Speed)?, program, tapes)
}

/// Compiles a program into code that can be kept: it says by name which functions of the engine it calls, so that
/// another process can load it.
///
/// # Errors
/// As [`compile_jit`], except that missing functions show when it is loaded.
pub fn compile_code(program: &Program, cpu: TargetCpu) -> Result<ModuleCode, CodegenError> {
    let tapes = lower_sites(program).map_err(CodegenError::Kernel)?;
    backend::compile(recorder::Recorder::new(program, cpu)?, program, &tapes)
}

/// Puts code that was kept into memory. `externs` are the functions of the engine; code can reach nothing else.
///
/// # Errors
/// The code refers to what is not there, or memory for it cannot be had. No code makes this panic.
///
/// # Safety
/// The code came from [`compile_code`] of the very same version of this crate and of `calyx-abi`, for a machine
/// ([`Machine`]) that can do no more than this one. It is run as it is: other bytes may do anything.
pub unsafe fn load_code(code: &ModuleCode, externs: &[Extern]) -> Result<JitModule, LoadError> {
    load::load(code, externs)
}

/// Compiles one tape for evaluation at one point at a time. For many points see [`compile_batch`].
///
/// # Errors
/// The tape is malformed, or the machine is not one that Cranelift knows.
pub fn compile_kernel(tape: &Tape) -> Result<Arc<dyn Kernel>, CodegenError> {
    let program = Program::default();
    let mut jit = jit::Jit::of_kernels()?;
    let mut lowering = module::ModuleLowering::new(jit.module(), &program)?;
    let function = kernel::lower(&mut lowering, "calyx_kernel", tape)?;
    Ok(jit::kernel(&jit.into_code()?, function, tape.inputs, tape.outputs.len()))
}

/// Compiles a program into an object file for this kind of machine, to be linked with `calyx-rt`.
///
/// It exports `NAME_model`, a [`calyx_abi::description::ModuleTable`], and, if it is to be an executable, `main`, which
/// calls `calyx_rt_main(argc, argv, &NAME_model)`.
///
/// # Errors
/// As [`compile_jit`], except that missing functions show when it is linked.
pub fn compile_object(program: &Program, options: &ObjectOptions) -> Result<Vec<u8>, CodegenError> {
    compile_object_with_tapes(program, &lower_sites(program).map_err(CodegenError::Kernel)?, options)
}

/// As [`compile_object`], with the kernels' tapes (one per site) made beforehand.
///
/// # Errors
/// As [`compile_object`].
pub fn compile_object_with_tapes(
    program: &Program,
    tapes: &[Tape],
    options: &ObjectOptions,
) -> Result<Vec<u8>, CodegenError> {
    backend::compile(object::ObjectFile::new(program, options)?, program, tapes)
}
