//! The state of one running model, as generated code and provided functions see it.

use crate::heap::{Heap, Kernel};
use std::any::Any;
use std::sync::Arc;

/// What the engine keeps for a running model (its scene, its results). Provided functions downcast it.
pub type Host = Box<dyn Any + Send>;

/// Why a call failed.
#[derive(Clone, Debug, PartialEq)]
pub struct RuntimeError {
    /// Stable code, e.g. `E0703`, or the program's own.
    pub code: String,
    pub message: String,
    /// What to do about it; empty if nothing can be said.
    pub help: String,
    /// Name of the argument to blame, if one is (the caller knows where it was written).
    pub argument: Option<String>,
    /// Byte range `(file, start, end)` of the blamed source, filled in by whoever knows it first.
    pub place: Option<(u32, u32, u32)>,
}

/// One running model. Generated code passes its address along and never looks inside.
pub struct Context {
    pub heap: Heap,
    /// Set by whoever returns a status other than `Ok`.
    pub error: Option<RuntimeError>,
    /// Values of the model's params in SI, one per param that is a number (others hold NaN);
    /// part of every kernel's inputs.
    pub params: Vec<f64>,
    /// Slots of all params in order of declaration, as the program reads them.
    pub param_slots: Vec<u64>,
    /// One kernel per symbolic site of the module.
    pub kernels: Vec<Arc<dyn Kernel>>,
    /// The engine's own state.
    pub host: Host,
    /// Lines the program printed are handed to this.
    pub print: Box<dyn FnMut(&str) + Send>,
    /// Basic blocks the program may still enter before it is stopped; `check` sets a limit.
    pub fuel: u64,
    /// Source range `(file, start, end)` of the call under way, for error messages.
    pub place: (u32, u32, u32),
}

impl Context {
    pub fn new(host: Host) -> Self {
        Context {
            heap: Heap::default(),
            error: None,
            params: Vec::new(),
            param_slots: Vec::new(),
            kernels: Vec::new(),
            host,
            print: Box::new(|line| println!("{line}")),
            fuel: u64::MAX,
            place: (0, 0, 0),
        }
    }

    /// The engine's state, if it is of type `T`.
    pub fn host<T: 'static>(&mut self) -> Option<&mut T> {
        self.host.downcast_mut()
    }
}
