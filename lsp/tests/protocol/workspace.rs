//! Workspaces with several files: open, on disk, created and deleted.

use crate::protocol::client::{Client, Folder};
use calyx_lsp::server::handlers::router;
use serde_json::json;

const MODULE: &str = "units mm_N_s;\nfunction twice(in x) { return 2*x; }\n";
const MODEL: &str = "import util;\nunits mm_N_s;\nprint(util.twice(1 mm));\n";

#[test]
fn a_module_on_the_disk_is_found_and_its_buffer_wins() {
    let folder = Folder::new();
    let (model, module) = (folder.write("pair.cx", MODEL), folder.write("util.cx", MODULE));
    let mut client = Client::ready(json!({}));
    client.open(&model, MODEL);
    client.codes_become(&model, &[]);
    client.open(&module, MODULE);
    client.codes_become(&module, &[]);
    // The model uses the module before it is saved.
    client.set(&module, 2, &MODULE.replace("twice", "thrice"));
    client.codes_become(&model, &["E0204"]);
    client.close(&module);
    client.codes_become(&model, &[]);
    assert!(client.leave());
}

/// The rule of `--allow-path`: files outside of the model's folder are read only if the client
/// allows it.
#[cfg(unix)]
#[test]
fn files_elsewhere_are_read_where_the_client_allows_it() {
    let folder = Folder::new();
    let text = format!("{MODEL}print(len(column(read_table(\"../shared/table.csv\"), \"a\", 1)));\n");
    let model = folder.write("models/pair.cx", &text);
    folder.write("shared/util.cx", MODULE);
    folder.write("shared/table.csv", "a\n1\n");
    std::os::unix::fs::symlink(folder.path("shared/util.cx"), folder.path("models/util.cx")).expect("a link");
    let mut refused = Client::ready(json!({}));
    refused.open(&model, &text);
    refused.codes_become(&model, &["E0230"]);
    assert!(refused.leave());
    let mut client = Client::new(router());
    let paths = [folder.path("shared").display().to_string(), "/nowhere/at/all".to_owned()];
    client.initialize_with(json!({}), json!({ "allowPaths": paths }));
    client.open(&model, &text);
    client.codes_become(&model, &[]);
    // Elaboration reads the table.
    client.set(&model, 2, &text.replace("\"a\"", "\"b\""));
    client.codes_become(&model, &["E0733"]);
    assert!(client.leave());
}

#[test]
fn errors_of_a_module_are_shown_in_the_module() {
    let folder = Folder::new();
    let broken = MODULE.replace("2*x", "2*y");
    let (model, module) = (folder.write("pair.cx", MODEL), folder.write("util.cx", &broken));
    let mut client = Client::ready(json!({}));
    client.open(&model, MODEL);
    // Also while the module is closed.
    client.codes_become(&module, &["E0201"]);
    client.open(&module, &broken);
    client.set(&module, 2, MODULE);
    client.codes_become(&module, &[]);
    assert!(client.leave());
}

#[test]
fn a_module_opened_by_itself_is_checked_as_a_module() {
    let folder = Folder::new();
    folder.write("pair.cx", "import parts.util;\noutput o := parts.util.twice(1);\n");
    let module = folder.write("parts/util.cx", MODULE);
    let mut client = Client::ready(json!({}));
    // Executable statements belong in models; only a module gets this diagnostic.
    client.open(&module, &format!("{MODULE}print(1);\n"));
    client.codes_become(&module, &["E0210"]);
    client.set(&module, 2, MODULE);
    client.codes_become(&module, &[]);
    assert!(client.leave());
}

#[test]
fn an_open_file_becomes_a_module_when_a_model_imports_it() {
    let folder = Folder::new();
    let (model, module) = (folder.uri("pair.cx"), folder.uri("parts/util.cx"));
    let mut client = Client::ready(json!({}));
    client.open(&module, "print(1);\n");
    client.codes_become(&module, &[]);
    client.open(&model, "var a = 1;\nprint(a);\n");
    client.change(&model, 2, json!([{ "text": "import parts.util;\nprint(1);\n" }]));
    client.codes_become(&module, &["E0210"]);
    client.change(&model, 3, json!([{ "text": "print(1);\n" }]));
    client.codes_become(&module, &[]);
    assert!(client.leave());
}

#[test]
fn files_that_come_and_go_are_noticed() {
    let folder = Folder::new();
    let model = folder.write("pair.cx", MODEL);
    let mut client = Client::ready(json!({}));
    client.open(&model, MODEL);
    client.codes_become(&model, &["E0209"]);
    let module = folder.write("util.cx", MODULE);
    let changed = |kind: i32| json!({ "changes": [{ "uri": module, "type": kind }] });
    client.notify("workspace/didChangeWatchedFiles", changed(1));
    client.codes_become(&model, &[]);
    folder.write("util.cx", &MODULE.replace("twice", "thrice"));
    client.notify("workspace/didChangeWatchedFiles", changed(2));
    client.codes_become(&model, &["E0204"]);
    std::fs::remove_file(folder.path("util.cx")).expect("it was there");
    client.notify("workspace/didChangeWatchedFiles", changed(3));
    client.codes_become(&model, &["E0209"]);
    assert!(client.leave());
}

#[test]
fn diagnostics_go_with_what_they_are_about() {
    let folder = Folder::new();
    let (model, module) =
        (folder.write("pair.cx", MODEL), folder.write("util.cx", &MODULE.replace("2*x", "2*y")));
    let mut client = Client::ready(json!({}));
    client.open(&model, MODEL);
    client.codes_become(&module, &["E0201"]);
    client.set(&model, 2, "print(1);\n");
    client.codes_become(&module, &[]);
    client.set(&model, 3, "print(x);\n");
    client.codes_become(&model, &["E0201"]);
    client.close(&model);
    client.codes_become(&model, &[]);
    assert!(client.leave());
}

#[test]
fn files_are_watched_if_the_client_can() {
    let watched = json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } });
    let mut client = Client::ready(watched);
    client.open("untitled:model", "var a = 1;\n");
    client.diagnostics("untitled:model", 1);
    let registers = |message: &serde_json::Value| message["method"] == "client/registerCapability";
    assert!(client.notifications.iter().any(registers));
    assert!(client.leave());
}

/// Modules are regular files below the folder of their model. Reading a pipe would block the
/// server.
#[cfg(unix)]
#[test]
fn pipes_and_links_that_lead_out_are_not_read() {
    let (folder, elsewhere) = (Folder::new(), Folder::new());
    elsewhere.write("secret.cx", MODULE);
    std::os::unix::fs::symlink(elsewhere.path("secret.cx"), folder.path("util.cx")).expect("a link");
    let made = std::process::Command::new("mkfifo").arg(folder.path("pipe.cx")).status();
    assert!(made.is_ok_and(|status| status.success()));
    let model = folder.write("pair.cx", MODEL);
    let mut client = Client::ready(json!({}));
    client.open(&model, MODEL);
    client.codes_become(&model, &["E0230"]);
    client.set(&model, 2, "import pipe;\n");
    client.codes_become(&model, &["E0230"]);
    assert!(client.leave());
}

#[test]
fn half_typed_records_do_not_end_the_server() {
    let folder = Folder::new();
    let text = "record P { x; }\nfunction f(in p) {\n    return p;\n    return p.x;\n}\nprint(f(P()));\n";
    let model = folder.write("pair.cx", text);
    let mut client = Client::ready(json!({}));
    client.open(&model, text);
    client.codes_become(&model, &["E0115", "E0302", "E0206"]);
    client.set(&model, 2, "print(1);\n");
    client.codes_become(&model, &[]);
    assert!(client.leave());
}
