//! A model compiled to machine code in memory.

use calyx_abi::description::ModelDescription;
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use calyx_codegen::{CodegenError, JitModule, compile_jit};
use calyx_elaborate::diagnostics::{diagnostic, finding_diagnostic};
use calyx_elaborate::nan::{Seen, explain};
use calyx_elaborate::{Checked, param_function};
use calyx_gears::host::Finding;
use calyx_gears::library::externs;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::{Program, SourceFile};
use calyx_lower::interpret::CallSites;
use calyx_rt::Given;
use calyx_rt::program::ParamFunction;
use std::fmt;
use std::sync::Arc;

/// Why a checked model could not be compiled.
#[derive(Debug)]
pub enum CompileError {
    /// The model has errors; see its diagnostics.
    NotChecked,
    Code(CodegenError),
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            CompileError::NotChecked => write!(f, "the model has errors and cannot be compiled"),
            CompileError::Code(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for CompileError {}

/// A compiled model. Its code is freed with it, when no value that came from it lives any more.
pub struct Module {
    program: Program,
    description: ModelDescription,
    files: Vec<SourceFile>,
    code: JitModule,
    call_sites: CallSites,
    /// What checking found, at the params' defaults.
    known: Vec<Diagnostic>,
    /// Inputs at which its kernels gave NaN.
    seen: Seen,
}

impl Module {
    /// Compiles a checked model. Its gears may be impossible at their defaults; running it then fails unless the params
    /// given to the run mend it.
    ///
    /// # Errors
    /// The model has errors of the language, or code generation failed.
    pub fn compile(checked: Checked) -> Result<Module, CompileError> {
        let program = checked.program.ok_or(CompileError::NotChecked)?;
        let code = compile_jit(&program, externs()).map_err(CompileError::Code)?;
        let call_sites = CallSites::new(&program);
        Ok(Module {
            program,
            description: checked.description,
            files: checked.files,
            code,
            call_sites,
            known: checked.diagnostics,
            seen: Seen::default(),
        })
    }

    pub(crate) fn program(&self) -> &Program {
        &self.program
    }

    /// Whether checking found errors of the gears, which other params may mend.
    pub fn has_errors(&self) -> bool {
        self.known.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// The model's file first, then every file it uses.
    pub fn files(&self) -> &[SourceFile] {
        &self.files
    }

    /// A run-time error at its place in the source; if NaN is behind it, with the expression that arose in. `given` are the
    /// params of the run.
    pub fn error(&self, error: &RuntimeError, given: &[Given]) -> Diagnostic {
        // What the analysis says of a body is placed at the call that made it, and blames an argument of that.
        let mut error = error.clone();
        self.call_sites.blame(&mut error);
        explain(&self.program, given, &self.seen, &error, diagnostic(&error))
    }

    /// What a run found, without what checking the model has said already.
    pub fn findings(&self, findings: &[Finding]) -> Vec<Diagnostic> {
        let found = findings.iter().map(|finding| finding_diagnostic(finding, &self.call_sites));
        found.filter(|diagnostic| !self.known.contains(diagnostic)).collect()
    }
}

impl calyx_rt::Program for Module {
    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        self.seen.watched(self.code.kernels())
    }

    fn param_function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError> {
        let Some(id) = param_function(&self.program, param, which) else { return Ok(None) };
        Ok(self.code.run_function(id, &[], context)?.first().copied())
    }

    fn main(&self, context: &mut Context) -> Result<(), RuntimeError> {
        self.code.run_main(context)
    }
}
