//! Request handlers, one file per group of features.
//!
//! A handler converts positions with [`View`](super::view::View), queries [`ide`](crate::ide), and
//! converts the result. Each file has a function `offer`, which sets the capabilities, and a
//! function `route`, which registers the handlers; both are called below.

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

/// Sets the capabilities of all handlers.
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

/// Returns the router with all handlers.
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
