//! Project: the models of one folder and the modules they import, in one database.

use super::imports::imports;
use super::library::Library;
use super::text::Text;
use crate::ide::Snapshot;
use crate::ide::elaborated::Elaborated;
use calyx_elaborate::read_module;
use calyx_lang::check::Loader;
use calyx_lang::db::Database;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Role of a file in its project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Role {
    Model,
    /// Module with this dotted path.
    Module(String),
    /// Prelude, visible to all files.
    Prelude,
}

/// A file of a project.
#[derive(Clone, Debug)]
pub struct File {
    pub text: Arc<Text>,
    pub role: Role,
    /// True for library files, which the user cannot change.
    pub of_library: bool,
}

/// Files by display name.
pub type Files = BTreeMap<Arc<str>, File>;

/// Source of the texts of imported files.
pub trait Sources {
    /// Returns the text of an open file.
    fn text(&self, path: &Path) -> Option<Arc<Text>>;
    /// Returns the modules that closed models of a folder import: such files are modules although
    /// no open file imports them.
    fn imported_in(&self, folder: &Path) -> BTreeSet<String>;
    /// Returns files and directories outside of the folder that models may read.
    fn allowed(&self) -> &[PathBuf];
}

/// Models that share a folder, and the modules they import.
pub struct Project {
    /// `None` for a text without a file, and for the library itself.
    folder: Option<PathBuf>,
    database: Database,
    files: Arc<Files>,
    /// Open files of this project, in the order they were opened. Its other files are imported by
    /// these.
    opened: Vec<Arc<str>>,
    /// Open modules: each has a generated model that only imports it, so that it is checked.
    importers: BTreeSet<String>,
    elaborated: Arc<BTreeMap<Arc<str>, Arc<Elaborated>>>,
    library: Arc<Library>,
}

/// The library as a loader of the database.
struct LibraryLoader<'a>(&'a Library);

impl Loader for LibraryLoader<'_> {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        self.0.module(&path.join(".")).map(|file| (file.name.clone(), file.text.clone()))
    }

    fn names(&self) -> Vec<String> {
        self.0.modules().iter().map(|module| module.path.clone()).collect()
    }

    fn prelude(&self) -> (String, String) {
        let prelude = self.0.prelude();
        (prelude.name.clone(), prelude.text.clone())
    }
}

impl Project {
    pub fn new(folder: Option<PathBuf>, library: &Arc<Library>) -> Project {
        let prelude = library.prelude();
        let text = Arc::new(Text::new(prelude.text.as_str()));
        let file = File { text, role: Role::Prelude, of_library: true };
        let mut project = Project {
            folder,
            database: Database::new(&LibraryLoader(library)),
            files: Arc::new(Files::from([(prelude.name.as_str().into(), file)])),
            opened: Vec::new(),
            importers: BTreeSet::new(),
            elaborated: Arc::default(),
            library: library.clone(),
        };
        // Completion offers all modules that can be imported.
        for module in library.modules() {
            project.put_library(&module.path);
        }
        project
    }

    /// Creates the project of the library's own files, which are checked too.
    pub fn of_library(library: &Arc<Library>) -> Project {
        let mut project = Project::new(None, library);
        for module in library.modules() {
            project.import(&module.path);
        }
        project
    }

    /// Returns a snapshot. A change of a text waits until all snapshots are dropped.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot { database: self.database.clone(), elaborated: self.elaborated.clone() }
    }

    /// Stores the result of an elaboration.
    pub fn set_elaborated(&mut self, model: &Arc<str>, elaborated: Elaborated) {
        if self.files.get(model).is_some_and(|file| file.role == Role::Model) {
            Arc::make_mut(&mut self.elaborated).insert(model.clone(), Arc::new(elaborated));
        }
    }

    pub fn files(&self) -> &Arc<Files> {
        &self.files
    }

    /// Returns the names of the models to check: open models, and the generated models of open
    /// modules.
    pub fn models(&self) -> Vec<Arc<str>> {
        let is_model = |name: &&Arc<str>| self.files.get(*name).is_some_and(|file| file.role == Role::Model);
        let open = self.opened.iter().filter(is_model).cloned();
        open.chain(self.importers.iter().map(|path| importer(path).into())).collect()
    }

    pub fn has_opened(&self, name: &str) -> bool {
        self.opened.iter().any(|opened| **opened == *name)
    }

    pub fn is_empty(&self) -> bool {
        self.opened.is_empty()
    }

    /// Adds or removes an open file. [`Project::settle`] must be called afterwards.
    pub fn set_opened(&mut self, name: &Arc<str>, open: bool) {
        self.opened.retain(|opened| opened != name);
        if open {
            self.opened.push(name.clone());
        }
    }

    /// Changes the text of an existing file. Returns true if its imports changed, so that
    /// [`Project::settle`] must be called.
    pub fn change(&mut self, name: &Arc<str>, text: &Arc<Text>) -> bool {
        let Some(file) = self.files.get(name) else { return false };
        let same = imports(file.text.content()) == imports(text.content());
        self.put(name, text, file.role.clone(), file.of_library);
        !same
    }

    /// Determines the files of the project and their roles, and updates the database.
    pub fn settle(&mut self, sources: &dyn Sources) {
        let opened = self.opened.clone();
        let Some(folder) = self.folder.clone() else {
            // A text without a folder can import library modules only.
            for name in &opened {
                if let Some(text) = sources.text(Path::new(&**name)) {
                    self.put(name, &text, Role::Model, false);
                    self.put_library_of(&text);
                }
            }
            return self.keep(|name, file| file.of_library || opened.contains(name));
        };
        let mut texts: BTreeMap<Arc<str>, Arc<Text>> = BTreeMap::new();
        for name in &opened {
            texts.extend(sources.text(Path::new(&**name)).map(|text| (name.clone(), text)));
        }
        let mut modules: BTreeMap<String, Arc<str>> = BTreeMap::new();
        let mut wanted: Vec<String> = texts.values().flat_map(|text| imports(text.content())).collect();
        let by_closed = sources.imported_in(&folder);
        wanted.extend(by_closed.iter().filter(|path| opened.contains(&name_of(&folder, path))).cloned());
        let mut seen = BTreeSet::new();
        while let Some(path) = wanted.pop() {
            if !seen.insert(path.clone()) || self.put_library(&path) {
                continue;
            }
            let name = name_of(&folder, &path);
            let open = texts.get(&name).cloned().or_else(|| sources.text(Path::new(&*name)));
            let names: Vec<String> = path.split('.').map(str::to_owned).collect();
            let read = match open {
                Some(text) => Ok(Some(text)),
                None => read_module(&folder, sources.allowed(), &names)
                    .map(|text| text.map(|text| Arc::new(Text::new(text)))),
            };
            self.database.set_refusal(&path, read.as_ref().err().cloned());
            if let Ok(Some(text)) = read {
                wanted.extend(imports(text.content()));
                texts.insert(name.clone(), text);
                modules.insert(path, name);
            }
        }
        for (name, text) in &texts {
            let path = modules.iter().find(|(_, module)| *module == name).map(|(path, _)| path.clone());
            self.put(name, text, path.map_or(Role::Model, Role::Module), false);
        }
        self.keep(|name, file| file.of_library || texts.contains_key(name));
        let importers = modules.iter().filter(|(_, name)| opened.contains(name));
        self.set_importers(importers.map(|(path, _)| path.clone()).collect());
    }

    fn put_library_of(&mut self, text: &Text) {
        for path in imports(text.content()) {
            self.put_library(&path);
        }
    }

    /// Adds a module of the library, and those it imports. Returns true if there is such a module.
    fn put_library(&mut self, path: &str) -> bool {
        let library = self.library.clone();
        let Some(module) = library.module(path) else { return false };
        if !self.files.contains_key(module.name.as_str()) {
            let text = Arc::new(Text::new(module.text.as_str()));
            self.put(&module.name.as_str().into(), &text, Role::Module(path.to_owned()), true);
            self.put_library_of(&text);
        }
        true
    }

    fn put(&mut self, name: &Arc<str>, text: &Arc<Text>, role: Role, of_library: bool) {
        let before = self.files.get(name).map(|file| &file.role);
        if before.is_some_and(|before| *before != role) {
            self.remove(&name.clone());
        }
        match &role {
            Role::Model => self.database.set_model(name, text.content()),
            Role::Module(path) => self.database.set_module(path, name, text.content()),
            // Library files never change.
            Role::Prelude => return,
        }
        let file = File { text: text.clone(), role, of_library };
        Arc::make_mut(&mut self.files).insert(name.clone(), file);
    }

    fn keep(&mut self, kept: impl Fn(&Arc<str>, &File) -> bool) {
        let gone = self.files.iter().filter(|(name, file)| !kept(name, file)).map(|(name, _)| name.clone());
        for name in gone.collect::<Vec<_>>() {
            self.remove(&name);
        }
    }

    fn remove(&mut self, name: &Arc<str>) {
        match self.files.get(name).map(|file| file.role.clone()) {
            Some(Role::Model) => {
                self.database.remove_model(name);
                Arc::make_mut(&mut self.elaborated).remove(name);
            }
            Some(Role::Module(path)) => self.database.remove_module(&path),
            Some(Role::Prelude) | None => return,
        }
        Arc::make_mut(&mut self.files).remove(name);
    }

    fn set_importers(&mut self, paths: BTreeSet<String>) {
        for gone in self.importers.difference(&paths) {
            self.database.remove_model(&importer(gone));
        }
        self.importers.clear();
        for path in paths {
            self.import(&path);
        }
    }

    /// Generates a model that imports a module, so that the module is checked.
    fn import(&mut self, path: &str) {
        self.database.set_model(&importer(path), &format!("import {path};\n"));
        self.importers.insert(path.to_owned());
    }
}

fn importer(path: &str) -> String {
    format!("<importer of {path}>")
}

/// Returns the file of a module, with the same rule as [`Loader`] of the command line.
pub fn module_path(folder: &Path, path: &str) -> PathBuf {
    let mut file = folder.to_path_buf();
    file.extend(path.split('.'));
    file.set_extension("cx");
    file
}

fn name_of(folder: &Path, path: &str) -> Arc<str> {
    module_path(folder, path).display().to_string().into()
}

/// Returns the dotted path by which models of a folder can import a file.
pub fn dotted(folder: &Path, file: &Path) -> Option<String> {
    let below = file.strip_prefix(folder).ok()?.with_extension("");
    let names: Option<Vec<&str>> = below.iter().map(|name| name.to_str()).collect();
    names.map(|names| names.join("."))
}

/// Returns the modules imported by the models in a folder, as they are on disk.
pub fn imported_by_files(folder: &Path, allowed: &[PathBuf]) -> BTreeSet<String> {
    /// Largest number of files read in a folder.
    const MOST_FILES: usize = 200;
    let Ok(entries) = fs::read_dir(folder) else { return BTreeSet::new() };
    let paths = entries.flatten().map(|entry| entry.path());
    let models = paths.filter(|path| path.extension().is_some_and(|extension| extension == "cx"));
    // File name of a module; the file need not exist.
    let name = |path: PathBuf| path.file_stem()?.to_str().map(str::to_owned);
    let texts = models
        .take(MOST_FILES)
        .filter_map(name)
        .filter_map(|name| read_module(folder, allowed, &[name]).ok()?);
    texts.flat_map(|text| imports(&text)).collect()
}
