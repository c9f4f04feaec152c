//! Loaders of imported modules: from the library and the model's folder, or from the sources stored
//! in a compiled model.

use calyx_gears::files::read_below;
use calyx_gears::library::{MODULES, PRELUDE};
use calyx_lang::check::Loader;
use calyx_lang::ir::SourceFile;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Loads modules from the library and from the model's folder.
#[derive(Clone, Debug, Default)]
pub struct ModelLoader {
    /// The model's folder; `None` for text that is not from a file.
    pub folder: Option<PathBuf>,
    /// Files and directories outside of the folder that the model may read, see [`allowed_path`].
    pub allowed: Arc<[PathBuf]>,
}

/// A path that a user allows models to read: absolute, without links, so that it means one file or
/// directory.
///
/// # Errors
/// Says why there is no such file or directory.
pub fn allowed_path(path: &str) -> Result<PathBuf, String> {
    Path::new(path).canonicalize().map_err(|error| error.to_string())
}

impl Loader for ModelLoader {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let name = path.join(".");
        if let Some(module) = MODULES.iter().find(|module| module.path == name) {
            return Some((module.file.to_owned(), module.text.to_owned()));
        }
        let folder = self.folder.as_deref()?;
        let text = read_module(folder, &self.allowed, path).ok()??;
        Some((beside(folder, path).display().to_string(), text))
    }

    fn refusal(&self, path: &[String]) -> Option<String> {
        read_module(self.folder.as_deref()?, &self.allowed, path).err()
    }

    fn names(&self) -> Vec<String> {
        MODULES.iter().map(|module| module.path.to_owned()).collect()
    }

    fn prelude(&self) -> (String, String) {
        (PRELUDE.file.to_owned(), PRELUDE.text.to_owned())
    }

    fn is_sound(&self, path: &[String]) -> bool {
        is_of_library(path)
    }

    fn allowed(&self) -> Arc<[PathBuf]> {
        self.allowed.clone()
    }
}

/// Returns `true` for the prelude and the modules of the library, which tests check.
fn is_of_library(path: &[String]) -> bool {
    path.is_empty() || MODULES.iter().any(|module| module.path == path.join("."))
}

/// Returns the text of a module in a file below a model's folder; `None` if the file does not
/// exist.
///
/// As for `read_table`, the module must be a regular file below the folder or an allowed path,
/// after symbolic links are resolved.
///
/// # Errors
/// The reason why an existing file cannot be read.
pub fn read_module(folder: &Path, allowed: &[PathBuf], path: &[String]) -> Result<Option<String>, String> {
    let relative = beside(Path::new(""), path);
    // An empty path is the working directory.
    let folder = if folder == Path::new("") { Path::new(".") } else { folder };
    if std::fs::symlink_metadata(folder.join(&relative)).is_err() {
        return Ok(None);
    }
    match read_below(Some(folder), allowed, &relative.to_string_lossy(), "") {
        Ok(text) => Ok(Some(text)),
        Err((message, _)) => Err(message),
    }
}

/// Returns the path of a module that is not part of the library.
fn beside(folder: &Path, path: &[String]) -> PathBuf {
    let mut file = folder.to_path_buf();
    file.extend(path);
    file.set_extension("cx");
    file
}

/// Loads modules from texts that were checked before: the model's own first, then the imported
/// ones, by the names they had.
pub struct TextLoader<'a>(pub &'a [SourceFile]);

impl TextLoader<'_> {
    fn named(&self, name: &str) -> Option<(String, String)> {
        let file = self.0.iter().find(|file| file.name == name)?;
        Some((file.name.clone(), file.text.clone()))
    }
}

impl Loader for TextLoader<'_> {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let name = path.join(".");
        if let Some(module) = MODULES.iter().find(|module| module.path == name) {
            return self.named(module.file);
        }
        let folder = Path::new(&self.0.first()?.name).parent()?;
        self.named(&beside(folder, path).display().to_string())
    }

    fn names(&self) -> Vec<String> {
        ModelLoader::default().names()
    }

    fn prelude(&self) -> (String, String) {
        self.named(PRELUDE.file).unwrap_or_else(|| ModelLoader::default().prelude())
    }

    fn is_sound(&self, path: &[String]) -> bool {
        is_of_library(path)
    }
}
