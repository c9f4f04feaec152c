//! Lowers the typed program: kernels of symbolic expressions, and an interpreter.

pub mod fingerprint;
pub mod interpret;
pub mod kernels;
pub mod layout;
pub mod link;
pub mod nan;
pub mod operations;
pub mod recently_used;
pub mod repeatable;
pub mod traverse;
