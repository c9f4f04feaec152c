//! Where code goes: what the lowering needs of a back end, and the settings all back ends share.

use crate::error::CodegenError;
use crate::module::ModuleLowering;
use calyx_lang::ir::Program;
use calyx_symbolic::Tape;
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use cranelift_module::{FuncId, Module};

/// A place for code: memory or an object file.
pub trait Backend {
    /// Cranelift's side of it.
    type Module: Module;
    /// What comes out.
    type Artifact;

    fn module(&mut self) -> &mut Self::Module;

    /// Makes the artifact of a module all of whose functions are defined.
    ///
    /// # Errors
    /// The code cannot be placed in memory or written.
    fn finish(self, lowered: Lowered) -> Result<Self::Artifact, CodegenError>;
}

/// The functions of a lowered program.
pub struct Lowered {
    /// In order of `Program::functions`.
    pub functions: Vec<FuncId>,
    /// In order of `Program::sites`.
    pub kernels: Vec<Kernel>,
}

/// A compiled kernel.
pub struct Kernel {
    pub function: FuncId,
    pub inputs: usize,
    pub outputs: usize,
}

/// Lowers a program and finishes it.
pub fn compile<B: Backend>(
    mut backend: B,
    program: &Program,
    tapes: &[Tape],
) -> Result<B::Artifact, CodegenError> {
    let lowered = ModuleLowering::new(backend.module(), program)?.lower(tapes)?;
    backend.finish(lowered)
}

/// How much Cranelift improves code.
#[derive(Clone, Copy)]
pub enum Effort {
    /// For functions of programs.
    Speed,
    /// For kernels: a tape holds each operation once, simplified and in an order that keeps few values alive. What
    /// Cranelift could add takes time and loses that order (a chain of fifty factors ran 1.25 times slower with it).
    AsWritten,
}

/// Settings of code in memory: this very machine.
pub fn native_isa(effort: Effort) -> Result<OwnedTargetIsa, CodegenError> {
    isa(TargetCpu::Native, false, effort)
}

/// Settings of code that is kept as data and placed in memory later.
pub fn position_dependent_isa(cpu: TargetCpu) -> Result<OwnedTargetIsa, CodegenError> {
    isa(cpu, false, Effort::Speed)
}

/// The machines that an object file, or code that is kept, is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TargetCpu {
    /// Every machine of this architecture (for x86-64 that is SSE2).
    #[default]
    Baseline,
    /// This very machine, and those that have all it has.
    Native,
}

/// Settings of object files.
///
/// What the baseline lacks is called, never emulated differently: `floor` and its like are calls everywhere, and
/// nothing is fused, so that object files give the bits of code in memory.
pub fn object_isa(cpu: TargetCpu) -> Result<OwnedTargetIsa, CodegenError> {
    isa(cpu, true, Effort::Speed)
}

fn isa(cpu: TargetCpu, position_independent: bool, effort: Effort) -> Result<OwnedTargetIsa, CodegenError> {
    let builder = cranelift_native::builder_with_options(cpu == TargetCpu::Native);
    let builder = builder.map_err(|error| CodegenError::Cranelift(error.into()))?;
    let flags = flags(position_independent, effort)?;
    builder.finish(flags).map_err(|error| CodegenError::Cranelift(error.to_string()))
}

fn flags(position_independent: bool, effort: Effort) -> Result<settings::Flags, CodegenError> {
    let mut builder = settings::builder();
    let opt_level = match effort {
        Effort::Speed => "speed",
        Effort::AsWritten => "none",
    };
    let verify = if cfg!(debug_assertions) { "true" } else { "false" };
    for (name, value) in [
        ("opt_level", opt_level),
        ("enable_verifier", verify),
        ("is_pic", if position_independent { "true" } else { "false" }),
        // Large frames touch their pages in order, so that an overrun meets the guard page.
        ("enable_probestack", "true"),
        ("probestack_strategy", "inline"),
        // Calls into the engine may be anywhere in memory.
        ("use_colocated_libcalls", "false"),
    ] {
        builder.set(name, value).map_err(|error| CodegenError::Cranelift(error.to_string()))?;
    }
    Ok(settings::Flags::new(builder))
}
