//! Code listings: Cranelift's intermediate representation and the machine code generated from it.

use crate::backend::{Backend, Effort};
use crate::error::CodegenError;
use crate::jit::Jit;
use crate::module::ModuleLowering;
use calyx_abi::Extern;
use calyx_lang::ir::Program;
use calyx_lower::kernels::lower_sites;

/// One function of a module under construction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listing {
    /// Link symbol: `calyx_function_N`, `calyx_kernel_N`, or a generated symbol for a part of a
    /// kernel.
    pub symbol: String,
    /// Cranelift's intermediate representation.
    pub clif: String,
    /// Assembly code for this machine.
    pub asm: String,
}

/// Compiles a program and returns the listings of its functions.
///
/// # Errors
/// As for [`crate::compile_jit`].
pub fn list(program: &Program, externs: &[Extern]) -> Result<Vec<Listing>, CodegenError> {
    let tapes = lower_sites(program).map_err(CodegenError::Kernel)?;
    let mut jit = Jit::new(program, externs, Effort::Speed)?;
    let mut listings = Vec::new();
    let quick = jit.quick_isa()?;
    let lowering = ModuleLowering::new(jit.module(), program)?.with_quick_isa(quick);
    let lowered = lowering.listed_in(&mut listings).lower(&tapes)?;
    // Finishing the module also frees its memory.
    jit.finish(lowered)?;
    Ok(listings)
}
