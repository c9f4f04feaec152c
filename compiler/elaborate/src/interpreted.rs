//! A model run by the interpreter: used by `check`, and as the reference for compiled models.

use crate::known_results::KnownResults;
use calyx_abi::description::{ModelDescription, ParamValue};
use calyx_abi::{Context, Kernel, Purity, Repr, RuntimeError, Slot};
use calyx_gears::library::{FINGERPRINT, externs};
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{FunctionId, Program};
use calyx_lower::interpret::{Interpreter, NanTrace};
use calyx_lower::kernels::{KernelError, lower_sites};
use calyx_lower::repeatable::RepeatableFunctions;
use calyx_lower::traverse::is_constant;
use calyx_rt::Error;
use calyx_rt::program::ParamFunction;
use calyx_symbolic::TapeKernel;
use std::sync::Arc;

/// A checked model and its interpreter.
pub struct Interpreted<'p> {
    program: &'p Program,
    interpreter: Interpreter<'p>,
    kernels: Vec<Arc<dyn Kernel>>,
    description: ModelDescription,
}

impl<'p> Interpreted<'p> {
    /// Prepares a model. Calls only engine functions whose purity is at most `allow`.
    ///
    /// # Errors
    /// E0708 if the program declares a function that the engine lacks; E0709 if an expression has
    /// no kernel.
    pub fn new(program: &'p Program, allow: Purity) -> Result<Self, Box<Diagnostic>> {
        let tapes = lower_sites(program).map_err(|error| no_kernel(&error))?;
        let kernels: Vec<_> = tapes.into_iter().map(|tape| Arc::new(TapeKernel(tape))).collect();
        Self::with_kernels(program, allow, &kernels)
    }

    /// Prepares a model with the kernels of all sites, in order.
    pub(crate) fn with_kernels(
        program: &'p Program,
        allow: Purity,
        kernels: &[Arc<TapeKernel>],
    ) -> Result<Self, Box<Diagnostic>> {
        let interpreter = Interpreter::new(program, externs(), allow).map_err(|error| {
            Diagnostic::error("E0708", error.to_string(), error.span, "declared here")
                .help("`extern` declares functions of the engine; write your own without it, with a body")
        })?;
        let description = calyx_lang::description::describe(program, FINGERPRINT);
        let kernels = kernels.iter().map(|kernel| kernel.clone() as Arc<dyn Kernel>).collect();
        Ok(Interpreted { program, interpreter, kernels, description })
    }

    /// Continues after library calls that report a problem of the model; see
    /// [`Interpreted::failures`].
    pub fn recovering(mut self) -> Self {
        self.interpreter = self.interpreter.recovering();
        self
    }

    /// Returns the failures after which the program continued, in order.
    pub fn failures(&self) -> Vec<RuntimeError> {
        self.interpreter.failures()
    }

    /// Reuses results of earlier elaborations for calls of these functions.
    pub(crate) fn reusing(mut self, functions: &'p RepeatableFunctions) -> Self {
        self.interpreter = self.interpreter.reusing(&KnownResults, functions);
        self
    }

    /// Enables NaN tracing.
    pub(crate) fn tracing(mut self) -> Self {
        self.interpreter = self.interpreter.tracing();
        self
    }

    /// Enables tracing of infinite results, see [`Interpreter::tracing_infinities`].
    pub(crate) fn tracing_infinities(mut self) -> Self {
        self.interpreter = self.interpreter.tracing_infinities();
        self
    }

    pub(crate) fn trace(&self) -> Option<&NanTrace> {
        self.interpreter.trace()
    }

    /// Runs the model's top level and returns the final slots of its variables.
    pub(crate) fn main_to_values(&self, context: &mut Context) -> Result<Vec<Slot>, RuntimeError> {
        self.interpreter.run_main_to_values(context)
    }

    /// Sets the defaults and ranges of the params. `context` has the params at their defaults.
    pub(crate) fn describe_params(&mut self, context: &mut Context) -> Result<(), Error> {
        for index in 0..self.description.params.len() {
            let mut end = |which| {
                let slot = self.function(index, which, context).map_err(Error::Model)?;
                Ok::<_, Error>(slot.map(f64::from_bits))
            };
            let (low, high) = (end(ParamFunction::Low)?, end(ParamFunction::High)?);
            let functions = [ParamFunction::Default, ParamFunction::Low, ParamFunction::High];
            let mut functions =
                functions.iter().filter_map(|which| param_function(self.program, index, *which));
            let independent = functions.all(|function| is_constant(self.program, function));
            let param = &mut self.description.params[index];
            (param.low, param.high, param.independent) = (low, high, independent);
            let slot = context.param_slots[index];
            param.default = Some(match param.repr {
                Repr::Bool => ParamValue::Bool(slot != 0),
                Repr::String => ParamValue::String(context.heap.str(slot).unwrap_or_default().to_owned()),
                Repr::Array(_) => ParamValue::Numbers(context.heap.numbers(slot).unwrap_or_default()),
                _ => ParamValue::Number(f64::from_bits(slot)),
            });
        }
        Ok(())
    }

    pub(crate) fn into_description(self) -> ModelDescription {
        self.description
    }

    fn function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError> {
        let Some(id) = param_function(self.program, param, which) else { return Ok(None) };
        Ok(self.interpreter.run_function(id, &[], context)?.first().copied())
    }
}

/// Converts the error of an expression without a kernel to a diagnostic.
pub(crate) fn no_kernel(error: &KernelError) -> Box<Diagnostic> {
    let found = Diagnostic::error("E0709", &error.message, error.span, "this expression");
    Box::new(if error.help.is_empty() { found } else { found.help(&error.help) })
}

/// Returns the function that computes a param's default or a limit of its range.
pub fn param_function(program: &Program, param: usize, which: ParamFunction) -> Option<FunctionId> {
    let param = program.params.get(param)?;
    match which {
        ParamFunction::Default => Some(param.default),
        ParamFunction::Low => param.low,
        ParamFunction::High => param.high,
    }
}

impl calyx_rt::Program for Interpreted<'_> {
    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        self.kernels.clone()
    }

    fn param_function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError> {
        self.function(param, which, context)
    }

    fn main(&self, context: &mut Context) -> Result<(), RuntimeError> {
        self.interpreter.run_main(context)
    }
}
