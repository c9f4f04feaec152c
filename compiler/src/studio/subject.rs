//! Subject of the studio: a model, or the directory of a run and the model that it belongs to.

use super::error::StudioError;
use super::folder::SUFFIX;
use calyx_rt::directory::read_run;
use std::fs;
use std::path::{Path, PathBuf};

/// Model and run that the studio shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subject {
    /// Path of the model; `None` if only the directory of a run is known.
    pub model: Option<PathBuf>,
    /// Directory of the run that the studio was opened with.
    pub run: Option<PathBuf>,
}

impl Subject {
    /// Interprets the argument of the command: the path of a model or of the directory of a run.
    /// Without an argument, the subject is the only model in the current directory.
    ///
    /// # Errors
    /// The path is neither, or there is not exactly one model.
    pub fn of_argument(argument: Option<&Path>) -> Result<Subject, StudioError> {
        let Some(path) = argument else {
            return Ok(Subject { model: Some(only_model(Path::new("."))?), run: None });
        };
        let shown = path.display();
        if path.is_dir() {
            let is_run =
                path.join("run.json").exists() || path.join(calyx_rt::run_directory::MARKER).exists();
            if !is_run {
                let message = format!("there is no run in {shown}");
                return Err(StudioError::with_help(
                    message,
                    "name a model (.cx file) or the directory of a run",
                ));
            }
            return Ok(Subject { model: model_of(path), run: Some(path.to_owned()) });
        }
        if !path.is_file() {
            return Err(StudioError::with_help(
                format!("cannot read {shown}: No such file or directory"),
                "name a model (.cx file) or the directory of a run",
            ));
        }
        if path.extension().is_none_or(|extension| extension != "cx") {
            return Err(StudioError::with_help(
                format!("{shown} is not a model"),
                "name a file that ends in .cx, or the directory of a run",
            ));
        }
        Ok(Subject { model: Some(path.to_owned()), run: None })
    }
}

/// Returns the only model in a directory.
fn only_model(directory: &Path) -> Result<PathBuf, StudioError> {
    let entries = fs::read_dir(directory).into_iter().flatten().flatten();
    let is_model = |path: &PathBuf| path.is_file() && path.extension().is_some_and(|end| end == "cx");
    let mut models: Vec<PathBuf> = entries.map(|entry| entry.path()).filter(is_model).take(2).collect();
    match (models.pop(), models.pop()) {
        (Some(model), None) => Ok(model.strip_prefix(".").map(Path::to_owned).unwrap_or(model)),
        (None, _) => Err(StudioError::with_help(
            "there is no model in this directory",
            "name a model: `calyx studio pair.cx`; `calyx new pair.cx` makes one",
        )),
        _ => Err(StudioError::with_help(
            "there are several models in this directory",
            "name one of them: `calyx studio pair.cx`",
        )),
    }
}

/// Finds the model of a run by the name of its directory, or by `run.json`.
fn model_of(run: &Path) -> Option<PathBuf> {
    let absolute = fs::canonicalize(run).ok()?;
    let beside = absolute.parent()?;
    let without = |path: &Path, suffix: &str| {
        let name = path.file_name()?.to_str()?.strip_suffix(suffix)?;
        Some(path.with_file_name(name))
    };
    let by_name = [without(&absolute, ".run"), without(beside, SUFFIX)];
    let written = read_run(&absolute).ok().flatten();
    let written = written.as_ref().and_then(|run| run["model"].as_str()).map(PathBuf::from);
    let by_content = written.into_iter().flat_map(|model| {
        let name = model.file_name().map(PathBuf::from).unwrap_or_default();
        [model, beside.join(name)]
    });
    let is_model = |path: &PathBuf| path.extension().is_some_and(|end| end == "cx") && path.is_file();
    by_name.into_iter().flatten().chain(by_content).find(is_model)
}
