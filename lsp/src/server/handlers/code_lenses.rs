//! Code lenses: actions above a declaration.

use crate::ide::code_lenses::{self, Lens, lenses, uses};
use crate::ide::source::Source;
use crate::server::commands::{PLAN, RUN, TEST};
use crate::server::router::Router;
use crate::server::view::View;
use calyx_lang::analysis::SourceRange;
use serde_json::{Value, json};
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::{CodeLensRequest, CodeLensResolve};
use tower_lsp_server::ls_types::{CodeLens, CodeLensOptions, CodeLensParams, Command, ServerCapabilities};

pub fn offer(capabilities: &mut ServerCapabilities) {
    capabilities.code_lens_provider = Some(CodeLensOptions { resolve_provider: Some(true) });
}

pub fn route(router: &mut Router) {
    router.on::<CodeLensRequest>(of_document);
    router.on::<CodeLensResolve>(resolve);
}

fn of_document(view: &View, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
    let Some(source) = Source::of(&view.snapshot, &view.file) else { return Ok(None) };
    let uri = params.text_document.uri;
    let convert = |lens: code_lenses::CodeLens| {
        let range = view.range(&view.file, lens.start..lens.end)?;
        let command = |title: &str, command: &str, arguments: Vec<Value>| {
            Some(Command { title: title.into(), command: command.into(), arguments: Some(arguments) })
        };
        let (command, data) = match lens.lens {
            Lens::Run => (command("▶ Run", RUN, vec![json!(uri)]), None),
            Lens::ExplainPlan => (command("Explain plan", PLAN, vec![json!(uri)]), None),
            Lens::RunTest(name) => (command("▶ Run test", TEST, vec![json!(uri), json!(name)]), None),
            // The count is computed when the lens is resolved.
            Lens::Uses(place) => (None, Some(json!({ "uri": uri, "start": place.start, "end": place.end }))),
        };
        Some(CodeLens { range, command, data })
    };
    Ok(Some(lenses(&source, &view.file).into_iter().filter_map(convert).collect()))
}

/// Resolves the number of uses of a declaration.
fn resolve(view: &View, lens: CodeLens) -> Result<CodeLens> {
    let offset = |key| lens.data.as_ref()?.get(key)?.as_u64().map(|offset| offset as u32);
    let (Some(start), Some(end)) = (offset("start"), offset("end")) else { return Ok(lens) };
    let count = uses(&view.snapshot, &SourceRange { file: view.file.clone(), start, end }).len();
    let title = match count {
        0 => "not used".to_string(),
        1 => "1 use".to_string(),
        several => format!("{several} uses"),
    };
    // The command to show references is client-specific and not available everywhere.
    let command = Some(Command { title, command: String::new(), arguments: None });
    Ok(CodeLens { command, data: None, ..lens })
}
