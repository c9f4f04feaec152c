//! Models compiled to machine code in memory.

use crate::artifact::{self, ArtifactError, Contents};
use crate::compiled::{Compiled, ParamFunctions};
use crate::error::{CompileError, Diagnostics};
use crate::typed::{LazyTyped, Typed};
use calyx_abi::RuntimeError;
use calyx_abi::description::{FileDescription, ModelDescription, OutputDescription};
use calyx_codegen::{TargetCpu, compile_code, compile_jit, compile_jit_with_tapes, load_code};
use calyx_elaborate::diagnostics::{diagnostic, finding_diagnostic, has_errors};
use calyx_elaborate::{Checked, check_file, check_language, check_text, param_function, render};
use calyx_gears::host::Finding;
use calyx_gears::library::{FINGERPRINT, externs};
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{FunctionId, Program, SourceFile};
use calyx_lower::interpret::CallSites;
use calyx_rt::program::ParamFunction;
use calyx_rt::{Engine, Error, Instance, Output, Param};
use std::path::Path;
use std::sync::Arc;

/// Compiled model.
///
/// Creating a module takes as long as checking and compiling: some hundredths of a second for a
/// model of one gear pair. A module is immutable, and a clone is the same module. Any number of
/// threads can create instances of it; they share its code. The code is freed with the last clone,
/// instance or kernel of the module.
///
/// ```
/// let engine = calyx::Engine::default();
/// let text = "param side = 2 mm; print(side^2);";
/// let module = calyx::Module::from_text(&engine, "square.cx", text)?;
/// let mut instance = module.instantiate();
/// instance.set("side", (1.0, "inch"))?;
/// instance.on_print(|line| println!("{line}"));
/// instance.solve()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Module {
    engine: Engine,
    compiled: Arc<Compiled>,
}

impl Module {
    /// Checks and compiles the model in a file.
    ///
    /// The gears of a module may be impossible at the default params ([`Module::has_errors`]).
    /// Running it then fails unless the params that are set fix the error.
    ///
    /// # Errors
    /// If the file cannot be read, the model has errors of the language, or code generation fails.
    pub fn from_file(engine: &Engine, path: impl AsRef<Path>) -> Result<Module, CompileError> {
        let path = path.as_ref();
        let checked =
            check_file(path).map_err(|error| CompileError::Unreadable { path: path.to_owned(), error })?;
        Module::from_checked(engine, checked)
    }

    /// Checks and compiles a model given as text, which can import the library only. `name` is its
    /// file name in messages.
    ///
    /// # Errors
    /// Same as for [`Module::from_file`].
    pub fn from_text(engine: &Engine, name: &str, text: &str) -> Result<Module, CompileError> {
        Module::from_checked(engine, check_text(name, text))
    }

    /// Compiles a checked model.
    ///
    /// # Errors
    /// Same as for [`Module::from_file`].
    pub fn from_checked(engine: &Engine, checked: Checked) -> Result<Module, CompileError> {
        let code = match (&checked.program, checked.tapes()) {
            (Some(program), Some(tapes)) => Some(compile_jit_with_tapes(program, &tapes, externs())),
            (Some(program), None) => Some(compile_jit(program, externs())),
            (None, _) => None,
        };
        let Checked { program, description, diagnostics, files, .. } = checked;
        let (Some(program), Some(code)) = (program, code) else {
            return Err(CompileError::Model(Diagnostics { list: diagnostics, files }));
        };
        let code = code.map_err(CompileError::Code)?;
        let param_functions = param_functions(&program);
        let typed = LazyTyped::checked(Typed::new(program, diagnostics));
        Ok(Module::new(engine, Compiled { description, files, code, param_functions, typed }))
    }

    /// Compiles the sources in the description of a module, which were checked when it was made.
    /// The module is equivalent to the original, on any machine. It reads the files that the
    /// description stores, and no others.
    ///
    /// # Errors
    /// If the sources have errors, or are not those of the description.
    pub fn from_description(engine: &Engine, description: ModelDescription) -> Result<Module, CompileError> {
        let file = |file: &FileDescription| SourceFile { name: file.name.clone(), text: file.text.clone() };
        let files: Vec<SourceFile> = description.files.iter().map(file).collect();
        let (program, list) = check_language(&files);
        let Some(program) = program else {
            return Err(CompileError::Model(Diagnostics { list, files }));
        };
        if !fits(&description, &calyx_lang::description::describe(&program, FINGERPRINT)) {
            return Err(CompileError::OtherSources);
        }
        let code = compile_jit(&program, externs()).map_err(CompileError::Code)?;
        let param_functions = param_functions(&program);
        let typed = LazyTyped::of_sources();
        Ok(Module::new(engine, Compiled { description, files, code, param_functions, typed }))
    }

    fn new(engine: &Engine, compiled: Compiled) -> Module {
        Module { engine: engine.clone(), compiled: Arc::new(compiled) }
    }

    /// Creates an instance with all params at their defaults, at negligible cost.
    pub fn instantiate(&self) -> Instance {
        Instance::new(&self.engine, self.as_program())
    }

    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Returns the module as a program of the runner.
    pub fn as_program(&self) -> Arc<dyn calyx_rt::Program> {
        self.compiled.clone()
    }

    /// Returns names, units, defaults, ranges and docs of params and outputs.
    pub fn description(&self) -> &ModelDescription {
        &self.compiled.description
    }

    /// Returns the source files: the model's file first, then every file that it uses.
    pub fn files(&self) -> &[SourceFile] {
        &self.compiled.files
    }

    /// Returns a handle of a param, which instances set without another look-up of its name.
    ///
    /// # Errors
    /// If the model has no such param.
    pub fn param(&self, name: &str) -> Result<Param, Error> {
        Param::named(self.description(), name)
    }

    /// Returns a handle of an output, which selects it in results without another look-up of its
    /// name.
    ///
    /// # Errors
    /// If the model has no such output.
    pub fn output(&self, name: &str) -> Result<Output, Error> {
        Output::named(self.description(), name)
    }

    /// Returns the diagnostics of the check at the default params: warnings, and errors of the
    /// gears, which other params may fix.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        self.compiled.typed().map_or(&[], |typed| &typed.known)
    }

    /// Returns true if the check found errors of the gears, which other params may fix.
    pub fn has_errors(&self) -> bool {
        has_errors(self.diagnostics())
    }

    /// Serializes the compiled module for [`Module::deserialize`] on this machine, or on one whose
    /// processor has the same instruction sets. The bytes contain everything that the module needs,
    /// including its sources.
    ///
    /// # Errors
    /// If code generation fails.
    pub fn serialize(&self) -> Result<Vec<u8>, CompileError> {
        self.serialize_for(TargetCpu::Native)
    }

    /// Serializes the module as [`Module::serialize`] does, optionally for every processor of this
    /// architecture.
    ///
    /// # Errors
    /// If code generation fails.
    pub fn serialize_for(&self, cpu: TargetCpu) -> Result<Vec<u8>, CompileError> {
        let Some(program) = self.program() else {
            let files = self.files().to_vec();
            return Err(CompileError::Model(Diagnostics { list: Vec::new(), files }));
        };
        serialize(program, self.description(), cpu)
    }

    /// Loads the result of [`Module::serialize`] without compiling. The module is equivalent to the
    /// original. Requests that need the typed program (kernels of symbolic functions, for example)
    /// check the sources again, at the first such request.
    ///
    /// # Errors
    /// If the bytes are not a compiled module, are incomplete, or belong to another version of
    /// Calyx or another machine. Accidental damage is always detected.
    ///
    /// # Safety
    /// The machine code in the bytes is executed without verification: they must come from
    /// [`Module::serialize`], and no untrusted party may have been able to change them since. The
    /// checksum protects against accidents, not against attacks.
    pub unsafe fn deserialize(engine: &Engine, bytes: &[u8]) -> Result<Module, ArtifactError> {
        let Contents { description, code, params } = artifact::read(bytes)?;
        // SAFETY: the caller guarantees the code; its version and machine were compared when it was
        // read.
        let code = unsafe { load_code(&code, externs()) }.map_err(ArtifactError::Code)?;
        let file = |file: &FileDescription| SourceFile { name: file.name.clone(), text: file.text.clone() };
        let files = description.files.iter().map(file).collect();
        let param_functions = params.into_iter().map(|ids| ids.map(|id| id.map(FunctionId))).collect();
        let typed = LazyTyped::of_sources();
        Ok(Module::new(engine, Compiled { description, files, code, param_functions, typed }))
    }

    pub(crate) fn program(&self) -> Option<&Program> {
        self.compiled.typed().map(|typed| &typed.program)
    }

    /// Returns the diagnostic of an error of an instance, with its source location, and the
    /// expression that produced NaN if that is the cause.
    pub fn error(&self, error: &RuntimeError) -> Diagnostic {
        let Some(Typed { call_sites, .. }) = self.compiled.typed() else { return diagnostic(error) };
        // Errors of the analysis about a body refer to the call that created it, and to an argument
        // of that call.
        let mut error = error.clone();
        call_sites.blame(&mut error);
        diagnostic(&error)
    }

    /// Renders an error of an instance with the source lines concerned, in colour if standard error
    /// is a terminal.
    pub fn render(&self, error: &Error) -> String {
        match error {
            Error::Given(refused) => calyx_rt::messages::refused(refused),
            Error::Model(error) => render(&[self.error(error)], self.files()),
        }
    }

    /// Returns the findings of a run, without those that the check of the model reported.
    pub fn findings(&self, findings: &[Finding]) -> Vec<Diagnostic> {
        // Without findings, the sources of a loaded module need no check.
        if findings.is_empty() {
            return Vec::new();
        }
        let nowhere = CallSites::default();
        let call_sites = self.compiled.typed().map_or(&nowhere, |typed| &typed.call_sites);
        let found = findings.iter().map(|finding| finding_diagnostic(finding, call_sites));
        found.filter(|diagnostic| !self.diagnostics().contains(diagnostic)).collect()
    }
}

/// Returns whether a description belongs to a program with its own description.
fn fits(description: &ModelDescription, own: &ModelDescription) -> bool {
    let params = |all: &ModelDescription| -> Vec<_> {
        all.params.iter().map(|param| (param.name.clone(), param.repr.clone())).collect()
    };
    let declared = match &description.declared_outputs[..] {
        [] => &description.outputs,
        declared => declared,
    };
    let outputs = |all: &[OutputDescription]| -> Vec<_> {
        all.iter().map(|output| (output.name.clone(), output.site)).collect()
    };
    description.abi == own.abi
        && params(description) == params(own)
        && outputs(declared) == outputs(&own.outputs)
        && description.kernels == own.kernels
}

/// Returns the default and range functions of every param.
fn param_functions(program: &Program) -> Vec<ParamFunctions> {
    use ParamFunction::{Default, High, Low};
    let functions = |param| [Default, Low, High].map(|which| param_function(program, param, which));
    (0..program.params.len()).map(functions).collect()
}

/// Serializes a checked program for [`Module::deserialize`].
pub(crate) fn serialize(
    program: &Program,
    description: &ModelDescription,
    cpu: TargetCpu,
) -> Result<Vec<u8>, CompileError> {
    let number = |id: Option<FunctionId>| id.map(|id| id.0);
    let contents = Contents {
        description: description.clone(),
        code: compile_code(program, cpu).map_err(CompileError::Code)?,
        params: param_functions(program).into_iter().map(|functions| functions.map(number)).collect(),
    };
    Ok(artifact::write(contents, cpu)?)
}
