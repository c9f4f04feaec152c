//! The session of a model, `session.json`: the values and settings of the form, selected runs,
//! camera and visibility.

use super::error::RequestError;
use super::folder;
use serde_json::{Value, json};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Version of the format of the file.
const VERSION: u64 = 1;
/// Largest length of the file, bytes.
pub(crate) const LONGEST: usize = 1 << 20;

/// The session file of a model.
pub(crate) struct Session {
    path: PathBuf,
    /// Held while a request compares and replaces the file.
    writing: Mutex<()>,
}

/// Values and settings of a stored form. The view is not compared, because each movement of a
/// camera changes it.
type StoredForm = [Value; 2];

impl Session {
    pub fn of_model(model: &Path) -> Session {
        Session { path: folder::of_model(model).join("session.json"), writing: Mutex::default() }
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

    /// Stores the session of a page, and returns whether its form differs from the stored one. Its
    /// entry `before`, which is not stored, has the form that the page has last read or written.
    ///
    /// # Errors
    /// It is invalid, the file cannot be written, or the stored form is neither that of `before`
    /// nor that of the session: another page has changed it, of this studio or of another one.
    pub fn write(&self, mut session: Value) -> Result<bool, RequestError> {
        let before = session.as_object_mut().and_then(|entries| entries.remove("before"));
        validate(&session)?;
        let _writing = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
        let (stored, new) = (stored_form(&self.path), form_of(&session));
        if let (Some(before), Some(stored)) = (before, &stored)
            && ![form_of(&before), new.clone()].contains(stored)
        {
            return Err(RequestError::conflict(
                "another page or studio of this model has stored its form: that of this page is not stored any more",
                "the page keeps its form, and its runs are stored; reload the page to take the stored form",
            ));
        }
        let unwritable =
            |error| RequestError::internal(format!("cannot write {}", self.path.display()), &error);
        let mut text = serde_json::to_vec_pretty(&session).map_err(|error| unwritable(error.into()))?;
        text.push(b'\n');
        let folder = self.path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder).and_then(|()| folder::replace(&self.path, &text)).map_err(unwritable)?;
        Ok(stored.is_none_or(|stored| stored != new))
    }
}

/// Returns the form in a session file; `None` without a valid file.
fn stored_form(path: &Path) -> Option<StoredForm> {
    let length = fs::metadata(path).ok()?.len();
    let text = (length <= LONGEST as u64).then(|| fs::read(path).ok())??;
    serde_json::from_slice(&text).ok().map(|session| form_of(&session))
}

fn form_of(session: &Value) -> StoredForm {
    // Sessions of older versions have no settings.
    ["params", "settings"].map(|key| match &session[key] {
        Value::Null => json!({}),
        form => form.clone(),
    })
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

    /// Pages of one studio and of two studios are treated alike.
    #[test]
    fn a_form_that_a_page_does_not_know_is_not_overwritten() {
        let directory = tempfile::tempdir().unwrap();
        let model = directory.path().join("pair.cx");
        let [one, other] = [(), ()].map(|()| Session::of_model(&model));
        let form = |torque: &str| json!({ "version": VERSION, "params": { "torque": torque }, "settings": {}, "view": null });
        let after = |torque: &str, before: &Value| {
            let mut session = form(torque);
            session["before"] = json!({ "params": before["params"], "settings": before["settings"] });
            session
        };
        let empty = one.read().unwrap();
        assert_eq!(empty["params"], json!({}));
        assert!(one.write(after("1", &empty)).unwrap());
        assert!(one.write(after("2", &form("1"))).unwrap());
        for studio in [&one, &other] {
            assert!(studio.write(after("3", &form("1"))).is_err());
            assert_eq!(studio.read().unwrap(), form("2"), "the file does not contain `before`");
        }
        // Cameras do not count.
        let mut moved = after("2", &form("2"));
        moved["view"] = json!({ "scene": null });
        assert!(!one.write(moved).unwrap());
        assert!(!other.write(after("2", &form("1"))).unwrap(), "the form that is stored already");
        // A page that knows the stored form may replace it, in any studio.
        assert!(other.write(after("4", &form("2"))).unwrap());
        assert!(one.write(after("5", &form("2"))).is_err());
        assert!(one.write(form("6")).unwrap(), "a program that does not compare");
    }
}
