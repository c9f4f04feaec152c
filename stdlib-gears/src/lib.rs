//! Gears: geometry and tooth meshes in Rust, under a library written in Calyx.

pub mod assembly;
pub mod blank;
pub mod derived;
pub mod error;
pub mod external;
pub mod externs;
pub mod fillet;
pub mod flank;
pub mod host;
pub mod internal;
pub mod involute;
pub mod library;
pub mod mesh_geometry;
pub mod modification;
pub mod mounting;
pub mod prototype;
pub mod rack;
mod root_finding;
pub mod sector_mesh;
pub mod tables;
