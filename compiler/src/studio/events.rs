//! Events of the server, and the stream that sends them to pages.

use super::Studio;
use axum::response::sse::{Event as SentEvent, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use futures_util::stream;
use serde_json::{Value, json};
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::broadcast;
use tokio::sync::broadcast::error::RecvError;

/// Number of events that a slow page may lag behind.
const LAG: usize = 256;
/// Time between two looks at the files of the model and the runs.
const POLL: Duration = Duration::from_millis(400);

/// An event.
#[derive(Clone, Debug)]
pub(crate) enum Event {
    /// The files of the model changed.
    Model,
    /// A run started, ended, appeared or disappeared.
    Runs,
    /// The form of the session changed.
    Session,
    /// Progress of a run: an object with its `id`.
    Progress(Value),
}

impl Event {
    fn sent(&self) -> SentEvent {
        match self {
            Event::Model => SentEvent::default().event("model").data("{}"),
            Event::Runs => SentEvent::default().event("runs").data("{}"),
            Event::Session => SentEvent::default().event("session").data("{}"),
            Event::Progress(progress) => SentEvent::default().event("progress").data(progress.to_string()),
        }
    }
}

/// Sender of events to all pages.
#[derive(Clone)]
pub(crate) struct Events(broadcast::Sender<Event>);

impl Default for Events {
    fn default() -> Events {
        Events(broadcast::Sender::new(LAG))
    }
}

impl Events {
    pub fn send(&self, event: Event) {
        // Without pages, nobody receives it.
        let _ = self.0.send(event);
    }

    /// Returns a response that sends events until the page is closed.
    pub fn stream(&self) -> Response {
        let first = stream::iter([Event::Model, Event::Runs, Event::Session]);
        let later = stream::unfold(self.0.subscribe(), |mut receiver| async move {
            match receiver.recv().await {
                Ok(event) => Some((event, receiver)),
                // The page requests everything again.
                Err(RecvError::Lagged(_)) => Some((Event::Runs, receiver)),
                Err(RecvError::Closed) => None,
            }
        });
        let all = stream::StreamExt::chain(first, later);
        let sent = stream::StreamExt::map(all, |event| Ok::<_, Infallible>(event.sent()));
        Sse::new(sent).keep_alive(KeepAlive::default()).into_response()
    }
}

/// Watches the files of the model and the runs of other processes.
pub(crate) async fn watch(studio: Arc<Studio>) {
    let (mut version, mut runs) = (None, None);
    loop {
        tokio::time::sleep(POLL).await;
        let here = studio.clone();
        // A request may have checked a changed model before, so versions are compared.
        let looked = tokio::task::spawn_blocking(move || {
            (here.model.as_ref().map(|model| model.now().version.clone()), here.runs.state())
        });
        // A panic of one look does not end the watch.
        let Ok((seen, state)) = looked.await else { continue };
        if version != seen {
            studio.events.send(Event::Model);
            version = seen;
        }
        if runs.as_ref() != Some(&state) {
            studio.events.send(Event::Runs);
            runs = Some(state);
        }
    }
}

/// Returns the progress of a run as an event.
pub(crate) fn progress(id: &str, mut state: Value) -> Event {
    state["id"] = json!(id);
    Event::Progress(state)
}
