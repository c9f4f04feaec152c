//! Data on which a request is answered: the state at its arrival.

use super::client::Client;
use super::library::Library;
use super::project::{File, Files, Project};
use super::workspace::{Documents, Key, Workspace, path_of};
use crate::ide;
use calyx_elaborate::results::RunSummary;
use std::collections::HashMap;
use std::sync::Arc;
use tower_lsp_server::ls_types::Uri;

/// Snapshot of a project. A change of a text waits until all views are dropped, so a view must not
/// be stored.
pub struct View {
    /// Snapshot for the queries of [`ide`].
    pub snapshot: ide::Snapshot,
    /// File of the request; empty if it has none.
    pub file: Arc<str>,
    pub files: Arc<Files>,
    pub client: Arc<Client>,
    pub documents: Arc<Documents>,
    pub project: Key,
    /// Models to check.
    pub models: Vec<Arc<str>>,
    /// Counter of all changes.
    pub revision: u64,
    runs: Arc<HashMap<Arc<str>, Arc<RunSummary>>>,
    library: Arc<Library>,
}

impl View {
    pub(super) fn new(project: &Project, key: Key, file: Arc<str>, workspace: &Workspace) -> View {
        View {
            snapshot: project.snapshot(),
            file,
            files: project.files().clone(),
            client: workspace.client.clone(),
            documents: workspace.documents().clone(),
            project: key,
            models: project.models(),
            revision: workspace.revision(),
            runs: workspace.runs().clone(),
            library: workspace.library().clone(),
        }
    }

    /// Returns a file by its display name.
    pub fn file(&self, name: &str) -> Option<&File> {
        self.files.get(name)
    }

    /// Returns the results of the last run of a model, if it has run since the server started.
    pub fn run(&self, model: &str) -> Option<&RunSummary> {
        self.runs.get(model).map(|run| &**run)
    }

    /// Returns the URI of a file.
    pub fn uri(&self, name: &str) -> Option<Uri> {
        // A client may spell a path in several ways; it receives its own spelling.
        if let Some((uri, _)) = self.documents.iter().find(|(_, document)| *document.name == *name) {
            return Some(uri.clone());
        }
        if self.file(name).is_some_and(|file| file.of_library) {
            return Uri::from_file_path(self.library.path(name)?);
        }
        Uri::from_file_path(name)
    }

    /// Returns the display name of the file with this URI, if it is part of the project.
    pub fn name(&self, uri: &Uri) -> Option<Arc<str>> {
        if let Some(document) = self.documents.get(uri) {
            return self.files.contains_key(&document.name).then(|| document.name.clone());
        }
        let name: Arc<str> = path_of(uri)?.display().to_string().into();
        self.files.contains_key(&name).then_some(name)
    }

    /// Returns the document version of an open file.
    pub fn version(&self, uri: &Uri) -> Option<i32> {
        self.documents.get(uri).map(|document| document.version)
    }
}
