//! Tests of the ownership of a results directory: files of the user stay, one process writes.

use calyx_rt::run_directory::{DirectoryError, Kind, MARKER, RunDirectory, utc};
use serde_json::json;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use tempfile::TempDir;

/// First line of the marker of a run directory.
const HEADER: &str = "Calyx run directory, format 1. A run replaces only the files listed here.\n";

/// Returns the last part of a path.
fn name(path: &Path) -> &str {
    path.file_name().unwrap().to_str().unwrap()
}

fn lock(directory: &Path) -> Result<RunDirectory, DirectoryError> {
    RunDirectory::lock(directory, Kind::Run, false)
}

/// Creates a folder with files that contain their own names.
fn folder(files: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    files.iter().for_each(|name| write(folder.path(), name));
    folder
}

fn write(directory: &Path, name: &str) {
    fs::create_dir_all(directory.join(name).parent().unwrap()).unwrap();
    fs::write(directory.join(name), name).unwrap();
}

/// Returns the names of the entries of a directory, sorted.
fn names_in(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Lists the files in a directory and its folders, without the marker.
fn files(directory: &Path) -> Vec<String> {
    let mut all = Vec::new();
    for name in names_in(directory) {
        let path = directory.join(&name);
        if path.is_dir() {
            all.extend(files(&path).into_iter().map(|below| format!("{name}/{below}")));
        } else if name != MARKER {
            all.push(name);
        }
    }
    all
}

/// Simulates a run: removes the files of an earlier one and writes these.
fn run(directory: &Path, names: &[&str]) {
    let locked = lock(directory).unwrap();
    locked.clear().unwrap();
    for name in names {
        locked.claim(name).unwrap();
        write(directory, name);
    }
}

#[test]
fn a_directory_with_files_of_the_user_is_refused_and_unchanged() {
    for own in [&["notes.txt"][..], &["run.json", "signals/measured.csv"], &[".hidden"], &[".calyx-run"]] {
        let folder = folder(own);
        let Err(error) = lock(folder.path()) else { panic!("{own:?} was accepted as a run directory") };
        assert!(matches!(error, DirectoryError::Foreign { .. }), "{error}");
        assert!(error.help().contains("--force"), "{}", error.help());
        assert_eq!(names_in(folder.path()).len(), own.len());
        own.iter().for_each(|name| assert_eq!(fs::read_to_string(folder.path().join(name)).unwrap(), *name));
    }
    // The message lists as many files as fit on a line.
    let folder = folder(&["a", "b", "c", "d", "e", "f"]);
    let message = lock(folder.path()).unwrap_err().to_string();
    assert!(message.ends_with("has files that a run did not write: a, b, c, d, and 2 more"), "{message}");
}

#[test]
fn a_run_replaces_only_the_files_of_earlier_runs() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("made");
    run(&directory, &["run.json", "steps.csv", "pressure.csv", "signals/te_spectrum.csv", "vtu/contact.pvd"]);
    for own in ["notes.txt", "signals/notes.csv", "vtu/scene.pvsm", "data/steps.csv"] {
        write(&directory, own);
    }
    run(&directory, &["run.json"]);
    let remaining = ["data/steps.csv", "notes.txt", "run.json", "signals/notes.csv", "vtu/scene.pvsm"];
    assert_eq!(files(&directory), remaining);
    // A file of the user with the name of a result.
    write(&directory, "modes.csv");
    let error = lock(&directory).unwrap_err();
    assert!(matches!(&error, DirectoryError::InTheWay { files, .. } if *files == ["modes.csv"]), "{error}");
    // With force, it is replaced; files with other names remain.
    RunDirectory::lock(&directory, Kind::Run, true).unwrap().clear().unwrap();
    assert_eq!(files(&directory), ["data/steps.csv", "notes.txt", "signals/notes.csv", "vtu/scene.pvsm"]);
}

#[test]
fn files_of_the_user_below_a_folder_of_results_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path(), &["run.json", "signals/te_spectrum.csv"]);
    write(folder.path(), "signals/te_order_map.csv");
    let locked = lock(folder.path()).unwrap();
    let of_te = |name: &str| name.starts_with("te_");
    let error = locked.check_folder("signals", of_te).unwrap_err();
    assert!(
        matches!(&error, DirectoryError::InTheWay { files, .. } if *files == ["signals/te_order_map.csv"])
    );
    locked.check_folder("signals", |name| name == "te_spectrum.csv").unwrap();
    assert_eq!(locked.claim("signals/te_order_map.csv").unwrap_err().kind(), ErrorKind::AlreadyExists);
    for elsewhere in ["../x", "/x", "signals/../x", "signals/a/b", "other.csv"] {
        assert!(locked.claim(elsewhere).is_err(), "{elsewhere}");
    }
}

#[test]
fn files_outside_the_directory_stay_unchanged() {
    let outside = folder(&["te_spectrum.csv", "target"]);
    let folder = tempfile::tempdir().unwrap();
    run(folder.path(), &["run.json", "signals/te_spectrum.csv", "steps.csv"]);
    fs::remove_dir_all(folder.path().join("signals")).unwrap();
    std::os::unix::fs::symlink(outside.path(), folder.path().join("signals")).unwrap();
    fs::remove_file(folder.path().join("steps.csv")).unwrap();
    std::os::unix::fs::symlink(outside.path().join("target"), folder.path().join("steps.csv")).unwrap();
    let locked = lock(folder.path()).unwrap();
    assert!(locked.check_folder("signals", |_| true).is_err());
    locked.clear().unwrap();
    assert_eq!(files(outside.path()), ["target", "te_spectrum.csv"]);
    assert_eq!(files(folder.path()), ["signals/target", "signals/te_spectrum.csv"]);
    drop(locked);
    // A marker that lists files elsewhere.
    let [listed, absolute] = [folder.path(), outside.path()].map(|path| path.join("target"));
    fs::write(&listed, "target").unwrap();
    let text = format!(
        "{HEADER}file ../{0}/target\nfile {1}\nfile target\n",
        name(outside.path()),
        absolute.display()
    );
    fs::write(folder.path().join(MARKER), text).unwrap();
    lock(folder.path()).unwrap().clear().unwrap();
    assert!(listed.exists() && absolute.exists());
    fs::remove_file(&listed).unwrap();
    // A marker that is a symbolic link.
    fs::remove_file(folder.path().join(MARKER)).unwrap();
    std::os::unix::fs::symlink(outside.path().join("target"), folder.path().join(MARKER)).unwrap();
    assert!(lock(folder.path()).is_err());
    assert_eq!(fs::read_to_string(outside.path().join("target")).unwrap(), "target");
}

#[test]
fn only_one_run_locks_a_directory() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("made");
    let first = lock(&directory).unwrap();
    let DirectoryError::InUse { owner, .. } = lock(&directory).unwrap_err() else { panic!("not locked") };
    assert!(owner.contains(&format!("process {} on ", std::process::id())), "{owner}");
    assert!(owner.ends_with(" UTC"), "{owner}");
    // Force does not override the lock.
    assert!(RunDirectory::lock(&directory, Kind::Run, true).is_err());
    // The run wrote nothing, so the directory is removed.
    drop(first);
    assert!(!directory.exists());
    let first = lock(&directory).unwrap();
    first.claim("run.json").unwrap();
    drop(first);
    drop(lock(&directory).unwrap());
    assert!(directory.join(MARKER).exists());
}

#[test]
fn threads_exclude_each_other_from_a_directory() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("made");
    let (inside, entered) = (std::sync::atomic::AtomicUsize::new(0), std::sync::atomic::AtomicUsize::new(0));
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                for _ in 0..200 {
                    use std::sync::atomic::Ordering::SeqCst;
                    match lock(&directory) {
                        Ok(locked) => {
                            assert_eq!(inside.fetch_add(1, SeqCst), 0, "two in one directory");
                            entered.fetch_add(1, SeqCst);
                            std::thread::yield_now();
                            inside.fetch_sub(1, SeqCst);
                            drop(locked);
                        }
                        Err(DirectoryError::InUse { .. }) => {}
                        Err(DirectoryError::Io { error, .. }) if error.kind() == ErrorKind::ResourceBusy => {}
                        Err(error) => panic!("{error}"),
                    }
                }
            });
        }
    });
    assert!(entered.into_inner() > 0);
    // If another thread locked the directory before its removal, it remains, empty.
    assert!(!directory.exists() || names_in(&directory).is_empty());
}

#[test]
fn a_truncated_marker_lists_its_complete_lines() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path(), &["run.json", "steps.csv"]);
    let whole = fs::read(folder.path().join(MARKER)).unwrap();
    assert!(whole.starts_with(HEADER.as_bytes()));
    let header = HEADER.len();
    for length in header..=whole.len() {
        fs::write(folder.path().join(MARKER), &whole[..length]).unwrap();
        let text = String::from_utf8(whole[..length].to_vec()).unwrap();
        let listed = |name: &str| text.contains(&format!("file {name}\n"));
        match lock(folder.path()) {
            Ok(_) => assert!(listed("run.json") && listed("steps.csv"), "{text}"),
            Err(error) => assert!(!listed("run.json") || !listed("steps.csv"), "{error}"),
        }
    }
    // A kill during the write of the header: the directory is otherwise empty.
    let folder = tempfile::tempdir().unwrap();
    for length in 0..header {
        fs::write(folder.path().join(MARKER), &whole[..length]).unwrap();
        lock(folder.path()).unwrap();
    }
}

#[test]
fn directories_of_versions_without_markers_are_recognised() {
    let run = json!({
        "calyx": "0.1.0", "abi": "1", "model": "pair.cx", "source": { "files": [] }, "params": {},
        "signals": [{ "table": "signals/te_spectrum.csv", "picture": "../picture.svg" }],
    });
    let old =
        folder(&["steps.csv", "signals/te_spectrum.csv", "signals/own.csv", "own.txt", "vtu/contact.pvd"]);
    fs::write(old.path().join("run.json"), run.to_string()).unwrap();
    // A run that fails before its first position leaves everything unchanged.
    drop(lock(old.path()).unwrap());
    assert!(!old.path().join(MARKER).exists());
    lock(old.path()).unwrap().clear().unwrap();
    assert_eq!(files(old.path()), ["own.txt", "signals/own.csv"]);
    // After a kill: a journal and no summary.
    let killed = folder(&["steps.csv"]);
    let journal = format!("{}\n", json!({ "journal": 2, "run": run }));
    fs::write(killed.path().join("journal.jsonl"), journal).unwrap();
    lock(killed.path()).unwrap();
    // A `run.json` of another program.
    for other in [json!({}), json!([1]), json!({ "calyx": "0.1.0", "params": {} })] {
        let foreign = folder(&["steps.csv"]);
        fs::write(foreign.path().join("run.json"), other.to_string()).unwrap();
        assert!(matches!(lock(foreign.path()).unwrap_err(), DirectoryError::Foreign { .. }), "{other}");
    }
}

#[test]
fn kinds_of_directories_are_distinct() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path(), &["run.json"]);
    let other = RunDirectory::lock(folder.path(), Kind::Tradeoff, false).unwrap_err();
    assert!(matches!(other, DirectoryError::Foreign { .. }), "{other}");
}

#[test]
fn times_have_dates() {
    let table = [
        (0, "1970-01-01 00:00:00 UTC"),
        (951_782_399, "2000-02-28 23:59:59 UTC"),
        (951_782_400, "2000-02-29 00:00:00 UTC"),
        (1_795_324_833, "2026-11-22 05:20:33 UTC"),
        (4_107_542_400, "2100-03-01 00:00:00 UTC"),
    ];
    for (seconds, date) in table {
        assert_eq!(utc(seconds), date);
    }
}
