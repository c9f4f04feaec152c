//! One request on its way to an answer.

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

/// Lets a client take its question back.
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

    /// From now on views are stopped if they are no longer wanted.
    fn watch(&self, views: &[View]) {
        let mut cancellers = self.cancellers.lock().unwrap_or_else(PoisonError::into_inner);
        *cancellers = views.iter().map(|view| view.snapshot.database.canceller()).collect();
        if self.is_asked() {
            cancellers.iter().for_each(Canceller::cancel);
        }
    }
}

/// A question and what it was asked about.
pub struct Job {
    pub method: String,
    pub params: Value,
    pub route: Route,
    pub uri: Option<Uri>,
    /// The version of the document when the question was asked.
    pub version: Option<i32>,
    pub cancel: Arc<Cancel>,
}

/// How often a question is asked again because something else changed.
const MOST_ATTEMPTS: usize = 5;

impl Job {
    /// What the question is answered on, as everything is now.
    pub fn views(&self, shared: &Shared) -> Vec<View> {
        let workspace = shared.workspace();
        match &self.route {
            Route::OfDocument(_) => workspace.view(self.uri.as_ref()).into_iter().collect(),
            Route::OfWorkspace(_) => workspace.views(),
        }
    }

    /// Answers on the views taken when the question arrived. If they are superseded, and the document it is about is still the
    /// same, on new ones.
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

    /// `None` if the answer is superseded. The views are gone afterwards, as whoever changes a text waits for that.
    fn attempt(&self, shared: &Shared, views: Vec<View>) -> Option<Result<Value>> {
        let params = self.params.clone();
        let answered = catch_unwind(AssertUnwindSafe(|| match (&self.route, views.as_slice()) {
            // Of a document that is not known nothing can be said.
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

/// Logs the panic of a task, and returns the error that answers whoever waits for it.
pub fn failed(log: &Log, task: &str, panic: &(dyn Any + Send)) -> Error {
    let message = format!("{task} failed: {}", reason(panic));
    log.error(&message);
    let mut error = Error::internal_error();
    error.message = message.into();
    error
}

/// Runs a task of a thread that serves all projects, and logs its panic: the thread must live on.
pub fn isolated<T>(log: &Log, task: &str, run: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(run)).map_err(|panic| failed(log, task, &*panic)).ok()
}

/// What a panic says of itself.
pub fn reason(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("a defect without a message")
}
