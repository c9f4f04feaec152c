//! Tests of radiated sound, one module per subject.

mod fields;
mod levels;
mod meshes;
mod nastran_results;
mod op2_writer;
mod plane_sources;
mod resources;
mod shapes;
mod shells;
mod skins;
mod special_functions;
mod spheres;
mod surface_sound;
mod transfer;
mod unv;
