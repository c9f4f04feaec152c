//! Life cycle of the server, and commands.

use super::Shared;
use super::capabilities::capabilities;
use super::commands;
use std::sync::Arc;
use tower_lsp_server::jsonrpc::Result;
use tower_lsp_server::ls_types::{
    DidChangeWatchedFilesRegistrationOptions, ExecuteCommandParams, FileSystemWatcher, GlobPattern,
    InitializeParams, InitializeResult, InitializedParams, LSPAny, Registration, ServerInfo,
};
use tower_lsp_server::{Client, LanguageServer};

/// Service for all messages other than queries about texts.
pub struct Backend {
    pub shared: Arc<Shared>,
    pub client: Client,
}

impl LanguageServer for Backend {
    async fn initialize(&self, _: InitializeParams) -> Result<InitializeResult> {
        let client = self.shared.workspace().client.clone();
        let version = Some(env!("CARGO_PKG_VERSION").to_owned());
        Ok(InitializeResult {
            capabilities: capabilities(&client),
            server_info: Some(ServerInfo { name: "calyx".to_owned(), version }),
            ..InitializeResult::default()
        })
    }

    async fn initialized(&self, _: InitializedParams) {
        let client = self.shared.workspace().client.clone();
        let workspace = client.capabilities.workspace.as_ref();
        let watched = workspace.and_then(|workspace| workspace.did_change_watched_files.as_ref());
        if watched.and_then(|watched| watched.dynamic_registration).unwrap_or(false) {
            self.watch_files().await;
        }
    }

    async fn shutdown(&self) -> Result<()> {
        Ok(())
    }

    async fn execute_command(&self, params: ExecuteCommandParams) -> Result<Option<LSPAny>> {
        commands::execute(&self.shared, &self.client, params).await
    }
}

impl Backend {
    /// Registers for notifications about changes of models and modules on disk.
    async fn watch_files(&self) {
        let watcher =
            FileSystemWatcher { glob_pattern: GlobPattern::String("**/*.cx".to_owned()), kind: None };
        let options = DidChangeWatchedFilesRegistrationOptions { watchers: vec![watcher] };
        let registration = Registration {
            id: "calyx-files".to_owned(),
            method: "workspace/didChangeWatchedFiles".to_owned(),
            register_options: serde_json::to_value(options).ok(),
        };
        if let Err(error) = self.client.register_capability(vec![registration]).await {
            self.shared.log.error(&format!("files on the disk are not watched: {error}"));
        }
    }
}
