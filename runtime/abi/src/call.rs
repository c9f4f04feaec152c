//! The calling convention: every function, compiled or provided by the engine, takes and returns 64-bit slots.

use crate::context::Context;
use crate::shape::Shape;

/// One 64-bit machine word: the bits of an `f64`, a truth value (0 or 1), or a [`crate::HeapId`].
pub type Slot = u64;

/// Outcome of a call. Generated code compares it with zero and returns at once when it is not.
/// The cause then stands in [`Context::error`].
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    Ok = 0,
    /// `Context::error` says why. Catchable by the program.
    Failed = 1,
    /// The run was cancelled or a limit was reached. Not catchable.
    Cancelled = 2,
}

/// Signature of every compiled function and of every function the engine provides.
///
/// `args` points to the slots of all arguments in order of declaration (see [`Repr::slots`]),
/// `ret` to room for the slots of the result. Returns a [`Status`] as `i32`.
///
/// # Safety
/// `ctx` is valid and not aliased, `args` and `ret` hold as many slots as the declaration says.
pub type SlotFn = unsafe extern "C" fn(ctx: *mut Context, args: *const Slot, ret: *mut Slot) -> i32;

/// A kernel: straight-line code without side effects, from inputs to outputs (SI units).
///
/// Inputs are `[Time, params..., captured values...]`, see [`crate::heap::Kernel`].
///
/// # Safety
/// The pointers hold as many values as the kernel's description says.
pub type KernelFn = unsafe extern "C" fn(inputs: *const f64, outputs: *mut f64);

/// How a value is represented in slots. Dimensions are gone: every number is an `f64` in SI.
#[derive(Clone, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub enum Repr {
    /// No value (a function without result). No slot.
    Unit,
    /// One slot: `f64::to_bits`.
    Number,
    /// One slot: 0 or 1.
    Bool,
    /// One slot: heap id of an immutable string.
    String,
    /// Three slots: components along e1, e2, e3.
    Vector,
    /// Twelve slots: the rotation matrix row by row (9), then the translation (3): `x' = R x + t`.
    Transform,
    /// One slot: heap id of an array whose elements are stored flat, `slots()` each.
    Array(Box<Repr>),
    /// The elements one after another.
    Tuple(Vec<Repr>),
    /// One slot: heap id of a symbolic value (a site with its captured numbers).
    /// The content tells what it evaluates to: Number, Vector or Transform.
    Symbolic(Box<Repr>),
    /// One slot: a number the engine hands out (a body, a gear, a mesh); its meaning is the engine's alone.
    Handle,
}

impl Repr {
    /// Number of slots a value takes.
    pub fn slots(&self) -> usize {
        match self {
            Repr::Unit => 0,
            Repr::Vector => 3,
            Repr::Transform => 12,
            Repr::Tuple(elements) => elements.iter().map(Repr::slots).sum(),
            Repr::Number | Repr::Bool | Repr::String | Repr::Array(_) | Repr::Symbolic(_) | Repr::Handle => 1,
        }
    }
}

/// What calling a provided function may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purity {
    /// Depends on its arguments alone. Called by `check` and the editor.
    Pure,
    /// Adds to the scene. Called by `check` on a scratch scene.
    Scene,
    /// Solves something or writes to the outside. Never called by `check`.
    Effect,
}

/// Name and representation of a provided function's parameter.
pub type ExternParameter = (&'static str, Shape);

/// One function that the engine provides to programs: the row from which the interpreter's table, the machine
/// code's symbol table and the link symbols all come.
#[derive(Clone)]
pub struct Extern {
    /// Link symbol, e.g. `calyx_gears_material`: `calyx_` + module + `_` + name in the Calyx declaration.
    pub symbol: &'static str,
    pub purity: Purity,
    /// In order.
    pub params: &'static [ExternParameter],
    pub result: Shape,
    pub call: SlotFn,
}
