//! A program that differs from another one in its description or its files.

use crate::nan_log::NanLog;
use crate::param_assignment::ParamAssignment;
use crate::program::{ParamFunction, Program};
use calyx_abi::description::{FileDescription, ModelDescription};
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use std::path::PathBuf;
use std::sync::Arc;

/// A program with another description or other files. Its code is unchanged.
pub struct AdaptedProgram {
    program: Arc<dyn Program>,
    description: Option<ModelDescription>,
    files: Option<Files>,
}

/// Tables of a program, and the directory below which it reads others.
struct Files {
    tables: Option<Arc<[FileDescription]>>,
    directory: PathBuf,
}

impl AdaptedProgram {
    /// Creates the program whose runs have outputs of the given names. If outputs are arrays, their
    /// number follows from the params, and is known when the model has been built.
    pub fn with_outputs<'n>(
        program: Arc<dyn Program>,
        names: impl Iterator<Item = &'n str>,
    ) -> AdaptedProgram {
        let description = program.description().with_outputs(names);
        let description = ModelDescription { declared_outputs: Vec::new(), ..description };
        AdaptedProgram { program, description: Some(description), files: None }
    }

    /// Creates the program without the directory of its model. It reads the tables of its
    /// description or, if `tables` is a directory, all tables from there.
    pub fn standalone(program: Arc<dyn Program>, tables: Option<PathBuf>) -> AdaptedProgram {
        let files = match tables {
            Some(directory) => Files { tables: None, directory },
            None => Files { tables: Some(program.description().tables.clone()), directory: ".".into() },
        };
        AdaptedProgram { program, description: None, files: Some(files) }
    }

    /// Creates the program that reads the tables of its description only. Errors of other tables
    /// name the directory.
    #[cfg(feature = "command")]
    pub fn stored(program: Arc<dyn Program>, directory: PathBuf) -> AdaptedProgram {
        let files = Files { tables: Some(program.description().tables.clone()), directory };
        AdaptedProgram { program, description: None, files: Some(files) }
    }
}

impl Program for AdaptedProgram {
    fn description(&self) -> &ModelDescription {
        self.description.as_ref().unwrap_or_else(|| self.program.description())
    }

    fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        self.program.kernels()
    }

    fn param_function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError> {
        self.program.param_function(param, which, context)
    }

    fn tables(&self) -> Option<Arc<[FileDescription]>> {
        match &self.files {
            Some(files) => files.tables.clone(),
            None => self.program.tables(),
        }
    }

    fn directory(&self) -> Option<PathBuf> {
        match &self.files {
            Some(files) => Some(files.directory.clone()),
            None => self.program.directory(),
        }
    }

    fn main(&self, context: &mut Context) -> Result<(), RuntimeError> {
        self.program.main(context)
    }

    fn explain(&self, error: &mut RuntimeError, given: &[ParamAssignment], seen: &NanLog) {
        self.program.explain(error, given, seen);
    }
}
