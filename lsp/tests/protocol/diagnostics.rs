//! Published diagnostics.

use crate::protocol::client::{Client, codes};
use serde_json::json;

const MODEL: &str = "untitled:model";

#[test]
fn diagnostics_follow_the_text_and_carry_its_version() {
    let mut client = Client::ready(json!({}));
    client.open(MODEL, "print(1 mm + 2);\n");
    let found = client.diagnostics(MODEL, 1);
    assert_eq!(codes(Some(&found)), ["E0401"]);
    assert_eq!(found[0]["source"], "calyx");
    assert_eq!(found[0]["severity"], 1);
    client.set(MODEL, 2, "print(1 mm + 2 mm);\n");
    assert_eq!(client.diagnostics(MODEL, 2), [] as [serde_json::Value; 0]);
    client.close(MODEL);
    assert!(client.leave());
}

#[test]
fn other_places_are_related_where_the_client_shows_them_and_told_where_it_does_not() {
    let text = "var a = 1 mm;\nvar a = 2 mm;\nprint(a);\n";
    let can = json!({ "textDocument": { "publishDiagnostics": { "relatedInformation": true } } });
    let mut client = Client::ready(can);
    client.open(MODEL, text);
    let found = client.diagnostics(MODEL, 1);
    assert_eq!(codes(Some(&found)), ["E0202"]);
    assert_eq!(found[0]["range"]["start"], json!({ "line": 1, "character": 4 }));
    let related = &found[0]["relatedInformation"][0];
    assert_eq!(related["location"]["uri"], MODEL);
    assert_eq!(related["location"]["range"]["start"], json!({ "line": 0, "character": 4 }));
    assert!(client.leave());

    let mut client = Client::ready(json!({}));
    client.open(MODEL, text);
    let found = client.diagnostics(MODEL, 1);
    let message = found[0]["message"].as_str().expect("a message");
    assert!(found[0].get("relatedInformation").is_none());
    assert!(message.contains("\nline 1: "), "{message}");
    assert!(client.leave());
}

#[test]
fn what_can_go_is_marked_and_fixes_travel_along() {
    let mut client = Client::ready(json!({}));
    client.open(MODEL, "var unused = 1;\nimport gear;\n");
    let found = client.diagnostics(MODEL, 1);
    let by_code =
        |code: &str| found.iter().find(|d| d["code"] == code).unwrap_or_else(|| panic!("{found:?}"));
    assert_eq!(by_code("W0201")["tags"], json!([1]));
    assert_eq!(by_code("W0201")["severity"], 2);
    let import = by_code("E0209");
    assert_eq!(import["data"]["newText"], "gears");
    assert_eq!(import["data"]["uri"], MODEL);
    let message = import["message"].as_str().expect("a message");
    assert!(message.contains("help: did you mean `gears`?"), "{message}");
    assert!(client.leave());
}

#[test]
fn what_only_elaboration_shows_follows_and_stays_while_the_text_is_broken() {
    let mut client = Client::ready(json!({}));
    let lines = ["var a = 1;", "assert(a > 2);", "print(a);"];
    client.open(MODEL, &lines.join("\n"));
    client.codes_become(MODEL, &["E0705"]);
    // The edit also breaks another line, so the model cannot be elaborated again.
    client.set(MODEL, 2, &["var a = 1;", "// One line more.", "assert(a > 2);", "print(b);"].join("\n"));
    let found = client.diagnostics(MODEL, 2);
    assert_eq!(codes(Some(&found)), ["E0201"], "what lies between two changes is taken for changed");
    client.set(MODEL, 3, &lines.join("\n"));
    client.codes_become(MODEL, &["E0705"]);
    client.change(MODEL, 4, json!([{
        "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } }, "text": "print(b);\n"
    }]));
    let found = client.diagnostics(MODEL, 4);
    let [.., assertion] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(assertion["code"], "E0705");
    assert_eq!(assertion["range"]["start"]["line"], 2);
    // The finding at the fixed line disappears before the next elaboration.
    client.set(MODEL, 5, "print(b);\nvar a = 1;\nassert(a > 0);\nprint(a);");
    client.codes_become(MODEL, &["E0201"]);
    client.set(MODEL, 6, "var a = 1;\nassert(a > 3);\nprint(a);");
    client.codes_become(MODEL, &["E0705"]);
    assert!(client.leave());
}
