//! The process of a run: its start, progress, messages and cancellation.

use super::events::{Event, Events, progress};
use super::folder;
use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};
use std::ffi::OsString;
use std::io;
use std::path::PathBuf;
use std::process::{ExitStatus, Stdio};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::io::{AsyncRead, AsyncReadExt};
use tokio::process::{Child, Command};
use tokio::sync::{Notify, watch};

/// Time in which an interrupted run writes its files before its process is killed.
const GRACE: Duration = Duration::from_secs(10);
/// Time in which pipes of an ended process are read to their end.
const PIPES: Duration = Duration::from_secs(2);
/// Shortest time between two events of progress.
const PROGRESS: Duration = Duration::from_millis(100);
/// Largest number of messages that are kept.
const MOST_MESSAGES: usize = 200;
/// Largest length of a message or of the kept text that the model prints, bytes.
const LONGEST: usize = 64 << 10;

/// Status of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    Running,
    Finished,
    Failed,
    Cancelled,
}

impl Status {
    pub fn name(self) -> &'static str {
        match self {
            Status::Running => "running",
            Status::Finished => "finished",
            Status::Failed => "failed",
            Status::Cancelled => "cancelled",
        }
    }
}

/// Command line of a run, and where its start and its end are recorded.
pub(crate) struct Start {
    pub id: String,
    pub command: PathBuf,
    pub arguments: Vec<OsString>,
    /// File and content of the record; `None` for automatic runs.
    pub record: Option<(PathBuf, Value)>,
}

/// A run that this studio started.
pub(crate) struct Process {
    id: String,
    state: Mutex<State>,
    cancel: Notify,
    ended: watch::Sender<bool>,
}

struct State {
    status: Status,
    cancelled: bool,
    /// The last progress line of the run.
    progress: Value,
    sent: Option<Instant>,
    messages: Vec<Value>,
    printed: String,
}

impl Process {
    /// Starts the process of a run.
    ///
    /// # Errors
    /// The process cannot be started.
    pub fn start(start: Start, events: Events) -> io::Result<Arc<Process>> {
        let Start { id, command, arguments, record } = start;
        let mut child = Command::new(command)
            .args(arguments)
            // The run is cancelled at its end, also if the studio is killed.
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            // Ctrl-C reaches the studio only, which interrupts the run once. A second signal would
            // end the run without its files.
            .process_group(0)
            .kill_on_drop(true)
            .spawn()?;
        let process = Arc::new(Process {
            id,
            state: Mutex::new(State {
                status: Status::Running,
                cancelled: false,
                progress: json!({ "stage": "starting", "done": 0, "total": null, "seconds_left": null }),
                sent: None,
                messages: Vec::new(),
                printed: String::new(),
            }),
            cancel: Notify::new(),
            ended: watch::Sender::new(false),
        });
        // Waiting for the child would close its input.
        let input = child.stdin.take();
        let supervised = supervise(process.clone(), child, record, events);
        tokio::spawn(async move {
            supervised.await;
            drop(input);
        });
        Ok(process)
    }

    pub fn status(&self) -> Status {
        self.state().status
    }

    /// Returns the progress of the run.
    pub fn progress(&self) -> Value {
        self.state().progress.clone()
    }

    /// Returns errors, warnings and notes of the run.
    pub fn messages(&self) -> Vec<Value> {
        self.state().messages.clone()
    }

    /// Returns the last text that the model printed.
    pub fn printed(&self) -> String {
        self.state().printed.clone()
    }

    /// Interrupts the run, and kills it if it does not end.
    pub fn cancel(&self) {
        self.state().cancelled = true;
        self.cancel.notify_one();
    }

    /// Waits until the process has ended.
    pub async fn wait(&self) {
        let _ = self.ended.subscribe().wait_for(|ended| *ended).await;
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Interprets a line that the run writes to standard error.
    fn read_line(&self, line: &str, events: &Events) {
        let value: Value = serde_json::from_str(line).unwrap_or(Value::Null);
        let mut state = self.state();
        if value["stage"].is_string() {
            let is_new_stage = state.progress["stage"] != value["stage"];
            state.progress = value;
            if is_new_stage || state.sent.is_none_or(|sent| sent.elapsed() >= PROGRESS) {
                state.sent = Some(Instant::now());
                events.send(progress(&self.id, state.progress.clone()));
            }
            return;
        }
        let message = match value["severity"].is_string() {
            true => value,
            false => json!({ "severity": "note", "code": null, "message": line, "help": null }),
        };
        if state.messages.len() < MOST_MESSAGES {
            state.messages.push(message);
        }
    }

    fn read_printed(&self, line: &str) {
        let mut state = self.state();
        if state.printed.len() + line.len() < LONGEST {
            state.printed += line;
            state.printed.push('\n');
        }
    }
}

/// Reads the output of a run, waits for its end, and records it.
async fn supervise(
    process: Arc<Process>,
    mut child: Child,
    record: Option<(PathBuf, Value)>,
    events: Events,
) {
    let (out, err) = (child.stdout.take(), child.stderr.take());
    let (printing, reading) = (process.clone(), process.clone());
    let progress_events = events.clone();
    let pipes = tokio::spawn(async move {
        tokio::join!(
            lines(out, |line| printing.read_printed(line)),
            lines(err, |line| reading.read_line(line, &progress_events))
        )
    });
    let status = tokio::select! {
        status = child.wait() => status,
        () = process.cancel.notified() => interrupt(&mut child).await,
    };
    // A process that the run started may still have the pipes.
    let _ = tokio::time::timeout(PIPES, pipes).await;
    process.end(status.ok());
    if let Some((path, mut record)) = record {
        record["status"] = json!(process.status().name());
        record["messages"] = json!(process.messages());
        let written = tokio::task::spawn_blocking(move || {
            // If the folder was deleted, nothing of the run remains to be described.
            let text = serde_json::to_vec_pretty(&record)?;
            folder::replace(&path, &text)
        });
        let _ = written.await;
    }
    process.ended.send_replace(true);
    events.send(Event::Runs);
}

/// Interrupts a run, and kills it after the grace period.
async fn interrupt(child: &mut Child) -> io::Result<ExitStatus> {
    // The process has not been waited for, so its number is not that of another process.
    let pid = child.id().and_then(|id| Pid::from_raw(i32::try_from(id).ok()?));
    if let Some(pid) = pid {
        let _ = kill_process(pid, Signal::INT);
    }
    match tokio::time::timeout(GRACE, child.wait()).await {
        Ok(status) => status,
        Err(_) => {
            child.start_kill()?;
            child.wait().await
        }
    }
}

impl Process {
    fn end(&self, status: Option<ExitStatus>) {
        let mut state = self.state();
        let success = status.is_some_and(|status| status.success());
        state.status = match (success, state.cancelled) {
            (true, _) => Status::Finished,
            (false, true) => Status::Cancelled,
            (false, false) => Status::Failed,
        };
        let has_error = state.messages.iter().any(|message| message["severity"] == "error");
        if state.status == Status::Failed && !has_error {
            let how = status.map_or_else(|| "its process was lost".to_owned(), |status| status.to_string());
            state.messages.push(json!({
                "severity": "error", "code": null, "message": format!("the run ended without a reason: {how}"), "help": null,
            }));
        }
    }
}

/// Calls a function with each line of a stream. The rest of a long line is dropped.
async fn lines(stream: Option<impl AsyncRead + Unpin>, mut of_line: impl FnMut(&str)) {
    let Some(mut stream) = stream else { return };
    let (mut buffer, mut line) = ([0_u8; 8 << 10], Vec::new());
    while let Ok(count) = stream.read(&mut buffer).await {
        if count == 0 {
            break;
        }
        for byte in &buffer[..count] {
            if *byte == b'\n' {
                of_line(&String::from_utf8_lossy(&line));
                line.clear();
            } else if line.len() < LONGEST {
                line.push(*byte);
            }
        }
    }
    if !line.is_empty() {
        of_line(&String::from_utf8_lossy(&line));
    }
}
