//! Library sources in the editor.

use crate::protocol::client::{Client, Folder};
use calyx_lsp::server::handlers::router;
use serde_json::{Value, json};

const TEXT: &str = "import gears;\nvar r = gears.rack(diametral_pitch = 10/inch);\nprint(r);\n";

#[test]
fn a_name_of_the_library_leads_to_a_file_that_is_read_like_any_other() {
    let folder = Folder::new();
    let model = folder.write("pair.cx", TEXT);
    let mut client = Client::with_cache(router(), &folder.path("cache"));
    client.initialize(json!({}));
    client.open(&model, TEXT);
    let place = json!({ "textDocument": { "uri": model }, "position": { "line": 1, "character": 16 } });
    let answer = client.ask("textDocument/definition", place).expect("nothing supersedes it");
    let found = match answer.as_array() {
        Some(all) => all[0].clone(),
        None => answer,
    };
    let uri = found["uri"].as_str().or(found["targetUri"].as_str()).expect("a place").to_owned();
    assert!(uri.starts_with(&folder.uri("cache/library-")) && uri.ends_with("/gears.cx"), "{uri}");
    let path = uri.strip_prefix("file://").expect("a file");
    let text = std::fs::read_to_string(path).expect("it was written");
    assert!(std::fs::metadata(path).expect("it is there").permissions().readonly());
    // The library is no model, and its findings are not published.
    client.open(&uri, &text);
    assert_eq!(client.diagnostics(&uri, 1), [] as [Value; 0]);
    let range = found.get("range").or(found.get("targetSelectionRange")).expect("a range");
    let place = json!({ "textDocument": { "uri": uri }, "position": range["start"] });
    let hover = client.ask("textDocument/hover", place).expect("nothing supersedes it");
    assert!(hover["contents"].to_string().contains("rack"), "{hover}");
    client.close(&uri);
    assert!(client.leave());
}
