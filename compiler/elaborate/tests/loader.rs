//! Tests of the files that a model may import.
#![cfg(unix)]

use calyx_elaborate::ModelLoader;
use std::path::{Path, PathBuf};

use calyx_lang::check_program;
use std::fs;
use std::os::unix::fs::symlink;

/// Returns the diagnostics of a model that imports `part`, a file that `make` creates.
fn imported(name: &str, make: impl FnOnce(&Path, &Path)) -> Vec<String> {
    imported_with(name, make, |_| Vec::new())
}

/// The same with paths that are allowed, below the folder around that of the model.
fn imported_with(
    name: &str,
    make: impl FnOnce(&Path, &Path),
    allowed: impl FnOnce(&Path) -> Vec<PathBuf>,
) -> Vec<String> {
    let root = std::env::temp_dir().join(format!("calyx-loader-{name}-{}", std::process::id()));
    let folder = root.join("model");
    fs::create_dir_all(folder.join("inside")).unwrap();
    make(&root, &folder);
    let allowed = allowed(&root.canonicalize().unwrap()).into();
    let loader = ModelLoader { folder: Some(folder.clone()), allowed };
    let checked = check_program("model.cx", "import part;\nprint(part.size);\n", &loader);
    fs::remove_dir_all(&root).unwrap();
    checked.diagnostics.iter().map(|found| format!("{} {}", found.code, found.message)).collect()
}

const MODULE: &str = "const size = 1 mm;\n";

#[test]
fn modules_are_regular_files_below_the_models_folder() {
    let inside = imported("inside", |_, folder| {
        fs::write(folder.join("inside/real.cx"), MODULE).unwrap();
        symlink(folder.join("inside/real.cx"), folder.join("part.cx")).unwrap();
    });
    assert_eq!(inside, Vec::<String>::new());
    let outside = imported("outside", |root, folder| {
        fs::write(root.join("secret.cx"), MODULE).unwrap();
        symlink(root.join("secret.cx"), folder.join("part.cx")).unwrap();
    });
    assert!(outside[0].starts_with("E0230") && outside[0].ends_with("leads out of the model's directory"));
    let allowed = imported_with(
        "allowed",
        |root, folder| {
            fs::write(root.join("shared.cx"), MODULE).unwrap();
            symlink(root.join("shared.cx"), folder.join("part.cx")).unwrap();
        },
        |root| vec![root.join("shared.cx")],
    );
    assert_eq!(allowed, Vec::<String>::new());
    let pipe = imported("pipe", |_, folder| {
        let made = std::process::Command::new("mkfifo").arg(folder.join("part.cx")).status();
        assert!(made.is_ok_and(|status| status.success()));
    });
    assert!(pipe[0].starts_with("E0230") && pipe[0].ends_with("it is not a file"), "{pipe:?}");
    let binary = imported("binary", |_, folder| fs::write(folder.join("part.cx"), [0xff, 0xfe]).unwrap());
    assert!(binary[0].starts_with("E0230"), "{binary:?}");
    assert!(imported("none", |_, _| ())[0].starts_with("E0209"));
}
