//! Reference pages from doc comments: self-contained HTML for a module or a model (`calyx doc`).
//!
//! A page is derived from the syntax tree and from the types of params and outputs. A file with
//! errors elsewhere is still documented.

mod collect;
mod html;

pub use collect::{Entry, Field, Kind, Page};

use crate::replace::replace;
use calyx_elaborate::ModelLoader;
use calyx_gears::library::{MODULES, PRELUDE};
use calyx_lang::check_program;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Error of writing pages.
#[derive(Debug)]
pub enum DocError {
    /// The name is neither a library module nor a file.
    Unknown {
        name: String,
        known: Vec<&'static str>,
    },
    /// An existing file that is not a page of this program would be replaced.
    Foreign {
        path: PathBuf,
    },
    Io {
        path: PathBuf,
        error: io::Error,
    },
}

/// Returns the page of a library module or of a file with the extension .cx.
///
/// # Errors
/// If there is no such module, or the file cannot be read.
pub fn page(name: &str, allowed: &Arc<[PathBuf]>) -> Result<Page, DocError> {
    if let Some(module) = MODULES.iter().find(|module| module.path == name) {
        return Ok(collect::page(name, module.text, true, &BTreeMap::new()));
    }
    if name == PRELUDE.path {
        return Ok(collect::page(name, PRELUDE.text, true, &BTreeMap::new()));
    }
    let path = Path::new(name);
    if path.extension().is_none_or(|extension| extension != "cx") {
        let known = library();
        return Err(DocError::Unknown { name: name.to_owned(), known });
    }
    let text =
        std::fs::read_to_string(path).map_err(|error| DocError::Io { path: path.to_owned(), error })?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    // Types are known for valid declarations, even if others have errors.
    let loader = ModelLoader { folder: path.parent().map(Path::to_path_buf), allowed: allowed.clone() };
    let checked = check_program(name, &text, &loader);
    let mut page = collect::page(&stem, &text, false, &checked.types);
    let params = checked.program.map(|program| program.params).unwrap_or_default();
    page.entries.extend(collect::instance_params(&params, &checked.files));
    Ok(page)
}

/// Returns the names of the library modules, the prelude first.
pub fn library() -> Vec<&'static str> {
    std::iter::once(PRELUDE.path).chain(MODULES.iter().map(|module| module.path)).collect()
}

/// Returns true if a file is a page of this program, recognized by its generator or by the first
/// bytes of pages of older versions.
fn is_page(path: &Path) -> bool {
    const OLD: [&str; 2] = [
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n",
        "placeholder=\"Search by name\"",
    ];
    let text = std::fs::read_to_string(path).unwrap_or_default();
    text.contains(html::GENERATOR) || (text.starts_with(OLD[0]) && text.contains(OLD[1]))
}

/// Writes a file for each page and, for more than one, an index; returns the file to open first.
/// Replaces files that are not pages of this program only with `force`.
///
/// # Errors
/// If an existing file would be replaced without `force`, or a file cannot be written.
pub fn write(pages: &[Page], directory: &Path, force: bool) -> Result<PathBuf, DocError> {
    let unwritable = |path: &Path, error| DocError::Io { path: path.to_owned(), error };
    std::fs::create_dir_all(directory).map_err(|error| unwritable(directory, error))?;
    let mut first = None;
    let mut files: Vec<(String, String)> = Vec::new();
    if pages.len() > 1 {
        files.push(("index.html".into(), html::index(pages)));
    }
    files.extend(pages.iter().map(|page| (format!("{}.html", page.name), html::page(page, pages))));
    let paths: Vec<PathBuf> = files.iter().map(|(name, _)| directory.join(name)).collect();
    // Before the first page is written.
    if let Some(path) = paths.iter().find(|path| !force && path.symlink_metadata().is_ok() && !is_page(path))
    {
        return Err(DocError::Foreign { path: path.clone() });
    }
    for ((_, text), path) in files.into_iter().zip(paths) {
        replace(&path, &text).map_err(|error| unwritable(&path, error))?;
        first.get_or_insert(path);
    }
    Ok(first.unwrap_or_else(|| directory.to_owned()))
}

/// Returns a page as plain text.
pub fn text(page: &Page) -> String {
    html::text(page)
}
