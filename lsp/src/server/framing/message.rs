//! Validation of JSON-RPC messages.

use serde_json::{Value, json};
use std::str::from_utf8;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Id, Request, Response};

/// Method of the request that represents a malformed message.
pub const MALFORMED: &str = "calyx/malformedMessage";

/// Error of a malformed message.
#[derive(Clone, Debug, PartialEq)]
pub struct Malformed {
    /// Error code of JSON-RPC.
    pub code: i64,
    pub problem: String,
    /// Id of the answer; JSON-RPC requires `null` if the message has no valid one.
    pub id: Id,
}

impl Malformed {
    /// Returns the error of a message that is no JSON text, or has no header.
    pub(super) fn unparsable(problem: String) -> Malformed {
        Malformed { code: ErrorCode::ParseError.code(), problem, id: Id::Null }
    }

    /// Returns the error of a JSON text that is no message.
    fn invalid(problem: impl Into<String>, id: Id) -> Malformed {
        Malformed { code: ErrorCode::InvalidRequest.code(), problem: problem.into(), id }
    }

    /// Returns the request that represents this message.
    pub(super) fn request(&self) -> String {
        let params = json!({ "code": self.code, "message": self.problem });
        json!({ "jsonrpc": "2.0", "id": self.id, "method": MALFORMED, "params": params }).to_string()
    }

    /// Returns the answer to a request that represents a malformed message.
    pub fn answer(params: Option<&Value>) -> Error {
        let code = params.and_then(|params| params.get("code")).and_then(Value::as_i64);
        let message = params.and_then(|params| params.get("message")).and_then(Value::as_str);
        let mut error = Error::invalid_request();
        error.code = code.map_or(ErrorCode::InvalidRequest, ErrorCode::from);
        if let Some(message) = message {
            error.message = message.to_owned().into();
        }
        error
    }
}

/// Decodes the body of a message. Returns JSON that the protocol crate can decode.
pub(super) fn decode(body: &[u8]) -> Result<String, Malformed> {
    let text = from_utf8(body).map_err(|error| {
        let at = error.valid_up_to();
        Malformed::unparsable(format!("the message is not valid UTF-8 at byte {at}"))
    })?;
    let message: Value = serde_json::from_str(text)
        .map_err(|error| Malformed::unparsable(format!("the message is not valid JSON: {error}")))?;
    let known = message.get("id").filter(|_| message.get("method").is_some());
    let known: Id = known.and_then(|id| serde_json::from_value(id.clone()).ok()).unwrap_or_default();
    let refused = |problem: &str| Err(Malformed::invalid(problem, known.clone()));
    if message.is_array() {
        return refused("the protocol has no batches: send one message at a time");
    }
    if !message.is_object() {
        return refused("a message must be a JSON object");
    }
    if message.get("jsonrpc").and_then(Value::as_str) != Some("2.0") {
        return refused("`jsonrpc` must be \"2.0\"");
    }
    if message.get("id").is_some_and(|id| serde_json::from_value::<Id>(id.clone()).is_err()) {
        return refused("`id` must be a string or a whole number of 64 bits");
    }
    let text = message.to_string();
    // The protocol crate must not fail to decode the message: that would end its input.
    let decoded = match message.get("method") {
        Some(Value::String(_)) => serde_json::from_value::<Request>(message).map(|_| ()),
        Some(_) => return refused("`method` must be a string"),
        None if message.get("result").is_some() || message.get("error").is_some() => {
            serde_json::from_value::<Response>(message).map(|_| ())
        }
        None => return refused("a message must have a `method`, a `result` or an `error`"),
    };
    decoded.map(|()| text).map_err(|error| Malformed::invalid(error.to_string(), known))
}
