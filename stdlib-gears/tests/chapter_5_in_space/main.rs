//! The chapter 5 pair in space, contact on the nominal path only: against independent models, against the report's tables, against the
//! plane, and against its own refinement.

#[path = "../common/mod.rs"]
mod common;

mod independent;
mod pair;
mod tables;
