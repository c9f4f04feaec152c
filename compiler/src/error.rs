//! Why a model could not be compiled, as data.

use crate::artifact::WriteError;
use calyx_codegen::CodegenError;
use calyx_elaborate::render;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::SourceFile;
use calyx_lang::render::{Colour, Renderer};
use std::path::PathBuf;
use std::{fmt, io};

/// Diagnostics, and the files they are about.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    /// In order of file and place, warnings among them.
    pub list: Vec<Diagnostic>,
    /// By their number in diagnostics: the model first, then every file it uses.
    pub files: Vec<SourceFile>,
}

impl Diagnostics {
    /// For people, with the lines of the source, in colour if standard error is a terminal.
    pub fn render(&self) -> String {
        render(&self.list, &self.files)
    }
}

/// As [`Diagnostics::render`], without colour.
impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut renderer = Renderer::new(&self.files, Colour::Never);
        self.list.iter().try_for_each(|diagnostic| f.write_str(&renderer.text(diagnostic)))
    }
}

/// Why a model could not be compiled.
#[derive(Debug)]
pub enum CompileError {
    /// Its file cannot be read.
    Unreadable {
        path: PathBuf,
        error: io::Error,
    },
    /// It has errors of the language.
    Model(Diagnostics),
    Code(CodegenError),
    Description(serde_json::Error),
    /// It could not be made bytes of.
    Artifact(postcard::Error),
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
