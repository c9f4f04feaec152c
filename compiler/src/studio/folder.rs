//! The folder `MODEL.cx.studio` next to a model.
//!
//! | File | Content |
//! |---|---|
//! | `run-0001/`, ... | directories of runs, numbered, never replaced |
//! | `run-0001.json`, ... | the start of each run: time, assigned params and settings, planned number of positions, status and messages |
//! | `preview/` | directory of the automatic run, replaced by each one |
//! | `preview.lock` | locked by the studio that writes `preview/`; another studio uses `preview-2/` |
//! | `session.json` | values and settings of the form, selected runs, camera and visibility |

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Suffix of the name of the folder.
pub(crate) const SUFFIX: &str = ".studio";
/// Largest number of studios with automatic runs of one model.
const PREVIEWS: usize = 16;
/// Largest number of runs in a folder.
const MOST_RUNS: usize = 99_999;

/// Returns the folder of a model.
pub(crate) fn of_model(model: &Path) -> PathBuf {
    let mut name: OsString = model.file_name().unwrap_or_default().to_owned();
    name.push(SUFFIX);
    model.with_file_name(name)
}

/// Returns true for the names of directories of runs, `run-0001`.
pub(crate) fn is_run_name(name: &str) -> bool {
    let digits = name.strip_prefix("run-").unwrap_or_default();
    (4..=6).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// Creates the directory of the next run and returns its name. Another studio may create one at the
/// same time.
///
/// # Errors
/// The directory cannot be created.
pub(crate) fn create_run(folder: &Path) -> io::Result<String> {
    fs::create_dir_all(folder)?;
    let names = fs::read_dir(folder)?.flatten().filter_map(|entry| entry.file_name().into_string().ok());
    let numbers = names.filter_map(|name| {
        let name = name.strip_suffix(".json").unwrap_or(&name);
        is_run_name(name).then(|| name["run-".len()..].parse::<usize>().ok()).flatten()
    });
    let mut number = numbers.max().unwrap_or(0) + 1;
    while number <= MOST_RUNS {
        let name = format!("run-{number:04}");
        match fs::create_dir(folder.join(&name)) {
            Ok(()) => return Ok(name),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => number += 1,
            Err(error) => return Err(error),
        }
    }
    Err(io::Error::other("there are too many runs"))
}

/// Directory of automatic runs, used by one studio until this value is dropped.
pub(crate) struct Preview {
    pub directory: PathBuf,
    _lock: File,
}

impl Preview {
    /// Locks the first directory of automatic runs that no other studio uses.
    ///
    /// # Errors
    /// The folder cannot be written, or too many studios show the model.
    pub fn lock(folder: &Path) -> io::Result<Preview> {
        fs::create_dir_all(folder)?;
        for number in 1..=PREVIEWS {
            let name = if number == 1 { "preview".to_owned() } else { format!("preview-{number}") };
            let lock = File::options().append(true).create(true).open(folder.join(format!("{name}.lock")))?;
            match lock.try_lock() {
                Ok(()) => return Ok(Preview { directory: folder.join(name), _lock: lock }),
                Err(TryLockError::WouldBlock) => {}
                // A file system without locks is accepted.
                Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => {
                    return Ok(Preview { directory: folder.join(name), _lock: lock });
                }
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
        Err(io::Error::other("too many studios show this model"))
    }
}

/// Replaces a file as a whole: a reader sees the earlier or the later content.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn replace(path: &Path, text: &[u8]) -> io::Result<()> {
    use std::sync::atomic::{AtomicU64, Ordering};
    /// Distinguishes files that this process writes at the same time.
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}-{count}.part", std::process::id()));
    let unfinished = path.with_file_name(name);
    let written = File::create(&unfinished)
        .and_then(|mut file| file.write_all(text).and_then(|()| file.sync_data()))
        .and_then(|()| fs::rename(&unfinished, path));
    if written.is_err() {
        let _ = fs::remove_file(&unfinished);
    }
    written
}
