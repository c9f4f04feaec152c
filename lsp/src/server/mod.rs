//! Implementation of the Language Server Protocol.
//!
//! [`framing`] reads messages from the stream and reports malformed ones. [`ingress`] handles
//! messages in order of arrival: it applies changes of texts ([`workspace`]) and takes the [`view`]
//! for each request. [`router`] maps requests to [`handlers`]; [`job`] runs each on a separate
//! thread. [`diagnostics`] are published after every change, those of gears by the [`background`]
//! elaboration. [`commands`] run models, in separate processes. Protocol types are used in this
//! module only.

mod backend;
mod background;
mod capabilities;
pub mod client;
mod commands;
pub mod convert;
pub mod diagnostics;
mod framing;
pub mod handlers;
mod imports;
mod ingress;
mod job;
pub mod library;
pub mod log;
pub mod project;
pub mod router;
mod runs;
pub mod text;
pub mod view;
pub mod workspace;

use backend::Backend;
use background::Background;
use diagnostics::PublishSignal;
use framing::Reader;
use ingress::{Ingress, Phase};
use library::Library;
use log::{Level, Log};
use router::Router;
use runs::Runs;
use std::fs::File;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::runtime::{Builder, Handle};
use tower_lsp_server::jsonrpc::Request;
use tower_lsp_server::{LspService, Server};
use workspace::Workspace;

/// Options of a server.
pub struct Options {
    pub library: Library,
    pub log: Level,
    /// Path of the `calyx` command, which runs models.
    pub executable: PathBuf,
    /// File that records the messages from the client, one JSON object per line, for bug reports.
    pub record: Option<PathBuf>,
}

/// Serves a client on standard input and output until it sends `exit` or disconnects. Returns true
/// after a correct shutdown.
///
/// # Errors
/// Threads cannot be created, or the record file cannot be written.
pub fn stdio(options: Options) -> io::Result<bool> {
    // A change of a text may block the thread that reads messages, so there is a second one.
    let runtime = Builder::new_multi_thread().worker_threads(2).enable_all().build()?;
    let left = runtime.block_on(serve(tokio::io::stdin(), tokio::io::stdout(), options, handlers::router()));
    // Standard input may never end, and no other answers are needed.
    runtime.shutdown_background();
    left
}

/// Serves a client on any pair of streams; requires a runtime with several threads.
///
/// # Errors
/// The record file cannot be written.
pub async fn serve(
    input: impl AsyncRead + Unpin,
    output: impl AsyncWrite,
    options: Options,
    router: Router,
) -> io::Result<bool> {
    let record = options.record.map(File::create).transpose()?;
    let mut made = None;
    let (service, socket) = LspService::new(|client| {
        let log = Log::new(options.log, client.clone(), Handle::current());
        let workspace = Workspace::new(options.library);
        let shared = Arc::new(Shared::new(workspace, log, options.executable, record));
        made = Some((shared.clone(), client.clone()));
        Backend { shared, client }
    });
    let Some((shared, client)) = made else { return Ok(false) };
    diagnostics::start(shared.clone(), client, Handle::current())?;
    background::start(shared.clone())?;
    let ingress = Ingress::new(service, shared.clone(), router);
    let log = shared.log.clone();
    let input = Reader::new(input, move |reason: &str| log.error(reason));
    /// Largest number of answers that wait to be sent; they are computed elsewhere.
    const MOST_ANSWERS: usize = 256;
    Server::new(input, output, socket).concurrency_level(MOST_ANSWERS).serve(ingress).await;
    if shared.phase() == Phase::Running {
        shared.log.info("the client has gone without `shutdown`");
    }
    shared.wake.stop();
    shared.background.stop();
    Ok(shared.phase() == Phase::ShutDown)
}

/// State shared by all parts of the server.
pub(crate) struct Shared {
    workspace: Mutex<Workspace>,
    phase: Mutex<Phase>,
    pub log: Log,
    pub wake: PublishSignal,
    pub background: Background,
    pub runs: Runs,
    pub executable: PathBuf,
    record: Option<Mutex<File>>,
}

impl Shared {
    fn new(workspace: Workspace, log: Log, executable: PathBuf, record: Option<File>) -> Shared {
        Shared {
            workspace: Mutex::new(workspace),
            phase: Mutex::new(Phase::Waiting),
            log,
            wake: PublishSignal::default(),
            background: Background::default(),
            runs: Runs::default(),
            executable,
            record: record.map(Mutex::new),
        }
    }

    /// Locks the workspace. Must not be called by a thread with a view: a thread that changes a
    /// text holds this lock and waits until all views are dropped.
    pub fn workspace(&self) -> MutexGuard<'_, Workspace> {
        self.workspace.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn phase(&self) -> Phase {
        *self.phase.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn set_phase(&self, phase: Phase) {
        *self.phase.lock().unwrap_or_else(PoisonError::into_inner) = phase;
    }

    fn record(&self, request: &Request) {
        if let Some(file) = &self.record {
            let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
            // Errors of the record are ignored.
            let _ = writeln!(file, "{request}");
        }
    }
}
