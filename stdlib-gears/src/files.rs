//! Files that a model reads. Every function of the library that reads a file uses [`read`], which
//! restricts the location and records the file.

use crate::externs::host;
use calyx_abi::description::{stored_bytes, stored_text};
use calyx_abi::limits::request_memory;
use calyx_abi::{Context, RuntimeError};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Size limit of a file, bytes. The limit suits tables, not hours of measured data.
const LARGEST: u64 = 100 << 20;

/// Remedy for a table that is too large.
const TABLE: &str = "split it, or keep every tenth row";
/// Remedy for a finite-element model that is too large.
const BODY: &str = "coarsen the mesh, or condense the body in the other program";

fn unreadable(path: &str, message: &str, help: &str) -> RuntimeError {
    RuntimeError::new("E0730", format!("`{path}` cannot be read: {message}"), help).of_argument("path")
}

/// Reason why a file cannot be read, with the help text.
pub type Unreadable = (String, &'static str);

/// File that a model has read.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelFile {
    /// Path as the model gives it.
    pub name: String,
    /// Text of the whole file; [`stored_text`] of a binary one.
    pub text: Arc<str>,
}

/// Reads a file of a finite-element model, which may be binary, under the rules of [`read`].
///
/// # Errors
/// The file is not accessible: the reason with the help text. E0707 as an error of its own: the
/// memory limit is reached.
pub fn read_bytes(context: &mut Context, path: &str) -> Result<Result<Vec<u8>, Unreadable>, RuntimeError> {
    if let Some(known) = host(context)?.files.iter().find(|known| known.name == path) {
        return Ok(Ok(stored_bytes(&known.text).into_owned()));
    }
    let stored = context.tables.iter().flat_map(|all| all.iter()).find(|file| file.name == path);
    let text = match stored {
        Some(file) => {
            request_memory(context, file.text.len() as u64)?;
            file.text.clone()
        }
        None => {
            let located = locate_as(context.directory.as_deref(), &context.allowed, path, BODY);
            let (file, size) = match located {
                Ok(found) => found,
                Err((message, help)) if context.tables.is_some() => {
                    return Ok(Err((format!("it does not travel with the program, and {message}"), help)));
                }
                Err(refused) => return Ok(Err(refused)),
            };
            // A binary file takes up to twice its size as text.
            request_memory(context, 3 * size)?;
            match bytes_up_to(&file, size, "export the file again") {
                Ok(bytes) => stored_text(bytes),
                Err(refused) => return Ok(Err(refused)),
            }
        }
    };
    let text: Arc<str> = text.into();
    context.kept_tables = context.kept_tables.saturating_add(text.len() as u64);
    let bytes = stored_bytes(&text).into_owned();
    host(context)?.files.push(ModelFile { name: path.into(), text });
    Ok(Ok(bytes))
}

/// Reads a text file for a function of the library, once in a run: from the files that are stored
/// with the program, or from below the model's directory. `valid_text` is the help if the file is
/// not valid text.
///
/// The file is added to `ModelHost::files`: `run.json` identifies it, a resumed run requires it
/// unchanged, and executables contain it. Its memory is reserved before it is read.
///
/// # Errors
/// E0730: the file is not accessible or is not text. E0707: the memory limit is reached.
pub fn read(context: &mut Context, path: &str, valid_text: &'static str) -> Result<Arc<str>, RuntimeError> {
    if let Some(known) = host(context)?.files.iter().find(|known| known.name == path) {
        return Ok(known.text.clone());
    }
    let text: Arc<str> = text_of(context, path, valid_text)?.into();
    context.kept_tables = context.kept_tables.saturating_add(text.len() as u64);
    host(context)?.files.push(ModelFile { name: path.into(), text: text.clone() });
    Ok(text)
}

/// Text of a file, either stored with the program or read from the disk.
fn text_of(context: &Context, path: &str, valid_text: &'static str) -> Result<String, RuntimeError> {
    if let Some(file) = context.tables.iter().flat_map(|all| all.iter()).find(|file| file.name == path) {
        request_memory(context, file.text.len() as u64)?;
        return Ok(file.text.clone());
    }
    let refused = |(message, help): Unreadable| match context.tables {
        Some(_) => unreadable(path, &format!("it does not travel with the program, and {message}"), help),
        None => unreadable(path, &message, help),
    };
    let (file, size) = locate(context.directory.as_deref(), &context.allowed, path).map_err(refused)?;
    request_memory(context, size)?;
    read_up_to(&file, size, valid_text).map_err(refused)
}

/// Reads the text of a file that a model names, such as a module that it imports. `allowed` are
/// files and directories outside of `directory`, as absolute paths without links. `text` is the
/// help if the file is not valid text.
///
/// # Errors
/// The file is not a regular file below `directory` or `allowed` after all links are resolved, or
/// it cannot be read.
pub fn read_below(
    directory: Option<&Path>,
    allowed: &[PathBuf],
    path: &str,
    text: &'static str,
) -> Result<String, Unreadable> {
    let (file, size) = locate(directory, allowed, path)?;
    read_up_to(&file, size, text)
}

/// Reads at most this number of bytes plus one, because a file may grow after its size was
/// determined.
fn read_up_to(file: &Path, size: u64, text: &'static str) -> Result<String, Unreadable> {
    String::from_utf8(bytes_up_to(file, size, text)?).map_err(|error| (error.to_string(), text))
}

fn bytes_up_to(file: &Path, size: u64, help: &'static str) -> Result<Vec<u8>, Unreadable> {
    let mut content = Vec::new();
    let taken = File::open(file).and_then(|file| file.take(size.saturating_add(1)).read_to_end(&mut content));
    match taken {
        Err(error) => Err((error.to_string(), help)),
        Ok(read) if read as u64 > size => Err(("it grows while it is read".into(), "read a copy of it")),
        Ok(_) => Ok(content),
    }
}

/// Resolves a path to its file and the size in bytes. After all links are resolved, the file must
/// lie below the directory or below one of the allowed paths.
fn locate(directory: Option<&Path>, allowed: &[PathBuf], path: &str) -> Result<(PathBuf, u64), Unreadable> {
    locate_as(directory, allowed, path, TABLE)
}

fn locate_as(
    directory: Option<&Path>,
    allowed: &[PathBuf],
    path: &str,
    smaller: &'static str,
) -> Result<(PathBuf, u64), Unreadable> {
    let below = "files are read from the model's directory and those in it; give a path relative to the model, or \
                 allow others with `--allow-path PATH`";
    let leads_out = || ("it leads out of the model's directory".to_owned(), below);
    let directory =
        directory.ok_or_else(|| ("there is no model file that determines its directory".into(), below))?;
    let (relative, named) = (Path::new(path), directory.join(path));
    let is_allowed = |path: &Path| allowed.iter().any(|place| path.starts_with(place));
    if !relative.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
        // The error does not reveal which files exist elsewhere.
        let parent = named.parent().and_then(|parent| parent.canonicalize().ok());
        let file = named.canonicalize().ok();
        if !parent.as_deref().is_some_and(is_allowed) && !file.as_deref().is_some_and(is_allowed) {
            return Err(leads_out());
        }
    }
    let whole = |path: &Path| path.canonicalize().map_err(|error| (not_in(directory, &error), below));
    let (root, file) = (whole(directory)?, whole(&named)?);
    if !file.starts_with(&root) && !is_allowed(&file) {
        return Err(leads_out());
    }
    let about = file.metadata().map_err(|error| (not_in(directory, &error), below))?;
    if !about.is_file() {
        return Err(("it is not a file".into(), below));
    }
    if about.len() > LARGEST {
        return Err((format!("it is larger than {} MB", LARGEST >> 20), smaller));
    }
    Ok((file, about.len()))
}

fn not_in(directory: &Path, error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound if directory == Path::new(".") => {
            "there is no such file in this directory".into()
        }
        io::ErrorKind::NotFound => format!("there is no such file in {}", directory.display()),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::host::ModelHost;
    use calyx_abi::description::FileDescription;

    #[test]
    fn every_file_that_is_read_is_recorded_once() {
        let folder = std::env::temp_dir().join(format!("calyx-recorded-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("near.csv"), "a\n1\n").unwrap();
        let mut context = Context::new(Box::new(ModelHost::default()));
        context.directory = Some(folder.clone());
        let stored = FileDescription { name: "stored.csv".into(), text: "b\n2\n3\n".into() };
        context.tables = Some(Arc::from([stored]));
        for path in ["near.csv", "stored.csv", "near.csv", "stored.csv"] {
            assert!(read(&mut context, path, "").is_ok(), "{path}");
        }
        assert_eq!(read(&mut context, "none.csv", "").unwrap_err().code, "E0730");
        let files = host(&mut context).unwrap().files.clone();
        let read: Vec<(&str, &str)> = files.iter().map(|file| (file.name.as_str(), &*file.text)).collect();
        assert_eq!(read, [("near.csv", "a\n1\n"), ("stored.csv", "b\n2\n3\n")]);
        assert_eq!(context.kept_tables, 4 + 6);
        std::fs::remove_dir_all(&folder).unwrap();
    }

    /// Binary files are recorded as text, and programs that contain them read the same bytes.
    #[test]
    fn binary_files_travel_with_a_program() {
        let folder = std::env::temp_dir().join(format!("calyx-binary-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let content = [0x50, 0x4b, 0x00, 0xff, 0xc3];
        std::fs::write(folder.join("body.npz"), content).unwrap();
        let mut context = Context::new(Box::new(ModelHost::default()));
        context.directory = Some(folder.clone());
        for _ in 0..2 {
            assert_eq!(read_bytes(&mut context, "body.npz").unwrap().unwrap(), content);
        }
        assert!(read_bytes(&mut context, "none.npz").unwrap().unwrap_err().0.contains("no such file"));
        let files = host(&mut context).unwrap().files.clone();
        assert_eq!(files.len(), 1);
        std::fs::remove_dir_all(&folder).unwrap();
        let stored =
            |file: &ModelFile| FileDescription { name: file.name.clone(), text: file.text.to_string() };
        let mut apart = Context::new(Box::new(ModelHost::default()));
        apart.tables = Some(files.iter().map(stored).collect());
        assert_eq!(read_bytes(&mut apart, "body.npz").unwrap().unwrap(), content);
        assert!(read_bytes(&mut apart, "none.npz").unwrap().unwrap_err().0.contains("does not travel"));
    }

    #[test]
    fn no_other_module_of_the_library_reads_files() {
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let mut folders = vec![source];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if !path.ends_with("files.rs") {
                    let text = std::fs::read_to_string(&path).unwrap();
                    assert!(
                        !text.contains("std::fs"),
                        "{} reads files without `files::read`",
                        path.display()
                    );
                }
            }
        }
    }

    #[test]
    fn files_outside_of_the_models_directory_are_refused() {
        let root = std::env::temp_dir().join(format!("calyx-files-{}", std::process::id()));
        let model = root.join("model");
        std::fs::create_dir_all(model.join("data")).unwrap();
        std::fs::write(model.join("data/inside.csv"), "a\n1\n").unwrap();
        std::fs::write(root.join("outside.csv"), "a\n1\n").unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink(root.join("outside.csv"), model.join("link.csv")).unwrap();
        let tried_with = |allowed: &[PathBuf], path: &str| {
            locate(Some(&model), allowed, path).map_err(|(message, _)| message)
        };
        let tried = |path: &str| tried_with(&[], path);
        assert!(tried("data/inside.csv").is_ok() && tried("./data/inside.csv").is_ok());
        let absolute = root.join("outside.csv");
        for path in ["../outside.csv", "data/../../outside.csv", absolute.to_str().unwrap()] {
            assert!(tried(path).unwrap_err().contains("leads out"), "{path}");
        }
        #[cfg(unix)]
        assert!(tried("link.csv").unwrap_err().contains("leads out"));
        assert!(tried("data").unwrap_err().contains("not a file") && tried("none.csv").is_err());
        assert!(locate(None, &[], "data/inside.csv").is_err());
        // An allowed directory or file is accepted, whichever path leads there.
        let real = root.canonicalize().unwrap();
        for allowed in [real.join("outside.csv"), real.clone()] {
            let allowed = [allowed];
            for path in ["../outside.csv", absolute.to_str().unwrap(), "data/inside.csv"] {
                assert!(tried_with(&allowed, path).is_ok(), "{path}");
            }
            #[cfg(unix)]
            assert!(tried_with(&allowed, "link.csv").is_ok());
            assert!(tried_with(&allowed, "../../etc/passwd").unwrap_err().contains("leads out"));
        }
        let elsewhere = [real.join("model/data")];
        assert!(tried_with(&elsewhere, "../outside.csv").unwrap_err().contains("leads out"));
        assert!(tried_with(std::slice::from_ref(&real), "../none.csv").unwrap_err().contains("no such file"));
        assert!(tried_with(std::slice::from_ref(&real), "../model/data").unwrap_err().contains("not a file"));
        std::fs::remove_dir_all(&root).unwrap();
    }
}
