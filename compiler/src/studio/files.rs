//! Files of a run that the page may read: a fixed list of names, and the files of the viewer.

use super::error::RequestError;
use super::runs::Runs;
use axum::body::{Body, Bytes};
use axum::http::header;
use axum::response::{IntoResponse, Response};
use calyx_rt::view::files::{FOLDER, PARTS, index_of, positions};
use calyx_rt::view::mesh;
use futures_util::stream;
use serde_json::{Value, json};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use tokio::fs::File;
use tokio::io::AsyncReadExt;

/// Files at the top of a run directory, with their types.
const FILES: [(&str, &str); 6] = [
    ("run.json", "application/json"),
    ("timing.json", "application/json"),
    ("steps.csv", "text/csv; charset=utf-8"),
    ("line_load.csv", "text/csv; charset=utf-8"),
    ("root_stress_range.csv", "text/csv; charset=utf-8"),
    ("report.html", "text/html; charset=utf-8"),
];
/// Number of bytes that are read at a time.
const CHUNK: usize = 256 << 10;
/// A report is a page of its own without scripts; it cannot send requests.
const REPORT_POLICY: &str =
    "sandbox allow-popups; default-src 'none'; style-src 'unsafe-inline'; img-src data:; font-src data:";

/// Returns the type of a file that may be read; `None` for all other names.
fn type_of(name: &str) -> Option<&'static str> {
    let known = FILES.iter().find(|(known, _)| *known == name).map(|(_, kind)| *kind);
    known.or_else(|| {
        let view = name.strip_prefix(FOLDER)?.strip_prefix('/')?;
        (view == PARTS || mesh::is_name(view) || index_of(view).is_some())
            .then_some("application/octet-stream")
    })
}

/// Returns the path of a file of a run: a regular file inside the directory, also after following
/// symbolic links.
fn path_of(directory: &Path, name: &str) -> io::Result<PathBuf> {
    let path = fs::canonicalize(directory.join(name))?;
    let is_inside = path.starts_with(fs::canonicalize(directory)?) && fs::metadata(&path)?.is_file();
    if is_inside { Ok(path) } else { Err(io::ErrorKind::NotFound.into()) }
}

/// Sends a file of a run.
///
/// # Errors
/// There is no such run or file, or the name is not one that may be read.
pub(crate) async fn send(runs: &Runs, id: &str, name: &str) -> Result<Response, RequestError> {
    let missing = || RequestError::not_found("this run has no such file");
    let kind = type_of(name).ok_or_else(missing)?;
    let directory = runs.existing(id)?;
    let path = path_of(&directory, name).map_err(|_| missing())?;
    let file = File::open(path).await.map_err(|_| missing())?;
    let chunks = stream::unfold(file, |mut file| async move {
        let mut chunk = vec![0; CHUNK];
        match file.read(&mut chunk).await {
            Ok(0) => None,
            Ok(count) => {
                chunk.truncate(count);
                Some((Ok(Bytes::from(chunk)), file))
            }
            Err(error) => Some((Err(error), file)),
        }
    });
    let mut response = ([(header::CONTENT_TYPE, kind)], Body::from_stream(chunks)).into_response();
    if name == "report.html" {
        let policy = header::HeaderValue::from_static(REPORT_POLICY);
        response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    Ok(response)
}

/// Lists the positions for the viewer, with their times in s.
///
/// # Errors
/// There is no such run, or the directory cannot be read.
pub(crate) fn view(runs: &Runs, id: &str) -> Result<Value, RequestError> {
    let directory = runs.existing(id)?;
    let positions: Vec<usize> = positions(&directory).iter().filter_map(|name| index_of(name)).collect();
    // Without the table, positions are displayed without their times.
    let times = super::results::times(&directory).unwrap_or_default();
    let time = |position: usize| times.get(position).copied().flatten();
    let listed: Vec<Value> =
        positions.iter().map(|&position| json!({ "position": position, "time": time(position) })).collect();
    let parts = directory.join(FOLDER).join(PARTS).is_file();
    Ok(json!({ "parts": parts, "positions": listed }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_listed_names_may_be_read() {
        for name in [
            "run.json",
            "steps.csv",
            "view/parts.bin",
            "view/position-0000.bin",
            "view/position-12345.bin",
            "view/mesh-0123456789abcdef.bin",
        ] {
            assert!(type_of(name).is_some(), "{name}");
        }
        for name in [
            "",
            ".calyx-run",
            "journal.jsonl",
            "../pair.cx",
            "view/../run.json",
            "view/position-.bin",
            "view/position-00a0.bin",
            "view/mesh-0.bin",
            "view/position-0000.bin/x",
            "/etc/passwd",
            "view//parts.bin",
            "run.json\0",
        ] {
            assert!(type_of(name).is_none(), "{name}");
        }
    }
}
