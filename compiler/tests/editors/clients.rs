//! Tests with installed editors and their tools: Neovim and Emacs connect to the language server,
//! npm builds the Visual Studio Code extension.
//!
//! Tests of missing programs are skipped with a message; with `CALYX_CI_STRICT=1`, which `.ci/run`
//! sets after installing all of them, they fail.

use super::editors;
use std::path::Path;
use std::process::{Command, Stdio};

/// Returns true if a program is installed, so that the test continues.
fn installed(program: &str, why: &str) -> bool {
    let answer = Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    answer.is_ok_and(|status| status.success()) || skipped(&format!("`{program}` is not installed: {why}"))
}

/// Reports a skipped test; fails in strict mode.
fn skipped(why: &str) -> bool {
    assert!(std::env::var_os("CALYX_CI_STRICT").is_none_or(|strict| strict != "1"), "{why}");
    // The harness captures the output macros of a passing test, but not direct writes to standard
    // error.
    let _ = std::io::Write::write_all(&mut std::io::stderr(), format!("SKIPPED: {why}\n").as_bytes());
    false
}

/// Runs a command to its end; shows its output if it fails.
fn run(command: &mut Command) {
    let output = command.stdin(Stdio::null()).output().expect("the program starts");
    let said = [&output.stdout, &output.stderr].map(|stream| String::from_utf8_lossy(stream));
    println!("{}{}", said[0], said[1]);
    assert!(output.status.success(), "{command:?}: {}\n{}{}", output.status, said[0], said[1]);
}

/// Creates a session with its own home directory for state of editors and server.
fn session(program: &str, home: &Path) -> Command {
    let mut command = Command::new(program);
    command.env("CALYX", env!("CARGO_BIN_EXE_calyx")).env("HOME", home);
    for kept in ["XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"] {
        command.env(kept, home.join(kept));
    }
    command
}

#[test]
fn neovim_edits_the_example_with_the_server() {
    if !installed("nvim", "the session in Neovim is left out") {
        return;
    }
    let home = tempfile::tempdir().expect("a folder");
    let script = format!("luafile {}", editors("neovim/tests/session.lua").display());
    run(session("nvim", home.path()).args(["--headless", "-u", "NONE", "-i", "NONE", "-c", &script]));
}

/// Creates a command that runs the mode's tests with a tag in Emacs.
fn emacs_tests(home: &Path, tag: &str) -> Command {
    let mut emacs = session("emacs", home);
    emacs.args(["--batch", "-L"]).arg(editors("emacs"));
    emacs.arg("-l").arg(editors("emacs/tests/calyx-mode-tests.el"));
    emacs.arg("--eval").arg(format!("(calyx-tests-run '{tag})"));
    emacs
}

#[test]
fn emacs_compiles_the_mode_without_a_warning_and_shows_models_right() {
    if !installed("emacs", "its mode is not tested") {
        return;
    }
    let home = tempfile::tempdir().expect("a folder");
    // A copy, because compiled files are written next to their source.
    let copy = home.path().join("calyx-mode.el");
    std::fs::copy(editors("emacs/calyx-mode.el"), &copy).expect("copied");
    let strict =
        ["-Q", "--batch", "--eval", "(setq byte-compile-error-on-warn t)", "-f", "batch-byte-compile"];
    run(session("emacs", home.path()).args(strict).arg(&copy));
    run(&mut emacs_tests(home.path(), "mode"));
}

#[test]
fn emacs_edits_the_example_with_the_server() {
    if !installed("emacs", "the session in Emacs is left out") {
        return;
    }
    let home = tempfile::tempdir().expect("a folder");
    let eglot = "(progn (package-initialize) (require 'eglot))";
    let found = session("emacs", home.path()).args(["--batch", "--eval", eglot]).output();
    if !found.is_ok_and(|output| output.status.success()) {
        skipped("Emacs has no Eglot: the session in Emacs is left out");
        return;
    }
    run(&mut emacs_tests(home.path(), "server"));
}

#[test]
fn the_visual_studio_code_extension_is_sound_and_can_be_packaged() {
    let folder = editors("vscode");
    if !installed("npm", "the extension is not built") {
        return;
    }
    if !folder.join("node_modules").is_dir() {
        skipped("`npm ci` was not run in lsp/editors/vscode: the extension is not built");
        return;
    }
    let npm = |script: &str| {
        let mut command = Command::new("npm");
        command.args(["run", "--silent", script]).current_dir(&folder);
        command
    };
    run(&mut npm("test"));
    run(&mut npm("package"));
    assert!(folder.join("calyx.vsix").is_file());
}
