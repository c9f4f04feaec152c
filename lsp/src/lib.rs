//! Language server for Calyx models.
//!
//! The crate has two layers. [`ide`] answers queries about one snapshot of the texts, in byte
//! offsets and plain data; it is independent of the protocol, does no I/O, and cannot fail.
//! [`server`] implements the Language Server Protocol: it applies edits in order of arrival, passes
//! each request the snapshot of its arrival, and converts answers to messages.

pub mod ide;
pub mod server;
