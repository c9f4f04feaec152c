//! Which function answers which request.

use super::view::View;
use serde_json::Value;
use std::collections::HashMap;
use std::sync::Arc;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::request::Request;

/// Params in, result out, both as JSON.
type Answer<On> = Arc<dyn Fn(&On, Value) -> Result<Value> + Send + Sync>;

/// How the requests of one method are answered.
#[derive(Clone)]
pub(super) enum Route {
    /// On a view of the project of the document it is about.
    OfDocument(Answer<View>),
    /// On views of all projects.
    OfWorkspace(Answer<[View]>),
}

/// Requests by their methods. Answers are computed on threads of their own, several at a time; when a text changes meanwhile they are
/// interrupted in the middle of what they ask the database.
#[derive(Clone, Default)]
pub struct Router {
    routes: HashMap<&'static str, Route>,
}

impl Router {
    /// Answers a request about one document: its params have a `textDocument`, or an `item` or `data` with a `uri`. Any
    /// other is about the document that was edited last.
    ///
    /// About a document that is not known nothing is said.
    pub fn on<R: Request>(
        &mut self,
        answer: impl Fn(&View, R::Params) -> Result<R::Result> + Send + Sync + 'static,
    ) {
        let route = move |view: &View, params: Value| to_json(&answer(view, from_json(params)?)?);
        self.routes.insert(R::METHOD, Route::OfDocument(Arc::new(route)));
    }

    /// Answers a request about everything that is open.
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
