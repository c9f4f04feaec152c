//! Life cycle, from `initialize` to `exit`.

use crate::protocol::client::Client;
use calyx_lsp::server::handlers::router;
use serde_json::{Value, json};

fn formatting(uri: &str) -> Value {
    json!({ "textDocument": { "uri": uri }, "options": { "tabSize": 4, "insertSpaces": true } })
}

#[test]
fn a_client_comes_and_goes() {
    let mut client = Client::new(router());
    let answer = client.initialize(json!({}));
    assert_eq!(answer["serverInfo"]["name"], "calyx");
    assert_eq!(answer["capabilities"]["positionEncoding"], "utf-16");
    assert!(client.leave());
}

#[test]
fn to_leave_without_shutdown_is_an_error() {
    let mut client = Client::ready(json!({}));
    client.open("untitled:model", "var a = 1;\n");
    assert!(!client.exit());
    assert!(!Client::ready(json!({})).vanish());
    assert!(!Client::new(router()).exit());
}

#[test]
fn requests_have_their_time() {
    let mut client = Client::new(router());
    let early = client.ask("textDocument/formatting", formatting("untitled:model"));
    assert_eq!(early.expect_err("not initialized")["code"], -32002);
    // Notifications are ignored.
    client.open("untitled:model", "var   a = 1;\n");
    client.initialize(json!({}));
    assert_eq!(client.ask("textDocument/formatting", formatting("untitled:model")), Ok(Value::Null));
    let again = client.ask("initialize", json!({ "capabilities": {} }));
    assert_eq!(again.expect_err("a second time")["code"], -32600);
    client.ask("shutdown", Value::Null).expect("it runs");
    let late = client.ask("textDocument/formatting", formatting("untitled:model"));
    assert_eq!(late.expect_err("shut down")["code"], -32600);
    assert!(client.exit());
}

#[test]
fn unknown_and_malformed_messages_change_nothing() {
    let mut client = Client::ready(json!({}));
    let unknown = client.ask("calyx/unknown", json!({}));
    assert_eq!(unknown.expect_err("unknown")["code"], -32601);
    client.notify("$/unknown", json!({}));
    client.notify("calyx/unknown", json!({}));
    client.notify("textDocument/didChange", json!({ "textDocument": 7 }));
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": "untitled:nothing" } }));
    client.change("untitled:nothing", 3, json!([{ "text": "x" }]));
    let malformed =
        client.ask("textDocument/formatting", json!({ "textDocument": { "uri": "untitled:model" } }));
    client.open("untitled:model", "var   a = 1;\n");
    assert!(malformed == Ok(Value::Null) || malformed.is_err());
    let malformed =
        client.ask("textDocument/formatting", json!({ "textDocument": { "uri": "untitled:model" } }));
    assert_eq!(malformed.expect_err("no options")["code"], -32602);
    let edits = client.ask("textDocument/formatting", formatting("untitled:model")).expect("it is well");
    // Two of three blanks are removed.
    assert_eq!((&edits[0]["newText"], &edits[0]["range"]["start"]["character"]), (&json!(""), &json!(4)));
    assert!(client.leave());
}
