//! Tests of models in C programs: the header is valid C and C++, the interface behaves as
//! documented, the example runs; valgrind reports no errors.
//!
//! Tests of missing programs are skipped with a message; with `CALYX_CI_STRICT=1`, which `.ci/run`
//! sets after installing them, they fail.
#![cfg(unix)]

use calyx::build::{BuildOptions, Emit, build, library};
use calyx_abi::Fingerprint;
use calyx_codegen::{ObjectOptions, compile_object};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-Werror", "-pedantic"];

fn here(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/embed_c").join(path)
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples")
}

/// Returns true if a program is installed, so that the test continues.
fn installed(program: &str) -> bool {
    let answer = Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if answer.is_ok_and(|status| status.success()) {
        return true;
    }
    let why = format!("`{program}` is not installed");
    assert!(std::env::var_os("CALYX_CI_STRICT").is_none_or(|strict| strict != "1"), "{why}");
    // The harness captures the output macros of a passing test, but not direct writes to standard
    // error.
    let _ = std::io::Write::write_all(&mut std::io::stderr(), format!("SKIPPED: {why}\n").as_bytes());
    false
}

/// Runs a command that must succeed.
fn run(command: &mut Command) -> Output {
    let output = command.stdin(Stdio::null()).output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let said = [&output.stdout, &output.stderr].map(|stream| String::from_utf8_lossy(stream));
    assert!(output.status.success(), "{command:?}: {}\n{}{}", output.status, said[0], said[1]);
    output
}

/// Creates a command that runs a program under valgrind, which must find no error and no leak,
/// except memory that running threads still use. Stacks of programs are large, but only reserved.
fn valgrind(program: &Path) -> Command {
    let mut command = Command::new("valgrind");
    command.args(["--quiet", "--error-exitcode=99", "--leak-check=full", "--max-stackframe=300000000"]);
    command.arg("--errors-for-leak-kinds=definite,indirect,possible");
    command.arg(format!("--suppressions={}", here("valgrind.supp").display())).arg(program);
    command
}

/// Builds header and object of a model called `name` in a directory.
fn made(model: &Path, directory: &Path, name: &str) {
    let checked = calyx::check_file(model).unwrap();
    let options = BuildOptions {
        emit: [Emit::Object, Emit::Header].into(),
        ..BuildOptions::executable(directory.join(name))
    };
    build(&checked, &options).unwrap_or_else(|error| panic!("{error}"));
}

/// Builds the interface test with both its models and one that was compiled for another engine.
fn interface() -> (TempDir, PathBuf) {
    let directory = tempfile::tempdir().unwrap();
    let at = |name: &str| directory.path().join(name);
    made(&here("small.cx"), directory.path(), "small");
    made(&examples().join("spur_pair.cx"), directory.path(), "spur_pair");
    let foreign = calyx::check_text("foreign.cx", "print(1);\n").program.unwrap();
    let options = ObjectOptions::new("foreign", "{}", Fingerprint(1));
    fs::write(at("foreign.o"), compile_object(&foreign, &options).unwrap()).unwrap();
    run(Command::new("cc")
        .args(["-std=c99", "-g"])
        .args(STRICT)
        .arg("-I")
        .arg(directory.path())
        .arg(here("interface.c"))
        .args(["small.o", "spur_pair.o", "foreign.o"].map(at))
        .arg(library::find(None, library::Needs::Interface).unwrap())
        .args(["-lm", "-lpthread", "-ldl", "-o"])
        .arg(at("interface")));
    let program = at("interface");
    (directory, program)
}

#[test]
fn headers_are_c_and_cpp() {
    let directory = tempfile::tempdir().unwrap();
    made(&here("small.cx"), directory.path(), "small");
    made(&examples().join("spur_pair.cx"), directory.path(), "spur_pair");
    let compilers: [(&str, &str, &[&str]); 4] = [
        ("cc", "c", &["-std=c99", "-Wstrict-prototypes"]),
        ("cc", "c", &["-std=c17"]),
        ("c++", "c++", &["-std=c++17"]),
        ("c++", "c++", &["-std=c++11"]),
    ];
    for (compiler, language, flags) in compilers {
        if !installed(compiler) {
            continue;
        }
        let source = directory.path().join("both.c");
        fs::write(&source, "#include \"small.h\"\n#include \"spur_pair.h\"\n#include \"small.h\"\n").unwrap();
        run(Command::new(compiler)
            .args(flags)
            .args(STRICT)
            .args(["-fsyntax-only", "-x", language])
            .arg(source));
    }
    let header = fs::read_to_string(directory.path().join("spur_pair.h")).unwrap();
    for part in [
        "/* Spur pair of the report, chapter 5: 20 and 40 teeth, 10 diametral pitch. */\nextern const calyx_model spur_pair_model;",
        "    /* Torque on the pinion.\n       0 lbf*inch .. 5000 lbf*inch; default 1000 lbf*inch. */\n    spur_pair_param_torque = 0,",
        "       TRUE or FALSE; default TRUE. */\n    spur_pair_param_tip_corner_contact = ",
        "whole numbers 2 .. 10000; default 32. */",
        "    /* Largest contact pressure on the flanks, excluding tip edges.\n       In psi. */\n",
    ] {
        assert!(header.contains(part), "{part}\nis not in\n{header}");
    }
}

#[test]
fn the_interface_keeps_its_promises() {
    let (_directory, program) = interface();
    run(Command::new(program).arg("all").env_clear());
}

#[test]
fn valgrind_finds_nothing_in_the_interface() {
    if installed("valgrind") {
        let (_directory, program) = interface();
        run(&mut valgrind(&program));
    }
}

/// Every function in the header is in the library, with C linkage.
#[test]
fn what_the_header_declares_is_there() {
    let declared: Vec<&str> = calyx::rt::c_api::HEADER
        .split([' ', '*', '('])
        .filter(|word| word.starts_with("calyx_") && !word.contains(['<', ')', ';', ',']))
        .collect();
    let functions: Vec<&str> =
        declared.into_iter().filter(|word| calyx::rt::c_api::HEADER.contains(&format!("{word}("))).collect();
    assert!(functions.len() > 25, "{functions:?}");
    let uses = fs::read_to_string(here("interface.c")).unwrap();
    for function in functions {
        assert!(uses.contains(&format!("{function}(")), "interface.c does not use {function}");
    }
}

/// Builds the example by its Makefile in a copy of the directory, after replacing `old => new` for
/// each edit of the model.
fn example(edits: &[(&str, &str)]) -> (TempDir, PathBuf) {
    let directory = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(examples().join("spur_pair.cx")).unwrap();
    let text = edits.iter().fold(text, |text, (old, new)| {
        assert!(text.contains(old), "the example has no `{old}`");
        text.replace(old, new)
    });
    fs::write(directory.path().join("spur_pair.cx"), text).unwrap();
    let folder = directory.path().join("embed-c");
    fs::create_dir(&folder).unwrap();
    for name in ["main.c", "Makefile"] {
        fs::copy(examples().join("embed-c").join(name), folder.join(name)).unwrap();
    }
    run(Command::new("make").arg("-C").arg(&folder).env("CALYX", env!("CARGO_BIN_EXE_calyx")));
    let program = folder.join("pair");
    (directory, program)
}

#[test]
fn the_example_prints_what_its_page_shows() {
    if !installed("make") {
        return;
    }
    let (_directory, program) = example(&[]);
    let output = run(Command::new(program).env_clear());
    let printed = String::from_utf8(output.stdout).unwrap();
    let page = fs::read_to_string(examples().join("embed-c/README.md")).unwrap();
    let shown =
        page.split("```text\n").nth(1).and_then(|text| text.split("```").next()).expect("a block of text");
    assert!(alike(shown, &printed), "the page shows\n{shown}\nand the example prints\n{printed}");
}

/// Returns true if two texts have the same words, and numbers equal within the tolerance for
/// changes of the engine.
fn alike(one: &str, other: &str) -> bool {
    let same = |(one, other): (&str, &str)| match (one.parse::<f64>(), other.parse::<f64>()) {
        (Ok(one), Ok(other)) => (one - other).abs() <= 0.01 * one.abs() + 1e-3,
        _ => one == other,
    };
    let words = [one, other].map(|text| text.split_whitespace().count());
    words[0] == words[1] && one.split_whitespace().zip(other.split_whitespace()).all(same)
}

/// Without meshes and error estimates and with a coarse contact grid: the solution is slow under
/// valgrind and does not concern the interface.
const FAST: [(&str, &str); 2] = [
    ("    fidelity = fidelity,", "    fidelity = \"analytic\", error_estimates = \"none\","),
    ("= tip_corner_contact);", "= tip_corner_contact, contact_cells = 6);"),
];

#[test]
fn valgrind_finds_nothing_in_the_example() {
    if installed("make") && installed("valgrind") {
        let (_directory, program) = example(&FAST);
        run(valgrind(&program).arg("2"));
    }
}
