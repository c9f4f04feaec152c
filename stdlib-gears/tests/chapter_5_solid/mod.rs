//! The chapter 5 pair in three dimensions, with contact on the nominal path only except in tests of
//! tip edges: compared with independent models, the report's tables, the plane model and its own
//! refinement, and far from its published parameters.

mod extremes;
mod independent;
mod matching_depth;
pub mod pair;
mod tables;
mod tips;
