//! Inlay hints.

use crate::ide::inlay_hints::{Hint, HintKind, HintSettings, OutputResult, Results, hints};
use crate::ide::source::Source;
use crate::server::router::Router;
use crate::server::view::View;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::InlayHintRequest;
use tower_lsp_server::ls_types::{
    InlayHint, InlayHintKind, InlayHintLabel, InlayHintLabelPart, InlayHintParams, InlayHintTooltip,
    MarkupContent, MarkupKind, OneOf, ServerCapabilities, TextEdit,
};

pub fn offer(capabilities: &mut ServerCapabilities) {
    capabilities.inlay_hint_provider = Some(OneOf::Left(true));
}

pub fn route(router: &mut Router) {
    router.on::<InlayHintRequest>(inlay_hints);
}

fn inlay_hints(view: &View, params: InlayHintParams) -> Result<Option<Vec<InlayHint>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let Some(range) = view.bytes(&view.file, params.range) else { return Ok(None) };
    let results = results(view, source.text);
    let found = hints(&view.snapshot, &source, &view.file, range, HintSettings::default(), &results);
    Ok(Some(found.into_iter().filter_map(|hint| convert(view, hint)).collect()))
}

/// Returns the results of the last run of the model.
fn results(view: &View, text: &str) -> Results {
    let Some(run) = view.run(&view.file) else { return Results::default() };
    let outputs = run.outputs.iter().map(|(name, output)| {
        let place = output.place_of_maximum().map(|place| format!("largest {place}"));
        let details: Vec<String> = place.into_iter().chain(output.error()).collect();
        let details = (!details.is_empty()).then(|| details.join("\n\n"));
        (name.clone(), OutputResult { shown: output.line(), details })
    });
    Results { outputs: outputs.collect(), outdated: !run.is_of(text) }
}

fn convert(view: &View, hint: Hint) -> Option<InlayHint> {
    let at = view.range(&view.file, hint.offset..hint.offset)?;
    let location = hint.declared.and_then(|place| view.location(&place.file, place.start..place.end));
    let label = match location {
        None => InlayHintLabel::String(hint.label),
        location => {
            let part = InlayHintLabelPart { value: hint.label, location, ..InlayHintLabelPart::default() };
            InlayHintLabel::LabelParts(vec![part])
        }
    };
    let text_edits = hint.change.and_then(|change| {
        let range = view.range(&view.file, change.start..change.end)?;
        Some(vec![TextEdit { range, new_text: change.replacement }])
    });
    let markdown = |value| InlayHintTooltip::from(MarkupContent { kind: MarkupKind::Markdown, value });
    Some(InlayHint {
        position: at.start,
        label,
        kind: match hint.kind {
            HintKind::Type => Some(InlayHintKind::TYPE),
            HintKind::Parameter => Some(InlayHintKind::PARAMETER),
            HintKind::Unit | HintKind::Result => None,
        },
        text_edits,
        tooltip: hint.tooltip.map(markdown),
        padding_left: Some(matches!(hint.kind, HintKind::Unit | HintKind::Result)),
        padding_right: Some(hint.kind == HintKind::Parameter),
        data: None,
    })
}
