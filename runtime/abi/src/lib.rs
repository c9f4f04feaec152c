//! Interface between generated code and the engine.
//!
//! Every crate of the workspace may depend on this one; it depends on none of them.
//!
//! - [`math`]: the single scalar definition of each numeric operation. [`newton`]: solution of
//!   implicit equations. [`piecewise`]: interpolation tables.
//! - [`call`]: calling convention. [`heap`]: run-time values behind slots.
//! - [`context`]: state of a running model. [`error`], [`failure`]: its errors. [`limits`],
//!   [`cancel`]: its limits.
//! - [`helpers`]: operations of programs besides arithmetic; [`entry`] exports them to machine
//!   code.
//! - [`display`], [`text`], [`units`]: output of values. [`quantity`]: their input.
//! - [`description`]: description that every compiled model contains.
//! - [`fingerprint`]: hash by which code recognizes an engine with the same interface.

pub mod attribution;
pub mod blame;
pub mod call;
pub mod cancel;
pub mod context;
pub mod description;
pub mod display;
pub mod entry;
pub mod error;
pub mod externs;
pub mod failure;
pub mod fingerprint;
pub mod heap;
pub mod helpers;
pub mod host;
pub mod limits;
pub mod math;
pub mod newton;
pub mod piecewise;
pub mod quantity;
pub mod repr_code;
pub mod shape;
pub mod shell;
pub mod stack;
pub mod standard;
pub mod text;
pub mod trigonometry;
pub mod units;
pub mod visible;

pub use call::{Extern, Purity, Repr, Slot, SlotFn, Status};
pub use cancel::Cancel;
pub use context::{Context, Host};
pub use error::RuntimeError;
pub use fingerprint::Fingerprint;
pub use heap::{Heap, HeapId, Kernel, SymbolicValue};
pub use shape::Shape;
