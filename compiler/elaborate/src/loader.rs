//! Where imported modules come from: the library, then files beside the model; or the texts a compiled model brings along.

use calyx_gears::library::{MODULES, PRELUDE};
use calyx_lang::check::Loader;
use calyx_lang::ir::SourceFile;
use std::path::{Path, PathBuf};

/// Finds modules for a model.
pub struct ModelLoader {
    /// The model's folder; `None` for text that is not from a file.
    pub folder: Option<PathBuf>,
}

impl Loader for ModelLoader {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let name = path.join(".");
        if let Some(module) = MODULES.iter().find(|module| module.path == name) {
            return Some((module.file.to_owned(), module.text.to_owned()));
        }
        let file = beside(self.folder.as_deref()?, path);
        let text = std::fs::read_to_string(&file).ok()?;
        Some((file.display().to_string(), text))
    }

    fn names(&self) -> Vec<String> {
        MODULES.iter().map(|module| module.path.to_owned()).collect()
    }

    fn prelude(&self) -> (String, String) {
        (PRELUDE.file.to_owned(), PRELUDE.text.to_owned())
    }
}

/// The file of a module that is not the library's.
fn beside(folder: &Path, path: &[String]) -> PathBuf {
    let mut file = folder.to_path_buf();
    file.extend(path);
    file.set_extension("cx");
    file
}

/// Finds modules among texts that were checked before: the model's first, then those it used, by the names they had.
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
        ModelLoader { folder: None }.names()
    }

    fn prelude(&self) -> (String, String) {
        self.named(PRELUDE.file).unwrap_or_else(|| ModelLoader { folder: None }.prelude())
    }
}
