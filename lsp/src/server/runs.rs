//! Runs and tests of models that the editor starts.
//!
//! Each is a process of its own, so that the server stays responsive, and can be stopped at any
//! time. The module reads the progress of the process from its standard error, shows it in the
//! editor, and writes everything else to the log.

use super::Shared;
use calyx_elaborate::results::{RunSummary, default_directory};
use serde::Deserialize;
use std::collections::HashMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::io::{AsyncBufReadExt, AsyncReadExt, BufReader};
use tokio::process::Command;
use tokio::sync::Notify;
use tower_lsp_server::Client;
use tower_lsp_server::ls_types::notification::Progress;
use tower_lsp_server::ls_types::request::WorkDoneProgressCreate;
use tower_lsp_server::ls_types::{
    MessageType, NumberOrString, ProgressParams, ProgressParamsValue, ProgressToken, Uri, WorkDoneProgress,
    WorkDoneProgressBegin, WorkDoneProgressCreateParams, WorkDoneProgressEnd, WorkDoneProgressReport,
};

/// Current runs, at most one per model.
#[derive(Default)]
pub(crate) struct Runs {
    current: Mutex<HashMap<Uri, Run>>,
    last_token: AtomicU32,
}

/// A current run.
struct Run {
    /// Identifies its progress display.
    token: ProgressToken,
    /// Notified to stop it.
    stop: Arc<Notify>,
}

/// Selection of the run to stop.
pub(crate) enum Stop {
    Model(Uri),
    Token(ProgressToken),
}

impl Runs {
    fn lock(&self) -> MutexGuard<'_, HashMap<Uri, Run>> {
        self.current.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Stops a run. Returns false if there is no such run.
    pub fn stop(&self, which: &Stop) -> bool {
        let runs = self.lock();
        let run = match which {
            Stop::Model(uri) => runs.get(uri),
            Stop::Token(token) => runs.values().find(|run| run.token == *token),
        };
        run.inspect(|run| run.stop.notify_one()).is_some()
    }

    /// Registers a run. Returns `None` if the model is already running.
    fn enter(&self, uri: &Uri) -> Option<(ProgressToken, Arc<Notify>)> {
        let mut runs = self.lock();
        if runs.contains_key(uri) {
            return None;
        }
        let number = self.last_token.fetch_add(1, Ordering::Relaxed);
        let token = NumberOrString::String(format!("calyx-run-{number}"));
        let stop = Arc::new(Notify::new());
        runs.insert(uri.clone(), Run { token: token.clone(), stop: stop.clone() });
        Some((token, stop))
    }
}

/// Guard that unregisters a run when it is dropped.
struct RegisteredRun<'a> {
    runs: &'a Runs,
    uri: &'a Uri,
}

impl Drop for RegisteredRun<'_> {
    fn drop(&mut self) {
        self.runs.lock().remove(self.uri);
    }
}

/// A finished run.
pub(crate) struct Finished {
    /// Directory of the results.
    pub directory: PathBuf,
    /// Summary for the user.
    pub message: String,
}

/// Line that a run writes on standard error: progress, or a message.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Line {
    stage: Option<String>,
    done: u32,
    total: Option<u32>,
    seconds_left: Option<f64>,
    severity: Option<String>,
    message: String,
}

/// Runs a model, shows its progress, and reads its results.
///
/// # Errors
/// A sentence that states why there are no results: the model is already running, the run was
/// cancelled, or it failed.
pub(crate) async fn run(
    shared: &Shared,
    client: &Client,
    uri: &Uri,
    model: &Path,
) -> Result<Finished, String> {
    let name = model.file_name().unwrap_or_default().display().to_string();
    let Some((token, stop)) = shared.runs.enter(uri) else {
        return Err(format!("{name} is running already: cancel that run first"));
    };
    let _registered = RegisteredRun { runs: &shared.runs, uri };
    let bar = Bar::begin(shared, client, token, format!("Running {name}")).await;
    let outcome = tokio::select! {
        outcome = solve(shared, client, model, &bar) => outcome,
        () = stop.notified() => Err(format!("the run of {name} was cancelled")),
    };
    bar.end(client).await;
    outcome?;
    let directory = default_directory(model);
    let summary = RunSummary::read(&directory)
        .map_err(|error| format!("the results of {name} cannot be read: {error}"))?;
    let positions = match summary.positions {
        0 => "no positions".to_owned(),
        1 => "1 position".to_owned(),
        more => format!("{more} positions"),
    };
    let message = format!("{name} has run: {positions}, results in {}", directory.display());
    shared.workspace().set_run(&model.display().to_string(), summary);
    refresh(shared, client).await;
    client.show_message(MessageType::INFO, &message).await;
    Ok(Finished { directory, message })
}

/// Runs the process of a model to its end. Errors are those of the model, or of the process.
async fn solve(shared: &Shared, client: &Client, model: &Path, bar: &Bar) -> Result<(), String> {
    let mut child = command(shared, model)
        .args(["run", "--progress", "json", "--message-format", "json"])
        .args(allow_paths(shared))
        .arg(model)
        .spawn()
        .map_err(|error| format!("the run cannot be started: {error}"))?;
    let printed = child.stdout.take();
    // The text that the model prints goes to the log. It is read concurrently, because a full pipe
    // would block the model.
    let log = shared.log.clone();
    let printing = tokio::spawn(async move {
        let mut lines = printed.map(|printed| BufReader::new(printed).lines());
        while let Some(lines) = &mut lines
            && let Ok(Some(line)) = lines.next_line().await
        {
            log.info(&line);
        }
    });
    let mut errors = Vec::new();
    if let Some(said) = child.stderr.take() {
        let mut lines = BufReader::new(said).lines();
        while let Ok(Some(text)) = lines.next_line().await {
            let line: Line = serde_json::from_str(&text).unwrap_or_default();
            match (&line.stage, line.severity.as_deref()) {
                (Some(_), _) => bar.report(client, &line).await,
                (None, Some("error")) => errors.push(line.message),
                (None, Some(_)) => shared.log.info(&line.message),
                (None, None) => shared.log.info(&text),
            }
        }
    }
    let status = child.wait().await.map_err(|error| error.to_string())?;
    let _ = printing.await;
    match (status.success(), errors.as_slice()) {
        (true, _) => Ok(()),
        (false, []) => Err(format!("the run failed: {status}")),
        (false, [only]) => Err(only.clone()),
        (false, [first, rest @ ..]) => Err(format!("{first} (and {} more)", rest.len())),
    }
}

/// Outcome of a test.
pub(crate) struct Tested {
    pub passed: bool,
    pub message: String,
}

/// Runs the tests of a file whose names contain `name`.
///
/// # Errors
/// The process cannot be started or read.
pub(crate) async fn test(shared: &Shared, model: &Path, name: &str) -> Result<Tested, String> {
    let mut child = command(shared, model)
        .args(["test", "--filter", name])
        .args(allow_paths(shared))
        .arg(model)
        .spawn()
        .map_err(|error| format!("the test cannot be started: {error}"))?;
    let mut said = String::new();
    let printed = child.stdout.take();
    let draining = tokio::spawn(async move {
        let mut text = String::new();
        if let Some(mut printed) = printed {
            let _ = printed.read_to_string(&mut text).await;
        }
        text
    });
    if let Some(mut errors) = child.stderr.take() {
        errors.read_to_string(&mut said).await.map_err(|error| error.to_string())?;
    }
    let printed = draining.await.unwrap_or_default();
    let passed = child.wait().await.map_err(|error| error.to_string())?.success();
    let all = format!("{printed}{said}");
    let message = if passed {
        format!("test `{name}` passed")
    } else {
        shared.log.info(all.trim_end());
        let reason = all.lines().find(|line| line.contains("error")).unwrap_or("see the log");
        format!("test `{name}` failed: {}", reason.trim())
    };
    Ok(Tested { passed, message })
}

/// Returns the command to run this program in the folder of a model; the process is killed when its
/// handle is dropped.
fn command(shared: &Shared, model: &Path) -> Command {
    let mut command = Command::new(&shared.executable);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).kill_on_drop(true);
    if let Some(folder) = model.parent() {
        command.current_dir(folder);
    }
    command
}

/// Returns the options that allow the run the paths that the server allows.
fn allow_paths(shared: &Shared) -> Vec<OsString> {
    let allowed = shared.workspace().allowed.clone();
    allowed.iter().flat_map(|path| ["--allow-path".into(), path.clone().into_os_string()]).collect()
}

/// Requests a refresh of inlay hints, because outputs have new values.
async fn refresh(shared: &Shared, client: &Client) {
    let facts = shared.workspace().client.clone();
    let workspace = facts.capabilities.workspace.as_ref();
    let hints = workspace.and_then(|workspace| workspace.inlay_hint.as_ref());
    if hints.and_then(|hints| hints.refresh_support).unwrap_or(false)
        && let Err(error) = client.inlay_hint_refresh().await
    {
        shared.log.debug(&format!("the client did not refresh the inlay hints: {error}"));
    }
}

/// Progress bar in the editor. Does nothing if the client has no progress bars.
struct Bar {
    token: Option<ProgressToken>,
}

impl Bar {
    async fn begin(shared: &Shared, client: &Client, token: ProgressToken, title: String) -> Bar {
        let facts = shared.workspace().client.clone();
        let window = facts.capabilities.window.as_ref();
        if !window.and_then(|window| window.work_done_progress).unwrap_or(false) {
            return Bar { token: None };
        }
        let create = WorkDoneProgressCreateParams { token: token.clone() };
        if client.send_request::<WorkDoneProgressCreate>(create).await.is_err() {
            return Bar { token: None };
        }
        let bar = Bar { token: Some(token) };
        let begin = WorkDoneProgressBegin {
            title,
            cancellable: Some(true),
            percentage: Some(0),
            ..WorkDoneProgressBegin::default()
        };
        bar.send(client, WorkDoneProgress::Begin(begin)).await;
        bar
    }

    async fn report(&self, client: &Client, line: &Line) {
        let mut message = line.stage.clone().unwrap_or_default();
        if let Some(total) = line.total {
            message += &format!(" {}/{total}", line.done);
        }
        if let Some(left) = line.seconds_left.filter(|left| *left >= 1.0) {
            message += &format!(", {left:.0} s left");
        }
        let percentage =
            line.total.filter(|total| *total > 0).map(|total| line.done.min(total) * 100 / total);
        let report = WorkDoneProgressReport { cancellable: Some(true), message: Some(message), percentage };
        self.send(client, WorkDoneProgress::Report(report)).await;
    }

    async fn end(&self, client: &Client) {
        self.send(client, WorkDoneProgress::End(WorkDoneProgressEnd::default())).await;
    }

    async fn send(&self, client: &Client, progress: WorkDoneProgress) {
        if let Some(token) = &self.token {
            let value = ProgressParamsValue::WorkDone(progress);
            client.send_notification::<Progress>(ProgressParams { token: token.clone(), value }).await;
        }
    }
}
