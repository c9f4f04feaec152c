//! The runs of a model: those of the folder `MODEL.cx.studio`, of `MODEL.cx.run`, and the directory
//! that the studio was opened with.

use super::check::{Form, Values};
use super::error::RequestError;
use super::events::{Event, Events};
use super::folder::{self, Preview};
use super::model::hash_of;
use super::process::{Process, Start, Status};
use super::requests::texts;
use super::results::{self, Summaries};
use super::settings;
use calyx_abi::context::codes;
use calyx_rt::directory::default_directory;
use calyx_rt::run_directory::writer;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Adds the texts that were entered in the form to the params of a run, which has them in the units
/// of the defaults.
fn with_entered(mut params: Value, entered: &Value) -> Value {
    for (name, param) in params.as_object_mut().into_iter().flatten() {
        if let (Some(param), Some(text)) = (param.as_object_mut(), entered[name]["text"].as_str()) {
            param.insert("entered".to_owned(), json!(text));
        }
    }
    params
}

/// Identifier of the run in `MODEL.cx.run`.
const OF_MODEL: &str = "model";
/// Identifier of the run that the studio was opened with, if it is none of the others.
const OPENED: &str = "opened";
/// Identifier of the automatic run.
pub(crate) const PREVIEW: &str = "preview";
/// Limit of an automatic run, whose predicted time is below a second.
const PREVIEW_LIMIT: &str = "30s";
/// Largest number of runs of this studio at a time.
const MOST_RUNNING: usize = 4;
/// Time in which the processes of the studio end when it ends.
const FAREWELL: Duration = Duration::from_secs(12);

/// The runs of a model.
pub(crate) struct Runs {
    model: Option<PathBuf>,
    opened: Option<PathBuf>,
    command: PathBuf,
    allowed: Arc<[PathBuf]>,
    events: Events,
    processes: Mutex<BTreeMap<String, Arc<Process>>>,
    preview: Mutex<Option<Preview>>,
    /// Number of the automatic run that was requested last.
    requested: AtomicU64,
    /// Automatic runs start one after another.
    previewing: tokio::sync::Mutex<()>,
    summaries: Summaries,
    /// Runs are resumed one after another.
    resuming: Mutex<()>,
}

impl Runs {
    pub fn new(
        model: Option<PathBuf>,
        opened: Option<PathBuf>,
        command: PathBuf,
        allowed: Arc<[PathBuf]>,
        events: Events,
    ) -> Runs {
        Runs {
            model,
            opened,
            command,
            allowed,
            events,
            processes: Mutex::default(),
            preview: Mutex::default(),
            requested: AtomicU64::new(0),
            previewing: tokio::sync::Mutex::default(),
            summaries: Summaries::default(),
            resuming: Mutex::default(),
        }
    }

    fn processes(&self) -> MutexGuard<'_, BTreeMap<String, Arc<Process>>> {
        self.processes.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn process(&self, id: &str) -> Option<Arc<Process>> {
        self.processes().get(id).cloned()
    }

    fn folder(&self) -> Option<PathBuf> {
        self.model.as_deref().map(folder::of_model)
    }

    /// Returns the directory of a run. Only identifiers of this module have one, so that a request
    /// cannot name another directory.
    pub fn directory(&self, id: &str) -> Option<PathBuf> {
        match id {
            OF_MODEL => self.model.as_deref().map(default_directory),
            OPENED => self.opened.clone(),
            PREVIEW => {
                let preview = self.preview.lock().unwrap_or_else(PoisonError::into_inner);
                preview.as_ref().map(|preview| preview.directory.clone())
            }
            _ if folder::is_run_name(id) => Some(self.folder()?.join(id)),
            _ => None,
        }
    }

    /// Returns the directory of a run that exists.
    ///
    /// # Errors
    /// There is no such run, or its directory was deleted.
    pub fn existing(&self, id: &str) -> Result<PathBuf, RequestError> {
        let directory = self.directory(id).filter(|directory| directory.is_dir());
        directory.ok_or_else(|| {
            let message = format!("there is no run `{}`", id.chars().take(40).collect::<String>());
            RequestError::new(
                axum::http::StatusCode::NOT_FOUND,
                message,
                "its directory may have been deleted",
            )
        })
    }

    /// Returns the absolute path of the model, or of the run without a model: the same for each
    /// studio that shows it.
    pub fn subject(&self) -> Option<String> {
        let path = self.model.as_deref().or(self.opened.as_deref())?;
        Some(fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()).display().to_string())
    }

    /// Returns the identifier of the run that the studio was opened with.
    pub fn opened(&self) -> Option<String> {
        let opened = fs::canonicalize(self.opened.as_deref()?).ok()?;
        let is_same = |id: &String| {
            self.directory(id).and_then(|directory| fs::canonicalize(directory).ok()).as_ref()
                == Some(&opened)
        };
        Some(self.known_ids().into_iter().find(is_same).unwrap_or_else(|| OPENED.to_owned()))
    }

    /// Returns the identifiers of the runs next to the model, whose directories exist.
    fn known_ids(&self) -> Vec<String> {
        let entries = self.folder().and_then(|folder| fs::read_dir(folder).ok());
        let entries = entries.into_iter().flatten().flatten().filter(|entry| entry.path().is_dir());
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        let mut ids: Vec<String> = names.filter(|name| folder::is_run_name(name)).collect();
        ids.sort_by_key(|id| (id.len(), id.clone()));
        let has_own = self.directory(OF_MODEL).is_some_and(|directory| results::is_run(&directory));
        if has_own {
            ids.insert(0, OF_MODEL.to_owned());
        }
        ids
    }

    fn ids(&self) -> Vec<String> {
        let mut ids = self.known_ids();
        if self.opened().as_deref() == Some(OPENED) {
            ids.insert(0, OPENED.to_owned());
        }
        if self.process(PREVIEW).is_some() {
            ids.push(PREVIEW.to_owned());
        }
        ids
    }

    /// Returns a value that changes with the list of runs, or with a run of another process.
    pub fn state(&self) -> Vec<(String, u64, Option<String>)> {
        let state = |id: String| {
            let directory = self.directory(&id).unwrap_or_default();
            let is_own = self.process(&id).is_some_and(|process| process.status() == Status::Running);
            let files = if is_own { &results::CHANGING[..1] } else { &results::CHANGING[..] };
            let writer = if is_own { None } else { writer(&directory) };
            (id, results::stamp(&directory, files), writer)
        };
        self.ids().into_iter().map(state).collect()
    }

    /// Returns the list of runs as JSON, the newest last.
    pub fn list(&self) -> Vec<Value> {
        self.ids().iter().filter_map(|id| self.summary(id)).collect()
    }

    /// Describes a run: status, time, params, and what it has. `None` without a directory.
    pub fn summary(&self, id: &str) -> Option<Value> {
        let directory = self.directory(id).filter(|directory| directory.is_dir())?;
        let record = self.record(id);
        let run = self.summaries.of(&directory);
        let process = self.process(id);
        let (status, message) = self.status(&directory, process.as_deref(), &record, &run);
        let of_run = |key: &str| if run[key].is_object() { run[key].clone() } else { record[key].clone() };
        let solved = &run["positions"];
        let ended_early = ["cancelled", "failed", "interrupted"].contains(&status);
        let is_resumable = ended_early
            && record["params"].is_object()
            && solved.as_u64() > Some(0)
            && directory.join("journal.jsonl").is_file();
        Some(json!({
            "id": id,
            "directory": directory.display().to_string(),
            "status": status,
            "message": message,
            "started": record["started"].as_u64().or_else(|| results::time_of(&directory)),
            "params": with_entered(of_run("params"), &record["params"]),
            "settings": of_run("settings"),
            "progress": process.as_ref().filter(|process| process.status() == Status::Running).map(|process| process.progress()),
            "positions": solved,
            "total": record["positions"],
            "incomplete": results::is_incomplete(&run),
            "resumable": is_resumable,
            "fidelity": run["fidelity"],
            "calyx": run["calyx"],
            "source": run["source"],
            "warnings": run["warnings"],
            "has_view": directory.join("view/parts.bin").is_file(),
            "has_report": directory.join("report.html").is_file(),
        }))
    }

    /// Returns the status of a run and a message about it.
    fn status(
        &self,
        directory: &Path,
        process: Option<&Process>,
        record: &Value,
        run: &Value,
    ) -> (&'static str, Option<String>) {
        let first_error = |messages: &Value| {
            let mut all = messages.as_array().into_iter().flatten();
            let error = all.find(|message| message["severity"] == "error")?;
            Some(error["message"].as_str()?.to_owned())
        };
        if let Some(process) = process {
            return (process.status().name(), first_error(&json!(process.messages())));
        }
        if let Some(writer) = writer(directory) {
            return ("elsewhere", Some(format!("written by {writer}")));
        }
        // A run that was cancelled and resumed may have failed later.
        if let Some(reason) = run["incomplete"]["message"].as_str().filter(|_| record["status"] != "failed") {
            let status =
                if run["incomplete"]["code"] == codes::CANCELLED { "cancelled" } else { "interrupted" };
            return (status, Some(reason.to_owned()));
        }
        if run.is_object() && !directory.join("journal.jsonl").exists() {
            return ("finished", None);
        }
        match record["status"].as_str() {
            Some("failed") => ("failed", first_error(&record["messages"])),
            Some("cancelled") => ("cancelled", first_error(&record["messages"])),
            // Another studio may have started it a moment ago.
            Some("running") if is_recent(record) => {
                ("elsewhere", Some("another studio starts it".to_owned()))
            }
            _ => ("interrupted", Some("its process ended early".to_owned())),
        }
    }

    /// Returns the record of the start of a run; `null` if there is none.
    fn record(&self, id: &str) -> Value {
        let path =
            self.folder().filter(|_| folder::is_run_name(id)).map(|folder| folder.join(format!("{id}.json")));
        let text = path.and_then(|path| fs::read(path).ok()).unwrap_or_default();
        serde_json::from_slice(&text).unwrap_or(Value::Null)
    }

    /// Returns all results of a run as JSON.
    ///
    /// # Errors
    /// There is no such run, or its files cannot be read.
    pub fn results(&self, id: &str) -> Result<Value, RequestError> {
        let directory = self.existing(id)?;
        let mut summary = self.summary(id).unwrap_or_default();
        let process = self.process(id);
        let messages = process
            .as_ref()
            .map_or_else(|| self.record(id)["messages"].clone(), |process| json!(process.messages()));
        summary["messages"] = messages;
        summary["printed"] = json!(process.map(|process| process.printed()));
        let run = results::run(&directory)?;
        if results::is_incomplete(&run) {
            summary["so_far"] = results::outputs_so_far(&directory, &run)?;
        }
        summary["run"] = run;
        let steps = results::steps(&directory)?;
        (summary["steps"], summary["stride"]) = (steps.columns, json!(steps.stride));
        Ok(summary)
    }

    /// Starts a run in a new directory and returns its identifier. `positions` is the planned
    /// number of positions, or `null`.
    ///
    /// # Errors
    /// There is no model, too many runs are in progress, or the directory or the process cannot be
    /// made.
    pub fn start(&self, form: &Form, positions: &Value) -> Result<String, RequestError> {
        let folder = self.folder().ok_or_else(no_model)?;
        self.refuse_too_many()?;
        let failed =
            |error| RequestError::internal(format!("cannot start a run in {}", folder.display()), &error);
        let id = folder::create_run(&folder).map_err(failed)?;
        let directory = folder.join(&id);
        let record = json!({
            "calyx": env!("CARGO_PKG_VERSION"),
            "started": seconds_now(),
            "params": form.params.iter().map(|(name, text)| (name.clone(), json!({ "text": text }))).collect::<serde_json::Map<_, _>>(),
            "settings": form.settings,
            "positions": positions,
            "status": Status::Running.name(),
            "messages": [],
        });
        let record = write_record(&folder, &id, record).map_err(failed)?;
        let file = record.0.clone();
        self.launch((&id, &directory), form, &[], Some(record)).inspect_err(|_| {
            // The directory is still empty. If it cannot be removed, the run is listed as ended.
            let _ = fs::remove_dir(&directory).and_then(|()| fs::remove_file(file));
        })?;
        Ok(id)
    }

    /// Resumes a run that ended early, in its directory, with the params and settings of its start.
    ///
    /// # Errors
    /// The run is in progress, finished, or not one of this model's studio; too many runs are in
    /// progress, or the process cannot be made.
    pub fn resume(&self, id: &str) -> Result<(), RequestError> {
        let folder = self.folder().ok_or_else(no_model)?;
        // Of two requests at the same time, the second one finds the run in progress.
        let _one = self.resuming.lock().unwrap_or_else(PoisonError::into_inner);
        let directory = self.existing(id)?;
        let summary = self.summary(id).unwrap_or_default();
        if summary["resumable"] != true {
            let message = format!(
                "this run cannot be continued: it is {}",
                summary["status"].as_str().unwrap_or("lost")
            );
            return Err(RequestError::conflict(message, "start a new run"));
        }
        self.refuse_changed_model(&summary)?;
        self.refuse_too_many()?;
        let mut record = self.record(id);
        let assigned = record["params"].as_object().into_iter().flatten();
        let params: Option<Values> =
            assigned.map(|(name, param)| Some((name.clone(), param["text"].as_str()?.to_owned()))).collect();
        let settings =
            if record["settings"].is_null() { Some(Values::new()) } else { texts(&record["settings"]) };
        let (Some(params), Some(settings)) = (params, settings) else {
            let message = format!("{id}.json is damaged: it does not have the params of the run");
            return Err(RequestError::conflict(message, "start a new run with the same params"));
        };
        let form = Form { params, settings };
        record["status"] = json!(Status::Running.name());
        record["resumed"] = json!(seconds_now());
        record["messages"] = json!([]);
        let failed = |error| RequestError::internal(format!("cannot continue {id}"), &error);
        let record = write_record(&folder, id, record).map_err(failed)?;
        self.launch((id, &directory), &form, &["--resume"], Some(record))
    }

    /// Refuses to resume a run of another text of the model. The process of the run compares the
    /// imported files and tables as well.
    fn refuse_changed_model(&self, summary: &Value) -> Result<(), RequestError> {
        let hash = self.model.as_deref().and_then(hash_of);
        if hash.is_some() && summary["source"] == json!(hash) {
            return Ok(());
        }
        let help = "restore the text of the model, or start a new run with the params of this one";
        Err(RequestError::conflict("the model has changed since this run was started", help))
    }

    fn refuse_too_many(&self) -> Result<(), RequestError> {
        let running = self.processes().values().filter(|process| process.status() == Status::Running).count();
        if running < MOST_RUNNING {
            return Ok(());
        }
        let message = format!("{running} runs are in progress");
        Err(RequestError::conflict(message, "wait until one of them ends, or cancel one"))
    }

    /// Starts the automatic run in place of the previous one. Returns `false` if a later request
    /// replaced this one.
    ///
    /// # Errors
    /// There is no model, or the directory or the process cannot be made.
    pub async fn start_preview(&self, form: &Form) -> Result<bool, RequestError> {
        let folder = self.folder().ok_or_else(no_model)?;
        let number = self.requested.fetch_add(1, Ordering::Relaxed) + 1;
        let _one = self.previewing.lock().await;
        if self.requested.load(Ordering::Relaxed) != number {
            return Ok(false);
        }
        if let Some(before) = self.process(PREVIEW) {
            before.cancel();
            before.wait().await;
        }
        let directory = {
            let mut preview = self.preview.lock().unwrap_or_else(PoisonError::into_inner);
            if preview.is_none() {
                let locked = Preview::lock(&folder);
                let failed =
                    |error| RequestError::internal(format!("cannot write {}", folder.display()), &error);
                *preview = Some(locked.map_err(failed)?);
            }
            preview.as_ref().map(|preview| preview.directory.clone()).unwrap_or_default()
        };
        // The run is listed as soon as its process starts.
        fs::create_dir_all(&directory).map_err(|error| {
            RequestError::internal(format!("cannot create {}", directory.display()), &error)
        })?;
        self.launch((PREVIEW, &directory), form, &["--time-limit", PREVIEW_LIMIT], None)?;
        Ok(true)
    }

    fn launch(
        &self,
        (id, directory): (&str, &Path),
        form: &Form,
        options: &[&str],
        record: Option<(PathBuf, Value)>,
    ) -> Result<(), RequestError> {
        let model = self.model.as_deref().ok_or_else(no_model)?;
        let mut arguments: Vec<OsString> = vec!["run".into(), model.into()];
        let set = |(name, value): (&String, &String)| format!("--set={name}={}", value.trim()).into();
        arguments.extend(form.params.iter().map(set));
        arguments.extend(settings::options(&form.settings));
        for path in self.allowed.iter() {
            arguments.extend(["--allow-path".into(), path.into()]);
        }
        arguments.extend(["--out".into(), directory.into()]);
        arguments.extend(options.iter().map(OsString::from));
        let formats = ["--progress", "json", "--message-format", "json", "--cancel-at-end-of-input"];
        arguments.extend(formats.map(OsString::from));
        let start = Start { id: id.to_owned(), command: self.command.clone(), arguments, record };
        let process = Process::start(start, self.events.clone())
            .map_err(|error| RequestError::internal("cannot start a run", &error))?;
        self.processes().insert(id.to_owned(), process);
        self.events.send(Event::Runs);
        Ok(())
    }

    /// Cancels a run of this studio.
    ///
    /// # Errors
    /// This studio did not start it, or it has ended.
    pub fn cancel(&self, id: &str) -> Result<(), RequestError> {
        match self.process(id).filter(|process| process.status() == Status::Running) {
            Some(process) => {
                process.cancel();
                Ok(())
            }
            None if self.directory(id).is_some() => Err(RequestError::conflict(
                "this studio has no such run in progress",
                "end a run of another process where it was started",
            )),
            None => Err(RequestError::not_found("there is no such run")),
        }
    }

    /// Ends all processes.
    pub async fn end_all(&self) {
        let all: Vec<Arc<Process>> = self.processes().values().cloned().collect();
        let running: Vec<_> = all.into_iter().filter(|process| process.status() == Status::Running).collect();
        running.iter().for_each(|process| process.cancel());
        let ended = async {
            for process in &running {
                process.wait().await;
            }
        };
        // Those that remain are killed with their handles.
        let _ = tokio::time::timeout(FAREWELL, ended).await;
    }
}

fn no_model() -> RequestError {
    RequestError::conflict("the model of this run is not known", "start `calyx studio` with the model")
}

/// Writes the record of a run. Returns its path and content.
fn write_record(folder: &Path, id: &str, record: Value) -> io::Result<(PathBuf, Value)> {
    let path = folder.join(format!("{id}.json"));
    folder::replace(&path, &serde_json::to_vec_pretty(&record)?)?;
    Ok((path, record))
}

fn seconds_now() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs())
}

/// Returns true if a run was started in the last seconds.
fn is_recent(record: &Value) -> bool {
    /// Time in which a process locks its directory: it checks the model before.
    const STARTING: u64 = 30;
    let started = record["resumed"].as_u64().or(record["started"].as_u64());
    started.is_some_and(|started| seconds_now().saturating_sub(started) < STARTING)
}
