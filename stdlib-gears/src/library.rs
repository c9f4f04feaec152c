//! The library's Calyx source, and the table of the functions behind it.

use calyx_abi::{Extern, Fingerprint, standard};
use std::sync::LazyLock;

/// A library module: its import path, the name it is shown by, its text.
pub struct LibraryModule {
    /// As `import` names it.
    pub path: &'static str,
    /// As messages show it.
    pub file: &'static str,
    /// The source.
    pub text: &'static str,
}

/// Names every model sees.
pub const PRELUDE: LibraryModule =
    LibraryModule { path: "std", file: "<library>/prelude.cx", text: include_str!("../calyx/prelude.cx") };

/// Modules to import.
pub const MODULES: &[LibraryModule] =
    &[LibraryModule { path: "gears", file: "<library>/gears.cx", text: include_str!("../calyx/gears.cx") }];

/// The tables of functions that programs may call: the library's, and those of the language itself.
const TABLES: &[&[Extern]] = &[
    crate::externs::EXTERNS,
    crate::bearing_externs::EXTERNS,
    crate::cutting_externs::EXTERNS,
    crate::gauge_externs::EXTERNS,
    crate::lumped_externs::EXTERNS,
    crate::dynamics_externs::EXTERNS,
    crate::mesh_externs::EXTERNS,
    crate::modification_externs::EXTERNS,
    crate::observable_externs::EXTERNS,
    crate::signal_externs::EXTERNS,
    crate::tables::EXTERNS,
    standard::EXTERNS,
];

/// What code must have been compiled against to run with this engine.
pub const FINGERPRINT: Fingerprint = Fingerprint::of(TABLES);

/// Every function that programs may call.
pub fn externs() -> &'static [Extern] {
    static ALL: LazyLock<Vec<Extern>> = LazyLock::new(|| TABLES.concat());
    &ALL
}
