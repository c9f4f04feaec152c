//! Errors of the studio: of its start, and of its requests.

use super::page::json_response;
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use serde_json::json;
use std::fmt;

/// Reason why the studio did not start or ended.
#[derive(Debug)]
pub struct StudioError {
    message: String,
    help: &'static str,
}

impl StudioError {
    pub(crate) fn new(message: impl Into<String>, cause: &dyn fmt::Display) -> StudioError {
        let help = "choose another port with --port, or another address with --listen";
        StudioError { message: format!("{}: {cause}", message.into()), help }
    }

    pub(crate) fn with_help(message: impl Into<String>, help: &'static str) -> StudioError {
        StudioError { message: message.into(), help }
    }

    /// Returns the remedy.
    pub fn help(&self) -> &'static str {
        self.help
    }
}

impl fmt::Display for StudioError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for StudioError {}

/// Error of a request: a status and a JSON object `{code, message, help}`.
#[derive(Debug)]
pub(crate) struct RequestError {
    status: StatusCode,
    message: String,
    help: String,
}

impl RequestError {
    pub fn new(status: StatusCode, message: impl Into<String>, help: impl Into<String>) -> RequestError {
        RequestError { status, message: message.into(), help: help.into() }
    }

    pub fn not_found(message: impl Into<String>) -> RequestError {
        RequestError::new(StatusCode::NOT_FOUND, message, "")
    }

    pub fn invalid(message: impl Into<String>, help: impl Into<String>) -> RequestError {
        RequestError::new(StatusCode::BAD_REQUEST, message, help)
    }

    pub fn conflict(message: impl Into<String>, help: impl Into<String>) -> RequestError {
        RequestError::new(StatusCode::CONFLICT, message, help)
    }

    /// Creates the error of an operation on files, or of a task that ended.
    pub fn internal(message: impl Into<String>, cause: &dyn fmt::Display) -> RequestError {
        let message = format!("{}: {cause}", message.into());
        RequestError::new(StatusCode::INTERNAL_SERVER_ERROR, message, "")
    }
}

/// Returns the code of a status in the JSON of errors.
fn code(status: StatusCode) -> &'static str {
    match status {
        StatusCode::UNAUTHORIZED => "unauthorized",
        StatusCode::FORBIDDEN => "forbidden",
        StatusCode::NOT_FOUND => "not_found",
        StatusCode::METHOD_NOT_ALLOWED => "method_not_allowed",
        StatusCode::CONFLICT => "conflict",
        StatusCode::PAYLOAD_TOO_LARGE => "too_large",
        StatusCode::UNSUPPORTED_MEDIA_TYPE => "not_json",
        status if status.is_server_error() => "internal",
        _ => "invalid_request",
    }
}

impl IntoResponse for RequestError {
    fn into_response(self) -> Response {
        let RequestError { status, message, help } = self;
        let body = json!({ "code": code(status), "message": message, "help": help });
        (status, json_response(&body)).into_response()
    }
}
