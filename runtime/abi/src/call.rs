//! Calling convention: every function, compiled or provided by the engine, takes and returns 64-bit
//! slots.

use crate::context::Context;
use crate::shape::Shape;

/// 64-bit slot: the bits of an `f64`, a Boolean (0 or 1), or a [`crate::HeapId`].
pub type Slot = u64;

/// Status of a call. Generated code compares it with zero and returns immediately if it differs.
/// The cause is in [`Context::error`].
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    Ok = 0,
    /// Failed; `Context::error` contains the reason. The program can catch it.
    Failed = 1,
    /// The run was cancelled or a limit was reached. The program cannot catch it.
    Cancelled = 2,
}

/// Signature of every compiled function and of every function of the engine.
///
/// `args` points to the slots of all arguments in order of declaration (see [`Repr::slots`]), `ret`
/// to space for the slots of the result. Returns a [`Status`] as `i32`.
///
/// # Safety
/// `ctx` must be valid and not aliased; `args` and `ret` must have the declared numbers of slots.
pub type SlotFn = unsafe extern "C" fn(ctx: *mut Context, args: *const Slot, ret: *mut Slot) -> i32;

/// Signature of a kernel: straight-line code without side effects, from inputs to outputs (SI
/// units).
///
/// Inputs are `[Time, params..., captured values...]`, see [`crate::heap::Kernel`].
///
/// # Safety
/// The pointers must have the numbers of values of the kernel's description.
pub type KernelFn = unsafe extern "C" fn(inputs: *const f64, outputs: *mut f64);

/// Representation of a value in slots. It contains no dimensions: every number is an `f64` in SI
/// units.
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
    /// One slot: heap id of a symbolic value (a site with its captured numbers) that evaluates to
    /// the content: Number, Vector or Transform.
    Symbolic(Box<Repr>),
    /// One slot: a number of the engine (a body, a gear, a mesh), opaque to programs.
    Handle,
}

impl Repr {
    /// Returns the number of slots of a value.
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

/// Permitted effects of a provided function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purity {
    /// The result depends only on the arguments. `check` and the editor call it.
    Pure,
    /// Adds to the scene. `check` calls it on a scratch scene.
    Scene,
    /// Solves or has external effects. `check` never calls it.
    Effect,
}

/// Name and representation of a parameter of a provided function.
pub type ExternParameter = (&'static str, Shape);

/// Function that the engine provides to programs: a row of the table from which the interpreter's
/// table, the symbol table of machine code and the link symbols are generated.
#[derive(Clone)]
pub struct Extern {
    /// Link symbol, e.g. `calyx_gears_material`: `calyx_` + module + `_` + name in the Calyx
    /// declaration.
    pub symbol: &'static str,
    pub purity: Purity,
    /// Parameters in order.
    pub params: &'static [ExternParameter],
    pub result: Shape,
    pub call: SlotFn,
}
