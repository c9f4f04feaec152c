//! The outputs of a run. If outputs are arrays, their number follows from the params, and is known
//! when the model has been built.

use crate::nan_log::NanLog;
use crate::param_assignment::ParamAssignment;
use crate::program::{ParamFunction, Program};
use calyx_abi::description::{FileDescription, ModelDescription};
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use std::path::PathBuf;
use std::sync::Arc;

/// A program with the outputs of particular params.
pub(crate) struct Described {
    program: Arc<dyn Program>,
    description: ModelDescription,
}

impl Described {
    /// Creates the program whose runs have outputs of the given names.
    pub fn new<'n>(program: Arc<dyn Program>, names: impl Iterator<Item = &'n str>) -> Described {
        let description = program.description().with_outputs(names);
        let description = ModelDescription { declared_outputs: Vec::new(), ..description };
        Described { program, description }
    }
}

impl Program for Described {
    fn description(&self) -> &ModelDescription {
        &self.description
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
        self.program.tables()
    }

    fn directory(&self) -> Option<PathBuf> {
        self.program.directory()
    }

    fn main(&self, context: &mut Context) -> Result<(), RuntimeError> {
        self.program.main(context)
    }

    fn explain(&self, error: &mut RuntimeError, given: &[ParamAssignment], seen: &NanLog) {
        self.program.explain(error, given, seen);
    }
}
