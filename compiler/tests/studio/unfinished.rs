//! Analysis settings of runs, and runs that end early: their results, their continuation, and the
//! end of a studio that is killed.

use super::*;
use calyx::rt::run_directory::writer;

/// Starts a run and waits until it has solved some positions.
fn start_and_wait(server: &Server, form: &Value, positions: u64) -> String {
    let id = server.send("POST", "/api/runs", form).json()["id"].as_str().expect("a run").to_owned();
    wait_for_positions(server, &id, positions);
    id
}

fn wait_for_positions(server: &Server, id: &str, positions: u64) {
    let started = Instant::now();
    while server.get(&format!("/api/runs/{id}")).json()["progress"]["done"].as_u64().unwrap_or(0) < positions
    {
        assert!(started.elapsed() < LONGEST);
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn analysis_settings_are_checked_planned_run_and_recorded() {
    let (directory, _) = folder_with(PAIR);
    let server = Server::start(directory.path(), &["pair.cx"]);
    let offered = server.get("/api/studio").json()["settings"].clone();
    assert_eq!(
        (&offered[0]["name"], &offered[0]["choices"][2]["name"]),
        (&json!("fidelity"), &json!("plane"))
    );
    let check = |settings: Value| {
        server.send("POST", "/api/check", &json!({ "params": {}, "settings": settings })).json()
    };
    let (own, plane) = (check(json!({})), check(json!({ "fidelity": "plane", "error_estimates": "full" })));
    assert_eq!((&own["plan"]["fidelity"], &plane["plan"]["fidelity"]), (&json!("analytic"), &json!("plane")));
    for key in ["time", "memory"] {
        assert!(plane["plan"][key].as_f64() > own["plan"][key].as_f64(), "{key}: {plane}");
    }
    let wrong = check(json!({ "fidelity": "exact", "contact_cells": "0", "vtu": "1" }));
    let errors = wrong["setting_errors"].as_object().expect("errors");
    assert_eq!((errors.len(), &wrong["runnable"]), (3, &json!(false)), "{wrong}");
    let malformed = server.send("POST", "/api/runs", &json!({ "params": {}, "settings": { "fidelity": 1 } }));
    assert_eq!(malformed.status, 400);

    let settings = json!({ "contact_cells": "6", "position_stride": "2", "vtu": "FALSE" });
    let form = json!({ "params": { "steps": "5" }, "settings": settings });
    server.send("POST", "/api/runs", &form);
    let results = server.ended("run-0001");
    assert_eq!(results["status"], "finished", "{results}");
    assert_eq!(results["settings"], json!({ "contact_cells": "6", "position_stride": "2" }));
    assert_eq!(results["total"], results["positions"], "{results}");
    let record = fs::read(directory.path().join("pair.cx.studio/run-0001.json")).expect("a record");
    let record: Value = serde_json::from_slice(&record).expect("JSON");
    assert_eq!(record["settings"], settings);

    let session = json!({ "version": 1, "params": {}, "settings": { "fidelity": "plane" }, "view": null });
    assert_eq!(server.send("PUT", "/api/session", &session).status, 204);
    assert_eq!(server.get("/api/session").json(), session);
}

#[test]
fn a_cancelled_run_shows_its_positions_and_continues() {
    let (directory, _) = folder_with(PAIR);
    let server = Server::start(directory.path(), &["pair.cx"]);
    let form = json!({ "params": { "steps": "400" }, "settings": { "contact_cells": "6" } });
    let id = start_and_wait(&server, &form, 3);
    assert_eq!(server.post(&format!("/api/runs/{id}/continue"), json!({})).status, 409);
    assert_eq!(server.post(&format!("/api/runs/{id}/cancel"), json!({})).status, 202);
    let cancelled = server.ended(&id);
    assert_eq!(
        (&cancelled["status"], &cancelled["resumable"]),
        (&json!("cancelled"), &json!(true)),
        "{cancelled}"
    );
    let solved = cancelled["positions"].as_u64().expect("a number");
    assert!(solved >= 3 && solved < cancelled["total"].as_u64().expect("a number"), "{cancelled}");
    // Statistics of the whole run do not exist.
    assert!(cancelled["incomplete"] == true && cancelled["run"]["outputs"].is_null());
    let pressures = cancelled["steps"]["contact_pressure"].as_array().expect("a column");
    let largest = pressures.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert_eq!(cancelled["so_far"]["contact_pressure"]["max"].as_f64(), Some(largest / 1e6));
    assert_eq!(pressures.len() as u64, solved);
    assert!(
        !server.get(&format!("/api/runs/{id}/view")).json()["positions"]
            .as_array()
            .expect("a list")
            .is_empty()
    );

    let model = directory.path().join("pair.cx");
    fs::write(&model, PAIR.replace("80.1 mm", "80.2 mm")).expect("a model");
    let refused = server.post(&format!("/api/runs/{id}/continue"), json!({}));
    assert_eq!(refused.status, 409);
    assert!(refused.json()["message"].as_str().expect("a message").contains("the model has changed"));
    fs::write(&model, PAIR).expect("a model");

    // It continues in another studio, too.
    drop(server);
    let server = Server::start(directory.path(), &["pair.cx"]);
    assert_eq!(server.post(&format!("/api/runs/{id}/continue"), json!({})).status, 202);
    let finished = server.ended(&id);
    assert_eq!(
        (&finished["status"], &finished["resumable"]),
        (&json!("finished"), &json!(false)),
        "{finished}"
    );
    assert_eq!(finished["settings"], json!({ "contact_cells": "6" }));
    assert!(finished["so_far"].is_null() && finished["run"]["outputs"]["contact_pressure"].is_object());
    let whole = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .current_dir(directory.path())
        .args(["run", "pair.cx", "--quiet", "--no-cache", "--set", "steps=400", "--contact-cells", "6"])
        .status();
    assert!(whole.expect("calyx starts").success());
    let table = |folder: &str| fs::read(directory.path().join(folder).join("steps.csv")).expect("a table");
    assert_eq!(table("pair.cx.run"), table(&format!("pair.cx.studio/{id}")));
    assert_eq!(server.post(&format!("/api/runs/{id}/continue"), json!({})).status, 409);
    assert_eq!(server.post("/api/runs/model/continue", json!({})).status, 409);
}

#[test]
fn a_killed_studio_ends_its_runs() {
    let (directory, _) = folder_with(PAIR);
    let mut server = Server::start(directory.path(), &["pair.cx"]);
    let id = start_and_wait(&server, &json!({ "params": { "steps": "10000" } }), 3);
    server.child.kill().expect("the studio is in progress");
    server.child.wait().expect("the studio ends");
    let run = directory.path().join("pair.cx.studio").join(&id);
    let killed = Instant::now();
    while writer(&run).is_some() {
        assert!(killed.elapsed() < LONGEST);
        std::thread::sleep(Duration::from_millis(20));
    }
    // It ended as after Ctrl-C.
    let file = fs::read_to_string(run.join("run.json")).expect("a description");
    assert!(file.contains("\"incomplete\""), "{file}");

    let server = Server::start(directory.path(), &["pair.cx"]);
    let found = server.get(&format!("/api/runs/{id}")).json();
    assert_eq!((&found["status"], &found["resumable"]), (&json!("cancelled"), &json!(true)), "{found}");
    let solved = found["positions"].as_u64().expect("a number");
    assert_eq!(server.post(&format!("/api/runs/{id}/continue"), json!({})).status, 202);
    wait_for_positions(&server, &id, solved + 1);
    server.post(&format!("/api/runs/{id}/cancel"), json!({}));
    assert!(server.ended(&id)["positions"].as_u64() > Some(solved));
}
