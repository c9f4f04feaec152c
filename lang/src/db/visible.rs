//! Queries for the names that can be used at a location.

use super::analysis::{RelativeTarget, relative_names};
use super::items::{declared, items, module};
use super::units::id;
use super::{Database, Text};
use crate::analysis::{NameKind, SourceRange, Visible};
use crate::check::builtins;
use crate::check::item::ItemKind;
use crate::deep_recursion::with_deep_stack;
use crate::hashed::HashSet;
use crate::scope::{self, Local};
use std::sync::Arc;

/// The known properties of a name declared in a file.
pub(super) struct NameInfo {
    pub kind: NameKind,
    pub ty: Option<Arc<str>>,
    /// The module that a module's name denotes.
    pub module: Option<SourceRange>,
}

impl Database {
    /// Returns the names that can be used at an offset: those of the file, innermost first, of the
    /// prelude, and of the language. Shadowed names are not included.
    pub fn visible(&self, file: &str, offset: u32) -> Vec<Visible> {
        let known = |local: &Local, _: &str| {
            // In an invalid text, the name may have no meaning.
            let name = self.name_at(file, local.span.start)?;
            match local.kind {
                NameKind::Module => Some(NameInfo { kind: local.kind, ty: None, module: name.declared }),
                _ => name.declares.then_some(NameInfo { kind: name.kind, ty: name.ty, module: None }),
            }
        };
        with_deep_stack(|| self.seen_by(file, offset, &known))
    }

    /// Computes [`Database::visible`]; `known` returns the properties of a name of the file itself.
    pub(super) fn seen_by(
        &self,
        file: &str,
        offset: u32,
        known: &dyn Fn(&Local, &str) -> Option<NameInfo>,
    ) -> Vec<Visible> {
        let (Some(text), Some(tokens)) = (self.find(file), self.tokens(file)) else { return Vec::new() };
        let db = &self.salsa;
        let content = text.content(db);
        let mut found: Vec<Visible> = Vec::new();
        let mut seen = HashSet::default();
        let own: Arc<str> = text.name(db).clone();
        for local in scope::visible(&tokens.tokens, offset) {
            let name = content.get(local.span.start as usize..local.span.end as usize).unwrap_or_default();
            if !seen.insert(name.to_string()) {
                continue;
            }
            let known = known(&local, name);
            let declared = match local.kind {
                NameKind::Module => known.as_ref().and_then(|known| known.module.clone()),
                _ => Some(SourceRange { file: own.clone(), start: local.span.start, end: local.span.end }),
            };
            found.push(Visible {
                name: name.into(),
                kind: known.as_ref().map_or(local.kind, |known| known.kind),
                ty: known.and_then(|known| known.ty),
                declared,
                level: Some(local.level),
            });
        }
        let prelude = self.library.prelude(db);
        if prelude != text {
            found.extend(self.exports(prelude).into_iter().filter(|v| seen.insert(v.name.to_string())));
        }
        for name in builtins::names() {
            if seen.insert(name.to_string()) {
                let constant = builtins::constant(name).is_some();
                let kind = if constant { NameKind::Constant } else { NameKind::Builtin };
                let ty = builtins::shown(name).map(|shown| Arc::from(shown.to_string()));
                found.push(Visible { name: name.into(), kind, ty, declared: None, level: None });
            }
        }
        found
    }

    /// Returns the names of a module that importers see.
    pub fn members(&self, module_path: &str) -> Vec<Visible> {
        match module(&self.salsa, self.library, module_path.to_string()) {
            Some(text) => self.exports(*text),
            None => Vec::new(),
        }
    }

    fn exports(&self, text: Text) -> Vec<Visible> {
        let db = &self.salsa;
        let own: Arc<str> = text.name(db).clone();
        let mut found = Vec::new();
        with_deep_stack(|| {
            for &item in items(db, text) {
                let named =
                    matches!(item.kind(db), ItemKind::Function | ItemKind::Extern | ItemKind::Declaration);
                if !named || item.private(db) {
                    continue;
                }
                let start = item.start(db);
                let name = relative_names(db, item, self.library)
                    .iter()
                    .find(|name| name.target == RelativeTarget::In(id(item), name.start, name.end));
                found.extend(name.map(|name| Visible {
                    name: name.text.clone(),
                    kind: name.kind,
                    ty: name.ty.clone(),
                    declared: Some(SourceRange {
                        file: own.clone(),
                        start: start + name.start,
                        end: start + name.end,
                    }),
                    level: None,
                }));
            }
        });
        found
    }

    /// Returns the modules that export this name, each with the declaration.
    pub fn exported(&self, name: &str) -> Vec<(String, Visible)> {
        let db = &self.salsa;
        let mut found = Vec::new();
        for (path, text) in self.library.modules(db) {
            if declared(db, *text).contains_key(name) {
                let all = self.exports(*text).into_iter().filter(|visible| &*visible.name == name);
                found.extend(all.map(|visible| (path.clone(), visible)));
            }
        }
        found
    }
}
