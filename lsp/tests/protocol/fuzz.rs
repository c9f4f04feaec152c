//! Sessions of random messages: valid, invalid and damaged, in any order. The server always answers
//! the next valid request.
//!
//! `CALYX_FUZZ=1000 cargo test -p calyx-lsp --test all protocol::fuzz` runs that many sessions
//! instead of a few, and `CALYX_FUZZ_SEED` changes the seed.

use crate::protocol::client::Client;
use calyx_lsp::server::handlers::router;
use serde_json::{Map, Value, json};

const SESSIONS: u64 = 20;
const MESSAGES: usize = 40;

const METHODS: &[&str] = &[
    "initialize",
    "initialized",
    "shutdown",
    "$/cancelRequest",
    "$/setTrace",
    "$/unknown",
    "calyx/malformedMessage",
    "unknown",
    "",
    "textDocument/didOpen",
    "textDocument/didChange",
    "textDocument/didChange",
    "textDocument/didChange",
    "textDocument/didClose",
    "textDocument/didSave",
    "workspace/didChangeWatchedFiles",
    "workspace/didChangeWorkspaceFolders",
    "workspace/executeCommand",
    "workspace/symbol",
    "window/workDoneProgress/cancel",
    "textDocument/codeAction",
    "textDocument/codeLens",
    "textDocument/completion",
    "completionItem/resolve",
    "textDocument/definition",
    "textDocument/documentHighlight",
    "textDocument/documentLink",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/formatting",
    "textDocument/rangeFormatting",
    "textDocument/onTypeFormatting",
    "textDocument/hover",
    "textDocument/inlayHint",
    "textDocument/prepareCallHierarchy",
    "callHierarchy/incomingCalls",
    "callHierarchy/outgoingCalls",
    "textDocument/prepareRename",
    "textDocument/references",
    "textDocument/rename",
    "textDocument/selectionRange",
    "textDocument/semanticTokens/full",
    "textDocument/semanticTokens/full/delta",
    "textDocument/semanticTokens/range",
    "textDocument/signatureHelp",
];

const TEXTS: &[&str] = &[
    "",
    "var a = 1;\nprint(a);\n",
    "record P { x; }\nfunction f(in p) { return p.x; }\nprint(f(P(1)));\n",
    "import \"other.cx\";\nparam w = 20 mm in 1 mm .. 50 mm;\nprint(w",
    "\u{feff}var é = \"\u{1F600}{1}\";\r\nvar b = é;\r",
    "function f(x) {\n  return f(x",
];

const URIS: &[&str] = &["untitled:a", "untitled:b", "file:///nowhere/c.cx", "file:///", "", "%", "a b"];

/// Xorshift generator.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 33) as usize % count
    }

    fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    fn number(&mut self) -> Value {
        match self.below(16) {
            0 => json!(u32::MAX),
            1 => json!(-1),
            2 => json!(0.5),
            3 => json!(i64::MIN),
            4 => json!(1e300),
            _ => json!(self.below(30)),
        }
    }

    fn position(&mut self) -> Value {
        json!({ "line": self.number(), "character": self.number() })
    }

    fn range(&mut self) -> Value {
        json!({ "start": self.position(), "end": self.position() })
    }

    /// Params that are valid for most methods, each of which uses some of them.
    fn params(&mut self) -> Value {
        let document = json!({
            "uri": self.of(URIS), "version": self.number(), "languageId": "calyx", "text": self.of(TEXTS),
        });
        let changes: Vec<Value> = (0..self.below(4))
            .map(|_| match self.below(3) {
                0 => json!({ "text": self.of(TEXTS) }),
                _ => json!({ "range": self.range(), "text": self.of(TEXTS) }),
            })
            .collect();
        let item = json!({
            "name": "f", "kind": 12, "uri": self.of(URIS), "range": self.range(), "selectionRange": self.range(),
        });
        json!({
            "capabilities": { "general": { "positionEncodings": [self.of(&["utf-8", "utf-16", "x"])] } },
            "textDocument": document,
            "position": self.position(),
            "positions": [self.position(), self.position()],
            "range": self.range(),
            "contentChanges": changes,
            "options": { "tabSize": self.number(), "insertSpaces": true },
            "context": { "diagnostics": [], "includeDeclaration": true, "triggerKind": self.number() },
            "newName": self.of(&["b", "", "1", "return", "é"]),
            "ch": self.of(&["}", "\n", ";", ""]),
            "query": self.of(&["", "f", "\u{1F600}"]),
            "label": "f",
            "item": item,
            "id": self.number(),
            "token": self.number(),
            "previousResultId": "1",
            "command": self.of(&["calyx.run", "calyx.unknown", ""]),
            "arguments": [self.any(2)],
            "event": { "added": [{ "uri": self.of(URIS), "name": "x" }], "removed": [] },
            "changes": [{ "uri": self.of(URIS), "type": self.number() }],
            "value": "off",
        })
    }

    fn any(&mut self, depth: usize) -> Value {
        match self.below(if depth > 0 { 8 } else { 5 }) {
            0 => Value::Null,
            1 => json!(self.one_in(2)),
            2 => json!(self.of(URIS)),
            3 => json!(self.of(TEXTS)),
            4 => self.number(),
            5 => (0..self.below(3)).map(|_| self.any(depth - 1)).collect(),
            _ => {
                let names = ["uri", "line", "textDocument", "data", "item"];
                let fields = (0..self.below(3)).map(|_| (self.of(&names).to_owned(), self.any(depth - 1)));
                Value::Object(fields.collect::<Map<_, _>>())
            }
        }
    }

    /// Replaces or removes a part of a message.
    fn damage(&mut self, value: &mut Value) {
        if self.one_in(3) {
            *value = self.any(2);
            return;
        }
        match value {
            Value::Object(fields) if !fields.is_empty() => {
                let names: Vec<String> = fields.keys().cloned().collect();
                let name = &names[self.below(names.len())];
                if self.one_in(4) {
                    fields.remove(name);
                } else {
                    self.damage(&mut fields[name]);
                }
            }
            Value::Array(items) if !items.is_empty() => {
                let at = self.below(items.len());
                self.damage(&mut items[at]);
            }
            other => *other = self.any(1),
        }
    }

    /// Returns a random message as bytes.
    fn message(&mut self) -> Vec<u8> {
        let mut message = json!({ "jsonrpc": "2.0", "method": self.of(METHODS), "params": self.params() });
        if !self.one_in(3) {
            // Negative, because the ids of the requests at the end are positive.
            message["id"] = json!(-1 - self.below(50) as i64);
        }
        if self.one_in(20) {
            message = json!({ "jsonrpc": "2.0", "id": self.any(1), "result": self.any(2) });
        }
        if self.one_in(3) {
            self.damage(&mut message);
        }
        if self.one_in(3)
            && let Some(params) = message.get_mut("params")
        {
            self.damage(params);
        }
        let body = message.to_string();
        let length = match self.below(20) {
            0 => self.below(2 * body.len()),
            _ => body.len(),
        };
        let mut bytes = format!("Content-Length: {length}\r\n\r\n{body}").into_bytes();
        while self.one_in(8) {
            let at = self.below(bytes.len());
            match self.below(3) {
                0 => bytes[at] = self.below(256) as u8,
                1 => bytes.truncate(at.max(1)),
                _ => drop(bytes.splice(at..at, *b"\r\n")),
            }
        }
        bytes
    }
}

#[test]
fn any_messages_leave_the_server_alive() {
    let number = |name: &str| std::env::var(name).ok().and_then(|number| number.parse::<u64>().ok());
    let seed = number("CALYX_FUZZ_SEED").unwrap_or(0);
    for session in 0..number("CALYX_FUZZ").unwrap_or(SESSIONS) {
        let mut random = Random(((seed << 32) | session).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        let mut client = Client::new(router());
        if !random.one_in(4) {
            client.initialize(json!({}));
        }
        for _ in 0..MESSAGES {
            let message = random.message();
            // Only `exit` ends the server.
            if !message.windows(6).any(|bytes| bytes == b"\"exit\"") {
                client.send_bytes(&message);
            }
        }
        let params = json!({ "textDocument": { "uri": "untitled:a" } });
        // An error is an answer too: the session may have shut the server down.
        let _ = client.ask("textDocument/documentSymbol", params);
        let _ = client.ask("shutdown", Value::Null);
        client.exit();
    }
}
