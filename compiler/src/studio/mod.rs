//! Local web server of `calyx studio`: a form made from the params of a model, runs of it, their
//! progress and their results, for a page in a browser.
//!
//! - Routes and their JSON: [`api`]. One event stream announces changes of the model, of the list
//!   of runs, and progress: browsers open at most six connections to a server.
//! - Each run is a process of its own, `calyx run` with `--progress json` ([`process`]): a run that
//!   fails or exceeds the memory does not end the studio, and its results are those of the command
//!   line, to the last bit.
//! - Requests need the token of the printed address, and headers of the page itself ([`access`]).
//! - Next to `MODEL.cx`, the folder `MODEL.cx.studio` has the runs and the session ([`folder`]).
//!   Two studios of one model share it: directories of runs are created, never replaced, and the
//!   session file is replaced as a whole.

mod access;
mod api;
mod check;
mod error;
mod events;
mod files;
mod folder;
mod form;
mod model;
mod page;
mod process;
mod requests;
mod results;
mod runs;
mod session;
mod settings;
mod subject;

pub use error::StudioError;
pub use subject::Subject;

use access::Access;
use events::Events;
use model::Model;
use runs::Runs;
use session::Session;
use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

/// Largest number of checks at a time. Others wait.
const CHECKS: usize = 2;

/// Options of a studio.
#[derive(Clone, Debug)]
pub struct Options {
    /// Model and run to show.
    pub subject: Subject,
    /// Host name or IP address to listen on.
    pub listen: String,
    /// Port to listen on; 0 selects a free one.
    pub port: u16,
    /// Path of the `calyx` command, which runs models.
    pub command: PathBuf,
    /// Files and directories outside of the model's directory that the model may read.
    pub allowed: Arc<[PathBuf]>,
}

/// State that all requests share.
pub(crate) struct Studio {
    access: Access,
    /// The model; `None` if only the directory of a run is known.
    model: Option<Model>,
    runs: Runs,
    session: Option<Session>,
    events: Events,
    checks: Semaphore,
}

/// Serves the studio until the process is interrupted. Calls `ready` with the address, which
/// includes the token, once the server accepts connections.
///
/// # Errors
/// The address cannot be listened on, or the system provides no random numbers or threads.
pub fn serve(options: Options, ready: impl FnOnce(&str)) -> Result<(), StudioError> {
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build();
    let runtime = runtime.map_err(|error| StudioError::new("cannot start the server", &error))?;
    let outcome = runtime.block_on(serve_here(options, ready));
    // A check in progress, which cannot be interrupted, does not delay the end.
    runtime.shutdown_background();
    outcome
}

async fn serve_here(options: Options, ready: impl FnOnce(&str)) -> Result<(), StudioError> {
    let folder = options.subject.model.as_deref().map(folder::of_model);
    if let Some(folder) = folder.filter(|path| !path.is_dir() && path.symlink_metadata().is_ok()) {
        let message =
            format!("{} is not a folder, and the studio stores runs in one of this name", folder.display());
        return Err(StudioError::with_help(message, "rename or move it"));
    }
    let shown = format!("{}:{}", options.listen, options.port);
    let unbound = |error: io::Error| StudioError::new(format!("cannot listen on {shown}"), &error);
    let listener = TcpListener::bind((options.listen.as_str(), options.port)).await.map_err(unbound)?;
    let address: SocketAddr = listener.local_addr().map_err(unbound)?;
    let access = Access::new(&options.listen, address)
        .map_err(|error| StudioError::new("the system provides no random numbers", &error))?;
    let url = access.url();
    let events = Events::default();
    let Subject { model, run } = options.subject;
    let studio = Arc::new(Studio {
        access,
        session: model.as_deref().map(Session::of_model),
        runs: Runs::new(model.clone(), run, options.command, options.allowed.clone(), events.clone()),
        model: model.map(|path| Model::new(path, options.allowed)),
        events,
        checks: Semaphore::new(CHECKS),
    });
    let watching = tokio::spawn(events::watch(studio.clone()));
    let app = api::router(studio.clone());
    ready(&url);
    let served = tokio::select! {
        served = axum::serve(listener, app) => {
            served.map_err(|error| StudioError::new("the server ended", &error))
        }
        () = interrupted() => Ok(()),
    };
    watching.abort();
    studio.runs.end_all().await;
    served
}

/// Waits for Ctrl-C, or for the end of the session that the process belongs to.
async fn interrupted() {
    use tokio::signal::unix::{SignalKind, signal};
    let kinds = [SignalKind::interrupt(), SignalKind::terminate(), SignalKind::hangup()];
    let [interrupt, terminate, hangup] = kinds.map(|kind| async move {
        match signal(kind) {
            Ok(mut signals) => drop(signals.recv().await),
            Err(_) => std::future::pending().await,
        }
    });
    tokio::select! {
        () = interrupt => {}
        () = terminate => {}
        () = hangup => {}
    }
}
