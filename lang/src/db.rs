//! The incremental database: texts in, trees and checked models out, recomputed only where a text changed.
//!
//! The only file that knows salsa. Queries are coarse (a file is parsed, a model is checked), so bookkeeping costs
//! nothing beside the work it saves.

use crate::ast::{Module, StmtKind};
use crate::check::{Checked, Loader, check_program};
use crate::diagnostic::Diagnostic;
use crate::parser;
use crate::span::FileId;
use salsa::Setter;
use std::collections::{BTreeMap, BTreeSet};
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
}

/// One text.
#[salsa::input]
struct Text {
    /// As shown to people.
    name: String,
    content: String,
}

/// What can be imported.
#[salsa::input]
struct Library {
    /// By dotted path.
    modules: BTreeMap<String, Text>,
    prelude: Text,
}

#[salsa::db]
#[derive(Clone, Default)]
struct Storage {
    storage: salsa::Storage<Self>,
}

#[salsa::db]
impl salsa::Database for Storage {}

#[salsa::tracked]
fn parse(db: &dyn salsa::Database, text: Text) -> Arc<Parsed> {
    let (module, diagnostics) = parser::parse(FileId(0), text.content(db));
    Arc::new(Parsed { module, diagnostics })
}

// A checked model is large and seldom equal to the one before: comparing does not pay.
#[salsa::tracked(no_eq)]
fn check(db: &dyn salsa::Database, model: Text, library: Library) -> Arc<Checked> {
    Arc::new(check_program(model.name(db), model.content(db), &Imports { db, library }))
}

/// Reads modules as inputs, so that a check depends on those it imports and on no other.
struct Imports<'db> {
    db: &'db dyn salsa::Database,
    library: Library,
}

impl Loader for Imports<'_> {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let text = self.library.modules(self.db).get(&path.join("."))?;
        Some((text.name(self.db).clone(), text.content(self.db).clone()))
    }

    fn prelude(&self) -> (String, String) {
        let text = self.library.prelude(self.db);
        (text.name(self.db).clone(), text.content(self.db).clone())
    }

    fn names(&self) -> Vec<String> {
        self.library.modules(self.db).keys().cloned().collect()
    }
}

impl Database {
    /// A database without models whose programs see what the loader's prelude declares.
    pub fn new(loader: &dyn Loader) -> Self {
        Self::with_storage(Storage::default(), loader)
    }

    fn with_storage(salsa: Storage, loader: &dyn Loader) -> Self {
        let (name, content) = loader.prelude();
        let prelude = Text::new(&salsa, name, content);
        let library = Library::new(&salsa, BTreeMap::new(), prelude);
        Database { salsa, models: BTreeMap::new(), library }
    }

    /// Adds a model or changes its text. `name` is the file as shown to people.
    pub fn set_model(&mut self, name: &str, content: &str) {
        match self.models.get(name) {
            Some(text) => set(&mut self.salsa, *text, content),
            None => {
                let text = Text::new(&self.salsa, name.into(), content.into());
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
                let text = Text::new(&self.salsa, name.into(), content.into());
                let mut modules = self.library.modules(&self.salsa).clone();
                modules.insert(path.into(), text);
                self.library.set_modules(&mut self.salsa).to(modules);
            }
        }
    }

    /// The tree of a model; `None` if it was never set.
    pub fn parse(&self, name: &str) -> Option<Arc<Parsed>> {
        Some(parse(&self.salsa, *self.models.get(name)?).clone())
    }

    /// Asks the loader for every module that a model imports, directly or through others, and that is not yet
    /// known. Call it after [`Database::set_model`] and before [`Database::check`].
    pub fn load_imports(&mut self, name: &str, loader: &dyn Loader) {
        let Some(model) = self.models.get(name).copied() else { return };
        let mut texts = vec![model, *self.library.prelude(&self.salsa)];
        let mut seen = BTreeSet::new();
        while let Some(text) = texts.pop() {
            let parsed = parse(&self.salsa, text).clone();
            for statement in &parsed.module.statements {
                let StmtKind::Import(path) = &statement.kind else { continue };
                let path: Vec<String> = path.iter().map(|ident| ident.name.clone()).collect();
                let dotted = path.join(".");
                if !seen.insert(dotted.clone()) {
                    continue;
                }
                if !self.library.modules(&self.salsa).contains_key(&dotted)
                    && let Some((name, content)) = loader.module(&path)
                {
                    self.set_module(&dotted, &name, &content);
                }
                texts.extend(self.library.modules(&self.salsa).get(&dotted));
            }
        }
    }

    /// The typed program of a model and everything wrong with it; `None` if the model was never set.
    pub fn check(&self, name: &str) -> Option<Arc<Checked>> {
        Some(check(&self.salsa, *self.models.get(name)?, self.library).clone())
    }
}

/// Changes a text if it differs: an equal one must not start a new revision.
fn set(salsa: &mut Storage, text: Text, content: &str) {
    if text.content(salsa) != content {
        text.set_content(salsa).to(content.into());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use std::sync::Mutex;

    #[derive(Default)]
    struct Modules {
        asked: Cell<usize>,
    }

    impl Loader for Modules {
        fn module(&self, path: &[String]) -> Option<(String, String)> {
            self.asked.set(self.asked.get() + 1);
            let content = match path.join(".").as_str() {
                "first" => "import second;\n",
                "second" => "function two() { return 2; }\n",
                _ => return None,
            };
            Some((format!("{}.cx", path.join("/")), content.into()))
        }

        fn prelude(&self) -> (String, String) {
            ("<library>/prelude.cx".into(), "/// Nothing yet.\n".into())
        }
    }

    /// A database that records the queries it runs.
    fn watched() -> (Database, Arc<Mutex<Vec<String>>>) {
        let log = Arc::new(Mutex::new(Vec::new()));
        let events = log.clone();
        let storage = salsa::Storage::new(Some(Box::new(move |event: salsa::Event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                events.lock().unwrap().push(format!("{database_key:?}"));
            }
        })));
        (Database::with_storage(Storage { storage }, &Modules::default()), log)
    }

    fn ran(log: &Mutex<Vec<String>>) -> Vec<String> {
        let name = |entry: String| entry.split('(').next().unwrap_or_default().to_string();
        std::mem::take(&mut *log.lock().unwrap()).into_iter().map(name).collect()
    }

    #[test]
    fn an_unchanged_text_runs_no_query() {
        let (mut db, log) = watched();
        db.set_model("a.cx", "var x = 1;\nprint(x);\n");
        let first = db.check("a.cx").unwrap();
        db.parse("a.cx").unwrap();
        assert_eq!(ran(&log), ["check", "parse"]);

        db.set_model("a.cx", "var x = 1;\nprint(x);\n");
        assert!(Arc::ptr_eq(&first, &db.check("a.cx").unwrap()));
        db.parse("a.cx").unwrap();
        assert_eq!(ran(&log), Vec::<String>::new());
    }

    #[test]
    fn a_changed_text_runs_its_own_queries_only() {
        let (mut db, log) = watched();
        db.set_model("a.cx", "var x = 1;\nprint(x);\n");
        db.set_model("b.cx", "var y = 2;\nprint(y);\n");
        db.check("a.cx").unwrap();
        db.check("b.cx").unwrap();
        ran(&log);

        db.set_model("a.cx", "var x = 2;\nprint(x);\n");
        db.check("a.cx").unwrap();
        db.check("b.cx").unwrap();
        assert_eq!(ran(&log), ["check"]);
        // A module that neither imports does not concern them.
        db.set_module("second", "second.cx", "function two() { return 2; }\n");
        db.check("a.cx").unwrap();
        ran(&log);
        db.set_module("second", "second.cx", "function two() { return 3; }\n");
        db.check("a.cx").unwrap();
        assert_eq!(ran(&log), Vec::<String>::new());
    }

    #[test]
    fn imports_are_loaded_once_and_through_others() {
        let (mut db, log) = watched();
        let loader = Modules::default();
        db.set_model("a.cx", "import first;\n");
        db.load_imports("a.cx", &loader);
        db.load_imports("a.cx", &loader);
        assert_eq!(loader.asked.get(), 2);
        let checked = db.check("a.cx").unwrap();
        let names: Vec<_> = checked.files.iter().map(|f| f.name.as_str()).collect();
        assert!(names.contains(&"first.cx") && names.contains(&"second.cx"), "{names:?}");
        ran(&log);

        db.set_module("second", "second.cx", "function two() { return 3; }\n");
        db.check("a.cx").unwrap();
        assert_eq!(ran(&log), ["check"]);
        assert!(db.check("unknown.cx").is_none());
    }
}
