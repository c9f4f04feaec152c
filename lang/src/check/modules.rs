//! Loading: the model, the prelude and every module they import, each parsed once.

use super::symbols::similar;
use super::{Loader, ModuleData};
use crate::ast::{Ident, StmtKind};
use crate::diagnostic::Diagnostic;
use crate::ir::SourceFile;
use crate::parser;
use crate::span::FileId;
use crate::units::UnitSystem;
use std::collections::VecDeque;

/// Parsed modules (the model first, the prelude second), their files, and what is wrong with their text.
pub fn load(
    name: &str,
    text: &str,
    loader: &dyn Loader,
) -> (Vec<ModuleData>, Vec<SourceFile>, Vec<Diagnostic>) {
    let mut loading = Loading::default();
    loading.add("", name.into(), text.into());
    let (prelude_name, prelude_text) = loader.prelude();
    loading.add("prelude", prelude_name, prelude_text);
    while let Some(path) = loading.wanted.pop_front() {
        let module = path.iter().map(|ident| ident.name.as_str()).collect::<Vec<_>>().join(".");
        if loading.modules.iter().any(|known| known.name == module) {
            continue;
        }
        let names: Vec<String> = path.iter().map(|ident| ident.name.clone()).collect();
        match loader.module(&names) {
            Some((shown, text)) => loading.add(&module, shown, text),
            None => loading.missing(&path, &module, loader),
        }
    }
    (loading.modules, loading.files, loading.diagnostics)
}

#[derive(Default)]
struct Loading {
    modules: Vec<ModuleData>,
    files: Vec<SourceFile>,
    diagnostics: Vec<Diagnostic>,
    wanted: VecDeque<Vec<Ident>>,
}

impl Loading {
    fn add(&mut self, module: &str, shown: String, text: String) {
        let file = FileId(self.files.len() as u32);
        let (tree, mut found) = parser::parse(file, &text);
        self.diagnostics.append(&mut found);
        let mut system = None;
        for statement in &tree.statements {
            match &statement.kind {
                StmtKind::Import(path) => self.wanted.push_back(path.clone()),
                // An unknown system is reported where statements are checked.
                StmtKind::Units(name) => system = system.or(UnitSystem::from_name(&name.name)),
                _ => {}
            }
        }
        self.files.push(SourceFile { name: shown, text: text.clone() });
        self.modules.push(ModuleData { name: module.into(), file, text, tree, system });
    }

    fn missing(&mut self, path: &[Ident], module: &str, loader: &dyn Loader) {
        let (Some(first), Some(last)) = (path.first(), path.last()) else { return };
        let known = loader.names();
        let diagnostic = Diagnostic::error(
            "E0209",
            format!("there is no module `{module}`"),
            first.span.to(last.span),
            "neither in the library nor beside this file",
        );
        let diagnostic = match similar(module, known.iter().map(String::as_str)) {
            Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
                format!("change to `{near}`"),
                first.span.to(last.span),
                near,
            ),
            None if known.is_empty() => {
                diagnostic.help(format!("put `{}.cx` beside this file", module.replace('.', "/")))
            }
            None => diagnostic.help(format!("the library has {}", known.join(", "))),
        };
        self.diagnostics.push(diagnostic);
    }
}
