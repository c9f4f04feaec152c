//! What a request is answered on: everything as it was when the request arrived.

use super::client::Client;
use super::library::Library;
use super::project::{File, Files, Project};
use super::workspace::{Documents, Key, Workspace, path_of};
use crate::ide;
use calyx_elaborate::results::RunSummary;
use std::collections::HashMap;
use std::sync::Arc;
use tower_lsp_server::ls_types::Uri;

/// A project at one moment. A text that changes waits until all views are gone, so none may be kept.
pub struct View {
    /// For the questions of [`ide`].
    pub snapshot: ide::Snapshot,
    /// The file that was asked about; empty if none was.
    pub file: Arc<str>,
    pub files: Arc<Files>,
    pub client: Arc<Client>,
    pub documents: Arc<Documents>,
    pub project: Key,
    /// Models to check.
    pub models: Vec<Arc<str>>,
    /// Counts changes of anything.
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

    /// A file by its name as shown to people.
    pub fn file(&self, name: &str) -> Option<&File> {
        self.files.get(name)
    }

    /// What the last run of a model has given, if it has run since the server began.
    pub fn run(&self, model: &str) -> Option<&RunSummary> {
        self.runs.get(model).map(|run| &**run)
    }

    /// What clients call a file.
    pub fn uri(&self, name: &str) -> Option<Uri> {
        // A client may spell a path in more than one way; it gets back its own.
        if let Some((uri, _)) = self.documents.iter().find(|(_, document)| *document.name == *name) {
            return Some(uri.clone());
        }
        if self.file(name).is_some_and(|file| file.of_library) {
            return Uri::from_file_path(self.library.path(name)?);
        }
        Uri::from_file_path(name)
    }

    /// The name of the file that a client calls so, if it is part of the project.
    pub fn name(&self, uri: &Uri) -> Option<Arc<str>> {
        if let Some(document) = self.documents.get(uri) {
            return self.files.contains_key(&document.name).then(|| document.name.clone());
        }
        let name: Arc<str> = path_of(uri)?.display().to_string().into();
        self.files.contains_key(&name).then_some(name)
    }

    /// The version of a file that is open.
    pub fn version(&self, uri: &Uri) -> Option<i32> {
        self.documents.get(uri).map(|document| document.version)
    }
}
