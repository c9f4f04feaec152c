//! What generated code and the engine must agree on, and nothing else.
//!
//! Every crate of the workspace may see this one; it sees none of ours.
//! It holds the one scalar definition of each numeric operation ([`math`]), the calling convention
//! ([`call`]), the run-time values behind opaque slots ([`heap`]), the state a running model carries
//! ([`context`]), its errors ([`error`], [`failure`]) and limits ([`limits`], [`cancel`]), the helpers that programs need beside
//! arithmetic ([`helpers`], as machine code calls them in [`entry`]), how values are shown ([`display`], [`text`],
//! [`units`]) and read ([`quantity`]), the description that every compiled model brings along ([`description`]), and the
//! number by which code knows an engine that keeps the same agreement ([`fingerprint`]).

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
pub mod quantity;
pub mod repr_code;
pub mod shape;
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
