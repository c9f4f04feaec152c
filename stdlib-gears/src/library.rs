//! Calyx source of the library, and the table of its functions.

use calyx_abi::{Extern, Fingerprint, standard};
use std::sync::LazyLock;

/// Library module: its import path, display name and text.
pub struct LibraryModule {
    /// Path in `import`.
    pub path: &'static str,
    /// Name in diagnostics.
    pub file: &'static str,
    /// Source text.
    pub text: &'static str,
}

/// Module whose names every model sees.
pub const PRELUDE: LibraryModule =
    LibraryModule { path: "std", file: "<library>/prelude.cx", text: include_str!("../calyx/prelude.cx") };

/// Declares library modules by their import paths, which are the names of their files.
macro_rules! modules {
    ($($name:literal),* $(,)?) => {
        &[$(LibraryModule {
            path: $name,
            file: concat!("<library>/", $name, ".cx"),
            text: include_str!(concat!("../calyx/", $name, ".cx")),
        }),*]
    };
}

/// Modules for import.
pub const MODULES: &[LibraryModule] = modules![
    "gears",
    "iso21771",
    "iso1328",
    "deviations",
    "inspection",
    "iso6336",
    "iso6336_1",
    "iso6336_2",
    "iso6336_3",
    "iso6336_5",
    "iso6336_6",
    "scuffing",
    "micropitting",
    "agma908",
    "agma2101",
    "bearing_fits",
    "gear_train",
    "gear_train_equations",
    "linear_equations",
    "stepped_planets",
    "transmission",
    "envelope",
    "bevel",
    "bevel_checks",
    "bevel_contact",
    "bevel_curve",
    "bevel_form",
    "bevel_gear",
    "bevel_mistakes",
    "bevel_pair_checks",
    "bevel_pattern",
    "bevel_section",
    "bevel_settings",
    "bevel_tooth",
];

/// Tables of the functions that programs may call: those of the library, and those of the language
/// itself.
const TABLES: &[&[Extern]] = &[
    crate::externs::EXTERNS,
    crate::bearing_externs::EXTERNS,
    crate::warning_externs::EXTERNS,
    crate::body_externs::EXTERNS,
    crate::cutting_externs::EXTERNS,
    crate::drawing_externs::EXTERNS,
    crate::gauge_externs::EXTERNS,
    crate::lubrication_externs::EXTERNS,
    crate::lumped_externs::EXTERNS,
    crate::dynamics_externs::EXTERNS,
    crate::elastic_externs::EXTERNS,
    crate::mesh_externs::EXTERNS,
    crate::modification_externs::EXTERNS,
    crate::observable_externs::EXTERNS,
    crate::power_flow::EXTERNS,
    crate::carrier_externs::EXTERNS,
    crate::rolling_catalogue::EXTERNS,
    crate::rolling_externs::EXTERNS,
    crate::shaft_externs::EXTERNS,
    crate::signal_externs::EXTERNS,
    crate::sensitivity_externs::EXTERNS,
    crate::sound_externs::EXTERNS,
    crate::stated_geometry::EXTERNS,
    crate::tables::EXTERNS,
    crate::tabulated_externs::EXTERNS,
    crate::web::disc::EXTERNS,
    crate::web::straight::EXTERNS,
    standard::EXTERNS,
];

/// Fingerprint of the function tables. Compiled code only runs with an engine of the same
/// fingerprint.
pub const FINGERPRINT: Fingerprint = Fingerprint::of(TABLES);

/// All functions that programs may call.
pub fn externs() -> &'static [Extern] {
    static ALL: LazyLock<Vec<Extern>> = LazyLock::new(|| TABLES.concat());
    &ALL
}
