//! Structures on disk: one file each, named by its key, so that later runs of a model reuse them.
//!
//! A file is written under a temporary name and renamed when it is complete, so a reader finds all
//! of it or none. Readers verify a hash of the content. A file that is damaged or of another
//! version or origin is ignored and replaced by the next write. If the store is too large, one
//! process at a time removes the least recently used files.
//!
//! The store is optional: a full or missing disk makes analyses slower but never makes them fail.

use super::Key;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::SystemTime;
use twox_hash::XxHash3_128;

/// Start of a file. The last byte is the version of the layout: this, the key, the hash of the
/// content, the content.
const MAGIC: [u8; 16] = *b"calyx structure\x03";
const HEADER: usize = MAGIC.len() + 32 + size_of::<u128>();
const WHOLE: &str = "structure";
const PARTIAL: &str = "partial";
const LOCK: &str = "lock";

/// Returns a hash that detects damage. Structures have hundreds of megabytes, and a cryptographic
/// hash would take longer than reading them.
fn hash_of(content: &[u8]) -> [u8; size_of::<u128>()] {
    XxHash3_128::oneshot(content).to_be_bytes()
}

/// Directory of structures with a limit on its size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Store {
    directory: PathBuf,
    limit: u64,
}

impl Store {
    /// Creates a store of at most `limit` bytes in this directory, which is created when needed.
    /// Does not access the disk yet.
    pub fn new(directory: impl Into<PathBuf>, limit: u64) -> Self {
        Self { directory: directory.into(), limit }
    }

    /// Returns the directory of the files.
    pub fn directory(&self) -> &Path {
        &self.directory
    }

    /// Returns the content for a key, if it exists and is valid.
    pub fn read(&self, key: &Key) -> Option<Vec<u8>> {
        let mut file = File::open(self.path(key)).ok()?;
        let mut header = [0; HEADER];
        file.read_exact(&mut header).ok()?;
        let (magic, rest) = header.split_at(MAGIC.len());
        let (of_key, hash) = rest.split_at(32);
        if magic != MAGIC || of_key != key.bytes() {
            return None;
        }
        let mut content = Vec::new();
        file.read_to_end(&mut content).ok()?;
        if hash_of(&content) != hash {
            return None;
        }
        // Mark the file as used. Without the permission, the file may be evicted and written again.
        let _ = file.set_modified(SystemTime::now());
        Some(content)
    }

    /// Writes the content for a key if it fits.
    pub fn write(&self, key: &Key, content: &[u8]) {
        if (HEADER + content.len()) as u64 <= self.limit {
            // Errors are ignored, see the module.
            let _ = self.try_write(key, content);
        }
    }

    fn try_write(&self, key: &Key, content: &[u8]) -> io::Result<()> {
        static WRITTEN: AtomicU64 = AtomicU64::new(0);
        fs::create_dir_all(&self.directory)?;
        let number = WRITTEN.fetch_add(1, Ordering::Relaxed);
        let partial = self.directory.join(format!("{key:?}-{}-{number}.{PARTIAL}", std::process::id()));
        let written = File::create_new(&partial).and_then(|mut file| {
            file.write_all(&MAGIC)?;
            file.write_all(key.bytes())?;
            file.write_all(&hash_of(content))?;
            file.write_all(content)
        });
        let lock = File::options().create(true).append(true).open(self.directory.join(LOCK));
        let placed = written.and(lock).and_then(|lock| {
            lock.lock()?;
            fs::rename(&partial, self.path(key))?;
            self.shrink()
        });
        if placed.is_err() {
            // The file has been renamed already, or is not needed.
            let _ = fs::remove_file(&partial);
        }
        placed
    }

    /// Removes the least recently used files until the rest fits. Other files are left alone.
    fn shrink(&self) -> io::Result<()> {
        let ours = |path: &Path| {
            let name = path.file_name().and_then(|name| name.to_str());
            name.is_some_and(|name| name != LOCK && is_name_of_a_store(name))
        };
        let mut files: Vec<(SystemTime, PathBuf, u64)> = fs::read_dir(&self.directory)?
            .flatten()
            .filter(|entry| ours(&entry.path()))
            .filter_map(|entry| {
                let about = entry.metadata().ok()?;
                Some((about.modified().ok()?, entry.path(), about.len()))
            })
            .collect();
        files.sort();
        let mut total: u64 = files.iter().map(|(_, _, size)| size).sum();
        for (_, path, size) in files {
            if total <= self.limit {
                break;
            }
            // A reader in another process keeps its open file.
            if fs::remove_file(&path).is_ok() {
                total -= size;
            }
        }
        Ok(())
    }

    /// Removes the files of this store, and its directory if it is empty then.
    ///
    /// # Errors
    /// A file cannot be removed.
    pub fn clear(&self) -> io::Result<()> {
        let ignore_missing = |removed: io::Result<()>| match removed {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        };
        let entries = match fs::read_dir(&self.directory) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
            entries => entries?,
        };
        for entry in entries {
            let entry = entry?;
            if entry.file_name().to_str().is_some_and(is_name_of_a_store) {
                ignore_missing(fs::remove_file(entry.path()))?;
            }
        }
        // Fails if the directory contains other files; then it remains.
        let _ = fs::remove_dir(&self.directory);
        Ok(())
    }

    fn path(&self, key: &Key) -> PathBuf {
        self.directory.join(format!("{key:?}.{WHOLE}"))
    }
}

/// Returns whether a file has the name of a structure, complete or partial, or of the lock.
fn is_name_of_a_store(name: &str) -> bool {
    let Some((stem, ending)) = name.rsplit_once('.') else { return name == LOCK };
    let key = if ending == PARTIAL { stem.split('-').next().unwrap_or_default() } else { stem };
    [WHOLE, PARTIAL].contains(&ending) && key.len() == 64 && key.bytes().all(|byte| byte.is_ascii_hexdigit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    fn key(number: u64) -> Key {
        Key::of("test").count(number).finish()
    }

    fn files(directory: &Path) -> Vec<PathBuf> {
        let mut files: Vec<PathBuf> =
            fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        files
    }

    #[test]
    fn what_was_written_is_read_by_any_store_of_the_directory() {
        let folder = tempfile::tempdir().unwrap();
        let directory = folder.path().join("made/when/needed");
        let store = Store::new(&directory, 1 << 20);
        assert_eq!(store.read(&key(1)), None);
        store.write(&key(1), b"first");
        store.write(&key(2), b"");
        store.write(&key(1), b"second");
        let other = Store::new(&directory, 1 << 20);
        assert_eq!(other.read(&key(1)).as_deref(), Some(&b"second"[..]));
        assert_eq!(other.read(&key(2)).as_deref(), Some(&b""[..]));
        assert_eq!(other.read(&key(3)), None);
        // Two structures and the lock; no partial file remains.
        assert_eq!(files(&directory).len(), 3);
    }

    #[test]
    fn damaged_and_foreign_files_count_as_none_and_are_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let store = Store::new(folder.path(), 1 << 20);
        store.write(&key(1), b"content");
        let path = store.path(&key(1));
        let sound = fs::read(&path).unwrap();
        for place in 0..sound.len() {
            let mut bytes = sound.clone();
            bytes[place] ^= 1;
            fs::write(&path, bytes).unwrap();
            assert_eq!(store.read(&key(1)), None, "byte {place}");
        }
        for length in 0..sound.len() {
            fs::write(&path, &sound[..length]).unwrap();
            assert_eq!(store.read(&key(1)), None, "length {length}");
        }
        // File of another key.
        fs::write(store.path(&key(2)), &sound).unwrap();
        assert_eq!(store.read(&key(2)), None);
        store.write(&key(1), b"content");
        assert_eq!(fs::read(&path).unwrap(), sound);
    }

    #[test]
    fn what_was_used_least_recently_goes_first_and_what_is_not_ours_stays() {
        let folder = tempfile::tempdir().unwrap();
        let content = [7; 100];
        let size = (HEADER + content.len()) as u64;
        let store = Store::new(folder.path(), 3 * size);
        for name in ["letter.txt", "house.structure", "work.partial"] {
            fs::write(folder.path().join(name), [0; 4096]).unwrap();
        }
        for number in 0..3 {
            store.write(&key(number), &content);
            // Set an earlier time of modification.
            let age = Duration::from_secs(100 - number);
            let file = File::options().append(true).open(store.path(&key(number))).unwrap();
            file.set_modified(SystemTime::now() - age).unwrap();
        }
        assert!(store.read(&key(0)).is_some());
        store.write(&key(3), &content);
        let there: Vec<bool> = (0..4).map(|number| store.path(&key(number)).exists()).collect();
        assert_eq!(there, [true, false, true, true]);
        // Content beyond the limit is not written and evicts nothing.
        store.write(&key(4), &[0; 1000]);
        assert!(store.read(&key(4)).is_none() && store.read(&key(3)).is_some());
        assert!(folder.path().join("letter.txt").exists());
    }

    #[test]
    fn a_place_that_cannot_be_written_keeps_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        let store = Store::new(file.join("below"), 1 << 20);
        store.write(&key(1), b"content");
        assert_eq!(store.read(&key(1)), None);
    }

    #[test]
    fn many_writers_leave_whole_files_within_the_bound() {
        let folder = tempfile::tempdir().unwrap();
        let content = vec![3; 10_000];
        let limit = 4 * (HEADER + content.len()) as u64;
        std::thread::scope(|scope| {
            for writer in 0..4 {
                let (directory, content) = (folder.path(), &content);
                scope.spawn(move || {
                    let store = Store::new(directory, limit);
                    for number in 0..10 {
                        store.write(&key((writer + number) % 6), content);
                        if let Some(read) = store.read(&key(number % 6)) {
                            assert_eq!(&read, content);
                        }
                    }
                });
            }
        });
        let whole = files(folder.path()).into_iter().filter(|path| path.extension().is_some());
        let sizes: Vec<u64> = whole.map(|path| path.metadata().unwrap().len()).collect();
        assert!(!sizes.is_empty() && sizes.iter().sum::<u64>() <= limit, "{sizes:?}");
    }

    #[test]
    fn a_cleared_store_leaves_files_of_others() {
        let folder = tempfile::tempdir().unwrap();
        let store = Store::new(folder.path().join("structures"), 1 << 20);
        store.clear().unwrap();
        store.write(&key(1), b"content");
        store.clear().unwrap();
        assert!(!store.directory().exists());
        store.write(&key(1), b"content");
        let own = store.directory().join("house.structure");
        fs::write(&own, "plan").unwrap();
        store.clear().unwrap();
        assert_eq!(files(store.directory()), [own]);
    }
}
