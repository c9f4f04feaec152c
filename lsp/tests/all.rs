//! Tests of the language server, one module per subject. They are one program: it is linked once,
//! and its tests run in parallel.

mod actions;
mod completion;
mod navigate;
mod protocol;
mod structure;
mod support;
