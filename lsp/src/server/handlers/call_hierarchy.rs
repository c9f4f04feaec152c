//! Call hierarchy: callers and callees of a function.

use crate::ide::call_hierarchy::{Calls, Item, incoming, outgoing, prepare};
use crate::server::router::Router;
use crate::server::view::View;
use calyx_lang::analysis::SourceRange;
use serde_json::{Value, json};
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::{
    CallHierarchyIncomingCalls, CallHierarchyOutgoingCalls, CallHierarchyPrepare,
};
use tower_lsp_server::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem,
    CallHierarchyOutgoingCall, CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams,
    CallHierarchyServerCapability, Range, ServerCapabilities, SymbolKind, Uri,
};

pub fn offer(capabilities: &mut ServerCapabilities) {
    capabilities.call_hierarchy_provider = Some(CallHierarchyServerCapability::Simple(true));
}

pub fn route(router: &mut Router) {
    router.on::<CallHierarchyPrepare>(at_cursor);
    router.on::<CallHierarchyIncomingCalls>(callers);
    router.on::<CallHierarchyOutgoingCalls>(callees);
}

fn at_cursor(view: &View, params: CallHierarchyPrepareParams) -> Result<Option<Vec<CallHierarchyItem>>> {
    let asked = &params.text_document_position_params;
    let Some(position) = view.position(asked) else { return Ok(None) };
    let item = prepare(&view.snapshot, &position);
    Ok(item.and_then(|item| shown(view, &item, &asked.text_document.uri)).map(|item| vec![item]))
}

fn callers(
    view: &View,
    params: CallHierarchyIncomingCallsParams,
) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
    let Some((place, asked)) = meant(&params.item) else { return Ok(None) };
    let convert = |calls: Calls| {
        let from_ranges = ranges(view, &calls.item.place.file, &calls);
        Some(CallHierarchyIncomingCall { from: shown(view, &calls.item, &asked)?, from_ranges })
    };
    Ok(Some(incoming(&view.snapshot, &place).into_iter().filter_map(convert).collect()))
}

fn callees(
    view: &View,
    params: CallHierarchyOutgoingCallsParams,
) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
    let Some((place, asked)) = meant(&params.item) else { return Ok(None) };
    let convert = |calls: Calls| {
        let from_ranges = ranges(view, &place.file, &calls);
        Some(CallHierarchyOutgoingCall { to: shown(view, &calls.item, &asked)?, from_ranges })
    };
    Ok(Some(outgoing(&view.snapshot, &place).into_iter().filter_map(convert).collect()))
}

fn ranges(view: &View, file: &str, calls: &Calls) -> Vec<Range> {
    calls.ranges.iter().filter_map(|(start, end)| view.range(file, *start..*end)).collect()
}

/// Converts an item. Its data has its position and the document of the initial request, because a
/// library file need not be open.
fn shown(view: &View, item: &Item, asked: &Uri) -> Option<CallHierarchyItem> {
    let SourceRange { file, start, end } = &item.place;
    Some(CallHierarchyItem {
        name: item.name.clone(),
        kind: if item.kind.is_some() { SymbolKind::FUNCTION } else { SymbolKind::FILE },
        tags: None,
        detail: item.detail.as_ref().map(ToString::to_string),
        uri: view.uri(file)?,
        range: view.range(file, item.start..item.end)?,
        selection_range: view.range(file, *start..*end)?,
        data: Some(json!({ "uri": asked, "file": **file, "start": start, "end": end })),
    })
}

/// Returns the position of an item from a client, and the document of the initial request.
fn meant(item: &CallHierarchyItem) -> Option<(SourceRange, Uri)> {
    let data = item.data.as_ref()?;
    let offset = |key| data.get(key).and_then(Value::as_u64).map(|offset| offset as u32);
    let place = SourceRange {
        file: data.get("file")?.as_str()?.into(),
        start: offset("start")?,
        end: offset("end")?,
    };
    Some((place, data.get("uri")?.as_str()?.parse().ok()?))
}
