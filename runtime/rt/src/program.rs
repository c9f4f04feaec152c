//! A compiled model as the runner sees it, wherever its code is: in memory, linked in, or interpreted.

use crate::nan_log::NanLog;
use crate::param_assignment::ParamAssignment;
use calyx_abi::description::{FileDescription, ModelDescription};
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use std::path::{Path, PathBuf};
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

    /// Tables that travel with the program; `None` if it reads all of them from [`Program::directory`].
    fn tables(&self) -> Option<Arc<[FileDescription]>> {
        let tables = &self.description().tables;
        (!tables.is_empty()).then(|| tables.clone())
    }

    /// The directory below which the program may read files; `None` if there is none. The model's own, unless it is a text
    /// that came from no file.
    fn directory(&self) -> Option<PathBuf> {
        let model = Path::new(&self.description().name);
        let beside = model.parent().filter(|_| model.is_file())?;
        Some(if beside.as_os_str().is_empty() { PathBuf::from(".") } else { beside.to_owned() })
    }

    /// Runs the model's top level.
    fn main(&self, context: &mut Context) -> Result<(), RuntimeError>;

    /// Notes at the error that a run ended with what can be said of its cause. `given` is what was set, and `seen` what
    /// its kernels did.
    fn explain(&self, error: &mut RuntimeError, given: &[ParamAssignment], seen: &NanLog) {
        let _ = (error, given, seen);
    }
}
