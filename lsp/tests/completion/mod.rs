//! Completion and signature help. One test binary, because linking takes longer than testing.

mod context;
mod items;
mod signature;
