//! Files, open and on disk, and the projects they belong to.
//!
//! A file belongs to the project of a folder that imports it, else to that of its own folder. Edits
//! are applied here, in order of arrival, while the client waits; requests are answered elsewhere,
//! on a [`View`].

use super::client::Client;
use super::library::Library;
use super::project::{Project, Sources, dotted, imported_by_files};
use super::text::Text;
use super::view::View;
use crate::ide::elaborated::Elaborated;
use calyx_elaborate::allowed_path;
use calyx_elaborate::results::RunSummary;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tower_lsp_server::ls_types::{
    InitializeParams, TextDocumentContentChangeEvent, Uri, WorkspaceFoldersChangeEvent,
};

/// Key of a project: models share a project if they share their folder.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Key {
    Folder(PathBuf),
    /// Name of a text without a file.
    Alone(Arc<str>),
    Library,
}

/// Open document.
#[derive(Clone, Debug)]
pub struct Document {
    /// Display name of its file.
    pub name: Arc<str>,
    pub text: Arc<Text>,
    pub version: i32,
    pub home: Key,
}

/// Change of a project.
pub enum Changed {
    Project(Box<View>),
    /// Its last document was closed.
    Gone(Key),
}

/// Open documents by URI.
pub type Documents = HashMap<Uri, Document>;

/// State of the workspace.
pub struct Workspace {
    pub client: Arc<Client>,
    library: Arc<Library>,
    /// Workspace folders of the client.
    roots: Vec<PathBuf>,
    /// Files and directories outside of models' folders that models may read, as with
    /// `--allow-path` of the command.
    pub allowed: Arc<[PathBuf]>,
    documents: Arc<Documents>,
    projects: BTreeMap<Key, Project>,
    runs: Arc<HashMap<Arc<str>, Arc<RunSummary>>>,
    disk: Disk,
    /// Counter of changes of any kind.
    revision: u64,
    /// Projects that changed since their diagnostics were last computed.
    dirty: BTreeSet<Key>,
    /// Document that was edited last.
    latest: Option<Uri>,
}

/// Cache of folder contents, until a change on disk.
#[derive(Default)]
struct Disk {
    imported: HashMap<PathBuf, BTreeSet<String>>,
}

impl Disk {
    fn imported(&mut self, folder: &Path, allowed: &[PathBuf]) -> &BTreeSet<String> {
        self.imported.entry(folder.to_path_buf()).or_insert_with(|| imported_by_files(folder, allowed))
    }
}

/// Files as a project sees them: open ones with the text of the editor.
struct FileView<'a> {
    documents: &'a Documents,
    allowed: &'a [PathBuf],
    imported: BTreeSet<String>,
}

impl Sources for FileView<'_> {
    fn text(&self, path: &Path) -> Option<Arc<Text>> {
        let open = self.documents.values().find(|document| Path::new(&*document.name) == path);
        open.map(|document| document.text.clone())
    }

    fn imported_in(&self, _: &Path) -> BTreeSet<String> {
        self.imported.clone()
    }

    fn allowed(&self) -> &[PathBuf] {
        self.allowed
    }
}

impl Workspace {
    pub fn new(library: Library) -> Workspace {
        Workspace {
            client: Arc::default(),
            library: Arc::new(library),
            roots: Vec::new(),
            allowed: Arc::default(),
            documents: Arc::default(),
            projects: BTreeMap::new(),
            runs: Arc::default(),
            disk: Disk::default(),
            revision: 0,
            dirty: BTreeSet::new(),
            latest: None,
        }
    }

    /// Stores the parameters of the client.
    pub fn initialize(&mut self, params: &InitializeParams) {
        self.client = Arc::new(Client::new(&params.capabilities));
        let folders = params.workspace_folders.iter().flatten();
        self.roots = folders.filter_map(|folder| path_of(&folder.uri)).collect();
        let options = params.initialization_options.as_ref();
        let paths = options.and_then(|options| options.get("allowPaths")?.as_array());
        let paths = paths.into_iter().flatten().filter_map(|path| path.as_str());
        // A path that does not exist is ignored.
        self.allowed = paths.filter_map(|path| allowed_path(path).ok()).collect();
    }

    /// Updates the workspace folders.
    pub fn change_roots(&mut self, event: &WorkspaceFoldersChangeEvent) {
        let gone: Vec<PathBuf> = event.removed.iter().filter_map(|folder| path_of(&folder.uri)).collect();
        self.roots.retain(|root| !gone.contains(root));
        self.roots.extend(event.added.iter().filter_map(|folder| path_of(&folder.uri)));
    }

    /// Returns the version of an open document.
    pub fn version(&self, uri: &Uri) -> Option<i32> {
        self.documents.get(uri).map(|document| document.version)
    }

    /// Returns the project of an open document.
    pub fn home_of(&self, uri: &Uri) -> Option<&Key> {
        self.documents.get(uri).map(|document| &document.home)
    }

    pub fn documents(&self) -> &Arc<Documents> {
        &self.documents
    }

    pub fn library(&self) -> &Arc<Library> {
        &self.library
    }

    /// Returns a view of the project of a file; of the file edited last if `uri` is `None`.
    pub fn view(&self, uri: Option<&Uri>) -> Option<View> {
        let uri = uri.or(self.latest.as_ref())?;
        let (name, home) = match self.documents.get(uri) {
            Some(document) => (document.name.clone(), document.home.clone()),
            None => self.closed(uri)?,
        };
        self.view_of(&home, name)
    }

    /// Returns a file that is part of a project but not open.
    fn closed(&self, uri: &Uri) -> Option<(Arc<str>, Key)> {
        let (name, key) = self.name(uri);
        if key == Key::Library {
            return None;
        }
        let home = self.projects.iter().find(|(_, project)| project.files().contains_key(&name))?;
        Some((name, home.0.clone()))
    }

    fn view_of(&self, home: &Key, file: Arc<str>) -> Option<View> {
        let project = self.projects.get(home)?;
        Some(View::new(project, home.clone(), file, self))
    }

    /// Returns views of all projects.
    pub fn views(&self) -> Vec<View> {
        self.projects.keys().filter_map(|key| self.view_of(key, "".into())).collect()
    }

    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Returns a project that has changed since it was last returned here; the project of the
    /// document edited last comes first.
    pub fn next_changed(&mut self) -> Option<Changed> {
        let latest = self.latest.as_ref().and_then(|uri| self.documents.get(uri));
        let latest = latest.map(|document| &document.home).filter(|home| self.dirty.contains(*home));
        let key = latest.or_else(|| self.dirty.first())?.clone();
        self.dirty.remove(&key);
        Some(match self.view_of(&key, "".into()) {
            Some(view) => Changed::Project(Box::new(view)),
            None => Changed::Gone(key),
        })
    }

    /// Returns a project to the queue of [`Workspace::next_changed`].
    pub fn mark_dirty(&mut self, home: &Key) {
        self.dirty.insert(home.clone());
    }

    pub fn open(&mut self, uri: Uri, version: i32, text: String) {
        let (name, own) = self.name(&uri);
        let text = Arc::new(Text::new(text));
        let home = self.home(&name, own);
        let document = Document { name, text, version, home: home.clone() };
        let name = document.name.clone();
        Arc::make_mut(&mut self.documents).insert(uri.clone(), document);
        self.latest = Some(uri);
        let library = &self.library;
        let project = self.projects.entry(home.clone()).or_insert_with(|| match &home {
            Key::Folder(folder) => Project::new(Some(folder.clone()), library),
            Key::Alone(_) => Project::new(None, library),
            Key::Library => Project::of_library(library),
        });
        project.set_opened(&name, true);
        // The document may replace a file that others have read from disk.
        self.settle_all_with(&name, home);
    }

    /// Applies changes of an open document.
    pub fn change(&mut self, uri: &Uri, version: i32, changes: &[TextDocumentContentChangeEvent]) {
        let encoding = self.client.encoding;
        let Some(document) = Arc::make_mut(&mut self.documents).get_mut(uri) else { return };
        let text = document.text.changed(changes, encoding);
        document.text = text.clone();
        document.version = version;
        let name = document.name.clone();
        self.latest = Some(uri.clone());
        self.revision += 1;
        let mut unsettled = Vec::new();
        for (key, project) in &mut self.projects {
            if project.files().contains_key(&name) {
                if project.change(&name, &text) && *key != Key::Library {
                    unsettled.push(key.clone());
                }
                self.dirty.insert(key.clone());
            }
        }
        unsettled.into_iter().for_each(|key| self.settle(key));
    }

    /// Stores the results of a run.
    pub fn set_run(&mut self, model: &str, summary: RunSummary) {
        Arc::make_mut(&mut self.runs).insert(model.into(), Arc::new(summary));
        self.revision += 1;
    }

    /// Returns the results of runs, by model file.
    pub fn runs(&self) -> &Arc<HashMap<Arc<str>, Arc<RunSummary>>> {
        &self.runs
    }

    /// Stores the result of an elaboration, to be published.
    pub fn set_elaborated(&mut self, home: &Key, model: &Arc<str>, elaborated: Elaborated) {
        if let Some(project) = self.projects.get_mut(home) {
            project.set_elaborated(model, elaborated);
            self.dirty.insert(home.clone());
        }
    }

    pub fn close(&mut self, uri: &Uri) {
        let Some(document) = Arc::make_mut(&mut self.documents).remove(uri) else { return };
        if let Some(project) = self.projects.get_mut(&document.home) {
            project.set_opened(&document.name, false);
        }
        self.changed_on_disk(Path::new(&*document.name));
        // From now on importers use the file on disk.
        self.settle_all_with(&document.name, document.home);
        self.projects.retain(|_, project| !project.is_empty());
    }

    /// Handles a file that was written, created or deleted by any program.
    pub fn touched(&mut self, uri: &Uri) {
        let Some(path) = path_of(uri) else { return };
        self.changed_on_disk(&path);
        for key in self.projects.keys().cloned().collect::<Vec<_>>() {
            // A new file may resolve imports that had failed.
            if let Key::Folder(folder) = &key
                && path.starts_with(folder)
            {
                self.settle(key);
            }
        }
    }

    fn changed_on_disk(&mut self, path: &Path) {
        if let Some(folder) = path.parent() {
            self.disk.imported.remove(folder);
        }
    }

    fn settle_all_with(&mut self, name: &Arc<str>, home: Key) {
        let path = Path::new(&**name);
        let mut keys: BTreeSet<Key> = [home].into();
        for (key, project) in &self.projects {
            let below = matches!(key, Key::Folder(folder) if path.starts_with(folder));
            if below || project.files().contains_key(name) {
                keys.insert(key.clone());
            }
        }
        keys.into_iter().for_each(|key| self.settle(key));
    }

    fn settle(&mut self, key: Key) {
        self.revision += 1;
        let Some(project) = self.projects.get_mut(&key) else { return };
        self.dirty.insert(key.clone());
        let imported = match &key {
            Key::Library => return,
            Key::Alone(_) => BTreeSet::new(),
            Key::Folder(folder) => self.disk.imported(folder, &self.allowed).clone(),
        };
        project.settle(&FileView { documents: &self.documents, allowed: &self.allowed, imported });
        // A file imported by this project belongs to it, not to the project of its own folder.
        let adopted: Vec<(Uri, Document)> = self
            .documents
            .iter()
            .filter(|(_, document)| document.home != key && project.files().contains_key(&document.name))
            .map(|(uri, document)| (uri.clone(), document.clone()))
            .collect();
        for (uri, document) in adopted {
            let is_model = |project: &Project| project.models().contains(&document.name);
            let leaves = self.projects.get(&document.home).is_some_and(is_model);
            if !leaves {
                continue;
            }
            if let Some(document) = Arc::make_mut(&mut self.documents).get_mut(&uri) {
                document.home = key.clone();
            }
            if let Some(project) = self.projects.get_mut(&document.home) {
                project.set_opened(&document.name, false);
            }
            if let Some(project) = self.projects.get_mut(&key) {
                project.set_opened(&document.name, true);
            }
            self.settle(document.home.clone());
            self.projects.retain(|_, project| !project.is_empty());
            self.settle(key.clone());
        }
    }

    /// Returns the display name of a file, and the project of its own folder.
    fn name(&self, uri: &Uri) -> (Arc<str>, Key) {
        let Some(path) = path_of(uri) else {
            let name: Arc<str> = uri.as_str().into();
            return (name.clone(), Key::Alone(name));
        };
        if let Some(file) = self.library.at(&path) {
            return (file.name.as_str().into(), Key::Library);
        }
        let name: Arc<str> = path.display().to_string().into();
        match path.parent() {
            Some(folder) => (name, Key::Folder(folder.to_path_buf())),
            None => (name.clone(), Key::Alone(name)),
        }
    }

    /// Returns the project of the nearest folder whose models import a file, or that of its own
    /// folder.
    fn home(&mut self, name: &Arc<str>, own: Key) -> Key {
        /// Largest depth of modules below their models that is searched.
        const MOST_LEVELS: usize = 4;
        let Key::Folder(folder) = &own else { return own };
        let path = Path::new(&**name);
        for ancestor in folder.ancestors().take(MOST_LEVELS) {
            let Some(dotted) = dotted(ancestor, path) else { continue };
            let key = Key::Folder(ancestor.to_path_buf());
            let open = self.projects.get(&key).is_some_and(|project| project.files().contains_key(name));
            if open || self.disk.imported(ancestor, &self.allowed).contains(&dotted) {
                return key;
            }
            if self.roots.iter().any(|root| root == ancestor) {
                break;
            }
        }
        own
    }
}

/// Returns the path of a file.
pub fn path_of(uri: &Uri) -> Option<PathBuf> {
    let is_file = uri.scheme().as_str().eq_ignore_ascii_case("file");
    if is_file { uri.to_file_path().map(|path| path.into_owned()) } else { None }
}
