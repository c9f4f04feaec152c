//! Laying out texts.

use crate::server::router::Router;
use crate::server::view::View;
use calyx_lang::format::format;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::Formatting;
use tower_lsp_server::ls_types::{DocumentFormattingParams, OneOf, ServerCapabilities, TextEdit};

pub fn offer(capabilities: &mut ServerCapabilities) {
    capabilities.document_formatting_provider = Some(OneOf::Left(true));
}

pub fn route(router: &mut Router) {
    router.on::<Formatting>(document);
}

/// A text with errors of syntax is left as it is: its diagnostics say why.
fn document(view: &View, _: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
    let Some(file) = view.file(&view.file) else { return Ok(None) };
    let Ok(formatted) = format(file.text.content()) else { return Ok(None) };
    if *formatted == **file.text.content() {
        return Ok(Some(Vec::new()));
    }
    let range = view.range(&view.file, 0..file.text.len());
    Ok(range.map(|range| vec![TextEdit { range, new_text: formatted }]))
}
