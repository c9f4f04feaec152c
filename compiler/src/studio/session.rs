//! The session of a model, `session.json`: the values and settings of the form, selected runs,
//! camera and visibility.

use super::error::RequestError;
use super::folder;
use serde_json::{Value, json};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Version of the format of the file.
const VERSION: u64 = 1;
/// Largest length of the file, bytes.
pub(crate) const LONGEST: usize = 1 << 20;

/// The session file of a model.
pub(crate) struct Session {
    path: PathBuf,
}

impl Session {
    pub fn of_model(model: &Path) -> Session {
        Session { path: folder::of_model(model).join("session.json") }
    }

    /// Returns the session; an empty one if there is no file, or a file with other contents.
    pub fn read(&self) -> Result<Value, RequestError> {
        let empty = json!({ "version": VERSION, "params": {}, "settings": {}, "view": null });
        let length = fs::metadata(&self.path).map_or(0, |about| about.len());
        if length > LONGEST as u64 {
            return Ok(empty);
        }
        match fs::read(&self.path) {
            Ok(text) => {
                let session = serde_json::from_slice(&text).ok();
                Ok(session.filter(|session| validate(session).is_ok()).unwrap_or(empty))
            }
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(empty),
            Err(error) => Err(RequestError::internal(format!("cannot read {}", self.path.display()), &error)),
        }
    }

    /// Stores the session.
    ///
    /// # Errors
    /// It is invalid, or the file cannot be written.
    pub fn write(&self, session: &Value) -> Result<(), RequestError> {
        validate(session)?;
        let unwritable =
            |error| RequestError::internal(format!("cannot write {}", self.path.display()), &error);
        let mut text = serde_json::to_vec_pretty(session).map_err(|error| unwritable(error.into()))?;
        text.push(b'\n');
        let folder = self.path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder).and_then(|()| folder::replace(&self.path, &text)).map_err(unwritable)
    }
}

/// Checks the form of a session. The page alone interprets `view`.
fn validate(session: &Value) -> Result<(), RequestError> {
    let help = "a session is {\"version\": 1, \"params\": {\"NAME\": \"VALUE\"}, \"settings\": {...}, \"view\": {...}}";
    let invalid = |message: &str| Err(RequestError::invalid(message, help));
    let Some(entries) = session.as_object() else { return invalid("the session is not an object") };
    if entries.get("version").and_then(Value::as_u64) != Some(VERSION) {
        return invalid("the session has another version");
    }
    if !entries.get("params").is_some_and(is_table_of_texts) {
        return invalid("`params` of the session is not an object of texts");
    }
    // Sessions of older versions have no settings.
    if !entries.get("settings").is_none_or(is_table_of_texts) {
        return invalid("`settings` of the session is not an object of texts");
    }
    if !entries.get("view").is_some_and(|view| view.is_object() || view.is_null()) {
        return invalid("`view` of the session is neither an object nor null");
    }
    match entries.keys().find(|key| !["version", "params", "settings", "view"].contains(&key.as_str())) {
        Some(_) => invalid("the session has an unknown key"),
        None => Ok(()),
    }
}

fn is_table_of_texts(value: &Value) -> bool {
    value.as_object().is_some_and(|entries| entries.values().all(Value::is_string))
}
