//! Tests of result directories: files of the user in them are never lost, two runs never write at
//! the same time, and after a kill at any moment a later run continues or replaces the results.

use crate::results::results;
use crate::support::pair;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Model of a pair without meshes, which is solved quickly.
fn model_text() -> String {
    let analysis =
        "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, steps), fidelity = \"analytic\");\n";
    pair("param steps = 3 in 1 .. 300;\n", analysis)
}

fn calyx(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.args(arguments).env("CALYX_CACHE", "off").current_dir(folder);
    command
}

fn said(mut command: Command) -> (Option<i32>, String) {
    let Output { status, stderr, .. } = command.output().expect("it starts");
    (status.code(), String::from_utf8_lossy(&stderr).into_owned())
}

/// Creates a directory with the model.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a directory");
    fs::write(folder.path().join("pair.cx"), model_text()).expect("writable");
    folder
}

/// Returns all files in a directory and its subdirectories with their contents.
fn all_files(directory: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(directory).expect("a directory") {
        let path = entry.expect("an entry").path();
        match path.is_dir() {
            true => all.extend(all_files(&path)),
            false => drop(all.insert(path.clone(), fs::read(&path).expect("readable"))),
        }
    }
    all
}

/// Files that a user may have in a result directory, with names similar to those of results.
const OWN: [&str; 6] = [
    "notes.txt",
    "signals/measured.csv",
    "vtu/scene.pvsm",
    "steps.csv.bak",
    "figures/report.html",
    ".hidden",
];

fn write_own(directory: &Path) {
    for name in OWN {
        fs::create_dir_all(directory.join(name).parent().expect("a folder")).expect("writable");
        fs::write(directory.join(name), format!("own {name}")).expect("writable");
    }
}

fn assert_own(directory: &Path, when: &str) {
    for name in OWN {
        let text = fs::read_to_string(directory.join(name));
        assert_eq!(text.ok(), Some(format!("own {name}")), "{name} {when}");
    }
}

#[test]
fn a_directory_of_the_user_is_refused_and_unchanged() {
    let folder = folder();
    let out = folder.path().join("out");
    write_own(&out);
    for name in
        ["run.json", "steps.csv", "timing.json", "journal.jsonl", "signals/transmission_error_spectrum.csv"]
    {
        fs::write(out.join(name), "{}").unwrap();
    }
    let before = all_files(folder.path());
    for command in ["run", "tradeoff"] {
        let (status, err) = said(calyx(folder.path(), &[command, "pair.cx", "--out", "out"]));
        assert_eq!(status, Some(2), "{err}");
        assert!(err.contains("error: out has files that") && err.contains("--force"), "{err}");
        assert_eq!(all_files(folder.path()), before, "{command}");
    }
    // The default directory behaves equally.
    fs::rename(&out, folder.path().join("pair.cx.run")).unwrap();
    let before = all_files(folder.path());
    let (status, err) = said(calyx(folder.path(), &["run", "pair.cx", "--resume"]));
    assert_eq!(status, Some(2), "{err}");
    assert_eq!(all_files(folder.path()), before);
    // With `--force`, files with names of results are replaced and all others remain.
    let out = folder.path().join("pair.cx.run");
    let (status, err) = said(calyx(folder.path(), &["run", "pair.cx", "--force"]));
    assert_eq!(status, Some(0), "{err}");
    assert_own(&out, "after --force");
    assert!(fs::read_to_string(out.join("run.json")).unwrap().contains("\"pair.cx\""));
    // Now it is a run directory. A file with a name that a later run of this model may write still
    // belongs to the user.
    let (status, err) = said(calyx(folder.path(), &["run", "pair.cx"]));
    assert_eq!(status, Some(2), "{err}");
    assert!(err.contains("signals/transmission_error_spectrum.csv"), "{err}");
    fs::remove_file(out.join("signals/transmission_error_spectrum.csv")).unwrap();
    let (status, err) = said(calyx(folder.path(), &["run", "pair.cx"]));
    assert_eq!(status, Some(0), "{err}");
    assert_own(&out, "after a second run");
    fs::write(out.join("modes.csv"), "own").unwrap();
    let (status, err) = said(calyx(folder.path(), &["run", "pair.cx"]));
    assert_eq!(status, Some(2), "{err}");
    assert!(err.contains("modes.csv") && err.contains("--force"), "{err}");
    assert_eq!(fs::read_to_string(out.join("modes.csv")).unwrap(), "own");
}

#[test]
fn a_run_that_fails_before_its_first_position_changes_nothing() {
    let folder = folder();
    let (status, err) = said(calyx(folder.path(), &["run", "pair.cx"]));
    assert_eq!(status, Some(0), "{err}");
    let before = all_files(&folder.path().join("pair.cx.run"));
    let model = folder.path().join("pair.cx");
    for (old, new) in [
        ("moment = torque * e3", "free = [\"u_x\"], moment = torque * e3"),
        ("48.05 mm", "30 mm"),
        ("20 N*m in 0 N*m .. 50 N*m", "20 N*m in 0 N*m .. 10 N*m"),
        ("fidelity = \"analytic\"", "fidelity = \"finer\""),
        ("var steel", "assert(steps < 2, \"stop\"); var steel"),
    ] {
        assert!(model_text().contains(old), "{old}");
        fs::write(&model, model_text().replace(old, new)).unwrap();
        let (status, err) = said(calyx(folder.path(), &["run", "pair.cx"]));
        assert!(matches!(status, Some(1 | 2)), "{new}: {err}");
        assert_eq!(all_files(&folder.path().join("pair.cx.run")), before, "{new}");
    }
    // A directory that did not exist is removed.
    let (status, _) = said(calyx(folder.path(), &["run", "pair.cx", "--out", "other"]));
    assert_eq!(status, Some(1));
    assert!(!folder.path().join("other").exists());
}

#[test]
fn a_second_run_into_a_directory_says_who_writes_there() {
    let folder = folder();
    let mut first =
        calyx(folder.path(), &["run", "pair.cx", "--set", "steps=300", "--quiet"]).spawn().unwrap();
    let marker = folder.path().join("pair.cx.run/.calyx-run");
    let patience = Instant::now() + Duration::from_secs(60);
    while !fs::read_to_string(&marker).is_ok_and(|text| text.contains("steps.csv")) {
        assert!(Instant::now() < patience && first.try_wait().unwrap().is_none(), "it ended or never began");
        std::thread::sleep(Duration::from_millis(5));
    }
    for arguments in [
        &["run", "pair.cx"][..],
        &["run", "pair.cx", "--resume"],
        &["run", "pair.cx", "--force"],
        &["report", "pair.cx"],
    ] {
        let (status, err) = said(calyx(folder.path(), arguments));
        assert_eq!(status, Some(1), "{arguments:?}: {err}");
        let who = format!("process {} on ", first.id());
        assert!(err.contains(&who) && err.contains(", since 2"), "{err}");
    }
    // The operating system releases the lock when the process ends.
    first.kill().unwrap();
    first.wait().unwrap();
    let (status, err) =
        said(calyx(folder.path(), &["run", "pair.cx", "--set", "steps=300", "--resume", "--quiet"]));
    assert_eq!(status, Some(0), "{err}");
}

/// Pseudo-random numbers (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) % count as u64) as usize
    }

    fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }
}

fn setting(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|number| number.parse().ok()).unwrap_or(usual)
}

/// Options of the fuzzed runs.
const VARIANTS: [&[&str]; 4] =
    [&[], &["--set", "torque=30"], &["--fields", "--set", "steps=4"], &["--vtu", "--set", "torque=10"]];

/// Random pairs of concurrent runs in one directory, killed at random moments, with files of the
/// user in it. The user's files survive, at most one run writes at a time, and a successful run
/// leaves exactly the results of an undisturbed run. `CALYX_FUZZ` is the number of rounds,
/// `CALYX_FUZZ_SEED` the seed.
#[test]
fn random_pairs_of_runs_and_kills_lose_nothing() {
    let (rounds, seed) = (setting("CALYX_FUZZ", 8), setting("CALYX_FUZZ_SEED", 1));
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let folder = folder();
    let mut longest = Duration::ZERO;
    let expected: Vec<BTreeMap<String, String>> = (0..VARIANTS.len())
        .map(|variant| {
            let out = format!("alone-{variant}");
            let began = Instant::now();
            let arguments = [&["run", "pair.cx", "--quiet", "--out", &out][..], VARIANTS[variant]].concat();
            let (status, err) = said(calyx(folder.path(), &arguments));
            assert_eq!(status, Some(0), "{err}");
            longest = longest.max(began.elapsed());
            results(&folder.path().join(out))
        })
        .collect();
    let shared = folder.path().join("shared");
    let of_run = || {
        let mut all = results(&shared);
        all.retain(|name, _| !OWN.contains(&name.as_str()));
        all
    };
    let (mut killed, mut refused, mut finished, mut continued) = (0, 0, 0, 0);
    for round in 0..rounds {
        let start = |random: &mut Random| {
            let (variant, resume) = (random.below(VARIANTS.len()), random.chance(50));
            let mut arguments =
                [&["run", "pair.cx", "--quiet", "--out", "shared"][..], VARIANTS[variant]].concat();
            arguments.extend(resume.then_some("--resume"));
            let mut command = calyx(folder.path(), &arguments);
            let child = command.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().expect("it starts");
            let kill = random.chance(50).then(|| longest.mul_f64(random.below(1000) as f64 / 1000.0));
            (child, variant, kill)
        };
        let first = start(&mut random);
        std::thread::sleep(longest.mul_f64(random.below(500) as f64 / 1000.0));
        let second = start(&mut random);
        let mut succeeded = Vec::new();
        let mut was_killed = false;
        for (child, variant, kill) in [first, second] {
            match end(child, kill) {
                (Some(0), _) => succeeded.push(variant),
                (Some(1), err) if err.contains("another run writes to shared: ") => refused += 1,
                (Some(2), err) if err.contains("the run in shared is another one") => refused += 1,
                (None, _) => (killed, was_killed) = (killed + 1, true),
                (status, err) => panic!("round {round} of seed {seed}: {status:?} {err}"),
            }
        }
        if !was_killed && !succeeded.is_empty() {
            let there = of_run();
            let known = succeeded.iter().any(|&variant| same(&there, &expected[variant]));
            assert!(known, "round {round} of seed {seed}: the results are of none of {succeeded:?}");
        }
        finished += succeeded.len();
        // An undisturbed run completes the results: it continues the earlier run or replaces it.
        let variant = random.below(VARIANTS.len());
        let arguments = [&["run", "pair.cx", "--quiet", "--out", "shared"][..], VARIANTS[variant]].concat();
        let (status, err) = said(calyx(folder.path(), &[&arguments[..], &["--resume"]].concat()));
        if status == Some(0) {
            continued += 1;
        } else {
            assert!(err.contains("is another one"), "round {round} of seed {seed}: {err}");
            let (status, err) = said(calyx(folder.path(), &arguments));
            assert_eq!(status, Some(0), "round {round} of seed {seed}: {err}");
        }
        assert!(same(&of_run(), &expected[variant]), "round {round} of seed {seed}: mixed results");
        if round > 0 {
            assert_own(&shared, &format!("after round {round} of seed {seed}"));
        }
        write_own(&shared);
    }
    println!(
        "{rounds} rounds: {finished} finished, {killed} killed, {refused} refused, {continued} continued or repeated"
    );
}

/// Returns true if two runs wrote the same files. Their reports list the files of the directory,
/// including those of the user.
fn same(there: &BTreeMap<String, String>, expected: &BTreeMap<String, String>) -> bool {
    let names = there.keys().eq(expected.keys());
    names && there.iter().all(|(name, text)| name == "report.html" || expected[name] == *text)
}

/// Waits for a run, or kills it after a time; returns its exit status, `None` if it was killed, and
/// standard error.
fn end(mut child: Child, kill: Option<Duration>) -> (Option<i32>, String) {
    if let Some(delay) = kill {
        std::thread::sleep(delay);
        let _ = child.kill();
    }
    let output = child.wait_with_output().expect("it ends");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}
