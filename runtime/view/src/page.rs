//! Self-contained page of a run: the viewer's program with the data of the run directory, in one
//! file that needs neither a server nor a network.

use crate::array_file::ArrayFile;
use crate::files::{FOLDER, PARTS, positions};
use crate::mesh;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{error, fmt, fs};

/// Name of the page in a run directory.
pub const NAME: &str = "scene.html";
/// Text near the beginning of every page, by which it is recognized.
pub const MARK: &str = "<meta name=\"generator\" content=\"calyx view\">";
/// Number of bytes from the beginning of a page within which [`MARK`] ends.
pub const MARK_WITHIN: u64 = 1024;
/// Program and style of the page.
const SCRIPT: &str = include_str!("../web/dist/viewer.js");
const STYLE: &str = include_str!("../web/dist/viewer.css");

/// Reason why a page cannot be made.
#[derive(Debug)]
pub enum PageError {
    /// The directory has no files of the viewer.
    NoFiles,
    /// A file cannot be read.
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Reason.
        error: Box<dyn error::Error + Send + Sync>,
    },
}

impl fmt::Display for PageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PageError::NoFiles => f.write_str("the directory contains no files of the viewer"),
            PageError::Unreadable { path, error } => write!(f, "{} cannot be read: {error}", path.display()),
        }
    }
}

impl error::Error for PageError {}

/// Returns the page of a run directory.
///
/// # Errors
/// The directory has no files of the viewer, or a file cannot be read.
pub fn page(directory: &Path) -> Result<String, PageError> {
    let (folder, names) = (directory.join(FOLDER), positions(directory));
    if names.is_empty() || !folder.join(PARTS).exists() {
        return Err(PageError::NoFiles);
    }
    let run = run_of(directory)?;
    let mut meshes = BTreeMap::new();
    let mut positions = Vec::new();
    for name in &names {
        let (header, data) = embedded(&folder, name)?;
        for mesh in header["meshes"].as_array().into_iter().flatten() {
            let mesh = mesh["mesh"].as_str().filter(|mesh| mesh::is_name(mesh)).unwrap_or_default();
            if !meshes.contains_key(mesh) {
                meshes.insert(mesh.to_owned(), embedded(&folder, mesh)?.1);
            }
        }
        positions.push(json!({ "position": header["position"], "time": header["time"], "data": data }));
    }
    let (_, parts) = embedded(&folder, PARTS)?;
    let title = run["model"].as_str().map_or("Calyx", file_name).to_owned();
    let data = json!({
        "title": title,
        "provenance": provenance(&run),
        "outputs": outputs(directory, &run)?,
        "parts": parts,
        "positions": positions,
        "meshes": meshes,
    });
    // `<` cannot end the script element then.
    let data = data.to_string().replace('<', "\\u003c");
    let script = SCRIPT.replace("</script", "<\\/script");
    let title = escaped(&title);
    Ok(format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n{MARK}\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <script type=\"application/json\" id=\"calyx-view\">{data}</script>\n<script>{script}</script>\n</body>\n</html>\n"
    ))
}

fn unreadable(path: &Path, error: impl Into<Box<dyn error::Error + Send + Sync>>) -> PageError {
    PageError::Unreadable { path: path.to_owned(), error: error.into() }
}

/// Returns the header of an array file, and the compressed file.
fn embedded(folder: &Path, name: &str) -> Result<(Value, String), PageError> {
    let path = folder.join(name);
    let bytes = fs::read(&path).map_err(|error| unreadable(&path, error))?;
    let header = ArrayFile::read(&bytes).map_err(|error| unreadable(&path, error))?.header;
    let data = compressed(&bytes).map_err(|error| unreadable(&path, error))?;
    Ok((header, data))
}

/// Reads `run.json`; null for a run that has not finished.
fn run_of(directory: &Path) -> Result<Value, PageError> {
    let path = directory.join("run.json");
    match fs::read(&path) {
        Ok(bytes) => serde_json::from_slice(&bytes).map_err(|error| unreadable(&path, error)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Value::Null),
        Err(error) => Err(unreadable(&path, error)),
    }
}

fn compressed(bytes: &[u8]) -> io::Result<String> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    Ok(STANDARD.encode(encoder.finish()?))
}

fn file_name(path: &str) -> &str {
    Path::new(path).file_name().and_then(|name| name.to_str()).unwrap_or(path)
}

/// Returns labels and values that describe the run.
fn provenance(run: &Value) -> Vec<[String; 2]> {
    let mut lines = Vec::new();
    let mut add = |label: &str, value: &Value| match value {
        Value::String(text) => lines.push([label.to_owned(), text.clone()]),
        Value::Null => {}
        other => lines.push([label.to_owned(), other.to_string()]),
    };
    add("model", &run["model"]);
    add("version of Calyx", &run["calyx"]);
    add("fidelity", &run["plan"]["fidelity"]);
    add("hash of the source", &run["source"]["sha256"]);
    for (name, param) in run["params"].as_object().into_iter().flatten() {
        let shown = match &param["display"] {
            Value::Null => param["value"].clone(),
            display => {
                let number = display["value"].to_string();
                json!(format!("{number} {}", display["unit"].as_str().unwrap_or_default()).trim_end())
            }
        };
        add(name, &shown);
    }
    lines
}

/// Returns the columns of `steps.csv` with their units; null without the table.
fn outputs(directory: &Path, run: &Value) -> Result<Value, PageError> {
    let path = directory.join("steps.csv");
    if !path.exists() {
        return Ok(Value::Null);
    }
    let failed = |error: csv::Error| unreadable(&path, error);
    let mut reader = csv::Reader::from_path(&path).map_err(failed)?;
    let names = reader.headers().map_err(failed)?.clone();
    let mut columns: Vec<Vec<Value>> = vec![Vec::new(); names.len()];
    for record in reader.records() {
        let record = record.map_err(failed)?;
        for (column, cell) in columns.iter_mut().zip(&record) {
            column.push(json!(cell.parse::<f64>().ok().filter(|number| number.is_finite())));
        }
    }
    let shown = names.iter().zip(columns).filter(|(name, _)| *name != "point");
    let columns = shown.map(|(name, values)| {
        let unit = match name {
            "time" => "s",
            "roll_angle" => "rad",
            _ => [&run["outputs"], &run["columns"]]
                .into_iter()
                .find_map(|outputs| outputs[name]["unit"].as_str())
                .filter(|unit| *unit != "1")
                .unwrap_or_default(),
        };
        json!({ "name": name, "unit": unit, "values": values })
    });
    Ok(json!({ "columns": columns.collect::<Vec<_>>() }))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ViewFiles;
    use calyx_runtime::observables::Fields;

    #[test]
    fn a_page_contains_the_files_of_its_run() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path();
        assert!(matches!(page(path), Err(PageError::NoFiles)));
        let mut files = ViewFiles::begin(path, ("pair.cx", "mm_N_s")).unwrap();
        files.write((0, 0.0), &Fields::default()).unwrap();
        files.write((1, 0.25), &Fields::default()).unwrap();
        fs::write(path.join("steps.csv"), "step,time,point,force\n0,0,SAP,1.5\n1,0.25,,\n").unwrap();
        let run = json!({
            "model": "models/<pair>.cx",
            "params": { "torque": { "value": 0.05, "display": { "value": 50, "unit": "N*mm" } } },
            "outputs": { "force": { "unit": "N" } },
        });
        fs::write(path.join("run.json"), run.to_string()).unwrap();
        let page = page(path).unwrap();
        assert!(page.contains("<title>&lt;pair&gt;.cx</title>"));
        assert!(page[..MARK_WITHIN as usize].contains(MARK));
        let (_, rest) = page.split_once("id=\"calyx-view\">").unwrap();
        let data: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
        assert_eq!(data["title"], "<pair>.cx");
        assert_eq!(data["positions"][1]["time"], 0.25);
        assert!(data["provenance"].as_array().unwrap().contains(&json!(["torque", "50 N*mm"])));
        let force = json!({ "name": "force", "unit": "N", "values": [1.5, null] });
        assert_eq!(data["outputs"]["columns"][2], force);
    }

    #[test]
    fn a_damaged_file_is_named() {
        let directory = tempfile::tempdir().unwrap();
        let mut files = ViewFiles::begin(directory.path(), ("pair.cx", "mm_N_s")).unwrap();
        files.write((0, 0.0), &Fields::default()).unwrap();
        fs::write(directory.path().join("view/position-0000.bin"), "CALYX").unwrap();
        let message = page(directory.path()).unwrap_err().to_string();
        assert!(message.ends_with("position-0000.bin cannot be read: the file is truncated"), "{message}");
    }
}
