//! Outline, folds, selections, semantic tokens, hints, lenses, links, calls and formatting as
//! clients receive them.

use crate::protocol::client::{Client, Folder};
use serde_json::{Value, json};

const MODEL: &str = "\
import gears;
units mm_N_s;
/// Größe 😀 der Zähne.
param size = 2 mm;
function twice(in x) {
    return 2 * x;
}
var rack = gears.rack(size, tip_radius = twice(0.25 mm));
test function a_test() { assert(twice(1 mm) > 1 mm); }
output turn := Time;
";

struct Session {
    client: Client,
    uri: String,
    _folder: Folder,
}

impl Session {
    fn new(text: &str) -> Session {
        let folder = Folder::new();
        let uri = folder.write("pair.cx", text);
        let hierarchical = json!({ "hierarchicalDocumentSymbolSupport": true });
        let mut client = Client::ready(json!({ "textDocument": { "documentSymbol": hierarchical } }));
        client.open(&uri, text);
        Session { client, uri, _folder: folder }
    }

    fn ask(&mut self, method: &str, mut params: Value) -> Value {
        params["textDocument"] = json!({ "uri": self.uri });
        self.client.ask(&format!("textDocument/{method}"), params).expect("an answer")
    }
}

fn position(line: u32, character: u32) -> Value {
    json!({ "line": line, "character": character })
}

fn whole() -> Value {
    json!({ "start": position(0, 0), "end": position(10, 0) })
}

#[test]
fn outline_folds_selections_and_links() {
    let mut session = Session::new(MODEL);
    let symbols = session.ask("documentSymbol", json!({}));
    let names: Vec<&Value> = symbols.as_array().into_iter().flatten().map(|symbol| &symbol["name"]).collect();
    assert_eq!(names, ["size", "twice", "rack", "a_test", "turn"]);
    assert_eq!(symbols[0]["detail"], "Length");
    assert_eq!(symbols[0]["range"]["start"], position(2, 0));
    let folds = session.ask("foldingRange", json!({}));
    assert_eq!((&folds[0]["startLine"], &folds[0]["endLine"]), (&json!(4), &json!(5)));
    let selections = session.ask("selectionRange", json!({ "positions": [position(5, 12), position(3, 7)] }));
    assert_eq!(selections.as_array().map(Vec::len), Some(2));
    assert_eq!(selections[0]["parent"]["range"]["start"], position(5, 11));
    let links = session.ask("documentLink", json!({}));
    assert!(links[0]["target"].as_str().is_some_and(|target| target.ends_with("gears.cx")), "{links}");
    let found = session.client.ask("workspace/symbol", json!({ "query": "twi" })).expect("an answer");
    assert_eq!(found[0]["name"], "twice");
    let found = session.client.ask("workspace/symbol", json!({ "query": "lead_crown" })).expect("an answer");
    assert_eq!(found[0]["containerName"], "library");
    assert!(session.client.leave());
}

/// Returns the tokens as lines: line, character, length, kind.
fn placed(data: &Value) -> Vec<[u64; 4]> {
    let numbers: Vec<u64> = data.as_array().into_iter().flatten().filter_map(Value::as_u64).collect();
    let (mut line, mut character) = (0, 0);
    let each = numbers.chunks_exact(5).map(|token| {
        character = if token[0] == 0 { character + token[1] } else { token[1] };
        line += token[0];
        [line, character, token[2], token[3]]
    });
    each.collect()
}

#[test]
fn colours_are_told_whole_in_part_and_as_changes() {
    let mut session = Session::new(MODEL);
    let full = session.ask("semanticTokens/full", json!({}));
    let tokens = placed(&full["data"]);
    // Characters are counted in UTF-16: the emoji counts as two.
    assert!(tokens.contains(&[2, 0, 23, 0]), "{tokens:?}");
    let part = session
        .ask("semanticTokens/range", json!({ "range": { "start": position(3, 0), "end": position(4, 0) } }));
    let expected: Vec<_> = tokens.iter().filter(|token| token[0] == 3).copied().collect();
    assert_eq!(placed(&part["data"]), expected);
    session.client.change(
        &session.uri.clone(),
        2,
        json!([{
        "range": { "start": position(3, 13), "end": position(3, 14) }, "text": "3.5" }]),
    );
    let delta = session.ask("semanticTokens/full/delta", json!({ "previousResultId": full["resultId"] }));
    let mut data = full["data"].as_array().cloned().expect("numbers");
    let edits = delta["edits"].as_array().cloned().expect("a delta");
    assert!(!edits.is_empty());
    for edit in edits {
        let number = |key: &str| edit[key].as_u64().expect("a number") as usize;
        let end = number("start") + number("deleteCount");
        data.splice(number("start")..end, edit["data"].as_array().cloned().unwrap_or_default());
    }
    let fresh = session.ask("semanticTokens/full", json!({}));
    assert_eq!(json!(data), fresh["data"]);
    // An unknown previous answer.
    let whole = session.ask("semanticTokens/full/delta", json!({ "previousResultId": "gone" }));
    assert_eq!(whole["data"], fresh["data"]);
    assert!(session.client.leave());
}

#[test]
fn hints_lenses_and_calls() {
    let mut session = Session::new(MODEL);
    let hints = session.ask("inlayHint", json!({ "range": whole() }));
    let module = hints.as_array().into_iter().flatten().find(|hint| hint["label"][0]["value"] == "module:");
    let target = module.and_then(|hint| hint["label"][0]["location"]["uri"].as_str());
    assert!(target.is_some_and(|target| target.ends_with("gears.cx")), "{hints}");
    let lenses = session.ask("codeLens", json!({}));
    let commands =
        lenses.as_array().into_iter().flatten().filter_map(|lens| lens["command"]["command"].as_str());
    assert_eq!(commands.collect::<Vec<_>>(), ["calyx.test", "calyx.run", "calyx.plan"]);
    let uses = lenses.as_array().into_iter().flatten().find(|lens| lens["range"]["start"] == position(4, 9));
    let resolved = session.client.ask("codeLens/resolve", uses.cloned().expect("a lens")).expect("resolved");
    assert_eq!(resolved["command"]["title"], "2 uses");
    let items = session.ask("prepareCallHierarchy", json!({ "position": position(7, 18) }));
    assert_eq!(items[0]["name"], "rack");
    let incoming =
        session.client.ask("callHierarchy/incomingCalls", json!({ "item": items[0] })).expect("callers");
    assert_eq!(
        (&incoming[0]["from"]["name"], &incoming[0]["fromRanges"][0]["start"]),
        (&json!("pair.cx"), &position(7, 17))
    );
    let caller = json!({ "item": incoming[0]["from"] });
    let outgoing = session.client.ask("callHierarchy/outgoingCalls", caller).expect("callees");
    let names: Vec<&Value> =
        outgoing.as_array().into_iter().flatten().map(|call| &call["to"]["name"]).collect();
    assert_eq!(names, ["rack", "twice"]);
    assert!(session.client.leave());
}

#[test]
fn texts_are_laid_out_whole_in_part_and_while_typing() {
    let mut session = Session::new("var  a=1;\nvar  größe=2;\nvar c = 3;\n");
    let options = json!({ "tabSize": 4, "insertSpaces": true });
    let all = session.ask("formatting", json!({ "options": options }));
    assert_eq!(all.as_array().map(Vec::len), Some(6), "{all}");
    let line = json!({ "start": position(1, 0), "end": position(1, 3) });
    let part = session.ask("rangeFormatting", json!({ "range": line, "options": options }));
    assert!(
        part.as_array().is_some_and(|edits| edits.iter().all(|edit| edit["range"]["start"]["line"] == 1))
    );
    let typed = json!({ "position": position(1, 14), "ch": ";", "options": options });
    assert_eq!(session.ask("onTypeFormatting", typed), part);
    assert!(session.client.leave());
}
