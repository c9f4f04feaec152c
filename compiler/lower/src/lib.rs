//! From the typed program to what runs: kernels of symbolic expressions, and the interpreter.

pub mod interpret;
pub mod kernels;
pub mod layout;
pub mod link;
pub mod nan;
pub mod operations;
pub mod traverse;
