//! Machine code through Cranelift: in memory ([`compile_jit`]) or as an object file ([`compile_object`]).
//!
//! One lowering (modules `module`, `function`, `kernel`) serves both, generic over where the code goes
//! ([`Backend`]). No other crate names Cranelift. Compiled code gives the same bits, the same errors and the
//! same places as the interpreter of `calyx-lower`: arithmetic is IEEE 754 without fused multiply-adds, everything
//! else is a call of the one definition in `calyx-abi`. No call unwinds: each returns a status, checked at once.

mod backend;
mod batch;
mod error;
mod expression;
mod function;
mod jit;
mod kernel;
mod listing;
mod module;
mod object;
mod operation;
mod place;
mod scalar;
mod statement;
mod together;

pub use backend::{Backend, TargetCpu};
pub use batch::{Batch, BatchError, BatchKernel, compile_batch};
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
