//! Routes of the server. Requests and responses are JSON; errors are `{code, message, help}`.
//!
//! | Route | Effect |
//! |---|---|
//! | `GET /` , `/studio.js`, `/studio.css` | the page |
//! | `GET /api/studio` | version, what was opened, analysis settings of the form |
//! | `GET /api/model` | params with type, unit, range, choices, default, documentation and group; outputs; diagnostics |
//! | `POST /api/check` | `{params, settings}`: errors by param and setting, diagnostics, and the plan with predicted time and memory: one elaboration provides all of them |
//! | `POST /api/params` | `{name, text}`: values of a params file |
//! | `GET, PUT /api/session` | the session file |
//! | `GET /api/runs` | list of runs |
//! | `POST /api/runs` | `{params, settings}`: starts a run |
//! | `POST /api/preview` | `{params, settings}`: starts the automatic run in place of the previous one |
//! | `GET /api/runs/ID` | results, positions and messages of a run |
//! | `POST /api/runs/ID/cancel` | interrupts a run |
//! | `POST /api/runs/ID/continue` | resumes a run that ended early |
//! | `GET /api/runs/ID/view` | positions for the viewer |
//! | `GET /api/runs/ID/files/NAME` | a file of a run |
//! | `POST /api/scene` | `{params, settings}`: the scene at time 0 without solving, as `{parts, position}`: both files of the viewer in base64 |
//! | `GET /api/events` | event stream: `model`, `runs`, `progress` |

use super::check::{Form, Outcome, check, scene_of};
use super::error::RequestError;
use super::events::Event;
use super::page::{self, json_response};
use super::runs::PREVIEW;
use super::session::{self, Session};
use super::{Studio, access, files, requests, settings};
use axum::Router;
use axum::body::Bytes;
use axum::extract::{DefaultBodyLimit, Path, State};
use axum::http::{HeaderMap, StatusCode};
use axum::middleware::from_fn_with_state;
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use std::sync::Arc;

/// Response of a request, or its error.
type Answer = Result<Response, RequestError>;
type Shared = State<Arc<Studio>>;

/// Largest body of a request, bytes: a session and some space for its form.
const LARGEST_BODY: usize = session::LONGEST + (4 << 10);

/// Returns the routes, all behind the check of access.
pub(crate) fn router(studio: Arc<Studio>) -> Router {
    Router::new()
        .route("/", get(page::page))
        .route("/studio.js", get(page::script))
        .route("/studio.css", get(page::style))
        .route("/api/studio", get(about))
        .route("/api/model", get(model))
        .route("/api/check", post(check_values))
        .route("/api/params", post(params_file))
        .route("/api/session", get(read_session).put(write_session))
        .route("/api/runs", get(runs).post(start))
        .route("/api/preview", post(preview))
        .route("/api/runs/{id}", get(results))
        .route("/api/runs/{id}/cancel", post(cancel))
        .route("/api/runs/{id}/continue", post(resume))
        .route("/api/runs/{id}/view", get(view))
        .route("/api/runs/{id}/files/{*name}", get(file))
        .route("/api/scene", post(scene))
        .route("/api/events", get(events))
        .layer(DefaultBodyLimit::max(LARGEST_BODY))
        .layer(from_fn_with_state(studio.clone(), access::guard))
        .with_state(studio)
}

/// Runs a function that blocks: it reads files or checks a model.
async fn blocking<T: Send + 'static>(
    studio: &Arc<Studio>,
    work: impl FnOnce(&Studio) -> Result<T, RequestError> + Send + 'static,
) -> Result<T, RequestError> {
    let studio = studio.clone();
    let done = tokio::task::spawn_blocking(move || work(&studio));
    done.await.map_err(|error| RequestError::internal("the request failed", &error))?
}

/// As [`blocking`], for a check of the model, of which few run at a time.
async fn checking<T: Send + 'static>(
    studio: &Arc<Studio>,
    work: impl FnOnce(&Studio) -> Result<T, RequestError> + Send + 'static,
) -> Result<T, RequestError> {
    let permit = studio.checks.acquire().await;
    let _permit = permit.map_err(|error| RequestError::internal("the request failed", &error))?;
    blocking(studio, work).await
}

fn no_model() -> RequestError {
    RequestError::conflict("the model of this run is not known", "start `calyx studio` with the model")
}

async fn about(State(studio): Shared) -> Answer {
    let about = blocking(&studio, |studio| {
        Ok(json!({
            "calyx": env!("CARGO_PKG_VERSION"),
            "model": studio.model.as_ref().map(|model| model.path().display().to_string()),
            "subject": studio.runs.subject(),
            "opened": studio.runs.opened(),
            "settings": settings::described(),
        }))
    });
    Ok(json_response(&about.await?))
}

async fn model(State(studio): Shared) -> Answer {
    let model = checking(&studio, |studio| {
        let model = studio.model.as_ref().ok_or_else(no_model)?;
        Ok(model.now().json.clone())
    });
    Ok(json_response(&model.await?))
}

async fn checked(studio: &Arc<Studio>, form: Form) -> Result<Outcome, RequestError> {
    checking(studio, move |studio| {
        let model = studio.model.as_ref().ok_or_else(no_model)?;
        let snapshot = model.now();
        check(model, &snapshot, &form).map_err(|error| {
            RequestError::conflict(format!("cannot read the model: {error}"), "restore its file")
        })
    })
    .await
}

async fn check_values(State(studio): Shared, headers: HeaderMap, body: Bytes) -> Answer {
    let form = requests::form(&headers, &body)?;
    Ok(json_response(&checked(&studio, form).await?.json))
}

async fn params_file(headers: HeaderMap, body: Bytes) -> Answer {
    let body = requests::json(&headers, &body)?;
    let (Some(name), Some(text)) = (body["name"].as_str(), body["text"].as_str()) else {
        return Err(RequestError::invalid("the request has no texts `name` and `text`", ""));
    };
    let values = requests::params_file(name, text.to_owned())?;
    Ok(json_response(&json!({ "params": values })))
}

fn session_of(studio: &Studio) -> Result<&Session, RequestError> {
    studio.session.as_ref().ok_or_else(no_model)
}

async fn read_session(State(studio): Shared) -> Answer {
    Ok(json_response(&blocking(&studio, |studio| session_of(studio)?.read()).await?))
}

async fn write_session(State(studio): Shared, headers: HeaderMap, body: Bytes) -> Answer {
    let session = requests::json(&headers, &body)?;
    if blocking(&studio, move |studio| session_of(studio)?.write(session)).await? {
        studio.events.send(Event::Session);
    }
    Ok(StatusCode::NO_CONTENT.into_response())
}

async fn runs(State(studio): Shared) -> Answer {
    let list = blocking(&studio, |studio| Ok(studio.runs.list()));
    Ok(json_response(&json!({ "runs": list.await? })))
}

/// Refuses to start what the check rejects, with the reasons in the key `check`.
fn rejected(outcome: &Outcome) -> Response {
    let body = json!({
        "code": "invalid_model",
        "message": "the model or its params have errors",
        "help": "fix the errors that are shown",
        "check": outcome.json,
    });
    (StatusCode::UNPROCESSABLE_ENTITY, json_response(&body)).into_response()
}

async fn start(State(studio): Shared, headers: HeaderMap, body: Bytes) -> Answer {
    let form = requests::form(&headers, &body)?;
    let outcome = checked(&studio, form.clone()).await?;
    if !outcome.is_runnable {
        return Ok(rejected(&outcome));
    }
    // A process is started on a thread of the server: it belongs to its runtime.
    let id = studio.runs.start(&form, &outcome.json["plan"]["positions"])?;
    Ok((StatusCode::CREATED, json_response(&json!({ "id": id }))).into_response())
}

async fn preview(State(studio): Shared, headers: HeaderMap, body: Bytes) -> Answer {
    let form = requests::form(&headers, &body)?;
    let outcome = checked(&studio, form.clone()).await?;
    if !outcome.is_runnable {
        return Ok(rejected(&outcome));
    }
    let started = studio.runs.start_preview(&form).await?;
    let answer = json!({ "id": PREVIEW, "started": started });
    Ok((StatusCode::ACCEPTED, json_response(&answer)).into_response())
}

async fn results(State(studio): Shared, Path(id): Path<String>) -> Answer {
    Ok(json_response(&blocking(&studio, move |studio| studio.runs.results(&id)).await?))
}

async fn cancel(State(studio): Shared, Path(id): Path<String>) -> Answer {
    studio.runs.cancel(&id)?;
    Ok(StatusCode::ACCEPTED.into_response())
}

async fn resume(State(studio): Shared, Path(id): Path<String>) -> Answer {
    blocking(&studio, move |studio| studio.runs.resume(&id)).await?;
    Ok(StatusCode::ACCEPTED.into_response())
}

async fn view(State(studio): Shared, Path(id): Path<String>) -> Answer {
    let listed: Value = blocking(&studio, move |studio| files::view(&studio.runs, &id)).await?;
    Ok(json_response(&listed))
}

async fn file(State(studio): Shared, Path((id, name)): Path<(String, String)>) -> Answer {
    files::send(&studio.runs, &id, &name).await
}

/// Sends the scene of the model with the values of a form, as it is at time 0 before anything is
/// solved.
async fn scene(State(studio): Shared, headers: HeaderMap, body: Bytes) -> Answer {
    let form = requests::form(&headers, &body)?;
    let [parts, position] = checking(&studio, move |studio| {
        let model = studio.model.as_ref().ok_or_else(no_model)?;
        scene_of(model, &model.now(), &form)
    })
    .await?
    .map(|file| STANDARD.encode(file));
    Ok(json_response(&json!({ "parts": parts, "position": position })))
}

async fn events(State(studio): Shared) -> Response {
    studio.events.stream()
}
