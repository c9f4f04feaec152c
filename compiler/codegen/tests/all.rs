//! Tests of code generation, one module per subject. They are one program: it is linked once, and
//! its tests run in parallel.

mod batch;
mod code_as_data;
mod common;
mod evaluators;
mod generated_flank;
mod graphs;
mod host;
mod implicit;
mod kinematics;
mod object;
mod sources;
mod tapes;
mod workloads;
