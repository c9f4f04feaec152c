//! A compiled model as the runner sees it, wherever its code is: in memory, linked in, or interpreted.

use crate::given::Given;
use crate::seen::Seen;
use calyx_abi::description::ModelDescription;
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use std::sync::Arc;

/// Which function of a param.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParamFunction {
    Default = 0,
    Low = 1,
    High = 2,
}

/// A compiled model. It keeps nothing of a run, so that any number of them go on at once.
pub trait Program: Send + Sync {
    fn description(&self) -> &ModelDescription;

    /// One per symbolic site, in order.
    fn kernels(&self) -> Vec<Arc<dyn Kernel>>;

    /// The default of a param, or an end of its range; `None` if it has none. May read the params before it.
    fn param_function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError>;

    /// Runs the model's top level.
    fn main(&self, context: &mut Context) -> Result<(), RuntimeError>;

    /// Notes at the error that a run ended with what can be said of its cause. `given` is what was set, and `seen` what
    /// its kernels did.
    fn explain(&self, error: &mut RuntimeError, given: &[Given], seen: &Seen) {
        let _ = (error, given, seen);
    }
}
