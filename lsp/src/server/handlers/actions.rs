//! Quick fixes and rewrites.

use crate::ide::actions::{Action, ActionKind, actions, fix_all};
use crate::server::router::Router;
use crate::server::view::View;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::CodeActionRequest;
use tower_lsp_server::ls_types::{
    CodeAction, CodeActionKind, CodeActionOptions, CodeActionOrCommand, CodeActionParams,
    CodeActionProviderCapability, Diagnostic, NumberOrString, ServerCapabilities,
};

pub fn offer(capabilities: &mut ServerCapabilities) {
    let kinds = [
        ActionKind::QuickFix,
        ActionKind::Rewrite,
        ActionKind::Extract,
        ActionKind::Inline,
        ActionKind::FixAll,
    ];
    let options =
        CodeActionOptions { code_action_kinds: Some(kinds.map(kind).into()), ..CodeActionOptions::default() };
    capabilities.code_action_provider = Some(CodeActionProviderCapability::Options(options));
}

pub fn route(router: &mut Router) {
    router.on::<CodeActionRequest>(code_actions);
}

fn kind(of: ActionKind) -> CodeActionKind {
    match of {
        ActionKind::QuickFix => CodeActionKind::QUICKFIX,
        ActionKind::Rewrite => CodeActionKind::REFACTOR_REWRITE,
        ActionKind::Extract => CodeActionKind::REFACTOR_EXTRACT,
        ActionKind::Inline => CodeActionKind::REFACTOR_INLINE,
        ActionKind::FixAll => CodeActionKind::SOURCE_FIX_ALL,
    }
}

fn code_actions(view: &View, params: CodeActionParams) -> Result<Option<Vec<CodeActionOrCommand>>> {
    let Some(range) = view.bytes(&view.file, params.range) else { return Ok(None) };
    // A kind includes its subkinds: `refactor` includes `refactor.extract`.
    let wanted = |action: &Action| {
        let own = kind(action.kind);
        params.context.only.as_ref().is_none_or(|only| {
            only.iter().any(|only| {
                own.as_str()
                    .strip_prefix(only.as_str())
                    .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            })
        })
    };
    let mut found = actions(&view.snapshot, &view.file, range);
    // Actions on a whole file are returned on request only.
    if params.context.only.is_some() {
        found.extend(fix_all(&view.snapshot, &view.file));
    }
    let each = found.iter().filter(|action| wanted(action));
    Ok(Some(each.map(|action| code_action(view, action, &params.context.diagnostics)).collect()))
}

fn code_action(view: &View, action: &Action, shown: &[Diagnostic]) -> CodeActionOrCommand {
    let fixed = action.resolves.as_ref().and_then(|(code, range)| {
        let range = view.range(&view.file, range.clone())?;
        let same = |diagnostic: &&Diagnostic| {
            diagnostic.range == range && diagnostic.code == Some(NumberOrString::String(code.clone()))
        };
        shown.iter().find(same).cloned()
    });
    CodeActionOrCommand::CodeAction(CodeAction {
        title: action.title.clone(),
        kind: Some(kind(action.kind)),
        diagnostics: fixed.map(|diagnostic| vec![diagnostic]),
        edit: Some(view.workspace_edit(&action.edits)),
        is_preferred: action.preferred.then_some(true),
        ..CodeAction::default()
    })
}
