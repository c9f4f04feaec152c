//! The back ends of the lowering: code in memory, in an object file or as data, and their common
//! settings.

use crate::error::CodegenError;
use crate::module::ModuleLowering;
use calyx_lang::ir::Program;
use calyx_symbolic::Tape;
use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use cranelift_module::{FuncId, Module};
use std::borrow::Borrow;

/// A destination for code, such as memory or an object file.
pub trait Backend {
    /// The Cranelift module.
    type Module: Module;
    /// The result of the back end.
    type Artifact;

    fn module(&mut self) -> &mut Self::Module;

    /// Returns the settings for functions that run a few times, if they differ from those of the
    /// module.
    ///
    /// # Errors
    /// Cranelift does not support this machine.
    fn quick_isa(&self) -> Result<Option<OwnedTargetIsa>, CodegenError> {
        Ok(None)
    }

    /// Returns the artifact of a module with all functions defined.
    ///
    /// # Errors
    /// The code cannot be placed in memory or written.
    fn finish(self, lowered: Lowered) -> Result<Self::Artifact, CodegenError>;
}

/// The functions of a lowered program.
pub struct Lowered {
    /// Functions in order of `Program::functions`.
    pub functions: Vec<FuncId>,
    /// Kernels in order of `Program::sites`.
    pub kernels: Vec<Kernel>,
}

/// A compiled kernel.
pub struct Kernel {
    pub function: FuncId,
    pub inputs: usize,
    pub outputs: usize,
}

/// Lowers a program and returns its artifact.
pub fn compile<B: Backend>(
    mut backend: B,
    program: &Program,
    tapes: &[impl Borrow<Tape>],
) -> Result<B::Artifact, CodegenError> {
    let quick = backend.quick_isa()?;
    let lowering = ModuleLowering::new(backend.module(), program)?.with_quick_isa(quick);
    let lowered = lowering.lower(tapes)?;
    backend.finish(lowered)
}

/// Optimization level and register allocator of Cranelift.
#[derive(Clone, Copy)]
pub enum Effort {
    /// Optimizes for speed; used for functions of programs.
    Speed,
    /// No optimization; used for kernels. A tape contains each operation once, simplified, in an
    /// order that keeps few values alive. Cranelift's optimizations would take time and lose that
    /// order: a chain of fifty factors runs 1.25 times slower with them.
    AsWritten,
    /// Fast compilation; used in memory for functions of the library and for those of the model
    /// that no loop repeats. They compile in a third of the time. Loops run 1.3 times slower with
    /// this register allocator.
    Quick,
}

/// Returns the settings of code in memory, for the current machine.
pub fn native_isa(effort: Effort) -> Result<OwnedTargetIsa, CodegenError> {
    isa(TargetCpu::Native, false, effort)
}

/// Returns the settings of code that is stored as data and placed in memory later.
pub fn position_dependent_isa(cpu: TargetCpu) -> Result<OwnedTargetIsa, CodegenError> {
    isa(cpu, false, Effort::Speed)
}

/// The processors for which object files or stored code are compiled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TargetCpu {
    /// Every processor of this architecture (for x86-64, SSE2).
    #[default]
    Baseline,
    /// This processor and those that support all its features.
    Native,
}

/// Returns the settings of object files.
///
/// Operations that the baseline lacks are calls on every processor (`floor`, for example), and no
/// multiply-add is fused. Object files therefore produce the same bits as code in memory.
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
    let (opt_level, allocator) = match effort {
        Effort::Speed => ("speed", "backtracking"),
        Effort::AsWritten => ("none", "backtracking"),
        Effort::Quick => ("none", "single_pass"),
    };
    let verify = if cfg!(debug_assertions) { "true" } else { "false" };
    for (name, value) in [
        ("opt_level", opt_level),
        ("regalloc_algorithm", allocator),
        ("enable_verifier", verify),
        ("is_pic", if position_independent { "true" } else { "false" }),
        // Large frames touch their pages in order, so that a stack overflow hits the guard page.
        ("enable_probestack", "true"),
        ("probestack_strategy", "inline"),
        // The functions of the engine may be at any address.
        ("use_colocated_libcalls", "false"),
    ] {
        builder.set(name, value).map_err(|error| CodegenError::Cranelift(error.to_string()))?;
    }
    Ok(settings::Flags::new(builder))
}
