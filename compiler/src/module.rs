//! A model compiled to machine code in memory.

use crate::artifact::{self, ArtifactError, Contents};
use crate::compiled::{Compiled, ParamFunctions};
use crate::error::{CompileError, Diagnostics};
use crate::typed::{LazyTyped, Typed};
use calyx_abi::RuntimeError;
use calyx_abi::description::{FileDescription, ModelDescription};
use calyx_codegen::{TargetCpu, compile_code, compile_jit, load_code};
use calyx_elaborate::diagnostics::{diagnostic, finding_diagnostic, has_errors};
use calyx_elaborate::{Checked, check_file, check_text, param_function, render};
use calyx_gears::host::Finding;
use calyx_gears::library::externs;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{FunctionId, Program, SourceFile};
use calyx_lower::interpret::CallSites;
use calyx_rt::program::ParamFunction;
use calyx_rt::{Engine, Error, Instance, Output, Param};
use std::path::Path;
use std::sync::Arc;

/// A compiled model.
///
/// Making one takes as long as checking and compiling: for a model of one gear pair some hundredths of a second. It is
/// immutable; a clone is the same module, and any number of threads may make instances of it, which share its code. Its
/// code is freed with the last clone, instance or kernel that came from it.
///
/// ```
/// let engine = calyx::Engine::default();
/// let module = calyx::Module::from_text(&engine, "square.cx", "param side = 2 mm; print(side^2);")?;
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
    /// Its gears may be impossible at their defaults ([`Module::has_errors`]); running it then fails unless the params that
    /// are set mend it.
    ///
    /// # Errors
    /// The file cannot be read, the model has errors of the language, or code generation failed.
    pub fn from_file(engine: &Engine, path: impl AsRef<Path>) -> Result<Module, CompileError> {
        let path = path.as_ref();
        let checked =
            check_file(path).map_err(|error| CompileError::Unreadable { path: path.to_owned(), error })?;
        Module::from_checked(engine, checked)
    }

    /// Checks and compiles a model given as text, which can import the library only. `name` stands for it in messages.
    ///
    /// # Errors
    /// As for [`Module::from_file`].
    pub fn from_text(engine: &Engine, name: &str, text: &str) -> Result<Module, CompileError> {
        Module::from_checked(engine, check_text(name, text))
    }

    /// Compiles a model that is checked already.
    ///
    /// # Errors
    /// As for [`Module::from_file`].
    pub fn from_checked(engine: &Engine, checked: Checked) -> Result<Module, CompileError> {
        let Checked { program, description, diagnostics, files, .. } = checked;
        let Some(program) = program else {
            return Err(CompileError::Model(Diagnostics { list: diagnostics, files }));
        };
        let code = compile_jit(&program, externs()).map_err(CompileError::Code)?;
        let param_functions = param_functions(&program);
        let typed = LazyTyped::checked(Typed::new(program, diagnostics));
        Ok(Module::new(engine, Compiled { description, files, code, param_functions, typed }))
    }

    fn new(engine: &Engine, compiled: Compiled) -> Module {
        Module { engine: engine.clone(), compiled: Arc::new(compiled) }
    }

    /// The model with values of its own: all params at their defaults. Costs next to nothing.
    pub fn instantiate(&self) -> Instance {
        Instance::new(&self.engine, self.as_program())
    }

    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// As the runner sees it, whoever compiled it.
    pub fn as_program(&self) -> Arc<dyn calyx_rt::Program> {
        self.compiled.clone()
    }

    /// Names, units, defaults, ranges and docs of params and outputs.
    pub fn description(&self) -> &ModelDescription {
        &self.compiled.description
    }

    /// The model's file first, then every file it uses.
    pub fn files(&self) -> &[SourceFile] {
        &self.compiled.files
    }

    /// A param, to be set in instances without looking up its name again.
    ///
    /// # Errors
    /// The model has no such param.
    pub fn param(&self, name: &str) -> Result<Param, Error> {
        Param::named(self.description(), name)
    }

    /// An output, to be read off results without looking up its name again.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn output(&self, name: &str) -> Result<Output, Error> {
        Output::named(self.description(), name)
    }

    /// What checking found at the params' defaults: warnings, and errors of the gears, which other params may mend.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        self.compiled.typed().map_or(&[], |typed| &typed.known)
    }

    /// Whether checking found errors of the gears, which other params may mend.
    pub fn has_errors(&self) -> bool {
        has_errors(self.diagnostics())
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
        let Some(program) = self.program() else {
            let files = self.files().to_vec();
            return Err(CompileError::Model(Diagnostics { list: Vec::new(), files }));
        };
        serialize(program, self.description(), cpu)
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
    pub unsafe fn deserialize(engine: &Engine, bytes: &[u8]) -> Result<Module, ArtifactError> {
        let Contents { description, code, params } = artifact::read(bytes)?;
        // SAFETY: the caller vouches for the code; its version and machine were checked while it was read.
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

    /// An error of an instance at its place in the source; if NaN is behind it, with the expression that arose in.
    pub fn error(&self, error: &RuntimeError) -> Diagnostic {
        let Some(Typed { call_sites, .. }) = self.compiled.typed() else { return diagnostic(error) };
        // What the analysis says of a body is placed at the call that made it, and blames an argument of that.
        let mut error = error.clone();
        call_sites.blame(&mut error);
        diagnostic(&error)
    }

    /// An error of an instance for people, with the lines of the source it is about, in colour if standard error is a
    /// terminal.
    pub fn render(&self, error: &Error) -> String {
        match error {
            Error::Given(refused) => calyx_rt::report::refused(refused),
            Error::Model(error) => render(&[self.error(error)], self.files()),
        }
    }

    /// What a run found, without what checking the model has said already.
    pub fn findings(&self, findings: &[Finding]) -> Vec<Diagnostic> {
        // Not worth checking the sources of a loaded module again.
        if findings.is_empty() {
            return Vec::new();
        }
        let nowhere = CallSites::default();
        let call_sites = self.compiled.typed().map_or(&nowhere, |typed| &typed.call_sites);
        let found = findings.iter().map(|finding| finding_diagnostic(finding, call_sites));
        found.filter(|diagnostic| !self.diagnostics().contains(diagnostic)).collect()
    }
}

/// The functions of every param.
fn param_functions(program: &Program) -> Vec<ParamFunctions> {
    use ParamFunction::{Default, High, Low};
    let functions = |param| [Default, Low, High].map(|which| param_function(program, param, which));
    (0..program.params.len()).map(functions).collect()
}

/// A checked program as bytes, for [`Module::deserialize`].
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
