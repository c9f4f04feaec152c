//! The server of `calyx studio`, from the side of a browser and of an attacker: requests are
//! written to its port as bytes.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use calyx::rt::view::array_file::ArrayFile;
use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

mod unfinished;

/// A pair that is solved in closed form, in a moment.
const PAIR: &str = r#"/// A pair in closed form.
import gears;
units mm_N_s;

/// # Load
/// Torque on the pinion.
param torque = 100 N*m in 0 N*m .. 500 N*m;
/// # Analysis
param steps = 2 in 2 .. 10000;

var pinion = gears.external(24, module = 2.5 mm, face_width = 20 mm);
var gear = gears.external(40, module = 2.5 mm, face_width = 20 mm);
var pair = gears.pair(pinion, gear, center_distance = 80.1 mm, torque = torque, speed = 1500 rpm);

/// Largest contact pressure on the flanks.
output contact_pressure := gears.max_contact_pressure(pair.mesh);
analyze("quasi_static", over = gears.mesh_cycle(pair.mesh, steps), fidelity = "analytic", error_estimates = "none");
"#;

/// Longest time of a run in closed form, with other tests on the same machine.
const LONGEST: Duration = Duration::from_secs(120);

struct Server {
    child: Child,
    host: String,
    token: String,
}

struct Response {
    status: u16,
    head: String,
    body: Vec<u8>,
}

impl Response {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.body)
            .unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&self.body)))
    }
}

impl Server {
    fn start(directory: &Path, arguments: &[&str]) -> Server {
        let mut child = Command::new(env!("CARGO_BIN_EXE_calyx"))
            .current_dir(directory)
            .args(["studio", "--no-browser"])
            .args(arguments)
            .env("CALYX_CACHE", "off")
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("calyx starts");
        let mut line = String::new();
        let out = child.stdout.take().expect("standard output");
        BufReader::new(out).read_line(&mut line).expect("an address");
        let (host, token) = line
            .trim()
            .strip_prefix("http://")
            .and_then(|rest| rest.split_once("/?token="))
            .unwrap_or_else(|| panic!("no address: {line:?}"));
        Server { child, host: host.to_owned(), token: token.to_owned() }
    }

    /// Sends bytes and reads the response to its end.
    fn raw(&self, request: &[u8]) -> Response {
        let mut stream = TcpStream::connect(&self.host).expect("the server accepts connections");
        stream.set_read_timeout(Some(LONGEST)).expect("a time limit");
        // The server may refuse a large body before all of it is written.
        let _ = stream.write_all(request);
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").unwrap_or(bytes.len());
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
        let body = bytes.get(end + 4..).unwrap_or_default().to_vec();
        let body = if head.to_ascii_lowercase().contains("transfer-encoding: chunked") {
            unchunked(&body)
        } else {
            body
        };
        Response { status, head, body }
    }

    /// Sends bytes that are no request, and ends the connection; returns the status, or 0.
    fn garbage(&self, bytes: &[u8]) -> u16 {
        let mut stream = TcpStream::connect(&self.host).expect("the server accepts connections");
        stream.write_all(bytes).expect("the connection is open");
        stream.shutdown(Shutdown::Write).expect("the connection is open");
        let mut answer = String::new();
        let _ = stream.read_to_string(&mut answer);
        answer.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0)
    }

    fn request(&self, method: &str, path: &str, headers: &str, body: &str) -> Response {
        let Server { host, token, .. } = self;
        let request = format!(
            "{method} {path} HTTP/1.1\r\nHost: {host}\r\nAuthorization: Bearer {token}\r\nConnection: close\r\n{headers}Content-Length: {}\r\n\r\n{body}",
            body.len()
        );
        self.raw(request.as_bytes())
    }

    fn get(&self, path: &str) -> Response {
        self.request("GET", path, "", "")
    }

    fn send(&self, method: &str, path: &str, body: &Value) -> Response {
        self.request(method, path, "Content-Type: application/json\r\n", &body.to_string())
    }

    fn post(&self, path: &str, params: Value) -> Response {
        self.send("POST", path, &json!({ "params": params }))
    }

    /// Waits until a run has another status than "running".
    fn ended(&self, id: &str) -> Value {
        let started = Instant::now();
        loop {
            let results = self.get(&format!("/api/runs/{id}")).json();
            if results["status"] != "running" {
                return results;
            }
            assert!(started.elapsed() < LONGEST, "{results}");
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    fn interrupt(&mut self) {
        let sent = Command::new("kill").args(["-INT", &self.child.id().to_string()]).status();
        assert!(sent.expect("kill").success());
        let status = self.child.wait().expect("the server ends");
        assert_eq!(status.code(), Some(0));
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn unchunked(mut bytes: &[u8]) -> Vec<u8> {
    let mut all = Vec::new();
    while let Some(end) = bytes.windows(2).position(|two| two == b"\r\n") {
        let length =
            usize::from_str_radix(std::str::from_utf8(&bytes[..end]).unwrap_or("0"), 16).unwrap_or(0);
        let chunk = bytes.get(end + 2..end + 2 + length).unwrap_or_default();
        all.extend_from_slice(chunk);
        bytes = bytes.get(end + 4 + length..).unwrap_or_default();
        if length == 0 {
            break;
        }
    }
    all
}

fn folder_with(model: &str) -> (tempfile::TempDir, PathBuf) {
    let directory = tempfile::tempdir().expect("a temporary folder");
    let path = directory.path().join("pair.cx");
    fs::write(&path, model).expect("a model");
    (directory, path)
}

#[test]
fn a_form_is_checked_run_and_read() {
    let (directory, _) = folder_with(PAIR);
    let server = Server::start(directory.path(), &["pair.cx"]);
    let model = server.get("/api/model").json();
    assert_eq!(model["params"][0]["group"], "Load");
    assert_eq!(model["params"][0]["doc"], "Torque on the pinion.");
    assert_eq!(model["params"][1]["group"], "Analysis");
    assert_eq!((&model["broken"], &model["outputs"][0]["unit"]), (&json!(false), &json!("MPa")));

    let check = server.post("/api/check", json!({ "torque": "200", "steps": "3" })).json();
    assert_eq!((&check["runnable"], &check["errors"]), (&json!(true), &json!({})));
    assert!(check["plan"]["time"].as_f64().expect("a time") > 0.0, "{check}");

    // Each param has its own error, and `run` rejects the same values.
    let wrong = json!({ "torque": "600", "steps": "2.5", "torqe": "1" });
    let empty = server.post("/api/check", json!({ "torque": " " })).json();
    assert_eq!(empty["errors"]["torque"]["message"], "a value is missing", "{empty}");
    let check = server.post("/api/check", wrong.clone()).json();
    assert_eq!(check["runnable"], false);
    assert!(check["errors"]["torque"]["message"].as_str().expect("an error").contains("outside its range"));
    assert!(check["errors"]["steps"]["message"].as_str().expect("an error").contains("whole number"));
    assert!(check["errors"]["torqe"]["help"].as_str().expect("a remedy").contains("did you mean `torque`?"));
    let refused = server.post("/api/runs", wrong);
    assert_eq!((refused.status, &refused.json()["code"]), (422, &json!("invalid_model")));
    assert!(!directory.path().join("pair.cx.studio").exists());

    let started = server.post("/api/runs", json!({ "torque": "200 N*m" }));
    assert_eq!((started.status, &started.json()["id"]), (201, &json!("run-0001")));
    let results = server.ended("run-0001");
    assert_eq!(results["status"], "finished", "{results}");
    assert_eq!(
        results["params"]["torque"],
        json!({ "text": "200", "unit": "N*m", "at_default": false, "entered": "200 N*m" })
    );
    let rows = results["steps"]["contact_pressure"].as_array().expect("a column").len();
    assert_eq!(json!(rows), results["run"]["positions"]);
    let file = server.get("/api/runs/run-0001/files/steps.csv");
    assert_eq!(
        file.body,
        fs::read(directory.path().join("pair.cx.studio/run-0001/steps.csv")).expect("a table")
    );
    let report = server.get("/api/runs/run-0001/files/report.html");
    assert!(report.head.contains("sandbox"), "{}", report.head);

    // The numbers are those of the command line.
    let status = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .current_dir(directory.path())
        .args(["run", "pair.cx", "--quiet", "--no-cache", "--set", "torque=200 N*m"])
        .status();
    assert!(status.expect("calyx starts").success());
    let same = fs::read(directory.path().join("pair.cx.run/steps.csv")).expect("a table");
    assert_eq!(file.body, same);
    let runs = server.get("/api/runs").json();
    let ids: Vec<&Value> = runs["runs"].as_array().expect("runs").iter().map(|run| &run["id"]).collect();
    assert_eq!(ids, ["model", "run-0001"]);
    let scene = server.post("/api/scene", json!({ "torque": "200 N*m" }));
    assert_eq!(scene.status, 200);
    let scene = scene.json();
    for (key, name) in [("parts", "parts.bin"), ("position", "position-0000.bin")] {
        let bytes = STANDARD.decode(scene[key].as_str().expect("a text")).expect("base64");
        let found = ArrayFile::read(&bytes).expect("an array file").header;
        let of_run = server.get(&format!("/api/runs/run-0001/files/view/{name}")).body;
        let of_run = ArrayFile::read(&of_run).expect("an array file").header;
        for list in ["parts", "poses"] {
            assert_eq!(found[list], of_run[list], "{name}");
        }
    }
}

/// Requests and their status: method and path, headers, body. `HOST`, `PORT` and `TOKEN` stand for
/// those of the server, `own` for its `Host`, `auth` for the header with the token, `json` for the
/// content type, and `LARGE` for 2 MB.
const REQUESTS: &str = r#"
200 | GET /api/model | own, auth |
200 | GET /api/model | Host: localhost:PORT, auth |
401 | GET /api/model | own |
401 | GET / | own |
401 | GET /studio.js | own |
401 | GET /?token=0 | own |
401 | GET /api/model | own, Authorization: Bearer 0 |
401 | GET /api/model?token=TOKEN | own |
401 | GET /api/model | own, Cookie: calyx_studio_1=TOKEN |
200 | GET /api/model | own, Cookie: a=b; calyx_studio_PORT=TOKEN |
303 | GET /?token=TOKEN | own |
403 | GET /api/model | Host: evil.example:PORT, auth |
403 | GET /api/model | Host: 127.0.0.1:1, auth |
403 | GET /api/model | auth |
403 | GET /api/model | own, own, auth |
403 | GET http://evil.example:PORT/api/model | own, auth |
403 | GET /?token=TOKEN | Host: evil.example:PORT |
403 | GET /api/model | own, auth, Origin: http://evil.example |
403 | GET /api/model | own, auth, Origin: null |
403 | GET /api/model | own, auth, Origin: http://localhost:PORT |
200 | GET /api/model | own, auth, Origin: http://HOST |
403 | GET /api/model | own, auth, Sec-Fetch-Site: same-site |
200 | GET /api/model | own, auth, Sec-Fetch-Site: same-origin |
200 | GET /api/runs/run-0001/files/run.json | own, auth |
404 | GET /api/runs/run-0001/files/steps.csv | own, auth |
404 | GET /api/runs/run-0001/files/../../../secret.txt | own, auth |
404 | GET /api/runs/run-0001/files/..%2f..%2f..%2fsecret.txt | own, auth |
404 | GET /api/runs/run-0001/files/view/..%2frun.json | own, auth |
404 | GET /api/runs/run-0001/files/%2fetc%2fpasswd | own, auth |
404 | GET /api/runs/run-0001/files/.calyx-run | own, auth |
404 | GET /api/runs/..%2f.. | own, auth |
404 | GET /api/runs/run-0001%2f.. | own, auth |
400 | GET /api/runs/%ff | own, auth |
404 | GET /api/runs/opened | own, auth |
404 | GET /secret.txt | own, auth |
405 | DELETE /api/runs | own, auth |
415 | POST /api/check | own, auth | {"params":{}}
415 | POST /api/check | own, auth, Content-Type: text/plain | {"params":{}}
400 | POST /api/check | own, auth, json | {
400 | POST /api/check | own, auth, json |
400 | POST /api/check | own, auth, json | []
400 | POST /api/check | own, auth, json | {"params":{"a":1}}
400 | POST /api/check | own, auth, json | {"params":{"a":"\u0000"}}
413 | POST /api/check | own, auth, json | LARGE
400 | PUT /api/session | own, auth, json | {"version":2}
400 | PUT /api/session | own, auth, json | {"version":1,"params":{},"view":null,"more":1}
409 | POST /api/runs/run-0001/cancel | own, auth |
404 | POST /api/runs/none/cancel | own, auth |
"#;

#[test]
fn foreign_and_malformed_requests_are_refused() {
    let (directory, _) = folder_with(PAIR);
    let run = directory.path().join("pair.cx.studio/run-0001");
    fs::create_dir_all(&run).expect("a folder");
    fs::write(directory.path().join("secret.txt"), "secret").expect("a file");
    fs::write(run.join("run.json"), "{").expect("a file");
    std::os::unix::fs::symlink("../../secret.txt", run.join("steps.csv")).expect("a link");
    let server = Server::start(directory.path(), &["pair.cx"]);
    let port = server.host.rsplit_once(':').expect("a port").1;
    let filled =
        |text: &str| text.replace("HOST", &server.host).replace("PORT", port).replace("TOKEN", &server.token);
    for case in REQUESTS.lines().filter(|line| !line.is_empty()) {
        let parts: Vec<&str> = case.splitn(4, '|').map(str::trim).collect();
        let [status, line, headers, body] = parts[..] else { panic!("four columns: {case}") };
        let body = if body == "LARGE" { "x".repeat(2 << 20) } else { body.to_owned() };
        let mut request = format!("{} HTTP/1.1\r\nConnection: close\r\n", filled(line));
        for header in headers.split(", ") {
            let header = match header {
                "own" => "Host: HOST",
                "auth" => "Authorization: Bearer TOKEN",
                "json" => "Content-Type: application/json",
                other => other,
            };
            request += &format!("{}\r\n", filled(header));
        }
        request += &format!("Content-Length: {}\r\n\r\n{body}", body.len());
        let response = server.raw(request.as_bytes());
        let text = String::from_utf8_lossy(&response.body);
        assert_eq!(response.status.to_string(), status, "{case}: {text}");
        assert!(response.head.contains("content-security-policy"), "{case}: {}", response.head);
        assert!(!text.contains("secret"), "{case}: {text}");
        // The page itself has its errors as text.
        if response.status >= 400 && line.contains("/api/") {
            assert!(response.json()["message"].is_string(), "{case}: {text}");
        }
    }
    for bytes in
        [&b"\r\n\r\n"[..], b"GET\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\x00", b"GET / HTTP/9.9\r\n\r\n"]
    {
        let status = server.garbage(bytes);
        assert!(status == 0 || (400..600).contains(&status), "{bytes:?}: {status}");
    }
    assert_eq!(server.get("/api/model").status, 200);
}

#[test]
fn a_model_with_errors_shows_them_until_it_is_fixed() {
    let (directory, path) = folder_with("param a = 1 mm;\nparam b = 1 kg;\nvar c = a + b;\n");
    let server = Server::start(directory.path(), &["pair.cx"]);
    let model = server.get("/api/model").json();
    assert_eq!((&model["broken"], &model["params"]), (&json!(true), &json!([])));
    let rendered = model["rendered"].as_str().expect("a text");
    assert!(rendered.contains("pair.cx:3:") && rendered.contains("var c = a + b;"), "{rendered}");
    assert_eq!(model["diagnostics"][0]["primary"]["line"], 3);
    assert_eq!(server.post("/api/runs", json!({})).status, 422);
    fs::write(&path, PAIR).expect("a model");
    let fixed = server.get("/api/model").json();
    assert_eq!(fixed["broken"], false);
    assert_ne!(fixed["version"], model["version"]);
    // A gear that cannot be made at these values leaves the form in place.
    fs::write(
        &path,
        PAIR.replace("center_distance = 80.1 mm", "center_distance = torque * 0.8 mm / (1 N*m)"),
    )
    .expect("a model");
    let check = server.post("/api/check", json!({ "torque": "50" })).json();
    assert_eq!((&check["runnable"], &check["errors"]), (&json!(false), &json!({})));
    assert!(check["rendered"].as_str().expect("a text").contains("Error"), "{check}");
    fs::remove_file(&path).expect("the model is there");
    assert!(server.get("/api/model").json()["rendered"].as_str().expect("a text").contains("cannot read"));
    assert_eq!(server.post("/api/check", json!({})).status, 409);
}

#[test]
fn runs_are_cancelled_listed_and_may_be_deleted() {
    let (directory, _) = folder_with(PAIR);
    let mut server = Server::start(directory.path(), &["pair.cx"]);
    let long = json!({ "steps": "10000" });
    assert_eq!(server.post("/api/runs", long.clone()).json()["id"], "run-0001");
    let positions = |id: &str| server.get(&format!("/api/runs/{id}")).json()["progress"]["done"].as_u64();
    let started = Instant::now();
    while positions("run-0001").unwrap_or(0) < 2 {
        assert!(started.elapsed() < LONGEST);
        std::thread::sleep(Duration::from_millis(50));
    }
    // A page that is closed in the middle of a stream.
    let stream = TcpStream::connect(&server.host).expect("a connection");
    let request = format!(
        "GET /api/events HTTP/1.1\r\nHost: {}\r\nAuthorization: Bearer {}\r\n\r\n",
        server.host, server.token
    );
    (&stream).write_all(request.as_bytes()).expect("a request");
    let mut lines = BufReader::new(stream).lines().map_while(Result::ok);
    assert!(lines.any(|line| line == "event: progress"));
    drop(lines);

    assert_eq!(server.post("/api/runs/run-0001/cancel", json!({})).status, 202);
    let cancelled = server.ended("run-0001");
    assert_eq!(cancelled["status"], "cancelled", "{cancelled}");
    assert!(cancelled["run"]["incomplete"].is_object(), "{cancelled}");
    assert_eq!(server.post("/api/runs/run-0001/cancel", json!({})).status, 409);

    // A directory that is deleted during the run and one that is deleted later.
    assert_eq!(server.post("/api/runs", long.clone()).json()["id"], "run-0002");
    fs::remove_dir_all(directory.path().join("pair.cx.studio")).expect("the folder is there");
    assert_eq!(server.get("/api/runs/run-0002").status, 404);
    assert_eq!(server.get("/api/runs").json()["runs"], json!([]));
    server.post("/api/runs/run-0002/cancel", json!({}));
    let id = server.post("/api/runs", json!({})).json()["id"].clone();
    assert_eq!(id, "run-0001");
    assert_eq!(server.ended("run-0001")["status"], "finished");

    // The end of the server ends its runs, which keep their positions.
    let id = server.post("/api/runs", long).json()["id"].as_str().expect("a run").to_owned();
    let run = directory.path().join("pair.cx.studio").join(&id);
    while !run.join("journal.jsonl").exists() {
        assert!(started.elapsed() < 2 * LONGEST);
        std::thread::sleep(Duration::from_millis(50));
    }
    server.interrupt();
    assert_eq!(calyx::rt::run_directory::writer(&run), None);
    let record =
        fs::read_to_string(directory.path().join(format!("pair.cx.studio/{id}.json"))).expect("a record");
    assert!(record.contains("\"status\": \"cancelled\""), "{record}");
}

#[test]
fn a_file_in_place_of_the_folder_is_named() {
    let (directory, _) = folder_with(PAIR);
    let folder = directory.path().join("pair.cx.studio");
    for is_link in [false, true] {
        let _ = fs::remove_file(&folder);
        match is_link {
            false => fs::write(&folder, "notes").expect("a file"),
            true => std::os::unix::fs::symlink("missing", &folder).expect("a link"),
        }
        check_refused(directory.path());
    }
}

/// Checks that the studio does not start without a place for its folder.
fn check_refused(directory: &Path) {
    let ended = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .current_dir(directory)
        .args(["studio", "--no-browser", "pair.cx"])
        .output()
        .expect("calyx starts");
    let text = String::from_utf8_lossy(&ended.stderr);
    assert!(text.contains("pair.cx.studio is not a folder") && text.contains("rename or move it"), "{text}");
    assert_eq!(ended.status.code(), Some(1));
}

#[test]
fn two_studios_share_a_model() {
    let (directory, _) = folder_with(PAIR);
    let servers = [(); 2].map(|()| Server::start(directory.path(), &["pair.cx"]));
    let mut ids: Vec<String> = std::thread::scope(|scope| {
        let start =
            |server: &Server| server.post("/api/runs", json!({})).json()["id"].as_str().map(str::to_owned);
        let started: Vec<_> = servers.iter().map(|server| scope.spawn(move || start(server))).collect();
        started.into_iter().map(|thread| thread.join().expect("no panic").expect("a run")).collect()
    });
    ids.sort();
    assert_eq!(ids, ["run-0001", "run-0002"]);
    for server in &servers {
        assert_eq!(server.post("/api/preview", json!({ "torque": "150" })).status, 202);
    }
    for server in &servers {
        assert_eq!(server.ended("preview")["status"], "finished");
        assert_eq!(server.get("/api/runs").json()["runs"].as_array().map(Vec::len), Some(3));
    }
    assert!(directory.path().join("pair.cx.studio/preview-2/run.json").exists());
    let session = |number: usize| json!({ "version": 1, "params": { "torque": format!("{number}") }, "view": { "text": "x".repeat(9 * number) } });
    std::thread::scope(|scope| {
        for (offset, server) in servers.iter().enumerate() {
            scope.spawn(move || {
                for number in 0..20 {
                    // Refused if the other studio has stored another form in between.
                    let status = server.send("PUT", "/api/session", &session(2 * number + offset)).status;
                    assert!(matches!(status, 204 | 409), "{status}");
                    assert_eq!(server.get("/api/session").json()["version"], 1);
                }
            });
        }
    });
    let text = fs::read(directory.path().join("pair.cx.studio/session.json")).expect("a session");
    let stored: Value = serde_json::from_slice(&text).expect("a complete file");
    assert!((0..40).any(|number| stored == session(number)));
    let names = fs::read_dir(directory.path().join("pair.cx.studio")).expect("a folder").flatten();
    assert!(names.map(|entry| entry.file_name()).all(|name| !name.to_string_lossy().ends_with(".part")));
}

#[test]
fn a_run_of_another_process_is_listed() {
    let (directory, _) = folder_with(PAIR);
    let server = Server::start(directory.path(), &["pair.cx"]);
    assert_eq!(server.get("/api/runs").json()["runs"], json!([]));
    let mut other = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .current_dir(directory.path())
        .args(["run", "pair.cx", "--quiet", "--no-cache", "--set", "steps=10000"])
        .spawn()
        .expect("calyx starts");
    let started = Instant::now();
    let seen = loop {
        let runs = server.get("/api/runs").json()["runs"].clone();
        if runs[0]["status"] == "elsewhere" {
            break runs[0].clone();
        }
        assert!(started.elapsed() < LONGEST, "{runs}");
        std::thread::sleep(Duration::from_millis(50));
    };
    assert_eq!(seen["id"], "model");
    let message = seen["message"].as_str().expect("a message");
    assert!(message.contains(&format!("process {}", other.id())), "{message}");
    assert!(server.get("/api/runs/model").json()["steps"]["time"].is_array());
    assert_eq!(server.post("/api/runs/model/cancel", json!({})).status, 409);
    other.kill().expect("the run is in progress");
    other.wait().expect("the run ends");
    let ended = server.get("/api/runs/model").json();
    assert_eq!(ended["status"], "interrupted", "{ended}");
}

#[test]
fn the_directory_of_a_run_is_a_subject() {
    let (directory, path) = folder_with(PAIR);
    let status = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .current_dir(directory.path())
        .args(["run", "pair.cx", "--quiet", "--no-cache", "--out", "results"])
        .status();
    assert!(status.expect("calyx starts").success());
    let server = Server::start(directory.path(), &["results"]);
    let about = server.get("/api/studio").json();
    assert_eq!((&about["opened"], &about["model"]), (&json!("opened"), &json!("pair.cx")));
    assert_eq!(server.get("/api/runs/opened").json()["status"], "finished");
    drop(server);
    fs::remove_file(path).expect("the model is there");
    let server = Server::start(directory.path(), &["results"]);
    assert_eq!(server.get("/api/studio").json()["model"], Value::Null);
    assert_eq!(server.get("/api/model").status, 409);
    assert_eq!(server.post("/api/runs", json!({})).status, 409);
    assert_eq!(server.get("/api/runs").json()["runs"][0]["id"], "opened");
}
