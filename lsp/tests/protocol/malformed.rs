//! Malformed messages, and messages at the wrong time: each is answered according to the protocol,
//! and the server continues.

use crate::protocol::client::Client;
use calyx_lsp::server::handlers::router;
use calyx_lsp::server::router::Router;
use calyx_lsp::server::view::View;
use serde_json::{Value, json};
use tower_lsp_server::ls_types::request::{ExecuteCommand, Request};

fn framed(body: &[u8]) -> Vec<u8> {
    let mut message = format!("Content-Length: {}\r\n\r\n", body.len()).into_bytes();
    message.extend(body);
    message
}

/// Sends a request that any running server answers.
fn is_served(client: &mut Client) {
    let params = json!({ "textDocument": { "uri": "untitled:model" } });
    assert_eq!(client.ask("textDocument/documentSymbol", params), Ok(Value::Null));
}

#[test]
fn malformed_messages_are_answered_and_the_server_serves_on() {
    let mut client = Client::ready(json!({}));
    let request = r#"{"jsonrpc":"2.0","id":-1,"method":"x"}"#;
    let cases: [(&str, Vec<u8>, i64, Value); 9] = [
        ("invalid JSON", framed(b"{\"jsonrpc\":"), -32700, Value::Null),
        ("a batch", framed(format!("[{request}]").as_bytes()), -32600, Value::Null),
        ("invalid UTF-8", framed(b"{\"jsonrpc\":\"\xff\"}"), -32700, Value::Null),
        ("too short", format!("Content-Length: 5\r\n\r\n{request}").into(), -32700, Value::Null),
        ("too long", format!("Content-Length: 5000\r\n\r\n{request}").into(), -32700, Value::Null),
        ("negative", format!("Content-Length: -1\r\n\r\n{request}").into(), -32700, Value::Null),
        ("enormous", format!("Content-Length: {}\r\n\r\n", u64::MAX).into(), -32700, Value::Null),
        ("no header", b"hello\n".to_vec(), -32700, Value::Null),
        ("no version", framed(b"{\"id\":\"a\",\"method\":\"x\"}"), -32600, json!("a")),
    ];
    for (name, bytes, code, id) in cases {
        client.send_bytes(&bytes);
        is_served(&mut client);
        let refused = client.refusals();
        let shown: Vec<_> = refused.iter().map(|r| (r["error"]["code"].as_i64(), &r["id"])).collect();
        assert_eq!(shown, [(Some(code), &id)], "{name}");
        let logged = |message: &Value| message["method"] == "window/logMessage";
        client.until(logged);
    }
    assert!(client.leave());
}

/// Only a request with valid params can initialize a server or shut it down.
#[test]
fn notifications_are_no_requests() {
    let mut client = Client::new(router());
    client.notify("initialize", json!({ "capabilities": {} }));
    let early = client.ask("textDocument/documentSymbol", json!({}));
    assert_eq!(early.expect_err("not initialized")["code"], -32002);
    assert_eq!(client.ask("initialize", json!(7)).expect_err("no params")["code"], -32602);
    client.initialize(json!({}));
    client.notify("shutdown", Value::Null);
    is_served(&mut client);
    assert!(client.leave());
}

/// A request that is not answered in a job.
#[test]
fn a_defect_in_a_command_is_answered() {
    let mut client = Client::ready(json!({}));
    for arguments in [json!(null), json!(7), json!([]), json!([{ "uri": 7 }])] {
        let params = json!({ "command": "calyx.unknown", "arguments": arguments });
        assert!(client.ask(ExecuteCommand::METHOD, params).is_err());
    }
    is_served(&mut client);
    assert!(client.leave());
}

#[test]
fn a_stream_that_ends_within_a_message_ends_the_server() {
    let mut client = Client::ready(json!({}));
    client.send_bytes(b"Content-Length: 100\r\n\r\n{");
    assert!(!client.vanish());
}

/// Panics outside of the computation of an answer: in a change of a text, and in the search for the
/// document of a request.
#[test]
fn defects_of_notifications_change_nothing_else() {
    let mut router: Router = router();
    router.on::<tower_lsp_server::ls_types::request::HoverRequest>(|_: &View, _| panic!("a defect"));
    let mut client = Client::ready_with(router, json!({}));
    client.open("untitled:other", "var a = 1;\n");
    let params =
        json!({ "textDocument": { "uri": "untitled:other" }, "position": { "line": 0, "character": 0 } });
    assert_eq!(client.ask("textDocument/hover", params).expect_err("it fails")["code"], -32603);
    is_served(&mut client);
    assert!(client.leave());
}
