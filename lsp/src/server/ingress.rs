//! Entry point of messages, in order of arrival.
//!
//! The protocol crate polls answers concurrently and in any order, but calls this service in the
//! order of arrival. Therefore texts change inside `call`, before any await point, and a request
//! takes its views of the texts there too. Its answer is computed immediately on a separate thread:
//! a view in a queue would block the next change of a text.

use super::Shared;
use super::backend::Backend;
use super::framing::{MALFORMED, Malformed};
use super::job::{Cancel, Job, failed};
use super::router::Router;
use super::runs::Stop;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::any::Any;
use std::collections::HashMap;
use std::future::{Future, poll_fn, ready};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::pin::Pin;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll};
use tower::Service;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Id, Request, Response};
use tower_lsp_server::ls_types::notification::{
    DidChangeTextDocument, DidChangeWatchedFiles, DidChangeWorkspaceFolders, DidCloseTextDocument,
    DidOpenTextDocument, DidSaveTextDocument, Notification, WorkDoneProgressCancel,
};
use tower_lsp_server::ls_types::{InitializeParams, Uri};
use tower_lsp_server::{ExitedError, LspService};

/// State of the protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Before `initialize`.
    Waiting,
    Running,
    /// After `shutdown`.
    ShutDown,
}

/// Requests in progress.
#[derive(Clone, Default)]
struct Pending(Arc<Mutex<HashMap<Id, Arc<Cancel>>>>);

impl Pending {
    fn lock(&self) -> MutexGuard<'_, HashMap<Id, Arc<Cancel>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Service that applies changes of texts, starts queries about them, and passes other messages to
/// the inner service.
pub struct Ingress {
    pub(super) inner: LspService<Backend>,
    pub(super) shared: Arc<Shared>,
    router: Router,
    pending: Pending,
}

type Answer = Pin<Box<dyn Future<Output = Result<Option<Response>, ExitedError>> + Send>>;

impl Service<Request> for Ingress {
    type Response = Option<Response>;
    type Error = ExitedError;
    type Future = Answer;

    fn poll_ready(&mut self, context: &mut Context<'_>) -> Poll<Result<(), ExitedError>> {
        self.inner.poll_ready(context)
    }

    /// Handles a message. A panic is answered or logged: it must not end the loop that reads
    /// messages.
    fn call(&mut self, request: Request) -> Answer {
        self.shared.record(&request);
        let (method, id) = (request.method().to_owned(), request.id().cloned());
        let shared = self.shared.clone();
        let refused = move |panic: &(dyn Any + Send)| {
            let error = failed(&shared.log, &method, panic);
            id.clone().map(|id| Response::from_error(id, error))
        };
        let mut answer = match catch_unwind(AssertUnwindSafe(|| self.dispatch(request))) {
            Ok(answer) => answer,
            Err(panic) => return Box::pin(ready(Ok(refused(&*panic)))),
        };
        Box::pin(poll_fn(move |context| {
            match catch_unwind(AssertUnwindSafe(|| answer.as_mut().poll(context))) {
                Ok(poll) => poll,
                Err(panic) => Poll::Ready(Ok(refused(&*panic))),
            }
        }))
    }
}

impl Ingress {
    pub(super) fn new(inner: LspService<Backend>, shared: Arc<Shared>, router: Router) -> Ingress {
        Ingress { inner, shared, router, pending: Pending::default() }
    }

    fn dispatch(&mut self, request: Request) -> Answer {
        let phase = self.shared.phase();
        match (request.method(), phase) {
            // The protocol has no notifications of these names.
            ("initialize" | "shutdown", _) if request.id().is_none() => Box::pin(ready(Ok(None))),
            (MALFORMED, _) => {
                let error = Malformed::answer(request.params());
                self.shared.log.error(&format!("malformed message: {}", error.message));
                let id = request.id().cloned().unwrap_or_default();
                Box::pin(ready(Ok(Some(Response::from_error(id, error)))))
            }
            ("initialize", Phase::Waiting) => {
                let params = request.params().cloned().unwrap_or_default();
                if let Ok(params) = serde_json::from_value::<InitializeParams>(params) {
                    self.shared.workspace().initialize(&params);
                    self.shared.set_phase(Phase::Running);
                }
                Box::pin(self.inner.call(request))
            }
            ("shutdown", Phase::Running) => {
                self.shared.set_phase(Phase::ShutDown);
                Box::pin(self.inner.call(request))
            }
            ("$/cancelRequest", _) => {
                if let Some(id) = request.params().and_then(|params| params.get("id"))
                    && let Ok(id) = serde_json::from_value::<Id>(id.clone())
                    && let Some(cancel) = self.pending.lock().get(&id)
                {
                    cancel.cancel();
                }
                Box::pin(self.inner.call(request))
            }
            _ if self.router.route(request.method()).is_some() => self.ask(request, phase),
            (_, Phase::Running) if request.id().is_none() && self.apply(&request) => {
                Box::pin(ready(Ok(None)))
            }
            _ => Box::pin(self.inner.call(request)),
        }
    }

    /// Starts a query about texts.
    fn ask(&mut self, request: Request, phase: Phase) -> Answer {
        let (method, id, params) = request.into_parts();
        let (Some(id), Some(route)) = (id, self.router.route(&method).cloned()) else {
            return Box::pin(ready(Ok(None)));
        };
        let refusal = match phase {
            Phase::Waiting => Some(Error::new(ErrorCode::ServerError(-32002))),
            Phase::ShutDown => Some(Error::invalid_request()),
            Phase::Running => None,
        };
        if let Some(mut error) = refusal {
            if phase == Phase::Waiting {
                error.message = "the server is not initialized".into();
            }
            return Box::pin(ready(Ok(Some(Response::from_error(id, error)))));
        }
        let params = params.unwrap_or_default();
        let uri = document_of(&params);
        let version = uri.as_ref().and_then(|uri| self.shared.workspace().version(uri));
        let cancel = Arc::new(Cancel::default());
        self.pending.lock().insert(id.clone(), cancel.clone());
        let job = Job { method: method.into_owned(), params, route, uri, version, cancel };
        let shared = self.shared.clone();
        let views = job.views(&shared);
        let answering = tokio::task::spawn_blocking(move || job.run(&shared, views));
        let pending = self.pending.clone();
        Box::pin(async move {
            // A panic of an attempt is answered by its own error. This error covers a panic between
            // attempts and a runtime that shuts down.
            let result = answering.await.unwrap_or_else(|_| Err(Error::internal_error()));
            pending.lock().remove(&id);
            Ok(Some(Response::from_parts(id, result)))
        })
    }

    /// Applies a notification that changes texts or stops a run; returns true if it is one.
    fn apply(&self, request: &Request) -> bool {
        let method = request.method();
        let params = request.params().cloned().unwrap_or_default();
        let applied = match method {
            DidOpenTextDocument::METHOD => self.with::<DidOpenTextDocument>(params, |shared, params| {
                let document = params.text_document;
                shared.workspace().open(document.uri, document.version, document.text);
            }),
            DidChangeTextDocument::METHOD => self.with::<DidChangeTextDocument>(params, |shared, params| {
                let document = params.text_document;
                let mut workspace = shared.workspace();
                if let Some(home) = workspace.home_of(&document.uri) {
                    shared.background.edited(home);
                }
                workspace.change(&document.uri, document.version, &params.content_changes);
            }),
            DidCloseTextDocument::METHOD => self.with::<DidCloseTextDocument>(params, |shared, params| {
                shared.workspace().close(&params.text_document.uri);
            }),
            DidSaveTextDocument::METHOD => self.with::<DidSaveTextDocument>(params, |shared, params| {
                shared.workspace().touched(&params.text_document.uri);
            }),
            DidChangeWatchedFiles::METHOD => self.with::<DidChangeWatchedFiles>(params, |shared, params| {
                for change in &params.changes {
                    shared.workspace().touched(&change.uri);
                }
            }),
            DidChangeWorkspaceFolders::METHOD => {
                self.with::<DidChangeWorkspaceFolders>(params, |shared, params| {
                    shared.workspace().change_roots(&params.event);
                })
            }
            WorkDoneProgressCancel::METHOD => {
                self.with::<WorkDoneProgressCancel>(params, |shared, params| {
                    shared.runs.stop(&Stop::Token(params.token));
                })
            }
            _ => return false,
        };
        if let Err(error) = applied {
            self.shared.log.error(&format!("{method} cannot be read: {error}"));
        }
        self.shared.wake.wake();
        true
    }

    fn with<N: Notification>(
        &self,
        params: Value,
        apply: impl FnOnce(&Shared, N::Params),
    ) -> Result<(), serde_json::Error>
    where
        N::Params: DeserializeOwned,
    {
        apply(&self.shared, serde_json::from_value(params)?);
        Ok(())
    }
}

/// Returns the document of a request. The document stored with an item by an earlier answer takes
/// precedence over the item's own, which need not be open.
fn document_of(params: &Value) -> Option<Uri> {
    let places = ["/textDocument/uri", "/item/data/uri", "/item/uri", "/data/uri"];
    let uri = places.iter().find_map(|place| params.pointer(place)?.as_str());
    uri.and_then(|uri| uri.parse().ok())
}
