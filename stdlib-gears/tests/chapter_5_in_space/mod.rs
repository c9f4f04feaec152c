//! The chapter 5 pair in space, contact on the nominal path only unless tips are the subject: against independent models, against the report's tables, against the
//! plane, against its own refinement, and far from where it was published.

mod extremes;
mod independent;
mod matching_depth;
pub mod pair;
mod tables;
mod tips;
