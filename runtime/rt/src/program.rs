//! Interface of compiled models, independent of their code: in memory, linked, or interpreted.

use crate::nan_log::NanLog;
use crate::param_assignment::ParamAssignment;
use calyx_abi::description::{FileDescription, ModelDescription};
use calyx_abi::{Context, Kernel, RuntimeError, Slot};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Kind of function of a param.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParamFunction {
    Default = 0,
    Low = 1,
    High = 2,
}

/// A compiled model. It has no state of a run, so any number of runs may use it concurrently.
pub trait Program: Send + Sync {
    fn description(&self) -> &ModelDescription;

    /// Returns the kernels, one per symbolic site, in order.
    fn kernels(&self) -> Vec<Arc<dyn Kernel>>;

    /// Computes the default of a param, or a bound of its range; `None` if it has none. May read
    /// the params before it.
    fn param_function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError>;

    /// Returns the tables that are part of the program; `None` if it reads all of them from
    /// [`Program::directory`].
    fn tables(&self) -> Option<Arc<[FileDescription]>> {
        let tables = &self.description().tables;
        (!tables.is_empty()).then(|| tables.clone())
    }

    /// Returns the directory below which the program may read files: the directory of the model.
    /// `None` for a model that does not come from a file.
    fn directory(&self) -> Option<PathBuf> {
        let model = Path::new(&self.description().name);
        let beside = model.parent().filter(|_| model.is_file())?;
        Some(if beside.as_os_str().is_empty() { PathBuf::from(".") } else { beside.to_owned() })
    }

    /// Runs the model's top level.
    fn main(&self, context: &mut Context) -> Result<(), RuntimeError>;

    /// Adds the cause of the failure to an error, as far as it can be determined. `given` are the
    /// assigned params and `seen` is the log of its kernels.
    fn explain(&self, error: &mut RuntimeError, given: &[ParamAssignment], seen: &NanLog) {
        let _ = (error, given, seen);
    }
}
