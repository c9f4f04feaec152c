//! A cache of the types of a file's names at the last check.
//!
//! Types change less often than texts. While a statement is typed, completion shows the cached
//! types and does not wait for a check of the current text.

use super::Database;
use super::callables::Types;
use super::items::items;
use super::visible::NameInfo;
use crate::analysis::{Callable, NameKind, SourceRange, Visible};
use crate::ast::{FunctionDecl, RecordDecl, RecordField};
use crate::check::ShownScheme;
use crate::check::item::ItemKind;
use crate::deep_recursion::with_deep_stack;
use crate::hashed::HashMap;
use crate::lexer::{Kind, Token};
use crate::scope::Local;
use std::sync::{Arc, Mutex, PoisonError};

/// Cached names by file.
#[derive(Default)]
pub(super) struct Recent(Mutex<HashMap<String, Arc<Names>>>);

/// Kinds and types by the enclosing function or record (empty at the top level) and by name.
type Names = HashMap<String, HashMap<Arc<str>, (NameKind, Option<Arc<str>>)>>;

impl Database {
    /// Checks a file and stores the known properties of its declared names. A name without known
    /// properties, because its statement is incomplete, keeps its previous ones.
    pub fn remember(&self, file: &str) {
        let Some(text) = self.find(file) else { return };
        let db = &self.salsa;
        let before = self.recent(file);
        let mut names = Names::default();
        with_deep_stack(|| {
            for &item in items(db, text) {
                let own = item.name(db);
                let holds =
                    matches!(item.kind(db), ItemKind::Function | ItemKind::Extern | ItemKind::Declaration);
                for name in self.names_of(item).into_iter().filter(|name| name.declares) {
                    let around = if holds && *name.text != **own { own.as_str() } else { "" };
                    let known = || before.as_ref()?.get(around)?.get(&name.text)?.1.clone();
                    let ty = name.ty.or_else(known);
                    names.entry(around.to_string()).or_default().insert(name.text, (name.kind, ty));
                }
            }
        });
        let mut recent = self.recent.0.lock().unwrap_or_else(PoisonError::into_inner);
        recent.insert(file.to_string(), Arc::new(names));
    }

    fn recent(&self, file: &str) -> Option<Arc<Names>> {
        self.recent.0.lock().unwrap_or_else(PoisonError::into_inner).get(file).cloned()
    }

    /// Returns [`Database::visible`] with the cached types of the file's own names; the first call
    /// fills the cache. Names declared since then have no type.
    pub fn seen(&self, file: &str, offset: u32) -> Vec<Visible> {
        let (Some(text), Some(tokens)) = (self.text(file), self.tokens(file)) else { return Vec::new() };
        if self.recent(file).is_none() {
            self.remember(file);
        }
        let names = self.recent(file).unwrap_or_default();
        let function = function_around(&tokens.tokens, offset);
        let inner = function
            .and_then(|name| text.get(name.span.start as usize..name.span.end as usize))
            .and_then(|function| names.get(function));
        let lookup = |local: &Local, name: &str| {
            if local.kind == NameKind::Module {
                let module = self.module_named(text, &tokens.tokens, local);
                return Some(NameInfo { kind: local.kind, ty: None, module });
            }
            let top = || names.get("")?.get(name);
            let (kind, ty) = match function {
                Some(function) if local.span.start > function.span.start => {
                    // Names declared after the function are also visible in it, except variables.
                    let hoisted = !matches!(local.kind, NameKind::Variable | NameKind::Parameter);
                    inner.and_then(|inner| inner.get(name)).or_else(|| top().filter(|_| hoisted))
                }
                _ => top(),
            }?;
            // The declaration may have changed. Tokens distinguish variables and functions, but not
            // the kinds of functions.
            let alike = match local.kind {
                NameKind::Variable => matches!(kind, NameKind::Variable | NameKind::Symbolic),
                NameKind::Function => {
                    matches!(kind, NameKind::Function | NameKind::SymbolicFunction | NameKind::Extern)
                }
                other => *kind == other,
            };
            alike.then(|| NameInfo { kind: *kind, ty: ty.clone(), module: None })
        };
        with_deep_stack(|| self.seen_by(file, offset, &lookup))
    }

    /// Returns [`Database::callable`] with the cached types, if the file is in the cache.
    pub fn callable_as_seen(&self, place: &SourceRange) -> Option<Callable> {
        let Some(names) = self.recent(&place.file) else { return self.callable(place) };
        let ty = |around: &str, name: &str| {
            let (_, ty) = names.get(around)?.get(name)?;
            ty.as_deref().map(str::to_string)
        };
        let scheme = |decl: &FunctionDecl| {
            let scheme = ty("", &decl.name.name).unwrap_or_default();
            let (given, result) = match scheme.split_once(") -> ") {
                Some((given, result)) => (given, Some(result)),
                None => (scheme.trim_end_matches(')'), None),
            };
            let mut types = parameter_types(given).into_iter();
            let parameters = decl.parameters.iter().map(|parameter| {
                (
                    parameter.mode,
                    parameter.name.name.to_string(),
                    types.next().unwrap_or_default().to_string(),
                )
            });
            let result = result.map(|result| result.split(" where ").next().unwrap_or(result).to_string());
            let parameters = parameters.collect();
            let (name, is_component) = (decl.name.name.to_string(), decl.is_component);
            ShownScheme { name, is_component, parameters, result, demands: Vec::new() }
        };
        let field = |decl: &RecordDecl, field: &RecordField| {
            ty(&decl.name.name, &field.name.name).unwrap_or_default()
        };
        self.called(place, &Types { scheme: &scheme, field: &field, dimension: &|_| None })
    }

    /// Returns the file of the module that an `import` names.
    fn module_named(&self, text: &str, tokens: &[Token], local: &Local) -> Option<SourceRange> {
        let named = tokens.iter().position(|token| token.span == local.span)?;
        // The name of `import module as name` follows the module.
        let renamed = named >= 3 && tokens.get(named - 1).is_some_and(|token| token.kind == Kind::Identifier);
        let last = if renamed { named - 2 } else { named };
        let mut first = last;
        while first >= 2 && tokens.get(first - 1).is_some_and(|token| token.kind == Kind::Dot) {
            first -= 2;
        }
        let start = tokens.get(first)?.span.start;
        let end = tokens.get(last)?.span.end;
        let path: String = text.get(start as usize..end as usize)?.split_whitespace().collect();
        Some(SourceRange { file: self.file_of(&path)?, start: 0, end: 0 })
    }
}

/// Returns the types in `(in x: Length, out y: [Number, String]`.
fn parameter_types(given: &str) -> Vec<&str> {
    let mut types = Vec::new();
    let (mut depth, mut start) = (0_i32, 1);
    let inner = given.char_indices().skip(1).chain([(given.len(), ',')]);
    for (at, character) in inner {
        match character {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                let parameter = given.get(start..at).unwrap_or_default();
                types.extend(parameter.split_once(": ").map(|(_, ty)| ty));
                start = at + 1;
            }
            _ => {}
        }
    }
    types
}

/// Returns the name of the top-level function that contains an offset.
fn function_around(tokens: &[Token], offset: u32) -> Option<Token> {
    let mut depth = 0_usize;
    let mut found = None;
    for (index, token) in tokens.iter().enumerate() {
        if token.span.start >= offset {
            break;
        }
        match token.kind {
            Kind::OpenBrace => depth += 1,
            Kind::CloseBrace => {
                depth = depth.saturating_sub(1);
                found = found.filter(|_| depth > 0);
            }
            Kind::Semicolon if depth == 0 => found = None,
            Kind::Function | Kind::Component if depth == 0 => {
                found = tokens.get(index + 1).filter(|name| name.kind == Kind::Identifier).copied();
            }
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::parameter_types;

    #[test]
    fn types_are_read_back_from_a_scheme() {
        assert_eq!(
            parameter_types("(in x: Length, out y: [a, Array(T)], in z: 1/a"),
            ["Length", "[a, Array(T)]", "1/a"]
        );
        assert!(parameter_types("(").is_empty());
        assert!(parameter_types("").is_empty());
    }
}
