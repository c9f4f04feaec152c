//! Semantic tokens: of a document, of a range, and as a difference from the previous answer.

use crate::ide::semantic_tokens::{Difference, KINDS, MODIFIERS, difference, tokens};
use crate::ide::source::Source;
use crate::server::router::Router;
use crate::server::view::View;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::{
    SemanticTokensFullDeltaRequest, SemanticTokensFullRequest, SemanticTokensRangeRequest,
};
use tower_lsp_server::ls_types::{
    SemanticToken, SemanticTokenModifier, SemanticTokenType, SemanticTokens, SemanticTokensDelta,
    SemanticTokensDeltaParams, SemanticTokensEdit, SemanticTokensFullDeltaResult, SemanticTokensFullOptions,
    SemanticTokensLegend, SemanticTokensOptions, SemanticTokensParams, SemanticTokensRangeParams,
    SemanticTokensRangeResult, SemanticTokensResult, ServerCapabilities, Uri,
};

pub fn offer(capabilities: &mut ServerCapabilities) {
    let options = SemanticTokensOptions {
        legend: SemanticTokensLegend {
            token_types: KINDS.iter().map(|kind| SemanticTokenType::new(kind)).collect(),
            token_modifiers: MODIFIERS.iter().map(|name| SemanticTokenModifier::new(name)).collect(),
        },
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Delta { delta: Some(true) }),
        ..SemanticTokensOptions::default()
    };
    capabilities.semantic_tokens_provider = Some(options.into());
}

pub fn route(router: &mut Router) {
    let sent = Arc::new(SentTokens::default());
    let known = sent.clone();
    router.on::<SemanticTokensFullRequest>(move |view, params| full(&known, view, &params));
    router.on::<SemanticTokensFullDeltaRequest>(move |view, params| delta(&sent, view, &params));
    router.on::<SemanticTokensRangeRequest>(range);
}

/// Last answer for each open document.
#[derive(Default)]
struct SentTokens(Mutex<Answers>);

#[derive(Default)]
struct Answers {
    count: u64,
    last: HashMap<Uri, (String, Vec<SemanticToken>)>,
}

impl SentTokens {
    /// Stores an answer under a new id, and drops those of closed documents.
    fn keep(&self, view: &View, uri: &Uri, data: Vec<SemanticToken>) -> String {
        let mut answers = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        answers.count += 1;
        let id = answers.count.to_string();
        answers.last.retain(|uri, _| view.documents.contains_key(uri));
        answers.last.insert(uri.clone(), (id.clone(), data));
        id
    }

    /// Takes the answer with an id.
    fn take(&self, uri: &Uri, id: &str) -> Option<Vec<SemanticToken>> {
        let mut answers = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let known = answers.last.get(uri).is_some_and(|(known, _)| known == id);
        let (_, data) = if known { answers.last.remove(uri)? } else { return None };
        Some(data)
    }
}

fn full(
    sent: &SentTokens,
    view: &View,
    params: &SemanticTokensParams,
) -> Result<Option<SemanticTokensResult>> {
    let Some(data) = whole(view) else { return Ok(None) };
    let result_id = Some(sent.keep(view, &params.text_document.uri, data.clone()));
    Ok(Some(SemanticTokens { result_id, data }.into()))
}

/// Returns the difference from an earlier answer, or all tokens if that is unknown.
fn delta(
    sent: &SentTokens,
    view: &View,
    params: &SemanticTokensDeltaParams,
) -> Result<Option<SemanticTokensFullDeltaResult>> {
    let Some(data) = whole(view) else { return Ok(None) };
    let uri = &params.text_document.uri;
    let before = sent.take(uri, &params.previous_result_id);
    let result_id = Some(sent.keep(view, uri, data.clone()));
    let Some(before) = before else { return Ok(Some(SemanticTokens { result_id, data }.into())) };
    // Numbers per token in the encoding of the protocol.
    const NUMBERS: u32 = 5;
    let edit = |change: Difference<SemanticToken>| SemanticTokensEdit {
        start: NUMBERS * change.start as u32,
        delete_count: NUMBERS * change.removed as u32,
        data: Some(change.inserted),
    };
    let edits = difference(&before, &data).map(edit).into_iter().collect();
    Ok(Some(SemanticTokensDelta { result_id, edits }.into()))
}

fn range(view: &View, params: SemanticTokensRangeParams) -> Result<Option<SemanticTokensRangeResult>> {
    let Some(range) = view.bytes(&view.file, params.range) else { return Ok(None) };
    let data = encoded(view, range);
    Ok(data.map(|data| SemanticTokens { result_id: None, data }.into()))
}

fn whole(view: &View) -> Option<Vec<SemanticToken>> {
    encoded(view, 0..view.file(&view.file)?.text.len())
}

/// Encodes the tokens of a range, each relative to the previous one.
fn encoded(view: &View, range: Range<u32>) -> Option<Vec<SemanticToken>> {
    let source = Source::of(&view.snapshot, &view.file)?;
    let names = view.snapshot.database.names_in(&view.file, range.clone());
    let (mut line, mut character) = (0, 0);
    let encode = |token: crate::ide::semantic_tokens::SemanticToken| {
        let place = view.range(&view.file, token.start..token.end)?;
        let delta_line = place.start.line.saturating_sub(line);
        let from = if delta_line == 0 { character } else { 0 };
        (line, character) = (place.start.line, place.start.character);
        Some(SemanticToken {
            delta_line,
            delta_start: place.start.character.saturating_sub(from),
            length: place.end.character.saturating_sub(place.start.character),
            token_type: token.kind as u32,
            token_modifiers_bitset: token.modifiers.0,
        })
    };
    Some(tokens(&source, &names, range).into_iter().filter_map(encode).collect())
}
