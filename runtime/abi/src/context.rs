//! State of a running model, shared by generated code and provided functions.

use crate::call::Slot;
use crate::cancel::Cancel;
use crate::description::{FileDescription, UnitDescription};
pub use crate::error::{RuntimeError, codes};
use crate::heap::{Heap, Kernel};
use crate::host::Resolved;
use crate::limits::Limits;
use std::any::Any;
use std::io::{self, Write};
use std::mem::offset_of;
use std::path::PathBuf;
use std::sync::Arc;

/// State of the engine for a running model (its scene, its results). Provided functions downcast
/// it.
pub type Host = Box<dyn Any + Send>;

/// Maximum depth of calls. With [`crate::stack::STACK_BYTES`] of stack each call has 256 KiB.
pub const MAX_DEPTH: u64 = 1000;

/// State of a running model.
///
/// Generated code accesses only the first four fields directly, at the offsets of [`Layout`].
/// Object files rely on them, so they are part of its [`Fingerprint`](crate::Fingerprint).
#[repr(C)]
pub struct Context {
    /// Number of basic blocks that may be entered before [`crate::limits::refuel`] must be called.
    pub granted: u64,
    /// Present depth of calls, at most [`MAX_DEPTH`].
    pub depth: u64,
    /// Source range `(file, start, end)` of the present call, for error messages.
    pub place: (u32, u32, u32),
    /// Source range of the innermost active call of a library function by the program, for
    /// findings, which have no call stack; zero outside of such calls.
    pub library_call: (u32, u32, u32),
    pub heap: Heap,
    /// Error of the call that returned a status other than `Ok`.
    pub error: Option<RuntimeError>,
    /// Values of the model's params in SI, one per numeric param (others are NaN); part of every
    /// kernel's inputs.
    pub params: Vec<f64>,
    /// Slots of all params in order of declaration.
    pub param_slots: Vec<Slot>,
    /// Kernels by symbolic site of the module.
    pub kernels: Vec<Arc<dyn Kernel>>,
    /// Host functions of the embedding program, in the order of the model's description.
    pub host_functions: Resolved,
    /// State of the engine.
    pub host: Host,
    /// Receiver of the lines that the program prints.
    pub print: Box<dyn FnMut(&str) + Send>,
    /// Fuel: number of basic blocks that the program may still enter; `check` sets a limit.
    pub fuel: u64,
    /// Cancellation flag.
    pub cancel: Cancel,
    /// Limits of time and memory.
    pub limits: Limits,
    /// Source files, for the locations of caught errors.
    pub files: Arc<[FileDescription]>,
    /// Directory below which the program may read files; `None` if there is none.
    pub directory: Option<PathBuf>,
    /// Files and directories outside `directory` that the program may read too, as absolute paths
    /// without links.
    pub allowed: Arc<[PathBuf]>,
    /// Tables stored with the program, by the names that it uses: these are not read from
    /// `directory`. `None` for a program next to its tables.
    pub tables: Option<Arc<[FileDescription]>>,
    /// Units for reading quantities given as text.
    pub units: Arc<[UnitDescription]>,
    /// The string under construction.
    pub text: String,
    /// Buffer for the inputs and outputs of kernels.
    pub numbers: Vec<f64>,
    /// True if printed lines are kept in memory, where they count towards the limit.
    pub keeps_output: bool,
    /// Size of the kept lines, bytes.
    pub kept_output: u64,
    /// Size of the tables that the program has read, bytes.
    pub kept_tables: u64,
    /// Path of the instance of a component that is being built; empty outside of components.
    pub instance: String,
}

/// Byte offsets of the fields of [`Context`] that generated code accesses.
pub struct Layout;

impl Layout {
    pub const GRANTED: usize = offset_of!(Context, granted);
    pub const DEPTH: usize = offset_of!(Context, depth);
    pub const PLACE_FILE: usize = offset_of!(Context, place.0);
    pub const PLACE_START: usize = offset_of!(Context, place.1);
    pub const PLACE_END: usize = offset_of!(Context, place.2);
    pub const LIBRARY_CALL_FILE: usize = offset_of!(Context, library_call.0);
    pub const LIBRARY_CALL_START: usize = offset_of!(Context, library_call.1);
    pub const LIBRARY_CALL_END: usize = offset_of!(Context, library_call.2);
}

const _: () = {
    assert!(Layout::GRANTED == 0 && Layout::DEPTH == 8);
    assert!(Layout::PLACE_FILE == 16 && Layout::PLACE_START == 20 && Layout::PLACE_END == 24);
    assert!(Layout::LIBRARY_CALL_FILE == 28 && Layout::LIBRARY_CALL_START == 32);
    assert!(Layout::LIBRARY_CALL_END == 36);
};

impl Context {
    pub fn new(host: Host) -> Self {
        Context {
            granted: 0,
            depth: 0,
            place: (0, 0, 0),
            library_call: (0, 0, 0),
            heap: Heap::default(),
            error: None,
            params: Vec::new(),
            param_slots: Vec::new(),
            kernels: Vec::new(),
            host_functions: Resolved::default(),
            host,
            print: Box::new(|line| drop(writeln!(io::stdout(), "{line}"))),
            fuel: u64::MAX,
            cancel: Cancel::default(),
            limits: Limits::default(),
            files: Arc::default(),
            directory: None,
            allowed: Arc::default(),
            tables: None,
            units: Arc::default(),
            text: String::new(),
            numbers: Vec::new(),
            keeps_output: false,
            kept_output: 0,
            kept_tables: 0,
            instance: String::new(),
        }
    }

    /// Returns a name that the model gives to a part, with the path of the instance that is being
    /// built: `low.sun`.
    pub fn name_in_instance(&self, name: String) -> String {
        if self.instance.is_empty() { name } else { format!("{}.{name}", self.instance) }
    }

    /// Returns the state of the engine, if it has type `T`.
    pub fn host<T: 'static>(&mut self) -> Option<&mut T> {
        self.host.downcast_mut()
    }
}
