//! Where imported modules come from: the library, then files beside the model.

use calyx_gears::library::{MODULES, PRELUDE};
use calyx_lang::check::Loader;
use std::path::PathBuf;

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
        let mut file = self.folder.clone()?;
        file.extend(path);
        file.set_extension("cx");
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
