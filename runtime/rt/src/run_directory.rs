//! Ownership of a results directory: the files that a run wrote, and the process that writes now.
//!
//! A run replaces and removes only files that an earlier run wrote. The file [`MARKER`] lists them:
//! its first line identifies the directory, and each file is listed before it is created.
//! Everything else in the directory belongs to the user. The writing process locks the marker with
//! a lock of the operating system, which is released when the process ends for any reason. After a
//! kill at any moment the marker is readable: lines are appended, and an incomplete last line is
//! ignored.

use calyx_report::directory::SIGNALS;
use calyx_report::former_keys::{self, ResultFile};
use calyx_report::{body_pictures, journal, page, surface_sound, unv, view, vtu};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

mod error;
mod file_names;
mod owner;

pub use error::DirectoryError;
pub use file_names::FILES_OF_A_SWEEP;
use file_names::{FILES_OF_A_RUN, FILES_OF_AN_OPTIMIZATION, FILES_OF_SENSITIVITIES};
pub use owner::utc;

/// File name of the marker.
pub const MARKER: &str = ".calyx-run";
/// Prefix of the marker lines that list a file.
const FILE: &str = "file ";
/// Prefix of the marker lines that describe the writing process.
const OWNER: &str = "locked by ";
/// Number of attempts to lock a marker that other processes remove.
const ATTEMPTS: usize = 100;

/// Kind of results directory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Written by `calyx run` or an executable.
    Run,
    /// Written by `calyx tradeoff`.
    Tradeoff,
    /// Written by `calyx sweep`.
    Sweep,
    /// Written by `calyx optimize`.
    Optimization,
    /// Written by `calyx sensitivities`.
    Sensitivities,
    /// Written by `calyx sound`.
    Sound,
}

impl Kind {
    /// Returns the first line of the marker.
    fn header(self) -> &'static str {
        match self {
            Kind::Run => "Calyx run directory, format 1. A run replaces only the files listed here.\n",
            Kind::Tradeoff => {
                "Calyx tradeoff directory, format 1. `calyx tradeoff` replaces only the files listed here.\n"
            }
            Kind::Sweep => {
                "Calyx sweep directory, format 1. `calyx sweep` replaces only the files listed here.\n"
            }
            Kind::Optimization => {
                "Calyx optimization directory, format 1. `calyx optimize` replaces only the files listed here.\n"
            }
            Kind::Sensitivities => {
                "Calyx sensitivities directory, format 1. `calyx sensitivities` replaces only the files listed here.\n"
            }
            Kind::Sound => {
                "Calyx sound directory, format 1. `calyx sound` replaces only the files listed here.\n"
            }
        }
    }

    /// Returns the file names that are the same for every model. If one of them exists and is not
    /// listed, nothing is written: readers of the directory would mistake it for a result.
    fn fixed_names(self) -> &'static [&'static str] {
        match self {
            Kind::Run => &FILES_OF_A_RUN,
            Kind::Tradeoff => &["tradeoff.csv", "tradeoff.json", "tradeoff.svg", "runs", "structures"],
            Kind::Sweep => &FILES_OF_A_SWEEP,
            Kind::Optimization => &FILES_OF_AN_OPTIMIZATION,
            Kind::Sensitivities => &FILES_OF_SENSITIVITIES,
            Kind::Sound => &surface_sound::FILES,
        }
    }

    /// Returns the folders whose file names depend on the model.
    fn folders(self) -> &'static [&'static str] {
        match self {
            Kind::Run => &[SIGNALS, vtu::FOLDER, unv::FOLDER, body_pictures::FOLDER, view::FOLDER],
            Kind::Tradeoff | Kind::Sweep | Kind::Optimization | Kind::Sensitivities | Kind::Sound => &[],
        }
    }

    /// Returns the names that a version without markers wrote, if the directory has a summary that
    /// only such a version wrote.
    fn names_without_marker(self, directory: &Path) -> Option<BTreeSet<String>> {
        let read = |name: &str| -> Option<Value> {
            serde_json::from_slice(&fs::read(regular(directory.join(name))?).ok()?).ok()
        };
        let has = |summary: &Value, names: &[&str]| {
            summary["calyx"].is_string() && names.iter().all(|name| !summary[*name].is_null())
        };
        let of_a_run = |summary: &Value| {
            has(summary, &["abi", "model", "params"]) && summary["source"]["files"].is_array()
        };
        let mut names = present(self, directory);
        match self {
            Kind::Run => {
                let summary = read("run.json").filter(of_a_run);
                let summary = summary.map(|summary| former_keys::current(ResultFile::Run, summary));
                let begun = || journal::find(directory).ok()?.filter(|found| of_a_run(&found.head));
                if summary.is_none() {
                    regular(journal::path(directory)).and_then(|_| begun())?;
                }
                let signals = summary.iter().flat_map(|summary| summary["signals"].as_array()).flatten();
                let of_signal = |signal: &Value| ["table", "plot"].map(|key| signal[key].clone());
                let listed = signals.flat_map(of_signal);
                names.extend(listed.filter_map(|name| name.as_str().map(str::to_owned)));
                names.extend(vtu::files_in(directory));
            }
            Kind::Tradeoff => {
                read("tradeoff.json").filter(|all| has(all, &["model", "settings", "reference"]))?;
            }
            // All directories of these kinds have a marker.
            Kind::Sweep | Kind::Optimization | Kind::Sensitivities | Kind::Sound => return None,
        }
        names.retain(|name| self.allows(name));
        Some(names)
    }

    /// Returns true if this kind of directory may contain the listed name: a marker from elsewhere
    /// must not list other files.
    fn allows(self, name: &str) -> bool {
        let parts: Vec<Component> = Path::new(name).components().collect();
        match parts[..] {
            [Component::Normal(_)] => self.fixed_names().contains(&name),
            [Component::Normal(folder), Component::Normal(_)] => {
                self.folders().iter().any(|known| folder == *known)
            }
            _ => false,
        }
    }
}

/// A results directory that is locked by this process until the value is dropped.
#[derive(Debug)]
pub struct RunDirectory {
    path: PathBuf,
    kind: Kind,
    /// Allows to replace files that no run wrote.
    force: bool,
    /// True if this process created the directory.
    created: bool,
    /// True if this process created the marker.
    marked: bool,
    marker: Mutex<Marker>,
}

/// A locked marker.
#[derive(Debug)]
struct Marker {
    file: File,
    /// Names that may be replaced.
    owned: BTreeSet<String>,
    /// Subset of `owned` that the file lists.
    listed: BTreeSet<String>,
    /// True if something was removed or listed.
    used: bool,
}

/// Returns the process that writes to a directory; `None` if there is none. Only a directory with
/// an unfinished run is examined, because that needs the lock for a moment.
pub fn writer(directory: &Path) -> Option<String> {
    if !exists(&journal::path(directory)) {
        return None;
    }
    let marker = regular(directory.join(MARKER))?;
    let file = File::open(marker).ok()?;
    match file.try_lock_shared() {
        Err(TryLockError::WouldBlock) => Some(owner::read(&file)),
        _ => None,
    }
}

impl RunDirectory {
    /// Locks a directory for writing, and creates it if it does not exist. Removes and replaces
    /// nothing. With `force`, files of the user with names of results become files of the run.
    ///
    /// # Errors
    /// The directory has files but no marker, and is not one of an older version; files that no run
    /// wrote have names of results; another process writes to it; or it cannot be written.
    pub fn lock(path: &Path, kind: Kind, force: bool) -> Result<RunDirectory, DirectoryError> {
        let unwritable = |error| DirectoryError::Io { path: path.to_owned(), error };
        let mut created = false;
        for _ in 0..ATTEMPTS {
            created |= !path.exists();
            match fs::create_dir_all(path) {
                // Another process has removed the directory between two steps of its creation.
                Err(error) if error.kind() == ErrorKind::AlreadyExists && !exists(path) => continue,
                made => made.map_err(unwritable)?,
            }
            let marker = path.join(MARKER);
            let marked = !exists(&marker);
            // Nothing is written to a directory of the user, not even a temporary marker.
            if marked && !force {
                match contents(path, kind, "") {
                    Ok(Contents::Foreign(_)) if exists(&marker) => continue,
                    Ok(Contents::Foreign(files)) => {
                        return Err(DirectoryError::Foreign { path: path.to_owned(), kind, files });
                    }
                    // Another process has removed the directory that it had created.
                    Err(error) if error.kind() == ErrorKind::NotFound => continue,
                    found => drop(found.map_err(unwritable)?),
                }
            }
            let file = match open(&marker) {
                // Another process has removed the directory that it had created.
                Err(error) if error.kind() == ErrorKind::NotFound => continue,
                Err(error) if error.raw_os_error() == Some(libc::ELOOP) => {
                    return Err(DirectoryError::InTheWay {
                        path: path.to_owned(),
                        files: vec![MARKER.into()],
                    });
                }
                file => file.map_err(unwritable)?,
            };
            match lock_soon(&file) {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    let owner = owner::read(&file);
                    return Err(DirectoryError::InUse { path: path.to_owned(), owner });
                }
                // A file system without locks is accepted.
                Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => {}
                Err(TryLockError::Error(error)) => return Err(unwritable(error)),
            }
            // The process that held the lock may have removed the marker meanwhile.
            if !is_at(&file, &marker) {
                continue;
            }
            return RunDirectory::locked(path, kind, force, (created, marked), file);
        }
        Err(unwritable(ErrorKind::ResourceBusy.into()))
    }

    fn locked(
        path: &Path,
        kind: Kind,
        force: bool,
        (created, mut marked): (bool, bool),
        file: File,
    ) -> Result<RunDirectory, DirectoryError> {
        let unwritable = |error| DirectoryError::Io { path: path.to_owned(), error };
        let text = read(&file).map_err(unwritable)?;
        let contents = contents(path, kind, &text).map_err(unwritable)?;
        if let (Contents::Foreign(files), false) = (&contents, force) {
            return Err(DirectoryError::Foreign { path: path.to_owned(), kind, files: files.clone() });
        }
        let (mut owned, mut listed) = (BTreeSet::new(), BTreeSet::new());
        match contents {
            Contents::Listed(names) => {
                listed.clone_from(&names);
                owned = names;
                let complete = text.rfind('\n').map_or(0, |end| end + 1);
                file.set_len(complete as u64).map_err(unwritable)?;
            }
            Contents::Old(names) => owned = names,
            Contents::Nothing | Contents::Foreign(_) => {}
        }
        let others: Vec<String> =
            present(kind, path).into_iter().filter(|name| !owned.contains(name)).collect();
        if !force && !others.is_empty() {
            return Err(DirectoryError::InTheWay { path: path.to_owned(), files: others });
        }
        if !text.starts_with(kind.header()) {
            marked = true;
            // These files were written by a version without markers.
            let lines: String = owned.iter().map(|name| format!("{FILE}{name}\n")).collect();
            file.set_len(0).map_err(unwritable)?;
            append(&file, &(kind.header().to_owned() + &lines)).map_err(unwritable)?;
            listed.clone_from(&owned);
        }
        // A forced replacement is listed when it happens.
        owned.extend(others);
        append(&file, &owner::line()).map_err(unwritable)?;
        let marker = Mutex::new(Marker { file, owned, listed, used: false });
        Ok(RunDirectory { path: path.to_owned(), kind, force, created, marked, marker })
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Draws the pictures of bodies and generates the report page, lists them as files of the run,
    /// and returns the path of the page.
    ///
    /// # Errors
    /// The page cannot be generated, see [`page::write()`], or there is a page that no run wrote.
    pub fn write_page(&self) -> io::Result<PathBuf> {
        self.draw_pictures()?;
        self.claim_all(page::FILES)?;
        page::write(&self.path)
    }

    /// Draws the pictures of bodies that are not drawn yet.
    ///
    /// # Errors
    /// A file cannot be read or written, or no run wrote it.
    pub fn draw_pictures(&self) -> io::Result<()> {
        self.claim_all(body_pictures::undrawn(&self.path))?;
        body_pictures::draw(&self.path)
    }

    /// Removes the files that an earlier run wrote.
    ///
    /// # Errors
    /// One of them cannot be removed.
    pub fn clear(&self) -> io::Result<()> {
        let mut marker = self.marker();
        let first = FILES_OF_A_RUN.iter().filter(|name| marker.owned.contains(**name));
        let rest = marker.owned.iter().map(String::as_str).filter(|name| !FILES_OF_A_RUN.contains(name));
        // The summary and the journal are removed first: neither may remain when the tables are
        // gone.
        for name in first.copied().chain(rest) {
            if self.is_inside(name) {
                ignore_missing(fs::remove_file(self.path.join(name)))?;
            }
        }
        for folder in self.kind.folders() {
            let below = format!("{folder}/");
            if marker.owned.iter().any(|name| name.starts_with(&below)) {
                // A folder with files of the user remains.
                let _ = fs::remove_dir(self.path.join(folder));
            }
        }
        marker.used = true;
        marker.owned.clear();
        marker.listed.clear();
        marker.file.set_len(self.kind.header().len() as u64)?;
        append(&marker.file, &owner::line())
    }

    /// Lists the files of an earlier run, which this one continues.
    ///
    /// # Errors
    /// The marker cannot be written.
    pub fn keep(&self) -> io::Result<()> {
        let mut marker = self.marker();
        let names: Vec<String> = marker.owned.difference(&marker.listed).cloned().collect();
        names.iter().try_for_each(|name| marker.list(name))
    }

    /// Lists a file, which may then be created or replaced, and returns its path.
    ///
    /// # Errors
    /// A file of this name exists that no run wrote, or the marker cannot be written.
    pub fn claim(&self, name: &str) -> io::Result<PathBuf> {
        let path = self.path.join(name);
        let mut marker = self.marker();
        if marker.listed.contains(name) {
            return Ok(path);
        }
        let foreign = !marker.owned.contains(name) && exists(&path);
        if !self.is_inside(name) || (foreign && !self.force) {
            return Err(io::Error::new(
                ErrorKind::AlreadyExists,
                format!("{name} is there, and no run wrote it"),
            ));
        }
        marker.list(name)?;
        Ok(path)
    }

    /// Removes a file of an earlier run that this one does not write.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn remove_owned(&self, name: &str) -> io::Result<()> {
        let owned = self.marker().owned.contains(name);
        if owned && self.is_inside(name) {
            ignore_missing(fs::remove_file(self.path.join(name)))
        } else {
            Ok(())
        }
    }

    /// Lists several files, see [`RunDirectory::claim`].
    ///
    /// # Errors
    /// As for one.
    pub fn claim_all<N: AsRef<str>>(&self, names: impl IntoIterator<Item = N>) -> io::Result<()> {
        names.into_iter().try_for_each(|name| self.claim(name.as_ref()).map(drop))
    }

    /// Checks a folder of this directory for files of the user.
    ///
    /// # Errors
    /// The folder has files with names that the run may write, and no run wrote them.
    pub fn check_folder(&self, folder: &str, may_write: impl Fn(&str) -> bool) -> Result<(), DirectoryError> {
        let below = self.path.join(folder);
        if self.force || !exists(&below) {
            return Ok(());
        }
        let in_the_way = |files| Err(DirectoryError::InTheWay { path: self.path.clone(), files });
        if !self.is_inside(&format!("{folder}/x")) {
            return in_the_way(vec![folder.to_owned()]);
        }
        let unreadable = |error| DirectoryError::Io { path: below.clone(), error };
        let owned = &self.marker().owned;
        let names = names_in(&below).map_err(unreadable)?.into_iter().filter(|name| may_write(name));
        let files: Vec<String> =
            names.map(|name| format!("{folder}/{name}")).filter(|name| !owned.contains(name)).collect();
        if files.is_empty() { Ok(()) } else { in_the_way(files) }
    }

    /// Returns true if this kind of directory may contain the name and no symbolic link leads it
    /// elsewhere.
    fn is_inside(&self, name: &str) -> bool {
        let folder = name.split_once('/').map(|(folder, _)| self.path.join(folder));
        let is_folder = |folder: &PathBuf| match folder.symlink_metadata() {
            Ok(about) => about.is_dir(),
            Err(error) => error.kind() == ErrorKind::NotFound,
        };
        self.kind.allows(name) && folder.is_none_or(|folder| is_folder(&folder))
    }

    fn marker(&self) -> MutexGuard<'_, Marker> {
        self.marker.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for RunDirectory {
    fn drop(&mut self) {
        let unused = self.marked && !self.marker().used;
        if unused {
            // Nothing was written: restores the initial state of the directory.
            let _ = fs::remove_file(self.path.join(MARKER));
            if self.created {
                let _ = fs::remove_dir(&self.path);
            }
        }
    }
}

impl Marker {
    fn list(&mut self, name: &str) -> io::Result<()> {
        append(&self.file, &format!("{FILE}{name}\n"))?;
        self.used = true;
        self.owned.insert(name.to_owned());
        self.listed.insert(name.to_owned());
        Ok(())
    }
}

/// Contents of a directory.
enum Contents {
    Nothing,
    /// Files that its marker lists, and perhaps others.
    Listed(BTreeSet<String>),
    /// Files of a version without markers, and perhaps others.
    Old(BTreeSet<String>),
    /// Files that no run wrote.
    Foreign(Vec<String>),
}

/// Classifies the contents of a directory with this marker; `marker` is empty if there is none.
fn contents(directory: &Path, kind: Kind, marker: &str) -> io::Result<Contents> {
    if let Some(lines) = marker.strip_prefix(kind.header()) {
        let complete = lines.split_inclusive('\n').filter_map(|line| line.strip_suffix('\n'));
        let names = complete.filter_map(|line| line.strip_prefix(FILE)).filter(|name| kind.allows(name));
        return Ok(Contents::Listed(names.map(str::to_owned).collect()));
    }
    let mut files = names_in(directory)?;
    // A kill may have left a part of the header.
    if kind.header().starts_with(marker) {
        files.retain(|name| name != MARKER);
        if files.is_empty() {
            return Ok(Contents::Nothing);
        }
        if let Some(names) = kind.names_without_marker(directory) {
            return Ok(Contents::Old(names));
        }
    }
    Ok(Contents::Foreign(files))
}

/// Returns the names of the entries of a directory, sorted.
fn names_in(directory: &Path) -> io::Result<Vec<String>> {
    let entries = fs::read_dir(directory)?;
    let names = entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut names = names.collect::<io::Result<Vec<String>>>()?;
    names.sort();
    Ok(names)
}

/// Returns the fixed names that exist in a directory.
fn present(kind: Kind, directory: &Path) -> BTreeSet<String> {
    let names = kind.fixed_names().iter().filter(|name| exists(&directory.join(name)));
    names.map(|name| (*name).to_owned()).collect()
}

fn exists(path: &Path) -> bool {
    path.symlink_metadata().is_ok()
}

/// Returns the path if it is a regular file and no symbolic link.
fn regular(path: PathBuf) -> Option<PathBuf> {
    path.symlink_metadata().is_ok_and(|about| about.is_file()).then_some(path)
}

/// Opens or creates a marker; follows no symbolic link.
fn open(marker: &Path) -> io::Result<File> {
    let flags = libc::O_NOFOLLOW | libc::O_NONBLOCK;
    let file = File::options().read(true).append(true).create(true).custom_flags(flags).open(marker)?;
    match file.metadata()?.is_file() {
        true => Ok(file),
        false => Err(io::Error::new(ErrorKind::InvalidInput, format!("{MARKER} is not a regular file"))),
    }
}

/// Locks a marker. A program that examines the directory has the lock for a moment, see [`writer`].
fn lock_soon(file: &File) -> Result<(), TryLockError> {
    /// Longest time in which such a program releases the lock.
    const MOMENT: Duration = Duration::from_millis(20);
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => {
            std::thread::sleep(MOMENT);
            file.try_lock()
        }
        locked => locked,
    }
}

/// Returns true if an open file is the one at a path.
fn is_at(file: &File, path: &Path) -> bool {
    let identity = |about: fs::Metadata| (about.dev(), about.ino());
    match (file.metadata(), path.symlink_metadata()) {
        (Ok(open), Ok(there)) => identity(open) == identity(there),
        _ => false,
    }
}

/// Maximum length of a marker in bytes: a hundred thousand files.
const LONGEST: u64 = 16 << 20;

fn read(mut file: &File) -> io::Result<String> {
    file.seek(SeekFrom::Start(0))?;
    let mut bytes = Vec::new();
    file.take(LONGEST).read_to_end(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Appends a line by a single write.
fn append(mut file: &File, line: &str) -> io::Result<()> {
    file.write_all(line.as_bytes())
}

fn ignore_missing(removed: io::Result<()>) -> io::Result<()> {
    match removed {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}
