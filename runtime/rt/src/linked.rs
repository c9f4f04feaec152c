//! A model whose machine code is linked into this program: its module table as a [`Program`].

use crate::program::{ParamFunction, Program};
use calyx_abi::call::KernelFn;
use calyx_abi::description::{ModelDescription, ModuleTable};
use calyx_abi::{Context, Fingerprint, Kernel, RuntimeError, Slot, stack};
use calyx_gears::library::FINGERPRINT;
use std::fmt;
use std::sync::Arc;

/// Fingerprint of the engine in this library, by which `calyx build` checks compatibility.
#[unsafe(no_mangle)]
pub static CALYX_RT_ABI: u64 = FINGERPRINT.0;

/// A model whose code is linked into this program.
pub(crate) struct LinkedProgram {
    module: &'static ModuleTable,
    description: ModelDescription,
}

/// Reason why a linked model cannot be run.
pub(crate) enum NotLinked {
    /// The model was compiled against another engine.
    Version(Fingerprint),
    /// The description cannot be parsed.
    Damaged(serde_json::Error),
}

impl fmt::Display for NotLinked {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotLinked::Version(compiled_for) => write!(
                f,
                "the model was compiled for another version of Calyx than it is linked with\n  \
                 help: compile the model again with the `calyx` of this engine (the model's code expects the interface \
                 {compiled_for}, the engine has {FINGERPRINT})"
            ),
            NotLinked::Damaged(error) => write!(
                f,
                "the model's description is damaged: {error}\n  help: compile the model again with the `calyx` of this engine"
            ),
        }
    }
}

impl LinkedProgram {
    pub(crate) fn new(module: &'static ModuleTable) -> Result<Self, NotLinked> {
        let compiled_for = Fingerprint(module.abi);
        if compiled_for != FINGERPRINT {
            return Err(NotLinked::Version(compiled_for));
        }
        // SAFETY: the table states the length of its constant description.
        let bytes =
            unsafe { std::slice::from_raw_parts(module.description, module.description_len as usize) };
        let description = serde_json::from_slice(bytes).map_err(NotLinked::Damaged)?;
        Ok(LinkedProgram { module, description })
    }
}

/// A kernel in the linked code.
struct LinkedKernel {
    function: KernelFn,
    inputs: usize,
    outputs: usize,
}

impl Kernel for LinkedKernel {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        assert!(
            inputs.len() >= self.inputs && outputs.len() >= self.outputs,
            "a kernel was given too few values"
        );
        // SAFETY: the lengths were checked against the description that was compiled with the code.
        unsafe { (self.function)(inputs.as_ptr(), outputs.as_mut_ptr()) }
    }
    fn inputs(&self) -> usize {
        self.inputs
    }
    fn outputs(&self) -> usize {
        self.outputs
    }
}

impl Program for LinkedProgram {
    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        let kernels = self.description.kernels.iter().enumerate();
        kernels
            .map(|(index, kernel)| {
                Arc::new(LinkedKernel {
                    // SAFETY: the table has one function per described kernel.
                    function: unsafe { *self.module.kernels.add(index) },
                    inputs: kernel.inputs,
                    outputs: kernel.outputs,
                }) as Arc<dyn Kernel>
            })
            .collect()
    }

    fn param_function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError> {
        // SAFETY: the table has three entries per described param.
        let Some(function) = (unsafe { *self.module.param_functions.add(3 * param + which as usize) }) else {
            return Ok(None);
        };
        // SAFETY: a param's function takes no arguments and returns one slot.
        let result = unsafe { stack::run(context, function, &[], 1) }?;
        Ok(result.first().copied())
    }

    fn main(&self, context: &mut Context) -> Result<(), RuntimeError> {
        // SAFETY: the top level takes no arguments and returns nothing.
        unsafe { stack::run(context, self.module.main, &[], 0) }.map(|_| ())
    }
}
