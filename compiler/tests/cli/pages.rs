//! Reads a page of `cli/`, runs its commands and compares their results with the page.

use super::{calyx_reads, edited};
use std::path::Path;
use std::process::Output;

/// One `## ` section of a page.
#[derive(Default)]
struct Case {
    name: String,
    /// Initial files by name. A block `cx` or `edit` is `model.cx`, a block `file NAME` any other.
    files: Vec<(String, String)>,
    commands: Vec<Expected>,
}

/// Command line with its expected results.
#[derive(Default)]
struct Expected {
    arguments: Vec<String>,
    /// Environment variables.
    variables: Vec<(String, String)>,
    status: Option<i32>,
    /// Complete standard output.
    out: Vec<String>,
    /// Parts of standard output.
    out_has: Vec<String>,
    /// Texts that standard output must not contain.
    out_lacks: Vec<String>,
    /// Parts of standard error, in this order.
    err: Vec<String>,
    err_lacks: Vec<String>,
    silent: bool,
    /// Lines of standard input.
    input: Vec<String>,
    /// Parts of files, by name.
    file_has: Vec<(String, String)>,
}

fn cases(page: &str) -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(name) = line.strip_prefix("## ") {
            cases.push(Case { name: name.into(), ..Case::default() });
        } else if let Some(kind) = line.strip_prefix("```") {
            let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            let case = cases.last_mut().expect("a block belongs to a section");
            match kind {
                "cx" => case.files.push(("model.cx".into(), block.join("\n"))),
                "edit" => case.files.push(("model.cx".into(), edited(&block))),
                _ if kind.starts_with("file ") => {
                    case.files.push((kind["file ".len()..].into(), block.join("\n")));
                }
                "console" => block.iter().for_each(|line| expectation(&mut case.commands, line)),
                other => panic!("unknown block `{other}`"),
            }
        }
    }
    cases
}

/// Splits a command line into words; blanks between quotes are part of a word.
pub fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quoted) = (Vec::new(), None::<String>, false);
    for c in line.chars() {
        match c {
            '"' => {
                quoted = !quoted;
                word.get_or_insert_default();
            }
            ' ' if !quoted => words.extend(word.take()),
            _ => word.get_or_insert_default().push(c),
        }
    }
    words.extend(word);
    words
}

fn expectation(commands: &mut Vec<Expected>, line: &str) {
    // Words before the command set environment variables.
    let call = line.strip_prefix("$").and_then(|line| line.split_once(" calyx"));
    if let Some((variables, arguments)) = call {
        let variables = words(variables).into_iter();
        let variables = variables.filter_map(|word| word.split_once('=').map(|(a, b)| (a.into(), b.into())));
        let variables = variables.collect();
        let arguments = words(arguments);
        commands.push(Expected { arguments, variables, ..Expected::default() });
        return;
    }
    let command = commands.last_mut().expect("a command comes first");
    let (kind, text) = line.split_once("| ").unwrap_or((line, ""));
    match kind {
        "out" => command.out.push(text.into()),
        "has out" => command.out_has.push(text.into()),
        "no out" => command.out_lacks.push(text.into()),
        "err" => command.err.push(text.into()),
        "no err" => command.err_lacks.push(text.into()),
        "err none" => command.silent = true,
        "in" => command.input.push(text.into()),
        _ if kind.starts_with("file ") => {
            command.file_has.push((kind["file ".len()..].into(), text.into()));
        }
        _ => command.status = Some(line.strip_prefix("exit ").and_then(|n| n.parse().ok()).expect(line)),
    }
}

/// Describes the first mismatch of a command's output and files; `None` if they match.
fn difference(expected: &Expected, output: &Output, directory: &Path) -> Option<String> {
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if output.status.code() != expected.status {
        return Some(format!("exit status {:?} instead of {:?}", output.status.code(), expected.status));
    }
    let all_of_out = expected.out_has.is_empty();
    if all_of_out && out.lines().ne(expected.out.iter().map(String::as_str)) {
        return Some("standard output differs".into());
    }
    if let Some(missing) = expected.out_has.iter().find(|part| !out.contains(part.as_str())) {
        return Some(format!("standard output lacks `{missing}`"));
    }
    if let Some(extra) = expected.out_lacks.iter().find(|part| out.contains(part.as_str())) {
        return Some(format!("standard output has `{extra}`"));
    }
    let mut rest = &err[..];
    for part in &expected.err {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return Some(format!("standard error lacks `{part}`, or has it too early")),
        }
    }
    if let Some(extra) = expected.err_lacks.iter().find(|part| err.contains(part.as_str())) {
        return Some(format!("standard error has `{extra}`"));
    }
    for (name, part) in &expected.file_has {
        let text = std::fs::read_to_string(directory.join(name)).unwrap_or_default();
        if !text.contains(part.as_str()) {
            return Some(format!("{name} lacks `{part}`"));
        }
    }
    (expected.silent && !err.is_empty()).then(|| "standard error is not empty".into())
}

/// Runs all cases of a page.
pub fn hold(page: &str) {
    let mut failures = String::new();
    for case in cases(page) {
        let directory = tempfile::tempdir().expect("a directory");
        for (name, text) in &case.files {
            let path = directory.path().join(name);
            std::fs::create_dir_all(path.parent().expect("a directory")).expect("the directory is made");
            std::fs::write(path, text).expect("the file is written");
        }
        assert!(!case.commands.is_empty(), "{} runs nothing", case.name);
        for expected in &case.commands {
            let input: String = expected.input.iter().map(|line| format!("{line}\n")).collect();
            let output = calyx_reads(directory.path(), &expected.arguments, &expected.variables, &input);
            if let Some(difference) = difference(expected, &output, directory.path()) {
                let (out, err) =
                    (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
                failures += &format!(
                    "## {}\n{difference}: calyx {}\n--- out\n{out}--- err\n{err}\n",
                    case.name,
                    expected.arguments.join(" ")
                );
            }
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}
