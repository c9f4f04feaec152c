//! Tests of symbolic expressions, one module per subject. They are one program: it is linked once,
//! and its tests run in parallel.

mod derivatives;
mod frames;
mod graph;
mod implicit;
mod long_chain;
mod planet;
mod schedules;
mod simplification;
mod support;
mod trace;
