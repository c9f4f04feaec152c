//! Tests the changes that diagnostics offer: every case of `offers.md` is a model with the lines
//! that each change would produce.
//!
//! `fix` marks automatic fixes of `calyx check --fix`, `offer` additional suggestions in editors.
//! `CALYX_BLESS=1` writes the actual changes into the file.

use crate::library::{Library, improper};
use calyx_lang::check_program;
use calyx_lang::diagnostic::{Diagnostic, Fix};
use std::fs;
use std::path::Path;

fn diagnostics(text: &str, library: &Library) -> Vec<Diagnostic> {
    check_program("model.cx", text, library).diagnostics
}

fn changed(text: &str, fix: &Fix) -> String {
    let mut changed = text.to_string();
    changed.replace_range(fix.span.start as usize..fix.span.end as usize, &fix.replacement);
    changed
}

/// Returns the changed line after a fix.
fn line(text: &str, fix: &Fix) -> String {
    let start = fix.span.start as usize;
    let line = text[..start].matches('\n').count();
    changed(text, fix).lines().nth(line).unwrap_or_default().trim().to_string()
}

#[test]
fn diagnostics_offer_what_they_say() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/offers.md");
    let document = fs::read_to_string(&path).expect("the corpus");
    let library = Library::read();
    let mut blessed = String::new();
    let mut failures = Vec::new();
    let (mut cases, mut rest) = (0, document.as_str());
    while let Some(at) = rest.find("```cx\n") {
        let body = &rest[at + "```cx\n".len()..];
        let end = body.find("```").expect("a program ends");
        let program = &body[..end];
        let mut found = String::new();
        let all = diagnostics(program, &library);
        failures.extend(improper(&all, program));
        for diagnostic in &all {
            for fix in diagnostic.fix.iter().chain(&diagnostic.suggestions) {
                let certain = diagnostic.fix.as_ref() == Some(fix);
                let word = if certain { "fix" } else { "offer" };
                let line = line(program, fix);
                found.push_str(&format!("{} {word} {}: {line}\n", diagnostic.code, fix.title));
                let like = |all: &[Diagnostic]| {
                    all.iter()
                        .filter(|d| d.code == diagnostic.code && d.message == diagnostic.message)
                        .count()
                };
                if certain && like(&diagnostics(&changed(program, fix), &library)) >= like(&all) {
                    failures.push(format!("`{}` does not fix the error\n{program}", fix.title));
                }
            }
        }
        let expected = &body[end..];
        let start = expected.find("```text\n").expect("an expectation") + "```text\n".len();
        let stop = start + expected[start..].find("```").expect("it ends");
        if expected[start..stop] != found {
            failures.push(format!("{program}gives\n{found}and not\n{}", &expected[start..stop]));
        }
        blessed.push_str(&rest[..at + "```cx\n".len() + end + start]);
        blessed.push_str(&found);
        rest = &expected[stop..];
        cases += 1;
    }
    blessed.push_str(rest);
    if std::env::var_os("CALYX_BLESS").is_some() {
        fs::write(&path, blessed).expect("the corpus can be written");
        return;
    }
    assert!(cases > 10, "only {cases} cases");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
