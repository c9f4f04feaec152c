//! Source of the library, which is part of the executable: shown to clients as read-only files in a
//! cache folder.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};

/// A file of the library.
#[derive(Clone, Debug)]
pub struct LibraryFile {
    /// Dotted path of the module; arbitrary for the prelude.
    pub path: String,
    /// Display name: `<library>/gears.cx`.
    pub name: String,
    pub text: String,
}

/// The prelude, which every model includes, and the modules that all models can import.
#[derive(Clone, Debug)]
pub struct Library {
    prelude: LibraryFile,
    modules: Vec<LibraryFile>,
    /// Folder of the files for clients; `None` if there is no cache folder.
    folder: Option<PathBuf>,
}

impl Library {
    /// Creates a library whose files are in a separate folder below `cache`.
    pub fn new(prelude: LibraryFile, modules: Vec<LibraryFile>, cache: Option<&Path>) -> Library {
        // Each version has its own folder, so that an open file does not change.
        let mut hasher = DefaultHasher::new();
        for file in [&prelude].into_iter().chain(&modules) {
            (&file.name, &file.text).hash(&mut hasher);
        }
        let version = format!("library-{}-{:08x}", env!("CARGO_PKG_VERSION"), hasher.finish() as u32);
        Library { prelude, modules, folder: cache.map(|cache| cache.join(version)) }
    }

    pub fn prelude(&self) -> &LibraryFile {
        &self.prelude
    }

    pub fn modules(&self) -> &[LibraryFile] {
        &self.modules
    }

    pub fn module(&self, path: &str) -> Option<&LibraryFile> {
        self.modules.iter().find(|module| module.path == path)
    }

    fn files(&self) -> impl Iterator<Item = &LibraryFile> {
        [&self.prelude].into_iter().chain(&self.modules)
    }

    /// Returns the file at a path of the cache folder.
    pub fn at(&self, path: &Path) -> Option<&LibraryFile> {
        let folder = self.folder.as_deref()?;
        self.files().find(|file| shown(folder, file).is_some_and(|shown| shown == path))
    }

    /// Returns the path of a file by its name; writes the file if it does not exist.
    pub fn path(&self, name: &str) -> Option<PathBuf> {
        let file = self.files().find(|file| file.name == name)?;
        let path = shown(self.folder.as_deref()?, file)?;
        let there = fs::read(&path).is_ok_and(|text| text == file.text.as_bytes());
        (there || write(&path, &file.text).is_ok()).then_some(path)
    }
}

fn shown(folder: &Path, file: &LibraryFile) -> Option<PathBuf> {
    Some(folder.join(Path::new(&file.name).file_name()?))
}

/// Writes a read-only file atomically: another server may write the same file.
fn write(path: &Path, text: &str) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let fresh = path.with_extension(format!("{}.tmp", std::process::id()));
    fs::write(&fresh, text)?;
    let mut permissions = fs::metadata(&fresh)?.permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&fresh, permissions)?;
    fs::rename(&fresh, path)
}

/// Returns the user's cache folder.
pub fn cache_folder() -> Option<PathBuf> {
    let absolute = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let folder = absolute("XDG_CACHE_HOME")
        .or_else(|| absolute("LOCALAPPDATA"))
        .or_else(|| absolute("HOME").map(|home| home.join(".cache")))?;
    Some(folder.join("calyx"))
}
