//! The model that the studio shows: checked when its files change.

use super::form;
use crate::{Checked, check_file_allowing};
use calyx_abi::description::ModelDescription;
use calyx_abi::visible::visible;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::SourceFile;
use calyx_lang::render::{Colour, Renderer, to_json};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// Prefix of the names of library files.
const LIBRARY: &str = calyx_abi::description::LIBRARY;
/// Largest number of diagnostics that are shown.
const MOST_SHOWN: usize = 200;

/// A model and its last check.
pub(crate) struct Model {
    path: PathBuf,
    allowed: Arc<[PathBuf]>,
    checked: Mutex<Option<Arc<Snapshot>>>,
}

/// A model as its files were at one time, with the defaults of its params.
pub(crate) struct Snapshot {
    /// Changes with the files.
    pub version: String,
    /// Description; without params if the model has errors of the language.
    pub description: ModelDescription,
    /// The model as JSON.
    pub json: Value,
    files: Vec<PathBuf>,
}

impl Model {
    pub fn new(path: PathBuf, allowed: Arc<[PathBuf]>) -> Model {
        Model { path, allowed, checked: Mutex::new(None) }
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    pub fn allowed(&self) -> &Arc<[PathBuf]> {
        &self.allowed
    }

    /// Returns the model as its files are now. Blocks while it is checked.
    pub fn now(&self) -> Arc<Snapshot> {
        // Requests at the same time wait for one check.
        let mut checked = self.checked.lock().unwrap_or_else(PoisonError::into_inner);
        match checked.as_ref().filter(|snapshot| snapshot.version == version(&snapshot.files)) {
            Some(snapshot) => snapshot.clone(),
            None => checked.insert(Arc::new(self.check())).clone(),
        }
    }

    fn check(&self) -> Snapshot {
        let before = version(std::slice::from_ref(&self.path));
        let outcome = check_file_allowing(&self.path, &self.allowed);
        let unchanged = before == version(std::slice::from_ref(&self.path));
        let files = outcome.as_ref().map_or_else(|_| Vec::new(), |checked| self.files(checked));
        let files = if files.is_empty() { vec![self.path.clone()] } else { files };
        // A file that changed during the check has a version that is never current.
        let version = if unchanged { version(&files) } else { format!("changed after {before}") };
        let (json, description) = match outcome {
            Ok(checked) => (self.json(&version, &checked), checked.description),
            Err(error) => (self.unreadable(&version, &error), ModelDescription::default()),
        };
        Snapshot { version, description, json, files }
    }

    /// Returns the files of the user that the model consists of.
    fn files(&self, checked: &Checked) -> Vec<PathBuf> {
        let directory = self.path.parent().unwrap_or(Path::new(""));
        let sources = checked.files.iter().map(|file| &file.name).filter(|name| !name.starts_with(LIBRARY));
        let tables = checked.description.tables.iter().map(|file| &file.name);
        let path_of = |name: &String| match directory.join(name) {
            inside if inside.exists() => inside,
            _ => PathBuf::from(name),
        };
        std::iter::once(self.path.clone()).chain(sources.skip(1).chain(tables).map(path_of)).collect()
    }

    fn json(&self, version: &str, checked: &Checked) -> Value {
        let description = &checked.description;
        json!({
            "version": version,
            "model": self.path.display().to_string(),
            "doc": description.doc,
            "units": description.units,
            "calyx": env!("CARGO_PKG_VERSION"),
            "broken": checked.program.is_none(),
            "params": form::params(description),
            "outputs": form::outputs(description),
            "diagnostics": diagnostics(&checked.diagnostics, &checked.files),
            "rendered": rendered(&checked.diagnostics, &checked.files),
        })
    }

    fn unreadable(&self, version: &str, error: &io::Error) -> Value {
        json!({
            "version": version,
            "model": self.path.display().to_string(),
            "doc": "",
            "units": "",
            "calyx": env!("CARGO_PKG_VERSION"),
            "broken": true,
            "params": [],
            "outputs": [],
            "diagnostics": [],
            "rendered": format!("error: cannot read {}: {error}\n", visible(&self.path.display().to_string())),
        })
    }
}

/// Returns the hash of the text of a model, as in `run.json`; `None` if the file cannot be read.
pub(crate) fn hash_of(model: &Path) -> Option<String> {
    let text = std::fs::read(model).ok()?;
    Some(Sha256::digest(text).iter().fold(String::new(), |hash, byte| hash + &format!("{byte:02x}")))
}

/// Returns a text that changes if one of the files is written, replaced, created or removed.
fn version(files: &[PathBuf]) -> String {
    let mut hasher = DefaultHasher::new();
    for file in files {
        let about = std::fs::metadata(file).ok();
        file.hash(&mut hasher);
        about.as_ref().map(|about| (about.len(), about.modified().ok())).hash(&mut hasher);
    }
    format!("{:016x}", hasher.finish())
}

/// Returns diagnostics as JSON objects.
pub(crate) fn diagnostics(found: &[Diagnostic], files: &[SourceFile]) -> Vec<Value> {
    let shown = in_order(found).take(MOST_SHOWN);
    shown.filter_map(|diagnostic| serde_json::from_str(&to_json(diagnostic, files)).ok()).collect()
}

/// Returns diagnostics as text with excerpts of the source.
pub(crate) fn rendered(found: &[Diagnostic], files: &[SourceFile]) -> String {
    let mut renderer = Renderer::new(files, Colour::Never);
    let mut text: String =
        in_order(found).take(MOST_SHOWN).map(|diagnostic| renderer.text(diagnostic)).collect();
    if found.len() > MOST_SHOWN {
        text += &format!("... and {} more\n", found.len() - MOST_SHOWN);
    }
    text
}

/// Errors first: warnings are often consequences of an error.
fn in_order(found: &[Diagnostic]) -> impl Iterator<Item = &Diagnostic> {
    let is_error = |diagnostic: &&Diagnostic| diagnostic.severity == Severity::Error;
    let (errors, others) =
        (found.iter().filter(is_error), found.iter().filter(move |found| !is_error(found)));
    errors.chain(others)
}
