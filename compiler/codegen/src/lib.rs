//! Machine code generation with Cranelift: in memory ([`compile_jit`]), as an object file
//! ([`compile_object`]), or as data that can be stored and loaded again ([`compile_code`],
//! [`load_code`]).
//!
//! All three share one lowering (modules `module`, `function`, `kernel`), generic over a
//! [`Backend`]. No other crate depends on Cranelift. Compiled code produces the same bits, the same
//! errors and the same source locations as the interpreter of `calyx-lower`: arithmetic is IEEE 754
//! without fused multiply-adds, and everything else calls the shared definitions in `calyx-abi`.
//! Calls do not unwind; each returns a status, which the caller checks immediately.

mod backend;
mod batch;
mod batched_sincos;
mod code;
mod error;
mod expression;
mod function;
mod jit;
mod kernel;
mod listing;
mod load;
mod module;
mod newton;
mod object;
mod operation;
mod place;
mod recorder;
mod scalar;
mod statement;

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
use std::borrow::Borrow;
use std::sync::Arc;

/// Compiles a program into memory. `externs` are the functions of the engine. The program's
/// declarations are resolved among them by symbol; the code cannot reach anything else.
///
/// # Errors
/// The engine lacks a function that the program declares, a symbolic expression has no kernel, or
/// Cranelift does not support the machine.
pub fn compile_jit(program: &Program, externs: &[Extern]) -> Result<JitModule, CodegenError> {
    compile_jit_with_tapes(program, &lower_sites(program).map_err(CodegenError::Kernel)?, externs)
}

/// Compiles as [`compile_jit`] does, with given tapes of the kernels (one per site).
///
/// # Errors
/// As for [`compile_jit`].
pub fn compile_jit_with_tapes(
    program: &Program,
    tapes: &[impl Borrow<Tape>],
    externs: &[Extern],
) -> Result<JitModule, CodegenError> {
    backend::compile(jit::Jit::new(program, externs, backend::Effort::Speed)?, program, tapes)
}

/// Compiles a program into code that can be stored. It references the functions of the engine by
/// symbol, so that another process can load it.
///
/// # Errors
/// As for [`compile_jit`], except that missing functions are reported by [`load_code`].
pub fn compile_code(program: &Program, cpu: TargetCpu) -> Result<ModuleCode, CodegenError> {
    let tapes = lower_sites(program).map_err(CodegenError::Kernel)?;
    backend::compile(recorder::Recorder::new(program, cpu)?, program, &tapes)
}

/// Places stored code in memory. `externs` are the functions of the engine; the code cannot reach
/// anything else.
///
/// # Errors
/// The code refers to an item that does not exist, or its memory cannot be allocated. Malformed
/// code never causes a panic.
///
/// # Safety
/// The code was produced by [`compile_code`] of the same version of this crate and of `calyx-abi`,
/// for a machine ([`Machine`]) whose features this one supports. The code is executed without
/// verification, so other bytes are undefined behaviour.
pub unsafe fn load_code(code: &ModuleCode, externs: &[Extern]) -> Result<JitModule, LoadError> {
    load::load(code, externs)
}

/// Compiles one tape for evaluation at one point at a time. For many points see [`compile_batch`].
///
/// # Errors
/// The tape is malformed, or Cranelift does not support the machine.
pub fn compile_kernel(tape: &Tape) -> Result<Arc<dyn Kernel>, CodegenError> {
    let program = Program::default();
    let mut jit = jit::Jit::of_kernels()?;
    let mut lowering = module::ModuleLowering::new(jit.module(), &program)?;
    let function = kernel::lower(&mut lowering, "calyx_kernel", tape)?;
    lowering.compile()?;
    Ok(jit::kernel(&jit.into_code()?, function, tape.inputs, tape.outputs.len()))
}

/// Compiles a program into an object file for a kind of machine, to be linked with `calyx-rt`.
///
/// The object file exports `NAME_model`, a [`calyx_abi::description::ModuleTable`]. For an
/// executable it also exports `main`, which calls `calyx_rt_main(argc, argv, &NAME_model)`.
///
/// # Errors
/// As for [`compile_jit`], except that missing functions are reported by the linker.
pub fn compile_object(program: &Program, options: &ObjectOptions) -> Result<Vec<u8>, CodegenError> {
    compile_object_with_tapes(program, &lower_sites(program).map_err(CodegenError::Kernel)?, options)
}

/// Compiles as [`compile_object`] does, with given tapes of the kernels (one per site).
///
/// # Errors
/// As for [`compile_object`].
pub fn compile_object_with_tapes(
    program: &Program,
    tapes: &[impl Borrow<Tape>],
    options: &ObjectOptions,
) -> Result<Vec<u8>, CodegenError> {
    backend::compile(object::ObjectFile::new(program, options)?, program, tapes)
}
