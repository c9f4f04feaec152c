//! Edits, in both encodings.

use crate::protocol::client::Client;
use calyx_lang::parser;
use calyx_lang::span::FileId;
use calyx_lsp::server::handlers::router;
use calyx_lsp::server::view::View;
use serde_json::{Value, json};
use tower_lsp_server::ls_types::TextDocumentIdentifier;
use tower_lsp_server::ls_types::request::Request;

const MODEL: &str = "untitled:model";

/// Requests the text of the server, and its tree from the database.
enum Text {}

#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "camelCase")]
struct Params {
    text_document: TextDocumentIdentifier,
}

impl Request for Text {
    type Params = Params;
    type Result = (String, String);
    const METHOD: &'static str = "test/text";
}

fn client(capabilities: Value) -> Client {
    let mut router = router();
    router.on::<Text>(|view: &View, _| {
        let text = view.file(&view.file).map(|file| file.text.content().to_string());
        let tree = view.snapshot.database.parse(&view.file);
        Ok((text.unwrap_or_default(), tree.map(|tree| format!("{:?}", tree.module)).unwrap_or_default()))
    });
    Client::ready_with(router, capabilities)
}

/// Returns the text of the server, which must equal a fresh parse.
fn text(client: &mut Client) -> String {
    let answer = client.ask("test/text", json!({ "textDocument": { "uri": MODEL } }));
    let (text, tree): (String, String) =
        serde_json::from_value(answer.expect("nothing supersedes it")).expect("two texts");
    assert!(tree == format!("{:?}", parser::parse(FileId(0), &text).0), "the tree is not that of the text");
    text
}

fn utf8() -> Value {
    json!({ "general": { "positionEncodings": ["utf-16", "utf-8"] } })
}

fn replace(line: u32, from: u32, to: u32, text: &str) -> Value {
    let at = |character: u32| json!({ "line": line, "character": character });
    json!({ "range": { "start": at(from), "end": at(to) }, "text": text })
}

#[test]
fn positions_count_what_was_agreed() {
    let before = "var d = \"Ø😀\";  // größer\nprint(d);\n";
    for (capabilities, encoding, [quote, comment]) in
        [(json!({}), "utf-16", [12, 20]), (utf8(), "utf-8", [15, 24])]
    {
        let mut client = Client::new(router());
        let answer = client.initialize(capabilities.clone());
        assert_eq!(answer["capabilities"]["positionEncoding"], encoding);
        assert!(client.leave());
        let mut client = self::client(capabilities);
        client.open(MODEL, before);
        client.change(
            MODEL,
            2,
            json!([replace(0, quote, quote, "µ"), replace(0, comment, comment + 2, "kl")]),
        );
        assert_eq!(text(&mut client), "var d = \"Ø😀µ\";  // klößer\nprint(d);\n");
        // Diagnostics use the same encoding.
        client.change(MODEL, 3, json!([replace(1, 6, 7, "\"Ø😀\" + e")]));
        let found = client.diagnostics(MODEL, 3);
        let column = if encoding == "utf-16" { 14 } else { 17 };
        let unknown = found.iter().find(|diagnostic| diagnostic["code"] == "E0201").expect("`e` is unknown");
        assert_eq!(unknown["range"]["start"]["character"], column);
        assert!(client.leave());
    }
}

#[test]
fn edits_anywhere_do_no_harm() {
    let mut client = client(json!({}));
    client.open(MODEL, "a😀b\r\nc");
    client.change(MODEL, 2, json!([replace(0, 2, 2, "x")]));
    assert_eq!(text(&mut client), "ax😀b\r\nc");
    client.change(MODEL, 3, json!([replace(0, 99, 999, "y"), replace(77, 0, 3, "z")]));
    assert_eq!(text(&mut client), "ax😀by\r\ncz");
    client.change(MODEL, 4, json!([replace(0, 4, 1, "")]));
    assert_eq!(text(&mut client), "aby\r\ncz");
    client.change(MODEL, 5, json!([{ "text": "" }, replace(0, 0, 0, "new"), replace(0, 3, 3, "er")]));
    assert_eq!(text(&mut client), "newer");
    assert!(client.leave());
}

/// Reproducible random numbers.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) as usize) % end.max(1)
    }
}

const START: &str = "import gears;\nunits mm_N_s;\nparam width = 20 mm in 1 mm .. 50 mm;\n\
    function area(in a, in b = 2 mm) {\n    return a*b;\n}\n// größer 😀\n\
    var size = area(width);\nif (size > 3 mm^2) {\n    print(\"Ø {size}\");\n}\noutput o := size;\n";

const PIECES: &[&str] = &[
    "var x = 3 mm;\n",
    "}",
    "{",
    "(",
    ")",
    "\"",
    "/*",
    "*/",
    "// µ\n",
    "😀",
    "é",
    "\r\n",
    "\n",
    ";",
    "1e",
    ".",
    ":=",
    "import gears;\n",
    "function f(in a) { return a; }\n",
    "print(width);\n",
    " mm",
    "output q := area(1 mm);\n",
    "x = ",
    "gears.",
    "\t",
    "param ",
];

/// Computes the position of a character independently: counts line feeds and UTF-16 units. The
/// texts have no lone carriage return.
fn position(text: &str, offset: usize) -> Value {
    let before = &text[..offset];
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    let column = before[line_start..].encode_utf16().count();
    json!({ "line": before.matches('\n').count(), "character": column })
}

#[test]
fn two_thousand_edits_end_like_a_fresh_start() {
    let mut random = Random(7);
    let mut mirror = START.to_owned();
    let mut edited = client(json!({}));
    edited.open(MODEL, &mirror);
    let last = 2001;
    for version in 2..=last {
        let boundaries: Vec<usize> = mirror.char_indices().map(|(at, _)| at).chain([mirror.len()]).collect();
        let start = random.below(boundaries.len());
        let most = if mirror.len() > 1500 { 40 } else { 6 };
        let end = (start + random.below(most)).min(boundaries.len() - 1);
        let piece = if random.below(4) == 0 { "" } else { PIECES[random.below(PIECES.len())] };
        let (start, end) = (boundaries[start], boundaries[end]);
        let mut after = format!("{}{piece}{}", &mirror[..start], &mirror[end..]);
        let mut change = json!({
            "range": { "start": position(&mirror, start), "end": position(&mirror, end) }, "text": piece
        });
        // A position between a carriage return and its line feed is invalid. Occasionally resets
        // the text to a valid program.
        let between = |at: usize| mirror[..at].ends_with('\r') && mirror[at..].starts_with('\n');
        let alone = after.replace("\r\n", "").contains('\r');
        if between(start) || between(end) || alone || random.below(60) == 0 {
            after = START.to_owned();
            change = json!({ "text": after });
        }
        edited.change(MODEL, version, json!([change]));
        mirror = after;
        match random.below(40) {
            0 => assert_eq!(text(&mut edited), mirror, "version {version}"),
            1 => drop(edited.diagnostics(MODEL, version)),
            _ => {}
        }
    }
    assert_eq!(text(&mut edited), mirror);
    let found = edited.diagnostics(MODEL, last);
    let mut fresh = client(json!({}));
    fresh.open(MODEL, &mirror);
    assert_eq!(found, fresh.diagnostics(MODEL, 1));
    assert!(!found.is_empty(), "an end that is well shows little: choose another seed");
    assert!(fresh.leave());
    assert!(edited.leave());
}
