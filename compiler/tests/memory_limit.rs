//! Tests of the memory limit: the largest resident size of the process, measured from outside.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Models with unbounded memory growth.
const ENDLESS: [(&str, &str); 8] = [
    ("text that doubles", "var s = \"0123456789\"; while (TRUE) { s = \"{s}{s}\"; }"),
    (
        "text that grows",
        "var s = \"0123456789\"; while (TRUE) { s = \"{s}0123456789012345678901234567890123456789\"; }",
    ),
    (
        "text of an array",
        "var a = [0.1]; while (TRUE) { for (var i = 0; i < 20000; i = i + 1) push(a, 0.1); var s = \"{a}\"; }",
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

/// Runs a command; returns its exit status and the largest resident size of its process, bytes.
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
        // Until it has its own name, the process may still have the memory of the tests.
        let own = text.strip_prefix("Name:\tcalyx\n");
        let line = own.and_then(|own| own.lines().find_map(|line| line.strip_prefix("VmHWM:")));
        let kilobytes = line.and_then(|line| line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok());
        most = most.max(kilobytes.unwrap_or(0) << 10);
        if let Some(ended) = child.try_wait().expect("it runs") {
            return (ended.code(), most);
        }
        sleep(Duration::from_millis(2));
    }
}

/// The process takes at most the limit, plus the size for an empty model, plus half of the limit
/// for memory that the allocator retains.
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
        // Discarded output takes no memory, except for the text itself.
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

/// A run checks its program first, on a thread of its own, and returns the memory of the check
/// before it starts. With an arena for each thread a tenth of all processes kept up to 64 MB of it:
/// ten processes show a defect in two of three runs of the tests.
#[test]
fn the_memory_of_the_check_is_returned_before_the_run() {
    let folder = tempfile::tempdir().expect("a directory");
    let folder = folder.path();
    fs::write(folder.join("nothing.cx"), "var x = 1;").expect("writable");
    let (_, of_run) = size(folder, &["run", "nothing.cx", "--quiet"]);
    fs::write(folder.join("model.cx"), "while (TRUE) { print(\"a line that is printed without end\"); }")
        .expect("writable");
    let limit = 50_000_000;
    let run = || size(folder, &["run", "model.cx", "--quiet", "--memory-limit", "50MB"]).1;
    let most = (0..10).map(|_| run()).max().unwrap_or(0);
    println!("{} MB over {}", most >> 20, of_run >> 20);
    assert!(most < of_run + limit * 5 / 4, "{most} bytes");
}

/// A table counts with the size of its file before it is read, and with its cells before they are
/// stored.
#[test]
fn tables_are_charged_before_they_are_read() {
    let folder = tempfile::tempdir().expect("a directory");
    let folder = folder.path();
    fs::write(folder.join("nothing.cx"), "var x = 1;").expect("writable");
    let (_, of_run) = size(folder, &["run", "nothing.cx", "--quiet"]);
    let text = "print(len(column(read_table(\"large.csv\"), \"a\", 1)));";
    fs::write(folder.join("model.cx"), text).expect("writable");
    // Short cells have the largest memory overhead per byte of text.
    for (megabytes, limit) in [(60, 50_000_000), (20, 50_000_000)] {
        let rows = "1,2,3,4\n".repeat(megabytes * 125_000);
        fs::write(folder.join("large.csv"), format!("a,b,c,d\n{rows}")).expect("writable");
        let option = limit.to_string();
        let (status, taken) = size(folder, &["run", "model.cx", "--quiet", "--memory-limit", &option]);
        println!("a table of {megabytes} MB: {} MB over {}", taken >> 20, of_run >> 20);
        assert_eq!(status, Some(1), "{megabytes} MB");
        assert!(taken < of_run + limit * 3 / 2, "{taken} bytes for a table of {megabytes} MB");
    }
}

/// A plane analysis stays within its limit, or is rejected before it exceeds the limit.
#[test]
fn plane_analyses_keep_to_their_memory_limit() {
    let folder = tempfile::tempdir().expect("a directory");
    let folder = folder.path();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    fs::copy(example, folder.join("model.cx")).expect("the example is there");
    // The program and its compiled model are in memory before the analysis begins.
    let (_, of_run) =
        size(folder, &["run", "model.cx", "--quiet", "--fidelity", "rigid", "--set", "steps=2"]);
    let run = |options: &[&str]| {
        let common = ["run", "model.cx", "--quiet", "--fidelity", "plane", "--set", "steps=2", "--force"];
        size(folder, &[&common[..], options].concat())
    };
    let (status, unlimited) = run(&["--refinement", "2"]);
    assert_eq!(status, Some(0));
    println!("plane without a limit: {} MB over {}", unlimited >> 20, of_run >> 20);
    let mut refused = 0;
    for limit in [10_000_000, 30_000_000, 50_000_000, 100_000_000, 400_000_000] {
        let (status, taken) = run(&["--refinement", "2", "--memory-limit", &limit.to_string()]);
        println!("plane with {} MB: exit {status:?}, {} MB", limit / 1_000_000, taken >> 20);
        refused += usize::from(status == Some(1));
        assert!(status == Some(0) || status == Some(1));
        assert!(taken < of_run + limit * 3 / 2, "{taken} bytes within {limit}");
    }
    assert!(refused >= 1, "no limit was too small");
}
