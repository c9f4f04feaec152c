//! Formatting of a document, of a range, and on typing.

use crate::ide::formatting::{Change, format_file, format_selection};
use crate::ide::on_type_formatting::{TRIGGERS, typed};
use crate::ide::source::Source;
use crate::server::router::Router;
use crate::server::view::View;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::{Formatting, OnTypeFormatting, RangeFormatting};
use tower_lsp_server::ls_types::{
    DocumentFormattingParams, DocumentOnTypeFormattingOptions, DocumentOnTypeFormattingParams,
    DocumentRangeFormattingParams, OneOf, ServerCapabilities, TextEdit,
};

pub fn offer(capabilities: &mut ServerCapabilities) {
    capabilities.document_formatting_provider = Some(OneOf::Left(true));
    capabilities.document_range_formatting_provider = Some(OneOf::Left(true));
    let [first, more @ ..] = TRIGGERS.map(String::from);
    capabilities.document_on_type_formatting_provider = Some(DocumentOnTypeFormattingOptions {
        first_trigger_character: first,
        more_trigger_character: Some(more.to_vec()),
    });
}

pub fn route(router: &mut Router) {
    router.on::<Formatting>(document);
    router.on::<RangeFormatting>(range);
    router.on::<OnTypeFormatting>(on_type);
}

/// Formats a document. A text with syntax errors remains unchanged: its diagnostics explain them.
fn document(view: &View, _: DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    Ok(Some(edits(view, &format_file(&source))))
}

fn range(view: &View, params: DocumentRangeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let Some(selection) = view.bytes(&view.file, params.range) else { return Ok(None) };
    Ok(Some(edits(view, &format_selection(&source, selection))))
}

fn on_type(view: &View, params: DocumentOnTypeFormattingParams) -> Result<Option<Vec<TextEdit>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let Some(position) = view.position(&params.text_document_position) else { return Ok(None) };
    // Some clients send a carriage return with the line feed.
    let Some(character) = params.ch.chars().next_back() else { return Ok(None) };
    Ok(Some(edits(view, &typed(&source, position.offset, character))))
}

fn edits(view: &View, changes: &[Change]) -> Vec<TextEdit> {
    let edit = |change: &Change| {
        let range = view.range(&view.file, change.start..change.end)?;
        Some(TextEdit { range, new_text: change.replacement.clone() })
    };
    changes.iter().filter_map(edit).collect()
}
