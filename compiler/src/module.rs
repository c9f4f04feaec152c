//! A model compiled to machine code in memory.

use crate::artifact::{self, ArtifactError, Contents, WriteError};
use crate::typed::{LazyTyped, Typed};
use calyx_abi::description::{FileDescription, ModelDescription};
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use calyx_codegen::{CodegenError, JitModule, TargetCpu, compile_code, compile_jit, load_code};
use calyx_elaborate::diagnostics::{diagnostic, finding_diagnostic};
use calyx_elaborate::nan::{Seen, explain};
use calyx_elaborate::{Checked, param_function};
use calyx_gears::host::Finding;
use calyx_gears::library::externs;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::{FunctionId, Program, SourceFile};
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
    Description(serde_json::Error),
    /// It could not be made bytes of.
    Artifact(postcard::Error),
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            CompileError::NotChecked => write!(f, "the model has errors and cannot be compiled"),
            CompileError::Code(error) => write!(f, "{error}"),
            CompileError::Description(error) => {
                write!(f, "the model's description cannot be written: {error}")
            }
            CompileError::Artifact(error) => write!(f, "the compiled module cannot be written: {error}"),
        }
    }
}

impl std::error::Error for CompileError {}

impl From<WriteError> for CompileError {
    fn from(error: WriteError) -> Self {
        match error {
            WriteError::Machine(error) => CompileError::Code(error),
            WriteError::Description(error) => CompileError::Description(error),
            WriteError::Encoding(error) => CompileError::Artifact(error),
        }
    }
}

/// The functions of a param: its default, and the ends of its range.
type ParamFunctions = [Option<FunctionId>; 3];

/// A compiled model. Its code is freed with it, when no value that came from it lives any more.
pub struct Module {
    description: ModelDescription,
    files: Vec<SourceFile>,
    code: JitModule,
    param_functions: Vec<ParamFunctions>,
    typed: LazyTyped,
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
        let functions = |param| {
            use ParamFunction::{Default, High, Low};
            [Default, Low, High].map(|which| param_function(&program, param, which))
        };
        let param_functions = (0..program.params.len()).map(functions).collect();
        Ok(Module {
            description: checked.description,
            files: checked.files,
            code,
            param_functions,
            typed: LazyTyped::checked(Typed::new(program, checked.diagnostics)),
            seen: Seen::default(),
        })
    }

    /// The compiled module as bytes, for [`Module::deserialize`] on this machine, or one whose processor can do as much.
    /// It contains everything the module needs, its sources too.
    ///
    /// # Errors
    /// Code generation failed.
    pub fn serialize(&self) -> Result<Vec<u8>, CompileError> {
        self.serialize_for(TargetCpu::Native)
    }

    /// As [`Module::serialize`], also for every processor of this architecture.
    ///
    /// # Errors
    /// Code generation failed.
    pub fn serialize_for(&self, cpu: TargetCpu) -> Result<Vec<u8>, CompileError> {
        let program = self.program().ok_or(CompileError::NotChecked)?;
        let number = |id: Option<FunctionId>| id.map(|id| id.0);
        let contents = Contents {
            description: self.description.clone(),
            code: compile_code(program, cpu).map_err(CompileError::Code)?,
            params: self.param_functions.iter().map(|functions| functions.map(number)).collect(),
        };
        Ok(artifact::write(contents, cpu)?)
    }

    /// Loads what [`Module::serialize`] made, without compiling anything. The module answers everything the original did;
    /// what only the checked program knows (kernels of symbolic functions, say) takes the time of checking when it is first
    /// asked for.
    ///
    /// # Errors
    /// The bytes are no compiled module, or not all of one; or one of another version of Calyx, or for another machine.
    /// Damage by accident is always found.
    ///
    /// # Safety
    /// The machine code in the bytes is run as it is: they must come from [`Module::serialize`], and nobody who might mean
    /// harm may have had a chance to change them since. The checksum protects against accidents, not against intent.
    pub unsafe fn deserialize(bytes: &[u8]) -> Result<Module, ArtifactError> {
        let Contents { description, code, params } = artifact::read(bytes)?;
        // SAFETY: the caller vouches for the code; its version and machine were checked while it was read.
        let code = unsafe { load_code(&code, externs()) }.map_err(ArtifactError::Code)?;
        let file = |file: &FileDescription| SourceFile { name: file.name.clone(), text: file.text.clone() };
        Ok(Module {
            files: description.files.iter().map(file).collect(),
            description,
            code,
            param_functions: params.into_iter().map(|ids| ids.map(|id| id.map(FunctionId))).collect(),
            typed: LazyTyped::of_sources(),
            seen: Seen::default(),
        })
    }

    /// `None` if the module was loaded and its sources cannot be checked any more, which its version rules out.
    pub(crate) fn program(&self) -> Option<&Program> {
        self.typed().map(|typed| &typed.program)
    }

    fn typed(&self) -> Option<&Typed> {
        self.typed.get(&self.files)
    }

    /// Whether checking found errors of the gears, which other params may mend.
    pub fn has_errors(&self) -> bool {
        self.known().iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// The model's file first, then every file it uses.
    pub fn files(&self) -> &[SourceFile] {
        &self.files
    }

    /// A run-time error at its place in the source; if NaN is behind it, with the expression that arose in. `given` are the
    /// params of the run.
    pub fn error(&self, error: &RuntimeError, given: &[Given]) -> Diagnostic {
        let Some(Typed { program, call_sites, .. }) = self.typed() else { return diagnostic(error) };
        // What the analysis says of a body is placed at the call that made it, and blames an argument of that.
        let mut error = error.clone();
        call_sites.blame(&mut error);
        explain(program, given, &self.seen, &error, diagnostic(&error))
    }

    /// What a run found, without what checking the model has said already.
    pub fn findings(&self, findings: &[Finding]) -> Vec<Diagnostic> {
        // Not worth checking the sources of a loaded module again.
        if findings.is_empty() {
            return Vec::new();
        }
        let nowhere = CallSites::default();
        let call_sites = self.typed().map_or(&nowhere, |typed| &typed.call_sites);
        let found = findings.iter().map(|finding| finding_diagnostic(finding, call_sites));
        found.filter(|diagnostic| !self.known().contains(diagnostic)).collect()
    }

    fn known(&self) -> &[Diagnostic] {
        self.typed().map_or(&[], |typed| &typed.known)
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
        let functions = self.param_functions.get(param);
        let Some(id) = functions.and_then(|functions| functions[which as usize]) else { return Ok(None) };
        Ok(self.code.run_function(id, &[], context)?.first().copied())
    }

    fn main(&self, context: &mut Context) -> Result<(), RuntimeError> {
        self.code.run_main(context)
    }
}
