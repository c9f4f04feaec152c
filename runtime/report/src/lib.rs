//! From results to files: the tables, VTU files and plots of a run, its summary `run.json`, its
//! report page, and the comparison of runs.
//!
//! This crate does not run models. It writes results into the directory that a run has locked, and
//! reads them from there: [`page`] and [`tradeoff`] depend on the files of a run alone.

pub mod bearing_loads;
pub mod body_pictures;
pub mod campbell;
pub mod choices;
pub mod component_table;
pub mod contact_pattern;
pub mod directory;
pub mod durations;
pub mod duty_cycle;
pub mod field_tables;
pub mod flank_tables;
pub mod forced_response;
pub mod former_keys;
pub mod journal;
pub mod modes_table;
pub mod optimization;
#[cfg(feature = "pages")]
pub mod page;
#[cfg(feature = "pages")]
pub mod parquet_table;
pub mod radiated_sound;
pub mod sample;
#[cfg(feature = "pages")]
pub mod sensitivity;
#[cfg(feature = "pages")]
pub mod signals;
pub mod stress_range;
pub mod study;
pub mod summary_table;
pub mod surface_sound;
pub mod sweep;
#[cfg(feature = "pages")]
pub mod tradeoff;
pub mod unv;
pub mod vtu;

pub use calyx_view as view;
