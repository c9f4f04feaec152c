//! The Language Server Protocol: messages in, messages out.
//!
//! [`framing`] reads messages off the stream and reports those that are malformed.
//! [`ingress`] takes messages in the order they arrive: texts change there ([`workspace`]), and requests take the [`view`] they are
//! answered on. [`router`] knows which of the [`handlers`] answers what; [`job`] runs it on a thread of its own. [`diagnostics`]
//! follow every change, those of gears from the [`background`]. [`commands`] run models,
//! in processes of their own. Types of the protocol are named here and nowhere else.

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

/// How a server is set up.
pub struct Options {
    pub library: Library,
    pub log: Level,
    /// The `calyx` command, which runs models.
    pub executable: PathBuf,
    /// A file for the messages that arrive, one JSON object a line, to go with a bug report.
    pub record: Option<PathBuf>,
}

/// Serves a client on standard input and output until it says `exit` or is gone. Returns whether it left as it should, after
/// `shutdown`.
///
/// # Errors
/// No threads to be had, or the file to record in cannot be written.
pub fn stdio(options: Options) -> io::Result<bool> {
    // A change of a text may keep the thread waiting that reads messages, so there is another one.
    let runtime = Builder::new_multi_thread().worker_threads(2).enable_all().build()?;
    let left = runtime.block_on(serve(tokio::io::stdin(), tokio::io::stdout(), options, handlers::router()));
    // Standard input may never end, and nobody waits for other answers.
    runtime.shutdown_background();
    left
}

/// Serves a client on any pair of streams; to be run on a runtime with several threads.
///
/// # Errors
/// The file to record in cannot be written.
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
    /// Answers are computed elsewhere; this is how many may wait to be sent.
    const MOST_ANSWERS: usize = 256;
    Server::new(input, output, socket).concurrency_level(MOST_ANSWERS).serve(ingress).await;
    if shared.phase() == Phase::Running {
        shared.log.info("the client has gone without `shutdown`");
    }
    shared.wake.stop();
    shared.background.stop();
    Ok(shared.phase() == Phase::ShutDown)
}

/// What all parts of a server know.
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

    /// The workspace, for a moment. Never to be asked for by who holds a view: whoever changes a text has the workspace, and waits
    /// until there are no views.
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
            // A record that cannot be written is no reason to stop.
            let _ = writeln!(file, "{request}");
        }
    }
}
