//! What every compiled model says of itself: the same structure feeds `--help`, hover, results and error messages.
//!
//! In an object file it is stored as JSON, made and read by the crates that know serde; here are only its types'
//! meaning and the C layout by which a linked model is found.

use crate::call::{KernelFn, SlotFn};

/// A linked model, as the object file exports it under the symbol `calyx_model`.
#[repr(C)]
pub struct ModuleTable {
    /// [`crate::ABI_VERSION`] of the compiler.
    pub abi_version: u64,
    /// Runs the program's top level once.
    pub main: SlotFn,
    /// Kernels in order of site.
    pub kernels: *const KernelFn,
    pub kernel_count: u64,
    /// The description, UTF-8 JSON (see `calyx_lang::description`).
    pub description: *const u8,
    pub description_len: u64,
}

// SAFETY: the table and what it points to are constants of the linked program.
unsafe impl Sync for ModuleTable {}
