//! The library for programs under test, and checks that every diagnostic must pass.

use calyx_lang::check::Loader;
use calyx_lang::codes;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::span::FileId;
use std::fs;
use std::path::Path;

pub fn folder(relative: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(relative)
}

/// The project's library.
pub struct Library {
    prelude: String,
    gears: String,
}

fn read(name: &str) -> Option<String> {
    fs::read_to_string(folder("../stdlib-gears/calyx").join(name)).ok()
}

impl Library {
    pub fn read() -> Library {
        let text = |name| read(name).expect("the library");
        Library { prelude: text("prelude.cx"), gears: text("gears.cx") }
    }
}

impl Loader for Library {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let [name] = path else { return None };
        let file = format!("{name}.cx");
        let text = if name == "gears" { Some(self.gears.clone()) } else { read(&file) };
        text.map(|text| (file, text))
    }

    fn prelude(&self) -> (String, String) {
        ("prelude.cx".into(), self.prelude.clone())
    }
}

/// Returns a description of an invalid diagnostic: a location outside the text, or a code without
/// an explanation.
pub fn improper(diagnostics: &[Diagnostic], text: &str) -> Option<String> {
    let outside = |start: u32, end: u32| start > end || text.get(start as usize..end as usize).is_none();
    diagnostics.iter().find_map(|d| {
        let labels = d.labels.iter().filter(|label| label.span.file == FileId(0)).map(|label| label.span);
        let fix = d.fix.iter().chain(&d.suggestions).map(|fix| fix.span);
        let mut spans = labels.chain(fix).chain((d.primary.span.file == FileId(0)).then_some(d.primary.span));
        if spans.any(|span| outside(span.start, span.end)) {
            return Some(format!("{} lies outside the text: {d:?}", d.code));
        }
        codes::explain(&d.code).is_none().then(|| format!("{} has no page", d.code))
    })
}
