//! The server as clients see it: messages over in-memory pipes.
//!
//! The real command over its standard streams is tested with the command, in
//! `compiler/tests/lsp.rs`.

mod cancellation;
mod client;
mod commands;
mod diagnostics;
mod edits;
mod fuzz;
mod library;
mod life_cycle;
mod malformed;
mod navigation;
mod structure;
mod workspace;
