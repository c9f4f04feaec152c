//! The incremental database: stores texts, and computes trees and checked models. After an edit,
//! only affected results are recomputed.
//!
//! The command line uses a new database, an editor keeps one. Texts are parsed by file and checked
//! by unit: a function, mutually recursive functions, or the rest of a file. A unit's check depends
//! on its own text, on the declarations it uses and on the schemes of the functions it calls, but
//! not on positions in files. Only the modules of this folder depend on salsa.

mod analysis;
mod callables;
mod groups;
mod items;
mod program;
mod recent;
#[cfg(test)]
mod tests;
mod units;
mod visible;

use crate::ast::Module;
use crate::check::item::ItemKind;
use crate::check::{Checked, Loader};
use crate::deep_recursion::with_deep_stack;
use crate::diagnostic::Diagnostic;
use crate::threads;
use items::{ChunkCache, declarations, parse};
use program::{check, check_groups, checked};
use salsa::{Cancelled, Setter};
use std::collections::{BTreeMap, BTreeSet};
use std::panic::AssertUnwindSafe;
use std::sync::Arc;

/// The tree of one file and the errors in its text. Spans have file 0.
#[derive(Debug, PartialEq)]
pub struct Parsed {
    pub module: Module,
    pub diagnostics: Vec<Diagnostic>,
}

/// The texts of models and of the modules they may import, with cached results.
///
/// Clones share results; a clone can be used on another thread while this one waits to change a
/// text.
#[derive(Clone)]
pub struct Database {
    salsa: Storage,
    models: BTreeMap<String, Text>,
    library: Library,
    /// Shared by all clones. It may be older than the texts, so it serves only queries that must
    /// not wait.
    recent: Arc<recent::Recent>,
}

/// A query was interrupted because a text changes or because it was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Superseded;

/// Cancels the queries of one clone of a database.
#[derive(Clone, Debug)]
pub struct Canceller(salsa::CancellationToken);

impl Canceller {
    /// Cancels the current and all later queries of the clone; they return [`Superseded`].
    pub fn cancel(&self) {
        self.0.cancel();
    }
}

/// The text of a file.
#[salsa::input(debug)]
struct Text {
    /// Display name.
    name: Arc<str>,
    /// Name as imported: `gears.helical`; empty for a model, `prelude` for the prelude.
    module: String,
    content: String,
    /// `true` if it has no errors and warnings, see [`Loader::is_sound`].
    #[returns(copy)]
    sound: bool,
    /// Never changes as an input; its contents speed up parsing but do not affect results.
    kept: ChunkCache,
}

/// The modules that can be imported.
#[salsa::input]
struct Library {
    /// Modules by dotted path.
    modules: BTreeMap<String, Text>,
    #[returns(copy)]
    prelude: Text,
    /// Names of available modules, for suggestions.
    known: Vec<String>,
    /// Reasons why files of imported modules cannot be read, by dotted path.
    refused: BTreeMap<String, String>,
}

#[salsa::db]
#[derive(Clone, Default)]
struct Storage {
    storage: salsa::Storage<Self>,
}

#[salsa::db]
impl salsa::Database for Storage {}

impl Database {
    /// Creates a database without models, with the prelude of the loader.
    pub fn new(loader: &dyn Loader) -> Self {
        Self::with_storage(Storage::default(), loader)
    }

    fn with_storage(salsa: Storage, loader: &dyn Loader) -> Self {
        let (name, content) = loader.prelude();
        let (module, sound) = ("prelude".into(), loader.is_sound(&[]));
        let prelude = Text::new(&salsa, name.into(), module, content, sound, ChunkCache::default());
        let library = Library::new(&salsa, BTreeMap::new(), prelude, loader.names(), BTreeMap::new());
        Database { salsa, models: BTreeMap::new(), library, recent: Arc::default() }
    }

    /// Adds a model or changes its text. `name` is its display name.
    pub fn set_model(&mut self, name: &str, content: &str) {
        match self.models.get(name) {
            Some(text) => set(&mut self.salsa, *text, content),
            None => {
                let (module, kept) = (String::new(), ChunkCache::default());
                let text = Text::new(&self.salsa, name.into(), module, content.into(), false, kept);
                self.models.insert(name.into(), text);
            }
        }
    }

    /// Adds a module or changes its text, for example while it is edited. `path` is dotted, as in
    /// `import`.
    pub fn set_module(&mut self, path: &str, name: &str, content: &str) {
        self.put_module(path, (name, content), false);
    }

    fn put_module(&mut self, path: &str, (name, content): (&str, &str), sound: bool) {
        let known = self.library.modules(&self.salsa).get(path).copied();
        match known {
            Some(text) => set(&mut self.salsa, text, content),
            None => {
                let kept = ChunkCache::default();
                let text = Text::new(&self.salsa, name.into(), path.into(), content.into(), sound, kept);
                let mut modules = self.library.modules(&self.salsa).clone();
                modules.insert(path.into(), text);
                self.library.set_modules(&mut self.salsa).to(modules);
            }
        }
    }

    /// Sets the reason why the file of a module cannot be read; `None` if it can be read.
    pub fn set_refusal(&mut self, path: &str, refusal: Option<String>) {
        if self.library.refused(&self.salsa).get(path) != refusal.as_ref() {
            let mut refused = self.library.refused(&self.salsa).clone();
            match refusal {
                Some(refusal) => refused.insert(path.into(), refusal),
                None => refused.remove(path),
            };
            self.library.set_refused(&mut self.salsa).to(refused);
        }
    }

    /// Removes a model.
    pub fn remove_model(&mut self, name: &str) {
        self.models.remove(name);
    }

    /// Removes a module. Its imports are then reported as unknown.
    pub fn remove_module(&mut self, path: &str) {
        if self.library.modules(&self.salsa).contains_key(path) {
            let mut modules = self.library.modules(&self.salsa).clone();
            modules.remove(path);
            self.library.set_modules(&mut self.salsa).to(modules);
        }
    }

    /// Runs queries on a clone that may be interrupted: by a change of a text, which waits until
    /// all clones are dropped, or by the clone's canceller. Other panics are propagated.
    ///
    /// # Errors
    /// The queries were interrupted.
    pub fn attempt<T>(&self, questions: impl FnOnce(&Database) -> T) -> Result<T, Superseded> {
        // Attached for all queries, so that no cancellation is lost between two of them.
        attempt(|| salsa::Database::attach(&self.salsa, |_| questions(self)))
    }

    /// Runs queries on this database during an attempt on another, for example on texts with a
    /// planned edit. They are not interrupted.
    pub fn aside<T>(&self, questions: impl FnOnce(&Database) -> T) -> T {
        salsa::attach_allow_change(&self.salsa, || questions(self))
    }

    /// Returns a handle that cancels this clone from another thread.
    pub fn canceller(&self) -> Canceller {
        Canceller(salsa::Database::cancellation_token(&self.salsa))
    }

    /// Returns the tree of a model; `None` if it does not exist.
    pub fn parse(&self, name: &str) -> Option<Arc<Parsed>> {
        let model = *self.models.get(name)?;
        Some(with_deep_stack(|| parse(&self.salsa, model).clone()))
    }

    /// Loads all modules that a model imports, directly or indirectly, and that are not yet loaded.
    /// Call it after [`Database::set_model`] and before [`Database::check`].
    pub fn load_imports(&mut self, name: &str, loader: &dyn Loader) {
        let Some(model) = self.models.get(name).copied() else { return };
        let mut texts = vec![model, self.library.prelude(&self.salsa)];
        let mut seen = BTreeSet::new();
        while let Some(text) = texts.pop() {
            for path in self.aside(|database| database.imports(text)) {
                if !seen.insert(path.clone()) {
                    continue;
                }
                let names: Vec<String> = path.split('.').map(str::to_string).collect();
                if !self.library.modules(&self.salsa).contains_key(&path) {
                    match loader.module(&names) {
                        Some((name, content)) => {
                            self.put_module(&path, (&name, &content), loader.is_sound(&names));
                        }
                        None => self.set_refusal(&path, loader.refusal(&names)),
                    }
                }
                texts.extend(self.library.modules(&self.salsa).get(&path));
            }
        }
    }

    fn imports(&self, text: Text) -> Vec<String> {
        let all = with_deep_stack(|| declarations(&self.salsa, text))
            .iter()
            .map(|item| item.kind(&self.salsa).clone());
        let paths = all.filter_map(|kind| match kind {
            ItemKind::Import(path) => Some(path),
            _ => None,
        });
        paths.collect()
    }

    /// Returns the typed program of a model and all diagnostics; `None` if the model does not
    /// exist.
    pub fn check(&self, name: &str) -> Option<Arc<Checked>> {
        let model = *self.models.get(name)?;
        Some(with_deep_stack(|| check(&self.salsa, model, self.library).clone()))
    }
}

/// Checks a model and everything that it imports, with a database that is then dropped. `name` is
/// the display name of the model's file.
pub fn check_program(name: &str, text: &str, loader: &dyn Loader) -> Checked {
    let mut database = Database::new(loader);
    database.set_model(name, text);
    database.load_imports(name, loader);
    let Some(model) = database.models.get(name).copied() else { return Checked::default() };
    check_groups(&database.salsa, model, database.library);
    let mut checked = with_deep_stack(|| checked(&database.salsa, model, database.library));
    if threads::for_text(text.len()) > 1 {
        // The results of a long model take milliseconds to free. Without a thread, the error drops
        // the closure and the database.
        let _ = std::thread::Builder::new().spawn(move || with_deep_stack(|| drop(database)));
    }
    if let Some(program) = &mut checked.program {
        program.allowed = loader.allowed();
    }
    checked
}

/// Runs queries on any databases, all of which may be interrupted as in [`Database::attempt`].
///
/// # Errors
/// A query was interrupted.
pub fn attempt<T>(questions: impl FnOnce() -> T) -> Result<T, Superseded> {
    // Incomplete results are discarded; all other state is unchanged.
    Cancelled::catch(AssertUnwindSafe(questions)).map_err(|_| Superseded)
}

/// Changes a text if it differs, because setting an equal text would start a new revision.
fn set(salsa: &mut Storage, text: Text, content: &str) {
    if text.content(salsa) != content {
        text.set_content(salsa).to(content.into());
    }
}
