//! Tests the checker with data: every fenced `cx` block of `check/*.md` is a model.
//!
//! Expected diagnostics are comments: `//~ E0401 part of the message` on the line of a diagnostic,
//! `//~^` on the line below it; `//= name: Length` expects a type. A block without `//~` must have
//! no diagnostics.

use calyx_lang::check::{Checked, Loader};
use calyx_lang::check_program;
use calyx_lang::diagnostic::Diagnostic;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The project's library, and a small module for tests.
struct Library;

const TEST_MODULE: &str = "extern pure function depth(in d: Length, in shape: String = \"flat\" in [\"flat\", \"round\"]) -> Length;\n\
     extern scene function part(in frame: Symbolic(Transform) :=, in count: Number = 1 in 1 .. 9) -> Part;\n\
     extern scene function load(in part: Part) -> Observable(Force);\n\
     function twice(in x) { return 2*x; }\n";

/// A module with every kind of declaration that a module can contain.
const COSTS: &str = "dimension Cost;\nunit euro: Cost;\nunit cent = 0.01 euro;\n\
     private const markup = 1.2;\nconst fee = 3 euro;\n\
     record Offer { price: Cost = fee; private_note = \"\"; }\n\
     private record Draft { n = 1; }\nprivate unit dime = 10 cent;\n\
     function sell(in price: Cost) -> Cost { return price*markup + fee; }\n\
     private function secret() { return Draft(); }\n";

fn library(name: &str) -> Option<(String, String)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../stdlib-gears/calyx/{name}.cx"));
    Some((format!("<library>/{name}.cx"), fs::read_to_string(path).ok()?))
}

impl Loader for Library {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        match path.join("/").as_str() {
            "parts" => Some(("parts.cx".into(), TEST_MODULE.into())),
            "costs" => Some(("costs.cx".into(), COSTS.into())),
            "loose" => Some(("loose.cx".into(), "var x = 1;".into())),
            "gears" => library("gears"),
            _ => None,
        }
    }

    fn prelude(&self) -> (String, String) {
        library("prelude").unwrap_or_default()
    }

    fn names(&self) -> Vec<String> {
        vec!["gears".into(), "parts".into()]
    }
}

fn check(text: &str) -> Checked {
    check_program("model.cx", text, &Library)
}

/// Returns the fenced `cx` blocks of a Markdown file, with their first lines.
fn blocks(text: &str) -> Vec<(usize, String)> {
    let mut blocks = Vec::new();
    let mut open: Option<(usize, String)> = None;
    for (index, line) in text.lines().enumerate() {
        match (&mut open, line.trim_end()) {
            (None, "```cx") => open = Some((index + 2, String::new())),
            (Some(_), "```") => blocks.extend(open.take()),
            (Some((_, block)), _) => {
                block.push_str(line);
                block.push('\n');
            }
            _ => {}
        }
    }
    assert!(open.is_none(), "a block is not closed");
    blocks
}

fn line_of(text: &str, offset: u32) -> usize {
    text.bytes().take(offset as usize).filter(|b| *b == b'\n').count()
}

fn describe(d: &Diagnostic, block: &str) -> String {
    format!("line {}: {} {}", line_of(block, d.primary.span.start) + 1, d.code, d.message)
}

/// Checks a block: returns missing and unexpected diagnostics.
fn judge(block: &str) -> Vec<String> {
    let checked = check(block);
    let mut left: Vec<&Diagnostic> = checked.diagnostics.iter().collect();
    let mut problems = Vec::new();
    for (index, line) in block.lines().enumerate() {
        for expectation in line.split("//~").skip(1) {
            let above = expectation.chars().take_while(|c| *c == '^').count();
            let text = expectation[above..].trim();
            // A diagnostic in another file, whose lines are not part of the block.
            let elsewhere = text.strip_prefix("elsewhere ");
            let text = elsewhere.unwrap_or(text);
            let (code, message) = text.split_once(' ').unwrap_or((text, ""));
            let found = left.iter().position(|d| {
                d.code == code
                    && (d.primary.span.file.0 == 0) == elsewhere.is_none()
                    && (elsewhere.is_some() || line_of(block, d.primary.span.start) + above == index)
                    && d.message.contains(message.trim())
            });
            match found {
                Some(at) => {
                    let diagnostic = left.remove(at);
                    if diagnostic.help.is_none() {
                        problems.push(format!("{} says nothing of what to do", describe(diagnostic, block)));
                    }
                }
                None => problems.push(format!("missing: line {}: {}", index + 1, expectation.trim())),
            }
        }
        if let Some((_, expectation)) = line.split_once("//=") {
            let (name, wanted) = expectation.split_once(':').unwrap_or((expectation, ""));
            let found = checked.types.get(name.trim()).cloned().unwrap_or_default();
            if found != wanted.trim() {
                problems.push(format!("`{}` is a {found}, not a {}", name.trim(), wanted.trim()));
            }
        }
    }
    problems.extend(left.iter().map(|d| format!("unexpected: {}", describe(d, block))));
    let failed = checked.diagnostics.iter().any(|d| d.code.starts_with('E'));
    if failed == checked.program.is_some() {
        problems.push("a program must result exactly if there is no error".into());
    }
    problems
}

#[test]
fn every_documented_program_is_judged_as_it_says() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/check");
    let mut files: Vec<_> =
        fs::read_dir(directory).expect("the corpus").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    let mut failures = Vec::new();
    let mut count = 0;
    for file in files {
        let text = fs::read_to_string(&file).expect("readable");
        for (line, block) in blocks(&text) {
            count += 1;
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            failures.extend(judge(&block).into_iter().map(|problem| format!("{name}:{line}: {problem}")));
        }
    }
    assert!(count > 0);
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn every_code_the_checker_uses_has_a_program_that_shows_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut shown = BTreeSet::new();
    for entry in fs::read_dir(root.join("tests/check")).expect("the corpus") {
        let text = fs::read_to_string(entry.expect("a file").path()).expect("readable");
        for (_, block) in blocks(&text) {
            for expectation in block.split("//~").skip(1) {
                let mut words = expectation.trim_start_matches('^').split_whitespace();
                shown.extend(words.find(|word| *word != "elsewhere").map(str::to_string));
            }
        }
    }
    let mut used = BTreeSet::new();
    collect_codes(&root.join("src/check"), &mut used);
    let missing: Vec<_> = used.difference(&shown).collect();
    assert!(missing.is_empty(), "no program shows {missing:?}");
}

fn collect_codes(directory: &Path, codes: &mut BTreeSet<String>) {
    for entry in fs::read_dir(directory).expect("sources") {
        let path = entry.expect("a file").path();
        if path.is_dir() {
            collect_codes(&path, codes);
        } else {
            let text = fs::read_to_string(&path).expect("readable");
            let pieces = text.split('"').filter(|piece| {
                piece.len() == 5
                    && piece.starts_with(['E', 'W'])
                    && piece[1..].bytes().all(|b| b.is_ascii_digit())
            });
            codes.extend(pieces.map(str::to_string));
        }
    }
}

/// Help examples shown in editors must be valid models.
#[test]
fn help_shows_programs_that_are_right() {
    let mut failures = Vec::new();
    for help in calyx_lang::help::all().filter(|help| !help.example.is_empty()) {
        let found = check(help.example).diagnostics;
        // Examples may contain unused declarations.
        let wrong =
            found.iter().filter(|d| d.code != "W0201").map(|d| format!("{}: {}", help.word, d.message));
        failures.extend(wrong);
        let laid_out = calyx_lang::format::format(help.example).unwrap_or_default();
        if laid_out.trim_end() != help.example {
            failures.push(format!("{} is laid out as\n{laid_out}", help.word));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_example_becomes_a_program() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    let text = fs::read_to_string(path).expect("the example");
    let checked = check(&text);
    let problems: Vec<_> = checked.diagnostics.iter().map(|d| describe(d, &text)).collect();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let program = checked.program.expect("a program");
    assert_eq!((program.params.len(), program.outputs.len(), program.sites.len()), (13, 8, 10));
    let orders: Vec<u8> = program.sites.iter().map(|site| site.order).collect();
    assert_eq!(orders, [2, 2, 0, 0, 0, 0, 0, 0, 0, 0], "two frames, eight outputs");
    let torque = &program.params[0];
    assert_eq!((torque.unit.name.as_str(), torque.integral), ("lbf*inch", false));
    assert!(program.params[9].integral, "steps is a count");
    assert!(program.doc.starts_with("Spur pair of the report"));
    let description = calyx_lang::description::describe(&program, calyx_abi::Fingerprint::default());
    let json = calyx_lang::description::to_json(&description).expect("writes");
    assert_eq!(calyx_lang::description::from_json(&json).expect("reads"), description);
}

/// Checks invalid programs: every program of the corpus truncated, and with a word removed.
#[test]
fn no_text_panics_the_checker() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/check");
    for entry in fs::read_dir(directory).expect("the corpus") {
        let text = fs::read_to_string(entry.expect("a file").path()).expect("readable");
        for (_, block) in blocks(&text) {
            let words: Vec<&str> = block.split_inclusive([' ', '(', ')', ';', '.', ',']).collect();
            for skipped in (0..words.len()).step_by(14) {
                let without: String =
                    words.iter().enumerate().filter(|(i, _)| *i != skipped).map(|(_, w)| *w).collect();
                check(&words[..skipped].concat());
                check(&without);
            }
        }
    }
}
