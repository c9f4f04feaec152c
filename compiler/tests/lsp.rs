//! Tests of the process `calyx lsp` over its standard streams. All other tests of the server are in
//! `lsp/tests`.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

const MODEL: &str = "\
units mm_N_s;
param width = 20 mm in 1 mm .. 50 mm;
print(width);
";

struct Editor {
    process: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    notifications: Vec<Value>,
    last_id: i64,
}

impl Editor {
    fn new(arguments: &[&str]) -> Editor {
        let mut process = Command::new(env!("CARGO_BIN_EXE_calyx"))
            .arg("lsp")
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the command can be run");
        let input = process.stdin.take();
        let output = BufReader::new(process.stdout.take().expect("it has standard output"));
        Editor { process, input, output, notifications: Vec::new(), last_id: 0 }
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        let input = self.input.as_mut().expect("it is open");
        write!(input, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the server reads");
        input.flush().expect("the server reads");
    }

    fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Returns the result or the error of a request.
    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.last_id += 1;
        let id = self.last_id;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.receive();
            if message.get("method").is_none() && message["id"] == id {
                return message.get("error").cloned().unwrap_or_else(|| message["result"].clone());
            }
        }
    }

    /// Receives one message; accepts requests of the server.
    fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            let read = self.output.read_line(&mut line).expect("the server writes text");
            assert!(read > 0, "the server has gone");
            match line.trim_end().strip_prefix("Content-Length: ") {
                Some(value) => length = value.parse().expect("a number"),
                None if line.trim_end().is_empty() => break,
                None => {}
            }
        }
        let mut body = vec![0; length];
        self.output.read_exact(&mut body).expect("all of the message");
        let message: Value = serde_json::from_slice(&body).expect("JSON");
        if message.get("method").is_some() {
            if let Some(id) = message.get("id") {
                self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": null }));
            }
            self.notifications.push(message.clone());
        }
        message
    }

    fn initialize(&mut self, capabilities: Value) -> Value {
        let answer = self.ask("initialize", json!({ "capabilities": capabilities }));
        self.notify("initialized", json!({}));
        answer
    }

    /// Opens a file; returns the first diagnostics published for it.
    fn open(&mut self, uri: &str, text: &str) -> Value {
        let document = json!({ "uri": uri, "languageId": "calyx", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
        loop {
            let message = self.receive();
            if message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == uri {
                return message["params"]["diagnostics"].clone();
            }
        }
    }

    /// Ends the server; returns its exit status.
    fn exit(mut self, politely: bool) -> Option<i32> {
        if politely {
            assert_eq!(self.ask("shutdown", Value::Null), Value::Null);
        }
        self.notify("exit", Value::Null);
        self.process.wait().expect("it ends").code()
    }
}

#[test]
fn a_session_ends_as_it_should() {
    let mut editor = Editor::new(&[]);
    let answer = editor.initialize(json!({ "general": { "positionEncodings": ["utf-8"] } }));
    assert_eq!(answer["capabilities"]["positionEncoding"], "utf-8");
    assert_eq!(answer["serverInfo"]["version"], env!("CARGO_PKG_VERSION"));
    let found = editor.open("untitled:model", "import gears;\nprint(1 mm + 2);\n");
    assert_eq!(found[0]["code"], "E0401");
    assert_eq!(editor.exit(true), Some(0));
}

#[test]
fn to_end_without_shutdown_is_a_failure() {
    let mut editor = Editor::new(&["--log", "error"]);
    editor.initialize(json!({}));
    assert_eq!(editor.exit(false), Some(1));
    let mut editor = Editor::new(&["--stdio"]);
    editor.initialize(json!({}));
    drop(editor.input.take());
    assert_eq!(editor.process.wait().expect("it ends").code(), Some(1));
}

#[test]
fn what_arrives_is_recorded() {
    let folder = tempfile::tempdir().expect("a folder");
    let record = folder.path().join("record.jsonl");
    let mut editor = Editor::new(&["--record", &record.display().to_string()]);
    editor.initialize(json!({}));
    editor.open("untitled:model", "print(1);\n");
    assert_eq!(editor.exit(true), Some(0));
    let text = std::fs::read_to_string(record).expect("it is there");
    let methods =
        text.lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON")["method"].clone());
    let expected = ["initialize", "initialized", "textDocument/didOpen", "shutdown", "exit"];
    assert_eq!(methods.collect::<Vec<_>>(), expected);
}

#[test]
fn a_model_runs_and_shows_how_far_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("model.cx");
    std::fs::write(&path, MODEL).expect("a file");
    let uri = format!("file://{}", path.display());
    let mut editor = Editor::new(&[]);
    editor.initialize(json!({ "window": { "workDoneProgress": true } }));
    editor.open(&uri, MODEL);
    let ran = editor.ask("workspace/executeCommand", json!({ "command": "calyx.run", "arguments": [uri] }));
    assert!(ran["message"].as_str().is_some_and(|message| message.contains("model.cx has run")), "{ran}");
    assert!(folder.path().join("model.cx.run/run.json").exists());
    let kinds = editor.notifications.iter().filter(|message| message["method"] == "$/progress");
    let kinds: Vec<&Value> = kinds.map(|message| &message["params"]["value"]["kind"]).collect();
    assert_eq!(kinds.first(), Some(&&json!("begin")));
    assert_eq!(kinds.last(), Some(&&json!("end")));
    assert_eq!(editor.exit(true), Some(0));
}
