//! Cancelled and failing requests.

use crate::protocol::client::Client;
use calyx_lsp::server::handlers::router;
use calyx_lsp::server::router::Router;
use calyx_lsp::server::view::View;
use serde_json::{Value, json};
use std::sync::mpsc::channel;
use tower_lsp_server::ls_types::TextDocumentIdentifier;
use tower_lsp_server::ls_types::request::Request;

const MODEL: &str = "untitled:model";

/// Request that queries the database until it is cancelled.
enum Endless {}

/// Request whose handler panics.
enum Defect {}

#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "camelCase")]
struct Params {
    text_document: TextDocumentIdentifier,
}

impl Request for Endless {
    type Params = Params;
    type Result = ();
    const METHOD: &'static str = "test/endless";
}

impl Request for Defect {
    type Params = Params;
    type Result = ();
    const METHOD: &'static str = "test/defect";
}

fn params(uri: &str) -> Value {
    json!({ "textDocument": { "uri": uri } })
}

/// Returns a client, and a function that waits until an endless request has started.
fn client() -> (Client, impl Fn()) {
    let (begun, wait) = channel();
    let mut router: Router = router();
    router.on::<Endless>(move |view: &View, _| {
        begun.send(()).expect("the test waits");
        loop {
            view.snapshot.database.check(&view.file);
        }
    });
    router.on::<Defect>(|view: &View, _| panic!("a defect in {}", view.file));
    let mut client = Client::ready_with(router, json!({}));
    client.open(MODEL, "var a = 1;\n");
    (client, move || wait.recv().expect("the request begins"))
}

#[test]
fn a_client_takes_its_question_back() {
    let (mut client, begun) = client();
    let id = client.request("test/endless", params(MODEL));
    begun();
    client.notify("$/cancelRequest", json!({ "id": id }));
    assert_eq!(client.answer(id).expect_err("cancelled")["code"], -32800);
    // Cancellation of an answered or unknown request has no effect.
    client.notify("$/cancelRequest", json!({ "id": id }));
    client.notify("$/cancelRequest", json!({ "id": "unknown" }));
    assert!(client.leave());
}

#[test]
fn an_edit_supersedes_what_was_asked_about_the_text_before() {
    let (mut client, begun) = client();
    let id = client.request("test/endless", params(MODEL));
    begun();
    client.set(MODEL, 2, "var b = 1;\n");
    assert_eq!(client.answer(id).expect_err("superseded")["code"], -32801);
    assert!(client.leave());
}

#[test]
fn an_edit_elsewhere_has_the_question_asked_again() {
    let (mut client, begun) = client();
    let folder = crate::protocol::client::Folder::new();
    let (one, other) = (folder.uri("one.cx"), folder.uri("other.cx"));
    client.open(&one, "var a = 1;\n");
    client.open(&other, "var a = 1;\n");
    let id = client.request("test/endless", params(&one));
    begun();
    client.set(&other, 2, "var b = 1;\n");
    begun();
    client.notify("$/cancelRequest", json!({ "id": id }));
    assert_eq!(client.answer(id).expect_err("cancelled")["code"], -32800);
    assert!(client.leave());
}

#[test]
fn a_defect_is_answered_and_the_server_lives_on() {
    let (mut client, _) = client();
    let error = client.ask("test/defect", params(MODEL)).expect_err("it fails");
    assert_eq!(error["code"], -32603);
    assert_eq!(error["message"], format!("test/defect failed: a defect in {MODEL}"));
    let again = client.ask("test/defect", params(MODEL)).expect_err("it fails");
    assert_eq!(again["code"], -32603);
    client.set(MODEL, 2, "print(c);\n");
    client.codes_become(MODEL, &["E0201"]);
    assert!(client.leave());
}
