//! Requests about the structure of a file: document symbols (the outline), workspace symbols,
//! folding ranges, selection ranges and document links.
//!
//! The modules of `ide` compute the answers as byte offsets. This module converts them to the types
//! of the protocol. Symbols, folds and links without a position in the client's text are omitted.

use crate::ide::document_links::links;
use crate::ide::folding::{FoldKind, folds};
use crate::ide::selection::selections;
use crate::ide::source::Source;
use crate::ide::symbols::{Symbol, SymbolKind, find, symbols, types};
use crate::server::client::Client;
use crate::server::router::Router;
use crate::server::view::View;
use std::collections::HashMap;
use std::sync::Arc;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::{
    DocumentLinkRequest, DocumentSymbolRequest, FoldingRangeRequest, SelectionRangeRequest,
    WorkspaceSymbolRequest,
};
use tower_lsp_server::ls_types::{
    self, DocumentLink, DocumentLinkOptions, DocumentLinkParams, DocumentSymbol, DocumentSymbolParams,
    DocumentSymbolResponse, FoldingRange, FoldingRangeKind, FoldingRangeParams,
    FoldingRangeProviderCapability, Location, OneOf, SelectionRange, SelectionRangeParams,
    SelectionRangeProviderCapability, ServerCapabilities, SymbolInformation, WorkspaceSymbol,
    WorkspaceSymbolParams, WorkspaceSymbolResponse,
};

/// Adds the capabilities for these requests.
pub fn offer(capabilities: &mut ServerCapabilities) {
    capabilities.document_symbol_provider = Some(OneOf::Left(true));
    capabilities.workspace_symbol_provider = Some(OneOf::Left(true));
    capabilities.folding_range_provider = Some(FoldingRangeProviderCapability::Simple(true));
    capabilities.selection_range_provider = Some(SelectionRangeProviderCapability::Simple(true));
    capabilities.document_link_provider =
        Some(DocumentLinkOptions { resolve_provider: None, work_done_progress_options: Default::default() });
}

/// Registers the handlers of these requests.
pub fn route(router: &mut Router) {
    router.on::<DocumentSymbolRequest>(outline);
    router.on_all::<WorkspaceSymbolRequest>(search);
    router.on::<FoldingRangeRequest>(folding);
    router.on::<SelectionRangeRequest>(selection);
    router.on::<DocumentLinkRequest>(document_links);
}

/// Converts the kind of a symbol. The protocol has no kinds for params, outputs, dimensions and
/// units; their kinds are chosen by the icons of editors.
pub(super) fn symbol_kind(kind: SymbolKind) -> ls_types::SymbolKind {
    match kind {
        SymbolKind::Param => ls_types::SymbolKind::PROPERTY,
        SymbolKind::Output => ls_types::SymbolKind::EVENT,
        SymbolKind::Constant => ls_types::SymbolKind::CONSTANT,
        SymbolKind::Variable | SymbolKind::Symbolic => ls_types::SymbolKind::VARIABLE,
        SymbolKind::Function => ls_types::SymbolKind::FUNCTION,
        SymbolKind::Test => ls_types::SymbolKind::METHOD,
        SymbolKind::Record => ls_types::SymbolKind::STRUCT,
        SymbolKind::Field => ls_types::SymbolKind::FIELD,
        SymbolKind::Dimension => ls_types::SymbolKind::CLASS,
        SymbolKind::Unit => ls_types::SymbolKind::ENUM_MEMBER,
    }
}

/// Returns true if the client shows nested symbols.
fn nests(client: &Client) -> bool {
    let document = client.capabilities.text_document.as_ref();
    let symbols = document.and_then(|document| document.document_symbol.as_ref());
    symbols.and_then(|symbols| symbols.hierarchical_document_symbol_support).unwrap_or(false)
}

/// Returns the symbols of a file, nested if the client supports it.
fn outline(view: &View, _: DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let names = view.snapshot.database.names(&view.file);
    let symbols = symbols(&source, &types(&names));
    if nests(&view.client) {
        return Ok(Some(DocumentSymbolResponse::Nested(nested(view, symbols))));
    }
    let mut flat = Vec::new();
    flatten(view, symbols, None, &mut flat);
    Ok(Some(DocumentSymbolResponse::Flat(flat)))
}

/// Converts symbols with their children.
fn nested(view: &View, symbols: Vec<Symbol>) -> Vec<DocumentSymbol> {
    let convert = |symbol: Symbol| {
        #[expect(deprecated, reason = "the protocol's struct has the field")]
        Some(DocumentSymbol {
            name: symbol.name,
            detail: symbol.detail,
            kind: symbol_kind(symbol.kind),
            tags: None,
            deprecated: None,
            range: view.range(&view.file, symbol.start..symbol.end)?,
            selection_range: view.range(&view.file, symbol.name_start..symbol.name_end)?,
            children: (!symbol.children.is_empty()).then(|| nested(view, symbol.children)),
        })
    };
    symbols.into_iter().filter_map(convert).collect()
}

/// Appends symbols and their children to a list, each with the name of the symbol that contains it.
fn flatten(view: &View, symbols: Vec<Symbol>, container: Option<&str>, flat: &mut Vec<SymbolInformation>) {
    for symbol in symbols {
        let Some(location) = view.location(&view.file, symbol.start..symbol.end) else { continue };
        #[expect(deprecated, reason = "the protocol's struct has the field")]
        flat.push(SymbolInformation {
            name: symbol.name.clone(),
            kind: symbol_kind(symbol.kind),
            tags: None,
            deprecated: None,
            location,
            container_name: container.map(str::to_string),
        });
        flatten(view, symbol.children, Some(&symbol.name), flat);
    }
}

/// Returns the symbols of all projects whose names match a query.
fn search(views: &[View], params: WorkspaceSymbolParams) -> Result<Option<WorkspaceSymbolResponse>> {
    // A file that several projects share, such as those of the library, is searched once.
    let mut files: HashMap<Arc<str>, (&View, Source<'_>)> = HashMap::new();
    for view in views {
        for name in view.files.keys() {
            if let Some(source) = Source::of(&view.snapshot, name) {
                files.entry(name.clone()).or_insert((view, source));
            }
        }
    }
    let found = find(&params.query, files.iter().map(|(name, (_, source))| (name.clone(), source)));
    let convert = |one: crate::ide::symbols::Found| {
        let (view, _) = files.get(&one.file)?;
        let Location { uri, range } = view.location(&one.file, one.symbol.name_start..one.symbol.name_end)?;
        let library = one.library.then(|| "library".to_string());
        Some(WorkspaceSymbol {
            name: one.symbol.name,
            kind: symbol_kind(one.symbol.kind),
            tags: None,
            container_name: one.container.or(library),
            location: OneOf::Left(Location { uri, range }),
            data: None,
        })
    };
    Ok(Some(WorkspaceSymbolResponse::Nested(found.into_iter().filter_map(convert).collect())))
}

/// Returns the ranges that an editor can fold.
fn folding(view: &View, _: FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let convert = |fold: crate::ide::folding::Fold| {
        let range = view.range(&view.file, fold.start..fold.end)?;
        Some(FoldingRange {
            start_line: range.start.line,
            start_character: Some(range.start.character),
            end_line: range.end.line,
            end_character: Some(range.end.character),
            kind: match fold.kind {
                FoldKind::Code => None,
                FoldKind::Comment => Some(FoldingRangeKind::Comment),
                FoldKind::Imports => Some(FoldingRangeKind::Imports),
            },
            collapsed_text: None,
        })
    };
    Ok(Some(folds(&source).into_iter().filter_map(convert).collect()))
}

/// Returns for each position the ranges that an editor selects one after the other, each around the
/// previous one.
fn selection(view: &View, params: SelectionRangeParams) -> Result<Option<Vec<SelectionRange>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let mut ranges = Vec::new();
    for position in params.positions {
        let Some(offset) = view.offset(&view.file, position) else { return Ok(None) };
        let mut around: Option<Box<SelectionRange>> = None;
        for (start, end) in selections(&source, offset).into_iter().rev() {
            let Some(range) = view.range(&view.file, start..end) else { continue };
            around = Some(Box::new(SelectionRange { range, parent: around }));
        }
        // Every position requires an answer; the range of the file always exists.
        ranges.push(around.map_or_else(SelectionRange::default, |range| *range));
    }
    Ok(Some(ranges))
}

/// Returns the links from names of modules and tables to their files.
fn document_links(view: &View, _: DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let convert = |link: crate::ide::document_links::Link| {
        Some(DocumentLink {
            range: view.range(&view.file, link.start..link.end)?,
            target: Some(view.uri(&link.file)?),
            tooltip: Some(format!("open `{}`", link.file)),
            data: None,
        })
    };
    Ok(Some(links(&view.snapshot, &source).into_iter().filter_map(convert).collect()))
}
