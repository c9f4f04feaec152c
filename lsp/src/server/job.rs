//! Execution of one request.

use super::Shared;
use super::log::Log;
use super::router::Route;
use super::view::View;
use calyx_lang::db::{Canceller, Superseded, attempt};
use calyx_lang::deep_recursion::with_deep_stack;
use serde_json::Value;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::Uri;

/// Cancellation of a request by the client.
#[derive(Default)]
pub struct Cancel {
    asked: AtomicBool,
    cancellers: Mutex<Vec<Canceller>>,
}

impl Cancel {
    pub fn cancel(&self) {
        self.asked.store(true, Ordering::SeqCst);
        let cancellers = self.cancellers.lock().unwrap_or_else(PoisonError::into_inner);
        cancellers.iter().for_each(Canceller::cancel);
    }

    fn is_asked(&self) -> bool {
        self.asked.load(Ordering::SeqCst)
    }

    /// Registers the views to be cancelled.
    fn watch(&self, views: &[View]) {
        let mut cancellers = self.cancellers.lock().unwrap_or_else(PoisonError::into_inner);
        *cancellers = views.iter().map(|view| view.snapshot.database.canceller()).collect();
        if self.is_asked() {
            cancellers.iter().for_each(Canceller::cancel);
        }
    }
}

/// A request and its subject.
pub struct Job {
    pub method: String,
    pub params: Value,
    pub route: Route,
    pub uri: Option<Uri>,
    /// Version of the document at the time of the request.
    pub version: Option<i32>,
    pub cancel: Arc<Cancel>,
}

/// Largest number of attempts to answer a request, each after a change of another document.
const MOST_ATTEMPTS: usize = 5;

impl Job {
    /// Returns the current views on which to answer the request.
    pub fn views(&self, shared: &Shared) -> Vec<View> {
        let workspace = shared.workspace();
        match &self.route {
            Route::OfDocument(_) => workspace.view(self.uri.as_ref()).into_iter().collect(),
            Route::OfWorkspace(_) => workspace.views(),
        }
    }

    /// Answers on the views taken at the arrival of the request. If these are superseded and the
    /// document itself is unchanged, retries on new views.
    pub fn run(self, shared: &Shared, mut views: Vec<View>) -> Result<Value> {
        for _ in 0..MOST_ATTEMPTS {
            self.cancel.watch(&views);
            let attempt = self.attempt(shared, views);
            if let Some(answer) = attempt {
                return answer;
            }
            if self.cancel.is_asked() {
                return Err(Error::request_cancelled());
            }
            let version = self.uri.as_ref().and_then(|uri| shared.workspace().version(uri));
            if version != self.version {
                break;
            }
            views = self.views(shared);
        }
        Err(Error::content_modified())
    }

    /// Tries to answer; `None` if a change supersedes the views. The views are dropped on return,
    /// because a change of a text waits for that.
    fn attempt(&self, shared: &Shared, views: Vec<View>) -> Option<Result<Value>> {
        let params = self.params.clone();
        let answered = catch_unwind(AssertUnwindSafe(|| match (&self.route, views.as_slice()) {
            // There is no answer about an unknown document.
            (Route::OfDocument(_), []) => Ok(Ok(Value::Null)),
            (Route::OfDocument(answer), [view, ..]) => {
                view.snapshot.database.attempt(|_| with_deep_stack(|| answer(view, params)))
            }
            (Route::OfWorkspace(answer), all) => attempt(|| with_deep_stack(|| answer(all, params))),
        }));
        drop(views);
        match answered {
            Ok(Ok(answer)) => Some(answer),
            Ok(Err(Superseded)) => None,
            Err(panic) => Some(Err(failed(&shared.log, &self.method, &*panic))),
        }
    }
}

/// Logs the panic of a task, and returns the error for the waiting client.
pub fn failed(log: &Log, task: &str, panic: &(dyn Any + Send)) -> Error {
    let message = format!("{task} failed: {}", reason(panic));
    log.error(&message);
    let mut error = Error::internal_error();
    error.message = message.into();
    error
}

/// Runs a task of a thread that serves all projects, and logs a panic: the thread must survive it.
pub fn isolated<T>(log: &Log, task: &str, run: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(run)).map_err(|panic| failed(log, task, &*panic)).ok()
}

/// Returns the message of a panic.
pub fn reason(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("a defect without a message")
}
