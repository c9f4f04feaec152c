//! Navigation: hover, declarations, references and rename.

use crate::ide::definition::{Definition, definition, type_definition};
use crate::ide::hover::hover;
use crate::ide::references::{highlight, references};
use crate::ide::rename::{Refusal, prepare, rename};
use crate::server::client::Client;
use crate::server::router::Router;
use crate::server::view::View;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp_server::ls_types::request::{
    DocumentHighlightRequest, GotoDeclaration, GotoDefinition, GotoTypeDefinition, HoverRequest,
    PrepareRenameRequest, References, Rename,
};
use tower_lsp_server::ls_types::{
    DeclarationCapability, DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams,
    GotoDefinitionParams, GotoDefinitionResponse, Hover, HoverContents, HoverParams, HoverProviderCapability,
    Location, LocationLink, MarkupContent, MarkupKind, OneOf, PrepareRenameResponse, ReferenceParams,
    RenameOptions, RenameParams, ServerCapabilities, TextDocumentPositionParams,
    TypeDefinitionProviderCapability, WorkDoneProgressOptions, WorkspaceEdit,
};

pub fn offer(client: &Client, capabilities: &mut ServerCapabilities) {
    let rename = client.capabilities.text_document.as_ref().and_then(|document| document.rename.as_ref());
    let prepares = rename.and_then(|rename| rename.prepare_support).unwrap_or(false);
    let renaming = RenameOptions {
        prepare_provider: Some(true),
        work_done_progress_options: WorkDoneProgressOptions::default(),
    };
    capabilities.hover_provider = Some(HoverProviderCapability::Simple(true));
    capabilities.definition_provider = Some(OneOf::Left(true));
    capabilities.declaration_provider = Some(DeclarationCapability::Simple(true));
    capabilities.type_definition_provider = Some(TypeDefinitionProviderCapability::Simple(true));
    capabilities.references_provider = Some(OneOf::Left(true));
    capabilities.document_highlight_provider = Some(OneOf::Left(true));
    capabilities.rename_provider = Some(if prepares { OneOf::Right(renaming) } else { OneOf::Left(true) });
}

pub fn route(router: &mut Router) {
    router.on::<HoverRequest>(hovered);
    router.on::<GotoDefinition>(|view, params| Ok(defined(view, &params, definition_at)));
    // A name has one declaration, which is its definition.
    router.on::<GotoDeclaration>(|view, params| Ok(defined(view, &params, definition_at)));
    router.on::<GotoTypeDefinition>(|view, params| Ok(defined(view, &params, type_at)));
    router.on::<References>(referred);
    router.on::<DocumentHighlightRequest>(highlighted);
    router.on::<PrepareRenameRequest>(prepared);
    router.on::<Rename>(renamed);
}

fn hovered(view: &View, params: HoverParams) -> Result<Option<Hover>> {
    let Some(at) = view.position(&params.text_document_position_params) else { return Ok(None) };
    let Some(found) = hover(&view.snapshot, &at) else { return Ok(None) };
    let document = view.client.capabilities.text_document.as_ref();
    let formats = document.and_then(|document| document.hover.as_ref()?.content_format.as_ref());
    let markdown = formats.is_none_or(|formats| formats.contains(&MarkupKind::Markdown));
    let kind = if markdown { MarkupKind::Markdown } else { MarkupKind::PlainText };
    let value = if markdown { found.markdown } else { plain(&found.markdown) };
    Ok(Some(Hover {
        contents: HoverContents::Markup(MarkupContent { kind, value }),
        range: view.range(&at.file, found.range),
    }))
}

/// Converts the Markdown of hover texts to plain text.
fn plain(markdown: &str) -> String {
    let lines = markdown.lines().filter(|line| !line.starts_with("```"));
    lines.map(|line| line.replace('`', "")).collect::<Vec<_>>().join("\n")
}

fn definition_at(view: &View, at: &TextDocumentPositionParams) -> Option<Definition> {
    definition(&view.snapshot, &view.position(at)?)
}

fn type_at(view: &View, at: &TextDocumentPositionParams) -> Option<Definition> {
    type_definition(&view.snapshot, &view.position(at)?)
}

fn defined(
    view: &View,
    params: &GotoDefinitionParams,
    find: impl Fn(&View, &TextDocumentPositionParams) -> Option<Definition>,
) -> Option<GotoDefinitionResponse> {
    let at = &params.text_document_position_params;
    let found = find(view, at)?;
    let document = view.client.capabilities.text_document.as_ref();
    let links = document.and_then(|document| document.definition.as_ref()?.link_support).unwrap_or(false);
    let Location { uri, range } = view.location(&found.file, found.name)?;
    if !links {
        return Some(GotoDefinitionResponse::Scalar(Location { uri, range }));
    }
    let asked = view.name(&at.text_document.uri)?;
    Some(GotoDefinitionResponse::Link(vec![LocationLink {
        origin_selection_range: view.range(&asked, found.origin),
        target_uri: uri,
        target_range: view.range(&found.file, found.item)?,
        target_selection_range: range,
    }]))
}

fn referred(view: &View, params: ReferenceParams) -> Result<Option<Vec<Location>>> {
    let Some(at) = view.position(&params.text_document_position) else { return Ok(None) };
    let found = references(&view.snapshot, &at, params.context.include_declaration);
    let each = found.iter().filter_map(|of| view.location(&of.file, of.start..of.end));
    Ok(Some(each.collect()))
}

fn highlighted(view: &View, params: DocumentHighlightParams) -> Result<Option<Vec<DocumentHighlight>>> {
    let Some(at) = view.position(&params.text_document_position_params) else { return Ok(None) };
    let found = highlight(&view.snapshot, &at).into_iter();
    let each = found.filter_map(|mark| {
        let kind = mark.writes.map_or(DocumentHighlightKind::TEXT, |writes| match writes {
            true => DocumentHighlightKind::WRITE,
            false => DocumentHighlightKind::READ,
        });
        Some(DocumentHighlight { range: view.range(&at.file, mark.range)?, kind: Some(kind) })
    });
    Ok(Some(each.collect()))
}

/// Error code of the protocol for a valid request that cannot be fulfilled.
const REQUEST_FAILED: i64 = -32803;

fn refused(refusal: Refusal) -> Error {
    Error { code: ErrorCode::ServerError(REQUEST_FAILED), message: refusal.0.into(), data: None }
}

fn prepared(view: &View, params: TextDocumentPositionParams) -> Result<Option<PrepareRenameResponse>> {
    let Some(at) = view.position(&params) else { return Ok(None) };
    let (range, placeholder) = prepare(&view.snapshot, &at).map_err(refused)?;
    let range = view.range(&at.file, range);
    Ok(range.map(|range| PrepareRenameResponse::RangeWithPlaceholder { range, placeholder }))
}

fn renamed(view: &View, params: RenameParams) -> Result<Option<WorkspaceEdit>> {
    let Some(at) = view.position(&params.text_document_position) else { return Ok(None) };
    let edits = rename(&view.snapshot, &at, &params.new_name).map_err(refused)?;
    Ok(Some(view.workspace_edit(&edits)))
}
