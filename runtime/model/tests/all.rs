//! Tests of mechanisms, one module per subject. They are one program: it is linked once, and its
//! tests run in parallel.

mod flanks;
mod lubrication;
mod motion;
mod structure_building;
