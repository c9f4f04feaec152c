//! Hover texts, declarations, references, renames and actions as clients receive them.

use crate::protocol::client::{Client, Folder};
use serde_json::{Value, json};

const MODULE: &str = "units mm_N_s;\n/// Twice.\nfunction twice(in x) { return 2*x; }\n";
const MODEL: &str = "import util;\nimport gears;\nunits mm_N_s;\nvar größe = util.twice(1 mm);\nprint(größe, util.twice(x = größe));\n";

/// Returns a position in a text, in UTF-16 as in the protocol.
fn at(uri: &str, text: &str, mark: &str) -> Value {
    let offset = text.find(mark).expect("the mark is there");
    let line = text[..offset].matches('\n').count();
    let character = text[..offset].rsplit('\n').next().unwrap_or_default().encode_utf16().count();
    json!({ "textDocument": { "uri": uri }, "position": { "line": line, "character": character } })
}

fn with(mut params: Value, more: Value) -> Value {
    let all = params.as_object_mut().expect("an object");
    all.extend(more.as_object().cloned().unwrap_or_default());
    params
}

fn pair(client: &mut Client, folder: &Folder) -> (String, String) {
    let (model, module) = (folder.write("pair.cx", MODEL), folder.write("util.cx", MODULE));
    client.open(&model, MODEL);
    (model, module)
}

#[test]
fn a_card_has_the_declaration_and_its_documentation() {
    let folder = Folder::new();
    let markdown = json!({ "textDocument": { "hover": { "contentFormat": ["markdown"] } } });
    let mut client = Client::ready(markdown);
    let (model, _) = pair(&mut client, &folder);
    let card = client.ask("textDocument/hover", at(&model, MODEL, "twice(1")).expect("an answer");
    let text = card["contents"]["value"].as_str().expect("a text");
    assert!(text.contains("```calyx\nfunction twice(in x)\n```") && text.contains("Twice."), "{text}");
    assert_eq!(card["contents"]["kind"], "markdown");
    assert_eq!(card["range"]["start"], json!({ "line": 3, "character": 17 }));
    let nothing = client.ask("textDocument/hover", at(&model, MODEL, ";\nprint")).expect("an answer");
    assert!(nothing.is_null(), "{nothing}");
    assert!(client.leave());
}

#[test]
fn a_client_without_markdown_gets_plain_text() {
    let folder = Folder::new();
    let mut client =
        Client::ready(json!({ "textDocument": { "hover": { "contentFormat": ["plaintext"] } } }));
    let (model, _) = pair(&mut client, &folder);
    let card = client.ask("textDocument/hover", at(&model, MODEL, "twice(1")).expect("an answer");
    assert_eq!(card["contents"]["kind"], "plaintext");
    assert!(!card["contents"]["value"].as_str().expect("a text").contains('`'));
    assert!(client.leave());
}

#[test]
fn definitions_lead_to_other_files_and_into_the_library() {
    let folder = Folder::new();
    let mut client = Client::ready(json!({}));
    let (model, module) = pair(&mut client, &folder);
    let found = client.ask("textDocument/definition", at(&model, MODEL, "twice(1")).expect("an answer");
    assert_eq!(found["uri"], module.as_str());
    assert_eq!(found["range"]["start"], json!({ "line": 2, "character": 9 }));
    let library = client.ask("textDocument/definition", at(&model, MODEL, "gears;")).expect("an answer");
    let path = library["uri"].as_str().and_then(|uri| uri.strip_prefix("file://")).expect("a file");
    let text = std::fs::read_to_string(path).expect("the library's source is there");
    assert!(text.contains("extern pure function external("));
    assert!(client.leave());
}

#[test]
fn a_client_that_follows_links_gets_whole_declarations() {
    let folder = Folder::new();
    let mut client = Client::ready(json!({ "textDocument": { "definition": { "linkSupport": true } } }));
    let (model, module) = pair(&mut client, &folder);
    let found = client.ask("textDocument/definition", at(&model, MODEL, "twice(1")).expect("an answer");
    assert_eq!(found[0]["targetUri"], module.as_str());
    assert_eq!(found[0]["targetRange"]["start"]["character"], 0);
    assert_eq!(found[0]["targetSelectionRange"]["start"]["character"], 9);
    assert_eq!(found[0]["originSelectionRange"]["start"], json!({ "line": 3, "character": 17 }));
    assert!(client.leave());
}

#[test]
fn references_and_highlights_count_as_the_client_does() {
    let folder = Folder::new();
    let mut client = Client::ready(json!({}));
    let (model, _) = pair(&mut client, &folder);
    let asked = with(at(&model, MODEL, "größe"), json!({ "context": { "includeDeclaration": false } }));
    let found = client.ask("textDocument/references", asked).expect("an answer");
    let starts: Vec<&Value> =
        found.as_array().expect("a list").iter().map(|at| &at["range"]["start"]).collect();
    assert_eq!(starts, [&json!({ "line": 4, "character": 6 }), &json!({ "line": 4, "character": 28 })]);
    let marks = client.ask("textDocument/documentHighlight", at(&model, MODEL, "größe")).expect("an answer");
    let kinds: Vec<i64> =
        marks.as_array().expect("a list").iter().filter_map(|m| m["kind"].as_i64()).collect();
    assert_eq!(kinds, [3, 2, 2]);
    assert!(client.leave());
}

#[test]
fn a_rename_changes_all_files_for_their_versions() {
    let folder = Folder::new();
    let capabilities = json!({
        "textDocument": { "rename": { "prepareSupport": true } },
        "workspace": { "workspaceEdit": { "documentChanges": true } },
    });
    let mut client = Client::ready(capabilities);
    let (model, module) = pair(&mut client, &folder);
    let place = at(&model, MODEL, "twice(1");
    let prepared = client.ask("textDocument/prepareRename", place.clone()).expect("it can be renamed");
    assert_eq!(prepared["placeholder"], "twice");
    let asked = with(place.clone(), json!({ "newName": "doubled" }));
    let edit = client.ask("textDocument/rename", asked).expect("an answer");
    let mut changed: Vec<(&str, &Value, usize)> = edit["documentChanges"]
        .as_array()
        .expect("changes")
        .iter()
        .map(|of| {
            let document = &of["textDocument"];
            let count = of["edits"].as_array().map_or(0, Vec::len);
            (document["uri"].as_str().unwrap_or_default(), &document["version"], count)
        })
        .collect();
    changed.sort_by_key(|(uri, ..)| *uri);
    assert_eq!(changed, [(model.as_str(), &json!(1), 2), (module.as_str(), &Value::Null, 1)]);
    let refused = client.ask("textDocument/rename", with(place, json!({ "newName": "while" })));
    let error = refused.expect_err("a word of the language");
    assert_eq!(error["code"], -32803);
    assert!(error["message"].as_str().expect("a sentence").contains("word of the language"));
    let library = client.ask("textDocument/prepareRename", at(&model, MODEL, "gears;"));
    assert!(library.is_err(), "{library:?}");
    assert!(client.leave());
}

#[test]
fn a_fix_belongs_to_its_diagnostic() {
    const BROKEN: &str = "var größe = 1 mm;\nprint(größ);\n";
    let folder = Folder::new();
    let model = folder.uri("model.cx");
    let mut client = Client::ready(json!({}));
    client.open(&model, BROKEN);
    let shown = client.diagnostics(&model, 1);
    let unknown = shown.iter().find(|shown| shown["code"] == "E0201").expect("a name is not known");
    let range = unknown["range"].clone();
    let ask = |client: &mut Client, context: Value| {
        let params = json!({ "textDocument": { "uri": model }, "range": range, "context": context });
        client.ask("textDocument/codeAction", params).expect("an answer")
    };
    let actions = ask(&mut client, json!({ "diagnostics": shown }));
    assert_eq!(actions[0]["title"], "Change to `größe`");
    assert_eq!(actions[0]["isPreferred"], true);
    assert_eq!(actions[0]["kind"], "quickfix");
    assert_eq!(actions[0]["diagnostics"][0]["code"], "E0201");
    assert_eq!(actions[0]["edit"]["changes"][&model][0]["newText"], "größe");
    let refactorings = ask(&mut client, json!({ "diagnostics": [], "only": ["refactor"] }));
    assert_eq!(refactorings, json!([]));
    let all = ask(&mut client, json!({ "diagnostics": [], "only": ["source.fixAll"] }));
    assert_eq!(all[0]["kind"], "source.fixAll");
    assert_eq!(all.as_array().map(Vec::len), Some(1));
    assert!(client.leave());
}

#[test]
fn derived_geometry_comes_with_the_elaboration() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/spur_pair.cx"))
        .expect("the example");
    let folder = Folder::new();
    let model = folder.write("spur_pair.cx", &text);
    let mut client = Client::ready(json!({ "textDocument": { "hover": { "contentFormat": ["markdown"] } } }));
    client.open(&model, &text);
    // Geometry is known some time after the edit; until then the hover text omits it.
    for _ in 0..600 {
        let card = client.ask("textDocument/hover", at(&model, &text, "external(")).expect("an answer");
        let shown = card["contents"]["value"].as_str().expect("a card");
        assert!(shown.contains("function external("), "{shown}");
        if shown.contains("| base diameter |") {
            assert!(client.leave());
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(100));
    }
    panic!("elaboration says nothing");
}
