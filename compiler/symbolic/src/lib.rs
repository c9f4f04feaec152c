//! Symbolic expressions: hash-consed graph, simplification at construction, derivatives, frames, kernels.

pub mod tape;
