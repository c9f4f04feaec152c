//! Answers to requests, one file a group of features.
//!
//! A handler finds its place with [`View`](super::view::View)'s conversions, asks [`ide`](crate::ide), and converts what
//! it says. A new group has a file here with a function `offer`, which says what it can, and a function `route`, which connects methods
//! with functions; both are called below.

mod actions;
mod call_hierarchy;
mod code_lenses;
mod completion;
mod formatting;
mod inlay_hints;
mod navigation;
mod semantic_tokens;
mod structure;

use super::client::Client;
use super::router::Router;
use tower_lsp_server::ls_types::ServerCapabilities;

/// Says what is offered.
pub fn offer(client: &Client, capabilities: &mut ServerCapabilities) {
    actions::offer(capabilities);
    completion::offer(client, capabilities);
    formatting::offer(capabilities);
    call_hierarchy::offer(capabilities);
    code_lenses::offer(capabilities);
    inlay_hints::offer(capabilities);
    navigation::offer(client, capabilities);
    semantic_tokens::offer(capabilities);
    structure::offer(capabilities);
}

/// The requests that are answered.
pub fn router() -> Router {
    let mut router = Router::default();
    actions::route(&mut router);
    completion::route(&mut router);
    formatting::route(&mut router);
    call_hierarchy::route(&mut router);
    code_lenses::route(&mut router);
    inlay_hints::route(&mut router);
    navigation::route(&mut router);
    semantic_tokens::route(&mut router);
    structure::route(&mut router);
    router
}
