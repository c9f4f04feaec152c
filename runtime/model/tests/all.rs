//! Tests of mechanisms, one module per subject. They are one program: it is linked once, and its
//! tests run in parallel.

mod bars;
mod connections;
mod elastic_bodies;
mod elastic_body_checks;
mod flanks;
mod linearized_bearings;
mod lubrication;
mod motion;
mod motion_shapes;
mod raceway;
mod shafts;
mod solid_shafts;
mod structure_building;
