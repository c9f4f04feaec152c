//! Checks of the dependency structure. The manifest of every crate may contain only the permitted
//! dependencies. The modules of each engine crate and the top-level modules of the language must
//! have no dependency cycles, according to the paths in their source. Only selected crates may use
//! Cranelift, chumsky, salsa, faer and Clarabel. Every member of the workspace is listed, and every
//! test file and unit test is run.

use calyx_tests::modules::Modules;
use calyx_tests::root;
use std::collections::BTreeSet;
use std::path::Path;

/// Crate, directory of its manifest, and the workspace crates that it may depend on.
const ALLOWED: &[(&str, &str, &[&str])] = &[
    ("calyx-abi", "runtime/abi", &[]),
    ("calyx-lang", "lang", &["calyx-abi"]),
    ("calyx-symbolic", "compiler/symbolic", &["calyx-abi"]),
    ("calyx-numerics", "runtime/numerics", &[]),
    ("calyx-fe", "runtime/fe", &["calyx-numerics"]),
    ("calyx-elastic", "runtime/elastic", &["calyx-fe", "calyx-numerics"]),
    ("calyx-rolling", "runtime/rolling", &["calyx-numerics"]),
    ("calyx-acoustics", "runtime/acoustics", &["calyx-numerics"]),
    ("calyx-structure", "runtime/structure", &["calyx-fe", "calyx-numerics"]),
    ("calyx-contact", "runtime/contact", &["calyx-numerics", "calyx-structure"]),
    (
        "calyx-model",
        "runtime/model",
        &[
            "calyx-abi",
            "calyx-contact",
            "calyx-elastic",
            "calyx-fe",
            "calyx-numerics",
            "calyx-rolling",
            "calyx-structure",
        ],
    ),
    (
        "calyx-solve",
        "runtime/solve",
        &["calyx-contact", "calyx-fe", "calyx-model", "calyx-numerics", "calyx-structure"],
    ),
    (
        "calyx-analysis",
        "runtime/analysis",
        &[
            "calyx-acoustics",
            "calyx-contact",
            "calyx-elastic",
            "calyx-fe",
            "calyx-model",
            "calyx-numerics",
            "calyx-rolling",
            "calyx-solve",
            "calyx-structure",
        ],
    ),
    (
        "calyx-runtime",
        "runtime",
        &[
            "calyx-acoustics",
            "calyx-analysis",
            "calyx-contact",
            "calyx-elastic",
            "calyx-fe",
            "calyx-model",
            "calyx-numerics",
            "calyx-rolling",
            "calyx-solve",
            "calyx-structure",
        ],
    ),
    ("calyx-lower", "compiler/lower", &["calyx-abi", "calyx-lang", "calyx-symbolic"]),
    ("calyx-codegen", "compiler/codegen", &["calyx-abi", "calyx-lang", "calyx-lower", "calyx-symbolic"]),
    ("calyx-gears", "stdlib-gears", &["calyx-abi", "calyx-runtime"]),
    ("calyx-view", "runtime/view", &["calyx-runtime"]),
    ("calyx-report", "runtime/report", &["calyx-abi", "calyx-runtime", "calyx-view"]),
    ("calyx-rt", "runtime/rt", &["calyx-abi", "calyx-gears", "calyx-report", "calyx-runtime"]),
    (
        "calyx-elaborate",
        "compiler/elaborate",
        &[
            "calyx-abi",
            "calyx-gears",
            "calyx-lang",
            "calyx-lower",
            "calyx-report",
            "calyx-rt",
            "calyx-runtime",
            "calyx-symbolic",
        ],
    ),
    ("calyx-lsp", "lsp", &["calyx-abi", "calyx-elaborate", "calyx-lang"]),
    ("embed-rust", "examples/embed-rust", &["calyx"]),
    ("calyx-python", "compiler/python", &["calyx", "calyx-abi", "calyx-runtime"]),
];

/// Crates of the engine behind its facade. Only they may use dense and sparse matrices.
const NUMERICAL: &[&str] = &[
    "calyx-numerics",
    "calyx-fe",
    "calyx-elastic",
    "calyx-rolling",
    "calyx-acoustics",
    "calyx-structure",
    "calyx-contact",
    "calyx-model",
    "calyx-solve",
    "calyx-analysis",
];

/// External crates that only these workspace crates may use.
const FENCED: &[(&str, &[&str])] = &[
    ("cranelift", &["calyx-codegen"]),
    ("chumsky", &["calyx-lang"]),
    ("ariadne", &["calyx-lang"]),
    ("salsa", &["calyx-lang"]),
    ("clarabel", &["calyx-contact"]),
    ("faer", NUMERICAL),
    ("axum", &["calyx"]),
    ("tokio", &["calyx", "calyx-lsp"]),
    ("tower", &["calyx-lsp"]),
    ("pyo3", &["calyx-python"]),
];

/// Returns the names under `[dependencies]` (not `[dev-dependencies]`) of a manifest.
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

/// The engine may move a module from one of its crates to another if no crate above names them.
#[test]
fn crates_above_the_engine_use_its_facade() {
    let others = [("calyx", "compiler", &[][..]), ("calyx-tests", "tests", &[])];
    let is_inner = |name: &str| NUMERICAL.contains(&name);
    for (name, folder, _) in ALLOWED.iter().chain(&others) {
        if is_inner(name) || *name == "calyx-runtime" {
            continue;
        }
        let inner = dependencies(&manifest(folder)).into_iter().find(|dependency| is_inner(dependency));
        assert!(inner.is_none(), "{name} must use calyx-runtime instead of {inner:?}");
    }
}

/// Returns the directories of the engine crates.
fn engine() -> impl Iterator<Item = &'static str> {
    let folders = ALLOWED.iter().map(|(_, folder, _)| *folder);
    folders.filter(|folder| folder.starts_with("runtime") && !["runtime/abi", "runtime/rt"].contains(folder))
}

#[test]
fn modules_of_the_engine_name_each_other_one_way() {
    let circles: Vec<String> = engine()
        .flat_map(|folder| {
            let circles = Modules::of(&root().join(folder).join("src")).circles();
            circles.into_iter().map(move |circle| format!("{folder}: {circle}"))
        })
        .collect();
    assert!(circles.is_empty(), "modules that need each other:\n{}", circles.join("\n"));
}

/// The database uses the checker, and the checker does not use the database. Modules within the
/// checker implement one type together, so they may use each other.
#[test]
fn stages_of_the_language_name_each_other_one_way() {
    let circles = Modules::of(&root().join("lang/src")).circles();
    let stages: Vec<&String> = circles.iter().filter(|circle| circle.starts_with(':')).collect();
    assert!(stages.is_empty(), "top-level modules of lang that need each other: {stages:?}");
}

/// Every module may use an item in the root of a crate, and the item may use every module.
#[test]
fn roots_of_the_engine_define_nothing() {
    for folder in engine() {
        let modules = Modules::of(&root().join(folder).join("src"));
        let items = modules.items_of_root();
        assert!(items.is_empty(), "{folder}/src/lib.rs defines {items:?}: put them into a module");
    }
}

#[test]
fn fenced_crates_stay_behind_few_of_ours() {
    let others = [("calyx", "compiler", &[][..]), ("calyx-tests", "tests", &[])];
    for (name, folder, _) in ALLOWED.iter().chain(&others) {
        for dependency in dependencies(&manifest(folder)) {
            for (fenced, owners) in FENCED.iter().filter(|(fenced, _)| dependency.starts_with(fenced)) {
                assert!(
                    owners.contains(name),
                    "{name} may not depend on {fenced}, which only {owners:?} may"
                );
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

/// If the tests of a crate form one program, a file that it does not list would never run.
#[test]
fn every_file_of_tests_is_run() {
    for folder in ALLOWED.iter().map(|(_, folder, _)| *folder).chain(["compiler", "tests"]) {
        let tests = root().join(folder).join("tests");
        if !tests.join("all.rs").exists() {
            continue;
        }
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

/// Unit tests of a library without a test program (`test = false`) would never run.
#[test]
fn every_unit_test_is_run() {
    for folder in ALLOWED.iter().map(|(_, folder, _)| *folder).chain(["compiler", "tests"]) {
        let manifest = manifest(folder);
        let library = manifest.split("\n[").find(|section| section.starts_with("lib]"));
        if library.is_some_and(|section| section.contains("\ntest = false")) {
            refuse_unit_tests(&root().join(folder).join("src"));
        }
    }
}

fn refuse_unit_tests(folder: &Path) {
    for entry in std::fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            refuse_unit_tests(&path);
        } else {
            let text = std::fs::read_to_string(&path).expect("a source");
            assert!(!text.contains("#[cfg(test)]"), "the tests in {} never run", path.display());
        }
    }
}
