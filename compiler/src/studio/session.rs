//! The session of a model, `session.json`: the values and settings of the form, selected runs,
//! camera and visibility.

use super::error::RequestError;
use super::folder;
use serde_json::{Value, json};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Version of the format of the file.
const VERSION: u64 = 1;
/// Largest length of the file, bytes.
pub(crate) const LONGEST: usize = 1 << 20;

/// The session file of a model.
pub(crate) struct Session {
    path: PathBuf,
    /// Form in the file when this studio last read or wrote it; `None` before that.
    known: Mutex<Option<StoredForm>>,
}

/// Values and settings of a stored form. The view is not compared, because each movement of a
/// camera changes it.
type StoredForm = [Value; 2];

impl Session {
    pub fn of_model(model: &Path) -> Session {
        Session { path: folder::of_model(model).join("session.json"), known: Mutex::default() }
    }

    fn known(&self) -> MutexGuard<'_, Option<StoredForm>> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the session; an empty one if there is no file, or a file with other contents.
    pub fn read(&self) -> Result<Value, RequestError> {
        let empty = json!({ "version": VERSION, "params": {}, "settings": {}, "view": null });
        let mut known = self.known();
        *known = Some(stored_form(&self.path).unwrap_or_else(|| form_of(&empty)));
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
    /// It is invalid, the file cannot be written, or another studio has changed it since this one
    /// last read or wrote it.
    pub fn write(&self, session: &Value) -> Result<(), RequestError> {
        validate(session)?;
        let mut known = self.known();
        let stored = stored_form(&self.path);
        if let (Some(known), Some(stored)) = (&*known, stored)
            && *known != stored
        {
            return Err(RequestError::conflict(
                "another studio of this model has stored its form: that of this page is not stored any more",
                "the page keeps its form, and its runs are stored; reload the page to take the stored form",
            ));
        }
        let unwritable =
            |error| RequestError::internal(format!("cannot write {}", self.path.display()), &error);
        let mut text = serde_json::to_vec_pretty(session).map_err(|error| unwritable(error.into()))?;
        text.push(b'\n');
        let folder = self.path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder).and_then(|()| folder::replace(&self.path, &text)).map_err(unwritable)?;
        *known = Some(form_of(session));
        Ok(())
    }
}

/// Returns the form in a session file; `None` without a valid file.
fn stored_form(path: &Path) -> Option<StoredForm> {
    let length = fs::metadata(path).ok()?.len();
    let text = (length <= LONGEST as u64).then(|| fs::read(path).ok())??;
    serde_json::from_slice(&text).ok().map(|session| form_of(&session))
}

fn form_of(session: &Value) -> StoredForm {
    ["params", "settings"].map(|key| session[key].clone())
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_session_of_another_studio_is_not_overwritten() {
        let directory = tempfile::tempdir().unwrap();
        let model = directory.path().join("pair.cx");
        let [one, other] = [(), ()].map(|()| Session::of_model(&model));
        let form = |torque: &str| json!({ "version": VERSION, "params": { "torque": torque }, "settings": {}, "view": null });
        assert_eq!(
            [&one, &other].map(|session| session.read().unwrap()["params"].clone()),
            [json!({}), json!({})]
        );
        one.write(&form("1")).unwrap();
        one.write(&form("2")).unwrap();
        assert!(other.write(&form("3")).is_err());
        // Cameras do not count.
        let mut moved = form("2");
        moved["view"] = json!({ "scene": null });
        one.write(&moved).unwrap();
        one.write(&form("2")).unwrap();
        assert_eq!(one.read().unwrap(), form("2"));
        // After it has read the file, the other studio may store its form, and the first one may
        // not.
        other.read().unwrap();
        other.write(&form("4")).unwrap();
        assert!(one.write(&form("5")).is_err());
        // A studio that was restarted has not read the file of its page.
        Session::of_model(&model).write(&form("6")).unwrap();
    }
}
