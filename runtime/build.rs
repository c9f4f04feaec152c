//! Gives a crate a fingerprint of its own source. It is part of the key of stored structures, so a
//! structure is reused only by the source that computed it. All crates of the engine and
//! `calyx-gears` have one.

use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::{fs, io};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=src");
    let mut files = BTreeSet::new();
    collect(Path::new("src"), &mut files)?;
    let mut hash = DefaultHasher::new();
    for path in files {
        path.hash(&mut hash);
        fs::read(path)?.hash(&mut hash);
    }
    println!("cargo::rustc-env=CALYX_SOURCE={:016x}", hash.finish());
    Ok(())
}

fn collect(directory: &Path, files: &mut BTreeSet<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(directory)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else {
            files.insert(path);
        }
    }
    Ok(())
}
