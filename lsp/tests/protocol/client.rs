//! A scripted client.

use calyx_lsp::server::handlers::router;
use calyx_lsp::server::library::{Library, LibraryFile};
use calyx_lsp::server::log::Level;
use calyx_lsp::server::router::Router;
use calyx_lsp::server::{Options, serve};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::thread::JoinHandle;
use std::time::Duration;
use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader, DuplexStream, WriteHalf};
use tokio::runtime::Runtime;

/// Timeout of all waits.
const PATIENCE: Duration = Duration::from_secs(60);

/// A client and its server, which runs on its own threads.
pub struct Client {
    runtime: Runtime,
    output: Option<WriteHalf<DuplexStream>>,
    messages: Receiver<Value>,
    answers: HashMap<i64, Value>,
    /// Notifications that the test has not consumed yet, in order.
    pub notifications: Vec<Value>,
    last_id: i64,
    server: Option<JoinHandle<bool>>,
}

/// Returns the library from the sources, with its cache below a folder.
pub fn library(cache: &Path) -> Library {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../stdlib-gears/calyx");
    let file = |path: &str, name: &str| LibraryFile {
        path: path.to_owned(),
        name: format!("<library>/{name}"),
        text: std::fs::read_to_string(folder.join(name)).expect("the library is there"),
    };
    Library::new(file("std", "prelude.cx"), vec![file("gears", "gears.cx")], Some(cache))
}

impl Client {
    /// Creates a client of a server that is not initialized.
    pub fn new(router: Router) -> Client {
        Client::with_cache(router, &std::env::temp_dir().join("calyx-protocol-tests"))
    }

    pub fn with_cache(router: Router, cache: &Path) -> Client {
        let (ours, theirs) = tokio::io::duplex(1 << 20);
        // Models run in processes of the real command, which is tested in the compiler crate.
        let executable = PathBuf::from("calyx-is-not-here");
        let options = Options { library: library(cache), log: Level::Error, executable, record: None };
        let server = std::thread::spawn(move || {
            let runtime = Runtime::new().expect("threads");
            let (input, output) = tokio::io::split(theirs);
            runtime.block_on(serve(input, output, options, router)).expect("nothing is recorded")
        });
        let runtime = Runtime::new().expect("threads");
        let (input, output) = tokio::io::split(ours);
        let (sender, messages) = channel();
        runtime.spawn(async move {
            let mut input = BufReader::new(input);
            while let Some(message) = read(&mut input).await {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        Client {
            runtime,
            output: Some(output),
            messages,
            answers: HashMap::new(),
            notifications: Vec::new(),
            last_id: 0,
            server: Some(server),
        }
    }

    /// Creates an initialized client with these capabilities.
    pub fn ready(capabilities: Value) -> Client {
        Client::ready_with(router(), capabilities)
    }

    pub fn ready_with(router: Router, capabilities: Value) -> Client {
        let mut client = Client::new(router);
        client.initialize(capabilities);
        client
    }

    pub fn initialize(&mut self, capabilities: Value) -> Value {
        self.initialize_with(capabilities, Value::Null)
    }

    /// Initializes the server with capabilities and options.
    pub fn initialize_with(&mut self, capabilities: Value, options: Value) -> Value {
        let asked = json!({ "capabilities": capabilities, "initializationOptions": options });
        let answer = self.ask("initialize", asked);
        self.notify("initialized", json!({}));
        answer.expect("a server that is not initialized can be")
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.send_bytes(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    pub fn send_bytes(&mut self, bytes: &[u8]) {
        let output = self.output.as_mut().expect("the client has not left");
        self.runtime.block_on(output.write_all(bytes)).expect("the server reads");
    }

    /// Removes and returns the errors that answer malformed messages.
    pub fn refusals(&mut self) -> Vec<Value> {
        let refused = |message: &mut Value| message.get("error").is_some();
        self.notifications.extract_if(.., refused).collect()
    }

    /// Waits for a notification, and removes it.
    pub fn until(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        loop {
            match self.notifications.iter().position(&wanted) {
                Some(at) => return self.notifications.remove(at),
                None => self.receive(),
            }
        }
    }

    pub fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request without waiting for its answer.
    pub fn request(&mut self, method: &str, params: Value) -> i64 {
        self.last_id += 1;
        let id = self.last_id;
        let message = match params {
            Value::Null => json!({ "jsonrpc": "2.0", "id": id, "method": method }),
            params => json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }),
        };
        self.send(&message);
        id
    }

    /// Waits for the answer to a request: its result, or its error.
    pub fn answer(&mut self, id: i64) -> Result<Value, Value> {
        loop {
            if let Some(mut answer) = self.answers.remove(&id) {
                return match answer.get("error") {
                    Some(error) => Err(error.clone()),
                    None => Ok(answer["result"].take()),
                };
            }
            self.receive();
        }
    }

    pub fn ask(&mut self, method: &str, params: Value) -> Result<Value, Value> {
        let id = self.request(method, params);
        self.answer(id)
    }

    /// Receives one message. Requests of the server are granted.
    fn receive(&mut self) {
        let received = self.messages.recv_timeout(PATIENCE);
        let message =
            received.unwrap_or_else(|_| panic!("nothing more is said after {:#?}", self.notifications));
        match (message.get("id").and_then(Value::as_i64), message.get("method")) {
            (Some(id), None) => {
                self.answers.insert(id, message);
            }
            (Some(id), Some(_)) => {
                self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": null }));
                self.notifications.push(message);
            }
            (None, _) => self.notifications.push(message),
        }
    }

    pub fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "calyx", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Replaces the whole text.
    pub fn set(&mut self, uri: &str, version: i32, text: &str) {
        self.change(uri, version, json!([{ "text": text }]));
    }

    pub fn change(&mut self, uri: &str, version: i32, changes: Value) {
        let document = json!({ "uri": uri, "version": version });
        self.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    pub fn close(&mut self, uri: &str) {
        self.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    }

    /// Waits for diagnostics of a document that satisfy a condition.
    pub fn diagnostics_when(&mut self, uri: &str, enough: impl Fn(&Value) -> bool) -> Vec<Value> {
        let wanted = |message: &Value| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["uri"] == uri
                && enough(&message["params"])
        };
        loop {
            if let Some(at) = self.notifications.iter().position(wanted) {
                let message = self.notifications.remove(at);
                // Drops earlier diagnostics of the document.
                let mut index = 0;
                self.notifications.retain(|earlier| {
                    index += 1;
                    index > at || earlier["params"]["uri"] != uri
                });
                let diagnostics = message["params"]["diagnostics"].as_array();
                return diagnostics.cloned().unwrap_or_default();
            }
            self.receive();
        }
    }

    /// Waits for the diagnostics of a version of a document.
    pub fn diagnostics(&mut self, uri: &str, version: i32) -> Vec<Value> {
        self.diagnostics_when(uri, |params| params["version"] == version)
    }

    /// Waits until the diagnostics of a document have these codes.
    pub fn codes_become(&mut self, uri: &str, expected: &[&str]) {
        self.diagnostics_when(uri, |params| codes(params["diagnostics"].as_array()) == expected);
    }

    /// Sends `shutdown` and `exit`. Returns true after a correct shutdown of the server.
    pub fn leave(mut self) -> bool {
        self.ask("shutdown", Value::Null).expect("a server that runs can be shut down");
        self.exit()
    }

    pub fn exit(mut self) -> bool {
        self.notify("exit", Value::Null);
        self.join()
    }

    /// Closes the connection without `shutdown`.
    pub fn vanish(mut self) -> bool {
        if let Some(mut output) = self.output.take() {
            self.runtime.block_on(output.shutdown()).expect("a stream can be closed");
        }
        self.join()
    }

    fn join(&mut self) -> bool {
        self.server.take().is_some_and(|server| server.join().expect("the server does not panic"))
    }
}

/// Returns the codes of diagnostics.
pub fn codes(diagnostics: Option<&Vec<Value>>) -> Vec<&str> {
    diagnostics.into_iter().flatten().filter_map(|diagnostic| diagnostic["code"].as_str()).collect()
}

async fn read(input: &mut (impl AsyncBufReadExt + Unpin)) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line).await.ok()? == 0 {
            return None;
        }
        match line.trim_end().split_once(": ") {
            Some(("Content-Length", value)) => length = value.parse().ok()?,
            Some(_) => {}
            None => break,
        }
    }
    let mut body = vec![0; length];
    input.read_exact(&mut body).await.ok()?;
    serde_json::from_slice(&body).ok()
}

/// Folder for the files of a test.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Folder {
        Folder(tempfile::tempdir().expect("there is room for a folder"))
    }

    pub fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    pub fn uri(&self, file: &str) -> String {
        format!("file://{}", self.path(file).display())
    }

    /// Writes a file and returns its URI.
    pub fn write(&self, file: &str, text: &str) -> String {
        let path = self.path(file);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).expect("a folder can be made");
        }
        std::fs::write(path, text).expect("a file can be written");
        self.uri(file)
    }
}
