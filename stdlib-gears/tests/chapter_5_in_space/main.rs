//! The chapter 5 pair in space, contact on the nominal path only unless tips are the subject: against independent models, against the report's tables, against the
//! plane, and against its own refinement.

#[path = "../common/mod.rs"]
mod common;

mod independent;
mod pair;
mod tables;
mod tips;
