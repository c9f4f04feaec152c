//! Errors of compilation as data.

use crate::artifact::WriteError;
use calyx_codegen::CodegenError;
use calyx_elaborate::render;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::SourceFile;
use calyx_lang::render::{Colour, Renderer};
use std::path::PathBuf;
use std::{fmt, io};

/// Diagnostics and the files that they refer to.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    /// Diagnostics sorted by file and location, including warnings.
    pub list: Vec<Diagnostic>,
    /// Files by their index in diagnostics: the model first, then every file that it uses.
    pub files: Vec<SourceFile>,
}

impl Diagnostics {
    /// Renders the diagnostics with source lines, in colour if standard error is a terminal.
    pub fn render(&self) -> String {
        render(&self.list, &self.files)
    }
}

/// Renders as [`Diagnostics::render`] does, without colour.
impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut renderer = Renderer::new(&self.files, Colour::Never);
        self.list.iter().try_for_each(|diagnostic| f.write_str(&renderer.text(diagnostic)))
    }
}

/// Error of the compilation of a model.
#[derive(Debug)]
pub enum CompileError {
    /// The file cannot be read.
    Unreadable {
        path: PathBuf,
        error: io::Error,
    },
    /// The model has errors of the language.
    Model(Diagnostics),
    Code(CodegenError),
    Description(serde_json::Error),
    /// The module could not be serialized.
    Artifact(postcard::Error),
    /// The sources are not those of the description.
    OtherSources,
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            CompileError::Unreadable { path, error } => write!(f, "cannot read {}: {error}", path.display()),
            CompileError::Model(diagnostics) => {
                write!(f, "the model has errors and cannot be compiled\n{diagnostics}")
            }
            CompileError::Code(error) => write!(f, "{error}"),
            CompileError::Description(error) => {
                write!(f, "the model's description cannot be written: {error}")
            }
            CompileError::OtherSources => f.write_str("the sources of the model do not fit its description"),
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
