//! Tests of mechanisms, one module per subject. They are one program: it is linked once, and its
//! tests run in parallel.

mod connections;
mod elastic_bodies;
mod flanks;
mod lubrication;
mod motion;
mod shafts;
mod structure_building;
