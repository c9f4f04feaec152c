//! The state of one running model, as generated code and provided functions see it.

use crate::call::{Slot, Status};
use crate::heap::{Heap, Kernel};
use std::any::Any;
use std::mem::offset_of;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

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

impl RuntimeError {
    /// An error without a place; whoever knows one fills it in.
    pub fn new(code: &str, message: impl Into<String>, help: impl Into<String>) -> Self {
        RuntimeError {
            code: code.into(),
            message: message.into(),
            help: help.into(),
            argument: None,
            place: None,
        }
    }

    /// What a function that fails with this error returns.
    pub fn status(&self) -> Status {
        match self.code.as_str() {
            codes::LIMIT | codes::CANCELLED => Status::Cancelled,
            _ => Status::Failed,
        }
    }
}

/// Codes of the errors that running programs raise by themselves.
pub mod codes {
    /// An index that is not whole or not within the array.
    pub const INDEX: &str = "E0701";
    /// Functions call each other too deeply.
    pub const DEPTH: &str = "E0702";
    /// The limit on the number of basic blocks was reached.
    pub const LIMIT: &str = "E0703";
    /// Somebody set [`super::Context::cancel`].
    pub const CANCELLED: &str = "E0704";
    /// An `assert` failed.
    pub const ASSERTION: &str = "E0705";
    /// An observable was asked for its value while the model is still being built.
    pub const OBSERVABLE: &str = "E0706";
    /// A fault of the engine or the compiler, not of the program.
    pub const INTERNAL: &str = "E0799";
}

/// Calls that may be under way at once. With [`crate::stack::STACK_BYTES`] of stack this leaves 256 KiB to each.
pub const MAX_DEPTH: u64 = 1000;

/// One running model.
///
/// The first three fields are the only ones that generated code reads and writes itself, at the offsets of
/// [`Layout`]; object files rely on them, so a change is a change of [`crate::ABI_VERSION`].
#[repr(C)]
pub struct Context {
    /// Basic blocks that may be entered before [`crate::helpers::refuel`] must be asked for more.
    pub granted: u64,
    /// Calls under way, at most [`MAX_DEPTH`].
    pub depth: u64,
    /// Source range `(file, start, end)` of the call under way, for error messages.
    pub place: (u32, u32, u32),
    pub heap: Heap,
    /// Set by whoever returns a status other than `Ok`.
    pub error: Option<RuntimeError>,
    /// Values of the model's params in SI, one per param that is a number (others hold NaN);
    /// part of every kernel's inputs.
    pub params: Vec<f64>,
    /// Slots of all params in order of declaration, as the program reads them.
    pub param_slots: Vec<Slot>,
    /// One kernel per symbolic site of the module.
    pub kernels: Vec<Arc<dyn Kernel>>,
    /// The engine's own state.
    pub host: Host,
    /// Lines the program printed are handed to this.
    pub print: Box<dyn FnMut(&str) + Send>,
    /// Basic blocks the program may still enter before it is stopped; `check` sets a limit.
    pub fuel: u64,
    /// Set from any thread, it stops the program soon.
    pub cancel: Arc<AtomicBool>,
    /// The string under construction.
    pub text: String,
}

/// Offsets in bytes of the fields of [`Context`] that generated code touches.
pub struct Layout;

impl Layout {
    pub const GRANTED: usize = offset_of!(Context, granted);
    pub const DEPTH: usize = offset_of!(Context, depth);
    pub const PLACE_FILE: usize = offset_of!(Context, place.0);
    pub const PLACE_START: usize = offset_of!(Context, place.1);
    pub const PLACE_END: usize = offset_of!(Context, place.2);
}

const _: () = {
    assert!(Layout::GRANTED == 0 && Layout::DEPTH == 8);
    assert!(Layout::PLACE_FILE == 16 && Layout::PLACE_START == 20 && Layout::PLACE_END == 24);
};

impl Context {
    pub fn new(host: Host) -> Self {
        Context {
            granted: 0,
            depth: 0,
            place: (0, 0, 0),
            heap: Heap::default(),
            error: None,
            params: Vec::new(),
            param_slots: Vec::new(),
            kernels: Vec::new(),
            host,
            print: Box::new(|line| println!("{line}")),
            fuel: u64::MAX,
            cancel: Arc::default(),
            text: String::new(),
        }
    }

    /// The engine's state, if it is of type `T`.
    pub fn host<T: 'static>(&mut self) -> Option<&mut T> {
        self.host.downcast_mut()
    }
}
