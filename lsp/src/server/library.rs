//! The library's own source, which is part of the program: shown to clients as read-only files in a cache folder.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};

/// A file of the library.
#[derive(Clone, Debug)]
pub struct LibraryFile {
    /// As imported; of the prelude, whatever.
    pub path: String,
    /// As shown to people: `<library>/gears.cx`.
    pub name: String,
    pub text: String,
}

/// What every model sees and what it may import from anywhere.
#[derive(Clone, Debug)]
pub struct Library {
    prelude: LibraryFile,
    modules: Vec<LibraryFile>,
    /// Where its files are shown to clients; `None` if there is no place for them.
    folder: Option<PathBuf>,
}

impl Library {
    /// A library whose files are shown in a folder of their own below `cache`.
    pub fn new(prelude: LibraryFile, modules: Vec<LibraryFile>, cache: Option<&Path>) -> Library {
        // Another text is another folder: one that a client has open does not change under it.
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

    /// The file that clients know by a path.
    pub fn at(&self, path: &Path) -> Option<&LibraryFile> {
        let folder = self.folder.as_deref()?;
        self.files().find(|file| shown(folder, file).is_some_and(|shown| shown == path))
    }

    /// Where clients find a file by its name, which is written if it is not there.
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

/// Writes a file that nobody is to change, all at once: another server may be writing the same.
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

/// Where programs of this user keep what can be made again.
pub fn cache_folder() -> Option<PathBuf> {
    let absolute = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let folder = absolute("XDG_CACHE_HOME")
        .or_else(|| absolute("LOCALAPPDATA"))
        .or_else(|| absolute("HOME").map(|home| home.join(".cache")))?;
    Some(folder.join("calyx"))
}
