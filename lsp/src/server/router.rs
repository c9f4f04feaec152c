//! Mapping from requests to handler functions.

use super::view::View;
use serde_json::Value;
use std::collections::HashMap;
use std::sync::Arc;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::request::Request;

/// Handler with JSON params and JSON result.
type Answer<On> = Arc<dyn Fn(&On, Value) -> Result<Value> + Send + Sync>;

/// Handler of a method.
#[derive(Clone)]
pub(super) enum Route {
    /// Answers on a view of the project of the document.
    OfDocument(Answer<View>),
    /// Answers on views of all projects.
    OfWorkspace(Answer<[View]>),
}

/// Handlers by method. Answers are computed concurrently on separate threads; a change of a text
/// cancels their database queries.
#[derive(Clone, Default)]
pub struct Router {
    routes: HashMap<&'static str, Route>,
}

impl Router {
    /// Registers a handler of requests about one document: their params have a `textDocument`, or
    /// an `item` or `data` with a `uri`. Requests without these are about the document that was
    /// edited last.
    ///
    /// The answer about an unknown document is null.
    pub fn on<R: Request>(
        &mut self,
        answer: impl Fn(&View, R::Params) -> Result<R::Result> + Send + Sync + 'static,
    ) {
        let route = move |view: &View, params: Value| to_json(&answer(view, from_json(params)?)?);
        self.routes.insert(R::METHOD, Route::OfDocument(Arc::new(route)));
    }

    /// Registers a handler of requests about all open projects.
    pub fn on_all<R: Request>(
        &mut self,
        answer: impl Fn(&[View], R::Params) -> Result<R::Result> + Send + Sync + 'static,
    ) {
        let route = move |views: &[View], params: Value| to_json(&answer(views, from_json(params)?)?);
        self.routes.insert(R::METHOD, Route::OfWorkspace(Arc::new(route)));
    }

    pub(super) fn route(&self, method: &str) -> Option<&Route> {
        self.routes.get(method)
    }
}

fn from_json<P: serde::de::DeserializeOwned>(params: Value) -> Result<P> {
    serde_json::from_value(params).map_err(|error| Error::invalid_params(error.to_string()))
}

fn to_json<T: serde::Serialize>(answer: &T) -> Result<Value> {
    serde_json::to_value(answer).map_err(|error| {
        let mut failed = Error::internal_error();
        failed.message = format!("an answer that cannot be written: {error}").into();
        failed
    })
}
