//! The page and its files, which are part of the program. The bundles are those of
//! `runtime/view/web/dist`.

use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde_json::Value;

const SCRIPT: &str = include_str!("../../../runtime/view/web/dist/studio.js");
const STYLE: &str = include_str!("../../../runtime/view/web/dist/studio.css");
const PAGE: &str = "<!doctype html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">
<meta name=\"color-scheme\" content=\"light dark\">
<title>Calyx studio</title>
<link rel=\"icon\" href=\"data:,\">
<link rel=\"stylesheet\" href=\"/studio.css\">
</head>
<body>
<div id=\"studio\"></div>
<noscript>The studio needs JavaScript.</noscript>
<script src=\"/studio.js\"></script>
</body>
</html>
";

fn text(kind: &'static str, text: &'static str) -> Response {
    ([(header::CONTENT_TYPE, kind)], text).into_response()
}

/// Sends the page.
pub(crate) async fn page() -> Response {
    text("text/html; charset=utf-8", PAGE)
}

/// Sends the script of the page.
pub(crate) async fn script() -> Response {
    text("text/javascript; charset=utf-8", SCRIPT)
}

/// Sends the style sheet of the page.
pub(crate) async fn style() -> Response {
    text("text/css; charset=utf-8", STYLE)
}

/// Returns a JSON document as a response.
pub(crate) fn json_response(value: &Value) -> Response {
    ([(header::CONTENT_TYPE, "application/json")], value.to_string()).into_response()
}
