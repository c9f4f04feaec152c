//! Dependencies between crates point in one direction: every manifest is read, and any other
//! dependency fails. Each of Cranelift, chumsky, salsa, faer and Clarabel is named by one crate
//! only. Every member of the workspace is listed, and every file of tests is run.

use calyx_tests::root;
use std::collections::BTreeSet;

/// Crate, its manifest's folder, and the crates of ours that it may see.
const ALLOWED: &[(&str, &str, &[&str])] = &[
    ("calyx-abi", "runtime/abi", &[]),
    ("calyx-lang", "lang", &["calyx-abi"]),
    ("calyx-symbolic", "compiler/symbolic", &["calyx-abi"]),
    ("calyx-runtime", "runtime", &["calyx-abi"]),
    ("calyx-lower", "compiler/lower", &["calyx-abi", "calyx-lang", "calyx-symbolic"]),
    ("calyx-codegen", "compiler/codegen", &["calyx-abi", "calyx-lang", "calyx-lower", "calyx-symbolic"]),
    ("calyx-gears", "stdlib-gears", &["calyx-abi", "calyx-runtime"]),
    ("calyx-rt", "runtime/rt", &["calyx-abi", "calyx-gears", "calyx-runtime"]),
    (
        "calyx-elaborate",
        "compiler/elaborate",
        &[
            "calyx-abi",
            "calyx-gears",
            "calyx-lang",
            "calyx-lower",
            "calyx-rt",
            "calyx-runtime",
            "calyx-symbolic",
        ],
    ),
    ("calyx-lsp", "lsp", &["calyx-abi", "calyx-elaborate", "calyx-lang"]),
    ("embed-rust", "examples/embed-rust", &["calyx"]),
];

/// Crates of others that only one of ours may name.
const FENCED: &[(&str, &str)] = &[
    ("cranelift", "calyx-codegen"),
    ("chumsky", "calyx-lang"),
    ("ariadne", "calyx-lang"),
    ("salsa", "calyx-lang"),
    ("clarabel", "calyx-runtime"),
    ("faer", "calyx-runtime"),
    ("tokio", "calyx-lsp"),
    ("tower", "calyx-lsp"),
];

/// The names under `[dependencies]` (not `[dev-dependencies]`) of a manifest.
fn dependencies(manifest: &str) -> BTreeSet<String> {
    let mut inside = false;
    let mut names = BTreeSet::new();
    for line in manifest.lines() {
        if line.starts_with('[') {
            inside = line.trim() == "[dependencies]";
        } else if inside {
            let name = line.split(['.', '=', ' ']).next().unwrap_or_default();
            if !name.is_empty() && !name.starts_with('#') {
                names.insert(name.to_owned());
            }
        }
    }
    names
}

fn manifest(folder: &str) -> String {
    std::fs::read_to_string(root().join(folder).join("Cargo.toml")).expect("every crate has a manifest")
}

#[test]
fn dependencies_go_one_way() {
    for (name, folder, allowed) in ALLOWED {
        let ours =
            dependencies(&manifest(folder)).into_iter().filter(|d| d == "calyx" || d.starts_with("calyx-"));
        for dependency in ours {
            assert!(allowed.contains(&dependency.as_str()), "{name} must not depend on {dependency}");
        }
    }
}

#[test]
fn fast_moving_crates_stay_behind_one_of_ours() {
    let others = [("calyx", "compiler", &[][..]), ("calyx-tests", "tests", &[])];
    for (name, folder, _) in ALLOWED.iter().chain(&others) {
        for dependency in dependencies(&manifest(folder)) {
            for (fenced, owner) in FENCED.iter().filter(|(fenced, _)| dependency.starts_with(fenced)) {
                assert_eq!(name, owner, "only {owner} may depend on {fenced}");
            }
        }
    }
}

#[test]
fn every_member_is_listed_here() {
    let workspace = manifest(".");
    let members =
        workspace.split("members = [").nth(1).and_then(|text| text.split(']').next()).expect("members");
    for member in members.split(',').map(|m| m.trim().trim_matches('"')).filter(|m| !m.is_empty()) {
        let known =
            ALLOWED.iter().any(|(_, folder, _)| *folder == member) || ["compiler", "tests"].contains(&member);
        assert!(known, "{member} is not in the table of allowed arrows");
    }
}

/// Where the tests of a crate are one program, a file that it does not name would never run.
#[test]
fn every_file_of_tests_is_run() {
    for folder in ["stdlib-gears", "compiler"] {
        let tests = root().join(folder).join("tests");
        let all = std::fs::read_to_string(tests.join("all.rs")).expect("all.rs names the files");
        let manifest = manifest(folder);
        for entry in std::fs::read_dir(&tests).expect("the folder of tests") {
            let path = entry.expect("an entry").path();
            let is_test = path.extension().is_some_and(|rs| rs == "rs") || path.join("mod.rs").exists();
            let name = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
            let named = all.contains(&format!("\nmod {name};\n"))
                || manifest.contains(&format!("[[test]]\nname = \"{name}\"\n"));
            assert!(!is_test || named, "{folder}/tests/all.rs does not name `{name}`");
        }
    }
}
