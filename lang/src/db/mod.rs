//! The incremental database: texts in, trees and checked models out, recomputed only where a text changed.
//!
//! The one way through: the command line asks a fresh database, an editor keeps one. Texts are parsed by file and checked
//! by unit: a function, functions that name each other, or what else a file has. A unit's check depends on its own text,
//! on the declarations it names and on the schemes of the functions it calls, and on nothing's place in a file.
//! These are the only files that know salsa.

mod analysis;
mod callables;
mod groups;
mod items;
mod program;
mod recent;
#[cfg(test)]
mod tests;
mod units;

use crate::ast::Module;
use crate::check::item::ItemKind;
use crate::check::{Checked, Loader};
use crate::deep_recursion::with_deep_stack;
use crate::diagnostic::Diagnostic;
use items::{ChunkCache, declarations, parse};
use program::check;
use salsa::{Cancelled, Setter};
use std::collections::{BTreeMap, BTreeSet};
use std::panic::AssertUnwindSafe;
use std::sync::Arc;

/// The tree of one file and what is wrong with its text. Spans have file 0.
#[derive(Debug, PartialEq)]
pub struct Parsed {
    pub module: Module,
    pub diagnostics: Vec<Diagnostic>,
}

/// Texts of a model and of every module it may import, and what was computed from them.
///
/// Clones share results; a clone may be used on another thread while this one waits to change a text.
#[derive(Clone)]
pub struct Database {
    salsa: Storage,
    models: BTreeMap<String, Text>,
    library: Library,
    /// Shared by all clones, and older than the texts: only for what must not wait.
    recent: Arc<recent::Recent>,
}

/// Why a question has no answer: a text is about to change, or nobody waits for it any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Superseded;

/// Stops what one clone of a database computes.
#[derive(Clone, Debug)]
pub struct Canceller(salsa::CancellationToken);

impl Canceller {
    /// Whatever the clone is asked from now on is answered with [`Superseded`].
    pub fn cancel(&self) {
        self.0.cancel();
    }
}

/// One text.
#[salsa::input(debug)]
struct Text {
    /// As shown to people.
    name: Arc<str>,
    /// As imported: `gears.helical`; empty for a model, `prelude` for the prelude.
    module: String,
    content: String,
    /// Never changes; what it holds speeds up parsing and decides nothing.
    kept: ChunkCache,
}

/// What can be imported.
#[salsa::input]
struct Library {
    /// By dotted path.
    modules: BTreeMap<String, Text>,
    #[returns(copy)]
    prelude: Text,
    /// Modules there are, for suggestions.
    known: Vec<String>,
    /// Reasons for not reading files of imported modules, by dotted path.
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
    /// A database without models whose programs see what the loader's prelude declares.
    pub fn new(loader: &dyn Loader) -> Self {
        Self::with_storage(Storage::default(), loader)
    }

    fn with_storage(salsa: Storage, loader: &dyn Loader) -> Self {
        let (name, content) = loader.prelude();
        let prelude = Text::new(&salsa, name.into(), "prelude".into(), content, ChunkCache::default());
        let library = Library::new(&salsa, BTreeMap::new(), prelude, loader.names(), BTreeMap::new());
        Database { salsa, models: BTreeMap::new(), library, recent: Arc::default() }
    }

    /// Adds a model or changes its text. `name` is the file as shown to people.
    pub fn set_model(&mut self, name: &str, content: &str) {
        match self.models.get(name) {
            Some(text) => set(&mut self.salsa, *text, content),
            None => {
                let text =
                    Text::new(&self.salsa, name.into(), String::new(), content.into(), ChunkCache::default());
                self.models.insert(name.into(), text);
            }
        }
    }

    /// Adds a module or changes its text, e.g. while it is edited. `path` is dotted, as in `import`.
    pub fn set_module(&mut self, path: &str, name: &str, content: &str) {
        let known = self.library.modules(&self.salsa).get(path).copied();
        match known {
            Some(text) => set(&mut self.salsa, text, content),
            None => {
                let text =
                    Text::new(&self.salsa, name.into(), path.into(), content.into(), ChunkCache::default());
                let mut modules = self.library.modules(&self.salsa).clone();
                modules.insert(path.into(), text);
                self.library.set_modules(&mut self.salsa).to(modules);
            }
        }
    }

    /// Sets the reason for not reading the file of a module; `None` if it can be read.
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

    /// Forgets a model.
    pub fn remove_model(&mut self, name: &str) {
        self.models.remove(name);
    }

    /// Forgets a module: who imports it is told that there is none.
    pub fn remove_module(&mut self, path: &str) {
        if self.library.modules(&self.salsa).contains_key(path) {
            let mut modules = self.library.modules(&self.salsa).clone();
            modules.remove(path);
            self.library.set_modules(&mut self.salsa).to(modules);
        }
    }

    /// Asks questions of a clone that may be interrupted: by a change of a text, which waits until all clones are gone, and
    /// by the clone's canceller. A panic that is neither is passed on.
    ///
    /// # Errors
    /// It was interrupted.
    pub fn attempt<T>(&self, questions: impl FnOnce(&Database) -> T) -> Result<T, Superseded> {
        // Attached throughout, so that no cancellation is lost between two questions.
        attempt(|| salsa::Database::attach(&self.salsa, |_| questions(self)))
    }

    /// Asks questions of this database in the middle of an attempt on another, e.g. of texts as an edit would make them.
    /// They are not interrupted.
    pub fn aside<T>(&self, questions: impl FnOnce(&Database) -> T) -> T {
        salsa::attach_allow_change(&self.salsa, || questions(self))
    }

    /// What stops this clone, from another thread.
    pub fn canceller(&self) -> Canceller {
        Canceller(salsa::Database::cancellation_token(&self.salsa))
    }

    /// The tree of a model; `None` if it was never set.
    pub fn parse(&self, name: &str) -> Option<Arc<Parsed>> {
        let model = *self.models.get(name)?;
        Some(with_deep_stack(|| parse(&self.salsa, model).clone()))
    }

    /// Asks the loader for every module that a model imports, directly or through others, and that is not yet
    /// known. Call it after [`Database::set_model`] and before [`Database::check`].
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
                        Some((name, content)) => self.set_module(&path, &name, &content),
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

    /// The typed program of a model and everything wrong with it; `None` if the model was never set.
    pub fn check(&self, name: &str) -> Option<Arc<Checked>> {
        let model = *self.models.get(name)?;
        Some(with_deep_stack(|| check(&self.salsa, model, self.library).clone()))
    }
}

/// Asks questions of any databases, all of which may be interrupted as in [`Database::attempt`].
///
/// # Errors
/// One was interrupted.
pub fn attempt<T>(questions: impl FnOnce() -> T) -> Result<T, Superseded> {
    // What is being computed is thrown away, and everything else is as it was.
    Cancelled::catch(AssertUnwindSafe(questions)).map_err(|_| Superseded)
}

/// Changes a text if it differs: an equal one must not start a new revision.
fn set(salsa: &mut Storage, text: Text, content: &str) {
    if text.content(salsa) != content {
        text.set_content(salsa).to(content.into());
    }
}
