//! What can be written at a cursor, and what is called around it. One program, as linking takes longer than testing.

mod context;
mod items;
mod signature;
#[path = "../support/mod.rs"]
mod support;
