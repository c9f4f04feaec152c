//! Errors of code generation.

use calyx_lower::kernels::KernelError;
use calyx_lower::link::LinkError;
use cranelift_module::ModuleError;
use std::fmt;

/// The reason why code could not be generated. Only `Kernel` can result from a mistake in the
/// user's text; it has the source location.
#[derive(Debug)]
pub enum CodegenError {
    /// The program declares a function that the engine does not provide.
    Link(LinkError),
    /// A symbolic expression has no kernel.
    Kernel(KernelError),
    /// The typed program is inconsistent.
    Malformed(&'static str),
    /// Cranelift does not support this machine or this code.
    Cranelift(String),
}

impl fmt::Display for CodegenError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            CodegenError::Link(error) => error.fmt(f),
            CodegenError::Kernel(error) => f.write_str(&error.message),
            CodegenError::Malformed(what) => write!(f, "internal error: the typed program contains {what}"),
            CodegenError::Cranelift(error) => write!(f, "the code generator failed: {error}"),
        }
    }
}

impl std::error::Error for CodegenError {}

impl From<LinkError> for CodegenError {
    fn from(error: LinkError) -> Self {
        CodegenError::Link(error)
    }
}

impl From<ModuleError> for CodegenError {
    fn from(error: ModuleError) -> Self {
        // The alternate form includes the cause.
        CodegenError::Cranelift(format!("{error:#}"))
    }
}
