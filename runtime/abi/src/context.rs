//! The state of one running model, as generated code and provided functions see it.

use crate::call::Slot;
use crate::cancel::Cancel;
use crate::description::{FileDescription, UnitDescription};
pub use crate::error::{RuntimeError, codes};
use crate::heap::{Heap, Kernel};
use crate::host::Resolved;
use crate::limits::Limits;
use std::any::Any;
use std::mem::offset_of;
use std::path::PathBuf;
use std::sync::Arc;

/// What the engine keeps for a running model (its scene, its results). Provided functions downcast it.
pub type Host = Box<dyn Any + Send>;

/// Calls that may be under way at once. With [`crate::stack::STACK_BYTES`] of stack this leaves 256 KiB to each.
pub const MAX_DEPTH: u64 = 1000;

/// One running model.
///
/// The first three fields are the only ones that generated code reads and writes itself, at the offsets of
/// [`Layout`]; object files rely on them, so they are part of its [`Fingerprint`](crate::Fingerprint).
#[repr(C)]
pub struct Context {
    /// Basic blocks that may be entered before [`crate::limits::refuel`] must be asked for more.
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
    /// What the embedding program provides of the model's host functions, in the order of its description.
    pub host_functions: Resolved,
    /// The engine's own state.
    pub host: Host,
    /// Lines the program printed are handed to this.
    pub print: Box<dyn FnMut(&str) + Send>,
    /// Basic blocks the program may still enter before it is stopped; `check` sets a limit.
    pub fuel: u64,
    /// Stops the program soon, from any thread.
    pub cancel: Cancel,
    /// Time and memory it may use.
    pub limits: Limits,
    /// The source, by which a caught error tells its place.
    pub files: Arc<[FileDescription]>,
    /// The directory below which the program may read files; none if there is none.
    pub directory: Option<PathBuf>,
    /// Files and directories outside of `directory` that the program may read too, as absolute
    /// paths without links.
    pub allowed: Arc<[PathBuf]>,
    /// Tables that travel with the program, by the names it reads them by: these are not looked for in `directory`.
    /// `None` for a program that is beside its tables.
    pub tables: Option<Arc<[FileDescription]>>,
    /// Units by which quantities given as text are read.
    pub units: Arc<[UnitDescription]>,
    /// The string under construction.
    pub text: String,
    /// Whether printed lines stay in memory, where they count towards the limit.
    pub keeps_output: bool,
    /// Bytes of the lines that were kept.
    pub kept_output: u64,
    /// Bytes of the tables that the program has read.
    pub kept_tables: u64,
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
            host_functions: Resolved::default(),
            host,
            print: Box::new(|line| println!("{line}")),
            fuel: u64::MAX,
            cancel: Cancel::default(),
            limits: Limits::default(),
            files: Arc::default(),
            directory: None,
            allowed: Arc::default(),
            tables: None,
            units: Arc::default(),
            text: String::new(),
            keeps_output: false,
            kept_output: 0,
            kept_tables: 0,
        }
    }

    /// The engine's state, if it is of type `T`.
    pub fn host<T: 'static>(&mut self) -> Option<&mut T> {
        self.host.downcast_mut()
    }
}
