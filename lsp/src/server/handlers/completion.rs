//! Completion and signature help.

use crate::ide::completion::{self, AfterInsert, Completions, Item, ItemKind, Subject};
use crate::ide::signature;
use crate::server::client::Client;
use crate::server::project::dotted;
use crate::server::router::Router;
use crate::server::view::View;
use calyx_lang::analysis::{NameKind, SourceRange};
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::request::{Completion, ResolveCompletionItem, SignatureHelpRequest};
use tower_lsp_server::ls_types::{
    Command, CompletionClientCapabilities, CompletionItem, CompletionItemKind, CompletionItemLabelDetails,
    CompletionList, CompletionOptions, CompletionOptionsCompletionItem, CompletionParams, CompletionResponse,
    CompletionTextEdit, Documentation, InsertTextFormat, InsertTextMode, MarkupContent, MarkupKind,
    ParameterInformation, ParameterLabel, ServerCapabilities, SignatureHelp, SignatureHelpOptions,
    SignatureHelpParams, SignatureInformation, TextEdit, Uri,
};

pub fn offer(_client: &Client, capabilities: &mut ServerCapabilities) {
    let texts = |characters: &[&str]| Some(characters.iter().map(|text| (*text).to_owned()).collect());
    capabilities.completion_provider = Some(CompletionOptions {
        resolve_provider: Some(true),
        trigger_characters: texts(completion::TRIGGERS),
        completion_item: Some(CompletionOptionsCompletionItem { label_details_support: Some(true) }),
        ..CompletionOptions::default()
    });
    capabilities.signature_help_provider = Some(SignatureHelpOptions {
        trigger_characters: texts(signature::TRIGGERS),
        retrigger_characters: texts(signature::RETRIGGERS),
        ..SignatureHelpOptions::default()
    });
}

pub fn route(router: &mut Router) {
    router.on::<Completion>(complete);
    router.on::<ResolveCompletionItem>(resolve);
    router.on::<SignatureHelpRequest>(signature_help);
}

fn complete(view: &View, params: CompletionParams) -> Result<Option<CompletionResponse>> {
    let Some(position) = view.position(&params.text_document_position) else { return Ok(None) };
    let typed = params.context.and_then(|context| context.trigger_character?.chars().next());
    let beside = || modules_beside(&position.file);
    let found = completion::complete(
        &view.snapshot,
        &position,
        &completion::CompletionTrigger { typed, beside: &beside },
    );
    let uri = &params.text_document_position.text_document.uri;
    Ok(list(view, uri, &position.file, found).map(CompletionResponse::List))
}

/// Returns the dotted paths of the importable files in the folder of a model and its subfolders.
fn modules_beside(file: &str) -> Vec<String> {
    /// Largest number of files listed in a folder.
    const MOST_FILES: usize = 200;
    let Some(folder) = Path::new(file).parent() else { return Vec::new() };
    let entries = |folder: &Path| {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        entries.take(MOST_FILES).map(|entry| entry.path()).collect::<Vec<_>>()
    };
    let here = entries(folder);
    let below: Vec<_> = here.iter().filter(|path| path.is_dir()).flat_map(|folder| entries(folder)).collect();
    let files = here.iter().chain(&below).filter(|path| {
        path.extension().is_some_and(|extension| extension == "cx") && path.as_path() != Path::new(file)
    });
    files.filter_map(|path| dotted(folder, path)).collect()
}

/// Relevant capabilities of the client.
struct ClientSupport {
    snippets: bool,
    label_details: bool,
    indents: bool,
    commit_characters: bool,
    /// Commands that the client accepts.
    commands: Vec<String>,
}

impl ClientSupport {
    fn by(client: &Client) -> ClientSupport {
        let document = client.capabilities.text_document.as_ref();
        let completion: Option<&CompletionClientCapabilities> =
            document.and_then(|document| document.completion.as_ref());
        let item = completion.and_then(|completion| completion.completion_item.as_ref());
        let modes = item.and_then(|item| item.insert_text_mode_support.as_ref());
        // As in rust-analyzer: the client lists its own commands.
        let experimental = client.capabilities.experimental.as_ref();
        let commands = experimental.and_then(|value| value.pointer("/commands/commands")?.as_array());
        ClientSupport {
            snippets: item.and_then(|item| item.snippet_support).unwrap_or(false),
            label_details: item.and_then(|item| item.label_details_support).unwrap_or(false),
            indents: modes.is_some_and(|modes| modes.value_set.contains(&InsertTextMode::ADJUST_INDENTATION)),
            commit_characters: item.and_then(|item| item.commit_characters_support).unwrap_or(false),
            commands: commands
                .into_iter()
                .flatten()
                .filter_map(|command| command.as_str().map(str::to_owned))
                .collect(),
        }
    }

    fn command(&self, then: AfterInsert) -> Option<Command> {
        let (command, title) = match then {
            AfterInsert::Nothing => return None,
            AfterInsert::Signature => ("editor.action.triggerParameterHints", "Show parameters"),
            AfterInsert::Completion => ("editor.action.triggerSuggest", "Show values"),
        };
        let known = self.commands.iter().any(|known| known == command);
        known.then(|| Command { title: title.to_owned(), command: command.to_owned(), arguments: None })
    }
}

fn list(view: &View, uri: &Uri, file: &str, found: Completions) -> Option<CompletionList> {
    let range = view.range(file, found.start..found.end)?;
    let shown = ClientSupport::by(&view.client);
    let items = found.items.into_iter().enumerate().map(|(place, item)| {
        let (new_text, snippet) = match (&item.insert.snippet, shown.snippets) {
            (Some(snippet), true) => (snippet.clone(), true),
            _ => (item.insert.plain.clone(), false),
        };
        let lines = new_text.contains('\n');
        let label_details = shown.label_details && !item.detail.is_empty();
        CompletionItem {
            kind: Some(kind(item.kind)),
            label_details: label_details
                .then(|| CompletionItemLabelDetails { detail: None, description: Some(item.detail.clone()) }),
            detail: (!item.detail.is_empty()).then(|| item.detail.clone()),
            sort_text: Some(format!("{place:04}")),
            filter_text: item.filter.clone(),
            insert_text_format: snippet.then_some(InsertTextFormat::SNIPPET),
            insert_text_mode: (lines && shown.indents).then_some(InsertTextMode::ADJUST_INDENTATION),
            text_edit: Some(CompletionTextEdit::Edit(TextEdit { range, new_text })),
            additional_text_edits: additional(view, file, &item),
            command: shown.command(item.then),
            commit_characters: commit_characters(item.kind).filter(|_| shown.commit_characters),
            data: item.subject.as_ref().and_then(|subject| Data::new(uri, subject).to_json()),
            label: item.label,
            ..CompletionItem::default()
        }
    });
    Some(CompletionList { is_incomplete: found.incomplete, items: items.collect() })
}

fn additional(view: &View, file: &str, item: &Item) -> Option<Vec<TextEdit>> {
    let import = item.import.clone()?;
    Some(view.text_edits(file, &[import]))
}

/// Returns the dot for modules, after which it is the only continuation; other items have no commit
/// characters.
fn commit_characters(kind: ItemKind) -> Option<Vec<String>> {
    (kind == ItemKind::Name(NameKind::Module)).then(|| vec![".".to_owned()])
}

fn kind(kind: ItemKind) -> CompletionItemKind {
    match kind {
        ItemKind::Name(name) => match name {
            NameKind::Variable | NameKind::Symbolic | NameKind::Parameter => CompletionItemKind::VARIABLE,
            NameKind::Param | NameKind::Output => CompletionItemKind::PROPERTY,
            NameKind::Function | NameKind::SymbolicFunction | NameKind::Extern | NameKind::Builtin => {
                CompletionItemKind::FUNCTION
            }
            NameKind::Const | NameKind::Constant => CompletionItemKind::CONSTANT,
            NameKind::Record | NameKind::Component => CompletionItemKind::STRUCT,
            NameKind::Enum => CompletionItemKind::ENUM,
            NameKind::Field => CompletionItemKind::FIELD,
            NameKind::Dimension => CompletionItemKind::CLASS,
            NameKind::Unit => CompletionItemKind::UNIT,
            NameKind::Module => CompletionItemKind::MODULE,
        },
        ItemKind::Keyword => CompletionItemKind::KEYWORD,
        ItemKind::Argument => CompletionItemKind::PROPERTY,
        ItemKind::Value => CompletionItemKind::ENUM_MEMBER,
        ItemKind::Unit => CompletionItemKind::UNIT,
        ItemKind::Type => CompletionItemKind::CLASS,
        ItemKind::Module => CompletionItemKind::MODULE,
        ItemKind::Label => CompletionItemKind::REFERENCE,
        ItemKind::Field => CompletionItemKind::FIELD,
    }
}

/// Subject of an item, stored in its data.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Data {
    /// Identifies the project.
    uri: Uri,
    about: About,
}

#[derive(Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum About {
    /// File, start, end.
    Place(String, u32, u32),
    /// File, start, end, and the parameter's name.
    Parameter(String, u32, u32, String),
    Builtin(String),
    Keyword(String),
    Unit(String),
}

impl Data {
    fn new(uri: &Uri, subject: &Subject) -> Data {
        let about = match subject.clone() {
            Subject::Declaration(SourceRange { file, start, end }) => {
                About::Place(file.to_string(), start, end)
            }
            Subject::Parameter(SourceRange { file, start, end }, name) => {
                About::Parameter(file.to_string(), start, end, name)
            }
            Subject::Builtin(name) => About::Builtin(name),
            Subject::Keyword(word) => About::Keyword(word),
            Subject::Unit(name) => About::Unit(name),
        };
        Data { uri: uri.clone(), about }
    }

    fn to_json(&self) -> Option<serde_json::Value> {
        serde_json::to_value(self).ok()
    }

    fn subject(self) -> Subject {
        let place = |file: String, start, end| SourceRange { file: file.into(), start, end };
        match self.about {
            About::Place(file, start, end) => Subject::Declaration(place(file, start, end)),
            About::Parameter(file, start, end, name) => Subject::Parameter(place(file, start, end), name),
            About::Builtin(name) => Subject::Builtin(name),
            About::Keyword(word) => Subject::Keyword(word),
            About::Unit(name) => Subject::Unit(name),
        }
    }
}

/// Returns the documentation of one item.
fn resolve(view: &View, mut item: CompletionItem) -> Result<CompletionItem> {
    let data = item.data.clone().and_then(|data| serde_json::from_value::<Data>(data).ok());
    if let Some(data) = data {
        let text = completion::documentation(&view.snapshot.database, &data.subject());
        item.documentation = text.map(markdown);
    }
    Ok(item)
}

fn markdown(value: String) -> Documentation {
    Documentation::MarkupContent(MarkupContent { kind: MarkupKind::Markdown, value })
}

fn signature_help(view: &View, params: SignatureHelpParams) -> Result<Option<SignatureHelp>> {
    let Some(position) = view.position(&params.text_document_position_params) else { return Ok(None) };
    let Some(found) = signature::signature(&view.snapshot, &position) else { return Ok(None) };
    let document = view.client.capabilities.text_document.as_ref();
    let information = document
        .and_then(|document| document.signature_help.as_ref())
        .and_then(|help| help.signature_information.as_ref());
    let offsets = information
        .and_then(|information| information.parameter_information.as_ref())
        .and_then(|parameter| parameter.label_offset_support)
        .unwrap_or(false);
    let parameters = found.parameters.iter().map(|parameter| {
        let text = found.label.get(parameter.label.clone()).unwrap_or_default();
        // Labels are always counted in UTF-16, independent of the position encoding.
        let start =
            found.label.get(..parameter.label.start).map_or(0, |before| before.encode_utf16().count());
        let end = start + text.encode_utf16().count();
        ParameterInformation {
            label: match offsets {
                true => ParameterLabel::LabelOffsets([start as u32, end as u32]),
                false => ParameterLabel::Simple(text.to_owned()),
            },
            documentation: (!parameter.doc.is_empty()).then(|| markdown(parameter.doc.clone())),
        }
    });
    // An index past the end means that no parameter is active.
    let active = found.active.unwrap_or(found.parameters.len()) as u32;
    let signature = SignatureInformation {
        documentation: found.doc.clone().map(markdown),
        parameters: Some(parameters.collect()),
        active_parameter: Some(active),
        label: found.label.clone(),
    };
    Ok(Some(SignatureHelp {
        signatures: vec![signature],
        active_signature: Some(0),
        active_parameter: Some(active),
    }))
}

#[cfg(test)]
mod tests {
    use super::{Data, Subject};
    use calyx_lang::analysis::SourceRange;
    use std::str::FromStr;
    use tower_lsp_server::ls_types::Uri;

    #[test]
    fn what_an_item_is_about_comes_back() {
        let uri = Uri::from_str("file:///a.cx").expect("a path");
        let place = SourceRange { file: "/a.cx".into(), start: 3, end: 8 };
        for subject in [
            Subject::Declaration(place.clone()),
            Subject::Parameter(place, "depth".into()),
            Subject::Builtin("sin".into()),
            Subject::Keyword("param".into()),
            Subject::Unit("inch".into()),
        ] {
            let json = Data::new(&uri, &subject).to_json().expect("written");
            let back: Data = serde_json::from_value(json).expect("read");
            assert_eq!(back.subject(), subject);
        }
    }
}
