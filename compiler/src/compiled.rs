//! Compiled program of a module, in the form that the runner uses.

use crate::typed::{LazyTyped, Typed};
use calyx_abi::description::ModelDescription;
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use calyx_codegen::JitModule;
use calyx_elaborate::nan::explain;
use calyx_lang::ir::{FunctionId, SourceFile};
use calyx_rt::program::ParamFunction;
use calyx_rt::{NanLog, ParamAssignment, Program};
use std::sync::Arc;

/// Functions of a param: its default, and the bounds of its range.
pub type ParamFunctions = [Option<FunctionId>; 3];

/// Machine code with its description and sources. The code is freed with the last value that refers
/// to it, including kernels.
pub struct Compiled {
    pub description: ModelDescription,
    pub files: Vec<SourceFile>,
    pub code: JitModule,
    pub param_functions: Vec<ParamFunctions>,
    pub typed: LazyTyped,
}

impl Compiled {
    /// Returns the typed program; `None` if the module was loaded and its sources fail the check,
    /// which the version comparison rules out.
    pub fn typed(&self) -> Option<&Typed> {
        self.typed.get(&self.files)
    }
}

impl Program for Compiled {
    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        self.code.kernels()
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

    fn explain(&self, error: &mut RuntimeError, given: &[ParamAssignment], seen: &NanLog) {
        if let Some(Typed { program, .. }) = self.typed() {
            explain(program, given, seen, error);
        }
    }
}
