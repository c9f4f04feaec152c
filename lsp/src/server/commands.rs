//! Commands of clients: run a model, run a test, show the plan, cancel.
//!
//! The first argument of each is the URI of the document.

use super::Shared;
use super::background::may_read;
use super::runs::{self, Stop};
use super::workspace::path_of;
use calyx_elaborate::{Cancel, Params, elaborate};
use calyx_lang::db::Superseded;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tower_lsp_server::Client;
use tower_lsp_server::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp_server::ls_types::{ExecuteCommandOptions, ExecuteCommandParams, MessageType, Uri};

/// Runs a model; answers with its results after the run.
pub const RUN: &str = "calyx.run";
/// Runs a test, whose name is the second argument; answers whether it passed.
pub const TEST: &str = "calyx.test";
/// Returns the plan of a model's analysis as text.
pub const PLAN: &str = "calyx.plan";
/// Cancels the run of a model.
pub const CANCEL: &str = "calyx.cancel";

pub fn offered() -> ExecuteCommandOptions {
    let commands = [RUN, TEST, PLAN, CANCEL].map(str::to_owned).to_vec();
    ExecuteCommandOptions { commands, ..ExecuteCommandOptions::default() }
}

pub async fn execute(
    shared: &Arc<Shared>,
    client: &Client,
    params: ExecuteCommandParams,
) -> Result<Option<Value>> {
    let uri = params.arguments.first().and_then(|uri| serde_json::from_value::<Uri>(uri.clone()).ok());
    let Some(uri) = uri else {
        return Err(Error::invalid_params(format!("{} takes the URI of a model", params.command)));
    };
    match params.command.as_str() {
        RUN => {
            let model = saved(shared, &uri)?;
            let summary = runs::run(shared, client, &uri, &model).await.map_err(refused)?;
            Ok(Some(json!({ "directory": summary.directory, "message": summary.message })))
        }
        TEST => {
            let model = saved(shared, &uri)?;
            let name = params.arguments.get(1).and_then(Value::as_str).unwrap_or_default();
            let tested = runs::test(shared, &model, name).await.map_err(refused)?;
            let kind = if tested.passed { MessageType::INFO } else { MessageType::ERROR };
            client.show_message(kind, &tested.message).await;
            Ok(Some(json!({ "passed": tested.passed, "message": tested.message })))
        }
        PLAN => {
            let shared = shared.clone();
            let plan = tokio::task::spawn_blocking(move || plan(&shared, &uri)).await;
            plan.unwrap_or_else(|_| Err(Error::internal_error())).map(|text| Some(json!(text)))
        }
        CANCEL => {
            let stopped = shared.runs.stop(&Stop::Model(uri));
            Ok(Some(json!(stopped)))
        }
        other => Err(Error {
            message: format!("there is no command `{other}`").into(),
            ..Error::method_not_found()
        }),
    }
}

fn refused(message: String) -> Error {
    Error { code: ErrorCode::ServerError(-32803), message: message.into(), data: None }
}

/// Returns the file of a document. Runs use the file on disk, so this requires that the editor has
/// saved it.
fn saved(shared: &Shared, uri: &Uri) -> Result<PathBuf> {
    let path = path_of(uri).ok_or_else(|| refused("save the model to a file first".to_owned()))?;
    let shown = shared.workspace().documents().get(uri).map(|document| document.text.clone());
    let on_disk = std::fs::read_to_string(&path);
    let name = path.file_name().unwrap_or_default().display();
    match (shown, on_disk) {
        (Some(shown), Ok(on_disk)) if **shown.content() == *on_disk => Ok(path),
        (None, Ok(_)) => Ok(path),
        (_, Ok(_)) => Err(refused(format!("{name} has changes that are not saved: save it first"))),
        (_, Err(error)) => Err(refused(format!("{name} cannot be read: {error}"))),
    }
}

/// Largest number of attempts to compute a plan, each after a change of a text.
const MOST_ATTEMPTS: usize = 5;

/// Returns the plan of a model as it is in the editor.
fn plan(shared: &Shared, uri: &Uri) -> Result<String> {
    for _ in 0..MOST_ATTEMPTS {
        let Some(view) = shared.workspace().view(Some(uri)) else {
            return Err(refused("open the model first".to_owned()));
        };
        let name = Path::new(&*view.file).file_name().unwrap_or_default().display().to_string();
        let checked = view.snapshot.database.attempt(|database| database.check(&view.file));
        let known = view.snapshot.elaborated.get(&view.file).cloned();
        // Released early, so that a change of a text need not wait.
        drop(view);
        let checked = match checked {
            Ok(Some(checked)) => checked,
            Ok(None) => return Err(refused(format!("{name} is a module: models have plans"))),
            Err(Superseded) => continue,
        };
        let Some(program) = &checked.program else {
            return Err(refused(format!("{name} has errors: fix them first")));
        };
        let text = match known.filter(|known| known.is_of(&checked)) {
            Some(known) => known.elaboration.plan.as_ref().map(|plan| plan.text()),
            None => {
                let program = may_read(program, shared.workspace().allowed.clone());
                let elaboration = elaborate(&program, Params::Defaults, &Cancel::default());
                elaboration.ok().and_then(|elaboration| elaboration.plan).map(|plan| plan.text())
            }
        };
        let nothing =
            || refused(format!("{name} has nothing to analyse, or something is wrong with its scene"));
        return text.ok_or_else(nothing);
    }
    Err(Error::content_modified())
}
