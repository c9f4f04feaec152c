//! Memory of the process under a limit: the largest resident size, seen from outside.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Models whose memory grows without end.
const ENDLESS: [(&str, &str); 8] = [
    ("text that doubles", "var s = \"0123456789\"; while (TRUE) { s = \"{s}{s}\"; }"),
    (
        "text that grows",
        "var s = \"0123456789\"; while (TRUE) { s = \"{s}0123456789012345678901234567890123456789\"; }",
    ),
    (
        "text of an array",
        "var a = [0.1]; while (TRUE) { for (var i = 0; i < 1000; i = i + 1) push(a, 0.1); var s = \"{a}\"; }",
    ),
    ("an array that grows", "var a = [0]; while (TRUE) { push(a, 1); }"),
    (
        "nested arrays",
        "var a = [[1, 2], [3]]; while (TRUE) { var b = a; push(a, b[0]); push(a, b[len(b) - 1]); }",
    ),
    ("tuples of arrays", "var a = [[1, 2, 3]]; while (TRUE) { var pair = [a, 1 > 2]; push(a, [1, 2, 3]); }"),
    ("printed lines", "while (TRUE) { print(\"a line that is printed without end\"); }"),
    (
        "errors that are caught",
        "while (TRUE) { try { assert(1 > 2, \"a text of an error\"); } catch (e) { } }",
    ),
];

/// Runs a command: its exit status, and the most that its process took, bytes.
fn size(folder: &Path, arguments: &[&str]) -> (Option<i32>, u64) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    let mut child = command
        .args(arguments)
        .env("CALYX_CACHE", "off")
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it starts");
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0;
    loop {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|line| line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok());
        most = most.max(kilobytes.unwrap_or(0) << 10);
        if let Some(ended) = child.try_wait().expect("it runs") {
            return (ended.code(), most);
        }
        sleep(Duration::from_millis(2));
    }
}

/// The process takes no more than the limit and the size for a model that does nothing, and a half of
/// the limit for what the allocator keeps.
#[test]
fn programs_keep_to_their_memory_limit() {
    let folder = tempfile::tempdir().expect("a directory");
    let folder = folder.path();
    fs::write(folder.join("nothing.cx"), "var x = 1;").expect("writable");
    let (status, [of_run, of_check]) = {
        let (status, run) = size(folder, &["run", "nothing.cx", "--quiet"]);
        (status, [run, size(folder, &["check", "nothing.cx"]).1])
    };
    assert_eq!(status, Some(0));
    let limit = 100_000_000;
    for (name, text) in ENDLESS {
        fs::write(folder.join("model.cx"), text).expect("writable");
        // Printing to nowhere takes no memory, but for the text itself.
        let (status, run) = size(folder, &["run", "model.cx", "--quiet", "--memory-limit", "100MB"]);
        assert_eq!(status, Some(1), "{name}");
        let (_, check) = size(folder, &["check", "model.cx"]);
        println!(
            "{name}: run {} MB over {}, check {} MB over {}",
            run >> 20,
            of_run >> 20,
            check >> 20,
            of_check >> 20
        );
        assert!(run < of_run + limit * 3 / 2, "{name}: {run} bytes in `run`");
        assert!(check < of_check + 256_000_000 * 3 / 2, "{name}: {check} bytes in `check`");
    }
}
