//! Latency on a model of 5,000 lines with an edit before each request, and memory use over ten
//! thousand edits: `cargo bench -p calyx-lsp`.
//!
//! Times are measured by the client, from sending the edit to receiving the answer, over in-memory
//! pipes. The check triggered by the edit runs concurrently.

#[allow(dead_code)]
#[path = "../tests/protocol/client.rs"]
mod client;
#[path = "../../lang/tests/support/generator.rs"]
mod generator;

use client::Client;
use serde_json::{Value, json};
use std::time::{Duration, Instant};

const MODEL: &str = "untitled:model";
const LINES: usize = 5_000;
const ROUNDS: usize = 200;
const EDITS: i32 = 10_000;

/// A text that is edited line by line, here and in the server.
struct Editor {
    client: Client,
    lines: Vec<String>,
    version: i32,
}

impl Editor {
    fn new() -> Editor {
        let text = generator::model(LINES);
        let mut client = Client::ready(json!({}));
        client.open(MODEL, &text);
        client.diagnostics(MODEL, 1);
        Editor { client, lines: text.split('\n').map(str::to_owned).collect(), version: 1 }
    }

    /// Replaces a line by any number of lines.
    fn replace(&mut self, line: usize, by: &[String]) {
        self.version += 1;
        let end = self.lines[line].encode_utf16().count();
        let range =
            json!({ "start": { "line": line, "character": 0 }, "end": { "line": line, "character": end } });
        self.client.change(MODEL, self.version, json!([{ "range": range, "text": by.join("\n") }]));
        self.lines.splice(line..=line, by.iter().cloned());
    }

    /// Returns the next line with a text from line `from` on, or else the first one.
    fn find(&self, from: usize, text: &str) -> usize {
        let found = self.lines.iter().skip(from).position(|line| line.contains(text)).map(|at| at + from);
        found
            .or_else(|| self.lines.iter().position(|line| line.contains(text)))
            .expect("the generator writes it")
    }

    fn settle(&mut self) {
        self.client.diagnostics(MODEL, self.version);
        self.client.notifications.clear();
    }

    fn ask(&mut self, method: &str, line: usize, character: usize) -> Value {
        let position = json!({ "line": line, "character": character });
        let params = json!({
            "textDocument": { "uri": MODEL }, "position": position, "range": { "start": position, "end": position },
            "context": {
                "diagnostics": [], "includeDeclaration": true, "triggerKind": 1, "isRetrigger": false,
            }, "options": { "tabSize": 4, "insertSpaces": true },
        });
        self.client.ask(method, params).unwrap_or_default()
    }
}

/// Makes edit `n`, one of several kinds: a changed number in a function, a new line near the top,
/// an incomplete name.
fn edit(editor: &mut Editor, n: usize) -> (usize, usize) {
    let from = n * 487 % LINES;
    let line = editor.find(from, "*weight_");
    let mut text = editor.lines[line].clone();
    match n % 3 {
        0 => {
            text = format!("        total = total + {}*step*weight_{};", n % 7 + 2, after(&text, "weight_"));
            let column = text.find("weight_").unwrap_or_default() + 2;
            editor.replace(line, &[text]);
            (line, column)
        }
        1 => {
            let top = editor.find(0, "/// Speed of");
            let comment = format!("// Note {n}.");
            let before = editor.lines[top].clone();
            editor.replace(top, &[comment, before]);
            (line + 1, text.find("weight_").unwrap_or_default() + 2)
        }
        _ => {
            let typed = "        tot".to_owned();
            editor.replace(line, &[text, typed.clone()]);
            (line + 1, typed.len())
        }
    }
}

/// Returns the rest of a statement after a text.
fn after<'a>(line: &'a str, text: &str) -> &'a str {
    line.split(text).nth(1).and_then(|rest| rest.split(';').next()).unwrap_or_default()
}

/// Replaces the line with the incomplete name by a valid one.
fn fix(editor: &mut Editor, n: usize, line: usize) {
    if n % 3 == 2 {
        editor.replace(line, &["        total = total + step;".to_owned()]);
        editor.settle();
    }
}

fn percentile(times: &mut [Duration], part: usize) -> f64 {
    times.sort();
    let at = (times.len() * part / 100).min(times.len().saturating_sub(1));
    times.get(at).map_or(0.0, |time| time.as_secs_f64() * 1e3)
}

fn report(name: &str, times: &mut [Duration], processor: f64) {
    let [half, most, all] = [50, 95, 100].map(|part| percentile(times, part));
    let each = processor / times.len().max(1) as f64;
    println!("{name:<36} {half:>8.1} {most:>8.1} {all:>8.1} {each:>8.1}");
}

/// Returns the CPU time of this process in ms, including the check after the edit.
fn processor() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields = stat.rsplit(") ").next().unwrap_or_default().split(' ');
    // User and system time, in hundredths of a second.
    fields.skip(11).take(2).filter_map(|field| field.parse::<f64>().ok()).sum::<f64>() * 10.0
}

fn of_request(editor: &mut Editor, method: &str) {
    let mut times = Vec::new();
    let worked = processor();
    let mut answered = 0;
    for n in 0..ROUNDS {
        let begun = Instant::now();
        let (line, character) = edit(editor, n);
        let answer = editor.ask(method, line, character);
        times.push(begun.elapsed());
        answered += usize::from(!answer.is_null());
        editor.settle();
        fix(editor, n, line);
    }
    report(method, &mut times, processor() - worked);
    if answered < ROUNDS / 2 {
        println!("    ... but only {answered} of {ROUNDS} had an answer");
    }
}

fn of_diagnostics(editor: &mut Editor) {
    let mut times = Vec::new();
    let worked = processor();
    for n in 0..ROUNDS {
        let begun = Instant::now();
        let (line, _) = edit(editor, n);
        editor.settle();
        times.push(begun.elapsed());
        fix(editor, n, line);
    }
    report("diagnostics after the last key", &mut times, processor() - worked);
}

/// Measures memory under edits at full speed, with occasional requests.
fn of_memory(editor: &mut Editor) {
    let before = memory("VmRSS");
    let begun = Instant::now();
    for n in 0..EDITS {
        let line = editor.find(n as usize * 37 % LINES, "*weight_");
        let text = editor.lines[line].clone();
        let text = format!("        total = total + {}*step*weight_{};", n % 100, after(&text, "weight_"));
        editor.replace(line, &[text]);
        if n % 10 == 0 {
            editor.settle();
            editor.ask("textDocument/hover", line, 10);
        }
    }
    editor.settle();
    let per_edit = begun.elapsed().as_secs_f64() * 1e3 / f64::from(EDITS);
    println!(
        "{EDITS} edits: {per_edit:.2} ms each; resident {before:.0} MB before, {:.0} MB after, {:.0} MB at most",
        memory("VmRSS"),
        memory("VmHWM")
    );
}

/// Returns the memory use of this process, client and server, in MB, from the operating system.
fn memory(name: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(':'));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(f64::NAN) / 1e3
}

fn main() {
    let mut editor = Editor::new();
    println!("{LINES} lines, {ROUNDS} rounds; ms {:>11} {:>8} {:>8} {:>8}", "median", "95 %", "most", "busy");
    // `-- hover` measures only requests with that name, `-- memory` only memory.
    let wanted = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let wanted = |name: &str| wanted.as_ref().is_none_or(|wanted| name.contains(wanted.as_str()));
    if wanted("diagnostics") {
        of_diagnostics(&mut editor);
    }
    let methods = [
        "textDocument/completion",
        "textDocument/hover",
        "textDocument/definition",
        "textDocument/documentHighlight",
        "textDocument/references",
        "textDocument/codeAction",
        "textDocument/documentSymbol",
        "textDocument/semanticTokens/full",
        "textDocument/inlayHint",
        "textDocument/foldingRange",
        "textDocument/codeLens",
        "textDocument/formatting",
    ];
    for method in methods.into_iter().filter(|method| wanted(method)) {
        of_request(&mut editor, method);
    }
    if wanted("memory") {
        of_memory(&mut editor);
    }
    editor.client.leave();
}
