//! Authoring Calyx models in an editor.
//!
//! Two layers. [`ide`] answers questions about one snapshot of the texts, in byte offsets and plain data; it knows no
//! protocol, does no input or output, and cannot fail. [`server`] speaks the Language Server Protocol: it applies edits in the order they
//! arrive, hands each request the snapshot it was asked about, and turns answers into messages.

pub mod ide;
pub mod server;
