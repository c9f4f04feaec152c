//! Runs of instances: without the GIL, with signals, progress and printed lines handled on the
//! calling thread.

use calyx::{Error, Instance, Progress};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// Time between two checks for signals.
const POLL: Duration = Duration::from_millis(50);

/// Handle that cancels runs, from any thread.
#[pyclass(frozen, module = "calyx", name = "Cancel")]
#[derive(Default)]
pub struct Cancel(pub calyx::Cancel);

#[pymethods]
impl Cancel {
    #[new]
    fn new() -> Cancel {
        Cancel::default()
    }

    /// Ends all runs that have this handle. It stays cancelled.
    fn cancel(&self) {
        self.0.cancel();
    }

    /// Returns a handle of its own that this one cancels too.
    fn child(&self) -> Cancel {
        Cancel(self.0.child())
    }

    /// True after `cancel`.
    #[getter]
    fn cancelled(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// Message of the thread of a run.
enum Message {
    Progress(Progress),
    Printed(String),
    Ended(Box<Result<calyx::Results, Error>>),
}

/// Functions of the caller.
#[derive(Default)]
pub struct Callbacks<'py> {
    /// Receives stage, number of solved positions and number of all positions.
    pub progress: Option<Bound<'py, PyAny>>,
    /// Receives printed lines.
    pub print: Option<Bound<'py, PyAny>>,
}

/// Runs an instance to its end. `cancel` cancels it.
///
/// # Errors
/// A signal handler or a callback raised an exception; the run has been cancelled and has ended.
pub fn solve(
    py: Python<'_>,
    mut instance: Instance,
    cancel: &calyx::Cancel,
    callbacks: &Callbacks<'_>,
) -> PyResult<Result<calyx::Results, Error>> {
    let (sender, mut messages) = channel();
    if callbacks.progress.is_some() {
        let sender = sender.clone();
        // Messages of a run whose caller has given up are dropped.
        instance.on_progress(move |progress| drop(sender.send(Message::Progress(progress))));
    }
    if callbacks.print.is_some() {
        let sender = sender.clone();
        instance.on_print(move |line| drop(sender.send(Message::Printed(line.to_owned()))));
    }
    let run = move |sender: Sender<Message>| {
        let outcome = instance.solve();
        drop(sender.send(Message::Ended(Box::new(outcome))));
    };
    let thread = thread::Builder::new()
        .name("calyx run".into())
        .spawn(move || run(sender))
        .map_err(|error| PyRuntimeError::new_err(format!("cannot start a thread for the run: {error}")))?;
    let outcome = loop {
        let received;
        (messages, received) = py.detach(move || {
            let received = messages.recv_timeout(POLL);
            (messages, received)
        });
        let handled = match received {
            Ok(Message::Ended(outcome)) => break Ok(*outcome),
            Ok(message) => handle(message, callbacks).and_then(|()| py.check_signals()),
            Err(RecvTimeoutError::Timeout) => py.check_signals(),
            Err(RecvTimeoutError::Disconnected) => {
                break Err(PyRuntimeError::new_err("internal error: the run has no outcome"));
            }
        };
        if let Err(raised) = handled {
            cancel.cancel();
            break Err(raised);
        }
    };
    // The run ends soon after its cancellation. A panic of its thread is reported above.
    drop(py.detach(|| thread.join()));
    outcome
}

fn handle(message: Message, callbacks: &Callbacks<'_>) -> PyResult<()> {
    match (message, callbacks) {
        (Message::Progress(Progress { stage, done, total }), Callbacks { progress: Some(call), .. }) => {
            call.call1((stage, done, total)).map(drop)
        }
        (Message::Printed(line), Callbacks { print: Some(call), .. }) => call.call1((line,)).map(drop),
        _ => Ok(()),
    }
}
