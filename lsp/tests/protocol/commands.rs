//! Commands without a run of a model; runs require the real command and are tested with it.

use crate::protocol::client::{Client, Folder};
use serde_json::{Value, json};

fn command(client: &mut Client, name: &str, arguments: Value) -> Result<Value, String> {
    let answer = client.ask("workspace/executeCommand", json!({ "command": name, "arguments": arguments }));
    answer.map_err(|error| error["message"].as_str().unwrap_or_default().to_owned())
}

#[test]
fn what_runs_is_what_the_editor_shows() {
    let folder = Folder::new();
    let model = folder.write("pair.cx", "print(1);\n");
    let mut client = Client::ready(json!({}));
    client.open(&model, "print(2);\n");
    let unsaved = command(&mut client, "calyx.run", json!([model]));
    assert_eq!(unsaved, Err("pair.cx has changes that are not saved: save it first".to_owned()));
    folder.write("pair.cx", "print(2);\n");
    let error = command(&mut client, "calyx.run", json!([model])).expect_err("there is no command");
    assert!(error.starts_with("the run cannot be started: "), "{error}");
    client.open("untitled:model", "print(1);\n");
    let nowhere = command(&mut client, "calyx.run", json!(["untitled:model"]));
    assert_eq!(nowhere, Err("save the model to a file first".to_owned()));
    assert_eq!(command(&mut client, "calyx.cancel", json!([model])), Ok(json!(false)));
    assert!(command(&mut client, "calyx.unknown", json!([model])).is_err());
    assert!(command(&mut client, "calyx.run", json!([])).is_err());
    assert!(client.leave());
}

#[test]
fn the_plan_is_that_of_the_text_in_the_editor() {
    let mut client = Client::ready(json!({}));
    let example = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    let text = std::fs::read_to_string(example).expect("there is an example");
    client.open("untitled:pair", &text);
    let plan = command(&mut client, "calyx.plan", json!(["untitled:pair"])).expect("the example is sound");
    let plan = plan.as_str().expect("a text");
    assert!(plan.starts_with("Method\n") && plan.contains("\nBodies\n"), "{plan}");
    client.set("untitled:pair", 2, &format!("{text}print(nothing);\n"));
    let broken = command(&mut client, "calyx.plan", json!(["untitled:pair"]));
    assert_eq!(broken, Err("untitled:pair has errors: fix them first".to_owned()));
    client.set("untitled:pair", 3, "print(1);\n");
    assert!(command(&mut client, "calyx.plan", json!(["untitled:pair"])).is_err());
    assert!(client.leave());
}
